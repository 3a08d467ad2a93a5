#include "solver/simulation/particles.h"

#include <algorithm>

#include "solver/schemes/schemes.h"

namespace trajan {
namespace {

constexpr std::string_view names[] = {
    "position.x",     "position.y",     "position.z",     "velocity.x",     "velocity.y",     "velocity.z",
    "displacement.x", "displacement.y", "displacement.z", "volume",         "stress.xx",      "stress.yy",
    "stress.zz",      "stress.xy",      "stress.yz",      "stress.xz",      "deformation.xx", "deformation.xy",
    "deformation.xz", "deformation.yx", "deformation.yy", "deformation.yz", "deformation.zx", "deformation.zy",
    "deformation.zz", "affine.xx",      "affine.xy",      "affine.xz",      "affine.yx",      "affine.yy",
    "affine.yz",      "affine.zx",      "affine.zy",      "affine.zz",      "history.0",      "history.1",
    "history.2",      "history.3",      "history.4",      "history.5",      "history.6",      "history.7",
    "load.x",         "load.y",         "load.z"};
static_assert(std::size(names) == attribute_count);

const LawKernels& law_of(const Model& model, const Body& body) {
  const bool total = find_scheme(model.numerics.scheme)->total_lagrangian;
  return *kernels().law(model.materials[body.material].kind->name, model.dimension, total);
}

double value_or_zero(const std::optional<Expression>& expression, Vector at) {
  return expression ? (*expression)(at.x, at.y, 0) : 0.0;
}

BodyParticles make_body(const Model& model, std::size_t index) {
  const Body& body = model.bodies[index];
  const Material& material = model.materials[body.material];
  BodyParticles made;
  made.law = &law_of(model, body);
  made.law_object = made.law->make(material.parameters.data(), model.dimension);
  made.constants.reference_volume = body.particle_volume;
  made.constants.mass = material.density * body.particle_volume;
  made.constants.law = made.law_object.get();

  const auto n = static_cast<std::size_t>(body.particles);
  for (const AttributeNeed& need : attributes_needed(model, index)) made[need.attribute].assign(n, 0.0);
  for (Attribute one : {Attribute::deformation_xx, Attribute::deformation_yy})
    made[one].assign(made[one].size(), 1.0);
  made[Attribute::volume].assign(made[Attribute::volume].size(), body.particle_volume);
  made.number.resize(n);
  for_each_lattice_point(body, [&](std::uint32_t number, Vector at) {
    made.number[number] = number;
    made[Attribute::position_x][number] = at.x;
    made[Attribute::position_y][number] = at.y;
    made[Attribute::velocity_x][number] = value_or_zero(body.velocity_x, at);
    made[Attribute::velocity_y][number] = value_or_zero(body.velocity_y, at);
  });
  return made;
}

}  // namespace

std::string_view attribute_name(Attribute attribute) { return names[static_cast<int>(attribute)]; }

std::vector<AttributeNeed> attributes_needed(const Model& model, std::size_t body) {
  const std::string scheme = "scheme " + model.numerics.scheme;
  const bool total = find_scheme(model.numerics.scheme)->total_lagrangian;
  const LawKernels& law = law_of(model, model.bodies[body]);
  const std::string law_name = "law " + std::string(model.materials[model.bodies[body].material].kind->name);
  using enum Attribute;
  std::vector<AttributeNeed> needs;
  const auto add = [&needs](std::initializer_list<Attribute> attributes, const std::string& by) {
    for (Attribute a : attributes) needs.push_back({a, by});
  };
  add({position_x, position_y, velocity_x, velocity_y}, scheme);
  if (total) add({displacement_x, displacement_y}, scheme);
  if (law.rate_form) add({volume, stress_xx, stress_yy, stress_xy}, law_name);
  if (law.rate_form && model.dimension == Dimension::plane_strain) add({stress_zz}, law_name + " in plane strain");
  if (!law.rate_form || total)
    add({deformation_xx, deformation_xy, deformation_yx, deformation_yy}, law.rate_form ? scheme : law_name);
  return needs;
}

std::vector<Vector> reference_positions(const Model& model, const std::vector<std::int64_t>& numbers) {
  std::vector<Vector> positions;
  for (std::int64_t wanted : numbers) {
    const auto after = std::upper_bound(model.bodies.begin(), model.bodies.end(), wanted,
                                        [](std::int64_t n, const Body& b) { return n < b.first_particle; });
    const Body& body = *(after - 1);
    std::int64_t index = wanted - body.first_particle, row = 0;
    Lattice::Range range = body.lattice.columns_in_row(row);
    for (; index >= range.end - range.begin; range = body.lattice.columns_in_row(++row))
      index -= range.end - range.begin;
    positions.push_back(body.lattice.point(range.begin + index, row));
  }
  return positions;
}

std::vector<BodyParticles> make_particles(const Model& model) {
  std::vector<BodyParticles> bodies;
  bodies.reserve(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) bodies.push_back(make_body(model, i));
  return bodies;
}

}  // namespace trajan
