#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "solver/schemes/scheme.h"
#include "tests/unit/boundaries/runs.h"

namespace trajan {
namespace {

using test::epsilon;
using test::Histories;

struct RingCase {
  Dimension dimension;
  std::string shape;
};
std::string name_of(const RingCase& of) {
  const char* dimensions[] = {"", "bar", "plane_stress", "plane_strain", "axisymmetric", "solid"};
  return std::string(dimensions[static_cast<int>(of.dimension)]) + "_" + of.shape;
}
std::ostream& operator<<(std::ostream& out, const RingCase& of) { return out << name_of(of); }

std::vector<RingCase> all_rings() {
  std::vector<RingCase> cases;
  for (std::string_view shape : shape_names())
    for (const Dimension dimension :
         {Dimension::bar, Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid})
      if (dimension != Dimension::axisymmetric || shape != "cpdi")
        cases.push_back({dimension, std::string(shape)});
  return cases;
}

/// The axis along which rings close. Axisymmetric ones are cylinders without ends.
Axis along(Dimension dimension) { return dimension == Dimension::axisymmetric ? Axis::y : Axis::x; }

BoundaryDefinition periodic(Axis axis) {
  return {"periodic_" + std::to_string(static_cast<int>(axis)), {}, Periodic{axis}};
}

/// A body that fills its domain along the axis that is periodic. Across it is narrow, and periodic as well or held
/// by a wall.
Scene ring(const RingCase& of, int cells, double length = 1) {
  const bool hoop = of.dimension == Dimension::axisymmetric;
  const int axes = grid_axes(of.dimension);
  const double cell = length / cells, width = (axes == 3 ? 4 : 10) * cell;
  Scene scene;
  scene.name = "ring";
  scene.domain.dimension = of.dimension;
  scene.domain.upper = hoop ? Vector{width, length} : Vector{length, axes > 1 ? width : 0, axes > 2 ? width : 0};
  scene.domain.cell_size = cell;
  scene.materials = {test::material("linear_elastic", 1, 0, 1)};
  scene.bodies = {{"ring", "solid", Box{{}, scene.domain.upper}, 2, {}}};
  scene.boundaries.push_back(periodic(along(of.dimension)));
  if (hoop) scene.boundaries.push_back({"wall", Edge::right, Roller{}});
  if (!hoop && axes > 1) scene.boundaries.push_back(periodic(Axis::y));
  if (axes > 2) scene.boundaries.push_back(periodic(Axis::z));
  scene.numerics.shape_functions = of.shape;
  if (of.shape == "bernstein") scene.numerics.scheme = "TLMPM";
  scene.outputs.samples = 10;
  scene.outputs.snapshots = 10;
  return scene;
}

class Ring : public testing::TestWithParam<RingCase> {
 protected:
  int axes() const { return grid_axes(GetParam().dimension); }
  /// Cells of the length: none that fills whole tiles of the grid.
  int coarse() const { return GetParam().dimension == Dimension::bar ? 70 : 18; }
  std::size_t axis() const { return GetParam().dimension == Dimension::axisymmetric ? 1 : 0; }
  void set_velocity(Scene& scene, const std::string& formula) const {
    (axis() == 1 ? scene.bodies[0].initial_velocity.y : scene.bodies[0].initial_velocity.x) = formula;
  }
};
INSTANTIATE_TEST_SUITE_P(Registry, Ring, testing::ValuesIn(all_rings()),
                         [](const auto& named) { return name_of(named.param); });

/// Root mean square error of the velocity of a wave that has run once around, relative to its amplitude.
double error_after_a_turn(Scene scene, std::size_t axis, int axes) {
  const std::string s = axis == 1 ? "y" : "x";
  const std::string wave = "1e-4*sin(2*pi*" + s + ")";
  (axis == 1 ? scene.bodies[0].initial_velocity.y : scene.bodies[0].initial_velocity.x) = wave;
  // d'Alembert: of the two waves of v = f(x - c t) only the one to the right is there with stress -rho c v.
  scene.bodies[0].initial_stress.components[axis] = "-" + wave;
  scene.analysis.end_time = 1;
  const Histories run(scene);
  const Snapshot& last = run.memory.snapshots.back();
  double sum = 0;
  const auto stride = static_cast<std::size_t>(axes);
  for (std::size_t i = axis; i < last.position.size(); i += stride) {
    const double difference = last.velocity[i] / 1e-4 - std::sin(2 * std::numbers::pi * (last.position[i] - 1));
    sum += difference * difference;
  }
  return std::sqrt(sum * axes / static_cast<double>(last.position.size()));
}

TEST_P(Ring, LetsAWaveRunAroundAsDAlembertSays) {
  const double coarse = error_after_a_turn(ring(GetParam(), this->coarse()), axis(), axes());
  const double fine = error_after_a_turn(ring(GetParam(), 2 * this->coarse()), axis(), axes());
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("order", std::to_string(std::log2(coarse / fine)));
  // The grid's dispersion is of second order; 16 cells are few for quadratic Bernstein functions, whose elements
  // are two cells wide.
  EXPECT_GT(std::log2(coarse / fine), GetParam().shape == "bernstein" ? 1.75 : 1.95);
}

TEST_P(Ring, StaysAtRestUnderItsOwnStress) {
  // Cells of 1/64, so that nothing is rounded at first: a stress as large as the modulus makes rounding grow.
  Scene scene = ring(GetParam(), coarse(), coarse() / 64.0);
  scene.bodies[0].initial_stress.components[axis()] = "1";
  scene.analysis.end_time = 1;
  const Histories run(scene);
  // Free ends would move by 1. Forces of cell size times stress are rounded in every step.
  for (double v : run.memory.snapshots.back().velocity) EXPECT_NEAR(v, 0, 100 * epsilon * run.steps());
}

TEST_P(Ring, TurnsManyTimesWithoutANotice) {
  Scene scene = ring(GetParam(), coarse());
  set_velocity(scene, "7");
  scene.analysis.end_time = 1;
  scene.numerics.time_step = 0.05 / coarse();
  const Histories run(scene);
  const Snapshot &first = run.memory.snapshots.front(), &last = run.memory.snapshots.back();
  // Each step rounds positions of up to 8; see also the free flight of the conformance tests.
  const double rounding = 8 * epsilon * run.steps();
  for (std::size_t i = 0; i < last.position.size(); ++i) {
    const bool moves = i % static_cast<std::size_t>(axes()) == axis();
    EXPECT_NEAR(last.position[i], first.position[i] + (moves ? 7 : 0), 7 * rounding);
    EXPECT_NEAR(last.velocity[i], moves ? 7 : 0, 7 * rounding);
  }
}

/// What happens to one body in a wide domain, and to the same body cut in two by the faces of a periodic one
/// that is 13 cells long.
struct Split {
  std::string name, scheme, shape;
  std::vector<BoundaryDefinition> wide, periodic;
};
std::ostream& operator<<(std::ostream& out, const Split& split) { return out << split.name; }

constexpr double period = 3.25;

Scene split_block(const Split& split, bool cut) {
  Scene scene = test::block(100);
  scene.numerics.scheme = split.scheme;
  scene.numerics.shape_functions = split.shape;
  scene.domain.lower = {0, -2};
  scene.domain.upper = {cut ? period : 40.0, 6};
  scene.bodies = {{"block", "solid", Box{{period - 1, 0}, {cut ? period : period + 0.5, 1}}, 2, {}}};
  if (cut) scene.bodies.push_back({"rest", "solid", Box{{0, 0}, {0.5, 1}}, 2, {}});
  for (BodyDefinition& body : scene.bodies)
    body.initial_velocity = {"1.1+0.3*sin(2*pi*x/3.25)", "0.2*cos(2*pi*x/3.25)-0.2"};
  scene.boundaries = cut ? split.periodic : split.wide;
  if (cut) scene.boundaries.push_back(periodic(Axis::x));
  scene.analysis.end_time = 8;
  scene.outputs.probes.clear();
  return scene;
}

std::vector<Split> all_splits() {
  std::vector<Split> splits;
  const Contact smooth{};
  for (const std::string scheme : {"MUSL", "TLMPM"})
    for (const std::string shape : {"linear", "quadratic_bspline"}) {
      const auto add = [&](const std::string& name, std::vector<BoundaryDefinition> wide,
                           std::vector<BoundaryDefinition> periodic) {
        splits.push_back({scheme + "_" + shape + "_" + name, scheme, shape, std::move(wide), std::move(periodic)});
      };
      const std::vector<BoundaryDefinition> floor = {{"floor", {}, RigidPlane{{0, -0.25}, {0, 1}, smooth}}};
      add("free", {}, {});
      // What a body meets later total Lagrangian schemes refuse.
      if (scheme != "TLMPM") add("floor", floor, floor);
      const auto held = [](double x) {
        return std::vector<BoundaryDefinition>{
            {"held", Box{{x, 0.5}, {x, 1}}, PrescribedVelocity{{"0.1*t", "0"}}}};
      };
      add("nodes", held(period), held(period));
      add("nodes_of_the_lower_face", held(period), held(0));
      const auto ball = [&](double x) {
        return std::vector<BoundaryDefinition>{{"ball", {}, RigidBall{{x, -1.2}, 1, smooth}}};
      };
      if (scheme != "TLMPM") add("ball", ball(period), ball(0));
    }
  return splits;
}

class SplitBlock : public testing::TestWithParam<Split> {};
INSTANTIATE_TEST_SUITE_P(Conditions, SplitBlock, testing::ValuesIn(all_splits()),
                         [](const auto& named) { return named.param.name; });

TEST_P(SplitBlock, DoesWhatTheWholeDoes) {
  Split split = GetParam();
  Scene whole_scene = split_block(split, false), cut_scene = split_block(split, true);
  // What stays at its place meets the block only in its first period.
  if (!split.wide.empty() && split.name.find("floor") == std::string::npos)
    whole_scene.analysis.end_time = cut_scene.analysis.end_time = 0.8;
  const Histories whole(whole_scene), cut(cut_scene);
  ASSERT_EQ(whole.rows(), cut.rows());
  for (std::size_t row = 0; row < whole.rows(); ++row)
    for (const char* column : {"momentum.x", "momentum.y", "energies.kinetic", "energies.strain", "energies.work"})
      // Sums in another order, and what elasticity makes of their rounding in as many steps.
      EXPECT_NEAR(whole.at(row, column), cut.at(row, column), 100 * epsilon * whole.steps()) << column << row;
}

/// Everything that rides on a block's surface while it passes the faces of a periodic domain.
Scene ridden(const std::string& scheme, bool cut) {
  Scene scene = test::block(100);
  scene.numerics.scheme = scheme;
  scene.domain.lower = {0, -2};
  scene.domain.upper = {cut ? period : 40.0, 6};
  scene.bodies[0].geometry = Box{{1.65, 0}, {3.15, 1}};
  scene.bodies[0].initial_velocity.x = "0.3";
  Hinge pulled = test::hinge(test::surface("block", Edge::right), HingeKind::mean, {Axis::x});
  pulled.displacement.x = "0.3*t";
  scene.boundaries = {{"pulled", {}, pulled}, {"quiet", {}, Absorbing{test::surface("block", Edge::left)}}};
  if (cut) scene.boundaries.push_back(periodic(Axis::x));
  scene.loads = {{"blow", test::pressure(test::surface("block", Edge::top), 0.1)}};
  scene.analysis.end_time = 4;
  return scene;
}

TEST(Periodic, SurfacePointsGoWithTheirParticles) {
  for (const char* scheme : {"MUSL", "TLMPM"}) {
    const Histories wide(ridden(scheme, false)), cut(ridden(scheme, true));
    ASSERT_EQ(wide.rows(), cut.rows());
    EXPECT_GT(wide.last("middle.displacement.x"), 0.9);
    for (std::size_t row = 0; row < wide.rows(); ++row)
      for (const std::string& column : history_columns(wide.model))
        // The block swings about its hinge through cells, which makes rounding grow by some powers of ten; a point
        // that lost its particle would be off by a period.
        EXPECT_NEAR(wide.at(row, column), cut.at(row, column), 1e8 * epsilon) << column << row;
  }
}

TEST(Periodic, GivesTheSameBitsOnAnyNumberOfThreadsAndFromAnyCheckpoint) {
  const Model model = validate(ridden("MUSL", true));
  test::Memory whole, threads;
  ASSERT_EQ(run(model, {1, 0, {}}, whole, nullptr).end, RunEnd::finished);
  ASSERT_EQ(run(model, {3, 1e9, {}}, threads, nullptr).end, RunEnd::finished);
  EXPECT_EQ(threads.rows, whole.rows);
  const Checkpoint& late = whole.checkpoints.at(whole.checkpoints.size() - 5);
  test::Memory rest;
  ASSERT_EQ(run(model, {2, 1e9, late}, rest, nullptr).end, RunEnd::finished);
  for (auto row = static_cast<std::size_t>(late.sample) + 1; row < whole.rows.size(); ++row)
    EXPECT_EQ(rest.rows.at(row), whole.rows[row]) << row;
}

}  // namespace
}  // namespace trajan
