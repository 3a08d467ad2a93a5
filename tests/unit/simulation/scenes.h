#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "solver/analyses/run.h"
#include "solver/model/validate.h"

namespace trajan::test {

/// Keeps everything that a run records.
class Memory : public Recorder {
 public:
  void sample(std::int64_t row, double time, std::span<const double> columns) override {
    rows.resize(static_cast<std::size_t>(row));
    rows.emplace_back(columns.begin(), columns.end());
    times.resize(static_cast<std::size_t>(row));
    times.push_back(time);
  }
  void snapshot(std::int64_t, const Snapshot& snapshot) override { snapshots.push_back(snapshot); }
  void checkpoint(const Checkpoint& checkpoint) override { checkpoints.push_back(checkpoint); }
  std::int64_t durable_rows() const override { return static_cast<std::int64_t>(rows.size()); }

  std::vector<double> times;
  std::vector<std::vector<double>> rows;
  std::vector<Snapshot> snapshots;
  std::vector<Checkpoint> checkpoints;
};

/// What a scene records that runs to its end.
inline Memory recorded(const Model& model, int threads = 1) {
  Memory memory;
  RunOptions options;
  options.threads = threads;
  const RunResult result = run(model, options, memory, nullptr);
  EXPECT_EQ(result.end, RunEnd::finished) << (result.divergence ? result.divergence->cause : "");
  return memory;
}

inline std::size_t column(const Model& model, const std::string& name) {
  const std::vector<std::string> names = history_columns(model);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return i;
  throw std::invalid_argument("no column " + name);
}

inline MaterialDefinition material(const std::string& law, double youngs_modulus, double poissons_ratio,
                                   double density) {
  return {"solid", density, law, {{"youngs_modulus", youngs_modulus}, {"poissons_ratio", poissons_ratio}}};
}

/// Two elastic discs that meet in the middle of the unit box (Sulsky, Chen and Schreyer 1994).
inline Scene discs(double cell) {
  Scene scene;
  scene.name = "discs";
  scene.domain = {Dimension::plane_strain, {0, 0}, {1, 1}, cell, 1};
  scene.materials = {material("linear_elastic", 1000, 0.3, 1000)};
  scene.bodies = {{"one", "solid", Disc{{0.2, 0.2}, 0.2}, 2, {"0.1", "0.1"}},
                  {"two", "solid", Disc{{0.8, 0.8}, 0.2}, 2, {"-0.1", "-0.1"}}};
  scene.analysis = {3.5, 0};
  scene.outputs.samples = 35;
  scene.outputs.snapshots = 1;
  return scene;
}

/// The first axial mode of a bar that is fixed at x = 0 (Asiri 2022, section 4.1.3).
inline Scene bar(const std::string& scheme, const std::string& law, double cell, double velocity) {
  Scene scene;
  scene.name = "bar";
  scene.domain = {Dimension::plane_stress, {-2, -2}, {14, 3}, cell, 1};
  scene.materials = {material(law, 100, 0, 1)};
  scene.bodies = {{"bar", "solid", Box{{0, 0}, {10, 1}}, 2, {std::to_string(velocity) + "*sin(pi*x/20)", {}}}};
  scene.boundaries = {{"left", Box{{0, -2}, {0, 3}}, Fixed{{Axis::x}}}};
  scene.analysis = {4, 0};
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 40;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"tip", Vector{10, 0.5}, {Field::displacement, Field::velocity, Field::stress}, ""}};
  return scene;
}

}  // namespace trajan::test
