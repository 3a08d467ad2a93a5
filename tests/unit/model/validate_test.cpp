#include "solver/model/validate.h"

#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

TEST(Validate, AcceptsTheSampleScene) {
  for (const Violation& violation : violations_of(sample_scene()))
    ADD_FAILURE() << violation.path << violation.problem;
}

TEST(Validate, FindsTenDifferentMistakesAtOnce) {
  Scene scene = sample_scene();
  scene.name = "my beam";
  scene.constants[1].value = "8 +";
  scene.domain.thickness = -1;
  scene.materials[0].parameters["poissons_ratio"] = 0.5;
  scene.bodies[0].material = "ruber";
  scene.bodies[1].geometry = Disc{{4, 1.5}, -0.4};
  scene.boundaries[0].nodes = Box{{20, 0}, {21, 1}};
  std::get<BodyForce>(scene.loads[1].kind).bodies = {"beem"};
  scene.numerics.scheme = "MULS";
  scene.measures[0].quantity = "tip.displacement.z";
  EXPECT_THAT(paths_of(scene),
              UnorderedElementsAre("name", "constants[1].value", "domain.thickness",
                                   "materials[0].linear_elastic.poissons_ratio", "bodies[0].material",
                                   "bodies[1].geometry.disc.radius", "boundaries[0].nodes",
                                   "loads[1].body_force.bodies[0]", "numerics.scheme", "measures[0].quantity"));
}

TEST(Validate, SaysWhatWasGivenAndWhatWouldBeRight) {
  Scene scene = sample_scene();
  scene.bodies[0].material = "ruber";
  const Violation violation = violations_of(scene).at(0);
  EXPECT_EQ(violation.value, "ruber");
  EXPECT_EQ(violation.problem, "there is no material \"ruber\"");
  EXPECT_EQ(violation.remedy, "did you mean \"rubber\"? (materials: rubber)");
  EXPECT_THAT(InvalidScene({violation}).what(), HasSubstr("bodies[0].material"));
}

TEST(Validate, EmptySceneNamesWhatIsRequired) {
  EXPECT_THAT(paths_of(Scene()),
              UnorderedElementsAre("name", "domain.dimension", "domain.upper", "domain.cell_size", "materials",
                                   "bodies", "analysis.end_time"));
}

TEST(Validate, AllowsAsManyCellsAsTheirIndicesCanCount) {
  Scene scene = sample_scene();
  scene.domain.cell_size = 0.25;
  // 2^30 cells from -1 on, or one more.
  scene.domain.upper.x = scene.domain.lower.x + 0.25 * 0x1p30;
  EXPECT_THAT(paths_of(scene), testing::IsEmpty());
  scene.domain.upper.x += 0.25;
  EXPECT_THAT(paths_of(scene), testing::ElementsAre("domain.cell_size"));
  EXPECT_THAT(violations_of(scene).at(0).remedy, HasSubstr("2^30 cells"));
}

class OneMistake : public testing::TestWithParam<Mistake> {};

TEST_P(OneMistake, GivesItsOneViolation) { expect_violation(GetParam()); }

const std::vector<Mistake> head = {
    {"NoName", [](Scene& s) { s.name = ""; }, "name", "needs a name"},
    {"LongName", [](Scene& s) { s.name = std::string(65, 'a'); }, "name", "is not a valid name"},
    {"ConstantNamedLikeAVariable",
     [](Scene& s) {
       s.constants.push_back({"t", "1"});
     },
     "constants[4].name", "else"},
    {"ConstantNamedLikeAFunction",
     [](Scene& s) {
       s.constants.push_back({"exp", "1"});
     },
     "constants[4].name", "else"},
    {"ConstantStartingWithADigit",
     [](Scene& s) {
       s.constants.push_back({"2a", "1"});
     },
     "constants[4].name", "formulas"},
    {"ConstantWithAHyphen",
     [](Scene& s) {
       s.constants.push_back({"a-b", "1"});
     },
     "constants[4].name", "formulas"},
    {"ConstantGivenTwice",
     [](Scene& s) {
       s.constants.push_back({"E", "1"});
     },
     "constants[4].name", "earlier"},
    {"ConstantOfALaterOne",
     [](Scene& s) {
       s.constants.insert(s.constants.begin(), {"k", "2 * P"});
     },
     "constants[0].value", "\"P\""},
    {"ConstantOfAVariable",
     [](Scene& s) {
       s.constants.push_back({"k", "2 * x"});
     },
     "constants[4].value", "\"x\""},
    {"InfiniteConstant",
     [](Scene& s) {
       s.constants.push_back({"k", "1 / 0"});
     },
     "constants[4].value", "inf"},
    {"NoDimension", [](Scene& s) { s.domain.dimension = {}; }, "domain.dimension", "not given"},
    {"InvertedDomain", [](Scene& s) { s.domain.upper.x = -2; }, "domain.upper", "above"},
    {"InfiniteDomain", [](Scene& s) { s.domain.upper.x = infinity; }, "domain.upper.x", "finite"},
    {"DomainThatIsNotANumber", [](Scene& s) { s.domain.lower.y = not_a_number; }, "domain.lower.y", "finite"},
    {"NoCells", [](Scene& s) { s.domain.cell_size = 0; }, "domain.cell_size", "greater than 0"},
    {"TooManyCells", [](Scene& s) { s.domain.cell_size = 1e-12; }, "domain.cell_size", "cells along an axis"},
    {"CellLargerThanTheDomain", [](Scene& s) { s.domain.cell_size = 1e300; }, "domain.cell_size",
     "larger than the domain"},
    {"CoordinatesBeyondPrecision",
     [](Scene& s) {
       s.domain.lower = {1e12, 1e12}, s.domain.upper = {1e12 + 10, 1e12 + 10};
     },
     "domain.cell_size", "too small for coordinates"},
    {"NoThickness", [](Scene& s) { s.domain.thickness = 0; }, "domain.thickness", "greater than 0"},
};

const std::vector<Mistake> materials = {
    {"NoMaterialName", [](Scene& s) { s.materials.push_back(s.materials[0]), s.materials[1].name = ""; },
     "materials[1].name", "needed"},
    {"MaterialGivenTwice", [](Scene& s) { s.materials.push_back(s.materials[0]); }, "materials[1].name",
     "earlier"},
    {"NoDensity", [](Scene& s) { s.materials[0].density = 0; }, "materials[0].density", "greater than 0"},
    {"NoLaw", [](Scene& s) { s.materials[0].law = ""; }, "materials[0]", "no constitutive law"},
    {"UnknownLaw", [](Scene& s) { s.materials[0].law = "linear_elastik"; }, "materials[0]", "no constitutive law",
     "did you mean \"linear_elastic\"?"},
    {"MissingParameter", [](Scene& s) { s.materials[0].parameters.erase("youngs_modulus"); },
     "materials[0].linear_elastic.youngs_modulus", "not given"},
    {"UnknownParameter", [](Scene& s) { s.materials[0].parameters["poisson_ratio"] = 0.3; },
     "materials[0].linear_elastic.poisson_ratio", "no parameter", "did you mean \"poissons_ratio\"?"},
    {"LawThatSchemeDoesNotSuit", [](Scene& s) { s.materials[0].law = "linear_strain_elastic"; },
     "materials[0].linear_strain_elastic", "from the reference configuration", "numerics.scheme"},
    {"ParametersThatDoNotGoTogether",
     [](Scene& s) {
       s.materials[0].law = "mooney_rivlin";
       s.materials[0].parameters = {{"c1", 10}, {"c2", 10}, {"bulk_modulus", 50}};
     },
     "materials[0].mooney_rivlin", "bulk_modulus is less", "at least 66.6"},
    {"DamageOfWhatIsNotElastic",
     [](Scene& s) {
       s.materials[0].law = "von_mises";
       s.materials[0].parameters["yield_stress"] = 10;
       s.materials[0].damage = {{"compressive_strength", 10}, {"shape", 3}};
     },
     "materials[0].damage", "not elastic"},
    {"DamageWithoutShape",
     [](Scene& s) {
       s.materials[0].damage = {{"compressive_strength", 10}};
     },
     "materials[0].damage.shape", "not given"},
    {"DamageWithoutStrength",
     [](Scene& s) {
       s.materials[0].damage = {{"shape", 3}};
     },
     "materials[0].linear_elastic", "neither compressive_strength nor tensile_strength"},
    {"DamageOfNegativeShape",
     [](Scene& s) {
       s.materials[0].damage = {{"tensile_strength", 10}, {"shape", -3}};
     },
     "materials[0].damage.shape", "out of range"},
    {"DamageByAnUnknownParameter",
     [](Scene& s) {
       s.materials[0].damage = {{"tensile_strength", 10}, {"shape", 3}, {"sed", 1}};
     },
     "materials[0].damage.sed", "no parameter", "did you mean \"seed\"?"},
    {"PoresThatNothingCloses",
     [](Scene& s) {
       s.materials[0].damage = {{"tensile_strength", 10}, {"shape", 3}, {"open_stiffness", 0.5}};
     },
     "materials[0].linear_elastic", "one alone has no effect"},
    {"OrthotropicLawWithoutPositiveEnergy",
     [](Scene& s) {
       s.materials[0].law = "orthotropic_elastic";
       s.materials[0].parameters = {{"youngs_modulus_1", 1},    {"youngs_modulus_2", 4},  {"youngs_modulus_3", 4},
                                    {"poissons_ratio_12", 0.6}, {"poissons_ratio_23", 0}, {"poissons_ratio_31", 0},
                                    {"shear_modulus_12", 1},    {"shear_modulus_23", 1},  {"shear_modulus_31", 1}};
     },
     "materials[0].orthotropic_elastic", "no positive strain energy", "poissons_ratio_ij^2"},
    {"ParameterOutOfRange", [](Scene& s) { s.materials[0].parameters["youngs_modulus"] = -1; },
     "materials[0].linear_elastic.youngs_modulus", "out of range"},
    {"ParameterOnItsOpenBound", [](Scene& s) { s.materials[0].parameters["poissons_ratio"] = -1; },
     "materials[0].linear_elastic.poissons_ratio", "out of range"},
    {"ParameterThatIsNotANumber", [](Scene& s) { s.materials[0].parameters["poissons_ratio"] = not_a_number; },
     "materials[0].linear_elastic.poissons_ratio", "out of range"},
    {"InfiniteWaveSpeed",
     [](Scene& s) { s.materials[0].parameters["youngs_modulus"] = 1e299, s.materials[0].density = 1e-300; },
     "materials[0]", "wave speed"},
};

const std::vector<Mistake> numerics = {
    {"NoEnd", [](Scene& s) { s.analysis.end_time = 0; }, "analysis.end_time", "greater than 0"},
    {"EndTimeThatCannotBeDivided", [](Scene& s) { s.analysis.end_time = 5e-324; }, "analysis.end_time",
     "too short"},
    {"NegativeDamping", [](Scene& s) { s.analysis.damping = -1; }, "analysis.damping", "not negative"},
    {"SurfaceLoadsOnSplinesByUsl",
     [](Scene& s) {
       s.numerics.scheme = "USL";
       s.numerics.shape_functions = "cubic_bspline";
     },
     "numerics.scheme", "hardly any mass", "\"MUSL\""},
    {"UnknownScheme", [](Scene& s) { s.numerics.scheme = "tlmpn"; }, "numerics.scheme", "no scheme \"tlmpn\"",
     "did you mean \"TLMPM\"?"},
    {"UnknownShapeFunctions", [](Scene& s) { s.numerics.shape_functions = "cubic"; }, "numerics.shape_functions",
     "no shape function \"cubic\"", "the shape functions are: "},
    {"UnknownTransfer", [](Scene& s) { s.numerics.transfer = "XPIK"; }, "numerics.transfer",
     "no transfer \"XPIK\"", "did you mean \"XPIC\"?"},
    {"UnknownLockingRemedy", [](Scene& s) { s.numerics.locking_remedy = "mean_dilation"; },
     "numerics.locking_remedy", "no locking remedy \"mean_dilation\"", "did you mean \"mean_dilatation\"?"},
    {"LockingRemedyOfExplicitUpdatedSteps",
     [](Scene& s) {
       s.domain.dimension = Dimension::plane_strain;
       s.numerics.locking_remedy = "mean_dilatation";
     },
     "numerics.locking_remedy", "particles leave", "TLMPM"},
    {"LockingRemedyOfParticlesThatSeeOtherNodes",
     [](Scene& s) {
       s.domain.dimension = Dimension::plane_strain;
       s.analysis.kind = ImplicitDynamics{};
       s.numerics.locking_remedy = "mean_dilatation";
       s.numerics.shape_functions = "gimp";
     },
     "numerics.locking_remedy", "same nodes", "\"linear\""},
    {"LockingRemedyOfAFreeThickness",
     [](Scene& s) {
       s.domain.dimension = Dimension::plane_stress;
       s.analysis.kind = ImplicitDynamics{};
       s.numerics.locking_remedy = "mean_dilatation";
     },
     "numerics.locking_remedy", "nothing locks"},
    {"UnknownPrecision", [](Scene& s) { s.numerics.precision = "float"; }, "numerics.precision",
     "no precision \"float\"", "FLOAT"},
    {"ImplicitStepsWithFloats",
     [](Scene& s) {
       s.numerics.precision = "FLOAT";
       s.analysis.kind = QuasiStatic{};
       s.analysis.damping = 0;
       s.bodies[1].initial_velocity = {};
     },
     "numerics.precision", "need doubles"},
    {"TooLightForFloats",
     [](Scene& s) {
       s.numerics.precision = "FLOAT";
       s.materials[0].density = 1e-35;
     },
     "numerics.precision", "no floats", "units"},
    {"OrderOfNothing", [](Scene& s) { s.numerics.transfer_order = 3; }, "numerics.transfer_order",
     "have an order"},
    {"OrderZero",
     [](Scene& s) {
       s.numerics.transfer = "FMPM";
       s.numerics.transfer_order = 0;
     },
     "numerics.transfer_order", "out of range"},
    {"BlendOfNothing",
     [](Scene& s) {
       s.numerics.transfer = "XPIC";
       s.numerics.flip_fraction = 0.9;
     },
     "numerics.flip_fraction", "is a blend"},
    {"AffineByLinearFunctions", [](Scene& s) { s.numerics.transfer = "APIC"; }, "numerics.transfer",
     "linear functions"},
    {"TooMuchFlip", [](Scene& s) { s.numerics.flip_fraction = 1.01; }, "numerics.flip_fraction", "out of range"},
    {"NoFractionOfTheStep", [](Scene& s) { s.numerics.time_step_fraction = 0; }, "numerics.time_step_fraction",
     "out of range"},
    {"NegativeStep", [](Scene& s) { s.numerics.time_step = -1e-3; }, "numerics.time_step", "greater than 0"},
    {"StepBeyondTheStableLimit", [](Scene& s) { s.numerics.time_step = 1; }, "numerics.time_step", "stable limit"},
    {"TooManySteps", [](Scene& s) { s.analysis.end_time = 1e13, s.loads.clear(), s.measures.clear(); },
     "analysis.end_time", "steps"},
    {"NoThreads", [](Scene& s) { s.numerics.threads = 0; }, "numerics.threads", "out of range"},
};

INSTANTIATE_TEST_SUITE_P(Head, OneMistake, testing::ValuesIn(head), name_of);
INSTANTIATE_TEST_SUITE_P(Materials, OneMistake, testing::ValuesIn(materials), name_of);
INSTANTIATE_TEST_SUITE_P(Numerics, OneMistake, testing::ValuesIn(numerics), name_of);

}  // namespace
}  // namespace trajan
