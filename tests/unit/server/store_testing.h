#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "server/store.h"
#include "server/store_jobs.h"
#include "server/store_leases.h"

namespace trajan::store {

/// Stores in a directory of their own.
class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    std::string name = (std::filesystem::temp_directory_path() / "trajan-store-XXXXXX").string();
    directory_ = mkdtemp(name.data());
  }
  ~StoreTest() override { std::filesystem::remove_all(directory_); }

  std::filesystem::path file() const { return directory_ / "queue.sqlite"; }

  static std::string queue(Store& store, int priority = 0, const std::string& request_id = "") {
    v1::SubmitJobRequest request;
    request.mutable_scene()->set_name("scene");
    request.set_priority(priority);
    request.set_request_id(request_id);
    v1::Job job;
    store.commit([&](Database& database) { job = submit(database, request); });
    return job.job_id();
  }

  static std::optional<Lease> take(Store& store, const std::string& worker) {
    std::optional<Lease> lease;
    store.commit([&](Database& database) { lease = lease_next(database, worker, 0); });
    return lease;
  }

  static v1::Job look(Store& store, std::int64_t job) {
    return store.read([&](Database& database) { return get_job(database, job); });
  }

 private:
  std::filesystem::path directory_;
};

}  // namespace trajan::store
