#include "server/store_estimates.h"

#include "tests/unit/server/store_testing.h"

namespace trajan::store {
namespace {

class EstimatesTest : public StoreTest {
 protected:
  /// A job that is expected to take so long.
  static std::string expect(Store& store, double seconds) {
    const std::string job = queue(store);
    v1::Estimate estimate;
    estimate.mutable_wall_seconds()->set_value(seconds);
    store.commit(
        [&](Database& database) { keep_estimate(database, job, get_scene(database, job_number(job)), estimate); });
    return job;
  }

  static void finish(Store& store, double seconds) {
    const auto lease = take(store, "worker");
    v1::CompleteRequest request;
    request.set_lease_id(lease_id(*lease));
    request.mutable_succeeded();
    request.mutable_progress()->set_step(7);
    request.mutable_cost()->set_wall_seconds(seconds);
    store.commit([&](Database& database) { complete(database, request); });
  }

  static std::vector<v1::Prediction> finished(Store& store) {
    return store.read([](Database& database) { return predictions(database, "", 10); });
  }
};

TEST_F(EstimatesTest, StayBesideWhatTheJobTookAlsoWhenItIsRemoved) {
  Store store(file());
  const std::string job = expect(store, 2);
  EXPECT_TRUE(finished(store).empty());
  finish(store, 3);
  store.commit([&](Database& database) { remove_job(database, job_number(job)); });
  const auto found = finished(store);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].job_id(), job);
  EXPECT_EQ(found[0].estimate().wall_seconds().value(), 2);
  EXPECT_EQ(found[0].cost().wall_seconds(), 3);
  EXPECT_EQ(found[0].steps(), 7);
}

TEST_F(EstimatesTest, OfAJobThatNeverRanGoWithIt) {
  Store store(file());
  const std::string job = expect(store, 2);
  store.commit([&](Database& database) {
    cancel(database, job_number(job), "");
    remove_job(database, job_number(job));
  });
  EXPECT_FALSE(store.read([&](Database& database) { return find_prediction(database, job_number(job)); }));
}

TEST_F(EstimatesTest, OfWaitingJobsMakeTheQueue) {
  Store store(file());
  const auto wait = [&](int workers) {
    return store.read([&](Database& database) { return queue_seconds(database, 0, workers); });
  };
  EXPECT_EQ(wait(1), 0);
  expect(store, 2);
  expect(store, 4);
  EXPECT_EQ(wait(1), 6);
  EXPECT_EQ(wait(2), 3);
  EXPECT_EQ(wait(3), 0) << "a worker is free";
}

TEST_F(EstimatesTest, FindTheCalibrationOfTheMachineAndVersion) {
  Store store(file());
  v1::Calibration calibration;
  calibration.set_machine("this");
  calibration.set_solver_version(TRAJAN_VERSION);
  (*calibration.mutable_seconds())["step"] = 1e-9;
  v1::Calibration old = calibration;
  old.set_machine("that");
  old.set_solver_version("0.0");
  store.commit([&](Database& database) {
    keep_calibration(database, calibration);
    keep_calibration(database, old);
  });
  const auto find = [&](const char* machine) {
    return store.read([&](Database& database) { return find_calibration(database, machine); });
  };
  ASSERT_TRUE(find("this"));
  EXPECT_EQ(find("this")->seconds().at("step"), 1e-9);
  EXPECT_FALSE(find("that"));
}

}  // namespace
}  // namespace trajan::store
