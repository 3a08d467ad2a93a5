#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

class ContactMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ContactMistake, GivesItsOneViolation) { expect_violation(GetParam()); }

const std::vector<Mistake> contacts = {
    {"NegativeFriction",
     [](Scene& s) {
       s.contacts = {{{}, -0.1}};
     },
     "contacts[0].friction", "negative"},
    {"FrictionThatIsNoNumber",
     [](Scene& s) {
       s.contacts = {{{}, not_a_number}};
     },
     "contacts[0].friction", "finite"},
    {"UnknownBody",
     [](Scene& s) {
       s.contacts = {{}, {{"beam", "bal"}, 0}};
     },
     "contacts[1].bodies[1]", "no body \"bal\"", "ball"},
    {"BodyNamedTwice",
     [](Scene& s) {
       s.contacts = {{{"beam", "ball", "beam"}, 0}};
     },
     "contacts[0].bodies[2]", "twice"},
    {"OneBody",
     [](Scene& s) {
       s.contacts = {{{"beam"}, 0}};
     },
     "contacts[0].bodies", "itself"},
    {"TooManyContacts", [](Scene& s) { s.contacts.resize(1001); }, "contacts", "too long"},
    {"TotalLagrangianScheme",
     [](Scene& s) {
       s.contacts = {{}};
       s.numerics.scheme = "TLMPM";
     },
     "contacts", "total Lagrangian", "MUSL"},
};

INSTANTIATE_TEST_SUITE_P(Contacts, ContactMistake, testing::ValuesIn(contacts), name_of);

Scene four_bodies(std::vector<BodyContact> touching) {
  Scene scene = sample_scene();
  scene.loads.clear();
  scene.outputs.probes.clear();
  scene.measures.clear();
  scene.bodies.clear();
  for (const char* name : {"a", "b", "c", "d"})
    scene.bodies.push_back({name, "rubber", Box{{0, 0}, {1, 1}}, 2, {}});
  scene.contacts = std::move(touching);
  return scene;
}

TEST(ValidateContacts, OneFieldIsEnoughWhereNothingIsSeparate) {
  const Model model = validate(four_bodies({}));
  EXPECT_EQ(model.contacts.fields, 1u);
  EXPECT_TRUE(model.contacts.field_of.empty());
}

TEST(ValidateContacts, BodiesThatAreNotSeparateFromEachOtherShareAField) {
  const Model model = validate(four_bodies({{{"a", "c"}, 0.1}}));
  EXPECT_THAT(model.contacts.field_of, testing::ElementsAre(0, 1, 2, 1));
  EXPECT_EQ(model.contacts.between(0, 2), 0.1);
  EXPECT_EQ(model.contacts.between(2, 0), 0.1);
  EXPECT_EQ(model.contacts.between(0, 1), std::nullopt);
}

TEST(ValidateContacts, TheLaterOfTwoEntriesForAPairOfBodiesWins) {
  const Model model = validate(four_bodies({{{}, 0.1}, {{"b", "d"}, 0.2}}));
  EXPECT_THAT(model.contacts.field_of, testing::ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(model.contacts.between(0, 1), 0.1);
  EXPECT_EQ(model.contacts.between(1, 3), 0.2);
}

}  // namespace
}  // namespace trajan
