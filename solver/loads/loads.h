#pragma once

#include "solver/loads/body_fields.h"
#include "solver/loads/loaded_tiles.h"
#include "solver/surfaces/riders.h"

namespace trajan {

/// Loads on surfaces and on whole bodies.
class Loads {
 public:
  explicit Loads(const Model& model);
  bool none() const { return model_.surface_loads.empty() && model_.body_loads.empty(); }

  /// Whether nodes get any from elsewhere than particles.
  bool on_surfaces() const { return !model_.surface_loads.empty(); }
  /// Whether loads depend on where particles are.
  bool follow_particles() const { return fields_.follow_particles(); }

  /// Finds the carriers after particles have been sorted.
  void bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles);
  /// Evaluates everything that depends on time, and sets the bodies' accelerations. Throws FormulaNotFinite.
  void prepare(std::vector<BodyParticles>& bodies, double time);
  /// Adds the surface loads to the windows of the carriers' tiles.
  void add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies);
  /// Whether a tile's nodes may have got anything of them.
  bool reach(std::size_t tile) const { return !none() && loaded_.are_near(tile); }
  /// Whether sweeps over particles clear the sums of loads.
  bool are_everywhere() const { return loaded_.everywhere(); }
  /// Moves the points; to be called before the particles move.
  void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift);

  /// Moves them by displacements that the nodes hold in the place of velocities.
  void displace(const Tiles& tiles, const std::vector<BodyParticles>& bodies);

  /// What each surface load's forces are multiplied by at the present time.
  const std::vector<double>& factors() const { return factors_; }
  /// The points of each surface load.
  std::vector<Riders>& riders() { return riders_; }

 private:
  /// A force on a node of a tile's window.
  struct NodeForce {
    std::uint32_t tile;
    int node;
    Vector force;
  };
  /// The nodes that a point's force goes to, and its shares of them.
  struct PlaceOfForce {
    Riders::Stencil stencil;
    Riders::Values weights;
  };
  PlaceOfForce place(std::size_t load, std::size_t p, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                     Riders::Of of) const;
  /// The same, but where nodes of a domain have no mass that of the carrier's place.
  PlaceOfForce place_on_mass(std::size_t load, std::size_t p, Tiles& tiles,
                             const std::vector<BodyParticles>& bodies) const;
  template <class Of>
  void give(std::size_t load, std::size_t p, const PlaceOfForce& at, Of&& of) const;
  /// Whether a surface load's points, and the nodes of their carriers, stay where they are.
  bool lasts(std::size_t load) const;
  void find_lasting(std::size_t load, const std::vector<BodyParticles>& bodies, const Tiles& tiles);

  const Model& model_;
  int axes_;                    ///< of the grid
  std::vector<Riders> riders_;  ///< by surface load
  BodyFields fields_;
  LoadedTiles loaded_;
  /// By surface load that lasts, for a factor of one: found once, with one force for all points around a node.
  /// With a load on one of a cube's faces 10^5 particles took 59 -> 45 ns per particle and step in a disturbed
  /// round.
  std::vector<std::vector<NodeForce>> lasting_;
  std::vector<double> factors_;  ///< by surface load
};

}  // namespace trajan
