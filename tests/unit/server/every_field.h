#pragma once

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <fstream>
#include <sstream>
#include <string>

#include "server/convert.h"

namespace trajan {

inline v1::Scene parse(const std::string& text) {
  v1::Scene scene;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &scene)) << text;
  return scene;
}

/// The message of every_field.textproto and its translation.
class EveryField : public ::testing::Test {
 protected:
  static v1::Scene read() {
    std::ostringstream text;
    text << std::ifstream(TRAJAN_TEST_DATA "/every_field.textproto").rdbuf();
    return parse(text.str());
  }
  v1::Scene message_ = read();
  Scene scene_ = to_scene(message_);
};

inline void expect_vector(const Vector& vector, double x, double y, double z = 0) {
  EXPECT_EQ(vector.x, x);
  EXPECT_EQ(vector.y, y);
  EXPECT_EQ(vector.z, z);
}

inline void expect_box(const Region& region, double lower_x, double lower_y, double upper_x, double upper_y) {
  ASSERT_TRUE(std::holds_alternative<Box>(region));
  expect_vector(std::get<Box>(region).lower, lower_x, lower_y);
  expect_vector(std::get<Box>(region).upper, upper_x, upper_y);
}

inline void expect_disc(const Region& region, double x, double y, double radius) {
  ASSERT_TRUE(std::holds_alternative<Disc>(region));
  expect_vector(std::get<Disc>(region).centre, x, y);
  EXPECT_EQ(std::get<Disc>(region).radius, radius);
}

}  // namespace trajan
