#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

using testing::ElementsAre;

EdgeTraction& traction(Scene& scene) { return std::get<EdgeTraction>(scene.loads[0].kind); }
BodyForce& gravity(Scene& scene) { return std::get<BodyForce>(scene.loads[1].kind); }
PointForce& push(Scene& scene) { return std::get<PointForce>(scene.loads[2].kind); }

/// The sample scene, periodic along x, along which it has 40 cells.
Scene with_period(Scene scene) {
  scene.boundaries[1] = {"ring", {}, Periodic{Axis::x}};
  return scene;
}

/// The same scene in equilibrium.
Scene at_rest(Scene scene) {
  scene.analysis.kind = QuasiStatic{};
  scene.analysis.damping = 0;
  scene.bodies[1].initial_velocity = {};
  return scene;
}

TEST(ValidateBodies, MayOverlap) {
  Scene scene = sample_scene();
  scene.bodies[1].geometry = Disc{{4, 0.5}, 0.4};
  EXPECT_THAT(paths_of(scene), ElementsAre());
}

TEST(ValidateBodies, MayTouchTheEdgesOfTheDomain) {
  Scene scene = sample_scene();
  scene.domain.lower = {0, 0};
  scene.domain.upper = {8, 2};
  scene.boundaries.pop_back();
  EXPECT_THAT(paths_of(scene), ElementsAre());
}

TEST(ValidateBodies, OneMistakeIsNotReportedAgainWhereTheBodyIsUsed) {
  Scene scene = sample_scene();
  scene.bodies[0].geometry = Box{{0, 0}, {8, -1}};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].geometry.box.upper"));
}

TEST(ValidateLoads, PointForceMayActOneParticleSpacingOutside) {
  Scene scene = sample_scene();
  push(scene).position = {8.125, 0.5};
  EXPECT_THAT(paths_of(scene), ElementsAre());
}

class BodyMistake : public testing::TestWithParam<Mistake> {};

TEST_P(BodyMistake, GivesItsOneViolation) { expect_violation(GetParam()); }

const std::vector<Mistake> bodies = {
    {"GivenTwice", [](Scene& s) { s.bodies[1].name = "beam"; }, "bodies[1].name", "earlier"},
    {"NameWithADot", [](Scene& s) { s.bodies[1].name = "the.ball"; }, "bodies[1].name", "is not a valid name"},
    {"NoMaterial", [](Scene& s) { s.bodies[1].material = ""; }, "bodies[1].material", "no material is named"},
    {"NoGeometry", [](Scene& s) { s.bodies[1].geometry = {}; }, "bodies[1].geometry", "no shape"},
    {"FlatBox",
     [](Scene& s) {
       s.bodies[1].geometry = Box{{1, 1}, {2, 1}};
     },
     "bodies[1].geometry.box.upper", "above"},
    {"InfiniteCentre",
     [](Scene& s) {
       s.bodies[1].geometry = Disc{{4, infinity}, 1};
     },
     "bodies[1].geometry.disc.centre.y", "finite"},
    {"NoRadius",
     [](Scene& s) {
       s.bodies[1].geometry = Disc{{4, 1}, 0};
     },
     "bodies[1].geometry.disc.radius", "greater than 0"},
    {"OutsideTheDomain",
     [](Scene& s) {
       s.bodies[1].geometry = Disc{{4, 1.5}, 0.6};
     },
     "bodies[1].geometry", "out of the domain"},
    {"NoParticle",
     [](Scene& s) {
       s.bodies[1].geometry = Disc{{4, 1.5}, 0.01};
     },
     "bodies[1].geometry", "no particle"},
    {"NoParticlesPerCell", [](Scene& s) { s.bodies[1].particles_per_cell_side = 0; },
     "bodies[1].particles_per_cell_side", "out of range"},
    {"VelocityOfTime", [](Scene& s) { s.bodies[1].initial_velocity.x = "t"; }, "bodies[1].initial_velocity.x",
     "\"t\""},
    {"InfiniteVelocity", [](Scene& s) { s.bodies[1].initial_velocity.y = "1 / 0"; },
     "bodies[1].initial_velocity.y", "inf"},
    {"BodyMuchThinnerThanACell",
     [](Scene& s) {
       s.bodies.resize(1);
       s.bodies[0].geometry = Box{{0, 0}, {1, 1e-200}};
       s.loads.clear(), s.outputs.probes[1].where = Vector{};
     },
     "bodies[0].geometry", "along y the body is thinner"},
    {"VolumeThatUnderflows",
     [](Scene& s) {
       s.domain.lower = {}, s.domain.upper = {4e-200, 4e-200}, s.domain.cell_size = 1e-200;
       s.bodies.resize(1), s.bodies[0].geometry = Box{{}, s.domain.upper};
       s.boundaries.clear(), s.loads.clear(), s.outputs.probes.clear(), s.measures.clear();
     },
     "bodies[0].geometry", "finite volume"},
};

Hinge hinge(const std::string& body, HingeKind kind, const Region& within) {
  Hinge hinge;
  hinge.surface.body = body;
  hinge.surface.part = Edge::left;
  hinge.surface.within = within;
  hinge.kind = kind;
  return hinge;
}

Pressure pressure(const std::string& body, decltype(Surface::part) part) {
  Pressure pressure;
  pressure.surface.body = body;
  pressure.surface.part = part;
  pressure.pressure = 1;
  return pressure;
}

const std::vector<Mistake> boundaries = {
    {"NoRegion", [](Scene& s) { s.boundaries[0].nodes = {}; }, "boundaries[0].nodes", "no shape"},
    {"BoxBetweenNodes",
     [](Scene& s) {
       s.boundaries[0].nodes = Box{{0.1, 0}, {0.2, 1}};
     },
     "boundaries[0].nodes", "no node"},
    {"DiscBetweenNodes",
     [](Scene& s) {
       s.boundaries[0].nodes = Disc{{0.125, 0.125}, 0.17};
     },
     "boundaries[0].nodes", "no node"},
    {"DiscBesideTheGrid",
     [](Scene& s) {
       s.boundaries[0].nodes = Disc{{-2, -2}, 1.4};
     },
     "boundaries[0].nodes", "no node"},
    {"InvertedBox",
     [](Scene& s) {
       s.boundaries[0].nodes = Box{{0, 1}, {0, 0}};
     },
     "boundaries[0].nodes.box.upper", "above"},
    {"NoCondition", [](Scene& s) { s.boundaries[0].condition = {}; }, "boundaries[0]", "no condition"},
    {"NoAxis",
     [](Scene& s) {
       s.boundaries[0].condition = Fixed{{Axis::x, Axis::unspecified}};
     },
     "boundaries[0].fixed.axes[1]", "not an axis"},
    {"NoComponent", [](Scene& s) { s.boundaries[0].condition = PrescribedVelocity{}; },
     "boundaries[0].prescribed_velocity.velocity", "no component"},
    {"VelocityOfAnAxisThatThereIsNot",
     [](Scene& s) {
       s.boundaries[0].condition = PrescribedVelocity{{"z", "t"}};
     },
     "boundaries[0].prescribed_velocity.velocity.x", "\"z\""},
    {"InfiniteAtTheEnd",
     [](Scene& s) {
       s.boundaries[0].condition = PrescribedVelocity{{"1 / (10 - t)", "t"}};
     },
     "boundaries[0].prescribed_velocity.velocity.x", "t = 10"},
    {"InfiniteInBetween",
     [](Scene& s) {
       s.boundaries[0].condition = PrescribedVelocity{{"1 / (t - 5)", "t"}};
     },
     "boundaries[0].prescribed_velocity.velocity.x", "t = 5"},
    {"RollerWithoutNormal", [](Scene& s) { s.boundaries[0].condition = Roller{}; }, "boundaries[0].roller.normal",
     "not an axis"},
    {"RollerAcrossItsFace",
     [](Scene& s) {
       s.boundaries[0].nodes = Edge::left;
       s.boundaries[0].condition = Roller{Axis::y};
     },
     "boundaries[0].roller.normal", "not normal"},
    {"FaceThatAPlaneLacks", [](Scene& s) { s.boundaries[0].nodes = Edge::back; }, "boundaries[0].face",
     "no z axis"},
    {"SymmetryOfARegion", [](Scene& s) { s.boundaries[0].condition = Symmetry{Edge::left}; },
     "boundaries[0].nodes", "says itself"},
    {"SymmetryWithoutFace",
     [](Scene& s) {
       s.boundaries[0] = {"sides", {}, Symmetry{}};
     },
     "boundaries[0].symmetry.face", "not given"},
    {"DisplacementWithoutComponents", [](Scene& s) { s.boundaries[0].condition = PrescribedDisplacement{}; },
     "boundaries[0].prescribed_displacement.displacement", "no component"},
    {"PlaneWithoutNormal",
     [](Scene& s) {
       s.boundaries[0] = {"floor", {}, RigidPlane{{0, 0}, {0, 0}, {}}};
     },
     "boundaries[0].rigid_plane.normal", "no direction"},
    {"NegativeFriction",
     [](Scene& s) {
       s.boundaries[0] = {"floor", {}, RigidPlane{{0, 0}, {0, 1}, {-0.1, false, false, {}}}};
     },
     "boundaries[0].rigid_plane.contact.friction", "negative"},
    {"FrictionOfWhatIsHeld",
     [](Scene& s) {
       s.boundaries[0] = {"floor", {}, RigidPlane{{0, 0}, {0, 1}, {0.1, false, true, {}}}};
     },
     "boundaries[0].rigid_plane.contact.friction", "pushed and pulled", "no_separation"},
    {"BallWithoutRadius",
     [](Scene& s) {
       s.boundaries[0] = {"ball", {}, RigidBall{{0, 0}, 0, {}}};
     },
     "boundaries[0].rigid_ball.radius", "greater than 0"},
    {"PlaneThatATotalLagrangianBodyWouldMeetLater",
     [](Scene& s) {
       s.numerics.scheme = "TLMPM";
       s.boundaries[1] = {"floor", {}, RigidPlane{{0, -0.5}, {0, 1}, {}}};
     },
     "boundaries[1]", "what meets it later", "MUSL"},
    {"HingeOfNoKind",
     [](Scene& s) {
       s.boundaries[0] = {"pin", {}, hinge("beam", HingeKind::unspecified, {})};
     },
     "boundaries[0].hinge.kind", "not given"},
    {"HingeOnADisc",
     [](Scene& s) {
       s.boundaries[0] = {"pin", {}, hinge("ball", HingeKind::mean, {})};
     },
     "boundaries[0].hinge.surface.body", "no straight edges"},
    {"HingeOnNothing",
     [](Scene& s) {
       s.boundaries[0] = {"pin", {}, hinge("beam", HingeKind::mean, Box{{1, 0}, {2, 1}})};
     },
     "boundaries[0].hinge.surface.within", "catches nothing"},
    {"AbsorbingRim",
     [](Scene& s) {
       s.boundaries[0] = {"quiet", {}, Absorbing{pressure("ball", Disc{{4, 1.5}, 0.4}).surface}};
     },
     "boundaries[0].absorbing.surface.rim", "straight edge"},
    {"PeriodOfNoAxis",
     [](Scene& s) {
       s.boundaries[1] = {"ring", {}, Periodic{}};
     },
     "boundaries[1].periodic.axis", "not an axis"},
    {"PeriodOfAMissingAxis",
     [](Scene& s) {
       s.boundaries[1] = {"ring", {}, Periodic{Axis::z}};
     },
     "boundaries[1].periodic.axis", "no z axis"},
    {"PeriodOfPartsOfCells",
     [](Scene& s) {
       s.boundaries[1] = {"ring", {}, Periodic{Axis::y}};
       s.domain.upper.y = 2.1;
     },
     "domain.upper.y", "a whole number of cells", "(12 cells)"},
    {"PeriodGivenTwice",
     [](Scene& s) {
       s = with_period(s);
       s.boundaries.push_back({"again", {}, Periodic{Axis::x}});
     },
     "boundaries[2].periodic.axis", "already"},
    {"PeriodWithAFace",
     [](Scene& s) {
       s = with_period(s);
       s.boundaries[0].nodes = Edge::right;
     },
     "boundaries[0].face", "has no face"},
    {"PeriodWithSymmetry",
     [](Scene& s) {
       s = with_period(s);
       s.boundaries[0] = {"mirror", {}, Symmetry{Edge::left}};
     },
     "boundaries[0].symmetry.face", "has no face"},
    {"PeriodWithAPlaneAcrossIt",
     [](Scene& s) {
       s = with_period(s);
       s.boundaries[0] = {"wall", {}, RigidPlane{{0, 0}, {1, 1}, {}}};
     },
     "boundaries[0].rigid_plane.normal.x", "no half-space"},
    {"PeriodOfAnAnalysisWithoutExplicitSteps", [](Scene& s) { s = at_rest(with_period(s)); },
     "boundaries[1].periodic", "solve for displacements"},
    {"ReactionsOfModes",
     [](Scene& s) {
       s = at_rest(s);
       s.analysis.kind = Modal{};
       s.outputs.reactions = {"clamp"};
     },
     "outputs.reactions", "modes have no forces"},
    {"SameName", [](Scene& s) { s.boundaries[1].name = "clamp"; }, "boundaries[1].name", "earlier"},
};

const std::vector<Mistake> loads = {
    {"NoKind", [](Scene& s) { s.loads[0].kind = {}; }, "loads[0]", "no kind"},
    {"UnknownBody", [](Scene& s) { traction(s).body = "baem"; }, "loads[0].edge_traction.body", "no body"},
    {"TractionOnADisc", [](Scene& s) { traction(s).body = "ball"; }, "loads[0].edge_traction.body",
     "no straight edges"},
    {"NoEdge", [](Scene& s) { traction(s).edge = {}; }, "loads[0].edge_traction.edge", "not given"},
    {"InfiniteTraction", [](Scene& s) { traction(s).traction.x = infinity; }, "loads[0].edge_traction.traction.x",
     "finite"},
    {"ProfileOfTime", [](Scene& s) { traction(s).profile = "t"; }, "loads[0].edge_traction.profile", "\"t\""},
    {"ProfileWithAPole", [](Scene& s) { traction(s).profile = "sqrt(0.5 - y)"; }, "loads[0].edge_traction.profile",
     "not finite at (8, "},
    {"PressureOnNoPart", [](Scene& s) { s.loads[0].kind = pressure("beam", {}); }, "loads[0].pressure.surface",
     "no part"},
    {"PressureOnAForeignRim",
     [](Scene& s) {
       s.loads[0].kind = pressure("ball", Disc{{4, 1.5}, 0.2});
     },
     "loads[0].pressure.surface.rim", "no part of the body's surface"},
    {"TractionOnNothing",
     [](Scene& s) {
       traction(s).within = Box{{0, 0}, {1, 1}};
     },
     "loads[0].edge_traction.within", "catches nothing"},
    {"UnknownBodyOfAForce",
     [](Scene& s) {
       gravity(s).bodies = {"beam", "bal"};
     },
     "loads[1].body_force.bodies[1]", "no body \"bal\"", "did you mean \"ball\"?"},
    {"BodyNamedTwice",
     [](Scene& s) {
       gravity(s).bodies = {"beam", "beam"};
     },
     "loads[1].body_force.bodies[1]", "twice"},
    {"InfiniteAcceleration", [](Scene& s) { gravity(s).acceleration.y = -infinity; },
     "loads[1].body_force.acceleration.y", "finite"},
    {"PointFarFromItsBody",
     [](Scene& s) {
       push(s).position = {8.13, 0.5};
     },
     "loads[2].point_force.position", "outside of body \"beam\""},
    {"PointThatIsNotANumber", [](Scene& s) { push(s).position.x = not_a_number; },
     "loads[2].point_force.position.x", "finite"},
    {"InfiniteForce", [](Scene& s) { push(s).force.x = infinity; }, "loads[2].point_force.force.x", "finite"},
    {"InfiniteConstant", [](Scene& s) { s.loads[0].time = infinity; }, "loads[0].time.constant", "finite"},
    {"NoRampDuration",
     [](Scene& s) {
       s.loads[0].time = Ramp{0, 0, false};
     },
     "loads[0].time.ramp.duration", "greater than 0"},
    {"NoFrequency",
     [](Scene& s) {
       s.loads[0].time = Sine{0, 0};
     },
     "loads[0].time.sine.frequency", "greater than 0"},
    {"EmptyTable", [](Scene& s) { s.loads[0].time = Table{}; }, "loads[0].time.table.times", "empty"},
    {"UnevenTable",
     [](Scene& s) {
       s.loads[0].time = Table{{0, 1}, {1}};
     },
     "loads[0].time.table.values", "as many values as times"},
    {"UnorderedTable",
     [](Scene& s) {
       s.loads[0].time = Table{{0, 1, 1}, {1, 2, 3}};
     },
     "loads[0].time.table.times[2]", "not after"},
    {"InfiniteTable",
     [](Scene& s) {
       s.loads[0].time = Table{{0, 1}, {1, infinity}};
     },
     "loads[0].time.table.values[1]", "finite"},
    {"TimeExpressionOfPlace", [](Scene& s) { s.loads[0].time = "y"; }, "loads[0].time.expression", "\"y\""},
    {"SameName", [](Scene& s) { s.loads[1].name = "push"; }, "loads[2].name", "earlier"},
};

INSTANTIATE_TEST_SUITE_P(Bodies, BodyMistake, testing::ValuesIn(bodies), name_of);
INSTANTIATE_TEST_SUITE_P(Boundaries, BodyMistake, testing::ValuesIn(boundaries), name_of);
INSTANTIATE_TEST_SUITE_P(Loads, BodyMistake, testing::ValuesIn(loads), name_of);

}  // namespace
}  // namespace trajan
