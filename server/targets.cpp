#include "server/targets.h"

#include <algorithm>

#include "server/log.h"
#include "server/store_jobs.h"
#include "server/study_target.h"

namespace trajan {

void Targets::recover() {
  for (const std::int64_t study : store_.read(store::open_studies)) look_at(study);
}

void Targets::look_at(std::int64_t study) {
  tasks_.post([this, study] {
    try {
      advance(study);
    } catch (const std::exception& error) {
      // It was deleted, or the server ends.
      logging::warning("target not led on", {{"job", std::to_string(study)}, {"why", error.what()}});
    }
  });
}

void Targets::advance(std::int64_t number) {
  v1::Study study;
  v1::Scene scene;
  store_.read([&](store::Database& database) {
    const v1::Job job = store::get_job(database, number);
    if (job.study().kind() != "target" || store::has_ended(job.state())) return;
    study = store::get_study(database, number);
    scene = store::get_scene(database, number);
  });
  const bool waits =
      std::ranges::all_of(study.runs(), [](const v1::Run& run) { return store::has_ended(run.state()); });
  if (!study.has_job() || study.job().state() == v1::CANCELLING || !waits) return;
  const TargetStep step = next_step(scene, study);
  store_.commit([&](store::Database& database) {
    if (step.run) {
      store::add_run(database, number, *step.run, study.runs_size(), step.message);
    } else {
      store::conclude(database, number, step.answer, step.message);
    }
  });
  hub_.publish(number);
  if (!step.run) return;
  assign_();
  look_at(number);  // it may have taken over an answer
}

}  // namespace trajan
