#include <array>

#include "server/convert.h"
#include "tests/unit/server/every_field.h"
#include "tests/unit/server/scene_schema.h"

namespace trajan {
namespace {

constexpr std::array texts = {
    "analysis { end_time: 1 damping: 2 explicit_dynamics {} }",
    "analysis { relaxation { tolerance: 0.31 most_steps: 32 } }",
    "analysis { quasi_static { load_steps: 11 arc_length { steps: 12 } newton { tolerance: 0.13 most_iterations: "
    "14"
    " most_cuts: 15 growth: 1.6 linear_solver: ITERATIVE } } }",
    "analysis { quasi_static { newton { linear_solver: AUTOMATIC } } }",
    "analysis { implicit_dynamics { time_steps: 21 newton { linear_solver: DIRECT } mass: LUMPED"
    " newmark { beta: 0.22 gamma: 0.23 } } }",
    "analysis { implicit_dynamics { mass: CONSISTENT generalized_alpha { spectral_radius: 0.24 } } }",
    "analysis { modal { mass: LUMPED } }",
    "analysis { buckling {} }",
};

AnalysisKind kind_of(const char* text) { return to_scene(parse(text)).analysis.kind; }

TEST(ConvertAnalysis, TheseTextsUseTheWholeSchema) {
  std::set<std::string> missing = testing::schema_of(*v1::Analysis::descriptor());
  for (const char* text : texts)
    for (const std::string& name : testing::used_by(parse(text))) missing.erase(name);
  EXPECT_THAT(missing, ::testing::ElementsAre("trajan.v1.MASS_MATRIX_UNSPECIFIED",
                                              "trajan.v1.Newton.LINEAR_SOLVER_UNSPECIFIED"));
}

TEST(ConvertAnalysis, KeepsTimeAndDamping) {
  const Analysis analysis = to_scene(parse(texts[0])).analysis;
  EXPECT_EQ(analysis.end_time, 1);
  EXPECT_EQ(analysis.damping, 2);
}

TEST(ConvertAnalysis, TellsKindsApart) {
  EXPECT_TRUE(std::holds_alternative<ExplicitDynamics>(kind_of(texts[0])));
  EXPECT_TRUE(std::holds_alternative<ExplicitDynamics>(kind_of(""))) << "the default";
  EXPECT_TRUE(std::holds_alternative<Relaxation>(kind_of(texts[1])));
  EXPECT_EQ(std::get<Modal>(kind_of(texts[6])).mass, MassMatrix::lumped);
  EXPECT_TRUE(std::holds_alternative<Buckling>(kind_of(texts[7])));
}

TEST(ConvertAnalysis, KeepsRelaxations) {
  const auto analysis = std::get<Relaxation>(kind_of(texts[1]));
  EXPECT_EQ(analysis.tolerance, 0.31);
  EXPECT_EQ(analysis.most_steps, 32);
}

TEST(ConvertAnalysis, KeepsQuasiStaticAnalysesAndNewtonsMethod) {
  const auto analysis = std::get<QuasiStatic>(kind_of(texts[2]));
  EXPECT_EQ(analysis.load_steps, 11);
  ASSERT_TRUE(analysis.arc_length);
  EXPECT_EQ(analysis.arc_length->steps, 12);
  EXPECT_EQ(analysis.newton.tolerance, 0.13);
  EXPECT_EQ(analysis.newton.most_iterations, 14);
  EXPECT_EQ(analysis.newton.most_cuts, 15);
  EXPECT_EQ(analysis.newton.growth, 1.6);
  EXPECT_EQ(analysis.newton.linear_solver, LinearSolver::iterative);
  const auto plain = std::get<QuasiStatic>(kind_of(texts[3]));
  EXPECT_FALSE(plain.arc_length);
  EXPECT_EQ(plain.newton.tolerance, Newton{}.tolerance);
  EXPECT_EQ(plain.newton.linear_solver, LinearSolver::automatic);
}

TEST(ConvertAnalysis, KeepsImplicitDynamics) {
  const auto newmark = std::get<ImplicitDynamics>(kind_of(texts[4]));
  EXPECT_EQ(newmark.time_steps, 21);
  EXPECT_EQ(newmark.newton.linear_solver, LinearSolver::direct);
  EXPECT_EQ(newmark.mass, MassMatrix::lumped);
  EXPECT_EQ(std::get<Newmark>(newmark.method).beta, 0.22);
  EXPECT_EQ(std::get<Newmark>(newmark.method).gamma, 0.23);
  const auto alpha = std::get<ImplicitDynamics>(kind_of(texts[5]));
  EXPECT_EQ(alpha.mass, MassMatrix::consistent);
  EXPECT_EQ(std::get<GeneralizedAlpha>(alpha.method).spectral_radius, 0.24);
}

TEST(ConvertAnalysis, UnknownWordsAreKeptAsSuch) {
  v1::Scene scene = parse(texts[4]);
  scene.mutable_analysis()->mutable_implicit_dynamics()->set_mass(static_cast<v1::MassMatrix>(99));
  EXPECT_EQ(std::get<ImplicitDynamics>(to_scene(scene).analysis.kind).mass, MassMatrix::unspecified);
}

}  // namespace
}  // namespace trajan
