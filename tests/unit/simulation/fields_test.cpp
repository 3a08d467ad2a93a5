#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

const std::vector<Field> tensors = {Field::stress, Field::pressure, Field::von_mises_stress,
                                    Field::deformation_gradient, Field::strain};

/// A bar in its first axial mode with a large amplitude, of a law that keeps the deformation gradient.
Scene swinging_bar() {
  Scene scene = test::bar("MUSL", "neo_hookean", 0.5, 2);
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.outputs.probes = {{"middle", Vector{5.2, 0.3}, tensors, ""}};
  return scene;
}

/// A history by its column's name without the probe's.
struct Probed {
  explicit Probed(const Scene& scene) : model(validate(scene)) { run(model, {}, memory, nullptr); }
  double operator()(std::size_t row, const std::string& column) const {
    return memory.rows[row][test::column(model, model.outputs.probes[0].name + "." + column)];
  }
  Model model;
  test::Memory memory;
};

TEST(Fields, TellWhatALawRemembers) {
  // Every node of a bar moves as its place says, so that the strain rate is 0.01 everywhere.
  Scene scene = test::bar("MUSL", "linear_elastic", 0.5, 0);
  scene.domain = {Dimension::bar, {-2, 0}, {14, 0}, 0.5};
  scene.bodies[0].geometry = Box{{0, 0}, {10, 0}};
  scene.bodies[0].initial_velocity.x = "0.01*x";
  scene.numerics.time_step = 0.01;
  scene.boundaries = {{"all", Box{{-2, 0}, {14, 0}}, PrescribedVelocity{{"0.01*x"}}}};
  scene.materials[0] = {
      "solid",
      1,
      "von_mises",
      {{"youngs_modulus", 100}, {"poissons_ratio", 0.3}, {"yield_stress", 1}, {"hardening_modulus", 25}}};
  scene.outputs.probes = {
      {"mean", Region{Box{{2, 0}, {8, 0}}}, {Field::stress}, "", {"equivalent_plastic_strain"}},
      {"most", Region{Box{{2, 0}, {8, 0}}}, {}, "", {"equivalent_plastic_strain"}, Statistic::largest}};
  const Probed probed(scene);
  ASSERT_EQ(probed.memory.rows.size(), 41u);
  for (std::size_t row = 0; row < probed.memory.rows.size(); ++row) {
    // Each step of 0.01 stretches by 1 + 1e-4, and strain is the logarithm of that but for its third power. Beyond
    // yield the plastic part of a further strain is E / (E + H).
    const double strain = std::round(probed.memory.times[row] / 0.01) * std::log1p(1e-4);
    const double plastic = std::max(0.0, (strain - 0.01) * 100 / 125);
    EXPECT_NEAR(probed(row, "equivalent_plastic_strain"), plastic, 1e-9);
    EXPECT_NEAR(probed(row, "stress.xx"), 100 * (strain - plastic), 1e-7);
    // The mean over equal particles is rounded.
    EXPECT_NEAR(probed.memory.rows[row][test::column(probed.model, "most.equivalent_plastic_strain")],
                probed(row, "equivalent_plastic_strain"), 1e-15);
  }
}

TEST(Fields, FollowFromStressAndDeformationGradient) {
  const Probed probed(swinging_bar());
  double largest_strain = 0;
  for (std::size_t row = 0; row < probed.memory.rows.size(); ++row) {
    const auto at = [&](const std::string& column) { return probed(row, column); };
    const double xx = at("stress.xx"), yy = at("stress.yy"), zz = at("stress.zz"), xy = at("stress.xy");
    // The same few terms summed in another order: rounding of the largest of them.
    const double rounding = 1e-15 * (std::abs(xx) + std::abs(yy) + std::abs(zz) + std::abs(xy));
    EXPECT_NEAR(at("pressure"), -(xx + yy + zz) / 3, 4 * rounding);
    const double mean = (xx + yy + zz) / 3;
    const double square = std::pow(xx - mean, 2) + std::pow(yy - mean, 2) + std::pow(zz - mean, 2) + 2 * xy * xy;
    EXPECT_NEAR(at("von_mises_stress"), std::sqrt(1.5 * square), 16 * rounding);
    const double fxx = at("deformation_gradient.xx"), fxy = at("deformation_gradient.xy"),
                 fyx = at("deformation_gradient.yx"), fyy = at("deformation_gradient.yy"),
                 fzz = at("deformation_gradient.zz");
    EXPECT_NEAR(at("strain.xx"), (fxx * fxx + fyx * fyx - 1) / 2, 1e-15);
    EXPECT_NEAR(at("strain.xy"), (fxx * fxy + fyx * fyy) / 2, 1e-15);
    EXPECT_NEAR(at("strain.yy"), (fxy * fxy + fyy * fyy - 1) / 2, 1e-15);
    EXPECT_NEAR(at("strain.zz"), (fzz * fzz - 1) / 2, 1e-15);
    largest_strain = std::max(largest_strain, std::abs(at("strain.xx")));
  }
  EXPECT_GT(largest_strain, 0.05) << "otherwise nothing of this was tested";
}

TEST(Fields, OfSnapshotsAreThoseOfProbes) {
  Scene scene = swinging_bar();
  scene.outputs.snapshot_fields = tensors;
  const Probed probed(scene);
  const Snapshot& last = probed.memory.snapshots.back();
  const auto particle = static_cast<std::size_t>(probed.model.outputs.probes[0].particles[0]);
  std::size_t column = 0;
  for (std::size_t f = 0; f < tensors.size(); ++f) {
    const std::size_t width = probed.model.outputs.snapshot_fields[f].width();
    for (std::size_t c = 0; c < width; ++c)
      EXPECT_EQ(last.fields[f][particle * width + c], probed.memory.rows.back()[column++]);
  }
}

TEST(Probes, TellHowFarABodyReaches) {
  Scene scene = swinging_bar();
  scene.outputs.snapshots = scene.outputs.samples;
  scene.outputs.probes = {{"right", Region{}, {Field::position}, "", {}, Statistic::largest},
                          {"left", Region{}, {Field::position}, "", {}, Statistic::smallest}};
  const Probed probed(scene);
  // Particles are a quarter of a unit apart: centres lie an eighth inside of the faces.
  EXPECT_DOUBLE_EQ(probed(0, "position.x"), 9.875);
  EXPECT_DOUBLE_EQ(probed(0, "position.y"), 0.875);
  for (std::size_t row = 0; row < probed.memory.rows.size(); ++row) {
    const std::vector<double>& position = probed.memory.snapshots[row].position;
    double right = -1e300, left = 1e300;
    for (std::size_t i = 0; i < position.size(); i += 2) {
      right = std::max(right, position[i]);
      left = std::min(left, position[i]);
    }
    EXPECT_EQ(probed(row, "position.x"), right);
    EXPECT_EQ(probed.memory.rows[row][test::column(probed.model, "left.position.x")], left);
  }
}

TEST(Probes, MeanOfAWholeBodyIsItsMomentumOverItsMass) {
  Scene scene = swinging_bar();
  scene.outputs.probes = {{"all", Region{}, {Field::velocity}, ""}};
  const Probed probed(scene);
  const double mass = 10;
  for (std::size_t row = 0; row < probed.memory.rows.size(); ++row) {
    const double momentum = probed.memory.rows[row][test::column(probed.model, "momentum.x")];
    // Two sums of 160 terms.
    EXPECT_NEAR(mass * probed(row, "velocity.x"), momentum, 320 * 2.3e-16 * mass * 2);
  }
}

}  // namespace
}  // namespace trajan
