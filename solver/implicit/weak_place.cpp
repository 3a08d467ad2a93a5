#include "solver/implicit/weak_place.h"

#include <array>
#include <cmath>

#include "solver/model/names.h"

namespace trajan {
namespace {

/// The sum of a vector of nodes, or of the nodes' places, by a particle's weights.
struct Seen {
  std::array<double, 3> value{}, place{};

  Seen(const Model& model, const Discretization& on, std::size_t p, const Eigen::VectorXd& values) {
    const Discretization::Particle particle = on.particle(p);
    const double origin[] = {model.grid.origin.x, model.grid.origin.y, model.grid.origin.z};
    for (std::size_t k = 0; k < particle.nodes.size(); ++k)
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(on.axes()); ++axis) {
        const auto unknown = static_cast<Eigen::Index>(particle.nodes[k]) * on.axes() + static_cast<int>(axis);
        value[axis] += particle.weights[k] * values[unknown];
        const double node =
            origin[axis] + model.grid.cell * static_cast<double>(on.grid_index(particle.nodes[k])[axis]);
        place[axis] += particle.weights[k] * node;
      }
  }
  double squared() const { return value[0] * value[0] + value[1] * value[1] + value[2] * value[2]; }
};

/// Three digits are enough to find a place.
double rounded(double x, double unit) { return std::round(x / unit * 1e3) / 1e3 * unit + 0.0; }

}  // namespace

std::string largest_place(const Model& model, const Discretization& on, const Eigen::VectorXd& values) {
  std::size_t largest = 0;
  double square = -1;
  for (std::size_t p = 0; p < on.particles(); ++p)
    if (const double of = Seen(model, on, p, values).squared(); of > square) largest = p, square = of;
  const Seen seen(model, on, largest, values);
  const double unit = std::pow(10, std::ceil(std::log10(model.grid.cell)));
  const Vector place{rounded(seen.place[0], unit), rounded(seen.place[1], unit), rounded(seen.place[2], unit)};
  return "body " + quoted(model.bodies[on.body(largest)].name) + " near " + point_text(place, on.axes());
}

}  // namespace trajan
