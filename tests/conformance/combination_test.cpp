#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "solver/schemes/scheme.h"
#include "solver/transfers/transfer.h"
#include "tests/conformance/material_point.h"
#include "tests/unit/simulation/scenes.h"

/// Every pair of choices that a scene can make, over one small scene: each either runs with its checks holding
/// or is refused with a reason.
namespace trajan::combination_test {
namespace {

/// One choice: what it is called, and what it does to a scene.
struct Choice {
  std::string name;
  std::function<void(Scene&)> apply;
};
/// The choices of one kind, of which a scene makes one.
using Choices = std::vector<Choice>;

Choices dimensions() {
  const auto choose = [](const char* name, Dimension dimension) {
    return Choice{name, [dimension](Scene& scene) { scene.domain.dimension = dimension; }};
  };
  return {choose("bar", Dimension::bar), choose("plane_stress", Dimension::plane_stress),
          choose("plane_strain", Dimension::plane_strain), choose("axisymmetric", Dimension::axisymmetric),
          choose("solid", Dimension::solid)};
}

Choices laws() {
  Choices choices;
  for (const MaterialKind& kind : material_kinds()) {
    const std::vector<double> values = test::sample_parameters(kind).front();
    choices.push_back({std::string(kind.name), [&kind, values](Scene& scene) {
                         MaterialDefinition& material = scene.materials[0];
                         material.law = kind.name;
                         material.parameters.clear();
                         for (std::size_t i = 0; i < values.size(); ++i)
                           material.parameters[std::string(kind.parameters[i].name)] = values[i];
                       }});
  }
  return choices;
}

Choices named(std::span<const std::string_view> names, std::string Numerics::*field) {
  Choices choices;
  for (std::string_view name : names)
    choices.push_back({std::string(name), [name, field](Scene& scene) { scene.numerics.*field = name; }});
  return choices;
}

Choices contacts() {
  const auto separate = [](const char* name, double friction) {
    return Choice{name, [friction](Scene& scene) { scene.contacts = {{{}, friction}}; }};
  };
  return {separate("frictionless", 0), separate("frictional", 0.3)};
}

Vector along_axes(Dimension dimension, double value) {
  const int axes = grid_axes(dimension);
  return {value, axes > 1 ? value : 0, axes > 2 ? value : 0};
}

/// The block's lower side across x, which it begins at.
constexpr double side = 3;

/// Nodes on the block's side.
Region nodes_on_side(Dimension dimension) {
  Box box{along_axes(dimension, 0), along_axes(dimension, 8)};
  box.lower.x = box.upper.x = side;
  return box;
}

Surface surface_of_side(Edge edge) {
  Surface surface;
  surface.body = "block";
  surface.part = edge;
  return surface;
}

/// On the side, in all dimensions, whether that makes sense or not. Choices of dimensions are made first.
Choices boundaries() {
  Choices choices;
  const auto on_nodes = [&](const char* name, auto condition) {
    choices.push_back({name, [condition](Scene& scene) {
                         scene.boundaries = {{"condition", nodes_on_side(scene.domain.dimension), condition}};
                       }});
  };
  const auto by_itself = [&](const char* name, auto condition) {
    choices.push_back({name, [condition](Scene& scene) { scene.boundaries = {{"condition", {}, condition}}; }});
  };
  on_nodes("fixed", Fixed{});
  on_nodes("roller", Roller{Axis::x});
  on_nodes("prescribed_velocity", PrescribedVelocity{{"0.1", {}}});
  on_nodes("prescribed_displacement", PrescribedDisplacement{{"0.1*t", {}}});
  by_itself("symmetry", Symmetry{Edge::left});
  by_itself("rigid_plane", RigidPlane{{side, 0}, {1, 0}, {0.3, false, false, {}}});
  by_itself("rigid_ball", RigidBall{{0, 0}, side * std::numbers::sqrt2, {0.3, false, false, {}}});
  by_itself("absorbing", Absorbing{surface_of_side(Edge::left)});
  by_itself("periodic", Periodic{Axis::x});
  for (const auto& [name, kind] :
       {std::pair("whole_hinge", HingeKind::whole), std::pair("mean_hinge", HingeKind::mean)}) {
    Hinge hinge;
    hinge.surface = surface_of_side(Edge::left);
    hinge.kind = kind;
    by_itself(name, hinge);
  }
  return choices;
}

Choices loads() {
  const auto choose = [](const char* name, auto load) {
    return Choice{name, [load](Scene& scene) {
                    scene.loads = {{"load", load(scene.domain.dimension), "exp(-t)"}};
                  }};
  };
  const auto pressure = [](bool follows) {
    return [follows](Dimension) {
      Pressure load;
      load.surface = surface_of_side(Edge::right);
      load.pressure = 0.1;
      load.follows = follows;
      return load;
    };
  };
  return {choose("point_force",
                 [](Dimension d) {
                   return PointForce{"block", along_axes(d, 4), {0.1, 0}};
                 }),
          choose("edge_traction",
                 [](Dimension) {
                   return EdgeTraction{"block", Edge::right, {0.1, 0}, ""};
                 }),
          choose("pressure", pressure(true)), choose("reference_pressure", pressure(false)),
          choose("body_force", [](Dimension) {
            return BodyForce{{0.1, 0}, {}};
          })};
}

/// Of the external forces. Nodes that splines hardly reach come to rest last, after thousands of steps.
constexpr double tolerance_of_relaxation = 0.01;

/// Beside explicit dynamics.
Choices analyses() {
  const auto choose = [](const char* name, AnalysisKind kind) {
    return Choice{name, [kind](Scene& scene) { scene.analysis.kind = kind; }};
  };
  return {choose("relaxation", Relaxation{tolerance_of_relaxation}), choose("quasi_static", QuasiStatic{4}),
          choose("implicit_dynamics", ImplicitDynamics{8}), choose("modal", Modal{}),
          choose("buckling", Buckling{})};
}

Choices particles() {
  return {Choice{"gauss", [](Scene& scene) { scene.bodies[0].particle_layout = ParticleLayout::gauss; }},
          Choice{"mean_dilatation", [](Scene& scene) { scene.numerics.locking_remedy = "mean_dilatation"; }},
          Choice{"damage", [](Scene& scene) {
                   scene.materials[0].damage = {{"tensile_strength", 10.0}, {"shape", 4.0}};
                 }}};
}

Choices precisions() {
  return {{"floats", [](Scene& scene) { scene.numerics.precision = float_precision; }}};
}

/// All kinds of choices that registries know, and those that scenes make beside.
std::vector<Choices> all_choices() {
  return {dimensions(),
          laws(),
          named(scheme_names(), &Numerics::scheme),
          named(shape_names(), &Numerics::shape_functions),
          named(transfer_names(), &Numerics::transfer),
          contacts(),
          boundaries(),
          loads(),
          analyses(),
          particles(),
          precisions()};
}

/// Of a block that is held on its side and at rest.
bool is_static(const Scene& scene) {
  return !std::holds_alternative<ExplicitDynamics>(scene.analysis.kind) &&
         !std::holds_alternative<ImplicitDynamics>(scene.analysis.kind);
}

/// At rest, with a support, and with a load that grows from nothing.
Scene held_and_loaded(Scene scene) {
  scene.analysis.end_time = 1;
  if (scene.boundaries.empty()) scene.boundaries = {{"condition", nodes_on_side(scene.domain.dimension), Fixed{}}};
  if (scene.loads.empty() && !std::holds_alternative<Modal>(scene.analysis.kind))
    scene.loads = {{"load", BodyForce{{-0.1, 0}, {}}, 1.0}};
  for (LoadDefinition& load : scene.loads) load.time = Ramp{0, 1, false};
  // Velocities that are mapped twice miss a part of a surface load's work that falls with the step: 2 % at a half.
  if (std::holds_alternative<Relaxation>(scene.analysis.kind)) scene.numerics.time_step_fraction = 0.125;
  return scene;
}

bool is_explicit(const Scene& scene) { return std::holds_alternative<ExplicitDynamics>(scene.analysis.kind); }

/// The time in which sound crosses the block twice and a half.
double crossings(const Scene& scene) {
  const MaterialDefinition& material = scene.materials[0];
  const MaterialKind& kind = *find_material_kind(material.law);
  std::vector<double> values;
  for (const auto& parameter : kind.parameters)
    values.push_back(material.parameters.at(std::string(parameter.name)));
  return 5 / kind.wave_speed(values, material.density, scene.domain.dimension);
}

/// A block that is stretched by its velocity and flies through some cells. Made once all choices are, since
/// vectors have the components of the dimension. In axisymmetric scenes it is a ring.
Scene scene_of(const std::vector<const Choice*>& choices) {
  Scene scene;
  scene.name = "block";
  scene.domain.dimension = Dimension::plane_strain;
  scene.materials = {test::material("neo_hookean", 100, 0.3, 1)};
  scene.bodies.resize(1);
  for (const Choice* choice : choices) choice->apply(scene);
  const Dimension dimension = scene.domain.dimension;
  scene.domain.upper = along_axes(dimension, 8);
  scene.domain.cell_size = 0.5;
  BodyDefinition& body = scene.bodies[0];
  body.name = "block";
  body.material = "solid";
  body.geometry = Box{along_axes(dimension, 3), along_axes(dimension, 5)};
  scene.analysis.end_time = is_explicit(scene) ? 1e9 : crossings(scene);
  scene.outputs.samples = 4;
  scene.outputs.snapshots = 1;
  if (is_static(scene)) return held_and_loaded(std::move(scene));
  // A ring cannot fly outwards.
  body.initial_velocity.x = dimension == Dimension::axisymmetric ? "0.01*sin(pi*x/2)" : "0.2+0.01*sin(pi*x/2)";
  if (grid_axes(dimension) > 1) body.initial_velocity.y = "0.2+0.01*sin(pi*y/2)";
  if (grid_axes(dimension) > 2) body.initial_velocity.z = "0.1";
  // In scenes with contacts it runs into another one that is at rest.
  if (!scene.contacts.empty()) {
    Box beside{along_axes(dimension, 3), along_axes(dimension, 5)};
    beside.lower.x = 5;
    beside.upper.x = 6;
    scene.bodies.push_back({"other", "solid", beside, 2, {}});
  }
  return scene;
}

struct Pair {
  const Choice *first, *second;
};
std::ostream& operator<<(std::ostream& out, const Pair& pair) {
  return out << pair.first->name << " and " << pair.second->name;
}

/// Kept for as long as tests refer to them.
const std::vector<Choices>& choices() {
  static const std::vector<Choices> all = all_choices();
  return all;
}

std::vector<Pair> all_pairs() {
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < choices().size(); ++a)
    for (std::size_t b = a + 1; b < choices().size(); ++b)
      for (const Choice& first : choices()[a])
        for (const Choice& second : choices()[b]) pairs.push_back({&first, &second});
  return pairs;
}

/// That momentum and energy are kept, as far as what the scene does can keep them, and forces are in balance at
/// rest.
void expect_right(const Scene& scene, const Model& model, const std::vector<std::vector<double>>& rows) {
  const std::vector<double>&first = rows.front(), &last = rows.back();
  for (double value : last) EXPECT_TRUE(std::isfinite(value));
  const auto of = [&](const char* column) { return last[test::column(model, column)]; };
  const double balance = of("energies.balance_error");
  // Energy is never made; a coarse grid's leapfrog may be a hundredth off.
  EXPECT_LT(balance, 0.01);
  if (is_static(scene)) {
    // Light nodes of splines, and XPIC, take some.
    EXPECT_GT(balance, -0.03);
    if (std::holds_alternative<Relaxation>(scene.analysis.kind)) {
      EXPECT_LE(of("relaxation.residual"), tolerance_of_relaxation);
    }
    return;
  }
  if (!scene.boundaries.empty() || !scene.loads.empty()) return;
  // Nothing acts on the block. Schemes and transfers that smooth take energy.
  EXPECT_GT(balance, -0.2);
  // A float velocity is rounded by up to 6e-8 of 0.2 in each of some 40 half steps, a cube of such blocks
  // weighs 8.
  const double rounding = model.numerics.precision == float_precision ? 4e-6 : 1e-9;
  for (int axis = 0; axis < grid_axes(model.dimension); ++axis) {
    if (axis == 0 && model.dimension == Dimension::axisymmetric) continue;
    const std::size_t column =
        test::column(model, std::string("momentum.") + std::string("xyz").at(static_cast<std::size_t>(axis)));
    EXPECT_NEAR(last[column], first[column], rounding) << axis;
  }
}

class Combination : public testing::TestWithParam<Pair> {};

TEST_P(Combination, RunsRightOrIsRefusedWithAReason) {
  Scene scene = scene_of({GetParam().first, GetParam().second});
  try {
    // Twenty of the largest steps.
    if (is_explicit(scene)) scene.analysis.end_time = 20 * plan(validate(scene)).time_step;
    const Model model = validate(scene);
    test::Memory memory;
    const RunResult result = run(model, {}, memory, nullptr);
    if (is_static(scene) && result.end == RunEnd::diverged) {
      // A block that turns, or one that no load may buckle, says so.
      EXPECT_FALSE(result.divergence->cause.empty());
      EXPECT_FALSE(result.divergence->remedy.empty());
      return;
    }
    ASSERT_EQ(result.end, RunEnd::finished) << result.divergence->cause;
    expect_right(scene, model, memory.rows);
  } catch (const InvalidScene& refused) {
    ASSERT_FALSE(refused.violations().empty());
    for (const Violation& violation : refused.violations()) {
      EXPECT_FALSE(violation.path.empty());
      EXPECT_FALSE(violation.problem.empty());
      EXPECT_FALSE(violation.remedy.empty());
    }
  }
}

std::string name_of(const testing::TestParamInfo<Pair>& tested) {
  return tested.param.first->name + "_" + tested.param.second->name;
}
INSTANTIATE_TEST_SUITE_P(Registry, Combination, testing::ValuesIn(all_pairs()), name_of);

}  // namespace
}  // namespace trajan::combination_test
