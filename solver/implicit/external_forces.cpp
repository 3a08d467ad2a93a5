#include "solver/implicit/external_forces.h"

#include <algorithm>
#include <array>

#include "solver/model/components.h"

namespace trajan {
namespace {

/// Of the run's time, over which loads are straight at its ends.
constexpr double slope_share = 1e-4;

Components product(const Components& a, const Components& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The nodes around a surface point: numbers (-1: no particle sees it), weights and their derivatives.
struct PointStencil {
  int count;
  std::array<std::int32_t, std::tuple_size_v<Riders::Values>> nodes;
  Riders::Values weights;
  std::array<Riders::Values, 3> slopes;

  PointStencil(const Discretization& on, const Riders& riders, const Executor& executor, std::size_t p)
      : count(riders.corners()) {
    const Riders::Stencil stencil = riders.stencil(executor.tiles(), executor.bodies(), p);
    weights = riders.weights(stencil, stencil.of_point);
    for (int axis = 0; axis < on.axes(); ++axis)
      slopes[static_cast<std::size_t>(axis)] = riders.slopes(stencil, stencil.of_point, axis);
    for (int n = 0; n < count; ++n) {
      const Riders::Owner owner = riders.owner(executor.tiles(), stencil.tile, stencil.node + riders.corner(n));
      nodes[static_cast<std::size_t>(n)] = on.number(owner.tile, owner.node);
    }
  }
};

/// Where a node's components begin among those of all nodes.
std::size_t first_of(std::int32_t node, const Discretization& on) {
  return static_cast<std::size_t>(node) * static_cast<std::size_t>(on.axes());
}

/// A material vector after a displacement, and its derivative by that of a node: along the node's own axis.
Components stretched(const Discretization& on, const PointStencil& stencil, const Components& now,
                     const Components& rest, std::span<const double> displacement) {
  Components out = now;
  for (int n = 0; n < stencil.count; ++n) {
    if (stencil.nodes[n] < 0) continue;
    const double* u = &displacement[first_of(stencil.nodes[n], on)];
    for (int i = 0; i < on.axes(); ++i)
      for (int j = 0; j < on.axes(); ++j) out[i] += u[i] * stencil.slopes[j][n] * rest[j];
  }
  return out;
}

/// The area vector of a point that follows, and what it depends on.
struct MovingArea {
  Components from[2];  ///< what the gradient acts on
  Components tangent[2];
  double scale = 1;
  bool by_radius = false;

  MovingArea(const Model& model, const Discretization& on, const Riders& riders, std::size_t p,
             const PointStencil& stencil, std::span<const double> displacement) {
    for (int which = 0; which < 2; ++which) {
      const double* t = riders.tangent(p, which);
      const Components now{t[0], t[1], t[2]};
      const Vector& rest = riders.point(p).tangents[static_cast<std::size_t>(which)];
      from[which] = riders.total_lagrangian() ? Components{rest.x, rest.y, rest.z} : now;
      tangent[which] = stretched(on, stencil, now, from[which], displacement);
    }
    by_radius = on.axisymmetric();
    if (on.axes() == 2) scale = model.thickness;
    if (!by_radius) return;
    scale = riders.place(p)[0];
    for (int n = 0; n < stencil.count; ++n)
      if (stencil.nodes[n] >= 0) scale += stencil.weights[n] * displacement[first_of(stencil.nodes[n], on)];
  }
  Components value() const { return scaled(product(tangent[0], tangent[1]), scale); }
  /// By the displacement of one of the stencil's nodes along an axis.
  Components derivative(const Discretization& on, const PointStencil& stencil, int node, int axis) const {
    Components change[2] = {};
    for (int which = 0; which < 2; ++which)
      for (int j = 0; j < on.axes(); ++j) change[which][axis] += stencil.slopes[j][node] * from[which][j];
    const Components a = product(change[0], tangent[1]), b = product(tangent[0], change[1]);
    const Components c = product(tangent[0], tangent[1]);
    const double of_scale = by_radius && axis == 0 ? stencil.weights[node] : 0;
    Components out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = scale * (a[i] + b[i]) + of_scale * c[i];
    return out;
  }

 private:
  static Components scaled(const Components& v, double by) { return {by * v[0], by * v[1], by * v[2]}; }
};

}  // namespace

bool ExternalForces::follow() const {
  return grid_axes(model_.dimension) > 1 &&
         std::ranges::any_of(model_.surface_loads, [](const SurfaceLoad& load) { return load.follows; });
}

void ExternalForces::add(const Discretization& on, double time, std::span<const double> displacement,
                         std::span<double> forces, SparseMatrix* stiffness) {
  const double end = std::clamp(time, 0.0, model_.end_time);
  if (time == end) return add_share(on, time, 1, displacement, forces, stiffness);
  const double inside = end + (end > 0 ? -slope_share : slope_share) * model_.end_time;
  const double ahead = (time - end) / (end - inside);
  add_share(on, end, 1 + ahead, displacement, forces, stiffness);
  add_share(on, inside, -ahead, displacement, forces, stiffness);
}

void ExternalForces::add_share(const Discretization& on, double time, double share,
                               std::span<const double> displacement, std::span<double> forces,
                               SparseMatrix* stiffness) {
  executor_.loads().prepare(executor_.bodies(), time);
  if (!model_.body_loads.empty()) add_body_loads(on, share, forces);
  for (std::size_t load = 0; load < model_.surface_loads.size(); ++load) {
    if (model_.surface_loads[load].follows && on.axes() > 1)
      add_pressure(on, load, share, displacement, forces, stiffness);
    else
      add_dead_loads(on, load, share, forces);
  }
}

void ExternalForces::add_body_loads(const Discretization& on, double share, std::span<double> forces) {
  const auto axes = static_cast<std::size_t>(on.axes());
  const auto blocks = executor_.tiles().blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BodyParticles& body = executor_.bodies()[blocks[b].body];
    for (std::uint32_t i = 0; i < blocks[b].count; ++i) {
      const std::size_t p = on.first_particle(b) + i;
      const Discretization::Particle particle = on.particle(p);
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const std::vector<double>& own = body.component(Attribute::load_x, static_cast<int>(axis));
        const double force = share * on.mass(p) *
                             (body.constants.acceleration[axis] + (own.empty() ? 0.0 : own[blocks[b].begin + i]));
        for (std::size_t k = 0; k < particle.nodes.size(); ++k)
          forces[particle.nodes[k] * axes + axis] += particle.weights[k] * force;
      }
    }
  }
}

void ExternalForces::add_dead_loads(const Discretization& on, std::size_t load, double share,
                                    std::span<double> forces) {
  const Riders& riders = executor_.loads().riders()[load];
  const SurfaceLoad& of = model_.surface_loads[load];
  const double factor = share * executor_.loads().factors()[load];
  for (std::size_t p = 0; p < of.points.size(); ++p) {
    const PointStencil stencil(on, riders, executor_, p);
    Vector force = of.points[p].force;
    if (of.follows) force.x -= of.points[p].pressure * riders.area(p).x;
    for (int n = 0; n < stencil.count; ++n)
      for (int axis = 0; axis < on.axes() && stencil.nodes[n] >= 0; ++axis)
        forces[first_of(stencil.nodes[n], on) + static_cast<std::size_t>(axis)] +=
            stencil.weights[n] * factor * component(force, axis);
  }
}

void ExternalForces::add_pressure(const Discretization& on, std::size_t load, double share,
                                  std::span<const double> displacement, std::span<double> forces,
                                  SparseMatrix* stiffness) {
  const Riders& riders = executor_.loads().riders()[load];
  const SurfaceLoad& of = model_.surface_loads[load];
  const double factor = share * executor_.loads().factors()[load];
  const int axes = on.axes();
  for (std::size_t p = 0; p < of.points.size(); ++p) {
    const PointStencil stencil(on, riders, executor_, p);
    const MovingArea area(model_, on, riders, p, stencil, displacement);
    const double pressure = -factor * of.points[p].pressure;
    const auto unknown = [&](int n, int axis) { return stencil.nodes[n] * axes + axis; };
    for (int n = 0; n < stencil.count; ++n)
      for (int axis = 0; axis < axes && stencil.nodes[n] >= 0; ++axis)
        forces[static_cast<std::size_t>(unknown(n, axis))] += stencil.weights[n] * pressure * area.value()[axis];
    for (int m = 0; stiffness && m < stencil.count; ++m)
      for (int k = 0; k < axes && stencil.nodes[m] >= 0; ++k) {
        const Components change = area.derivative(on, stencil, m, k);
        for (int n = 0; n < stencil.count; ++n)
          for (int axis = 0; axis < axes && stencil.nodes[n] >= 0; ++axis)
            stiffness->coeffRef(unknown(n, axis), unknown(m, k)) -= stencil.weights[n] * pressure * change[axis];
      }
  }
}

}  // namespace trajan
