#include "tests/conformance/material_point.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace trajan::test {
namespace {

struct Sample {
  LawTraits traits;
  std::vector<std::vector<double>> parameters;
};

const std::vector<std::vector<double>> isotropic = {{1000, 0}, {1000, 0.3}, {1000, 0.45}, {1000, -0.3}};
constexpr LawTraits hyperelastic{.hyperelastic = true, .elastic = true, .hookean = true};
constexpr LawTraits hypoelastic{.elastic = true, .hookean = true};

/// What each law is tested with: moduli below `largest_modulus`.
const std::map<std::string_view, Sample> samples = {
    {"linear_elastic", {hypoelastic, isotropic}},
    {"neo_hookean", {hyperelastic, isotropic}},
    {"st_venant_kirchhoff", {hyperelastic, isotropic}},
    {"linear_strain_elastic",
     {{.hyperelastic = true, .elastic = true, .hookean = true, .objective = false}, isotropic}},
    {"mooney_rivlin",
     {{.hyperelastic = true, .elastic = true}, {{150, 50, 1000}, {200, 0, 500}, {100, 100, 3000}}}},
    {"orthotropic_elastic",
     {{.hyperelastic = true, .elastic = true, .isotropic = false},
      {{1000, 300, 200, 0.3, 0.2, 0.05, 150, 100, 120, 0, 0, 0},
       {1000, 1000, 1000, 0.3, 0.3, 0.3, 1000 / 2.6, 1000 / 2.6, 1000 / 2.6, 0, 0, 0}}}},
    // Yielding early, late, with and without hardening.
    {"von_mises", {hypoelastic, {{1000, 0.3, 5, 0}, {1000, 0.3, 5, 100}, {1000, 0.45, 200, 10}}}},
    // Warm, but without what goes on at rest: rates below that of reference, no heating.
    {"johnson_cook",
     {hypoelastic,
      {{1000, 0.3, 5, 20, 0.3, 0.02, 1e3, 1, 300, 1300, 600, not_given, 0.9},
       {1000, 0.3, 5, 0, 1, 0, 1, 1, 0, not_given, not_given, not_given, 0.9}}}},
    {"drucker_prager",
     {hypoelastic,
      {{1000, 0.3, 5, 30, 10, not_given}, {1000, 0.2, 5, 0, 0, not_given}, {1000, 0.3, 5, 40, 40, 2}}}},
    // Without viscosity: at rest its stress would vanish.
    {"tait_fluid", {{}, {{1000, 7, 0, -not_given}, {1000, 2, 0, -100}}}},
    {"ideal_gas", {{}, {{1.4, 500, 500, 0}, {1.67, 300, 300, 0}}}},
};

/// A law with damage is tested with what the law is tested with, once hardly damaged and once much.
Sample damaged(Sample sample) {
  sample.traits.hyperelastic = false;
  const std::vector<std::vector<double>> elastic = std::exchange(sample.parameters, {});
  for (const std::vector<double>& damage :
       {std::vector<double>{1e4, not_given, 3, 0, 1, not_given, 0}, {100, 50, 2, 0, 1, 4, 7}})
    for (std::vector<double> one : elastic) {
      one.insert(one.end(), damage.begin(), damage.end());
      sample.parameters.push_back(one);
    }
  return sample;
}

Sample sample_of(const MaterialKind& kind) {
  const bool is_damaged = kind.name.starts_with(damage_prefix);
  const auto found = samples.find(is_damaged ? kind.name.substr(damage_prefix.size()) : kind.name);
  if (found == samples.end())
    throw std::invalid_argument("give parameters to test law " + std::string(kind.name) + " with");
  return is_damaged ? damaged(found->second) : found->second;
}

constexpr Dimension dimensions[] = {Dimension::bar, Dimension::plane_stress, Dimension::plane_strain,
                                    Dimension::axisymmetric, Dimension::solid};

}  // namespace

std::string name_of(Dimension dimension) {
  static const std::map<Dimension, std::string> names = {{Dimension::bar, "bar"},
                                                         {Dimension::plane_stress, "plane_stress"},
                                                         {Dimension::plane_strain, "plane_strain"},
                                                         {Dimension::axisymmetric, "axisymmetric"},
                                                         {Dimension::solid, "solid"}};
  return names.at(dimension);
}

std::string name_of(const LawCase& of) {
  return std::string(of.kind->name) + "_" + name_of(of.dimension) + (of.total_lagrangian ? "_total" : "_updated");
}

std::ostream& operator<<(std::ostream& out, const LawCase& of) { return out << name_of(of); }

std::vector<LawCase> all_laws() {
  std::vector<LawCase> cases;
  for (const std::span<const MaterialKind> kinds : {material_kinds(), damaged_kinds()})
    for (const MaterialKind& kind : kinds)
      for (Dimension dimension : dimensions)
        for (bool total_lagrangian : {false, true})
          if (kind.objection(dimension, total_lagrangian).empty())
            cases.push_back({&kind, dimension, total_lagrangian});
  return cases;
}

std::vector<LawCase> hyperelastic_laws() {
  std::vector<LawCase> cases = all_laws();
  std::erase_if(cases, [](const LawCase& of) { return !traits_of(*of.kind).hyperelastic; });
  return cases;
}

std::vector<std::vector<double>> sample_parameters(const MaterialKind& kind) { return sample_of(kind).parameters; }

LawTraits traits_of(const MaterialKind& kind) { return sample_of(kind).traits; }

MaterialPoint::MaterialPoint(const LawCase& of, const std::vector<double>& parameters, double density)
    : of_(of),
      kernels_(kernels().law(of.kind->name, of.dimension, of.total_lagrangian)),
      response_kernels_(law_response(of.kind->name, of.dimension, of.total_lagrangian)),
      law_(kernels_->make(parameters.data(), density)),
      scratch_(std::make_shared<Scratch>()) {
  body_.density = body_.mass = density;
  body_.reference_volume = 1;
  body_.law = law_.get();
  sweep_.inverse_cell = 1;
  sweep_.drift = 1;
  for (Attribute one : {Attribute::volume, Attribute::reference_volume, Attribute::deformation_xx,
                        Attribute::deformation_yy, Attribute::deformation_zz})
    state_[static_cast<std::size_t>(one)].fill(1);
  std::array<double, most_history_variables> history{};
  kernels_->begin(law_.get(), 0, history.data());
  for (int h = 0; h < kernels_->history; ++h)
    state_[static_cast<std::size_t>(Attribute::history_0) + static_cast<std::size_t>(h)].fill(
        history[static_cast<std::size_t>(h)]);
}

Block MaterialPoint::block() const {
  Block block;
  block.count = 1;
  // A stage that touches what it has not declared reads a null pointer.
  for (Attribute a : kernels_->attributes)
    block.arrays[static_cast<std::size_t>(a)] = state_[static_cast<std::size_t>(a)].data();
  if (of_.dimension == Dimension::axisymmetric)
    block.arrays[static_cast<std::size_t>(Attribute::reference_volume)] =
        state_[static_cast<std::size_t>(Attribute::reference_volume)].data();
  block.body = &body_;
  block.sweep = &sweep_;
  block.scratch = scratch_.get();
  return block;
}

void MaterialPoint::deform(const Matrix& wanted) {
  const Matrix next = in(of_.dimension, wanted), g = gradient_to(next);
  for (int i = 0; i < axes(); ++i)
    for (int j = 0; j < axes(); ++j) scratch_->gradient[i * axes() + j][0] = g(i, j);
  scratch_->gradient_rest[0] = g(2, 2);
  Block all = block();
  kernels_->deform(all);
  deformation_ = next;
}

Matrix MaterialPoint::gradient_to(const Matrix& next) const {
  const Matrix change = next - deformation_;
  return of_.total_lagrangian ? change : product(change, inverse(deformation_));
}

std::vector<double> MaterialPoint::step_to(const Matrix& next) const {
  const Matrix g = gradient_to(in(of_.dimension, next));
  std::vector<double> step;
  for (int i = 0; i < axes(); ++i)
    for (int j = 0; j < axes(); ++j) step.push_back(g(i, j));
  if (of_.dimension == Dimension::axisymmetric) step.push_back(g(2, 2));
  return step;
}

MaterialPoint::StepResponse MaterialPoint::respond(const std::vector<double>& step) const {
  StepResponse r{std::vector<double>(step.size()), std::vector<double>(step.size() * step.size()), 0, 0};
  LawResponse response{step.data(), r.force.data(), r.tangent.data()};
  response_kernels_->respond(block(), sweep_.drift, response);
  r.inverted = response.inverted;
  r.unsolved = response.unsolved;
  return r;
}

void MaterialPoint::commit(const std::vector<double>& step) {
  Matrix g{};
  const auto n = static_cast<std::size_t>(axes());
  for (std::size_t c = 0; c < n * n; ++c) g(static_cast<int>(c / n), static_cast<int>(c % n)) = step[c];
  if (of_.dimension == Dimension::axisymmetric) g(2, 2) = step[n * n];
  Block all = block();
  response_kernels_->commit(all, sweep_.drift, step.data());
  deformation_ = deformation_ + (of_.total_lagrangian ? g : product(g, deformation_));
}

Stress MaterialPoint::stress() const {
  std::array<double, 6> s{};
  double* const out[6] = {&s[0], &s[1], &s[2], &s[3], &s[4], &s[5]};
  kernels_->stress(block(), out);
  if (of_.dimension == Dimension::bar) return {{s[0], 0, 0}, {}};
  if (of_.dimension == Dimension::solid) return {{s[0], s[1], s[2]}, {s[3], s[4], s[5]}};
  return {{s[0], s[1], s[3]}, {s[2], 0, 0}};
}

Matrix MaterialPoint::virial() const {
  Block all = block();
  kernels_->force(all);
  Matrix force{};
  for (int i = 0; i < axes(); ++i)
    for (int j = 0; j < axes(); ++j) force(i, j) = scratch_->force[i * axes() + j][0];
  if (of_.dimension == Dimension::axisymmetric) force(2, 2) = scratch_->virial_rest[0];
  return of_.total_lagrangian ? product(force, transpose(deformation_)) : force;
}

Matrix MaterialPoint::nominal_stress() const { return product(virial(), inverse(transpose(deformation_))); }

double MaterialPoint::energy() const {
  Totals totals;
  kernels_->measure(block(), totals);
  return totals.strain_energy;
}

double MaterialPoint::squared_wave_speed() const {
  Totals totals;
  kernels_->measure(block(), totals);
  return totals.squared_wave_speed;
}

Matrix matrix(const std::array<double, 9>& rows) {
  Matrix m{};
  for (std::size_t k = 0; k < rows.size(); ++k) m(static_cast<int>(k / 3), static_cast<int>(k % 3)) = rows[k];
  return m;
}

bool has(Dimension dimension, int i, int j) {
  const int axes = grid_axes(dimension);
  return (i < axes && j < axes) || (dimension == Dimension::axisymmetric && i == 2 && j == 2);
}

Matrix in(Dimension dimension, const Matrix& m) {
  Matrix r = identity<3>();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (has(dimension, i, j)) r(i, j) = m(i, j);
  return r;
}

bool turns(Dimension dimension) { return dimension != Dimension::bar && dimension != Dimension::axisymmetric; }

Matrix rotation(Dimension dimension, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Matrix about_z = matrix({c, -s, 0, s, c, 0, 0, 0, 1});
  if (!turns(dimension)) return identity<3>();
  if (dimension != Dimension::solid) return about_z;
  const double a = std::cos(0.8), b = std::sin(0.8);
  const Matrix tilt = product(matrix({1, 0, 0, 0, a, -b, 0, b, a}), matrix({a, 0, b, 0, 1, 0, -b, 0, a}));
  return product(product(tilt, about_z), transpose(tilt));
}

double contraction(const Matrix& a, const Matrix& b) { return double_contraction(a, b); }

double largest_difference(const Stress& a, const Stress& b) {
  double largest = 0;
  for (int k = 0; k < 3; ++k)
    largest = std::max({largest, std::abs(a.diagonal[k] - b.diagonal[k]), std::abs(a.off[k] - b.off[k])});
  return largest;
}

}  // namespace trajan::test
