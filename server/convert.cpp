#include "server/convert.h"

#include "server/convert_parts.h"

namespace trajan {
namespace {

Constant to_constant(const v1::Constant& message) { return {message.name(), message.value()}; }

ParticleLayout to_particle_layout(int value) {
  switch (value) {
    case v1::Body::PARTICLE_LAYOUT_UNSPECIFIED:
    case v1::Body::UNIFORM:
      return ParticleLayout::uniform;
    case v1::Body::GAUSS:
      return ParticleLayout::gauss;
    default:
      return ParticleLayout::unspecified;
  }
}

BodyDefinition to_body(const v1::Body& message) {
  BodyDefinition body;
  body.name = message.name();
  body.material = message.material();
  body.geometry = to_region(message.geometry());
  if (message.has_particles_per_cell_side()) body.particles_per_cell_side = message.particles_per_cell_side();
  body.initial_velocity = to_vector_expression(message.initial_velocity());
  body.initial_stress = to_symmetric_tensor_expression(message.initial_stress());
  body.initial_deformation = to_tensor_expression(message.initial_deformation());
  body.particle_layout = to_particle_layout(message.particle_layout());
  return body;
}

BodyContact to_contact(const v1::BodyContact& message) {
  return {{message.bodies().begin(), message.bodies().end()}, message.friction()};
}

Numerics to_numerics(const v1::Numerics& message) {
  Numerics numerics;
  if (!message.scheme().empty()) numerics.scheme = message.scheme();
  if (!message.shape_functions().empty()) numerics.shape_functions = message.shape_functions();
  if (!message.transfer().empty()) numerics.transfer = message.transfer();
  if (message.has_transfer_order()) numerics.transfer_order = message.transfer_order();
  if (message.has_flip_fraction()) numerics.flip_fraction = message.flip_fraction();
  if (message.has_time_step_fraction()) numerics.time_step_fraction = message.time_step_fraction();
  if (message.has_time_step()) numerics.time_step = message.time_step();
  if (message.has_threads()) numerics.threads = message.threads();
  if (!message.locking_remedy().empty()) numerics.locking_remedy = message.locking_remedy();
  if (!message.precision().empty()) numerics.precision = message.precision();
  return numerics;
}

}  // namespace

Scene to_scene(const v1::Scene& message) {
  Scene scene;
  scene.name = message.name();
  scene.description = message.description();
  scene.units = message.units();
  scene.constants = convert_all(message.constants(), to_constant);
  scene.domain = to_domain(message.domain());
  scene.materials = convert_all(message.materials(), to_material);
  scene.bodies = convert_all(message.bodies(), to_body);
  scene.boundaries = convert_all(message.boundaries(), to_boundary);
  scene.loads = convert_all(message.loads(), to_load);
  scene.analysis = to_analysis(message.analysis());
  scene.numerics = to_numerics(message.numerics());
  scene.outputs = to_outputs(message.outputs());
  scene.measures = convert_all(message.measures(), to_measure);
  scene.contacts = convert_all(message.contacts(), to_contact);
  return scene;
}

v1::Violation to_proto(const Violation& violation) {
  v1::Violation message;
  message.set_path(violation.path);
  message.set_value(violation.value);
  message.set_problem(violation.problem);
  message.set_remedy(violation.remedy);
  return message;
}

google::protobuf::RepeatedPtrField<v1::Violation> to_proto(const std::vector<Violation>& violations) {
  google::protobuf::RepeatedPtrField<v1::Violation> messages;
  for (const Violation& violation : violations) *messages.Add() = to_proto(violation);
  return messages;
}

v1::MeasureValue to_proto(const MeasureValue& value) {
  v1::MeasureValue message;
  message.set_name(value.name);
  message.set_quantity(value.quantity);
  message.set_value(value.value);
  if (value.exact) message.set_exact(*value.exact);
  if (value.error) message.set_error(*value.error);
  if (value.tolerance) message.set_tolerance(*value.tolerance);
  message.set_source(value.source);
  return message;
}

v1::Progress to_proto(const RunProgress& progress) {
  v1::Progress message;
  message.set_step(progress.step);
  message.set_total_steps(progress.total_steps);
  message.set_time(progress.time);
  message.set_end_time(progress.end_time);
  message.set_rows(progress.rows);
  message.set_energy_balance_error(progress.energy_balance_error);
  message.set_particle_steps_per_second(progress.particle_steps_per_second);
  return message;
}

v1::Failure to_proto(const Divergence& divergence) {
  v1::Failure message;
  message.set_reason("DIVERGED");
  message.set_message(divergence.cause);
  message.set_remedy(divergence.remedy);
  message.set_step(divergence.step);
  message.set_time(divergence.time);
  message.set_particle(divergence.particle);
  return message;
}

v1::Warning to_proto(const Warning& warning) {
  v1::Warning message;
  message.set_name(warning.name);
  message.set_cause(warning.cause);
  message.set_remedy(warning.remedy);
  message.set_step(warning.step);
  message.set_time(warning.time);
  message.set_particle(warning.particle);
  return message;
}

namespace {

void add_attributes(const ModelPlan& plan, v1::Plan& message) {
  for (const ModelPlan::Attribute& attribute : plan.attributes) {
    v1::Attribute& row = *message.add_attributes();
    row.set_name(attribute.name);
    row.set_bytes_per_particle(attribute.bytes);
    row.set_wanted_by(attribute.wanted_by);
  }
  for (const ModelPlan::Attribute& attribute : plan.node_attributes) {
    v1::NodeAttribute& row = *message.add_node_attributes();
    row.set_name(attribute.name);
    row.set_bytes_per_node(attribute.bytes);
    row.set_wanted_by(attribute.wanted_by);
  }
}

void add_sweeps(const ModelPlan& plan, v1::Plan& message) {
  for (const ModelPlan::Sweep& sweep : plan.sweeps) {
    v1::ParticleSweep& row = *message.add_sweeps();
    for (const ModelPlan::BodyStages& of_bodies : sweep.of_bodies) {
      v1::ParticleSweep::BodyStages& stages = *row.add_of_bodies();
      stages.mutable_bodies()->Assign(of_bodies.bodies.begin(), of_bodies.bodies.end());
      stages.mutable_stages()->Assign(of_bodies.stages.begin(), of_bodies.stages.end());
    }
  }
}

}  // namespace

v1::Plan to_proto(const ModelPlan& plan) {
  v1::Plan message;
  message.set_particles(plan.particles);
  message.set_active_cells(plan.active_cells);
  message.set_time_step(plan.time_step);
  message.set_steps(plan.steps);
  message.set_time_step_limit(plan.time_step_limit);
  message.set_memory_bytes(plan.memory_bytes);
  add_attributes(plan, message);
  add_sweeps(plan, message);
  message.set_tiles(plan.tiles);
  message.set_occupied_tiles(plan.occupied_tiles);
  message.set_particle_bytes(plan.particle_bytes);
  message.set_grid_bytes(plan.grid_bytes);
  message.set_matrix_bytes(plan.matrix_bytes);
  return message;
}

}  // namespace trajan
