#include "solver/simulation/coherence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "solver/model/names.h"
#include "solver/schemes/scheme.h"

namespace trajan {
namespace {

/// Finding groups takes as long as a few steps: less than a hundredth of so many.
constexpr std::int64_t steps_between = 500;

/// In cells: particles this far apart in the direction in which they are stretched most leave every third cell
/// empty.
constexpr double widest_gap = 1.5;

/// Of a cell's index along each axis in its key.
constexpr int bits = 21;
constexpr std::uint64_t middle = std::uint64_t{1} << (bits - 1);

bool is_fluid(const Material& material, Dimension dimension) {
  const auto axes = static_cast<std::size_t>(grid_axes(dimension));
  if (axes == 1) return false;
  std::array<double, 9> tensor{};
  material.kind->acoustic_tensor(material.parameters, material.density, dimension, 0, tensor);
  return tensor[axes + 1] == 0;
}

/// The root of a tree of cells, which it makes shorter.
std::size_t root(std::vector<std::size_t>& parent, std::size_t cell) {
  while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
  return cell;
}

/// Cells in order, each with the slot of a particle in it.
using Occupied = std::vector<std::pair<std::uint64_t, std::size_t>>;

/// Index of the first one that is not before `cell`; there is one. `near`: where the search begins. Neighbours of
/// cells in order are in order but for periodic faces, so that mostly it ends there or at the next one.
std::size_t find(const Occupied& cells, std::uint64_t cell, std::size_t near) {
  const auto is_before = [](const auto& a, std::uint64_t b) { return a.first < b; };
  const auto begin = cells.begin(), from = begin + static_cast<std::ptrdiff_t>(near);
  if (from->first > cell) return static_cast<std::size_t>(std::lower_bound(begin, from, cell, is_before) - begin);
  std::size_t step = 1;
  while (near + step < cells.size() && cells[near + step].first < cell) step *= 2;
  const auto to = begin + static_cast<std::ptrdiff_t>(std::min(near + step + 1, cells.size()));
  return static_cast<std::size_t>(std::lower_bound(from, to, cell, is_before) - begin);
}

std::string rounded(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 3);
}

}  // namespace

Coherence::Coherence(const Model& model, const Executor& executor)
    : model_(model), executor_(executor), axes_(grid_axes(model.dimension)) {
  const std::string& shape = model.numerics.shape_functions;
  reach_ = shape == "linear" ? 1 : 2;
  stretches_with_particles_ = shape == "cpgimp" || shape == "cpdi";
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    groups_at_first_.push_back(is_watched(model.bodies[b]) ? groups(executor.bodies()[b]).count : 0);
}

bool Coherence::is_watched(const Body& body) const {
  const Material& material = model_.materials[body.material];
  return !is_total_lagrangian(model_.numerics.scheme) && !material.kind->name.starts_with(damage_prefix) &&
         !is_fluid(material, model_.dimension);
}

Coherence::Cell Coherence::cell_of(const BodyParticles& body, std::size_t slot) const {
  const double origin[] = {model_.grid.origin.x, model_.grid.origin.y, model_.grid.origin.z};
  Cell key = 0;
  for (int axis = 0; axis < axes_; ++axis) {
    const double at = body.component(Attribute::position_x, axis)[slot];
    // A run that goes bad may have lost particles anywhere, also between numbers.
    const double from = std::floor((at - origin[axis]) / model_.grid.cell);
    auto cell = std::abs(from) < static_cast<double>(middle) ? static_cast<std::int64_t>(from) : 0;
    const std::int64_t cells = model_.grid.cells()[static_cast<std::size_t>(axis)];
    if (model_.grid.periodic[static_cast<std::size_t>(axis)]) cell = (cell % cells + cells) % cells;
    key |= (static_cast<Cell>(cell) + middle) << bits * axis;
  }
  return key;
}

Coherence::Groups Coherence::groups(const BodyParticles& body) const {
  // Particles of a cell mostly follow each other: one of them is enough.
  Occupied particles;
  for (std::size_t slot = 0; slot < body.size(); ++slot)
    if (const Cell cell = cell_of(body, slot); particles.empty() || particles.back().first != cell)
      particles.emplace_back(cell, slot);
  std::sort(particles.begin(), particles.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  particles.erase(std::unique(particles.begin(), particles.end(), same), particles.end());
  std::vector<std::size_t> parent(particles.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  // Of two neighbours one sees the other; across a periodic face the one that is first.
  const int side = 2 * reach_ + 1, around = axes_ == 1 ? side : axes_ == 2 ? side * side : side * side * side;
  std::vector<std::size_t> near(static_cast<std::size_t>(around), 0);
  for (std::size_t c = 0; c < particles.size(); ++c)
    for (int n = 0; n < around; ++n) {
      Cell other = 0;
      for (int axis = 0, rest = n; axis < axes_; ++axis, rest /= side) {
        auto cell =
            static_cast<std::int64_t>(particles[c].first >> bits * axis & (2 * middle - 1)) + rest % side - reach_;
        const std::int64_t cells = model_.grid.cells()[static_cast<std::size_t>(axis)];
        const auto first = static_cast<std::int64_t>(middle);
        if (model_.grid.periodic[static_cast<std::size_t>(axis)]) cell = (cell - first + cells) % cells + first;
        other |= static_cast<Cell>(cell) << bits * axis;
      }
      if (other >= particles[c].first) continue;
      std::size_t& found = near[static_cast<std::size_t>(n)];
      found = find(particles, other, found);
      if (particles[found].first == other) parent[root(parent, found)] = root(parent, c);
    }
  std::vector<std::size_t> size(particles.size());
  for (std::size_t c = 0; c < particles.size(); ++c) ++size[root(parent, c)];
  Groups result;
  std::size_t least = particles.size() + 1;
  for (std::size_t c = 0; c < particles.size(); ++c) {
    if (size[c] == 0) continue;
    ++result.count;
    if (size[c] < least) least = size[c], result.slot = particles[c].second;
  }
  return result;
}

std::vector<Warning> Coherence::check(std::int64_t step, double time, bool due) {
  const bool passed = step / steps_between != last_sample_ / steps_between;
  last_sample_ = step;
  std::vector<Warning> all;
  for (std::size_t b = 0; b < groups_at_first_.size(); ++b) {
    if (groups_at_first_[b] == 0) continue;
    std::optional<Warning> found = check_gaps(b);
    if (!found && (passed || due)) found = check_groups(b);
    if (!found) continue;
    groups_at_first_[b] = 0;
    found->step = step;
    found->time = time;
    all.push_back(*found);
  }
  return all;
}

/// Costs no more than a step.
std::optional<Warning> Coherence::check_gaps(std::size_t b) const {
  const BodyParticles& body = executor_.bodies()[b];
  if (stretches_with_particles_ || !body.has(Attribute::deformation_xx)) return std::nullopt;
  double widest = 0;
  std::size_t slot = 0;
  for (std::size_t i = 0; i < body.size(); ++i)
    for (int edge = 0; edge < axes_; ++edge) {
      double square = 0;
      for (int axis = 0; axis < axes_; ++axis)
        square += std::pow(body.value(Attribute::deformation_xx, 3 * axis + edge, i), 2);
      const double apart = 2 * body.constants.half_size[edge] * std::sqrt(square);
      if (apart > widest) widest = apart, slot = i;
    }
  if (!(widest > widest_gap)) return std::nullopt;
  return warning(b, slot,
                 "is stretched until its particles are " + rounded(widest) +
                     " cells apart: there are holes that the shape functions do not see");
}

std::optional<Warning> Coherence::check_groups(std::size_t b) const {
  const Groups now = groups(executor_.bodies()[b]);
  if (now.count <= groups_at_first_[b]) return std::nullopt;
  return warning(b, now.slot,
                 "has come apart into " + std::to_string(now.count) +
                     " pieces that no shape function joins, though its material does not break");
}

Warning Coherence::warning(std::size_t b, std::size_t slot, const std::string& cause) const {
  const BodyParticles& body = executor_.bodies()[b];
  Warning warning;
  warning.name = "coherence of " + quoted(model_.bodies[b].name);
  warning.particle = model_.bodies[b].first_particle + body.number[slot];
  double* const place[] = {&warning.place.x, &warning.place.y, &warning.place.z};
  for (int axis = 0; axis < axes_; ++axis) *place[axis] = body.component(Attribute::position_x, axis)[slot];
  warning.cause = "body " + quoted(model_.bodies[b].name) + " " + cause;
  warning.remedy =
      "what follows is no longer its motion: choose numerics.scheme: \"TLMPM\", numerics.shape_functions: "
      "\"cpdi\" or more "
      "particles_per_cell_side";
  return warning;
}

}  // namespace trajan
