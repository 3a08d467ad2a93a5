#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/executors/block.h"
#include "solver/executors/tiles.h"
#include "solver/model/model.h"
#include "solver/schemes/kernels.h"

namespace trajan {

/// An attribute that a body's particles carry, and which part of the scene makes it necessary.
struct AttributeNeed {
  Attribute attribute;
  std::string wanted_by;
};

/// The particles of one body: one array per attribute that the scene needs, in the order of tiles.
struct BodyParticles {
  BodyConstants constants;
  std::uint32_t field = 0;  ///< the velocity field that it shares
  const LawKernels* law = nullptr;
  std::unique_ptr<const void, void (*)(const void*)> law_object{nullptr, [](const void*) {}};
  std::vector<AttributeNeed> needs;                         ///< several may want the same attribute
  std::array<std::vector<double>, attribute_count> arrays;  ///< empty: not needed
  std::vector<std::uint32_t> number;                        ///< within the body, by slot
  double inertia = 1;  ///< by what mass is multiplied where only a state of rest is wanted, but not weight

  std::size_t size() const { return number.size(); }
  bool carries(Attribute a) const;
  std::vector<double>& operator[](Attribute a) { return arrays[static_cast<int>(a)]; }
  const std::vector<double>& operator[](Attribute a) const { return arrays[static_cast<int>(a)]; }
  /// A component of a vector whose first component is `a`.
  std::vector<double>& component(Attribute a, int axis) { return arrays[static_cast<int>(a) + axis]; }
  const std::vector<double>& component(Attribute a, int axis) const { return arrays[static_cast<int>(a) + axis]; }
};

std::string_view attribute_name(Attribute attribute);

/// Bodies without particles.
std::vector<BodyParticles> make_bodies(const Model& model);
/// Gives them their particles of time 0, in the order of their numbers.
void add_particles(const Model& model, std::vector<BodyParticles>& bodies);

/// The least mass of a particle.
double lightest_particle(const std::vector<BodyParticles>& bodies);

/// Positions at time 0 of the particles of these numbers.
std::vector<Vector> reference_positions(const Model& model, const std::vector<std::int64_t>& numbers);

/// Puts particles in the order of tiles and, within one, of the nodes that their stencils begin with: those of
/// cells, or (`staggered`) of cells that are shifted by half a cell. Particles of one stay in order.
void sort_into_tiles(const Grid& grid, bool staggered, std::vector<BodyParticles>& bodies, Tiles& tiles);

/// The tiles that will have particles at time 0, in any order.
std::vector<OccupiedTile> occupied_tiles(const Model& model, const Tiles& tiles);

}  // namespace trajan
