#include "solver/schemes/scheme.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/materials/material.h"
#include "tests/conformance/material_point.h"
#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

/// What every scheme must do with every law. Both come from their registries.
namespace trajan {
namespace {

using test::epsilon;

struct SchemeCase {
  std::string scheme, law;
  Dimension dimension;
};

std::string name_of(const SchemeCase& of) {
  return of.scheme + "_" + of.law + (of.dimension == Dimension::plane_stress ? "_plane_stress" : "_plane_strain");
}
std::ostream& operator<<(std::ostream& out, const SchemeCase& of) { return out << name_of(of); }

std::vector<SchemeCase> all_schemes() {
  std::vector<SchemeCase> cases;
  for (std::string_view scheme : scheme_names())
    for (const MaterialKind& kind : material_kinds()) {
      if (!test::traits_of(kind).objective || !kind.history.empty()) continue;  // elastic ones alone
      for (Dimension dimension : {Dimension::plane_stress, Dimension::plane_strain})
        cases.push_back({std::string(scheme), std::string(kind.name), dimension});
    }
  return cases;
}

/// A tenth as stiff as the law's second sample.
MaterialDefinition soft(const std::string& law) {
  const MaterialKind& kind = *find_material_kind(law);
  const auto samples = test::sample_parameters(kind);
  const std::vector<double>& values = samples[samples.size() > 1 ? 1 : 0];
  MaterialDefinition material{"solid", 1, law, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    material.parameters[std::string(kind.parameters[i].name)] =
        values[i] * (kind.parameters[i].unit == "stress" ? 0.1 : 1);
  return material;
}

class Scheme : public testing::TestWithParam<SchemeCase> {
 protected:
  /// A free block of 2 x 1 about the origin, of mass 2.
  Scene block() const {
    Scene scene;
    scene.name = "block";
    scene.domain = {GetParam().dimension, {-10, -10}, {10, 10}, 0.25, 1};
    scene.materials = {soft(GetParam().law)};
    scene.bodies = {{"block", "solid", Box{{-1, -0.5}, {1, 0.5}}, 2, {}}};
    scene.analysis = {3, 0};
    scene.numerics.scheme = GetParam().scheme;
    scene.outputs.samples = 10;
    scene.outputs.snapshots = 10;
    return scene;
  }
};
INSTANTIATE_TEST_SUITE_P(Registry, Scheme, testing::ValuesIn(all_schemes()),
                         [](const auto& named) { return name_of(named.param); });

struct Outcome {
  explicit Outcome(const Scene& scene) : model(validate(scene)), result(run(model, {}, memory, nullptr)) {}
  double last(const std::string& column) const { return memory.rows.back()[test::column(model, column)]; }
  double first(const std::string& column) const { return memory.rows.front()[test::column(model, column)]; }
  test::Memory memory;
  Model model;
  RunResult result;
};

TEST_P(Scheme, CarriesARigidTranslationThroughHundredsOfCellsExactly) {
  Scene scene = block();
  scene.domain = {GetParam().dimension, {-2, -200}, {200, 2}, 0.25, 1};
  scene.bodies[0].initial_velocity = {"8", "-6"};
  scene.analysis.end_time = 15;
  const Outcome out(scene);
  ASSERT_EQ(out.result.end, RunEnd::finished);
  // Each step rounds positions of up to 120 and velocities of up to 8, and velocities that differ by their
  // rounding strain the block and push its particles apart: some ten roundings a step.
  const double rounding = 16 * epsilon * static_cast<double>(out.result.progress.step);
  const Snapshot &first = out.memory.snapshots.front(), &last = out.memory.snapshots.back();
  ASSERT_EQ(last.position.size(), first.position.size());
  for (std::size_t i = 0; i < last.position.size(); i += 2) {
    EXPECT_NEAR(last.position[i], first.position[i] + 120, 120 * rounding);
    EXPECT_NEAR(last.position[i + 1], first.position[i + 1] - 90, 120 * rounding);
  }
  EXPECT_NEAR(out.last("momentum.x"), 16, 20 * rounding);
  EXPECT_NEAR(out.last("momentum.y"), -12, 20 * rounding);
  // Of the kinetic energy.
  EXPECT_NEAR(out.last("energies.strain"), 0, 100 * rounding);
}

TEST_P(Scheme, KeepsTheMomentumOfASpinningBlock) {
  Scene scene = block();
  scene.bodies[0].initial_velocity = {"0.3-2*y", "2*x-0.2"};
  const Outcome out(scene);
  ASSERT_EQ(out.result.end, RunEnd::finished);
  // In each step every particle's momentum is rounded, in the worst case all of them one way: the sum of
  // their magnitudes is below 2 times 2.6.
  const double tolerance = 4 * epsilon * 5.2 * static_cast<double>(out.result.progress.step);
  for (const std::vector<double>& row : out.memory.rows) {
    EXPECT_NEAR(row[test::column(out.model, "momentum.x")], out.first("momentum.x"), tolerance);
    EXPECT_NEAR(row[test::column(out.model, "momentum.y")], out.first("momentum.y"), tolerance);
  }
}

/// What one turn of a free block does, by cell size.
struct Turn {
  double place, energy;  ///< largest errors, relative to the block and to its kinetic energy
};
Turn turn(Scene scene, double cell) {
  scene.domain.cell_size = cell;
  scene.bodies[0].initial_velocity = {"-y", "x"};
  scene.analysis.end_time = 2 * std::numbers::pi;
  const Outcome out(scene);
  EXPECT_EQ(out.result.end, RunEnd::finished);
  Turn turn{0, 0};
  if (out.result.end != RunEnd::finished) return turn;
  const Snapshot &first = out.memory.snapshots.front(), &last = out.memory.snapshots.back();
  for (std::size_t i = 0; i < last.position.size(); ++i)
    turn.place = std::max(turn.place, std::abs(last.position[i] - first.position[i]));
  for (const std::vector<double>& row : out.memory.rows)
    turn.energy = std::max(turn.energy, std::abs(row[test::column(out.model, "energies.balance_error")]));
  return turn;
}

TEST_P(Scheme, ComesBackFromAFullTurn) {
  const Turn coarse = turn(block(), 0.25), fine = turn(block(), 0.125);
  RecordProperty("place", std::to_string(coarse.place) + " " + std::to_string(fine.place));
  RecordProperty("energy", std::to_string(coarse.energy) + " " + std::to_string(fine.energy));
  // Lumped masses turn the block's rim too slowly, an error of first order at least in the cell.
  EXPECT_LT(fine.place, coarse.place / 1.9);
  // Crossing cells costs energy: most by USL, a tenth, as small an error by TLMPM as leapfrog's.
  EXPECT_LT(fine.energy, coarse.energy);
  EXPECT_LT(fine.energy, 0.15);
}

}  // namespace
}  // namespace trajan
