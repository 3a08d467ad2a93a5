#include "solver/implicit/constraints.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trajan {
namespace {

/// Coefficients that have cancelled but for rounding.
constexpr double cancelled = 1e-12;

}  // namespace

Constraints::Constraints(const Discretization& on, Executor& executor, double from, double to)
    : on_(on), which_(on.unknowns(), -1) {
  executor.conditions().constrain(executor.bodies(), executor.tiles(), from, to, *this, *this);
  for (const Row& row : rows_) {
    eliminate(row);
    homogeneous_ = homogeneous_ && row.value == 0;
  }
  make_expansion();
}

void Constraints::prescribe(std::size_t condition, std::size_t tile, int node, int axis, double displacement) {
  const std::int32_t n = on_.number(tile, node);
  if (n < 0) return;
  rows_.push_back({{{static_cast<std::uint32_t>(n * on_.axes() + axis), 1.0}}, displacement, condition, true});
}

void Constraints::prescribe_mean(std::size_t condition, std::span<const SurfaceNode> nodes, int axis,
                                 double displacement) {
  Row row{{}, displacement, condition};
  for (const SurfaceNode& at : nodes) {
    const std::int32_t n = on_.number(at.tile, static_cast<int>(at.node));
    if (n >= 0 && at.weight != 0)
      row.terms.emplace_back(static_cast<std::uint32_t>(n * on_.axes() + axis), at.weight);
  }
  rows_.push_back(std::move(row));
}

void Constraints::add_reactions(const Eigen::VectorXd& forces, double time, std::span<Reaction> reactions) const {
  std::vector<double> weights(which_.size(), 0.0);
  std::vector<char> held(which_.size(), 0);
  for (const Row& row : rows_)
    for (const auto& [unknown, weight] : row.terms) {
      if (row.of_node) held[unknown] = 1;
      weights[unknown] += row.of_node ? 0 : std::abs(weight);
    }
  for (const Row& row : rows_)
    for (const auto& [unknown, weight] : row.terms) {
      if (held[unknown] && !row.of_node) continue;
      const double share = row.of_node ? 1 : std::abs(weight) / weights[unknown];
      const std::size_t axis = unknown % static_cast<std::size_t>(on_.axes());
      reactions[row.condition].impulse[axis] += time * share * forces[unknown];
    }
}

/// Solves a row for its largest coefficient that is left, and puts that into the rows before it.
void Constraints::eliminate(const Row& row) {
  std::map<std::uint32_t, double> terms;
  double value = row.value, largest = 0;
  for (const auto& [unknown, coefficient] : row.terms) {
    largest = std::max(largest, std::abs(coefficient));
    if (which_[unknown] < 0) {
      terms[unknown] += coefficient;
      continue;
    }
    const Row& known = eliminated_[static_cast<std::size_t>(which_[unknown])];
    value -= coefficient * known.value;
    for (const auto& [other, factor] : known.terms) terms[other] += coefficient * factor;
  }
  const auto pivot = std::max_element(terms.begin(), terms.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) < std::abs(b.second);
  });
  if (pivot == terms.end() || std::abs(pivot->second) <= cancelled * largest) return;
  const std::uint32_t solved = pivot->first;
  Row result{{}, value / pivot->second};
  for (const auto& [unknown, coefficient] : terms)
    if (unknown != solved && std::abs(coefficient) > cancelled * largest)
      result.terms.emplace_back(unknown, -coefficient / pivot->second);
  for (Row& before : eliminated_) {
    const auto at = std::ranges::find(before.terms, solved, &std::pair<std::uint32_t, double>::first);
    if (at == before.terms.end()) continue;
    const double factor = at->second;
    before.terms.erase(at);
    before.value += factor * result.value;
    for (const auto& [unknown, coefficient] : result.terms) {
      const auto same = std::ranges::find(before.terms, unknown, &std::pair<std::uint32_t, double>::first);
      if (same != before.terms.end())
        same->second += factor * coefficient;
      else
        before.terms.emplace_back(unknown, factor * coefficient);
    }
  }
  which_[solved] = static_cast<std::int32_t>(eliminated_.size());
  eliminated_.push_back(std::move(result));
}

Places Constraints::places() const {
  Places places;
  places.reserve(static_cast<std::size_t>(expand_.cols()));
  const auto axes = static_cast<std::size_t>(on_.axes());
  for (std::size_t u = 0; u < which_.size(); ++u) {
    if (which_[u] >= 0) continue;
    Place place{{}, static_cast<std::int32_t>(u % axes)};
    std::ranges::transform(on_.grid_index(u / axes), place.node.begin(),
                           [](std::int64_t index) { return static_cast<std::int32_t>(index); });
    places.push_back(place);
  }
  return places;
}

void Constraints::make_expansion() {
  std::vector<int> column(which_.size(), -1);
  int free = 0;
  for (std::size_t u = 0; u < which_.size(); ++u)
    if (which_[u] < 0) column[u] = free++;
  std::vector<Eigen::Triplet<double>> entries;
  given_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(which_.size()));
  for (std::size_t u = 0; u < which_.size(); ++u) {
    const int row = static_cast<int>(u);
    if (which_[u] < 0) {
      entries.emplace_back(row, column[u], 1.0);
      continue;
    }
    const Row& known = eliminated_[static_cast<std::size_t>(which_[u])];
    given_[row] = known.value;
    for (const auto& [other, factor] : known.terms) entries.emplace_back(row, column[other], factor);
  }
  expand_.resize(static_cast<Eigen::Index>(which_.size()), free);
  expand_.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace trajan
