#include "client/field_change.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "client/exit_code.h"
#include "client/scene_text.h"

namespace trajan::client {
namespace {

using ::testing::HasSubstr;

v1::Scene beam() {
  v1::Scene scene;
  google::protobuf::TextFormat::ParseFromString(
      R"(name: "beam" constants { name: "L" value: "8" } constants { name: "E.1" value: "3" }
         domain { dimension: PLANE_STRESS cell_size: 0.5 } bodies { name: "left" } bodies { name: "right" }
         analysis { end_time: 1 relaxation {} } outputs { snapshot_fields: STRESS snapshot_fields: VELOCITY })",
      &scene);
  return scene;
}

TEST(FieldChange, SetsNumbersWordsAndTexts) {
  v1::Scene scene = beam();
  EXPECT_EQ(change_field(scene, "domain.cell_size=1e-1"), "domain.cell_size");
  change_field(scene, "domain.dimension=PLANE_STRAIN");
  change_field(scene, "numerics.scheme=USL");
  change_field(scene, "description=\"a \\\"quoted\\\" = text\"");
  EXPECT_EQ(scene.domain().cell_size(), 0.1);
  EXPECT_EQ(scene.domain().dimension(), v1::Domain::PLANE_STRAIN);
  EXPECT_EQ(scene.numerics().scheme(), "USL");
  EXPECT_EQ(scene.description(), "a \"quoted\" = text");
}

TEST(FieldChange, FindsElementsByNumberAndByName) {
  v1::Scene scene = beam();
  EXPECT_EQ(change_field(scene, "bodies[1].material=soft"), "bodies[1].material");
  EXPECT_EQ(change_field(scene, "constants[E.1].value=2 * L"), "constants[1].value");
  EXPECT_EQ(scene.bodies(1).material(), "soft");
  EXPECT_EQ(scene.constants(1).value(), "2 * L");
}

TEST(FieldChange, ReplacesMessagesAndLists) {
  v1::Scene scene = beam();
  change_field(scene, "analysis.quasi_static.load_steps=4");
  EXPECT_TRUE(scene.analysis().has_quasi_static()) << "the kind of analysis is the one whose field is set";
  EXPECT_EQ(scene.analysis().end_time(), 1) << "the rest stays";
  change_field(scene, "analysis={end_time: 2}");
  EXPECT_FALSE(scene.analysis().has_quasi_static());
  change_field(scene, "outputs.snapshot_fields=[DISPLACEMENT]");
  EXPECT_THAT(scene.outputs().snapshot_fields(), ::testing::ElementsAre(v1::DISPLACEMENT));
  change_field(scene, "bodies[left]={name: \"middle\"}");
  EXPECT_EQ(scene.bodies(0).name(), "middle");
}

struct Wrong {
  const char* change;
  const char* problem;
  const char* hint;
};

class WrongChange : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongChange, IsExplained) {
  v1::Scene scene = beam();
  try {
    change_field(scene, GetParam().change);
    FAIL() << scene.DebugString();
  } catch (const CommandError& error) {
    EXPECT_EQ(error.code, ExitCode::usage);
    EXPECT_THAT(error.what(), HasSubstr(GetParam().problem));
    EXPECT_THAT(error.hint, HasSubstr(GetParam().hint));
  }
}

INSTANTIATE_TEST_SUITE_P(
    , WrongChange,
    ::testing::Values(Wrong{"domain.cell_size", "not PATH=VALUE", "as in"}, Wrong{"=3", "not PATH=VALUE", "as in"},
                      Wrong{"domain.celsize=3", "no field \"celsize\" in domain", "\"cell_size\""},
                      Wrong{"domian.cell_size=3", "no field \"domian\" in a scene", "\"domain\""},
                      Wrong{"domain.cell_size.x=3", "has no fields", "single value"},
                      Wrong{"bodies.material=soft", "bodies is a list", "bodies[0]"},
                      Wrong{"bodies[2].material=soft", "has 2 elements", ""},
                      Wrong{"bodies[rihgt].material=soft", "no element of bodies", "\"right\""},
                      Wrong{"domain[0].cell_size=3", "not a list", "brackets"},
                      Wrong{"bodies[0.material=soft", "brackets", "as in"},
                      Wrong{"bodies[0]x.material=soft", "brackets", "as in"},
                      Wrong{"domain.cell_size=small", "--set", "as in a scene file"},
                      Wrong{"domain.dimension=PLANE", "PLANE", "as in a scene file"}));

TEST(SceneText, ShowsNoPlaceForWhatTheCommandLineSaid) {
  SceneText text("domain {\n  cell_size: 0.5\n}\n", SceneFormat::text);
  text.change("domain.cell_size=-1");
  v1::Violation violation;
  violation.set_path("domain.cell_size");
  violation.set_problem("is negative");
  EXPECT_EQ(text.locate(violation).position.line, 0);
  EXPECT_EQ(text.scene().domain().cell_size(), -1);
}

}  // namespace
}  // namespace trajan::client
