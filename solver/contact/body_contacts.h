#pragma once

#include <cstdint>
#include <vector>

#include "solver/boundaries/condition.h"
#include "solver/contact/impulses.h"
#include "solver/contact/nearby_particles.h"
#include "solver/executors/thread_pool.h"
#include "solver/model/model.h"

namespace trajan {

/// Contact between bodies by velocity fields of their own (Bardenhagen et al. 2001). Fields feel each other at
/// nodes that both have mass at, where their particles touch (Nairn, Hammerquist and Smith 2020). What happens at
/// a node does not depend on any other one, so that places may be worked on in any order by any thread.
class BodyContacts {
 public:
  BodyContacts(const Model& model, int threads);

  /// Finds the places where tiles of several fields lie, after particles have been sorted.
  void bind(const Tiles& tiles);
  /// How many such places there are; 0 as long as no two fields come near each other.
  std::size_t places() const { return places_.size(); }

  /// Finds where fields touch. `least_mass`: nodes with less do not move.
  void find(ThreadPool& pool, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
            const SweepConstants& sweep, double least_mass);
  /// Changes accelerations and velocities after a kick of this length. Returns the energy that is dissipated.
  double act(ThreadPool& pool, Tiles& tiles, const HeldComponents& held, double kick);
  /// The impulse of that kick on a body by all others.
  Components impulse_on(std::size_t body, const Tiles& tiles) const;
  /// Makes other velocities of the nodes fit: what touches does not come closer, what stuck in the last kick still
  /// sticks. Friction has had its impulse.
  void act_on(ThreadPool& pool, Tiles& tiles, const HeldComponents& held, NodeVector velocities);

 private:
  /// Consecutive tiles of different fields in the same place, and what touches at their nodes, by node.
  struct Place {
    std::uint32_t first = 0, fields = 0;
    std::vector<NodeContact> contacts;
    double dissipated = 0;
  };
  /// Working memory of one thread.
  struct Near {
    std::vector<NearbyParticles> particles;  ///< by field and node
    std::vector<NearbyParticles*> of_field;  ///< by node
    std::vector<NodeContact> contacts;
    std::vector<NodeMotion> motions;  ///< by field
  };
  /// Calls of(place, working memory).
  template <class Of>
  void for_each_place(ThreadPool& pool, Of&& of);
  void find(Place& place, Near& near, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
            const SweepConstants& sweep, double least_mass) const;
  void act(Place& place, Near& near, Tiles& tiles, const HeldComponents& held, double kick) const;
  void act_on(const Place& place, Near& near, Tiles& tiles, const HeldComponents& held,
              NodeVector velocities) const;
  void find_at_node(const Place& place, int node, const Tiles& tiles, const SweepConstants& sweep,
                    Near& near) const;
  /// Lets the fields exchange impulses, and calls of(contacts, motions) for every node of the place where they do.
  template <class Of>
  void exchange(const Place& place, std::span<NodeContact> contacts, std::vector<NodeMotion>& motions,
                const Tiles& tiles, const HeldComponents& held, NodeVector velocities, Of&& of) const;

  int axes_;
  ContactPlan plan_;
  std::vector<BodySurface> surfaces_;  ///< by body
  std::vector<Place> places_;
  std::vector<Near> near_;  ///< by thread
};

}  // namespace trajan
