#include "solver/simulation/particles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/loads/body_fields.h"
#include "solver/schemes/law_response.h"
#include "solver/schemes/law_state.h"
#include "solver/schemes/schemes.h"
#include "solver/simulation/kinks.h"
#include "solver/transfers/transfer.h"

namespace trajan {
namespace {

constexpr std::string_view names[] = {
    "position.x",       "position.y",     "position.z",     "velocity.x",     "velocity.y",     "velocity.z",
    "displacement.x",   "displacement.y", "displacement.z", "volume",         "stress.xx",      "stress.yy",
    "stress.zz",        "stress.xy",      "stress.yz",      "stress.xz",      "deformation.xx", "deformation.xy",
    "deformation.xz",   "deformation.yx", "deformation.yy", "deformation.yz", "deformation.zx", "deformation.zy",
    "deformation.zz",   "affine.xx",      "affine.xy",      "affine.xz",      "affine.yx",      "affine.yy",
    "affine.yz",        "affine.zx",      "affine.zy",      "affine.zz",      "history.0",      "history.1",
    "history.2",        "history.3",      "history.4",      "history.5",      "history.6",      "history.7",
    "reference_volume", "load.x",         "load.y",         "load.z"};
static_assert(std::size(names) == attribute_count);

const LawKernels& law_of(const Model& model, const Body& body) {
  const bool total = find_scheme(model.numerics.scheme)->total_lagrangian;
  return *kernels().law(model.materials[body.material].kind->name, model.dimension, total);
}

double value_or_zero(const std::optional<Expression>& expression, Vector at) {
  return expression ? (*expression)(at, 0) : 0.0;
}

BodyConstants constants_of(const Model& model, const Body& body) {
  BodyConstants constants;
  constants.density = model.materials[body.material].density;
  constants.reference_volume = body.particle_volume;
  constants.mass = constants.density * body.particle_volume;
  const double spacing[] = {body.lattice.spacing.x, body.lattice.spacing.y, body.lattice.spacing.z};
  for (int axis = 0; axis < 3; ++axis) constants.half_size[axis] = 0.5 * spacing[axis] / model.grid.cell;
  return constants;
}

Attribute affine(int a, int b) {
  return static_cast<Attribute>(static_cast<int>(Attribute::affine_xx) + 3 * a + b);
}

/// The gradient of the initial velocity, by its differences across the particle; zero where it has none.
void fill_affine(BodyParticles& made, const Model& model, const Body& body) {
  const int axes = grid_axes(model.dimension);
  const std::optional<Expression>* velocity[] = {&body.velocity_x, &body.velocity_y, &body.velocity_z};
  const Vector spacing = body.lattice.spacing;
  const Vector along[] = {{spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}};
  const double size[] = {spacing.x, spacing.y, spacing.z};
  body.lattice.for_each_point([&](std::int64_t number, Vector at) {
    for (int a = 0; a < axes; ++a)
      for (int b = 0; b < axes; ++b) {
        const Vector half{0.5 * along[b].x, 0.5 * along[b].y, 0.5 * along[b].z};
        const double above = value_or_zero(*velocity[a], {at.x + half.x, at.y + half.y, at.z + half.z});
        const double below = value_or_zero(*velocity[a], {at.x - half.x, at.y - half.y, at.z - half.z});
        const double gradient = (above - below) / size[b];
        made[affine(a, b)][static_cast<std::size_t>(number)] = std::isfinite(gradient) ? gradient : 0;
      }
  });
}

/// In cells; what is nearer to a face of cells lies on it but for rounding.
constexpr double on_a_face = 1e-9;

/// A coordinate in cells, of a particle of a body whose particles lie between `first` and `last`: at the body's
/// surface one that lies on a face of cells belongs to the cell that has the body. In the other one it would bring
/// forces to nodes beyond, but no mass. A body of a single row has nothing on either side.
double into_the_body(double at, double first, double last, double spacing) {
  const double face = std::round(at);
  if (std::abs(at - face) > on_a_face || last - first < 0.5 * spacing) return at;
  if (at - first < 0.5 * spacing) return face + on_a_face;
  return last - at < 0.5 * spacing ? face - on_a_face : at;
}

/// Only lattices of boxes have places on faces of cells: `into_the_body` along each axis.
Vector inside(Vector at, const Model& model, const Lattice& lattice) {
  const Vector first = lattice.point(0, 0), last = lattice.point(lattice.columns - 1, lattice.row_count() - 1);
  const auto along = [&](double x, double lower, double upper, double spacing, double origin) {
    const double cell = model.grid.cell, in_cells = (x - origin) / cell;
    const double moved = into_the_body(in_cells, (lower - origin) / cell, (upper - origin) / cell, spacing / cell);
    return moved == in_cells ? x : origin + cell * moved;
  };
  const Vector &spacing = lattice.spacing, &origin = model.grid.origin;
  return {along(at.x, first.x, last.x, spacing.x, origin.x), along(at.y, first.y, last.y, spacing.y, origin.y),
          along(at.z, first.z, last.z, spacing.z, origin.z)};
}

void fill(BodyParticles& made, const Model& model, const Body& body) {
  const int axes = grid_axes(model.dimension);
  const bool kinks = has_kinks_at_rest(model);
  const std::optional<Expression>* velocity[] = {&body.velocity_x, &body.velocity_y, &body.velocity_z};
  body.lattice.for_each_point([&](std::int64_t point, Vector at) {
    const auto number = static_cast<std::uint32_t>(point);
    made.number[number] = number;
    const Vector place = kinks ? inside(at, model, body.lattice) : at;
    const double position[] = {place.x, place.y, place.z};
    for (int axis = 0; axis < axes; ++axis) {
      made.component(Attribute::position_x, axis)[number] = position[axis];
      made.component(Attribute::velocity_x, axis)[number] = value_or_zero(*velocity[axis], at);
    }
  });
  if (!made[Attribute::affine_xx].empty()) fill_affine(made, model, body);
  std::vector<double>& reference_volume = made[Attribute::reference_volume];
  for (std::size_t i = 0; i < reference_volume.size(); ++i)
    reference_volume[i] = body.particle_volume * body.lattice.share(static_cast<std::int64_t>(i), axes) *
                          (model.dimension == Dimension::axisymmetric ? made[Attribute::position_x][i] : 1.0);
  std::vector<double>& volume = made[Attribute::volume];
  for (std::size_t i = 0; i < volume.size(); ++i)
    volume[i] = reference_volume.empty() ? body.particle_volume : reference_volume[i];
}

/// Whether a deformation gradient is asked for that laws may not need.
bool records_deformation(const Model& model) {
  const auto follows = [](const RecordedField& field) {
    return field.field == Field::strain || field.field == Field::deformation_gradient;
  };
  return std::ranges::any_of(model.outputs.snapshot_fields, follows) ||
         std::ranges::any_of(model.outputs.probes,
                             [&](const Probe& probe) { return std::ranges::any_of(probe.fields, follows); });
}

/// Evaluates a formula for all particles into an attribute, if there is one and the attribute is needed.
void fill(BodyParticles& made, Attribute attribute, const std::optional<Expression>& formula,
          const Lattice& lattice) {
  std::vector<double>& values = made[attribute];
  if (!formula || values.empty()) return;
  lattice.for_each_point(
      [&](std::int64_t point, Vector at) { values[static_cast<std::size_t>(point)] = (*formula)(at, 0); });
}

void begin_state(BodyParticles& made, const Body& body) {
  using enum Attribute;
  constexpr Attribute stress[] = {stress_xx, stress_yy, stress_zz, stress_xy, stress_yz, stress_xz};
  for (std::size_t i = 0; i < body.stress.size(); ++i) fill(made, stress[i], body.stress[i], body.lattice);
  for (std::size_t i = 0; i < body.deformation.size(); ++i)
    fill(made, static_cast<Attribute>(static_cast<std::size_t>(deformation_xx) + i), body.deformation[i],
         body.lattice);
}

/// Of particles that store their deformation gradient, and beside it their volume.
void begin_volume(BodyParticles& made, const Model& model, const Body& body) {
  std::vector<double>& volume = made[Attribute::volume];
  if (volume.empty() || made.law->rate_form) return;
  const bool linear =
      law_response(model.materials[body.material].kind->name, model.dimension, true)->geometrically_linear;
  for (std::size_t i = 0; i < made.size(); ++i) {
    double f[3][3];
    for (int k = 0; k < 9; ++k) {
      const std::vector<double>& component = made.component(Attribute::deformation_xx, k);
      f[k / 3][k % 3] = component.empty() ? k % 4 == 0 : component[i];
    }
    volume[i] *= linear ? f[0][0] + f[1][1] + f[2][2] - 2
                        : f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) -
                              f[0][1] * (f[1][0] * f[2][2] - f[1][2] * f[2][0]) +
                              f[0][2] * (f[1][0] * f[2][1] - f[1][1] * f[2][0]);
  }
}

void begin_history(BodyParticles& made) {
  std::array<double, most_history_variables> history{};
  for (std::size_t i = 0; made.law->history > 0 && i < made.size(); ++i) {
    made.law->begin(made.constants.law, made.number[i], history.data());
    for (int h = 0; h < made.law->history; ++h) made.component(Attribute::history_0, h)[i] = history[h];
  }
}

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
  const auto add_vector = [&](Attribute first) {
    for (int axis = 0; axis < grid_axes(model.dimension); ++axis)
      needs.push_back({static_cast<Attribute>(static_cast<int>(first) + axis), scheme});
  };
  add_vector(position_x);
  add_vector(velocity_x);
  if (total) add_vector(displacement_x);
  if (model.dimension == Dimension::axisymmetric) add({reference_volume}, "dimension axisymmetric");
  if (!model.bodies[body].lattice.shares.empty() && model.dimension != Dimension::axisymmetric)
    add({reference_volume}, "particle layout GAUSS");
  if (find_transfer(model.numerics.transfer)->affine)
    for (int a = 0; a < grid_axes(model.dimension); ++a)
      for (int b = 0; b < grid_axes(model.dimension); ++b)
        add({affine(a, b)}, "transfer " + model.numerics.transfer);
  for (Attribute a : law.attributes) add({a}, law_name);
  if (total && !law.rate_form && model.numerics.locking_remedy != "none")
    add({volume}, "locking remedy " + model.numerics.locking_remedy);
  const bool shapes =
      kernels().doubles.transfer(model.numerics.shape_functions, model.dimension, Margin::none)->needs_deformation;
  const bool contacts = model.contacts.fields > 1;
  if (shapes || contacts || records_deformation(model))
    for (Attribute a : law.tracked)
      add({a}, shapes     ? "shape functions " + model.numerics.shape_functions
               : contacts ? "contacts"
                          : "outputs of strain");
  for (int axis = 0; BodyFields::act_on(model, body) && axis < grid_axes(model.dimension); ++axis)
    needs.push_back({static_cast<Attribute>(static_cast<int>(load_x) + axis), "body force of place"});
  return needs;
}

BodyParticles make_body(const Model& model, std::size_t index) {
  const Body& body = model.bodies[index];
  BodyParticles made;
  made.law = &law_of(model, body);
  const Material& material = model.materials[body.material];
  made.law_object = made.law->make(material.parameters.data(), material.density);
  made.constants = constants_of(model, body);
  if (!model.contacts.field_of.empty()) made.field = model.contacts.field_of[index];
  made.constants.law = made.law_object.get();
  made.needs = attributes_needed(model, index);
  made.narrow = model.numerics.precision == float_precision;
  for (int a = 0; a < attribute_count; ++a)
    if (made.carries(static_cast<Attribute>(a))) made.present.push_back(static_cast<Attribute>(a));
  std::ranges::copy_if(made.present, std::back_inserter(made.narrow_state),
                       [&](Attribute a) { return made.is_float(a) && is_float_of_law(a); });
  made.constants.narrow_state = made.narrow_state;
  return made;
}

void add_particles(const Model& model, const Body& body, BodyParticles& made) {
  const auto n = static_cast<std::size_t>(body.particles);
  for (const AttributeNeed& need : made.needs) made[need.attribute].assign(n, 0.0);
  for (Attribute one : {Attribute::deformation_xx, Attribute::deformation_yy, Attribute::deformation_zz})
    made[one].assign(made[one].size(), 1.0);
  made.number.resize(n);
  fill(made, model, body);
  begin_state(made, body);
  begin_volume(made, model, body);
  begin_history(made);
  made.round();
}

}  // namespace

double BodyParticles::value(Attribute a, std::size_t slot) const {
  const std::vector<float>& rounded = floats[static_cast<std::size_t>(a)];
  return rounded.empty() ? (*this)[a][slot] : value_at_rest(a) + static_cast<double>(rounded[slot]);
}

void BodyParticles::round() {
  for (Attribute a : present) {
    if (!is_float(a)) continue;
    std::vector<float>& rounded = floats[static_cast<std::size_t>(a)];
    rounded.resize(size());
    std::ranges::transform((*this)[a], rounded.begin(),
                           [a](double value) { return static_cast<float>(value - value_at_rest(a)); });
    std::vector<double>().swap((*this)[a]);  // with its memory
  }
}

bool BodyParticles::carries(Attribute a) const {
  return std::ranges::any_of(needs, [a](const AttributeNeed& need) { return need.attribute == a; });
}

std::string_view attribute_name(Attribute attribute) { return names[static_cast<int>(attribute)]; }

std::vector<Vector> reference_positions(const Model& model, const std::vector<std::int64_t>& numbers) {
  std::vector<Vector> positions;
  for (std::int64_t wanted : numbers) {
    const auto after = std::upper_bound(model.bodies.begin(), model.bodies.end(), wanted,
                                        [](std::int64_t n, const Body& b) { return n < b.first_particle; });
    const Body& body = *(after - 1);
    positions.push_back(body.lattice.point_of(wanted - body.first_particle));
  }
  return positions;
}

double lightest_particle(const std::vector<BodyParticles>& bodies) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const BodyParticles& body : bodies) {
    const std::vector<double>& volumes = body[Attribute::reference_volume];
    lightest = std::min(lightest, volumes.empty() ? body.constants.mass
                                                  : body.constants.density * *std::ranges::min_element(volumes));
  }
  return lightest;
}

std::vector<BodyParticles> make_bodies(const Model& model) {
  std::vector<BodyParticles> bodies;
  bodies.reserve(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) bodies.push_back(make_body(model, i));
  return bodies;
}

void add_particles(const Model& model, std::vector<BodyParticles>& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) add_particles(model, model.bodies[i], bodies[i]);
}

}  // namespace trajan
