#include "server/address.h"

#include <arpa/inet.h>
#include <sys/un.h>

#include <charconv>

namespace trajan {

namespace {

constexpr std::string_view unix_prefix = "unix:";

bool is_port(const std::string& text) {
  int port = -1;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, port);
  return error == std::errc() && stop == end && port >= 0 && port <= 65535;
}

bool is_loopback(const std::string& host) {
  if (host == "localhost" || host == "[::1]") return true;
  in_addr address{};
  return inet_pton(AF_INET, host.c_str(), &address) == 1 && (ntohl(address.s_addr) >> 24) == 127;
}

}  // namespace

void require_local(const std::string& address) {
  const std::string path = socket_file(address).string();
  if (address.starts_with(unix_prefix)) {
    constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (path.empty()) throw UsageError("\"" + address + "\" names no file; write unix:PATH");
    if (path.size() > longest) {
      throw UsageError("the path of the socket has " + std::to_string(path.size()) + " bytes, but at most " +
                       std::to_string(longest) + " are possible: " + path +
                       "; choose a shorter state directory, or --listen unix:PATH with a shorter path");
    }
    return;
  }
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos || !is_port(address.substr(colon + 1))) {
    throw UsageError("\"" + address + "\" is no address; write unix:PATH, 127.0.0.1:PORT or [::1]:PORT");
  }
  if (!is_loopback(address.substr(0, colon))) {
    throw UsageError("refusing to listen on " + address +
                     ": an address that others can reach requires TLS, which this server does not offer; "
                     "write unix:PATH, 127.0.0.1:PORT or [::1]:PORT, and reach it through a tunnel");
  }
}

std::filesystem::path socket_file(const std::string& address) {
  if (!address.starts_with(unix_prefix)) return {};
  return address.substr(unix_prefix.size());
}

std::string with_port(const std::string& address, int port) {
  if (address.starts_with(unix_prefix)) return address;
  return address.substr(0, address.rfind(':') + 1) + std::to_string(port);
}

}  // namespace trajan
