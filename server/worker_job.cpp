#include "server/worker_job.h"

#include <new>

#include "server/convert.h"
#include "server/log.h"
#include "server/run_cost.h"
#include "solver/analyses/background_recorder.h"
#include "solver/measures/measure.h"
#include "solver/results/results.h"

namespace trajan {

namespace {

v1::ResultFile to_message(const results::FinishedFile& file) {
  v1::ResultFile message;
  message.set_name(results::result_name);
  message.set_size(file.size);
  message.set_sha256(file.sha256);
  message.set_complete(file.complete);
  message.set_path(file.path.string());
  return message;
}

v1::Failure make_failure(const std::string& reason, const std::string& text, const std::string& remedy) {
  v1::Failure failure;
  failure.set_reason(reason);
  failure.set_message(text);
  failure.set_remedy(remedy);
  failure.set_particle(-1);
  return failure;
}

/// Says how a run ended whose file is finished.
void describe(const results::FinishedRun& run, v1::CompleteRequest& request) {
  results::write_xdmf(run.file.path);
  *request.mutable_result() = to_message(run.file);
  for (const Warning& warning : run.warnings) *request.add_warnings() = to_proto(warning);
  switch (run.status) {
    case results::Status::succeeded:
      request.mutable_succeeded();
      for (const MeasureValue& measure : run.measures) {
        *request.mutable_succeeded()->add_measures() = to_proto(measure);
      }
      break;
    case results::Status::diverged:
      *request.mutable_failed() = to_proto(run.divergence.value_or(Divergence{}));
      break;
    case results::Status::cancelled:
    case results::Status::running:
      request.mutable_cancelled();
      break;
  }
}

void finish(results::FinishedRun run, results::ResultWriter& writer, v1::CompleteRequest& request) {
  run.warnings = writer.warnings();
  run.file = writer.finish(run.status, run.measures, run.divergence);
  describe(run, request);
}

std::vector<MeasureValue> evaluate_measures(const Model& model, results::ResultWriter& writer) {
  std::vector<double> time;
  std::vector<double> values;
  writer.histories(time, values);
  return evaluate(model, time, values);
}

/// A lost lease leaves the outcome unset.
void stop(Command command, results::ResultWriter& writer, v1::CompleteRequest& request) {
  if (command == Command::cancel) {
    finish({{}, results::Status::cancelled, {}, {}, {}}, writer, request);
  } else if (command != Command::lost) {
    writer.suspend();
    request.mutable_released();
  }
}

/// Records, and tells the server at once what it warns of.
class TellingRecorder : public Recorder {
 public:
  TellingRecorder(Recorder& recorder, LeaseKeeper& keeper) : recorder_(recorder), keeper_(keeper) {}
  void sample(std::int64_t row, double time, std::span<const double> columns) override {
    recorder_.sample(row, time, columns);
  }
  void snapshot(std::int64_t row, const Snapshot& snapshot) override { recorder_.snapshot(row, snapshot); }
  void checkpoint(const Checkpoint& checkpoint) override { recorder_.checkpoint(checkpoint); }
  void warn(const Warning& warning) override {
    recorder_.warn(warning);
    keeper_.tell(to_proto(warning));
  }
  std::int64_t durable_rows() const override { return recorder_.durable_rows(); }

 private:
  Recorder& recorder_;
  LeaseKeeper& keeper_;
};

/// The file is written while the solver goes on.
RunResult run_recorded(const Model& model, const RunOptions& options, Recorder& recorder, LeaseKeeper& keeper) {
  TellingRecorder telling(recorder, keeper);
  BackgroundRecorder background(telling);
  const RunResult result =
      run(model, options, background, [&](const RunProgress& progress) { return keeper.update(progress); });
  background.finish();
  return result;
}

void compute(const v1::LeaseResponse& lease, int threads, LeaseKeeper& keeper, v1::CompleteRequest& request) {
  const results::Provenance provenance{lease.scene_text(), TRAJAN_VERSION};
  if (const auto earlier = results::finished_run(lease.directory(), provenance))
    return describe(*earlier, request);
  const Model model = validate(to_scene(lease.scene()));
  const auto writer = results::ResultWriter::open(lease.directory(), model, provenance);
  RunOptions options;
  options.threads = model.numerics.threads.value_or(threads);
  options.checkpoint_interval = lease.checkpoint_interval_seconds();
  options.resume = writer->resume_point();
  const RunResult result = run_recorded(model, options, *writer, keeper);
  keeper.update(result.progress);
  *request.mutable_progress() = keeper.progress();
  switch (result.end) {
    case RunEnd::finished:
      return finish({{}, results::Status::succeeded, evaluate_measures(model, *writer), {}, {}}, *writer, request);
    case RunEnd::diverged:
      return finish({{}, results::Status::diverged, {}, result.divergence, {}}, *writer, request);
    case RunEnd::stopped:
      return stop(keeper.command(), *writer, request);
  }
}

}  // namespace

std::optional<v1::CompleteRequest> run_job(const v1::LeaseResponse& lease, int threads, LeaseKeeper& keeper) {
  v1::CompleteRequest request;
  request.set_lease_id(lease.lease_id());
  const RunCost cost(threads);
  try {
    compute(lease, threads, keeper, request);
    if (request.outcome_case() == v1::CompleteRequest::OUTCOME_NOT_SET) return std::nullopt;
  } catch (const InvalidScene& invalid) {
    *request.mutable_failed() = make_failure("INTERNAL", invalid.what(), "submit the scene again");
  } catch (const std::bad_alloc&) {
    *request.mutable_failed() = make_failure("OUT_OF_MEMORY", "the solver got no more memory",
                                             "use larger cells, fewer particles, or a machine with more memory");
  } catch (const std::exception& error) {
    *request.mutable_failed() =
        make_failure("RESULT_IO", error.what(), "see that there is space and permission in " + lease.directory());
  }
  *request.mutable_cost() = cost.so_far();
  return request;
}

}  // namespace trajan
