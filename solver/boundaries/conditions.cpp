#include "solver/boundaries/conditions.h"

#include <algorithm>

#include "solver/boundaries/registry.h"

namespace trajan {

GridFrame::GridFrame(const Model& model)
    : dimensions(grid_axes(model.dimension)), origin(model.grid.origin), cell(model.grid.cell) {
  for (std::size_t axis = 0; axis < period.size(); ++axis)
    if (model.grid.periodic[axis]) period[axis] = model.grid.cells()[axis];
}

Conditions::Conditions(const Model& model) : axes_(grid_axes(model.dimension)), count_(model.conditions.size()) {
#define TRAJAN_MAKE(Kind) Kind::make(model, on_nodes_);
  TRAJAN_FOR_EACH_NODE_CONDITION(TRAJAN_MAKE)
#undef TRAJAN_MAKE
#define TRAJAN_MAKE(Kind) Kind::make(model, on_surfaces_);
  TRAJAN_FOR_EACH_SURFACE_CONDITION(TRAJAN_MAKE)
#undef TRAJAN_MAKE
  const auto works = [](const auto& condition) { return condition->works(); };
  work_ = std::ranges::any_of(on_nodes_, works) || std::ranges::any_of(on_surfaces_, works);
}

void Conditions::bind(const std::vector<BodyParticles>& bodies, Tiles& tiles) {
  tiles_.clear();
  for (std::size_t t = 0; t < tiles.tiles().size(); ++t) {
    TileNodes nodes{axes_, {}, tiles.nodes(t)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      nodes.first[axis] = std::int64_t{tiles.tiles()[t].at[axis]} * tiles.layout().side;
    tiles_.push_back(nodes);
  }
  if (on_nodes_.empty() && on_surfaces_.empty()) return;
  held_.assign(tiles_.size() * TileNodes::count, 0);
  for (auto& condition : on_nodes_) condition->bind(tiles_, held_);
  for (auto& condition : on_surfaces_) condition->bind(bodies, tiles);
  if (kick_) prepare(*kick_);
}

void Conditions::prepare(const Kick& kick) {
  kick_ = kick;
  for (auto& condition : on_nodes_) condition->prepare(kick);
  for (auto& condition : on_surfaces_) condition->prepare(kick);
}

void Conditions::act(std::size_t tile, std::span<Reaction> reactions) {
  for (auto& condition : on_nodes_) condition->act(tile, tiles_[tile], reactions);
}

void Conditions::act_on_mapped(std::size_t tile) const {
  for (const auto& condition : on_nodes_) condition->act_on_mapped(tile, tiles_[tile]);
}

void Conditions::act_on_surfaces(const std::vector<BodyParticles>& bodies, Tiles& tiles,
                                 std::span<Reaction> reactions) {
  for (auto& condition : on_surfaces_) {
    condition->find_nodes(bodies, tiles);
    reactions[condition->condition()] += condition->act(tiles, held_);
  }
}

void Conditions::act_on_mapped_surfaces(const std::vector<BodyParticles>& bodies, Tiles& tiles, bool moved) {
  for (auto& condition : on_surfaces_) {
    if (moved) condition->find_nodes(bodies, tiles);
    condition->act_on_mapped(tiles, held_);
  }
}

void Conditions::hold(std::size_t tile, double* vector) const {
  if (held_.empty()) return;
  const std::uint8_t* held = held_.data() + tile * TileNodes::count;
  for (int axis = 0; axis < axes_; ++axis)
    for (int node = 0; node < TileNodes::count; ++node)
      if (held[node] >> axis & 1) vector[axis * TileNodes::count + node] = 0;
}

void Conditions::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  for (auto& condition : on_surfaces_) condition->advect(tiles, bodies, drift);
}

std::vector<Riders*> Conditions::riders() const {
  std::vector<Riders*> riders;
  for (const auto& condition : on_surfaces_) riders.push_back(&condition->riders());
  return riders;
}

void Conditions::constrain(const std::vector<BodyParticles>& bodies, const Tiles& tiles, double from, double to,
                           DisplacementConstraints& of_nodes, MeanConstraints& of_means) {
  for (const auto& condition : on_nodes_) condition->constrain(from, to, of_nodes);
  for (const auto& condition : on_surfaces_) {
    condition->find_nodes(bodies, tiles);
    condition->constrain(from, to, of_means);
  }
}

}  // namespace trajan
