#pragma once

#include <cmath>

#include "solver/implicit/quasi_static_steps.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan::test {

/// A block from the origin to (length, 1), whose nodes at x = 0 are held along x and whose node at the origin is
/// held.
inline Scene block(Dimension dimension, const std::string& law, double length, double cell,
                   double poissons_ratio) {
  Scene scene;
  scene.name = "block";
  const bool bar = dimension == Dimension::bar;
  scene.domain = {dimension, {-1, bar ? 0.0 : -1}, {2 * length + 1, bar ? 0.0 : 3}, cell, 1};
  if (bar) scene.domain.thickness.reset(), scene.domain.cross_section = 1;
  scene.materials = {material(law, 100, poissons_ratio, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {length, bar ? 0.0 : 1}}, 2, {}}};
  scene.boundaries = {{"left", Box{{-1, bar ? 0.0 : -1}, {0, bar ? 0.0 : 3}}, Fixed{{Axis::x}}}};
  if (!bar) scene.boundaries.push_back({"bottom", Box{{-1, -1}, {2 * length + 1, 0}}, Fixed{{Axis::y}}});
  scene.analysis = {1, 0, QuasiStatic{}};
  scene.numerics.scheme = "TLMPM";
  scene.outputs.samples = 2;
  scene.outputs.snapshots = 1;
  return scene;
}

inline EdgeTraction traction(const std::string& body, Edge edge, Vector value) {
  EdgeTraction load;
  load.body = body;
  load.edge = edge;
  load.traction = value;
  return load;
}

/// A load that grows from 0 to its value at the end.
template <class Kind>
LoadDefinition growing(Kind kind) {
  return {"load", std::move(kind), "t"};
}

struct Answer {
  RunResult result;
  Memory memory;
};
inline Answer solve(const Model& model, int threads = 1) {
  Answer answer;
  RunOptions options;
  options.threads = threads;
  options.checkpoint_interval = 1e9;
  answer.result = run(model, options, answer.memory, {});
  return answer;
}

/// Runs a model of four samples whole, in three threads, and again from its second checkpoint.
inline void expect_same_bits_always(const Model& model) {
  Memory whole, threads, resumed;
  RunOptions options;
  options.checkpoint_interval = 0;
  run(model, options, whole, {});
  ASSERT_EQ(whole.rows.size(), 5u);
  options.threads = 3;
  run(model, options, threads, {});
  EXPECT_EQ(threads.rows, whole.rows);
  options.threads = 1;
  options.resume = whole.checkpoints.at(1);
  resumed.rows = {whole.rows.begin(), whole.rows.begin() + 3};
  run(model, options, resumed, {});
  EXPECT_EQ(resumed.rows, whole.rows);
  EXPECT_EQ(resumed.snapshots.back().position, whole.snapshots.back().position);
}

}  // namespace trajan::test
