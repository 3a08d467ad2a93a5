#include <gtest/gtest.h>

#include "solver/schemes/scheme.h"
#include "solver/simulation/simulation.h"
#include "tests/fuzz/allocation_meter.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

TEST(Steps, AllocateNothing) {
  for (std::string_view scheme : scheme_names()) {
    // Too slow for a particle to reach another tile, which is when particles are sorted.
    Scene scene = test::bar(std::string(scheme), "linear_elastic", 0.5, 0.001);
    scene.loads = {{"push", PointForce{"bar", {10, 0.5}, {1e-4, 0}}, Ramp{0, 1, true}}};
    scene.outputs.samples = 1;
    const Model model = validate(scene);
    Simulation simulation(model, 1);
    // The passes across the end of a step are first seen in the second one.
    for (int step = 0; step < 3; ++step) simulation.step();
    const std::size_t before = trajan::testing::allocated_bytes();
    for (int step = 0; step < 10; ++step) ASSERT_FALSE(simulation.step());
    EXPECT_EQ(trajan::testing::allocated_bytes(), before) << scheme;
  }
}

}  // namespace
}  // namespace trajan
