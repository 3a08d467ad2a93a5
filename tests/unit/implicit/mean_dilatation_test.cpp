#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

#include "solver/implicit/step_balance.h"
#include "tests/unit/implicit/statics.h"

/// The particles of a cell that share their volume ratio.
namespace trajan {
namespace {

using namespace test;

struct Case {
  const char* name;
  Dimension dimension;
  const char *law, *scheme, *shapes;
};
void PrintTo(const Case& of, std::ostream* out) { *out << of.name; }

/// A block of two by two (by two) cells.
Scene cube(const Case& of, const char* remedy) {
  Scene scene;
  scene.name = "cube";
  const bool solid = of.dimension == Dimension::solid;
  const double below = of.dimension == Dimension::axisymmetric ? 0 : -1;
  scene.domain = {of.dimension, {below, -1, solid ? -1.0 : 0}, {3, 3, solid ? 3.0 : 0}, 0.5};
  scene.materials = {material(of.law, 100, 0.45, 1)};
  if (of.law == std::string("von_mises")) scene.materials[0].parameters["yield_stress"] = 2;
  scene.bodies = {{"block", "solid", Box{{0.5, 0.5, solid ? 0.5 : 0}, {1.5, 1.5, solid ? 1.5 : 0}}, 2, {}}};
  scene.analysis = {1, 0, QuasiStatic{}};
  scene.numerics.scheme = of.scheme;
  scene.numerics.shape_functions = of.shapes;
  scene.numerics.locking_remedy = remedy;
  return scene;
}

/// Forces and stiffness of a body as functions of displacements.
struct ElasticBody {
  Model model;
  Executor executor;
  GridView view;
  Responses responses;

  explicit ElasticBody(const Scene& scene)
      : model(validate(scene)), executor((model), 1), view(begun(), executor), responses(model, executor) {}
  const Model& begun() {
    executor.begin();
    return model;
  }
  static std::span<const double> span_of(const Eigen::VectorXd& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
  }
  /// Displacements of no particular kind, of strains about `size`.
  Eigen::VectorXd some(double size, double phase) const {
    Eigen::VectorXd u(static_cast<Eigen::Index>(view.on.unknowns()));
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = 0.5 * size * std::sin(phase + 2.3 * static_cast<double>(i));
    return u;
  }
  Eigen::VectorXd forces(const Eigen::VectorXd& u) {
    EXPECT_TRUE(responses.evaluate(view.on, span_of(u), 1, true).none());
    Eigen::VectorXd f = Eigen::VectorXd::Zero(u.size());
    view.assembly.add_forces(responses.forces(), span_of(u), {f.data(), static_cast<std::size_t>(f.size())});
    return f;
  }
  SparseMatrix stiffness(const Eigen::VectorXd& u) {
    SparseMatrix k;
    forces(u);
    view.assembly.stiffness(responses.tangents(), k);
    responses.add_stiffness(view.on, k);
    return k;
  }
};

class MeanDilatationTangent : public ::testing::TestWithParam<Case> {};

TEST_P(MeanDilatationTangent, IsTheDerivativeOfTheForces) {
  ElasticBody body(cube(GetParam(), "mean_dilatation"));
  const Eigen::VectorXd before = body.some(0.1, 1), at = body.some(0.1, 2), along = body.some(1, 3);
  // From a state in which particles are not those at rest, and differ from what laws have felt.
  body.responses.commit(body.view.on, ElasticBody::span_of(before), 1);
  const SparseMatrix stiffness = body.stiffness(at);
  const double step = 1e-6;
  const Eigen::VectorXd difference =
      (body.forces(at + step * along) - body.forces(at - step * along)) / (2 * step);
  // Differences leave the square of the step, and rounding over the step: 1e-10.
  EXPECT_LT((stiffness * along - difference).norm(), 1e-8 * difference.norm());
  if (GetParam().law != std::string("neo_hookean")) return;
  EXPECT_LT((stiffness - SparseMatrix(stiffness.transpose())).norm(), 1e-13 * stiffness.norm());
}

TEST_P(MeanDilatationTangent, UniformDeformationsAreFeltAsTheyAre) {
  ElasticBody with(cube(GetParam(), "mean_dilatation")), without(cube(GetParam(), "none"));
  // Homogeneous also about the axis.
  const int axes = with.view.on.axes();
  const bool hoop = with.view.on.axisymmetric();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(with.view.on.unknowns()));
  const Grid& grid = with.model.grid;
  for (std::size_t n = 0; n < with.view.on.nodes(); ++n) {
    const auto index = with.view.on.grid_index(n);
    const double x = grid.origin.x + grid.cell * static_cast<double>(index[0]);
    const double y = grid.origin.y + grid.cell * static_cast<double>(index[1]);
    const Eigen::Index first = static_cast<Eigen::Index>(n) * axes;
    u[first] = 0.03 * x + (hoop ? 0 : 0.02 * y);
    u[first + 1] = (hoop ? 0 : -0.04 * x) - 0.05 * y;
  }
  const Eigen::VectorXd expected = without.forces(u);
  // Rounding, of sums and of a power of numbers near 1.
  EXPECT_LT((with.forces(u) - expected).norm(), 1e-12 * expected.norm());
}

const Case cases[] = {{"PlaneStrain", Dimension::plane_strain, "neo_hookean", "TLMPM", "linear"},
                      {"PlaneStrainUpdated", Dimension::plane_strain, "neo_hookean", "MUSL", "linear"},
                      {"PlaneStrainRate", Dimension::plane_strain, "linear_elastic", "TLMPM", "linear"},
                      {"PlaneStrainRateUpdated", Dimension::plane_strain, "linear_elastic", "MUSL", "linear"},
                      {"PlaneStrainLinear", Dimension::plane_strain, "linear_strain_elastic", "TLMPM", "linear"},
                      {"PlaneStrainPlastic", Dimension::plane_strain, "von_mises", "TLMPM", "linear"},
                      {"Splines", Dimension::plane_strain, "neo_hookean", "TLMPM", "quadratic_bspline"},
                      {"CubicSplines", Dimension::plane_strain, "neo_hookean", "TLMPM", "cubic_bspline"},
                      {"Bernstein", Dimension::plane_strain, "neo_hookean", "TLMPM", "bernstein"},
                      {"Axisymmetric", Dimension::axisymmetric, "neo_hookean", "TLMPM", "linear"},
                      {"AxisymmetricRate", Dimension::axisymmetric, "linear_elastic", "TLMPM", "linear"},
                      {"Solid", Dimension::solid, "neo_hookean", "TLMPM", "linear"},
                      {"SolidUpdated", Dimension::solid, "neo_hookean", "MUSL", "linear"}};
INSTANTIATE_TEST_SUITE_P(Cases, MeanDilatationTangent, ::testing::ValuesIn(cases),
                         [](const auto& of) { return std::string(of.param.name); });

/// A nearly incompressible cantilever that bends far.
Scene cantilever(const char* remedy, const char* scheme = "TLMPM", int load_steps = 4) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 4, 0.25, 0.4999);
  scene.boundaries = {{"left", Box{{-1, -4}, {0, 3}}, Fixed{}}};
  scene.domain.lower.y = -4;
  scene.numerics.scheme = scheme;
  scene.numerics.locking_remedy = remedy;
  scene.loads = {growing(traction("block", Edge::right, {0, -0.3}))};
  scene.analysis.kind = QuasiStatic{load_steps, {1e-9}};
  scene.outputs.probes = {{"tip", Vector{4, 0.5}, {Field::displacement}, ""}};
  scene.outputs.samples = 1;
  return scene;
}

double tip_of(const Scene& scene) {
  const Model model = validate(scene);
  const Answer answer = solve(model);
  EXPECT_EQ(answer.result.end, RunEnd::finished)
      << (answer.result.divergence ? answer.result.divergence->cause : "");
  return answer.memory.rows.back()[column(model, "tip.displacement.y")];
}

TEST(MeanDilatation, FreesABendingBeamFromLocking) {
  // Timoshenko's beam in plane strain, P L^3 / (3 E' I) + P L / (5/6 G): E' = 100 / (1 - nu^2), G = 100 / 3.
  const double beam = 0.3 * 64 / (3 * 133.3 / 12) + 0.3 * 4 * 6 / 5 / 33.3;
  // Four linear cells over the height, the clamped edge and the large deflection make it stiffer by some percent.
  EXPECT_NEAR(-tip_of(cantilever("mean_dilatation")), beam, 0.08 * beam);
  EXPECT_LT(-tip_of(cantilever("none")), 0.1 * beam);
}

/// A short one, with Poisson's ratio 0.499, which explicit steps can bear.
Scene short_cantilever(const char* law, const char* scheme, const char* remedy, AnalysisKind kind) {
  Scene scene = block(Dimension::plane_strain, law, 2, 0.25, 0.499);
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}};
  scene.numerics.scheme = scheme;
  scene.numerics.locking_remedy = remedy;
  scene.loads = {growing(traction("block", Edge::right, {0, -0.6}))};
  scene.analysis.kind = kind;
  scene.outputs.probes = {{"tip", Vector{2, 0.5}, {Field::displacement}, ""}};
  scene.outputs.samples = 1;
  return scene;
}

// Particles of a cell have one pressure but for what shears add to it; means by mass and by volume differ by the
// compression, a thousandth.
TEST(MeanDilatation, IsTheSameInExplicitSteps) {
  for (const char* law : {"neo_hookean", "linear_elastic", "linear_strain_elastic"}) {
    const auto tip = [&](const char* remedy, AnalysisKind kind) {
      return tip_of(short_cantilever(law, "TLMPM", remedy, kind));
    };
    const double implicit = tip("mean_dilatation", QuasiStatic{4}),
                 relaxed = tip("mean_dilatation", Relaxation{1e-4});
    EXPECT_NEAR(relaxed, implicit, 3e-3 * std::abs(implicit)) << law;
    EXPECT_LT(std::abs(tip("none", QuasiStatic{4})), 0.6 * std::abs(implicit)) << law;
  }
}

// As much as without it: the steps leave 1e-3 of the energy at most.
TEST(MeanDilatation, KeepsTheEnergyOfExplicitSteps) {
  for (const char* law : {"neo_hookean", "linear_elastic"}) {
    Scene scene = short_cantilever(law, "TLMPM", "mean_dilatation", ExplicitDynamics{});
    scene.loads.clear();
    scene.bodies[0].initial_velocity.y = "-0.5*x";
    scene.analysis.end_time = 0.4;
    const Model model = validate(scene);
    const Answer answer = solve(model);
    ASSERT_EQ(answer.result.end, RunEnd::finished) << law;
    EXPECT_NEAR(answer.memory.rows.back()[column(model, "energies.balance_error")], 0, 1e-3) << law;
  }
}

TEST(MeanDilatation, AnElasticBodyForgetsTheStepsThatItWasLoadedBy) {
  // Newton's tolerance, 1e-9 of the forces, times the slenderness of the beam.
  EXPECT_NEAR(tip_of(cantilever("mean_dilatation", "TLMPM", 2)), tip_of(cantilever("mean_dilatation", "TLMPM", 5)),
              1e-7);
}

TEST(MeanDilatation, ResidualsConvergeQuadratically) {
  const Model model = validate(cantilever("mean_dilatation"));
  Executor executor(model, 1);
  executor.begin();
  QuasiStaticSteps steps(model, std::get<QuasiStatic>(model.analysis), executor, nullptr);
  for (int i = 0; !steps.advance(1, i); ++i) ASSERT_LT(i, 200);
  const std::vector<double>& residuals = steps.residuals();
  int checked = 0;
  for (std::size_t i = 1; i < residuals.size(); ++i) {
    // Each is the square of the one before it times a constant, as long as rounding, 1e-16 times the stiffness of
    // volume over that of shape, is far; an error in the tangent would leave a constant factor.
    if (residuals[i - 1] > 1e-2 || residuals[i - 1] < 1e-6) continue;
    ++checked;
    EXPECT_LE(residuals[i], 100 * residuals[i - 1] * residuals[i - 1]) << ::testing::PrintToString(residuals);
  }
  EXPECT_GE(checked, 1) << ::testing::PrintToString(residuals);
}

TEST(MeanDilatation, GoesOnFromCheckpointsWithTheSameBits) {
  Scene scene = cantilever("mean_dilatation");
  scene.outputs.samples = 2;
  const Model model = validate(scene);
  Memory whole, resumed;
  RunOptions options;
  options.checkpoint_interval = 0;
  run(model, options, whole, {});
  options.resume = whole.checkpoints.at(0);
  resumed.rows = {whole.rows.begin(),
                  whole.rows.begin() + static_cast<std::ptrdiff_t>(options.resume->sample) + 1};
  run(model, options, resumed, {});
  EXPECT_EQ(resumed.rows, whole.rows);
}

}  // namespace
}  // namespace trajan
