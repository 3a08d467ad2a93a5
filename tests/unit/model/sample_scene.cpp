#include "tests/unit/model/sample_scene.h"

namespace trajan {

namespace {

void add_boundaries_and_loads(Scene& scene) {
  scene.boundaries = {{"clamp", Box{{0, -1}, {0, 2}}, Fixed{}},
                      {"shaker", Box{{-1, -1}, {-1, 2}}, PrescribedVelocity{{std::nullopt, "0.1 * sin(t)"}}}};
  LoadDefinition end_load;
  end_load.name = "end_load";
  end_load.kind = EdgeTraction{"beam", Edge::right, {0, -1}, "6 * y * (1 - y)"};
  end_load.time = Ramp{0, 1, true};
  LoadDefinition gravity;
  gravity.name = "gravity";
  gravity.kind = BodyForce{{0, -9.81}, {"beam"}};
  LoadDefinition push;
  push.name = "push";
  push.kind = PointForce{"beam", {8, 0.5}, {1, 0}};
  push.time = "exp(-t)";
  scene.loads = {end_load, gravity, push};
}

void add_outputs_and_measures(Scene& scene) {
  scene.outputs.probes = {{"tip", Vector{8, 0.5}, {Field::displacement, Field::velocity}, ""},
                          {"root", Region{Box{{0, 0}, {1, 1}}}, {Field::stress}, "beam"}};
  MeasureDefinition deflection;
  deflection.name = "deflection";
  deflection.quantity = "tip.displacement.y";
  deflection.kind = FinalValue{};
  deflection.exact = "-4 * P * L^3 / E";
  deflection.tolerance = 0.01;
  MeasureDefinition frequency;
  frequency.name = "frequency";
  frequency.quantity = "tip.displacement.y";
  frequency.kind = DominantFrequency{0.1, std::nullopt};
  scene.measures = {deflection, frequency};
}

}  // namespace

Scene sample_scene() {
  Scene scene;
  scene.name = "cantilever";
  scene.constants = {{"E", "3000"}, {"L", "8"}, {"P", "1"}, {"c", "sqrt(E / 2)"}};
  scene.domain = {Dimension::plane_stress, {-1, -1}, {9, 2}, 0.25, 1};
  scene.materials = {{"rubber", 2, "linear_elastic", {{"youngs_modulus", 3000}, {"poissons_ratio", 0.3}}}};
  scene.bodies = {{"beam", "rubber", Box{{0, 0}, {8, 1}}, 2, {}},
                  {"ball", "rubber", Disc{{4, 1.5}, 0.4}, 3, {"0.1 * x", std::nullopt}}};
  add_boundaries_and_loads(scene);
  scene.analysis = {10, 0.5};
  add_outputs_and_measures(scene);
  return scene;
}

std::vector<Violation> violations_of(const Scene& scene) {
  try {
    validate(scene);
  } catch (const InvalidScene& invalid) {
    return invalid.violations();
  }
  return {};
}

std::vector<std::string> paths_of(const Scene& scene) {
  std::vector<std::string> paths;
  for (const Violation& violation : violations_of(scene)) paths.push_back(violation.path);
  return paths;
}

}  // namespace trajan
