#include "solver/cost/sample_scenes.h"

#include <algorithm>
#include <span>
#include <utility>

namespace trajan {
namespace {

/// Of a parameter that must be given. Moduli, strengths and the like grow from one to the next, which is what laws
/// ask of them together, and are so large that small strains are elastic.
double sample_value(const Parameter& parameter, double& modulus) {
  constexpr double bounded = 1e6, share = 0.3, pure_number = 0.1, growth = 6;
  if (parameter.highest - parameter.lowest < bounded) {
    const double lowest = std::max(parameter.lowest, 0.0);
    return lowest + share * (parameter.highest - lowest);
  }
  if (parameter.unit == "1") return pure_number;
  return std::exchange(modulus, growth * modulus);
}

MaterialDefinition sample_material(const MaterialKind& kind) {
  MaterialDefinition material;
  material.name = "sample";
  material.density = 1000;
  const bool damaged = kind.name.starts_with(damage_prefix);
  material.law = damaged ? kind.name.substr(damage_prefix.size()) : kind.name;
  const std::size_t own = damaged ? find_material_kind(material.law)->parameters.size() : kind.parameters.size();
  if (damaged) material.damage.emplace();
  double modulus = 1000;
  for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
    const Parameter& parameter = kind.parameters[i];
    // One of the strengths, which are the first parameters of damage, must be given.
    if (parameter.optional() && i != own) continue;
    auto& values = i < own ? material.parameters : *material.damage;
    values[std::string(parameter.name)] = sample_value(parameter, modulus);
  }
  return material;
}

/// Walls all around, so that a gas stays where it is.
std::vector<BoundaryDefinition> walls(int axes, bool axisymmetric) {
  struct Wall {
    const char* name;
    Edge edge;
    Axis normal;
  };
  static const Wall all[] = {{"left", Edge::left, Axis::x},     {"right", Edge::right, Axis::x},
                             {"bottom", Edge::bottom, Axis::y}, {"top", Edge::top, Axis::y},
                             {"back", Edge::back, Axis::z},     {"front", Edge::front, Axis::z}};
  std::vector<BoundaryDefinition> walls;
  for (const Wall& wall : std::span(all).first(static_cast<std::size_t>(2 * axes)))
    if (!axisymmetric || wall.edge != Edge::left) walls.push_back({wall.name, wall.edge, Fixed{{wall.normal}}});
  return walls;
}

}  // namespace

Scene sample_block(Dimension dimension, const MaterialKind& kind, int cells, int particles) {
  Scene scene;
  scene.name = "sample";
  const int axes = grid_axes(dimension);
  const double size = cells;
  const Vector far{size, axes > 1 ? size : 0, axes > 2 ? size : 0};
  scene.domain.dimension = dimension;
  scene.domain.cell_size = 1;
  scene.domain.upper = far;
  scene.boundaries = walls(axes, dimension == Dimension::axisymmetric);
  if (dimension == Dimension::bar) scene.domain.cross_section = 1;
  scene.materials = {sample_material(kind)};
  scene.bodies = {
      {"block", "sample", Box{{}, far}, particles, {"1e-6 * x * (" + std::to_string(cells) + " - x)"}}};
  scene.analysis.end_time = 1e6;  // no sample comes while steps are measured
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  return scene;
}

Scene sample_contact(Dimension dimension, const MaterialKind& kind, int cells, int particles) {
  Scene scene = sample_block(dimension, kind, cells, particles);
  BodyDefinition& left = scene.bodies[0];
  BodyDefinition right = left;
  right.name = "right";
  auto& first = std::get<Box>(left.geometry);
  auto& second = std::get<Box>(right.geometry);
  first.upper.x = second.lower.x = 0.5 * cells;
  scene.bodies.push_back(right);
  scene.contacts = {{{}, 0.2}};
  return scene;
}

}  // namespace trajan
