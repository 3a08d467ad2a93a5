#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/convergence.h"
#include "tests/verification/gallery.h"

/// Different analyses of one scene have one answer.
namespace trajan::verification {
namespace {

/// Four cells over the height, `load` times the gallery's end load, and room for it.
Scene cantilever(double load) {
  Scene scene = with_cells(gallery_scene("cantilever"), 0.25);
  scene.domain.lower.y = -8;
  // The last column of particles alone.
  std::get<Box>(std::get<Region>(scene.outputs.probes.at(0).where)).lower.x = 8 - 0.25 / 2;
  std::get<EdgeTraction>(scene.loads.at(0).kind).traction.y *= load;
  return scene;
}

Scene relaxed(Scene scene) {
  scene.analysis = {1, 0, Relaxation{}};
  scene.loads.at(0).time = 1.0;
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  std::erase_if(scene.measures, [](const MeasureDefinition& m) { return m.name == "remaining_speed"; });
  return scene;
}

// The ramp leaves a motion of less than a thousandth of the deflection; the cells' error is 0.9 %.
TEST(Relaxation, FindsTheAnswerOfARampInAFractionOfItsSteps) {
  const Outcome ramped = run_scene(cantilever(1)), at_once = run_scene(relaxed(cantilever(1)));
  const MeasureValue &one = ramped.measure("tip_deflection"), &other = at_once.measure("tip_deflection");
  std::printf("tip %.6f in %lld steps by a ramp, %.6f in %lld relaxed; error %.2g\n", one.value,
              static_cast<long long>(ramped.steps), other.value, static_cast<long long>(at_once.steps),
              *other.error);
  EXPECT_NEAR(one.value, other.value, 0.0005 * std::abs(one.value));
  EXPECT_GT(std::abs(*other.error), 0.005) << "what the cells are to blame for";
  EXPECT_LT(2 * at_once.steps, ramped.steps);
}

// Ten times the load bends the end down by more than half the length.
TEST(Relaxation, FindsLargeDeflectionsToo) {
  const Outcome ramped = run_scene(cantilever(10)), at_once = run_scene(relaxed(cantilever(10)));
  const double one = ramped.measure("tip_deflection").value, other = at_once.measure("tip_deflection").value;
  std::printf("tip %.6f in %lld steps by a ramp, %.6f in %lld relaxed\n", one,
              static_cast<long long>(ramped.steps), other, static_cast<long long>(at_once.steps));
  EXPECT_LT(one, -4);
  EXPECT_NEAR(one, other, 0.001 * std::abs(one));
  EXPECT_LT(2 * at_once.steps, ramped.steps);
}

}  // namespace
}  // namespace trajan::verification
