#include "server/store.h"

#include <future>
#include <iterator>
#include <stdexcept>
#include <string>

namespace trajan::store {

namespace {

/// What brings a database from each version to the next; an empty one has version 0.
constexpr const char* migrations[] = {
    R"sql(
  CREATE TABLE jobs(
    job_id INTEGER PRIMARY KEY AUTOINCREMENT,
    state INTEGER NOT NULL,          -- trajan.v1.JobState
    priority INTEGER NOT NULL,
    losses INTEGER NOT NULL,         -- attempts that ended without a word from the worker
    worker TEXT,                     -- holds the lease of the present attempt
    process_id INTEGER NOT NULL,     -- of that worker if it is one of the server's own, or 0
    request_id TEXT UNIQUE,
    job BLOB NOT NULL,               -- trajan.v1.Job without its scene
    request BLOB NOT NULL);          -- trajan.v1.SubmitJobRequest, of a study trajan.v1.SubmitStudyRequest
  CREATE INDEX queued ON jobs(priority DESC, job_id) WHERE state = 1;
  CREATE INDEX leased ON jobs(worker) WHERE worker IS NOT NULL;
  CREATE TABLE labels(
    key TEXT, value TEXT, job_id INTEGER, PRIMARY KEY(job_id, key)) WITHOUT ROWID;
  CREATE TABLE events(
    job_id INTEGER, sequence INTEGER, event BLOB NOT NULL,  -- trajan.v1.Event
    PRIMARY KEY(job_id, sequence)) WITHOUT ROWID;)sql",
    R"sql(
  ALTER TABLE jobs ADD COLUMN is_study INTEGER NOT NULL DEFAULT 0;  -- never leased
  ALTER TABLE jobs ADD COLUMN parent INTEGER;                       -- the study that it is a run of
  ALTER TABLE jobs ADD COLUMN plan BLOB;  -- of a study trajan.v1.Study, of a run trajan.v1.Run: what was planned
  ALTER TABLE jobs ADD COLUMN reuse INTEGER NOT NULL DEFAULT 0;     -- takes over the answer of an equal scene
  ALTER TABLE jobs ADD COLUMN scene TEXT;        -- digest of the scene and the solver's version; NULL for studies
  ALTER TABLE jobs ADD COLUMN answered_by INTEGER;                  -- whose answer it took over
  DROP INDEX queued;
  CREATE INDEX queued ON jobs(priority DESC, job_id) WHERE state = 1 AND is_study = 0;
  CREATE INDEX runs ON jobs(parent) WHERE parent IS NOT NULL;
  CREATE INDEX scenes ON jobs(scene) WHERE scene IS NOT NULL;
  CREATE INDEX answers ON jobs(answered_by) WHERE answered_by IS NOT NULL;
  CREATE TABLE findings(
    job_id INTEGER, measure TEXT, family TEXT NOT NULL, machine TEXT NOT NULL,
    finding BLOB NOT NULL,           -- trajan.v1.Finding
    PRIMARY KEY(job_id, measure)) WITHOUT ROWID;
  CREATE INDEX families ON findings(family, measure);)sql",
    R"sql(
  CREATE TABLE predictions(
    job_id INTEGER PRIMARY KEY, family TEXT NOT NULL,
    ended INTEGER NOT NULL,          -- whether what the job took is known
    prediction BLOB NOT NULL);       -- trajan.v1.Prediction
  CREATE INDEX predicted_families ON predictions(family);
  CREATE TABLE calibrations(
    machine TEXT, version TEXT,      -- of the solver
    calibration BLOB NOT NULL,       -- trajan.v1.Calibration
    PRIMARY KEY(machine, version)) WITHOUT ROWID;)sql",
};
constexpr std::int64_t schema_version = std::size(migrations);

/// WAL: readers and the writer do not wait for each other. FULL: a commit is on disk before it returns.
void configure(Database& database) { database.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;"); }

void bring_to_present_schema(Database& database) {
  std::int64_t version = 0;
  {
    Statement query = database.prepare("PRAGMA user_version");
    query.step();
    version = query.integer(0);
  }
  if (version > schema_version) {
    throw std::runtime_error("the database has schema version " + std::to_string(version) +
                             "; this program knows versions up to " + std::to_string(schema_version));
  }
  for (; version < schema_version; ++version) {
    const std::string next = std::to_string(version + 1);
    database.execute(
        ("BEGIN IMMEDIATE;" + std::string(migrations[version]) + "PRAGMA user_version = " + next + "; COMMIT;")
            .c_str());
  }
}

}  // namespace

Store::Store(const std::filesystem::path& file) : writer_(file), reader_(file) {
  configure(writer_);
  bring_to_present_schema(writer_);
  configure(reader_);
  reader_.execute("PRAGMA query_only = ON");
  thread_ = std::thread([this] { write_until_closed(); });
}

Store::~Store() { close(); }

void Store::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Store::commit(Change change, Done done) {
  {
    const std::lock_guard lock(mutex_);
    if (!closed_) {
      pending_.push_back({std::move(change), std::move(done), nullptr});
      wake_.notify_all();
      return;
    }
  }
  done(std::make_exception_ptr(std::runtime_error("the store is closed")));
}

void Store::commit(Change change) {
  std::promise<void> committed;
  commit(std::move(change), [&](std::exception_ptr error) {
    if (error) {
      committed.set_exception(error);
    } else {
      committed.set_value();
    }
  });
  committed.get_future().get();
}

void Store::write_until_closed() {
  while (true) {
    std::vector<Pending> batch;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return closed_ || !pending_.empty(); });
      if (pending_.empty()) return;
      batch.swap(pending_);
    }
    write(batch);
    for (Pending& entry : batch) entry.done(entry.error);
  }
}

void Store::write(std::vector<Pending>& batch) {
  try {
    writer_.execute("BEGIN IMMEDIATE");
    for (Pending& entry : batch) {
      writer_.execute("SAVEPOINT change");
      try {
        entry.change(writer_);
      } catch (...) {
        entry.error = std::current_exception();
        writer_.execute("ROLLBACK TO change");
      }
      writer_.execute("RELEASE change");
    }
    writer_.execute("COMMIT");
  } catch (...) {
    for (Pending& entry : batch) entry.error = std::current_exception();
    try {
      writer_.execute("ROLLBACK");
    } catch (const std::exception&) {
      // SQLite has rolled back by itself, as it does on a full disk.
    }
  }
}

}  // namespace trajan::store
