#include "solver/boundaries/prescribed_nodes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "solver/model/geometry.h"

namespace trajan {
namespace {

/// Regions catch nodes to this many cell sizes, as boundaries.proto says.
constexpr double caught_within = 1e-9;

/// The rate of a displacement is taken over this share of the time between samples: its error is of second
/// order in that, and rounding adds 1e-10.
constexpr double rate_step = 1e-6;

bool contains(const NodeRegion& region, const GridFrame& frame, std::int64_t i, std::int64_t j, std::int64_t k) {
  if (i < region.i0 || i > region.i1 || j < region.j0 || j > region.j1 || k < region.k0 || k > region.k1)
    return false;
  if (!region.shape) return true;
  const Vector at = frame.place(i, j, k);
  const Spans row = spans(*region.shape, at.y, at.z, caught_within * frame.cell);
  return std::ranges::any_of(row, [&](const Span& span) { return span.from <= at.x && at.x <= span.to; });
}

/// The first node along a periodic axis is the last one too.
bool contains(const NodeRegion& region, const GridFrame& frame, const TileNodes& tile, int node) {
  const std::int64_t at[] = {tile.index(node, 0), tile.index(node, 1), tile.index(node, 2)};
  std::int64_t again[3];
  for (int axis = 0; axis < 3; ++axis) again[axis] = at[axis] == 0 ? frame.period[axis] : 0;
  for (std::int64_t k : {at[2], at[2] + again[2]})
    for (std::int64_t j : {at[1], at[1] + again[1]})
      for (std::int64_t i : {at[0], at[0] + again[0]})
        if (contains(region, frame, i, j, k)) return true;
  return false;
}

bool may_touch(const NodeRegion& region, const GridFrame& frame, const TileNodes& tile) {
  const std::int64_t lowest[] = {region.i0, region.j0, region.k0}, highest[] = {region.i1, region.j1, region.k1};
  for (int axis = 0; axis < tile.dimensions; ++axis) {
    const bool again = tile.first[axis] == 0 && frame.period[axis] > 0 && highest[axis] == frame.period[axis];
    if (again) continue;
    if (tile.first[axis] > highest[axis] || tile.index(TileNodes::count - 1, axis) < lowest[axis]) return false;
  }
  return true;
}

bool is_zero(const std::optional<Formula>& formula) {
  return !formula || formula->text().find_first_not_of(" 0.") == std::string::npos;
}

}  // namespace

double rate_of(const Formula& displacement, Vector at, double t, double step, double end) {
  const double from = std::max(0.0, t - step), to = std::min(end, t + step);
  return (displacement(at, to) - displacement(at, from)) / (to - from);
}

PrescribedVelocities::PrescribedVelocities(const Model& model)
    : end_(model.end_time), step_(rate_step * model.end_time / static_cast<double>(model.outputs.samples)) {}

PrescribedVelocities::Value PrescribedVelocities::of(const Formula& formula, bool displacement, Vector at,
                                                     const Kick& kick) const {
  double before, after;
  if (displacement) {
    const auto mean = [&](double from, double to) { return (formula(at, to) - formula(at, from)) / (to - from); };
    const double last_drift = 2 * (kick.time - kick.before);
    before =
        last_drift > 0 ? mean(kick.time - last_drift, kick.time) : rate_of(formula, at, kick.time, step_, end_);
    after =
        kick.drift > 0 ? mean(kick.time, kick.time + kick.drift) : rate_of(formula, at, kick.time, step_, end_);
  } else {
    before = formula(at, kick.before);
    after = formula(at, kick.after);
  }
  return {after, (after - before) / kick.length()};
}

void PrescribedNodes::make(const Model& model, std::vector<std::unique_ptr<Condition>>& conditions) {
  const auto is_motion = [](const BoundaryCondition& c) {
    return std::holds_alternative<PrescribedMotion>(c.kind);
  };
  if (std::ranges::any_of(model.conditions, is_motion))
    conditions.push_back(std::make_unique<PrescribedNodes>(model));
}

PrescribedNodes::PrescribedNodes(const Model& model) : frame_(model), velocities_(model) {
  for (std::size_t i = 0; i < model.conditions.size(); ++i) {
    const auto* motion = std::get_if<PrescribedMotion>(&model.conditions[i].kind);
    if (!motion) continue;
    motions_.push_back(motion);
    conditions_.push_back(i);
    for (const std::optional<Formula>& component : motion->components) works_ = works_ || !is_zero(component);
  }
}

void PrescribedNodes::bind(std::span<const TileNodes> tiles, HeldComponents& held) {
  targets_.clear();
  for (std::size_t m = 0; m < motions_.size(); ++m)
    for (const std::optional<Formula>& formula : motions_[m]->components)
      targets_.push_back({conditions_[m],
                          formula && formula->uniform() ? &*formula : nullptr,
                          motions_[m]->displacement,
                          {},
                          {}});
  entries_.clear();
  first_.assign(1, 0);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (std::ranges::any_of(motions_, [&](const auto* m) { return may_touch(m->nodes, frame_, tiles[t]); }))
      for (int node = 0; node < TileNodes::count; ++node)
        bind_node(tiles[t], node, held[t * TileNodes::count + static_cast<std::size_t>(node)]);
    first_.push_back(static_cast<std::uint32_t>(entries_.size()));
  }
}

void PrescribedNodes::bind_node(const TileNodes& tile, int node, std::uint8_t& held) {
  std::array<int, 3> last = {-1, -1, -1};  // later motions win
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    if (!contains(motions_[m]->nodes, frame_, tile, node)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (motions_[m]->components[axis]) last[axis] = static_cast<int>(m);
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(frame_.dimensions); ++axis) {
    if (last[axis] < 0) continue;
    const auto m = static_cast<std::size_t>(last[axis]);
    const Formula& formula = *motions_[m]->components[axis];
    std::size_t target = 3 * m + axis;
    if (!formula.uniform()) {
      target = targets_.size();
      targets_.push_back({conditions_[m], &formula, motions_[m]->displacement, frame_.place(tile, node), {}});
    }
    held = static_cast<std::uint8_t>(held | 1u << axis);
    entries_.push_back(
        {static_cast<std::uint32_t>(target), static_cast<std::uint8_t>(axis), static_cast<std::uint8_t>(node)});
  }
}

void PrescribedNodes::prepare(const Kick& kick) {
  kick_ = kick;
  for (Target& target : targets_)
    if (target.formula) target.value = velocities_.of(*target.formula, target.displacement, target.at, kick);
}

void PrescribedNodes::act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) {
  for (const Entry& entry : entries_of(tile)) {
    const PrescribedVelocities::Value& v = targets_[entry.target].value;
    Reaction& reaction = reactions[targets_[entry.target].condition];
    double& a = nodes.acceleration(entry.axis)[entry.node];
    const double impulse = kick_.length() * nodes.mass()[entry.node] * (v.acceleration - a);
    reaction.work += impulse * (v.after - 0.5 * kick_.length() * v.acceleration);
    reaction.impulse[entry.axis] += impulse;
    a = v.acceleration;
    nodes.velocity(entry.axis)[entry.node] = v.after;
  }
}

void PrescribedNodes::act_on_mapped(std::size_t tile, const TileNodes& nodes) const {
  for (const Entry& entry : entries_of(tile))
    nodes.mapped_velocity(entry.axis)[entry.node] = targets_[entry.target].value.after;
}

/// Of a velocity the integral by Simpson's rule.
void PrescribedNodes::constrain(double from, double to, DisplacementConstraints& constraints) const {
  const auto displacement = [&](const Target& target) {
    const auto value = [&](double time) { return (*target.formula)(target.at, time); };
    if (target.displacement) return value(to) - value(from);
    return (to - from) / 6 * (value(from) + 4 * value(0.5 * (from + to)) + value(to));
  };
  for (std::size_t tile = 0; tile + 1 < first_.size(); ++tile)
    for (const Entry& entry : entries_of(tile))
      constraints.prescribe(targets_[entry.target].condition, tile, entry.node, entry.axis,
                            displacement(targets_[entry.target]));
}

}  // namespace trajan
