#pragma once

#include <filesystem>
#include <optional>

#include "client/connection.h"
#include "client/subprocess.h"

namespace trajan::client {

/// A folder that is removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// `trajand serve` for this process alone, on a temporary state directory. It ends with this object.
class PrivateServer {
 public:
  /// Waits until it answers. Throws CommandError with the end of its log if it does not.
  /// `calibrate`: the server measures the machine, for estimates.
  explicit PrivateServer(bool calibrate);
  const std::string& address() const { return address_; }

 private:
  TemporaryFolder folder_;
  std::string address_;
  std::optional<ChildProcess> process_;
};

/// A server to work with: the configured one; otherwise the default one if it runs; otherwise a private one.
class AvailableServer {
 public:
  /// `option`: what --server says; `calibrate`: of a private one. Throws CommandError.
  explicit AvailableServer(const std::string& option, bool calibrate = false);
  Connection& connection() { return *connection_; }
  bool is_private() const { return private_.has_value(); }

 private:
  std::optional<PrivateServer> private_;
  std::optional<Connection> connection_;
};

}  // namespace trajan::client
