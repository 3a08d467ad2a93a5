#include "solver/contact/body_contacts.h"

#include <algorithm>
#include <tuple>

#include "solver/contact/meeting.h"

namespace trajan {
namespace {

/// In cells: gaps that may be closed within a step.
constexpr double soon = 0.1;

double mass_of(const Tiles& tiles, std::size_t tile, int node) {
  return tiles.nodes(tile)[tile_array(quantity_mass) + node];
}

bool same_pair(const NodeContact& a, const NodeContact& b) {
  return a.node == b.node && a.first == b.first && a.second == b.second;
}

bool pair_before(const NodeContact& a, const NodeContact& b) {
  return std::tie(a.node, a.first, a.second) < std::tie(b.node, b.first, b.second);
}

}  // namespace

BodyContacts::BodyContacts(const Model& model, int threads)
    : axes_(grid_axes(model.dimension)), plan_(model.contacts), near_(static_cast<std::size_t>(threads)) {
  for (std::size_t body = 0; plan_.fields > 1 && body < model.bodies.size(); ++body)
    surfaces_.emplace_back(model, model.bodies[body]);
}

void BodyContacts::bind(const Tiles& tiles) {
  places_.clear();
  if (plan_.fields == 1) return;
  const auto& all = tiles.tiles();
  for (std::uint32_t first = 0, end; first < all.size(); first = end) {
    for (end = first + 1; end < all.size() && all[end].at == all[first].at;) ++end;
    if (end - first > 1) places_.push_back({first, end - first, {}});
  }
}

template <class Of>
void BodyContacts::for_each_place(ThreadPool& pool, Of&& of) {
  if (places_.empty()) return;
  pool.run([&](int thread) {
    const auto t = static_cast<std::size_t>(thread), threads = static_cast<std::size_t>(pool.size());
    for (std::size_t place = t; place < places_.size(); place += threads) of(places_[place], near_[t]);
  });
}

void BodyContacts::find(ThreadPool& pool, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                        const SweepConstants& sweep, double least_mass) {
  for_each_place(pool, [&](Place& place, Near& near) { find(place, near, tiles, bodies, sweep, least_mass); });
}

double BodyContacts::act(ThreadPool& pool, Tiles& tiles, const HeldComponents& held, double kick) {
  for_each_place(pool, [&](Place& place, Near& near) { act(place, near, tiles, held, kick); });
  double dissipated = 0;
  for (const Place& place : places_) dissipated += place.dissipated;
  return dissipated;
}

Components BodyContacts::impulse_on(std::size_t body, const Tiles& tiles) const {
  Components sum{};
  for (const Place& place : places_)
    for (const NodeContact& contact : place.contacts)
      for (const auto& [field, sign] : {std::pair(contact.first, -1.0), std::pair(contact.second, 1.0)})
        if (tiles.tiles()[place.first + field].field == plan_.field_of[body])
          for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += sign * contact.impulse[axis];
  return sum;
}

void BodyContacts::act_on(ThreadPool& pool, Tiles& tiles, const HeldComponents& held, NodeVector velocities) {
  for_each_place(pool, [&](Place& place, Near& near) { act_on(place, near, tiles, held, velocities); });
}

void BodyContacts::find(Place& place, Near& near, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
                        const SweepConstants& sweep, double least_mass) const {
  near.contacts.clear();
  std::uint64_t some = 0, shared = 0;
  for (std::uint32_t f = 0; f < place.fields; ++f)
    for (int node = 0; node < tile_nodes; ++node) {
      const std::uint64_t bit = std::uint64_t{mass_of(tiles, place.first + f, node) > least_mass} << node;
      shared |= some & bit;
      some |= bit;
    }
  if (shared != 0) {
    near.particles.resize(std::max<std::size_t>(near.particles.size(), place.fields * std::size_t{tile_nodes}));
    for (std::uint32_t f = 0; f < place.fields; ++f) {
      near.of_field.clear();
      for (int node = 0; node < tile_nodes; ++node) {
        near.of_field.push_back(&near.particles[f * std::size_t{tile_nodes} + static_cast<std::size_t>(node)]);
        near.of_field.back()->clear();
      }
      find_nearby(tiles, bodies, surfaces_, sweep, tiles.tiles()[place.first + f], shared, near.of_field);
    }
    for (int node = 0; node < tile_nodes; ++node)
      if (shared >> node & 1u) find_at_node(place, node, tiles, sweep, near);
  }
  // What sticks or presses does so until the next kick, wherever particles have moved.
  for (NodeContact& contact : near.contacts) {
    const auto old = std::lower_bound(place.contacts.begin(), place.contacts.end(), contact, pair_before);
    if (old == place.contacts.end() || !same_pair(*old, contact)) continue;
    contact.sticks = old->sticks;
    contact.impulse = old->impulse;
  }
  place.contacts.assign(near.contacts.begin(), near.contacts.end());
}

void BodyContacts::find_at_node(const Place& place, int node, const Tiles& tiles, const SweepConstants& sweep,
                                Near& near) const {
  for (std::uint32_t a = 0; a < place.fields; ++a)
    for (std::uint32_t b = a + 1; b < place.fields; ++b) {
      if (!(mass_of(tiles, place.first + a, node) > 0 && mass_of(tiles, place.first + b, node) > 0)) continue;
      const auto& friction =
          plan_.between(tiles.tiles()[place.first + a].field, tiles.tiles()[place.first + b].field);
      NodeContact contact;
      contact.node = static_cast<std::uint8_t>(node);
      contact.first = a;
      contact.second = b;
      contact.bonded = !friction;
      contact.friction = friction.value_or(0);
      if (friction) {
        const NearbyParticles& of_a = near.particles[a * std::size_t{tile_nodes} + static_cast<std::size_t>(node)];
        const NearbyParticles& of_b = near.particles[b * std::size_t{tile_nodes} + static_cast<std::size_t>(node)];
        if (of_a.places.empty() || of_b.places.empty()) continue;
        const auto meets = meeting(axes_, of_a, of_b, soon);
        if (!meets) continue;
        contact.normal = meets->normal;
        // At a sample particles stand still, and go on with the next kick.
        const double time = sweep.drift > 0 ? sweep.drift : 2 * sweep.kick;
        contact.approach = std::max(0.0, meets->gap) / (sweep.inverse_cell * time);
      }
      near.contacts.push_back(contact);
    }
}

template <class Of>
void BodyContacts::exchange(const Place& place, std::span<NodeContact> contacts, std::vector<NodeMotion>& motions,
                            const Tiles& tiles, const HeldComponents& held, NodeVector velocities, Of&& of) const {
  motions.assign(place.fields, {});
  for (std::size_t begin = 0, end; begin < contacts.size(); begin = end) {
    const int node = contacts[begin].node;
    for (end = begin; end < contacts.size() && contacts[end].node == node;) ++end;
    for (std::uint32_t f = 0; f < place.fields; ++f) {
      motions[f].mass = mass_of(tiles, place.first + f, node);
      for (int axis = 0; axis < axes_; ++axis)
        motions[f].velocity[static_cast<std::size_t>(axis)] =
            tiles.nodes(place.first + f)[tile_array(quantity(velocities, axis, axes_)) + node];
    }
    const std::size_t at = place.first * std::size_t{tile_nodes} + static_cast<std::size_t>(node);
    const std::span<NodeContact> of_node = contacts.subspan(begin, end - begin);
    exchange_impulses(of_node, motions, held.empty() ? 0u : held[at]);
    of(of_node, motions);
  }
}

void BodyContacts::act(Place& place, Near& near, Tiles& tiles, const HeldComponents& held, double kick) const {
  place.dissipated = 0;
  const auto change = [&](std::span<const NodeContact> contacts, std::vector<NodeMotion>& motions) {
    const int node = contacts[0].node;
    for (std::uint32_t f = 0; f < place.fields; ++f) {
      double* values = tiles.nodes(place.first + f) + node;
      for (int axis = 0; axis < axes_ && motions[f].mass > 0; ++axis) {
        double& a = values[tile_array(quantity(node_acceleration, axis, axes_))];
        double& v = values[tile_array(quantity(node_velocity, axis, axes_))];
        double& changed = motions[f].velocity[static_cast<std::size_t>(axis)];
        a += (changed - v) / kick;
        v = changed;
        // In the middle of the kick.
        changed = v - 0.5 * kick * a;
      }
    }
    for (const NodeContact& contact : contacts) {
      const Components &a = motions[contact.first].velocity, &b = motions[contact.second].velocity;
      place.dissipated += dot(contact.impulse, {a[0] - b[0], a[1] - b[1], a[2] - b[2]});
    }
  };
  exchange(place, place.contacts, near.motions, tiles, held, node_velocity, change);
}

void BodyContacts::act_on(const Place& place, Near& near, Tiles& tiles, const HeldComponents& held,
                          NodeVector velocities) const {
  std::vector<NodeContact>& contacts = near.contacts;
  contacts.assign(place.contacts.begin(), place.contacts.end());
  const auto component = [&](std::uint32_t field, int axis, int node) -> double& {
    return tiles.nodes(place.first + field)[tile_array(quantity(velocities, axis, axes_)) + node];
  };
  for (NodeContact& contact : contacts) {
    double approach = 0;
    for (int axis = 0; axis < axes_; ++axis)
      approach += contact.normal[static_cast<std::size_t>(axis)] *
                  (component(contact.first, axis, contact.node) - component(contact.second, axis, contact.node));
    // What pressed in the last kick does not part either.
    if (dot(contact.impulse, contact.normal) > 0 && approach < contact.approach) {
      for (double& along : contact.normal) along = -along;
      contact.approach = -contact.approach;
    }
    contact.bonded = contact.bonded || contact.sticks;
    contact.friction = 0;
  }
  // Half of it: forces have worked on the mean of the velocities before and after contact, which is what strains
  // must see for energy to be kept. All of it gives energy in proportion to the time step, whichever way particles
  // move.
  const auto change = [&](std::span<const NodeContact> of_node, const std::vector<NodeMotion>& motions) {
    for (std::uint32_t f = 0; f < place.fields; ++f)
      for (int axis = 0; axis < axes_ && motions[f].mass > 0; ++axis) {
        double& v = component(f, axis, of_node[0].node);
        v += 0.5 * (motions[f].velocity[static_cast<std::size_t>(axis)] - v);
      }
  };
  exchange(place, contacts, near.motions, tiles, held, velocities, change);
}

}  // namespace trajan
