/// The laws of the registry and the messages of the schema are two lists of the same things.

#include <gmock/gmock.h>

#include "solver/materials/material.h"
#include "trajan/v1/scene.pb.h"

namespace trajan {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::OneofDescriptor;

const OneofDescriptor& laws() { return *v1::Material::descriptor()->FindOneofByName("law"); }

TEST(LawSchema, EveryLawOfTheRegistryHasAMessageAndTheOtherWayRound) {
  std::vector<std::string> registry;
  for (const MaterialKind& kind : material_kinds()) registry.emplace_back(kind.name);
  std::vector<std::string> messages;
  for (int i = 0; i < laws().field_count(); ++i) messages.push_back(laws().field(i)->name());
  EXPECT_THAT(registry, ::testing::UnorderedElementsAreArray(messages));
}

TEST(LawSchema, ParameterTablesAndMessagesHaveTheSameNames) {
  for (int i = 0; i < laws().field_count(); ++i) {
    const FieldDescriptor& law = *laws().field(i);
    const MaterialKind* kind = find_material_kind(law.name());
    ASSERT_NE(kind, nullptr) << law.name();
    std::vector<std::string> table;
    for (const Parameter& parameter : kind->parameters) table.emplace_back(parameter.name);
    std::vector<std::string> fields;
    for (int f = 0; f < law.message_type()->field_count(); ++f) {
      fields.push_back(law.message_type()->field(f)->name());
    }
    EXPECT_THAT(table, ::testing::UnorderedElementsAreArray(fields)) << law.name();
  }
}

TEST(LawSchema, AParameterThatMayBeLeftOutIsAFieldThatKnowsWhetherItWasGiven) {
  for (int i = 0; i < laws().field_count(); ++i) {
    const FieldDescriptor& law = *laws().field(i);
    for (const Parameter& parameter : find_material_kind(law.name())->parameters) {
      const FieldDescriptor* field = law.message_type()->FindFieldByName(std::string(parameter.name));
      ASSERT_NE(field, nullptr) << parameter.name;
      EXPECT_EQ(field->has_presence(), parameter.optional()) << field->full_name();
      EXPECT_TRUE(!parameter.optional() || parameter.allows(parameter.otherwise)) << field->full_name();
    }
  }
}

TEST(LawSchema, EveryParameterIsANumberThatTranslationUnderstands) {
  for (int i = 0; i < laws().field_count(); ++i) {
    const google::protobuf::Descriptor& law = *laws().field(i)->message_type();
    for (int f = 0; f < law.field_count(); ++f) {
      EXPECT_EQ(law.field(f)->cpp_type(), FieldDescriptor::CPPTYPE_DOUBLE) << law.field(f)->full_name();
      EXPECT_FALSE(law.field(f)->is_repeated()) << law.field(f)->full_name();
    }
  }
}

}  // namespace
}  // namespace trajan
