#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/executors/block.h"
#include "solver/executors/floats.h"
#include "solver/executors/thread_pool.h"
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
  bool narrow = false;                                      ///< what may be float is
  std::vector<Attribute> present;                           ///< what is needed, each once
  std::vector<Attribute> narrow_state;                      ///< what of it the law sees and is float
  std::array<std::vector<double>, attribute_count> arrays;  ///< empty: not needed, or floats
  std::array<std::vector<float>, attribute_count> floats;   ///< less their value at rest
  std::vector<std::uint32_t> number;                        ///< within the body, by slot
  double inertia = 1;  ///< by what mass is multiplied where only a state of rest is wanted, but not weight

  std::size_t size() const { return number.size(); }
  bool carries(Attribute a) const;
  std::vector<double>& operator[](Attribute a) { return arrays[static_cast<int>(a)]; }
  const std::vector<double>& operator[](Attribute a) const { return arrays[static_cast<int>(a)]; }
  /// A component of a vector whose first component is `a`.
  std::vector<double>& component(Attribute a, int axis) { return arrays[static_cast<int>(a) + axis]; }
  const std::vector<double>& component(Attribute a, int axis) const { return arrays[static_cast<int>(a) + axis]; }

  /// \name Of what may be double or float
  /// @{
  bool has(Attribute a) const { return !(*this)[a].empty() || !floats[static_cast<int>(a)].empty(); }
  double value(Attribute a, std::size_t slot) const;
  double value(Attribute first, int axis, std::size_t slot) const {
    return value(static_cast<Attribute>(static_cast<int>(first) + axis), slot);
  }
  bool is_float(Attribute a) const { return narrow && may_be_float(a); }
  /// Makes floats of what is one.
  void round();
  /// @}
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

/// How particles lie within a tile.
enum class CellOrder : unsigned char {
  cell_by_cell,
  strips  ///< row by row: one of each cell, then a second one of each, and so on
};

/// Puts particles in the order of tiles and within them. Particles of one cell stay in order, however many threads
/// there are.
void sort_into_tiles(const Grid& grid, CellOrder order, std::vector<BodyParticles>& bodies, Tiles& tiles,
                     ThreadPool& pool);

/// The tiles that will have particles at time 0, in any order.
std::vector<OccupiedTile> occupied_tiles(const Model& model, const Tiles& tiles);

}  // namespace trajan
