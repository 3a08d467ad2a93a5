#include "solver/simulation/sweeps.h"

#include <algorithm>
#include <iterator>

#include "solver/schemes/share_dilatation.h"

namespace trajan {
namespace {

std::vector<Stage> joined(std::initializer_list<std::vector<Stage>> lists) {
  std::vector<Stage> all;
  for (const std::vector<Stage>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Without those that are nullptr.
std::vector<Stage> present(std::initializer_list<Stage> stages) {
  std::vector<Stage> all;
  std::ranges::copy_if(stages, std::back_inserter(all), [](Stage stage) { return stage != nullptr; });
  return all;
}

/// Of the step's drift by which laws deform.
void take_half(Block& block) { block.scratch->deform_share = 0.5; }
void take_whole(Block& block) { block.scratch->deform_share = 1; }

/// Whether a pass needs what the transfer finds where particles are.
bool is_of_transfer(Pass pass) {
  using enum Pass;
  return pass == scatter_state || pass == update_velocity || pass == kick || pass == scatter_momentum ||
         pass == scatter_motion;
}

bool needs_slopes(Pass pass) {
  using enum Pass;
  return pass == begin || pass == scatter_state || pass == gather_gradient || pass == gather_motion;
}

struct NamedStage {
  Stage stage;
  const char* name;
};

const char* name_among(std::initializer_list<NamedStage> known, Stage stage) {
  for (const NamedStage& one : known)
    if (one.stage == stage) return one.name;
  return nullptr;
}

}  // namespace

Sweeps::Sweeps(const Model& model, const Transfer& kind, const TransferKernels& transfer, int sum_quantities)
    : model_(model),
      axes_(grid_axes(model.dimension)),
      motion_(kernels().grid(model.numerics).motion[axes_ - 1]),
      kind_(kind),
      transfer_(&transfer),
      transfer_passes_(kind.passes(transfer, motion_, model.numerics)),
      sum_quantities_(sum_quantities),
      loads_(!model.body_loads.empty()) {}

std::vector<Stage> Sweeps::stages_of(Pass pass, const BodyParticles& body, std::size_t index) const {
  const bool hoop = model_.dimension == Dimension::axisymmetric;
  const auto only_if = [](bool wanted, Stage stage) { return wanted ? stage : nullptr; };
  const TransferPasses& transfer = transfer_passes_;
  const LawExchangeKernels& exchange = motion_.law_exchange;
  switch (pass) {
    case Pass::begin:
      return transfer.begin.stages;
    case Pass::locate:
      return {};  // see `locating`
    case Pass::force:
      if (body.narrow && body.law->in_floats.force) return {body.law->in_floats.force};
      return present({exchange.widen_state, body.law->force, exchange.narrow_force});
    case Pass::scatter_state:
      return joined({transfer.scatter_state.stages,
                     present({only_if(hoop, transfer_->scatter_hoop), only_if(loads_, motion_.find_loads),
                              only_if(loads_, transfer_->scatter_loads)})});
    case Pass::update_velocity:
      return transfer.update_velocity.stages;
    case Pass::kick:
      return transfer.kick.stages;
    case Pass::remap:
      return {transfer_->remap};
    case Pass::scatter_momentum:
      return transfer.scatter_momentum.stages;
    case Pass::scatter_motion:
      return joined({{transfer_->scatter_mass}, transfer.scatter_momentum.stages});
    case Pass::gather_velocity:
      return {transfer.takes_grid_velocity ? motion_.own_velocity : transfer_->gather_velocity};
    case Pass::gather_gradient:
      return present({transfer_->gather_gradient, only_if(hoop, transfer_->gather_hoop)});
    case Pass::gather_motion:
      if (transfer.takes_grid_velocity)
        return joined(
            {stages_of(Pass::gather_gradient, body, index), stages_of(Pass::gather_velocity, body, index)});
      return present({transfer_->gather_motion, only_if(hoop, transfer_->gather_hoop)});
    case Pass::move:
      return {motion_.move};
    case Pass::displace:
      return {motion_.displace};
    case Pass::deform:
      return deform_stages(body, index);
    case Pass::deform_by_half:
      return joined({{take_half}, deform_stages(body, index), {take_whole}});
  }
  return {};
}

Stage Sweeps::sharing(std::size_t body) const {
  if (model_.numerics.locking_remedy == "none") return nullptr;
  return share_dilatation(model_.materials[model_.bodies[body].material].kind->name, model_.dimension);
}

std::vector<Stage> Sweeps::deform_stages(const BodyParticles& body, std::size_t index) const {
  const LawExchangeKernels& exchange = motion_.law_exchange;
  const Stage track = body.carries(Attribute::deformation_xx) ? body.law->track : nullptr;
  if (body.narrow && body.law->in_floats.deform && !track && !sharing(index)) return {body.law->in_floats.deform};
  return present({exchange.widen_state, exchange.widen_gradient, sharing(index), body.law->deform, track,
                  exchange.narrow_state});
}

unsigned Sweeps::gathered(Pass pass) const {
  switch (pass) {
    case Pass::update_velocity:
      return transfer_passes_.update_velocity.gathered;
    case Pass::kick:
      return transfer_passes_.kick.gathered;
    case Pass::remap:
      return 1u << node_remainder;
    case Pass::gather_velocity:
      return transfer_passes_.takes_grid_velocity ? 0 : 1u << node_velocity;
    case Pass::gather_gradient:
      return 1u << node_mapped_velocity;
    case Pass::gather_motion:
      return gathered(Pass::gather_velocity) | gathered(Pass::gather_gradient);
    default:
      return 0;
  }
}

bool Sweeps::relocates(Pass pass) const {
  const bool deforms = pass == Pass::deform || pass == Pass::deform_by_half;
  return pass == Pass::move || (deforms && transfer_->needs_deformation);
}

Stage Sweeps::locating(std::span<const Pass> next) const {
  for (Pass pass : next) {
    if (needs_slopes(pass)) return transfer_->locate;
    if (relocates(pass)) break;
  }
  return kind_.affine ? transfer_->affine.locate_values : transfer_->locate_values;
}

Sweep& Sweeps::of(std::span<const Pass> passes, const std::vector<BodyParticles>& bodies) {
  for (const auto& known : sweeps_)
    if (std::ranges::equal(known->passes, passes)) return *known;
  auto sweep = std::make_unique<Sweep>();
  sweep->passes.assign(passes.begin(), passes.end());
  for (Pass pass : passes) {
    for (int vector = 0; vector < kind_.node_vectors; ++vector)
      if (gathered(pass) >> vector & 1u) sweep->mask |= ((1u << axes_) - 1) << quantity(vector, 0, axes_);
    if (pass == Pass::scatter_state) sweep->sums = sum_quantities_;
    if (pass == Pass::scatter_motion) sweep->sums = quantities(1, axes_);
    if (pass == Pass::scatter_momentum || pass == Pass::remap) {
      sweep->first_sum = quantity(sum_momentum, 0, axes_);
      sweep->sums = axes_;
    }
  }
  resolve(*sweep, bodies);
  sweeps_.push_back(std::move(sweep));
  return *sweeps_.back();
}

void Sweeps::use(const TransferKernels& transfer, const std::vector<BodyParticles>& bodies) {
  transfer_ = &transfer;
  transfer_passes_ = kind_.passes(transfer, motion_, model_.numerics);
  for (const auto& sweep : sweeps_) resolve(*sweep, bodies);
}

void Sweeps::resolve(Sweep& sweep, const std::vector<BodyParticles>& bodies) const {
  const std::span<const Pass> passes = sweep.passes;
  sweep.stages.clear();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::vector<Stage>& stages = sweep.stages.emplace_back();
    // Not twice in one place: by TLMPM in a plane 4.5 -> 3.4 ns per particle and step. What the transfer finds
    // there besides only before its own passes: by a profile of APIC in a plane 2 ns less.
    bool located = false, found = false;
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const Pass pass = passes[k];
      if (pass == Pass::locate && located) continue;
      if (pass == Pass::locate) stages.push_back(locating(passes.subspan(k + 1)));
      if (is_of_transfer(pass) && !found) {
        for (Stage stage : transfer_passes_.locate.stages) stages.push_back(stage);
        found = true;
      }
      for (Stage stage : stages_of(pass, bodies[b], b)) stages.push_back(stage);
      located = pass == Pass::locate || (located && !relocates(pass));
      found = found && pass != Pass::locate && !relocates(pass);
    }
  }
}

std::string Sweeps::name(Stage stage, const BodyParticles& body, std::size_t index) const {
  const std::string_view law = model_.materials[model_.bodies[index].material].kind->name;
  const AffineKernels& affine = transfer_->affine;
  if (const char* of_law = name_among({{body.law->force, "force"},
                                       {body.law->deform, "deform"},
                                       {body.law->in_floats.force, "force in floats"},
                                       {body.law->in_floats.deform, "deform in floats"},
                                       {body.law->track, "track deformation"},
                                       {sharing(index), "share dilatation"}},
                                      stage))
    return std::string(of_law) + " (" + std::string(law) + ")";
  const char* name = name_among({{transfer_->locate, "locate"},
                                 {transfer_->locate_values, "locate, values alone"},
                                 {affine.locate_values, "locate, values alone"},
                                 {transfer_->scatter_state, "scatter mass, momentum, force"},
                                 {transfer_->scatter_hoop, "scatter hoop force"},
                                 {transfer_->scatter_loads, "scatter loads"},
                                 {transfer_->scatter_mass, "scatter mass"},
                                 {transfer_->scatter_momentum, "scatter momentum"},
                                 {transfer_->gather_acceleration, "gather acceleration"},
                                 {transfer_->gather_velocity, "gather velocity"},
                                 {transfer_->gather_gradient, "gather gradient"},
                                 {transfer_->gather_motion, "gather velocity, gradient"},
                                 {transfer_->gather_hoop, "gather hoop strain rate"},
                                 {transfer_->gather_projected, "gather projected velocity"},
                                 {transfer_->remap, "remap"},
                                 {affine.find_levers, "find levers"},
                                 {affine.begin, "begin affine velocity"},
                                 {affine.scatter_state, "scatter mass, affine momentum, force"},
                                 {affine.scatter_momentum, "scatter affine momentum"},
                                 {affine.gather, "gather affine velocity"},
                                 {affine.kick, "kick affine velocity"},
                                 {motion_.find_loads, "find loads"},
                                 {motion_.kick, "kick"},
                                 {motion_.kick_and_blend, "kick and blend"},
                                 {motion_.move, "move"},
                                 {motion_.displace, "displace"},
                                 {motion_.take_velocity, "take velocity"},
                                 {motion_.own_velocity, "own velocity"},
                                 {motion_.law_exchange.widen_state, "widen"},
                                 {motion_.law_exchange.widen_gradient, "widen gradient"},
                                 {motion_.law_exchange.narrow_state, "narrow"},
                                 {motion_.law_exchange.narrow_force, "narrow force"},
                                 {take_half, "half a step"},
                                 {take_whole, "whole step"}},
                                stage);
  return name ? name : "";
}

}  // namespace trajan
