#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <vector>

#include "solver/boundaries/conditions.h"
#include "solver/contact/body_contacts.h"
#include "solver/executors/thread_pool.h"
#include "solver/loads/loads.h"
#include "solver/simulation/account.h"
#include "solver/simulation/particle_order.h"
#include "solver/simulation/particles.h"
#include "solver/simulation/pass.h"
#include "solver/simulation/sweeps.h"
#include "solver/simulation/tile_loop.h"
#include "solver/transfers/transfer.h"

namespace trajan {

/// Runs a scheme's passes over particles and grid. Passes over particles are only noted; when somebody needs what
/// they give, the whole chain of them runs on one block after the other, so that particles are read from memory
/// once per chain, across the ends of steps too. Nothing depends on where chains are cut or on the number of
/// threads.
class Executor {
 public:
  /// With `nothing` in its bodies it only finds out which sweeps its passes make.
  enum class Filling { particles, nothing };
  Executor(const Model& model, int threads, Filling filling = Filling::particles);
  ~Executor();

  /// \name What schemes are written with. All throw Diverged.
  /// @{
  void particles(std::initializer_list<Pass> passes);
  /// Accelerations, and velocities after the kick. With `light_node` velocities for gradients as well: the
  /// same, but on nodes of less than this share of the lightest particle's mass those before the kick.
  void update_velocities(const StepTimes& times, double light_node = 0);
  /// Velocities for gradients, from momenta that were mapped a second time, or from mass and momentum.
  void map_velocities(bool with_mass = false);
  /// @}

  /// \name What implicit analyses are written with
  /// @{
  /// Calls of(block, its index among all blocks, its tile), each on some thread.
  void visit(const std::function<void(Block&, std::size_t, std::size_t)>& of);
  Loads& loads() { return loads_; }
  Conditions& conditions() { return conditions_; }
  ThreadPool& pool() { return pool_; }
  /// @}

  /// Runs what has been noted; after it particles may be looked at.
  void finish();
  /// Sorts particles into tiles and makes of initial velocities what the transfer needs.
  void begin();
  /// Sorts particles into tiles and finds everything that depends on their places.
  void sort();
  /// Finds that again without sorting, for particles and tiles that were restored.
  void bind();
  /// From now on windows have a margin, as if a particle had left its tile; before particles are sorted.
  void expect_drift();

  /// Sums and maxima over all particles, in an order that does not depend on the number of threads.
  Totals totals();
  /// Cauchy stress of a particle, components as field_components; `out` has room for six.
  void stress(const Slot& particle, double* out) const;
  std::vector<BodyParticles>& bodies() { return bodies_; }
  const std::vector<BodyParticles>& bodies() const { return bodies_; }
  Tiles& tiles() { return tiles_; }
  const Tiles& tiles() const { return tiles_; }
  /// That a node holds.
  int node_quantities() const { return quantities(transfer_kind_.node_vectors, axes_); }
  /// The surface points of loads and boundary conditions.
  std::vector<Riders*> riders();
  std::int64_t sortings() const { return sortings_; }  ///< for whoever keeps slots
  /// What decides when particles are sorted next.
  ParticleOrder& order() { return order_; }
  const Sweeps& sweeps() const { return sweeps_; }
  /// Whether nothing is done to nodes after all tiles have their velocities.
  bool in_one_pass() const { return !conditions_.on_surfaces() && contacts_.places() == 0; }
  /// Whether work on a tile's nodes needs nothing but the windows around.
  bool by_wave() const { return by_wave_; }
  Account& account() { return account_; }
  const Account& account() const { return account_; }
  /// Multiplies the inertia of a body, by which waves become slower; its weight stays.
  void scale_inertia(std::size_t body, double factor);
  /// After a kick: moves particles back by what they outrun the grid in `drift`, and takes all velocity from them.
  void halt(double drift);
  std::size_t memory() const;
  /// Throws Diverged at the present step, about the particle that looks worst.
  [[noreturn]] void diverge(const std::string& cause, const std::string& remedy) const;

 private:
  /// On nodes of (tile, thread), once all windows around have their sums.
  using NodeWork = std::function<void(std::size_t, std::size_t)>;
  /// Runs what has been noted, and then `work` on all tiles.
  void finish(const NodeWork& work);
  void run(std::span<const Pass> passes, const NodeWork& work = {});
  Trouble sweep_tiles(const Sweep& sweep, const NodeWork& work);
  void run_tile(std::size_t tile, const Sweep& sweep, std::size_t thread);
  Block make_block(const Tile& tile, const BlockRange& range, Scratch& scratch) const;
  template <class Of>
  void or_diverge(Of&& of);
  NodeBlock node_block(std::size_t tile, std::size_t thread);
  void kick_tile(std::size_t tile, std::size_t thread, double light_node);
  void kick_nodes(double light_node), act_between_tiles(double light_node);
  void fold_images(), copy_to_images();  ///< of all tiles
  /// What follows once a tile's velocities are final.
  void complete(NodeBlock& block, std::size_t tile, double light_node);
  /// What the transfer iterates on when nodes have velocities. Those for gradients stay on nodes of less mass.
  void project(const Projection& projection, double light_mass);
  void check(const Trouble& trouble) const;
  std::int64_t worst_particle() const;

  const Model& model_;
  bool rehearsal_;
  int axes_;  ///< of the grid
  const MotionKernels& motion_;
  const Transfer& transfer_kind_;
  ThreadPool pool_;
  TileLoop loop_;
  std::vector<BodyParticles> bodies_;
  std::unique_ptr<BodyGaps> gaps_;  ///< where rigid surfaces need them
  Conditions conditions_;
  BodyContacts contacts_;
  Loads loads_;
  const TransferKernels* transfer_;
  Tiles tiles_;
  Sweeps sweeps_;
  SweepConstants sweep_;
  StepTimes times_;
  std::vector<Pass> noted_;                        ///< passes over particles that are still to be run
  std::vector<std::unique_ptr<Scratch>> scratch_;  ///< by thread
  std::vector<Block> blocks_;                      ///< by thread, that of the last run
  std::vector<NodeSums> collected_;                ///< by thread or by tile
  std::vector<Totals> tile_totals_;
  Account account_;
  bool by_wave_ = false;
  double lightest_particle_ = 0;
  bool accounts_ = false;                  ///< for work and dissipation
  bool looks_for_unborne_forces_ = false;  ///< in this kick
  std::atomic<bool> unborne_forces_ = false;
  std::int64_t sortings_ = 0;
  ParticleOrder order_;
};

}  // namespace trajan
