#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/analyses/run.h"
#include "solver/model/validate.h"
#include "solver/schemes/scheme.h"
#include "solver/simulation/simulation.h"
#include "tests/verification/gallery.h"

namespace trajan::verification {
namespace {

using Names = std::set<std::string>;

class GalleryFrugality : public testing::TestWithParam<std::string> {
 protected:
  GalleryFrugality() : model(validate(gallery_scene(GetParam()))) {}
  const Model model;
};

std::string with_axis(const std::string& name, int axis) { return name + "." + "xyz"[axis]; }

/// What the choices of a scene need, written down once more: positions and velocities always, displacements in
/// total Lagrangian schemes, what the law declares, and what one choice each adds.
Names attributes_for(const Model& model, const Body& body) {
  const int axes = grid_axes(model.dimension);
  const bool total = is_total_lagrangian(model.numerics.scheme);
  const LawKernels& law = *kernels().law(model.materials[body.material].kind->name, model.dimension, total);
  Names names;
  for (int a = 0; a < axes; ++a) {
    names.insert({with_axis("position", a), with_axis("velocity", a)});
    if (total) names.insert(with_axis("displacement", a));
    for (int b = 0; b < axes && model.numerics.transfer == "APIC"; ++b)
      names.insert(with_axis("affine", a) + "xyz"[b]);
  }
  for (Attribute a : law.attributes) names.insert(std::string(attribute_name(a)));
  if (model.dimension == Dimension::axisymmetric || !body.lattice.shares.empty()) names.insert("reference_volume");
  return names;
}

Names attributes_of(const BodyParticles& body) {
  Names names;
  for (int a = 0; a < attribute_count; ++a)
    if (!body.arrays[a].empty()) names.insert(std::string(attribute_name(static_cast<Attribute>(a))));
  return names;
}

/// Where deformation gradients are kept beside the law's own state, they are all that there is besides.
void expect_only(const Names& found, const Names& needed, const std::string& prefix) {
  Names rest;
  std::ranges::set_difference(found, needed, std::inserter(rest, rest.end()));
  for (const std::string& name : rest) EXPECT_TRUE(name.starts_with(prefix)) << name << " is not needed";
  for (const std::string& name : needed) EXPECT_TRUE(found.contains(name)) << name << " is missing";
}

TEST_P(GalleryFrugality, ParticlesCarryWhatTheChoicesNeedAndNothingElse) {
  const Simulation simulation(model, 1);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Names found = attributes_of(simulation.executor().bodies()[b]);
    const Names needed = attributes_for(model, model.bodies[b]);
    const bool tracks = model.contacts.fields > 1 || model.numerics.shape_functions.starts_with("cp") ||
                        std::ranges::any_of(model.outputs.snapshot_fields, [](const RecordedField& field) {
                          return field.field == Field::strain || field.field == Field::deformation_gradient;
                        });
    if (tracks)
      expect_only(found, needed, "deformation.");
    else if (model.numerics.locking_remedy != "none")
      expect_only(found, needed, "volume");
    else if (!model.body_loads.empty())
      expect_only(found, needed, "load.");
    else
      EXPECT_EQ(found, needed);
  }
}

TEST_P(GalleryFrugality, PlanSaysWhatIsAllocated) {
  const ModelPlan planned = plan(model);
  Executor executor(model, 1);
  // Until particles leave their tiles there is less.
  if (!is_total_lagrangian(model.numerics.scheme)) executor.expect_drift();
  executor.begin();
  Names names, allocated{"number"};
  for (const ModelPlan::Attribute& row : planned.attributes) names.insert(row.name);
  std::int64_t bytes = 0;
  for (const BodyParticles& body : executor.bodies()) {
    allocated.merge(attributes_of(body));
    bytes += static_cast<std::int64_t>(body.number.size() * sizeof(std::uint32_t));
    for (const std::vector<double>& array : body.arrays)
      bytes += static_cast<std::int64_t>(array.size() * sizeof(double));
  }
  EXPECT_EQ(names, allocated);
  EXPECT_EQ(planned.particle_bytes, bytes);
  const std::span<const Tile> tiles = executor.tiles().tiles();
  EXPECT_EQ(planned.tiles, std::ssize(tiles));
  EXPECT_EQ(planned.occupied_tiles, std::ranges::count_if(tiles, [](const Tile& t) { return t.window >= 0; }));
  // Ranges of blocks are not in the plan, 8 bytes for up to 128 particles.
  EXPECT_NEAR(static_cast<double>(planned.particle_bytes + planned.grid_bytes),
              static_cast<double>(executor.memory()), 0.02 * static_cast<double>(executor.memory()));
  EXPECT_EQ(planned.node_attributes.size(),
            static_cast<std::size_t>(executor.node_quantities() + executor.tiles().sum_quantities()));
}

using Stages = std::vector<std::string>;

/// Of all sweeps that have been made.
std::set<Stages> stages_made(const Executor& executor, std::size_t body) {
  std::set<Stages> all;
  for (const auto& sweep : executor.sweeps().all()) {
    Stages stages;
    for (Stage stage : sweep->stages[body])
      stages.push_back(executor.sweeps().name(stage, executor.bodies()[body], body));
    all.insert(stages);
  }
  return all;
}

TEST_P(GalleryFrugality, PlanSaysWhatASteppingSimulationDoes) {
  const ModelPlan planned = plan(model);
  if (!std::holds_alternative<ExplicitDynamics>(model.analysis)) return;
  Simulation simulation(model, 1);
  for (int step = 0; step < 3; ++step) simulation.step();
  const std::set<Stages> made = stages_made(simulation.executor(), 0);
  EXPECT_FALSE(planned.sweeps.empty());
  for (const ModelPlan::Sweep& sweep : planned.sweeps) {
    const Stages& stages = sweep.of_bodies.front().stages;
    EXPECT_TRUE(made.contains(stages)) << testing::PrintToString(stages);
    EXPECT_THAT(stages, testing::Not(testing::Contains(""))) << "a stage has no name";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, GalleryFrugality, testing::ValuesIn(gallery_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace trajan::verification
