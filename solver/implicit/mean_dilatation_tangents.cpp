#include <algorithm>
#include <array>
#include <cassert>

#include "solver/implicit/mean_dilatation.h"

/// The derivatives of the energy in which particles share their volume ratio.
namespace trajan {
namespace {

/// By the gradient H of a particle, and then by the shared ratio.
template <Dimension D>
using Variable = Dual<VolumeSharing<D>::components + 1>;

/// The first derivatives of a particle's energy and ratio.
template <Dimension D>
struct Share {
  typename VolumeSharing<D>::template Slopes<Variable<D>> energy;
  Tensor<VolumeSharing<D>::N, Variable<D>> ratio_slope;
};

/// From the law's force and tangent at what it feels.
template <Dimension D>
Share<D> share_of(const VolumeSharing<D>& sharing, const Tensor<VolumeSharing<D>::N>& end, double shared,
                  const double* force, const double* tangent) {
  constexpr int N = VolumeSharing<D>::N, n = VolumeSharing<D>::components;
  using Number = Variable<D>;
  Tensor<N, Number> h = cast<Number>(end), f{};
  for (int c = 0; c < n; ++c) sharing.component(h, c).slope[c] = 1;
  const Number common(shared, n);
  Tensor<N, Number> felt = sharing.felt(h, common);
  for (int c = 0; c < n; ++c) {
    Number& component = sharing.component(f, c);
    component = Number(force[c]);
    for (int e = 0; e < n; ++e)
      for (int v = 0; v <= n; ++v) component.slope[v] += tangent[c * n + e] * sharing.component(felt, e).slope[v];
  }
  return {sharing.slopes(h, common, f), sharing.ratio_slope(h)};
}

/// Adds the nodes' share of values by components of a particle's displacement gradient.
void scatter(const Discretization& on, std::size_t p, const double* values, double* out) {
  const auto axes = static_cast<std::size_t>(on.axes());
  const Discretization::Particle particle = on.particle(p);
  for (std::size_t k = 0; k < particle.nodes.size(); ++k) {
    for (std::size_t i = 0; i < axes; ++i)
      for (std::size_t j = 0; j < axes; ++j)
        out[k * axes + i] += values[i * axes + j] * particle.gradients[k * axes + j];
    if (on.axisymmetric()) out[k * axes] += values[axes * axes] * particle.weights[k] * particle.inverse_radius;
  }
}

}  // namespace

void MeanDilatation::pull(const Discretization& on, std::vector<double>& forces, std::vector<double>& tangents) {
  const std::size_t values = on.first_node(on.cells()) * static_cast<std::size_t>(on.axes());
  for (std::vector<double>* of_nodes : {&ratio_slopes_, &couplings_, &counter_couplings_})
    of_nodes->assign(values, 0.0);
  for_each_cell(on, [&]<Dimension D>(std::size_t c) { pull_cell<D>(on, c, forces, tangents); });
}

template <Dimension D>
void MeanDilatation::pull_cell(const Discretization& on, std::size_t c, std::vector<double>& forces,
                               std::vector<double>& tangents) {
  using Sharing = VolumeSharing<D>;
  constexpr std::size_t n = Sharing::components;
  Shared& shared = shared_[c];
  std::vector<Share<D>> shares;
  double pressure = 0;  // derivative of the cell's energy by the shared ratio
  shared.curvature = 0;
  for (std::uint32_t p : on.members(c)) {
    const Sharing sharing{particles_[p].linear, particles_[p].factor};
    const auto end = Sharing::read(&end_[p * n], identity<Sharing::N>());
    shares.push_back(share_of<D>(sharing, end, shared.ratio, &forces[p * n], &tangents[p * n * n]));
    pressure += shares.back().energy.by_shared.value;
    shared.curvature += shares.back().energy.by_shared.slope[n];
  }
  const std::size_t first = on.first_node(c) * static_cast<std::size_t>(on.axes());
  for (std::size_t m = 0; m < shares.size(); ++m) {
    const std::size_t p = on.members(c)[m];
    auto& [energy, ratio_slope] = shares[m];
    std::array<double, n> of_ratio, coupling, counter_coupling;
    for (std::size_t i = 0; i < n; ++i) {
      const int place = static_cast<int>(i);
      const Variable<D> force = Sharing::component(energy.by_gradient, place);
      const Variable<D> slope = (particles_[p].weight / shared.weight) * Sharing::component(ratio_slope, place);
      forces[p * n + i] = force.value + pressure * slope.value;
      for (std::size_t j = 0; j < n; ++j)
        tangents[(p * n + i) * n + j] = force.slope[j] + pressure * slope.slope[j];
      of_ratio[i] = slope.value;
      coupling[i] = force.slope[n];
      counter_coupling[i] = energy.by_shared.slope[i];
    }
    scatter(on, p, of_ratio.data(), &ratio_slopes_[first]);
    scatter(on, p, coupling.data(), &couplings_[first]);
    scatter(on, p, counter_coupling.data(), &counter_couplings_[first]);
  }
}

/// Of each cell a t^T + t (b + k t)^T: t is the shared ratio's derivative by displacements, a that of forces by
/// the shared ratio, b that of the energy's derivative by the shared ratio, and k its curvature.
void MeanDilatation::add_stiffness(const Discretization& on, Eigen::SparseMatrix<double>& out) const {
  const auto axes = static_cast<std::size_t>(on.axes());
  for (std::size_t c = 0; c < on.cells(); ++c) {
    const std::span<const std::uint32_t> nodes = on.particle(on.members(c)[0]).nodes;
    const std::size_t first = on.first_node(c) * axes;
    for (std::size_t column = 0; column < nodes.size() * axes; ++column) {
      const std::size_t unknown = nodes[column / axes] * axes + column % axes;
      const int* begin = out.innerIndexPtr() + out.outerIndexPtr()[unknown];
      const int* end = out.innerIndexPtr() + out.outerIndexPtr()[unknown + 1];
      const double ratio = ratio_slopes_[first + column];
      const double energy = counter_couplings_[first + column] + shared_[c].curvature * ratio;
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const int* row = std::lower_bound(begin, end, static_cast<int>(nodes[a] * axes));
        assert(row != end && *row == static_cast<int>(nodes[a] * axes));
        double* values = out.valuePtr() + (row - out.innerIndexPtr());
        for (std::size_t i = 0; i < axes; ++i)
          values[i] += couplings_[first + a * axes + i] * ratio + ratio_slopes_[first + a * axes + i] * energy;
      }
    }
  }
}

}  // namespace trajan
