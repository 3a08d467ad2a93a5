/// The libFuzzer target: any bytes as the text of a scene. A broken promise is an exception that nobody
/// catches; a crash, a hang or a leak is libFuzzer's and the sanitizers' to see.

#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/text_format.h>

#include <cstring>

#include "tests/fuzz/scene_mutator.h"
#include "tests/fuzz/scene_pipeline.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const google::protobuf::LogSilencer silencer;
  trajan::testing::run_pipeline(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

/// Readable scenes change by the schema, which byte changes would almost never get right; now and then,
/// and whatever is not readable, by text and by libFuzzer's own means.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  static const google::protobuf::LogSilencer silencer;
  trajan::testing::SceneMutator mutator(seed);
  if (mutator.below(8) == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::string text(reinterpret_cast<const char*>(data), size);
  trajan::v1::Scene scene;
  if (mutator.below(6) > 0 && google::protobuf::TextFormat::ParseFromString(text, &scene)) {
    mutator.mutate(scene);
    google::protobuf::TextFormat::PrintToString(scene, &text);
  } else {
    text = mutator.mutate(text);
  }
  if (text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
