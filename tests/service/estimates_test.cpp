#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "tests/service/service.h"
#include "trajan/v1/estimates.grpc.pb.h"

namespace trajan::test {
namespace {

v1::Estimate estimate(Service& service, const v1::Scene& scene, double probe_seconds = 0) {
  v1::EstimateJobRequest request;
  *request.mutable_scene() = scene;
  request.set_probe_seconds(probe_seconds);
  grpc::ClientContext context;
  v1::Estimate answer;
  const grpc::Status status = v1::Estimates::NewStub(service.channel())->EstimateJob(&context, request, &answer);
  if (!status.ok()) throw std::runtime_error("estimate: " + status.error_message());
  return answer;
}

/// All files of a server's state that say something, with their bytes. Readers share memory by one more file.
std::map<std::string, std::string> files(const Service& service) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(service.state())) {
    if (!entry.is_regular_file() || entry.path().extension() == ".sqlite-shm") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    found[entry.path().string()] = std::string(std::istreambuf_iterator<char>(file), {});
  }
  return found;
}

TEST(Estimates, change_nothing) {
  Service service;
  const v1::Scene scene = bar(0.001, 20);
  service.wait(service.submit(scene));
  const auto before = files(service);
  EXPECT_GT(estimate(service, scene).steps().value(), 0);
  estimate(service, scene, 0.1);
  EXPECT_EQ(files(service), before);
}

TEST(Estimates, are_kept_beside_what_the_job_took_and_found_again) {
  Service service;
  const v1::Scene scene = bar(0.001, 20);
  const std::string job = service.submit(scene);
  service.wait(job);
  v1::GetPredictionRequest request;
  request.set_job_id(job);
  grpc::ClientContext context;
  v1::Prediction prediction;
  ASSERT_TRUE(v1::Estimates::NewStub(service.channel())->GetPrediction(&context, request, &prediction).ok());
  EXPECT_EQ(static_cast<double>(prediction.steps()), prediction.estimate().steps().value()) << "of a stiff bar";
  EXPECT_GT(prediction.cost().wall_seconds(), 0);
  const v1::Estimate again = estimate(service, scene);
  EXPECT_EQ(again.wall_seconds().source(), v1::Figure::HISTORY);
  EXPECT_EQ(again.wall_seconds().value(), prediction.cost().wall_seconds());
  EXPECT_THAT(again.wall_seconds().basis(), testing::HasSubstr("job " + job));
}

TEST(Estimates, by_a_trial_run_say_so) {
  Service service;
  const v1::Estimate answer = estimate(service, bar(0.001, 20), 5);
  EXPECT_EQ(answer.wall_seconds().source(), v1::Figure::PROBE);
  EXPECT_GT(answer.wall_seconds().value(), 0);
  EXPECT_EQ(answer.steps().source(), v1::Figure::PROBE);
}

// All time steps of a stiff bar are alike, with larger cells too.
TEST(Estimates, by_a_part_of_a_run_know_all_of_its_steps) {
  Service service({"--workers", "0"});
  const v1::Scene scene = bar(4);
  const double steps = estimate(service, scene).steps().value();
  const v1::Figure probed = estimate(service, scene, 0.3).steps();
  EXPECT_EQ(probed.source(), v1::Figure::PROBE);
  EXPECT_THAT(probed.basis(), testing::HasSubstr("% of the run"));
  EXPECT_NEAR(probed.value(), steps, 0.01 * steps) << "samples are not all as far as the probe was";
}

TEST(Estimates, of_a_scene_with_mistakes_are_refused_with_all_of_them) {
  Service service({"--workers", "0"});
  v1::EstimateJobRequest request;
  *request.mutable_scene() = bar();
  request.mutable_scene()->mutable_domain()->set_cell_size(-1);
  grpc::ClientContext context;
  v1::Estimate answer;
  const grpc::Status status = v1::Estimates::NewStub(service.channel())->EstimateJob(&context, request, &answer);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_FALSE(details(context).violations().empty());
}

}  // namespace
}  // namespace trajan::test
