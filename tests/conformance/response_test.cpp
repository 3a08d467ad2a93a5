#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/conformance/material_point.h"
#include "tests/epsilon.h"

/// What implicit analyses rely on in every law: forces and tangents of finite steps, and the states they end in.
namespace trajan::test {
namespace {

/// Of a difference quotient, so small that its square times any third derivative vanishes.
constexpr double difference = 1e-6;
/// Some hundred operations round values of that size before they are divided by the difference.
constexpr double quotient_error = 64 * epsilon * largest_modulus / difference;

using Step = std::vector<double>;

class LawResponse : public testing::TestWithParam<LawCase> {
 protected:
  Matrix in_scene(const std::array<double, 9>& rows) const { return in(GetParam().dimension, matrix(rows)); }
  /// The deformation gradient at the beginning of the step and at its end.
  Matrix start() const { return in_scene({1.06, 0.08, 0.03, -0.02, 0.97, 0.05, 0.01, -0.04, 1.03}); }
  Matrix end() const { return in_scene({1.1, 0.15, 0.02, -0.06, 0.93, 0.07, 0.04, -0.05, 1.05}); }

  /// check(point at the start of the step, step)
  template <class Check>
  void for_each_sample(Check&& check) const {
    for (const std::vector<double>& parameters : sample_parameters(*GetParam().kind)) {
      SCOPED_TRACE(testing::PrintToString(parameters));
      MaterialPoint point(GetParam(), parameters);
      point.deform(start());
      check(point, point.step_to(end()));
    }
  }
};
std::string name_of_case(const testing::TestParamInfo<LawCase>& named) { return name_of(named.param); }
INSTANTIATE_TEST_SUITE_P(Registry, LawResponse, testing::ValuesIn(all_laws()), name_of_case);

class HyperelasticResponse : public LawResponse {};
INSTANTIATE_TEST_SUITE_P(Registry, HyperelasticResponse, testing::ValuesIn(hyperelastic_laws()), name_of_case);

Step moved(Step step, std::size_t component, double by) {
  step[component] += by;
  return step;
}

TEST_P(LawResponse, IsThatOfTheStateThatIsCommitted) {
  for_each_sample([&](const MaterialPoint& before, const Step& step) {
    MaterialPoint after = before;
    after.commit(step);
    // Work per component of the displacement gradient with respect to the end, both of a step of nothing from
    // there and of the step itself.
    const Step nothing(step.size(), 0.0);
    const Step at_rest = after.respond(nothing).force, in_step = before.respond(step).force;
    const Step to_end = GetParam().total_lagrangian ? nothing : step;
    const auto axes = static_cast<std::size_t>(grid_axes(GetParam().dimension));
    for (std::size_t c = 0; c < step.size(); ++c) {
      double pushed = 0;
      if (c < axes * axes)
        for (std::size_t m = 0; m < axes; ++m)
          pushed += in_step[c / axes * axes + m] * (to_end[c % axes * axes + m] + (m == c % axes));
      else
        pushed = in_step[c] * (1 + to_end[c]);
      EXPECT_NEAR(at_rest[c], pushed, 64 * epsilon * largest_modulus) << c;
    }
  });
}

TEST_P(LawResponse, CommitsTheStateThatExplicitStepsReach) {
  for_each_sample([&](const MaterialPoint& before, const Step& step) {
    MaterialPoint implicit = before, explicit_one = before;
    implicit.commit(step);
    explicit_one.deform(end());
    const double rounding = 64 * epsilon * largest_modulus;
    EXPECT_LE(largest_difference(implicit.stress(), explicit_one.stress()), rounding);
    EXPECT_NEAR(implicit.energy(), explicit_one.energy(), rounding);
    const Matrix apart = implicit.virial() - explicit_one.virial();
    EXPECT_NEAR(contraction(apart, apart), 0, rounding * rounding);
  });
}

TEST_P(LawResponse, HasTheForceOfTheExplicitKernels) {
  for_each_sample([&](MaterialPoint point, const Step& step) {
    point.commit(step);
    const Step force = point.respond(Step(step.size(), 0.0)).force;
    const Matrix expected = GetParam().total_lagrangian ? point.nominal_stress() : point.virial();
    const auto axes = static_cast<std::size_t>(grid_axes(GetParam().dimension));
    for (std::size_t c = 0; c < step.size(); ++c) {
      const int i = c < axes * axes ? static_cast<int>(c / axes) : 2,
                j = c < axes * axes ? static_cast<int>(c % axes) : 2;
      EXPECT_NEAR(force[c], expected(i, j), 64 * epsilon * largest_modulus) << i << j;
    }
  });
}

TEST_P(LawResponse, HasTheTangentThatDifferencesOfForcesFind) {
  for_each_sample([&](const MaterialPoint& point, const Step& step) {
    const std::size_t n = step.size();
    const MaterialPoint::StepResponse at = point.respond(step);
    for (std::size_t d = 0; d < n; ++d) {
      const Step ahead = point.respond(moved(step, d, difference)).force;
      const Step behind = point.respond(moved(step, d, -difference)).force;
      for (std::size_t c = 0; c < n; ++c)
        EXPECT_NEAR(at.tangent[c * n + d], (ahead[c] - behind[c]) / (2 * difference), quotient_error) << c << d;
    }
  });
}

TEST_P(LawResponse, IsStiffAgainstTheFirstStrain) {
  for (const std::vector<double>& parameters : sample_parameters(*GetParam().kind)) {
    const MaterialPoint point(GetParam(), parameters);
    const std::size_t n = point.step_to(identity<3>()).size();
    const MaterialPoint::StepResponse at = point.respond(Step(n, 0.0));
    for (std::size_t c = 0; c < n; ++c) EXPECT_TRUE(std::isfinite(at.force[c])) << c;
    for (double slope : at.tangent) EXPECT_TRUE(std::isfinite(slope));
    EXPECT_GT(at.tangent[0], 0);
  }
}

TEST_P(LawResponse, CountsWhatIsTurnedInsideOut) {
  for_each_sample([&](const MaterialPoint& point, const Step& step) {
    EXPECT_EQ(point.respond(step).inverted, 0);
    EXPECT_EQ(point.respond(step).unsolved, 0);
    Matrix inside_out = end();
    inside_out(0, 0) = -inside_out(0, 0);
    EXPECT_EQ(point.respond(point.step_to(inside_out)).inverted, 1);
  });
}

TEST_P(HyperelasticResponse, HasTheForceThatDifferencesOfItsEnergyFind) {
  for_each_sample([&](const MaterialPoint& point, const Step& step) {
    const Step force = point.respond(step).force;
    for (std::size_t c = 0; c < step.size(); ++c) {
      MaterialPoint ahead = point, behind = point;
      ahead.commit(moved(step, c, difference));
      behind.commit(moved(step, c, -difference));
      EXPECT_NEAR(force[c], (ahead.energy() - behind.energy()) / (2 * difference), quotient_error) << c;
    }
  });
}

TEST_P(HyperelasticResponse, HasASymmetricTangent) {
  for_each_sample([&](const MaterialPoint& point, const Step& step) {
    const std::size_t n = step.size();
    const std::vector<double> tangent = point.respond(step).tangent;
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t d = 0; d < c; ++d)
        EXPECT_NEAR(tangent[c * n + d], tangent[d * n + c], 64 * epsilon * largest_modulus) << c << d;
  });
}

}  // namespace
}  // namespace trajan::test
