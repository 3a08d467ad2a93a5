#include "solver/implicit/assembly.h"

#include <algorithm>

namespace trajan {
namespace {

/// Lists of what touches each node: counts first, then places.
template <class Elements, class Incidence>
void collect(std::size_t nodes, std::size_t elements, Elements&& nodes_of, std::vector<std::size_t>& first,
             std::vector<Incidence>& incidences) {
  first.assign(nodes + 1, 0);
  for (std::size_t e = 0; e < elements; ++e)
    for (std::uint32_t n : nodes_of(e)) ++first[n + 1];
  for (std::size_t n = 0; n < nodes; ++n) first[n + 1] += first[n];
  incidences.resize(first.back());
  std::vector<std::size_t> at(first.begin(), first.end() - 1);
  for (std::size_t e = 0; e < elements; ++e) {
    std::uint32_t place = 0;
    for (std::uint32_t n : nodes_of(e)) incidences[at[n]++] = {static_cast<std::uint32_t>(e), place++};
  }
}

/// Adds to the columns of the particle's node of number b what its displacement makes of the forces at all its
/// nodes.
template <std::size_t axes, bool axisymmetric>
void add_stiffness(const Discretization::Particle& particle, const double* tangent, std::uint32_t b,
                   const std::vector<int>& place, double* const* column) {
  constexpr std::size_t count = axes * axes + (axisymmetric ? 1 : 0);
  const double* slope = particle.gradients + b * axes;
  // The change of forces by the node's displacement along k.
  double change[axes][count] = {};
  for (std::size_t k = 0; k < axes; ++k)
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t l = 0; l < axes; ++l) change[k][r] += tangent[r * count + k * axes + l] * slope[l];
      if (k == 0 && axisymmetric)
        change[k][r] += tangent[r * count + axes * axes] * particle.weights[b] * particle.inverse_radius;
    }
  for (std::size_t a = 0; a < particle.nodes.size(); ++a) {
    const double* test = particle.gradients + a * axes;
    const int at = place[particle.nodes[a]];
    for (std::size_t k = 0; k < axes; ++k) {
      for (std::size_t r = 0; r < axes; ++r) {
        double sum = column[k][static_cast<std::size_t>(at) + r];
        for (std::size_t j = 0; j < axes; ++j) sum += test[j] * change[k][r * axes + j];
        column[k][static_cast<std::size_t>(at) + r] = sum;
      }
      if constexpr (axisymmetric)
        column[k][at] += particle.weights[a] * particle.inverse_radius * change[k][axes * axes];
    }
  }
}

}  // namespace

Assembly::Assembly(const Discretization& on, const GhostPenalty& ghost, ThreadPool& pool)
    : on_(on), ghost_(ghost), pool_(pool) {
  collect(
      on.nodes(), on.particles(), [&](std::size_t p) { return on.particle(p).nodes; }, first_incidence_,
      incidences_);
  collect(
      on.nodes(), ghost.differences().size(),
      [&](std::size_t d) { return std::span<const std::uint32_t>(ghost.differences()[d].nodes); }, first_ghost_,
      ghosts_);
  find_neighbours();
}

void Assembly::find_neighbours() {
  first_neighbour_.assign(1, 0);
  std::vector<std::uint32_t> last_seen(on_.nodes(), static_cast<std::uint32_t>(-1));
  for (std::uint32_t n = 0; n < on_.nodes(); ++n) {
    const auto see = [&](std::span<const std::uint32_t> nodes) {
      for (std::uint32_t other : nodes)
        if (last_seen[other] != n) neighbours_.push_back(other), last_seen[other] = n;
    };
    for (std::size_t i = first_incidence_[n]; i < first_incidence_[n + 1]; ++i)
      see(on_.particle(incidences_[i].element).nodes);
    for (std::size_t i = first_ghost_[n]; i < first_ghost_[n + 1]; ++i)
      see(ghost_.differences()[ghosts_[i].element].nodes);
    std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(first_neighbour_.back()), neighbours_.end());
    first_neighbour_.push_back(neighbours_.size());
  }
  neighbours_.shrink_to_fit();
}

void Assembly::begin(SparseMatrix& out) const {
  const auto axes = static_cast<std::size_t>(on_.axes());
  const auto size = static_cast<Eigen::Index>(on_.unknowns());
  out.resize(size, size);
  out.resizeNonZeros(static_cast<Eigen::Index>(neighbours_.size() * axes * axes));
  int* outer = out.outerIndexPtr();
  int* inner = out.innerIndexPtr();
  std::size_t entry = 0;
  for (std::size_t n = 0; n < on_.nodes(); ++n)
    for (std::size_t k = 0; k < axes; ++k) {
      outer[n * axes + k] = static_cast<int>(entry);
      for (std::size_t q = first_neighbour_[n]; q < first_neighbour_[n + 1]; ++q)
        for (std::size_t i = 0; i < axes; ++i) inner[entry++] = static_cast<int>(neighbours_[q] * axes + i);
    }
  outer[size] = static_cast<int>(entry);
  std::fill_n(out.valuePtr(), entry, 0.0);
}

/// Calls of(node, place of each of its neighbours' blocks in a column, by node).
template <class Column>
void Assembly::for_each_column(Column&& of) const {
  const auto axes = static_cast<std::size_t>(on_.axes());
  const auto threads = static_cast<std::size_t>(pool_.size());
  pool_.run([&](int thread) {
    std::vector<int> place(on_.nodes());
    const auto t = static_cast<std::size_t>(thread);
    for (std::size_t n = on_.nodes() * t / threads; n < on_.nodes() * (t + 1) / threads; ++n) {
      for (std::size_t q = first_neighbour_[n]; q < first_neighbour_[n + 1]; ++q)
        place[neighbours_[q]] = static_cast<int>((q - first_neighbour_[n]) * axes);
      of(n, place);
    }
  });
}

void Assembly::stiffness(const std::vector<double>& tangents, SparseMatrix& out) const {
  begin(out);
  const auto axes = static_cast<std::size_t>(on_.axes()), count = static_cast<std::size_t>(on_.components());
  const auto add = on_.axisymmetric() ? &add_stiffness<2, true>
                   : axes == 1        ? &add_stiffness<1, false>
                   : axes == 2        ? &add_stiffness<2, false>
                                      : &add_stiffness<3, false>;
  for_each_column([&](std::size_t node, const std::vector<int>& place) {
    double* column[3] = {};
    for (std::size_t k = 0; k < axes; ++k) column[k] = out.valuePtr() + out.outerIndexPtr()[node * axes + k];
    for (std::size_t i = first_incidence_[node]; i < first_incidence_[node + 1]; ++i) {
      const auto [p, b] = incidences_[i];
      add(on_.particle(p), &tangents[p * count * count], b, place, column);
    }
    for (std::size_t i = first_ghost_[node]; i < first_ghost_[node + 1]; ++i) {
      const auto [d, b] = ghosts_[i];
      const GhostPenalty::Difference& difference = ghost_.differences()[d];
      for (std::size_t a = 0; a < difference.nodes.size(); ++a)
        for (std::size_t k = 0; k < axes; ++k)
          column[k][static_cast<std::size_t>(place[difference.nodes[a]]) + k] +=
              difference.stiffness * difference.coefficients[a] * difference.coefficients[b];
    }
  });
}

void Assembly::mass(bool lumped, SparseMatrix& out) const {
  begin(out);
  const auto axes = static_cast<std::size_t>(on_.axes());
  for_each_column([&](std::size_t node, const std::vector<int>& place) {
    for (std::size_t i = first_incidence_[node]; i < first_incidence_[node + 1]; ++i) {
      const auto [p, b] = incidences_[i];
      const Discretization::Particle particle = on_.particle(p);
      const double mass = on_.mass(p) * particle.weights[b];
      for (std::size_t a = 0; a < particle.nodes.size(); ++a) {
        const std::size_t row = static_cast<std::size_t>(place[lumped ? node : particle.nodes[a]]);
        for (std::size_t k = 0; k < axes; ++k)
          out.valuePtr()[static_cast<std::size_t>(out.outerIndexPtr()[node * axes + k]) + row + k] +=
              mass * particle.weights[a];
      }
    }
  });
}

void Assembly::add_forces(const std::vector<double>& forces, std::span<const double> displacement,
                          std::span<double> out) const {
  const auto axes = static_cast<std::size_t>(on_.axes()), count = static_cast<std::size_t>(on_.components());
  for_each_column([&](std::size_t node, const std::vector<int>&) {
    double* force = &out[node * axes];
    for (std::size_t i = first_incidence_[node]; i < first_incidence_[node + 1]; ++i) {
      const auto [p, b] = incidences_[i];
      const Discretization::Particle particle = on_.particle(p);
      const double* of_particle = &forces[p * count];
      const double* slope = particle.gradients + b * axes;
      for (std::size_t k = 0; k < axes; ++k)
        for (std::size_t j = 0; j < axes; ++j) force[k] += of_particle[k * axes + j] * slope[j];
      if (on_.axisymmetric()) force[0] += of_particle[axes * axes] * particle.weights[b] * particle.inverse_radius;
    }
    for (std::size_t i = first_ghost_[node]; i < first_ghost_[node + 1]; ++i) {
      const auto [d, b] = ghosts_[i];
      const GhostPenalty::Difference& difference = ghost_.differences()[d];
      for (std::size_t a = 0; a < difference.nodes.size(); ++a)
        for (std::size_t k = 0; k < axes; ++k)
          force[k] += difference.stiffness * difference.coefficients[a] * difference.coefficients[b] *
                      displacement[difference.nodes[a] * axes + k];
    }
  });
}

}  // namespace trajan
