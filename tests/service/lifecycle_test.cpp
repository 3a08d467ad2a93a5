#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "tests/service/service.h"

namespace trajan::test {
namespace {

TEST(Server, gives_jobs_back_and_ends_on_SIGTERM_and_the_queue_survives) {
  Service service({"--checkpoint-interval", "0.2"});
  const std::string running = service.submit(bar());
  const std::string waiting = service.submit(bar(0.001, 20));
  service.wait_for_checkpoint(running);
  std::vector<v1::Event> events;
  v1::Job last;
  const auto status = service.watch(running, events, last, [&](const v1::WatchJobResponse& response) {
    if (response.has_job()) service.server().send(SIGTERM);
    return false;
  });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(service.server().wait(), 0);
  EXPECT_TRUE(service.workers().empty());
  service.restart();
  const v1::Job done = service.wait(running);
  EXPECT_EQ(done.state(), v1::SUCCEEDED) << done.ShortDebugString();
  EXPECT_EQ(done.attempts(), 2);
  EXPECT_EQ(service.wait(waiting).state(), v1::SUCCEEDED);
}

TEST(Server, refuses_to_listen_where_others_could_connect) {
  const TemporaryDirectory state;
  for (const char* address : {"0.0.0.0:0", "[::]:0", "192.0.2.1:5000", "example.org:5000", "unix:", "5000"}) {
    Process server({"serve", "--state", state.path().string(), "--listen", address, "--log-level", "off"});
    EXPECT_EQ(server.read_line(), "") << address;
    EXPECT_EQ(server.wait(), 2) << address;
  }
}

TEST(Server, refuses_a_socket_whose_path_is_too_long) {
  const TemporaryDirectory state;
  Process server({"serve", "--state", state.path() / std::string(120, 'x'), "--log-level", "off"});
  EXPECT_EQ(server.wait(), 2);
}

TEST(Server, has_its_state_directory_for_itself) {
  Service service({"--workers", "0"});
  Process second({"serve", "--state", service.state().string(), "--listen", "127.0.0.1:0", "--log-level", "off"});
  EXPECT_EQ(second.read_line(), "");
  EXPECT_EQ(second.wait(), 1);
}

TEST(Server, keeps_its_files_private) {
  Service service({"--workers", "0"});
  namespace fs = std::filesystem;
  for (const auto& entry : fs::recursive_directory_iterator(service.state())) {
    const auto others = fs::perms::group_all | fs::perms::others_all;
    EXPECT_EQ(fs::status(entry).permissions() & others, fs::perms::none) << entry.path();
  }
}

TEST(Server, listens_on_a_loopback_port_of_its_choice) {
  const TemporaryDirectory state;
  Process server({"serve", "--state", state.path().string(), "--listen", "127.0.0.1:0", "--workers", "0"});
  const std::string ready = server.read_line();
  EXPECT_THAT(ready, testing::StartsWith("listening on 127.0.0.1:"));
  const auto jobs = v1::Jobs::NewStub(grpc::CreateChannel(ready.substr(13), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  v1::ListJobsResponse response;
  EXPECT_TRUE(jobs->ListJobs(&context, {}, &response).ok());
  server.send(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

}  // namespace
}  // namespace trajan::test
