#include "tests/conformance/material_point.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace trajan::test {

std::string name_of(const LawCase& of) {
  const std::string dimension = of.dimension == Dimension::plane_stress ? "plane_stress" : "plane_strain";
  return std::string(of.kind->name) + "_" + dimension + (of.total_lagrangian ? "_total" : "_updated");
}

std::ostream& operator<<(std::ostream& out, const LawCase& of) { return out << name_of(of); }

std::vector<LawCase> all_laws() {
  std::vector<LawCase> cases;
  for (const MaterialKind& kind : material_kinds())
    for (Dimension dimension : {Dimension::plane_stress, Dimension::plane_strain})
      for (bool total_lagrangian : {false, true}) cases.push_back({&kind, dimension, total_lagrangian});
  return cases;
}

std::vector<LawCase> hyperelastic_laws() {
  std::vector<LawCase> cases;
  for (const LawCase& of : all_laws())
    if (!kernels().law(of.kind->name, of.dimension, of.total_lagrangian)->rate_form) cases.push_back(of);
  return cases;
}

std::vector<std::vector<double>> sample_parameters(const MaterialKind& kind) {
  static const std::map<std::string_view, std::vector<double>> samples = {
      {"youngs_modulus", {1000}}, {"poissons_ratio", {0, 0.3, 0.45, -0.3}}};
  std::vector<std::vector<double>> sets = {{}};
  for (const Parameter& parameter : kind.parameters) {
    const auto found = samples.find(parameter.name);
    if (found == samples.end())
      throw std::invalid_argument("give values to test parameter " + std::string(parameter.name) + " with");
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& set : sets)
      for (double value : found->second) {
        longer.push_back(set);
        longer.back().push_back(value);
      }
    sets = longer;
  }
  return sets;
}

double value_of(const MaterialKind& kind, const std::vector<double>& parameters, std::string_view name) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (kind.parameters[i].name == name) return parameters[i];
  throw std::invalid_argument(std::string(kind.name) + " has no parameter " + std::string(name));
}

MaterialPoint::MaterialPoint(const LawCase& of, const std::vector<double>& parameters, double density)
    : of_(of),
      kernels_(kernels().law(of.kind->name, of.dimension, of.total_lagrangian)),
      law_(kernels_->make(parameters.data(), of.dimension)),
      scratch_(std::make_shared<Scratch>()) {
  body_.mass = density;
  body_.reference_volume = 1;
  body_.law = law_.get();
  sweep_.inverse_cell = 1;
  sweep_.drift = 1;
  for (Attribute one : {Attribute::volume, Attribute::deformation_xx, Attribute::deformation_yy})
    state_[static_cast<std::size_t>(one)].fill(1);
}

Block MaterialPoint::block() const {
  Block block;
  block.count = 1;
  for (int a = 0; a < attribute_count; ++a) block.arrays[a] = state_[a].data();
  block.body = &body_;
  block.sweep = &sweep_;
  block.scratch = scratch_.get();
  return block;
}

void MaterialPoint::deform(const Tensor& next) {
  const Tensor change = next - deformation_;
  const Tensor g = of_.total_lagrangian ? change : product(change, inverse(deformation_));
  scratch_->gradient[0][0] = g.xx;
  scratch_->gradient[1][0] = g.xy;
  scratch_->gradient[2][0] = g.yx;
  scratch_->gradient[3][0] = g.yy;
  Block all = block();
  kernels_->deform(all);
  deformation_ = next;
}

std::array<double, 4> MaterialPoint::stress() const {
  std::array<double, 4> stress;
  double* const out[4] = {&stress[0], &stress[1], &stress[2], &stress[3]};
  kernels_->stress(block(), out);
  return stress;
}

Tensor MaterialPoint::virial() const {
  Block all = block();
  kernels_->force(all);
  const Tensor force{scratch_->force[0][0], scratch_->force[1][0], scratch_->force[2][0], scratch_->force[3][0]};
  return of_.total_lagrangian ? product(force, transpose(deformation_)) : force;
}

Tensor MaterialPoint::nominal_stress() const { return product(virial(), inverse(transpose(deformation_))); }

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

Tensor rotation(double angle) { return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)}; }

}  // namespace trajan::test
