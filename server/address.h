#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace trajan {

/// What was asked for on the command line cannot be done.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Checks an address to listen on: `unix:PATH`, or a loopback address with a port (0: any free one).
/// Everything else would need TLS. Throws UsageError.
void require_local(const std::string& address);

/// The path of a Unix socket's address; empty for others.
std::filesystem::path socket_file(const std::string& address);

/// `address` with the port that was chosen in the end.
std::string with_port(const std::string& address, int port);

}  // namespace trajan
