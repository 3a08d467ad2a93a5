#include "proto/crc32c.h"

#include <gtest/gtest.h>

#include <string>

namespace trajan {
namespace {

// RFC 3720, appendix B.4; the check value of "123456789" is that of every catalogue of CRCs.
TEST(Crc32c, has_the_published_values) {
  EXPECT_EQ(crc32c(""), 0U);
  EXPECT_EQ(crc32c("123456789"), 0xE3069283U);
  EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8A9136AAU);
  EXPECT_EQ(crc32c(std::string(32, '\xff')), 0x62A8AB43U);
}

}  // namespace
}  // namespace trajan
