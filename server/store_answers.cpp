#include "server/store_answers.h"

#include <vector>

#include "server/store_jobs.h"

namespace trajan::store {

namespace {

std::vector<std::int64_t> numbers(Statement& query) {
  std::vector<std::int64_t> found;
  while (query.step()) found.push_back(query.integer(0));
  return found;
}

void answer(Database& database, std::int64_t number, const v1::Job& by) {
  v1::Job job = get_job(database, number);
  *job.mutable_measures() = by.measures();
  *job.mutable_result() = by.result();
  *job.mutable_cost() = by.cost();
  job.set_answered_by(by.job_id());
  add_warnings(database, job, by.warnings());
  append_message(database, job, "answered by job " + by.job_id() + ", which has an equal scene");
  enter(database, job, v1::SUCCEEDED);
  database.prepare("UPDATE jobs SET answered_by = ? WHERE job_id = ?")
      .bind(1, job_number(by.job_id()))
      .bind(2, number)
      .run();
  update(database, job);
}

}  // namespace

void take_over_answer(Database& database, std::int64_t job) {
  std::int64_t by = 0;
  {
    Statement query = database.prepare(
        "SELECT done.job_id FROM jobs AS waiting JOIN jobs AS done ON done.scene = waiting.scene "
        "WHERE waiting.job_id = ? AND waiting.state = 1 AND waiting.reuse AND done.state = 4 "
        "AND done.answered_by IS NULL LIMIT 1");
    if (!query.bind(1, job).step()) return;
    by = query.integer(0);
  }
  answer(database, job, get_job(database, by));
}

void answer_equal_scenes(Database& database, const v1::Job& job) {
  std::vector<std::int64_t> waiting;
  {
    Statement query = database.prepare(
        "SELECT waiting.job_id FROM jobs AS done JOIN jobs AS waiting ON waiting.scene = done.scene "
        "WHERE done.job_id = ? AND waiting.state = 1 AND waiting.reuse ORDER BY waiting.job_id");
    waiting = numbers(query.bind(1, job_number(job.job_id())));
  }
  for (const std::int64_t number : waiting) answer(database, number, job);
}

void forget_answer(Database& database, std::int64_t job) {
  std::vector<std::int64_t> answered;
  {
    Statement query = database.prepare("SELECT job_id FROM jobs WHERE answered_by = ?");
    answered = numbers(query.bind(1, job));
  }
  for (const std::int64_t number : answered) {
    v1::Job other = get_job(database, number);
    other.clear_result();
    update(database, other);
  }
}

}  // namespace trajan::store
