/// What the fuzzer does at leisure, in small, with fixed seeds, with every compiler and sanitizer.

#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/text_format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/fuzz/allocation_meter.h"
#include "tests/fuzz/scene_mutator.h"
#include "tests/fuzz/scene_pipeline.h"

namespace trajan::testing {
namespace {

/// All scenes of the gallery and the one that uses every field, by file name.
const std::map<std::string, std::string>& seeds() {
  static const std::map<std::string, std::string> seeds = [] {
    std::map<std::string, std::string> texts;
    for (const char* folder : {TRAJAN_SCENES, TRAJAN_SCHEMA_SCENES}) {
      for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".textproto") continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        texts[entry.path().filename()] = text.str();
      }
    }
    return texts;
  }();
  return seeds;
}

class HostileScenes : public ::testing::Test {
 protected:
  /// The bound on work: a parsed byte is a few hundred bytes at most (an element of the largest message),
  /// a violation repeats a value, and validation limits the rest: the numbers of 10^7 particles in mean probes,
  /// 4 * 10^6 rows of shapes with their ends as numbers and as columns, and 64 MiB for all else.
  static constexpr std::size_t fixed_work = 10'000'000 * 8 + 4'000'000 * 2 * 16 + (64 << 20);
  static constexpr std::size_t work_per_byte = 4096;

  void SetUp() override { ASSERT_GE(seeds().size(), 2u); }

  void expect_promises(const std::string& text) {
    const std::size_t before = allocated_bytes();
    try {
      ++fates_[run_pipeline(text)];
    } catch (const std::exception& broken) {
      ADD_FAILURE() << broken.what() << "\nin the scene\n" << text;
    }
    const std::size_t work = allocated_bytes() - before;
    EXPECT_LE(work, fixed_work + work_per_byte * text.size()) << "in the scene\n" << text;
  }

  google::protobuf::LogSilencer silencer_;
  std::map<SceneFate, int> fates_;
};

TEST_F(HostileScenes, GalleryScenesAreValid) {
  for (const auto& [name, text] : seeds()) {
    if (name == "every_field.textproto") continue;
    EXPECT_EQ(run_pipeline(text), SceneFate::valid) << name;
  }
}

TEST_F(HostileScenes, RandomBytesAreRefusedCalmly) {
  SceneMutator mutator(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text(mutator.below(2000), '\0');
    for (char& byte : text) byte = static_cast<char>(mutator.below(256));
    expect_promises(text);
  }
  EXPECT_EQ(fates_[SceneFate::valid], 0);
}

TEST_F(HostileScenes, ScenesWithChangedTextKeepThePromises) {
  SceneMutator mutator(2);
  for (int round = 0; round < 60; ++round) {
    for (const auto& [name, seed] : seeds()) {
      std::string text = seed;
      for (std::size_t i = 0; i <= mutator.below(3); ++i) text = mutator.mutate(text);
      expect_promises(text);
    }
  }
  // Changes in comments and numbers leave many scenes readable; otherwise this would test the parser alone.
  EXPECT_GT(fates_[SceneFate::unreadable], 50);
  EXPECT_GT(fates_[SceneFate::invalid] + fates_[SceneFate::valid], 50);
}

TEST_F(HostileScenes, ScenesWithChangedFieldsKeepThePromises) {
  SceneMutator mutator(3);
  for (int round = 0; round < 200; ++round) {
    for (const auto& [name, seed] : seeds()) {
      v1::Scene scene;
      ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(seed, &scene)) << name;
      std::string text;
      for (std::size_t i = 0; i <= mutator.below(6); ++i) mutator.mutate(scene);
      google::protobuf::TextFormat::PrintToString(scene, &text);
      expect_promises(text);
    }
  }
  EXPECT_GT(fates_[SceneFate::invalid], 500);
  EXPECT_GT(fates_[SceneFate::valid], 100) << "only one change in several hurts";
}

TEST_F(HostileScenes, AMillionOfAnythingIsBoundedWork) {
  std::string bodies = "name: \"many\"";
  for (int i = 0; i < 20000; ++i) bodies += "bodies{}materials{}measures{}";
  expect_promises(bodies);
  expect_promises("constants { name: \"a\" value: \"" + std::string(1000000, '(') + "\" }");
  expect_promises("constants { name: \"a\" value: \"" + std::string(100000, '-') + "1\" }");
  expect_promises(std::string(1000000, '{'));
  EXPECT_EQ(fates_[SceneFate::valid], 0);
}

}  // namespace
}  // namespace trajan::testing
