#pragma once

#include <gtest/gtest.h>

#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan::test {

/// A scene's histories, once it has run to its end.
struct Histories {
  explicit Histories(const Scene& scene) : model(validate(scene)), result(run(model, {}, memory, nullptr)) {
    EXPECT_EQ(result.end, RunEnd::finished) << (result.divergence ? result.divergence->cause : "");
  }
  std::size_t rows() const { return memory.rows.size(); }
  double time(std::size_t row) const { return memory.times[row]; }
  double at(std::size_t row, const std::string& name) const { return memory.rows[row][column(model, name)]; }
  double last(const std::string& name) const { return at(rows() - 1, name); }
  double steps() const { return static_cast<double>(result.progress.step); }

  Memory memory;
  Model model;
  RunResult result;
};

inline Surface surface(const std::string& body, decltype(Surface::part) part, const Region& within = {}) {
  Surface surface;
  surface.body = body;
  surface.part = part;
  surface.within = within;
  return surface;
}

inline Hinge hinge(const Surface& surface, HingeKind kind, const std::vector<Axis>& axes = {}) {
  Hinge hinge;
  hinge.surface = surface;
  hinge.kind = kind;
  hinge.axes = axes;
  return hinge;
}

inline Pressure pressure(const Surface& surface, double value, bool follows = true) {
  Pressure pressure;
  pressure.surface = surface;
  pressure.pressure = value;
  pressure.follows = follows;
  return pressure;
}

/// A block of 2 x 1 and mass 2 above y = 0, of E = 1000 unless another is given.
inline Scene block(double youngs_modulus = 1000) {
  Scene scene;
  scene.name = "block";
  scene.domain.dimension = Dimension::plane_strain;
  scene.domain.lower = {-4, -2};
  scene.domain.upper = {12, 6};
  scene.domain.cell_size = 0.25;
  scene.materials = {material("neo_hookean", youngs_modulus, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {2, 1}}, 2, {}}};
  scene.analysis = {1, 0};
  scene.outputs.samples = 20;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"middle", Vector{1, 0.5}, {Field::displacement, Field::velocity}, ""}};
  return scene;
}

}  // namespace trajan::test
