#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

using testing::ElementsAre;

TEST(ValidateMeasures, DeviationIsComparedWithZero) {
  Scene scene = sample_scene();
  scene.measures[0].kind = Deviation{"0.1 * sin(t)", 2};
  scene.measures[0].exact = "";
  EXPECT_EQ(validate(scene).measures[0].exact, 0);
}

TEST(ValidateMeasures, BrokenProbeIsNotReportedAgainWhereItIsMeasured) {
  Scene scene = sample_scene();
  scene.outputs.probes[0].fields = {Field::unspecified};
  scene.measures[1].quantity = "energies.kinetik";
  EXPECT_THAT(paths_of(scene), ElementsAre("outputs.probes[0].fields[0]", "measures[1].quantity"));
}

class OutputMistake : public testing::TestWithParam<Mistake> {};

TEST_P(OutputMistake, GivesItsOneViolation) { expect_violation(GetParam()); }

const std::vector<Mistake> outputs = {
    {"NoSamples", [](Scene& s) { s.outputs.samples = 0; }, "outputs.samples", "out of range"},
    {"NegativeSnapshots", [](Scene& s) { s.outputs.snapshots = -1; }, "outputs.snapshots", "out of range"},
    {"SnapshotsThatDoNotDivide", [](Scene& s) { s.outputs.snapshots = 30; }, "outputs.snapshots", "must divide"},
    {"UnknownSnapshotField", [](Scene& s) { s.outputs.snapshot_fields = {Field::unspecified}; },
     "outputs.snapshot_fields[0]", "not a field"},
    {"SnapshotFieldTwice",
     [](Scene& s) {
       s.outputs.snapshot_fields = {Field::stress, Field::stress};
     },
     "outputs.snapshot_fields[1]", "twice"},
    {"TooLargeHistories",
     [](Scene& s) {
       s.outputs.samples = 10'000'000;
       for (int i = 0; i < 30; ++i) {
         s.outputs.probes.push_back({std::string("p").append(std::to_string(i)), Vector{}, {Field::stress}, ""});
       }
     },
     "outputs.samples", "columns"},
    {"ProbeWithoutFields", [](Scene& s) { s.outputs.probes[1].fields.clear(); }, "outputs.probes[1].fields",
     "empty"},
    {"ProbeWithoutPlace", [](Scene& s) { s.outputs.probes[1].where = {}; }, "outputs.probes[1]", "no place"},
    {"ProbeOfNothing",
     [](Scene& s) {
       s.outputs.probes[1].where = Region{Box{{-1, -1}, {0, 0}}};
     },
     "outputs.probes[1].mean", "no particle"},
    {"ProbeOfAnotherBody",
     [](Scene& s) {
       s.outputs.probes[1].where = Region{Disc{{4, 1.5}, 0.2}};
     },
     "outputs.probes[1].mean", "no particle"},
    {"ExtremeOfNothing",
     [](Scene& s) {
       s.outputs.probes[1].where = Region{Box{{-1, -1}, {0, 0}}};
       s.outputs.probes[1].statistic = Statistic::largest;
     },
     "outputs.probes[1].largest", "no particle"},
    {"HistoryOfALawThatRemembersNothing", [](Scene& s) { s.outputs.probes[1].history = {"damage"}; },
     "outputs.probes[1].history[0]", "remember nothing"},
    {"SnapshotHistoryOfLawsThatRememberNothing", [](Scene& s) { s.outputs.snapshot_history = {"damage"}; },
     "outputs.snapshot_history[0]", "remember nothing"},
    {"ReactionOfNothing", [](Scene& s) { s.outputs.reactions = {"clap"}; }, "outputs.reactions[0]",
     "no boundary condition", "did you mean \"clamp\"?"},
    {"ReactionGivenTwice",
     [](Scene& s) {
       s.outputs.reactions = {"clamp", "shaker", "clamp"};
     },
     "outputs.reactions[2]", "twice"},
    {"ReactionOfAPeriod",
     [](Scene& s) {
       s.boundaries[1] = {"ring", {}, Periodic{Axis::x}};
       s.outputs.reactions = {"ring"};
     },
     "outputs.reactions[0]", "has no reaction"},
    {"ContactForceWithoutContact", [](Scene& s) { s.outputs.reactions = {"beam"}; }, "outputs.reactions[0]",
     "no contact is defined", "contacts"},
    {"ContactForceGivenTwice",
     [](Scene& s) {
       s.contacts = {{}};
       s.outputs.reactions = {"beam", "ball", "beam"};
     },
     "outputs.reactions[2]", "twice"},
    {"ContactForceOnOneOfTwoThatFeelContactAsOne",
     [](Scene& s) {
       s.bodies.push_back({"stop", "rubber", Box{{8, 0}, {8.5, 1}}, 2, {}});
       s.contacts = {{{"beam", "ball"}}, {{"stop", "ball"}}};
       s.outputs.reactions = {"beam"};
     },
     "outputs.reactions[0]", "feel contact as one"},
    {"ProbeAtInfinity",
     [](Scene& s) {
       s.outputs.probes[0].where = Vector{infinity, 0};
     },
     "outputs.probes[0].nearest.x", "finite"},
    {"ProbeOfAnUnknownBody", [](Scene& s) { s.outputs.probes[1].body = "beams"; }, "outputs.probes[1].body",
     "no body \"beams\"", "did you mean \"beam\"?"},
    {"ProbeNamedLikeTheEnergies", [](Scene& s) { s.outputs.probes[1].name = "energies"; },
     "outputs.probes[1].name", "other histories"},
    {"ProbeWithADot", [](Scene& s) { s.outputs.probes[1].name = "a.b"; }, "outputs.probes[1].name",
     "is not a valid name"},
    {"ProbeFieldTwice",
     [](Scene& s) {
       s.outputs.probes[1].fields = {Field::stress, Field::stress};
     },
     "outputs.probes[1].fields[1]", "twice"},
};

const std::vector<Mistake> measures = {
    {"SameName", [](Scene& s) { s.measures[1].name = "deflection"; }, "measures[1].name", "earlier"},
    {"UnknownQuantity", [](Scene& s) { s.measures[0].quantity = "tip.displacement.yy"; }, "measures[0].quantity",
     "no history \"tip.displacement.yy\"", "did you mean \"tip.displacement.y\"?"},
    {"NoKind", [](Scene& s) { s.measures[0].kind = {}; }, "measures[0]", "no way to measure"},
    {"NegativeFrom", [](Scene& s) { s.measures[0].from = -1; }, "measures[0].from", "not negative"},
    {"UntilAfterTheEnd", [](Scene& s) { s.measures[0].until = 11; }, "measures[0].until", "after the end"},
    {"NothingInBetween", [](Scene& s) { s.measures[0].from = 5.01, s.measures[0].until = 5.02; },
     "measures[0].from", "no sample"},
    {"TooFewForASpectrum", [](Scene& s) { s.measures[1].from = 9.5; }, "measures[1].from", "11 samples"},
    {"FrequencyAboveHalfTheRate",
     [](Scene& s) {
       s.measures[1].kind = DominantFrequency{0, 10.1};
     },
     "measures[1].dominant_frequency.highest", "half the sampling rate"},
    {"EmptyRangeOfFrequencies",
     [](Scene& s) {
       s.measures[1].kind = DominantFrequency{2, 2};
     },
     "measures[1].dominant_frequency.lowest", "not below"},
    {"NoExactHistory",
     [](Scene& s) {
       s.measures[0].kind = Deviation{"", 1};
     },
     "measures[0].deviation.exact_history", "empty"},
    {"NoScale",
     [](Scene& s) {
       s.measures[0].kind = Deviation{"t", 0};
     },
     "measures[0].deviation.scale", "greater than 0"},
    {"ExactOfTime", [](Scene& s) { s.measures[0].exact = "t"; }, "measures[0].exact", "\"t\""},
    {"NoTolerance", [](Scene& s) { s.measures[0].tolerance = 0; }, "measures[0].tolerance", "greater than 0"},
    {"ToleranceOfNothing", [](Scene& s) { s.measures[0].exact = ""; }, "measures[0].tolerance",
     "nothing to compare with"},
};

INSTANTIATE_TEST_SUITE_P(Outputs, OutputMistake, testing::ValuesIn(outputs), name_of);
INSTANTIATE_TEST_SUITE_P(Measures, OutputMistake, testing::ValuesIn(measures), name_of);

}  // namespace
}  // namespace trajan
