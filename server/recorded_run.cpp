#include "server/recorded_run.h"

#include "solver/analyses/background_recorder.h"
#include "solver/measures/measure.h"
#include "solver/model/validate.h"
#include "solver/results/results.h"

namespace trajan {

RecordedRun record_run(const Scene& scene, const std::filesystem::path& directory, int threads,
                       const CostlyStop& stop) {
  const RunCost cost(threads);
  RecordedRun recorded;
  std::filesystem::create_directories(directory);
  {
    const Model model = validate(scene);
    const auto writer = results::ResultWriter::open(directory, model, {"", TRAJAN_VERSION});
    RunOptions options;
    options.threads = threads;
    BackgroundRecorder background(*writer);
    recorded.result =
        run(model, options, background, [&](const RunProgress& progress) { return stop && stop(progress, cost); });
    background.finish();
    std::vector<double> time, values;
    writer->histories(time, values);
    const std::vector<MeasureValue> measures =
        recorded.result.end == RunEnd::finished ? evaluate(model, time, values) : std::vector<MeasureValue>();
    results::write_xdmf(writer->finish(results::Status::succeeded, measures, {}).path);
    recorded.cost = cost.so_far();
  }
  std::filesystem::remove_all(directory);
  return recorded;
}

}  // namespace trajan
