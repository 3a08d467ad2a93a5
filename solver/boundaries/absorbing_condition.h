#pragma once

#include "solver/boundaries/surface_condition.h"

namespace trajan {

/// Viscous dashpots on a surface (Lysmer and Kuhlemeyer 1969, equations 6 and 7 with a = b = 1), implicit by
/// the trapezoidal rule: stable for every time step, and what they consume is exact.
class AbsorbingCondition : public SurfaceCondition {
 public:
  static void make(const Model& model, std::vector<std::unique_ptr<SurfaceCondition>>& conditions);
  AbsorbingCondition(const Model& model, const AbsorbingSurface& surface, std::size_t condition);
  bool works() const override { return true; }
  void prepare(const Kick& kick) override { kick_ = kick.length(); }
  Reaction act(Tiles& tiles, const HeldComponents& held) override;
  void act_on_mapped(Tiles&, const HeldComponents&) const override {}

 private:
  const AbsorbingSurface& surface_;
  double kick_ = 0;
};

}  // namespace trajan
