#include <algorithm>

#include "solver/simulation/executor.h"

/// Iterations of transfers between the nodes and the particles, which stay where they are.
namespace trajan {
namespace {

/// The vectors of a tile's nodes.
struct NodeVectors {
  double* nodes;
  int axes;
  double* operator()(NodeVector vector, int axis = 0) const {
    return nodes + tile_array(quantity(vector, axis, axes));
  }
};

/// The first term: all of it is remainder.
void start(const Projection& projection, const NodeVectors& vectors, double kick) {
  const int size = vectors.axes * tile_nodes;
  std::copy_n(vectors(projection.of), size, vectors(node_remainder));
  for (NodeVector into : projection.into)
    if (into == node_projected_velocity) std::copy_n(vectors(projection.of), size, vectors(into));
  if (!projection.before_kick) return;
  double* remainder = vectors(node_remainder);
  const double* acceleration = vectors(node_acceleration);
  for (int i = 0; i < size; ++i) remainder[i] -= kick * acceleration[i];
}

/// On nodes of at least this mass.
void add_remainder(const NodeVectors& vectors, NodeVector into, double least_mass) {
  const double* mass = vectors.nodes + tile_array(quantity_mass);
  for (int axis = 0; axis < vectors.axes; ++axis) {
    const double* remainder = vectors(node_remainder, axis);
    double* sum = vectors(into, axis);
    for (int i = 0; i < tile_nodes; ++i)
      if (mass[i] >= least_mass) sum[i] += remainder[i];
  }
}

}  // namespace

void Executor::project(const Projection& projection, double light_mass) {
  if (projection.into.empty()) return;
  loop_.for_each([&](std::size_t index, std::size_t) {
    start(projection, {tiles_.nodes(index), axes_}, sweep_.kick);
  });
  const int order = model_.numerics.transfer_order.value_or(default_transfer_order);
  for (int term = 1; term < order; ++term) {
    static constexpr Pass exchange[] = {Pass::locate, Pass::remap};
    const NodeWork reduce = [&](std::size_t index, std::size_t thread) {
      NodeBlock block = node_block(index, thread);
      transfer_->reduce_remainder(block);
      conditions_.hold(index, NodeVectors{block.nodes, axes_}(node_remainder));
      for (NodeVector into : projection.into)
        add_remainder({block.nodes, axes_}, into, into == node_mapped_velocity ? light_mass : 0);
    };
    if (by_wave_) {
      run(exchange, reduce);
      continue;
    }
    run(exchange);
    fold_images();
    loop_.for_each(reduce);
    copy_to_images();
  }
  // Further terms may make what touches come closer.
  for (NodeVector into : projection.into)
    if (into == node_velocity || into == node_mapped_velocity)
      contacts_.act_on(pool_, tiles_, conditions_.held(), into);
  copy_to_images();
}

}  // namespace trajan
