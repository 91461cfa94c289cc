#include <gtest/gtest.h>

#include "exact/doubles.hpp"

namespace waywright::test {
namespace {

TEST(NextCoordinate, IsTheNextNumberOfItsType) {
  EXPECT_EQ(exact::next_coordinate<double>(1.0, 1.0), 1.0 + 0x1p-52);
  EXPECT_EQ(exact::next_coordinate<double>(1.0, -5.0), 1.0 - 0x1p-53);
  EXPECT_EQ(exact::next_coordinate<double>(-1.0, 1.0), -1.0 + 0x1p-53);
  EXPECT_EQ(exact::next_coordinate<float>(1.0, 1.0), 1.0 + 0x1p-23);
  EXPECT_EQ(exact::next_coordinate<float>(-2.0, -1.0), -2.0 - 0x1p-22);
}

// Between -2^-100 and 2^-100 only 0 is a coordinate, and nothing beyond 2^100 is one.
TEST(NextCoordinate, StaysInRange) {
  EXPECT_EQ(exact::next_coordinate<double>(0.0, 1.0), 0x1p-100);
  EXPECT_EQ(exact::next_coordinate<float>(0.0, -1.0), -0x1p-100);
  EXPECT_EQ(exact::next_coordinate<double>(0x1p-100, -1.0), 0.0);
  EXPECT_EQ(exact::next_coordinate<float>(-0x1p-100, 1.0), 0.0);
  EXPECT_EQ(exact::next_coordinate<double>(0x1p-100, 1.0), 0x1p-100 + 0x1p-152);
  EXPECT_EQ(exact::next_coordinate<double>(0x1p100, 1.0), 0x1p100);
  EXPECT_EQ(exact::next_coordinate<float>(-0x1p100, -1.0), -0x1p100);
}

}  // namespace
}  // namespace waywright::test
