#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/implicit/statics.h"

namespace trajan {
namespace {

using namespace test;

/// One cell of a Saint Venant-Kirchhoff bar under a pressure: P(s) = E/2 (s^3 - s), -E / sqrt(27) at most.
Scene crushed_bar() {
  Scene scene = block(Dimension::bar, "st_venant_kirchhoff", 1, 1, 0);
  scene.loads = {growing(traction("block", Edge::right, {-100 / std::sqrt(27), 0}))};
  scene.outputs.probes = {{"end", Vector{1, 0}, {Field::displacement}, ""}};
  QuasiStatic analysis{20};
  analysis.arc_length = ArcLength{60};
  scene.analysis.kind = analysis;
  scene.outputs.samples = 60;
  return scene;
}

TEST(ArcLength, FollowsABarBeyondItsLimitLoad) {
  const Model model = validate(crushed_bar());
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished) << answer.result.divergence->cause;
  const std::size_t end = column(model, "end.displacement.x"), factor = column(model, "load_factor");
  double largest = 0, smallest_stretch = 1;
  for (const std::vector<double>& row : answer.memory.rows) {
    // Two particles in the cell: the right one is at three quarters.
    const double stretch = 1 + row[end] / 0.75;
    // Newton's tolerance, 1e-8 of the forces.
    EXPECT_NEAR(row[factor] * -100 / std::sqrt(27), 50 * (stretch * stretch * stretch - stretch), 1e-6);
    largest = std::max(largest, row[factor]);
    smallest_stretch = std::min(smallest_stretch, stretch);
  }
  // The limit point is between two steps of 1/60 of the load at first: it is flat there.
  EXPECT_NEAR(largest, 1, 2e-3);
  EXPECT_LT(smallest_stretch, 0.5) << "the limit is at 0.577";
}

/// The same under half the load, which a ramp brings on in a time.
Scene ramped_bar(double duration) {
  Scene scene = crushed_bar();
  scene.loads[0].time = Ramp{0, duration, false};
  std::get<EdgeTraction>(scene.loads[0].kind).traction.x *= 0.5;
  std::get<QuasiStatic>(scene.analysis.kind).load_steps = 10;  // steps as long as before
  return scene;
}

TEST(ArcLength, GoesOnWhereARampEndsWithTheRun) {
  const Model model = validate(ramped_bar(1));
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished) << answer.result.divergence->cause;
  double largest = 0;
  for (const std::vector<double>& row : answer.memory.rows)
    largest = std::max(largest, row[column(model, "load_factor")]);
  EXPECT_NEAR(largest, 2, 4e-3) << "twice the load at the end of the ramp, as flat as before";
}

TEST(ArcLength, IsWhatGetsBeyondALimitThatStepsOfGivenLoadEndAt) {
  Scene scene = crushed_bar();
  std::get<EdgeTraction>(scene.loads[0].kind).traction.x /= 0.75;
  scene.analysis.kind = QuasiStatic{10};
  const Answer answer = solve(validate(scene));
  ASSERT_EQ(answer.result.end, RunEnd::diverged);
  EXPECT_THAT(answer.result.divergence->cause,
              ::testing::HasSubstr("no equilibrium is found beyond the load factor 0.750000"));
  EXPECT_THAT(answer.result.divergence->remedy, ::testing::HasSubstr("arc_length"));
  // From the tenth of a load step to the ten-millionth that is the shortest there are 20 halvings, each with a
  // step that finds a balance and one that takes all 20 iterations and does not.
  EXPECT_LT(answer.result.divergence->step, 20 * 40);
}

TEST(ArcLength, NeedsLoadsThatGrow) {
  for (Scene scene : {ramped_bar(0.5), crushed_bar()}) {
    if (std::holds_alternative<Ramp>(scene.loads[0].time) == false) scene.loads[0].time = 1.0;
    const Answer answer = solve(validate(scene));
    ASSERT_EQ(answer.result.end, RunEnd::diverged);
    EXPECT_THAT(answer.result.divergence->cause,
                ::testing::HasSubstr("the loads do not change with time at the load factor"));
    EXPECT_THAT(answer.result.divergence->remedy, ::testing::HasSubstr("ramp"));
  }
}

TEST(ArcLength, GoesOnFromCheckpointsWithTheSameBits) {
  const Model model = validate(crushed_bar());
  Memory whole, resumed;
  RunOptions options;
  options.checkpoint_interval = 0;
  run(model, options, whole, {});
  options.resume = whole.checkpoints.at(30);
  resumed.rows = {whole.rows.begin(), whole.rows.begin() + 32};
  run(model, options, resumed, {});
  EXPECT_EQ(resumed.rows, whole.rows);
}

}  // namespace
}  // namespace trajan
