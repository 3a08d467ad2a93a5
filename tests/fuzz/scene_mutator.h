#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "trajan/v1/scene.pb.h"

namespace trajan::testing {

/// Makes scenes that nobody would write from scenes that somebody did. The same seed gives the same
/// scenes everywhere.
class SceneMutator {
 public:
  explicit SceneMutator(std::uint64_t seed) : random_(seed) {}

  /// Changes one field somewhere in the scene: sets, clears, adds, removes, copies or swaps. Knows the
  /// schema, so that what comes out is a readable scene.
  void mutate(v1::Scene& scene);

  /// Changes characters or words, without regard for the syntax.
  std::string mutate(std::string text);

  /// Uniform in [0, bound), bound > 0.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

 private:
  void mutate_field(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);
  void mutate_repeated(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);
  void add_element(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);
  void set_value(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);
  double make_number(double present);
  std::int32_t make_integer(std::int32_t present);
  std::string make_string(const std::string& present);
  template <typename Values>
  const auto& any_of(const Values& values) {
    return values[below(std::size(values))];
  }

  std::mt19937_64 random_;
  std::vector<std::string> strings_;  ///< of the scene, so that references sometimes fit
};

}  // namespace trajan::testing
