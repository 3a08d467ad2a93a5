#include "solver/implicit/discretization.h"

#include <algorithm>
#include <numeric>

#include "solver/implicit/stencil_kernels.h"
#include "solver/model/spline_degree.h"

namespace trajan {
namespace {

/// The node of the grid that a window's node is, by its owner: tile and node.
Discretization::Owner owner_of(const Layout& layout, const Tile& tile, int window_node) {
  int neighbour = 0, node = 0, power = 1;
  for (int axis = 0; axis < layout.dimensions; ++axis, power *= 3) {
    const int i = window_node / layout.window_stride(axis) % layout.window_side - layout.below;
    neighbour += (i + layout.side) / layout.side * power;
    node += (i & (layout.side - 1)) * layout.tile_stride(axis);
  }
  return {static_cast<std::uint32_t>(tile.around[static_cast<std::size_t>(neighbour)]), node};
}

}  // namespace

Discretization::Discretization(const Model& model, Executor& executor)
    : tiles_(executor.tiles()),
      axes_(grid_axes(model.dimension)),
      axisymmetric_(model.dimension == Dimension::axisymmetric) {
  first_particle_.assign(1, 0);
  for (const BlockRange& block : tiles_.blocks()) first_particle_.push_back(first_particle_.back() + block.count);
  find_stencils(model, executor);
  if (model.numerics.locking_remedy != "none") find_cells();
}

void Discretization::find_stencils(const Model& model, Executor& executor) {
  const StencilKernel kernel =
      stencil_kernel(model.numerics.shape_functions, model.dimension, splines_keep_degree(model));
  std::vector<BlockStencils> stencils(tiles_.blocks().size());
  const std::size_t particles = first_particle_.back();
  masses_.resize(particles);
  volumes_.resize(particles);
  bodies_.resize(particles);
  if (axisymmetric_) inverse_radii_.resize(particles);
  const Layout window(axes_, tiles_.layout().reach);  // whatever margin that of explicit steps has
  executor.visit([&](Block& block, std::size_t b, std::size_t tile) {
    kernel(block, stencils[b]);
    // From nodes of the window to nodes of all tiles.
    for (int& node : stencils[b].nodes) {
      const Owner owner = owner_of(window, tiles_.tiles()[tile], node);
      node = static_cast<int>(owner.tile) * tile_nodes + owner.node;
    }
    for (int i = 0; i < block.count; ++i) {
      const std::size_t p = first_particle_[b] + static_cast<std::size_t>(i);
      masses_[p] = block.mass(i);
      volumes_[p] = masses_[p] / block.body->density;
      bodies_[p] = tiles_.blocks()[b].body;
      if (axisymmetric_) inverse_radii_[p] = 1 / block[Attribute::position_x][i];
    }
  });

  first_node_.assign(1, 0);
  first_node_.reserve(particles + 1);
  numbers_.assign(tiles_.tiles().size() * tile_nodes, -1);
  for (const BlockStencils& s : stencils) {
    for (int count : s.counts) first_node_.push_back(first_node_.back() + static_cast<std::size_t>(count));
    for (int node : s.nodes) numbers_[static_cast<std::size_t>(node)] = 0;
  }
  for (std::size_t at = 0; at < numbers_.size(); ++at) {
    if (numbers_[at] < 0) continue;
    numbers_[at] = static_cast<std::int32_t>(owners_.size());
    owners_.push_back({static_cast<std::uint32_t>(at / tile_nodes), static_cast<std::int32_t>(at % tile_nodes)});
  }
  weights_.reserve(first_node_.back());
  gradients_.reserve(first_node_.back() * static_cast<std::size_t>(axes_));
  nodes_.reserve(first_node_.back());
  for (BlockStencils& s : stencils) {
    weights_.insert(weights_.end(), s.weights.begin(), s.weights.end());
    gradients_.insert(gradients_.end(), s.gradients.begin(), s.gradients.end());
    for (int node : s.nodes)
      nodes_.push_back(static_cast<std::uint32_t>(numbers_[static_cast<std::size_t>(node)]));
    s = {};
  }
}

/// Sorts particles by body and nodes; those of one cell keep their order.
void Discretization::find_cells() {
  cell_particles_.resize(particles());
  std::iota(cell_particles_.begin(), cell_particles_.end(), 0u);
  const auto before = [this](std::uint32_t a, std::uint32_t b) {
    if (bodies_[a] != bodies_[b]) return bodies_[a] < bodies_[b];
    return std::ranges::lexicographical_compare(particle(a).nodes, particle(b).nodes);
  };
  std::ranges::stable_sort(cell_particles_, before);
  std::size_t nodes = 0;
  for (std::size_t k = 0; k < cell_particles_.size(); ++k) {
    if (k > 0 && !before(cell_particles_[k - 1], cell_particles_[k])) continue;
    cells_.push_back({k, nodes});
    nodes += particle(cell_particles_[k]).nodes.size();
  }
  cells_.push_back({cell_particles_.size(), nodes});
}

std::array<std::int64_t, 3> Discretization::grid_index(std::size_t n) const {
  const Layout& layout = tiles_.layout();
  const Tile& tile = tiles_.tiles()[owners_[n].tile];
  std::array<std::int64_t, 3> index{};
  for (int axis = 0; axis < axes_; ++axis)
    index[static_cast<std::size_t>(axis)] = std::int64_t{tile.at[static_cast<std::size_t>(axis)]} * layout.side +
                                            owners_[n].node / layout.tile_stride(axis) % layout.side;
  return index;
}

std::int32_t Discretization::neighbour(std::size_t n, int axis, int steps) const {
  const Layout& layout = tiles_.layout();
  std::int32_t tile = static_cast<std::int32_t>(owners_[n].tile), stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
  int i = owners_[n].node / layout.tile_stride(axis) % layout.side;
  const int rest = owners_[n].node - i * layout.tile_stride(axis);
  const int middle = layout.neighbours / 2;
  for (i += steps; tile >= 0 && (i < 0 || i >= layout.side);) {
    const int side = i < 0 ? -1 : 1;
    const int other = middle + side * stride;
    tile = tiles_.tiles()[static_cast<std::size_t>(tile)].around[static_cast<std::size_t>(other)];
    i -= side * layout.side;
  }
  return tile < 0 ? -1 : number(static_cast<std::size_t>(tile), rest + i * layout.tile_stride(axis));
}

}  // namespace trajan
