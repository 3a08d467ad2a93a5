#include "client/private_server.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

#include "proto/default_paths.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{20};

std::string last_lines(const fs::path& file) {
  constexpr std::streamoff most = 2000;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return {};
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - most));
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  fs::path root = fs::temp_directory_path(error);
  std::string pattern = (root / "trajan-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw CommandError(ExitCode::local_failure,
                       fmt::format("cannot make a folder in {}: {}", root.string(), std::strerror(errno)));
  }
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

PrivateServer::PrivateServer(bool calibrate) : address_("unix:" + socket_path(folder_.path()).string()) {
  const fs::path log = folder_.path() / "serve.log";
  process_.emplace(find_trajand(),
                   std::vector<std::string>{"serve", "--state", folder_.path().string(),
                                            calibrate ? "--calibrate" : "--no-calibrate"},
                   log);
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (!Connection(address_).answers_within(std::chrono::milliseconds(200))) {
    if (process_->has_ended() || std::chrono::steady_clock::now() > give_up) {
      throw CommandError(ExitCode::not_reachable, "the private server did not start:\n" + last_lines(log));
    }
  }
}

AvailableServer::AvailableServer(const std::string& option, bool calibrate) {
  const std::string configured = configured_address(option);
  if (!configured.empty()) {
    connection_.emplace(configured);
    return;
  }
  if (fs::exists(socket_path(default_state_directory()))) {
    connection_.emplace(default_address());
    if (connection_->answers_within(std::chrono::seconds(1))) return;
  }
  private_.emplace(calibrate);
  connection_.emplace(private_->address());
}

}  // namespace trajan::client
