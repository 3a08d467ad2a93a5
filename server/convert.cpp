#include "server/convert.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <iterator>

namespace trajan {
namespace {

using google::protobuf::FieldDescriptor;

template <typename Messages, typename Convert>
auto convert_all(const Messages& messages, Convert convert) {
  std::vector<decltype(convert(messages[0]))> values;
  values.reserve(static_cast<std::size_t>(messages.size()));
  std::transform(messages.begin(), messages.end(), std::back_inserter(values), convert);
  return values;
}

Vector to_vector(const v1::Vector& message) { return {message.x(), message.y()}; }

VectorExpression to_vector_expression(const v1::VectorExpression& message) {
  VectorExpression expression;
  if (message.has_x()) expression.x = message.x();
  if (message.has_y()) expression.y = message.y();
  return expression;
}

Constant to_constant(const v1::Constant& message) { return {message.name(), message.value()}; }

Dimension to_dimension(v1::Domain::Dimension value) {
  switch (value) {
    case v1::Domain::PLANE_STRESS:
      return Dimension::plane_stress;
    case v1::Domain::PLANE_STRAIN:
      return Dimension::plane_strain;
    default:
      return Dimension::unspecified;
  }
}

Domain to_domain(const v1::Domain& message) {
  Domain domain;
  domain.dimension = to_dimension(message.dimension());
  domain.lower = to_vector(message.lower());
  domain.upper = to_vector(message.upper());
  domain.cell_size = message.cell_size();
  if (message.has_thickness()) domain.thickness = message.thickness();
  return domain;
}

/// Fields of laws are numbers; a law with another kind of field has no place in a parameter table.
std::map<std::string, double> parameters_of(const google::protobuf::Message& law) {
  const auto& reflection = *law.GetReflection();
  const auto& descriptor = *law.GetDescriptor();
  std::map<std::string, double> parameters;
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const FieldDescriptor* field = descriptor.field(i);
    if (field->is_repeated() || field->cpp_type() != FieldDescriptor::CPPTYPE_DOUBLE) continue;
    if (field->has_presence() && !reflection.HasField(law, field)) continue;
    parameters.emplace(field->name(), reflection.GetDouble(law, field));
  }
  return parameters;
}

MaterialDefinition to_material(const v1::Material& message) {
  MaterialDefinition material;
  material.name = message.name();
  material.density = message.density();
  const auto& reflection = *message.GetReflection();
  const auto* laws = v1::Material::descriptor()->FindOneofByName("law");
  if (const FieldDescriptor* law = reflection.GetOneofFieldDescriptor(message, laws)) {
    material.law = law->name();
    material.parameters = parameters_of(reflection.GetMessage(message, law));
  }
  return material;
}

Region to_region(const v1::Region& message) {
  switch (message.shape_case()) {
    case v1::Region::kBox:
      return Box{to_vector(message.box().lower()), to_vector(message.box().upper())};
    case v1::Region::kDisc:
      return Disc{to_vector(message.disc().centre()), message.disc().radius()};
    case v1::Region::SHAPE_NOT_SET:
      break;
  }
  return {};
}

BodyDefinition to_body(const v1::Body& message) {
  BodyDefinition body;
  body.name = message.name();
  body.material = message.material();
  body.geometry = to_region(message.geometry());
  if (message.has_particles_per_cell_side()) body.particles_per_cell_side = message.particles_per_cell_side();
  body.initial_velocity = to_vector_expression(message.initial_velocity());
  return body;
}

Axis to_axis(int value) {
  switch (value) {
    case v1::Fixed::X:
      return Axis::x;
    case v1::Fixed::Y:
      return Axis::y;
    default:
      return Axis::unspecified;
  }
}

BoundaryDefinition to_boundary(const v1::Boundary& message) {
  BoundaryDefinition boundary;
  boundary.name = message.name();
  boundary.nodes = to_region(message.nodes());
  switch (message.condition_case()) {
    case v1::Boundary::kFixed:
      boundary.condition = Fixed{convert_all(message.fixed().axes(), to_axis)};
      break;
    case v1::Boundary::kPrescribedVelocity:
      boundary.condition = PrescribedVelocity{to_vector_expression(message.prescribed_velocity().velocity())};
      break;
    case v1::Boundary::CONDITION_NOT_SET:
      break;
  }
  return boundary;
}

TimeFunctionDefinition to_time_function(const v1::TimeFunction& message) {
  switch (message.kind_case()) {
    case v1::TimeFunction::kConstant:
      return message.constant();
    case v1::TimeFunction::kRamp:
      return Ramp{message.ramp().start(), message.ramp().duration(), message.ramp().smooth()};
    case v1::TimeFunction::kSine:
      return Sine{message.sine().frequency(), message.sine().phase()};
    case v1::TimeFunction::kTable:
      return Table{{message.table().times().begin(), message.table().times().end()},
                   {message.table().values().begin(), message.table().values().end()}};
    case v1::TimeFunction::kExpression:
      return message.expression();
    case v1::TimeFunction::KIND_NOT_SET:
      break;
  }
  return LoadDefinition{}.time;
}

Edge to_edge(v1::EdgeTraction::Edge value) {
  switch (value) {
    case v1::EdgeTraction::LEFT:
      return Edge::left;
    case v1::EdgeTraction::RIGHT:
      return Edge::right;
    case v1::EdgeTraction::BOTTOM:
      return Edge::bottom;
    case v1::EdgeTraction::TOP:
      return Edge::top;
    default:
      return Edge::unspecified;
  }
}

PointForce to_point_force(const v1::PointForce& message) {
  return {message.body(), to_vector(message.position()), to_vector(message.force())};
}

EdgeTraction to_edge_traction(const v1::EdgeTraction& message) {
  return {message.body(), to_edge(message.edge()), to_vector(message.traction()), message.profile()};
}

BodyForce to_body_force(const v1::BodyForce& message) {
  return {to_vector(message.acceleration()), {message.bodies().begin(), message.bodies().end()}};
}

LoadDefinition to_load(const v1::Load& message) {
  LoadDefinition load;
  load.name = message.name();
  load.time = to_time_function(message.time());
  switch (message.kind_case()) {
    case v1::Load::kPointForce:
      load.kind = to_point_force(message.point_force());
      break;
    case v1::Load::kEdgeTraction:
      load.kind = to_edge_traction(message.edge_traction());
      break;
    case v1::Load::kBodyForce:
      load.kind = to_body_force(message.body_force());
      break;
    case v1::Load::KIND_NOT_SET:
      break;
  }
  return load;
}

Numerics to_numerics(const v1::Numerics& message) {
  Numerics numerics;
  if (!message.scheme().empty()) numerics.scheme = message.scheme();
  if (!message.shape_functions().empty()) numerics.shape_functions = message.shape_functions();
  if (message.has_flip_fraction()) numerics.flip_fraction = message.flip_fraction();
  if (message.has_time_step_fraction()) numerics.time_step_fraction = message.time_step_fraction();
  if (message.has_time_step()) numerics.time_step = message.time_step();
  if (message.has_threads()) numerics.threads = message.threads();
  return numerics;
}

Field to_field(int value) {
  switch (value) {
    case v1::POSITION:
      return Field::position;
    case v1::DISPLACEMENT:
      return Field::displacement;
    case v1::VELOCITY:
      return Field::velocity;
    case v1::STRESS:
      return Field::stress;
    default:
      return Field::unspecified;
  }
}

ProbeDefinition to_probe(const v1::Probe& message) {
  ProbeDefinition probe;
  probe.name = message.name();
  if (message.has_nearest()) probe.where = to_vector(message.nearest());
  if (message.has_mean()) probe.where = to_region(message.mean());
  probe.fields = convert_all(message.fields(), to_field);
  probe.body = message.body();
  return probe;
}

Outputs to_outputs(const v1::Outputs& message) {
  Outputs outputs;
  if (message.has_samples()) outputs.samples = message.samples();
  if (message.has_snapshots()) outputs.snapshots = message.snapshots();
  if (!message.snapshot_fields().empty()) {
    outputs.snapshot_fields = convert_all(message.snapshot_fields(), to_field);
  }
  outputs.probes = convert_all(message.probes(), to_probe);
  return outputs;
}

using MeasureKind = decltype(MeasureDefinition::kind);

/// An unknown kind is no kind: another extreme than the one that was meant would be a wrong answer.
MeasureKind to_extreme(const v1::Extreme& message) {
  switch (message.kind()) {
    case v1::Extreme::MAGNITUDE:
      return ExtremeValue{ExtremeKind::magnitude};
    case v1::Extreme::MAXIMUM:
      return ExtremeValue{ExtremeKind::maximum};
    case v1::Extreme::MINIMUM:
      return ExtremeValue{ExtremeKind::minimum};
    default:
      return {};
  }
}

DominantFrequency to_dominant_frequency(const v1::DominantFrequency& message) {
  DominantFrequency frequency;
  frequency.lowest = message.lowest();
  if (message.has_highest()) frequency.highest = message.highest();
  return frequency;
}

Deviation to_deviation(const v1::Deviation& message) {
  Deviation deviation;
  deviation.exact_history = message.exact_history();
  if (message.has_scale()) deviation.scale = message.scale();
  return deviation;
}

MeasureKind to_measure_kind(const v1::Measure& message) {
  switch (message.kind_case()) {
    case v1::Measure::kFinal:
      return FinalValue{};
    case v1::Measure::kExtreme:
      return to_extreme(message.extreme());
    case v1::Measure::kMean:
      return MeanValue{};
    case v1::Measure::kDominantFrequency:
      return to_dominant_frequency(message.dominant_frequency());
    case v1::Measure::kDeviation:
      return to_deviation(message.deviation());
    case v1::Measure::KIND_NOT_SET:
      break;
  }
  return {};
}

MeasureDefinition to_measure(const v1::Measure& message) {
  MeasureDefinition measure;
  measure.name = message.name();
  measure.quantity = message.quantity();
  measure.kind = to_measure_kind(message);
  measure.from = message.from();
  if (message.has_until()) measure.until = message.until();
  measure.exact = message.exact();
  measure.source = message.source();
  if (message.has_tolerance()) measure.tolerance = message.tolerance();
  return measure;
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
  scene.analysis = {message.analysis().end_time(), message.analysis().damping()};
  scene.numerics = to_numerics(message.numerics());
  scene.outputs = to_outputs(message.outputs());
  scene.measures = convert_all(message.measures(), to_measure);
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

v1::Plan to_proto(const ModelPlan& plan) {
  v1::Plan message;
  message.set_particles(plan.particles);
  message.set_active_cells(plan.active_cells);
  message.set_time_step(plan.time_step);
  message.set_steps(plan.steps);
  message.set_time_step_limit(plan.time_step_limit);
  message.set_memory_bytes(plan.memory_bytes);
  for (const ModelPlan::Attribute& attribute : plan.attributes) {
    v1::Attribute& row = *message.add_attributes();
    row.set_name(attribute.name);
    row.set_bytes_per_particle(attribute.bytes_per_particle);
    row.set_wanted_by(attribute.wanted_by);
  }
  return message;
}

}  // namespace trajan
