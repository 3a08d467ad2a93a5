#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "solver/results/results.h"

/// A run without physics: every recorded value is a known function of its place, so that tests can say
/// what a result file must hold.
namespace trajan::results::rehearsal {

/// A directory that is removed with its content.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Two bodies, two probes, one measure with an exact value and one without.
Model make_model(int samples, int snapshots, Dimension dimension = Dimension::plane_strain);
Provenance provenance();

double time_of(const Model& model, std::int64_t row);
double column_value(std::int64_t row, std::size_t column);
/// All rows of a block, (rows, columns) row-major.
std::vector<double> rows_of(const HistoryBlock& block, std::size_t columns);
double particle_value(std::int64_t row, std::int64_t particle, std::string_view what, std::size_t component);
std::vector<MeasureValue> measure_values(const Model& model);

struct Plan {
  std::int64_t samples_per_checkpoint = 7;
  std::int64_t stop_after_row = -1;  ///< -1: goes to the end
  std::function<void(std::int64_t row)> after_sample = [](std::int64_t) {};
  std::function<void(std::int64_t sample)> after_checkpoint = [](std::int64_t) {};
};
/// Records what is left to record: all of it, or from the writer's resume point on. Fails the test's
/// process (std::logic_error) if the checkpoint is not what was stored.
void record(ResultWriter& writer, const Model& model, const Plan& plan = {});
/// Opens, records, finishes.
FinishedFile run_to_end(const std::filesystem::path& directory, const Model& model, const Plan& plan = {});

/// Empty if both files hold the same datasets with the same bits, otherwise what differs.
std::string difference(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace trajan::results::rehearsal
