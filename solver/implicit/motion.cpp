#include "solver/implicit/motion.h"

#include "solver/schemes/scheme.h"

namespace trajan {
namespace {

/// Surface points ask the nodes for velocities.
void write_to_tiles(const Eigen::VectorXd& displacement, const Discretization& on, Tiles& tiles) {
  const int axes = on.axes();
  for (std::size_t n = 0; n < on.nodes(); ++n) {
    const auto [tile, node] = on.owner(n);
    double* nodes = tiles.nodes(tile);
    for (int axis = 0; axis < axes; ++axis)
      for (NodeVector vector : {node_velocity, node_mapped_velocity})
        nodes[tile_array(quantity(vector, axis, axes)) + node] =
            displacement[static_cast<Eigen::Index>(n) * axes + axis];
  }
}

}  // namespace

void move_by(const Eigen::VectorXd& displacement, double from, double to, const Discretization& on,
             const Model& model, Executor& executor) {
  write_to_tiles(displacement, on, executor.tiles());
  executor.loads().displace(executor.tiles(), executor.bodies());
  executor.conditions().prepare({from, from, to, to - from});
  executor.conditions().advect(executor.tiles(), executor.bodies(), 1);

  const Attribute moved =
      is_total_lagrangian(model.numerics.scheme) ? Attribute::displacement_x : Attribute::position_x;
  const int axes = on.axes();
  executor.visit([&](Block& block, std::size_t b, std::size_t) {
    for (int i = 0; i < block.count; ++i) {
      const Discretization::Particle particle = on.particle(on.first_particle(b) + static_cast<std::size_t>(i));
      for (int axis = 0; axis < axes; ++axis) {
        double sum = 0;
        for (std::size_t k = 0; k < particle.nodes.size(); ++k)
          sum += particle.weights[k] * displacement[static_cast<Eigen::Index>(particle.nodes[k]) * axes + axis];
        block.component(moved, axis)[i] += sum;
      }
    }
  });
}

std::int64_t outside_domain(const Model& model, const Executor& executor) {
  const Grid& grid = model.grid;
  const std::int64_t cells[] = {grid.cells_x, grid.cells_y, grid.cells_z};
  for (std::size_t b = 0; b < executor.bodies().size(); ++b) {
    const BodyParticles& body = executor.bodies()[b];
    for (int axis = 0; axis < grid_axes(model.dimension); ++axis) {
      const double lower = component(grid.origin, axis),
                   upper = lower + grid.cell * static_cast<double>(cells[axis]);
      const std::vector<double>& places = body.component(Attribute::position_x, axis);
      for (std::size_t i = 0; i < places.size(); ++i)
        if (!(places[i] >= lower && places[i] <= upper)) return model.bodies[b].first_particle + body.number[i];
    }
  }
  return -1;
}

}  // namespace trajan
