#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include "tests/unit/model/sample_scene.h"

namespace trajan {

/// One mistake in the sample scene, and the one violation that must be found for it.
struct Mistake {
  std::string name;
  std::function<void(Scene&)> make;
  std::string path;
  std::string problem;      ///< a part of it
  std::string remedy = {};  ///< a part of it
};

inline std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.name; }

inline std::string name_of(const testing::TestParamInfo<Mistake>& info) { return info.param.name; }

/// Expects exactly this violation, with a remedy.
inline void expect_violation(const Mistake& mistake) {
  Scene scene = sample_scene();
  mistake.make(scene);
  const auto violations = violations_of(scene);
  ASSERT_THAT(paths_of(scene), testing::ElementsAre(mistake.path));
  EXPECT_THAT(violations[0].problem, testing::HasSubstr(mistake.problem));
  EXPECT_NE(violations[0].remedy, "");
  EXPECT_THAT(violations[0].remedy, testing::HasSubstr(mistake.remedy));
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace trajan
