#include "server/convert.h"

#include <gmock/gmock.h>

#include "tests/unit/server/every_field.h"
#include "tests/unit/server/scene_schema.h"

namespace trajan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

TEST_F(EveryField, UsesTheWholeSchema) {
  std::set<std::string> missing = testing::schema_of(*v1::Scene::descriptor());
  for (const std::string& name : testing::used_by(message_)) missing.erase(name);
  // Laws are translated by reflection: what is done for one is done for all.
  const auto* laws = v1::Material::descriptor()->FindOneofByName("law");
  for (int i = 0; i < laws->field_count(); ++i) {
    missing.erase(laws->field(i)->full_name());
    const auto* law = laws->field(i)->message_type();
    for (int p = 0; p < law->field_count(); ++p) missing.erase(law->field(p)->full_name());
  }
  // A scene has one analysis, each of which is another test's.
  for (const std::string& name : testing::schema_of(*v1::Analysis::descriptor())) missing.erase(name);
  // A scene has one dimension; what is unspecified is another test's.
  EXPECT_THAT(missing, ElementsAre("trajan.v1.Domain.AXISYMMETRIC", "trajan.v1.Domain.BAR",
                                   "trajan.v1.Domain.DIMENSION_UNSPECIFIED", "trajan.v1.Domain.PLANE_STRESS",
                                   "trajan.v1.Domain.SOLID"));
}

TEST_F(EveryField, KeepsNamesConstantsAndDomain) {
  EXPECT_EQ(scene_.name, "every-field");
  EXPECT_EQ(scene_.description, "a description");
  EXPECT_EQ(scene_.units, "m, s, kg");
  ASSERT_EQ(scene_.constants.size(), 2u);
  EXPECT_EQ(scene_.constants[0].name, "E");
  EXPECT_EQ(scene_.constants[0].value, "2e3");
  EXPECT_EQ(scene_.constants[1].name, "c");
  EXPECT_EQ(scene_.domain.dimension, Dimension::plane_strain);
  expect_vector(scene_.domain.lower, -1.5, -2.5, -3.5);
  expect_vector(scene_.domain.upper, 3.5, 4.5, 5.5);
  EXPECT_EQ(scene_.domain.cell_size, 0.125);
  EXPECT_EQ(scene_.domain.thickness, 0.75);
  EXPECT_EQ(scene_.domain.cross_section, 0.76);
}

TEST_F(EveryField, KeepsMaterials) {
  ASSERT_EQ(scene_.materials.size(), 2u);
  EXPECT_EQ(scene_.materials[0].name, "rate");
  EXPECT_EQ(scene_.materials[0].density, 1001);
  EXPECT_EQ(scene_.materials[0].law, "linear_elastic");
  EXPECT_THAT(scene_.materials[0].parameters,
              ElementsAre(Pair("poissons_ratio", 0.31), Pair("youngs_modulus", 1002)));
  EXPECT_EQ(scene_.materials[1].law, "neo_hookean");
  ASSERT_TRUE(scene_.materials[1].damage);
  EXPECT_THAT(*scene_.materials[1].damage,
              UnorderedElementsAre(Pair("compressive_strength", 1005), Pair("tensile_strength", 1006),
                                   Pair("shape", 1007), Pair("closure_stress", 1008), Pair("open_stiffness", 0.33),
                                   Pair("scatter_shape", 1009), Pair("seed", 1010)));
  EXPECT_FALSE(scene_.materials[0].damage);
  EXPECT_THAT(scene_.materials[1].parameters,
              ElementsAre(Pair("poissons_ratio", 0.32), Pair("youngs_modulus", 1004)));
}

TEST_F(EveryField, KeepsBodies) {
  ASSERT_EQ(scene_.bodies.size(), 3u);
  EXPECT_EQ(scene_.bodies[0].name, "beam");
  EXPECT_EQ(scene_.bodies[0].material, "rate");
  expect_box(scene_.bodies[0].geometry, 5.1, 5.2, 5.3, 5.4);
  EXPECT_EQ(scene_.bodies[0].particles_per_cell_side, 3);
  EXPECT_EQ(scene_.bodies[0].particle_layout, ParticleLayout::gauss);
  EXPECT_EQ(scene_.bodies[1].particle_layout, ParticleLayout::uniform);
  EXPECT_EQ(scene_.bodies[2].particle_layout, ParticleLayout::uniform) << "the default";
  EXPECT_EQ(scene_.bodies[0].initial_velocity.x, "1*x");
  EXPECT_EQ(scene_.bodies[0].initial_velocity.y, "2*y");
  expect_disc(scene_.bodies[1].geometry, 6.1, 6.2, 6.3);
}

TEST_F(EveryField, KeepsInitialStates) {
  const BodyDefinition& beam = scene_.bodies[0];
  EXPECT_EQ(beam.initial_velocity.z, "3*z");
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(beam.initial_stress.components[i], std::to_string(21 + i)) << symmetric_tensor_names[i];
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_EQ(beam.initial_deformation.components[i], std::to_string(31 + i)) << tensor_names[i];
  EXPECT_EQ(scene_.bodies[1].initial_stress.components[0], std::nullopt);
}

TEST_F(EveryField, KeepsShapesAndSets) {
  const auto& parts = std::get<Union>(scene_.bodies[2].geometry).regions;
  ASSERT_EQ(parts.size(), 5u);
  const auto& sphere = std::get<Sphere>(parts[0].region);
  expect_vector(sphere.centre, 20.1, 20.2, 20.3);
  EXPECT_EQ(sphere.radius, 20.4);
  const auto& cylinder = std::get<Cylinder>(parts[1].region);
  expect_vector(cylinder.from, 21.1, 21.2, 21.3);
  expect_vector(cylinder.to, 21.4, 21.5, 21.6);
  EXPECT_EQ(cylinder.radius, 21.7);
  const auto& polygon = std::get<Polygon>(parts[2].region);
  ASSERT_EQ(polygon.corners.size(), 3u);
  expect_vector(polygon.corners[2], 22.5, 22.6);
  EXPECT_EQ(std::get<Mesh>(parts[3].region).stl, "solid part");
  const auto& common = std::get<Intersection>(parts[4].region).regions;
  ASSERT_EQ(common.size(), 2u);
  EXPECT_EQ(std::get<Disc>(common[1].region).radius, 23.3);
  const auto& ring = std::get<Difference>(common[0].region).regions;
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_EQ(std::get<Disc>(ring[0].region).radius, 23.1);
  EXPECT_EQ(std::get<Disc>(ring[1].region).radius, 23.2);
}

TEST_F(EveryField, KeepsTimeFunctions) {
  EXPECT_EQ(std::get<double>(scene_.loads[0].time), 9.5);
  const auto& ramp = std::get<Ramp>(scene_.loads[1].time);
  EXPECT_EQ(ramp.start, 10.3);
  EXPECT_EQ(ramp.duration, 10.4);
  EXPECT_TRUE(ramp.smooth);
  const auto& sine = std::get<Sine>(scene_.loads[2].time);
  EXPECT_EQ(sine.frequency, 11.1);
  EXPECT_EQ(sine.phase, 11.2);
  const auto& table = std::get<Table>(scene_.loads[3].time);
  EXPECT_THAT(table.times, ElementsAre(12.1, 12.2, 12.3));
  EXPECT_THAT(table.values, ElementsAre(12.4, 12.5));
  EXPECT_EQ(std::get<std::string>(scene_.loads[4].time), "6*t");
  EXPECT_EQ(std::get<double>(scene_.loads[5].time), 1.0) << "the default";
}

TEST_F(EveryField, KeepsAnalysisAndNumerics) {
  EXPECT_EQ(scene_.analysis.end_time, 14.1);
  EXPECT_EQ(scene_.analysis.damping, 14.2);
  EXPECT_EQ(scene_.numerics.scheme, "TLMPM");
  EXPECT_EQ(scene_.numerics.shape_functions, "cubic");
  EXPECT_EQ(scene_.numerics.flip_fraction, 0.91);
  EXPECT_EQ(scene_.numerics.time_step_fraction, 0.92);
  EXPECT_EQ(scene_.numerics.time_step, 0.93);
  EXPECT_EQ(scene_.numerics.threads, 7);
  EXPECT_EQ(scene_.numerics.transfer, "XPIC");
  EXPECT_EQ(scene_.numerics.transfer_order, 5);
  EXPECT_EQ(scene_.numerics.locking_remedy, "mean_dilatation");
  EXPECT_EQ(scene_.numerics.precision, "FLOAT");
}

TEST_F(EveryField, KeepsContacts) {
  ASSERT_EQ(scene_.contacts.size(), 1u);
  EXPECT_THAT(scene_.contacts[0].bodies, ElementsAre("beam", "ball"));
  EXPECT_EQ(scene_.contacts[0].friction, 37.1);
}

TEST_F(EveryField, KeepsOutputs) {
  EXPECT_EQ(scene_.outputs.samples, 300);
  EXPECT_EQ(scene_.outputs.snapshots, 30);
  EXPECT_THAT(scene_.outputs.snapshot_fields, ElementsAre(Field::velocity, Field::unspecified));
  EXPECT_THAT(scene_.outputs.reactions, ElementsAre("clamp", "pin"));
  ASSERT_EQ(scene_.outputs.probes.size(), 4u);
  const ProbeDefinition& tip = scene_.outputs.probes[0];
  EXPECT_EQ(tip.name, "tip");
  EXPECT_EQ(tip.body, "beam");
  expect_vector(std::get<Vector>(tip.where), 15.1, 15.2);
  EXPECT_THAT(tip.fields, ElementsAre(Field::position, Field::displacement));
  expect_box(std::get<Region>(scene_.outputs.probes[1].where), 16.1, 16.2, 16.3, 16.4);
  EXPECT_THAT(scene_.outputs.probes[1].fields, ElementsAre(Field::stress));
}

TEST(ConvertScene, KeepsEveryFieldAndStatisticOfOutputs) {
  const Scene scene =
      to_scene(parse("outputs { snapshot_fields: [STRAIN, DEFORMATION_GRADIENT, PRESSURE, VON_MISES_STRESS]"
                     "  snapshot_history: \"damage\""
                     "  probes { largest {} history: \"temperature\" } probes { smallest { box {} } } }"));
  EXPECT_THAT(scene.outputs.snapshot_fields,
              ElementsAre(Field::strain, Field::deformation_gradient, Field::pressure, Field::von_mises_stress));
  EXPECT_THAT(scene.outputs.snapshot_history, ElementsAre("damage"));
  EXPECT_EQ(scene.outputs.probes[0].statistic, Statistic::largest);
  EXPECT_EQ(std::get<Region>(scene.outputs.probes[0].where).index(), 0u);
  EXPECT_THAT(scene.outputs.probes[0].history, ElementsAre("temperature"));
  EXPECT_EQ(scene.outputs.probes[1].statistic, Statistic::smallest);
  EXPECT_EQ(std::get<Region>(scene.outputs.probes[1].where).index(), 1u);
}

TEST_F(EveryField, KeepsMeasures) {
  ASSERT_EQ(scene_.measures.size(), 7u);
  const MeasureDefinition& first = scene_.measures[0];
  EXPECT_EQ(first.name, "m1");
  EXPECT_EQ(first.quantity, "tip.displacement.y");
  EXPECT_EQ(first.from, 17.1);
  EXPECT_EQ(first.until, 17.2);
  EXPECT_EQ(first.exact, "6*E");
  EXPECT_EQ(first.source, "a book");
  EXPECT_EQ(first.tolerance, 17.3);
}

TEST_F(EveryField, KeepsKindsOfMeasures) {
  ASSERT_EQ(scene_.measures.size(), 7u);
  EXPECT_TRUE(std::holds_alternative<FinalValue>(scene_.measures[0].kind));
  EXPECT_EQ(std::get<ExtremeValue>(scene_.measures[1].kind).kind, ExtremeKind::maximum);
  EXPECT_EQ(std::get<ExtremeValue>(scene_.measures[2].kind).kind, ExtremeKind::minimum);
  EXPECT_EQ(std::get<ExtremeValue>(scene_.measures[3].kind).kind, ExtremeKind::magnitude);
  EXPECT_TRUE(std::holds_alternative<MeanValue>(scene_.measures[4].kind));
  const auto& frequency = std::get<DominantFrequency>(scene_.measures[5].kind);
  EXPECT_EQ(frequency.lowest, 18.1);
  EXPECT_EQ(frequency.highest, 18.2);
  const auto& deviation = std::get<Deviation>(scene_.measures[6].kind);
  EXPECT_EQ(deviation.exact_history, "7*t");
  EXPECT_EQ(deviation.scale, 18.3);
}

TEST(ConvertScene, FieldsLeftOutTakeTheirDefaults) {
  const Scene scene = to_scene(parse("bodies {} loads {} measures { deviation {} }"));
  const Scene fresh;
  EXPECT_EQ(scene.domain.thickness, std::nullopt);
  EXPECT_EQ(scene.bodies[0].particles_per_cell_side, 2);
  EXPECT_EQ(scene.bodies[0].initial_velocity.x, std::nullopt);
  EXPECT_EQ(std::get<double>(scene.loads[0].time), 1);
  EXPECT_EQ(scene.numerics.scheme, fresh.numerics.scheme);
  EXPECT_EQ(scene.numerics.shape_functions, fresh.numerics.shape_functions);
  EXPECT_EQ(scene.numerics.flip_fraction, std::nullopt);
  EXPECT_EQ(scene.numerics.transfer, fresh.numerics.transfer);
  EXPECT_EQ(scene.numerics.time_step_fraction, 0.5);
  EXPECT_EQ(scene.numerics.time_step, std::nullopt);
  EXPECT_EQ(scene.numerics.threads, std::nullopt);
  EXPECT_EQ(scene.outputs.samples, 200);
  EXPECT_EQ(scene.outputs.snapshots, std::nullopt);
  EXPECT_EQ(scene.outputs.snapshot_fields, fresh.outputs.snapshot_fields);
  EXPECT_EQ(std::get<Deviation>(scene.measures[0].kind).scale, 1);
  EXPECT_EQ(scene.measures[0].tolerance, std::nullopt);
}

TEST(ConvertScene, ChoicesLeftOutStayOpen) {
  const Scene scene = to_scene(
      parse("materials {} bodies {} boundaries {} loads {} measures {} outputs { probes {} probes { mean {} } }"));
  EXPECT_THAT(scene.materials[0].law, IsEmpty());
  EXPECT_EQ(scene.bodies[0].geometry.index(), 0u);
  EXPECT_EQ(scene.boundaries[0].condition.index(), 0u);
  EXPECT_EQ(scene.loads[0].kind.index(), 0u);
  EXPECT_EQ(scene.measures[0].kind.index(), 0u);
  EXPECT_EQ(scene.outputs.probes[0].where.index(), 0u);
  EXPECT_EQ(std::get<Region>(scene.outputs.probes[1].where).index(), 0u) << "a mean over an empty region";
}

TEST(ConvertScene, ZeroGivenIsNotTheSameAsLeftOut) {
  const Scene scene =
      to_scene(parse("domain { thickness: 0 } numerics { flip_fraction: 0 threads: 0 }"
                     "outputs { samples: 0 snapshots: 0 } bodies { particles_per_cell_side: 0 }"));
  EXPECT_EQ(scene.domain.thickness, 0);
  EXPECT_EQ(scene.numerics.flip_fraction, 0);
  EXPECT_EQ(scene.numerics.threads, 0);
  EXPECT_EQ(scene.outputs.samples, 0);
  EXPECT_EQ(scene.outputs.snapshots, 0);
  EXPECT_EQ(scene.bodies[0].particles_per_cell_side, 0);
}

TEST(ConvertScene, EnumValuesOfALaterVersionAreUnspecified) {
  const Scene scene =
      to_scene(parse("domain { dimension: 77 } boundaries { fixed { axes: 77 } }"
                     "loads { edge_traction { edge: 77 } } outputs { snapshot_fields: 77 }"
                     "measures { extreme { kind: 77 } }"));
  EXPECT_EQ(scene.domain.dimension, Dimension::unspecified);
  EXPECT_THAT(std::get<Fixed>(scene.boundaries[0].condition).axes, ElementsAre(Axis::unspecified));
  EXPECT_EQ(std::get<EdgeTraction>(scene.loads[0].kind).edge, Edge::unspecified);
  EXPECT_THAT(scene.outputs.snapshot_fields, ElementsAre(Field::unspecified));
  EXPECT_EQ(scene.measures[0].kind.index(), 0u);
}

TEST(ConvertScene, DimensionsKeepTheirMeaning) {
  const auto dimension = [](const std::string& word) {
    return to_scene(parse("domain { dimension: " + word + " }")).domain.dimension;
  };
  EXPECT_EQ(dimension("BAR"), Dimension::bar);
  EXPECT_EQ(dimension("PLANE_STRESS"), Dimension::plane_stress);
  EXPECT_EQ(dimension("AXISYMMETRIC"), Dimension::axisymmetric);
  EXPECT_EQ(dimension("SOLID"), Dimension::solid);
}

std::vector<Violation> violations_of(const v1::Scene& scene) {
  try {
    validate(to_scene(scene));
    return {};
  } catch (const InvalidScene& invalid) {
    return invalid.violations();
  }
}

TEST_F(EveryField, ViolationsNameFieldsOfTheMessage) {
  const std::vector<Violation> violations = violations_of(message_);
  EXPECT_GE(violations.size(), 10u) << "its numbers tell fields apart, they make no sense together";
  for (const Violation& violation : violations) {
    EXPECT_TRUE(testing::names_a_field(message_, violation.path)) << violation.path;
  }
}

TEST(ConvertScene, ViolationsOfAnEmptySceneNameWhatIsMissing) {
  std::vector<std::string> paths;
  for (const Violation& violation : violations_of(v1::Scene())) paths.push_back(violation.path);
  EXPECT_THAT(paths, ::testing::IsSupersetOf({"name", "domain.dimension", "domain.cell_size", "materials",
                                              "bodies", "analysis.end_time"}));
}

TEST(SceneSchema, TellsPathsOfFieldsFromOthers) {
  const v1::Scene scene = parse("bodies { geometry { disc {} } } constants {}");
  for (const char* path : {"name", "bodies", "bodies[0]", "bodies[0].geometry.disc.radius",
                           "bodies[0].geometry.shape", "domain.lower.x"}) {
    EXPECT_TRUE(testing::names_a_field(scene, path)) << path;
  }
  for (const char* path : {"", "nam", "name.x", "bodies[1]", "bodies.name", "name[0]",
                           "bodies[0].geometry.shape.disc", "bodies[0]. name", "bodies[-1]", "bodies[0"}) {
    EXPECT_FALSE(testing::names_a_field(scene, path)) << path;
  }
}

}  // namespace
}  // namespace trajan
