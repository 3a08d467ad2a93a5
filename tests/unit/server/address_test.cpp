#include "server/address.h"

#include <gtest/gtest.h>

namespace trajan {
namespace {

TEST(Address, of_this_machine_alone_is_allowed) {
  for (const char* address : {"unix:/tmp/x.sock", "127.0.0.1:0", "127.1.2.3:80", "localhost:80", "[::1]:65535"}) {
    EXPECT_NO_THROW(require_local(address)) << address;
  }
}

TEST(Address, that_others_can_reach_is_refused) {
  for (const char* address :
       {"0.0.0.0:80", "[::]:80", "10.0.0.1:80", "example.org:80", "127.0.0.1.example.org:80"}) {
    EXPECT_THROW(require_local(address), UsageError) << address;
  }
}

TEST(Address, without_a_sensible_port_or_path_is_refused) {
  for (const char* address : {"", "unix:", "127.0.0.1", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:8x"}) {
    EXPECT_THROW(require_local(address), UsageError) << address;
  }
}

TEST(Address, of_a_socket_has_at_most_107_bytes) {
  EXPECT_NO_THROW(require_local("unix:" + std::string(107, 'x')));
  EXPECT_THROW(require_local("unix:" + std::string(108, 'x')), UsageError);
}

}  // namespace
}  // namespace trajan
