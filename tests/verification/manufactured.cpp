#include "tests/verification/manufactured.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/gallery.h"

namespace trajan::verification {

namespace {

using std::numbers::pi;

Vector axis_aligned(Vector reference, double time) {
  constexpr double amplitude = 0.05;
  const double factor = amplitude * std::sin(100 * pi * time);  // sqrt(E / rho) = 100
  return {factor * std::sin(pi * reference.x), -factor * std::sin(pi * reference.y)};
}

Vector generalized_vortex(Vector reference, double time) {
  const double s = (std::hypot(reference.x, reference.y) - 1) / 0.5;
  const double turn = 0.5 * std::sin(pi * time) * std::pow(1 - 4 * s * s, 2);
  const double c = std::cos(turn) - 1, d = std::sin(turn);
  return {c * reference.x - d * reference.y, d * reference.x + c * reference.y};
}

/// The chord of half a radian at the radius 1.
const ManufacturedSolution solutions[] = {
    {"axis_aligned", 0.05, 0.125, axis_aligned},
    {"generalized_vortex", 2 * std::sin(0.5), 0.1, generalized_vortex},
};

double mean_error(const Snapshot& snapshot, const ManufacturedSolution& solution) {
  const std::vector<double>& displacement = snapshot.fields.at(0);
  double sum = 0;
  for (std::size_t i = 0; i < displacement.size(); i += 2) {
    const Vector u{displacement[i], displacement[i + 1]};
    const Vector exact =
        solution.displacement({snapshot.position[i] - u.x, snapshot.position[i + 1] - u.y}, snapshot.time);
    sum += std::pow(u.x - exact.x, 2) + std::pow(u.y - exact.y, 2);
  }
  return std::sqrt(2 * sum / static_cast<double>(displacement.size()));
}

}  // namespace

std::span<const ManufacturedSolution> manufactured_solutions() { return solutions; }

double displacement_error(Scene scene, const ManufacturedSolution& solution) {
  scene.outputs.snapshot_fields = {Field::displacement};
  double error = 0;
  run_scene(scene, [&](const Snapshot& snapshot) { error = std::max(error, mean_error(snapshot, solution)); });
  return error / solution.largest_displacement;
}

Scene with_numerics(Scene scene, const std::string& scheme, const std::string& shape_functions,
                    const std::string& transfer) {
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shape_functions;
  scene.numerics.transfer = transfer;
  return scene;
}

}  // namespace trajan::verification
