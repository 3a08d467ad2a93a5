#include <gtest/gtest.h>

#include "server/convert.h"

namespace trajan {
namespace {

TEST(ConvertAnswers, ViolationKeepsItsFourTexts) {
  const v1::Violation message = to_proto(Violation{"a[0].b", "value", "problem", "remedy"});
  EXPECT_EQ(message.path(), "a[0].b");
  EXPECT_EQ(message.value(), "value");
  EXPECT_EQ(message.problem(), "problem");
  EXPECT_EQ(message.remedy(), "remedy");
}

TEST(ConvertAnswers, MeasureWithoutExactValueHasNoError) {
  const v1::MeasureValue bare = to_proto(MeasureValue{"m", "q", 1.5, {}, {}, {}, ""});
  EXPECT_EQ(bare.value(), 1.5);
  EXPECT_FALSE(bare.has_exact() || bare.has_error() || bare.has_tolerance());
  const v1::MeasureValue full = to_proto(MeasureValue{"m", "q", 1.5, 0.0, 1.5, 0.25, "book"});
  EXPECT_TRUE(full.has_exact());
  EXPECT_EQ(full.error(), 1.5);
  EXPECT_EQ(full.tolerance(), 0.25);
  EXPECT_EQ(full.source(), "book");
}

TEST(ConvertAnswers, ProgressKeepsItsNumbers) {
  const v1::Progress message = to_proto(RunProgress{1, 2, 3.5, 4.5, 5, 6.5, 7.5});
  EXPECT_EQ(message.ShortDebugString(),
            "step: 1 total_steps: 2 time: 3.5 end_time: 4.5 rows: 5 energy_balance_error: 6.5 "
            "particle_steps_per_second: 7.5");
}

TEST(ConvertAnswers, DivergenceSaysWhereAndWhy) {
  const v1::Failure message = to_proto(Divergence{1, 2.5, 3, "cause", "remedy"});
  EXPECT_EQ(message.ShortDebugString(),
            "reason: \"DIVERGED\" message: \"cause\" remedy: \"remedy\" step: 1 time: 2.5 particle: 3");
}

TEST(ConvertAnswers, PlanKeepsItsNumbersAndAttributes) {
  ModelPlan plan;
  plan.particles = 1, plan.active_cells = 2, plan.time_step = 3.5, plan.steps = 4;
  plan.time_step_limit = "wave", plan.memory_bytes = 5;
  plan.attributes = {{"volume", 8, "law"}};
  plan.node_attributes = {{"mass", 8, "scheme"}};
  plan.sweeps = {{{{{"one", "two"}, {"locate", "kick"}}}}};
  plan.tiles = 6, plan.occupied_tiles = 7, plan.particle_bytes = 8, plan.grid_bytes = 9, plan.matrix_bytes = 10;
  EXPECT_EQ(to_proto(plan).ShortDebugString(),
            "particles: 1 active_cells: 2 time_step: 3.5 steps: 4 time_step_limit: \"wave\" memory_bytes: 5 "
            "attributes { name: \"volume\" bytes_per_particle: 8 wanted_by: \"law\" } "
            "node_attributes { name: \"mass\" bytes_per_node: 8 wanted_by: \"scheme\" } "
            "sweeps { of_bodies { bodies: \"one\" bodies: \"two\" stages: \"locate\" stages: \"kick\" } } "
            "tiles: 6 occupied_tiles: 7 particle_bytes: 8 grid_bytes: 9 matrix_bytes: 10");
}

}  // namespace
}  // namespace trajan
