#include <limits>

#include <gtest/gtest.h>

#include "exact/doubles.hpp"

namespace waywright::test {
namespace {

TEST(Whole, NumbersAreRecognised) {
  for (const double value : {0.0, 1.0, 3.0, 0x1p31, 0x1p51, 0x1p51 + 1.0, 0x1p52 - 1.0}) {
    EXPECT_TRUE(exact::is_whole(value)) << value;
    EXPECT_TRUE(exact::is_whole(-value)) << value;
  }
}

// Values next to powers of two, where the distance between doubles changes.
TEST(Whole, NoOtherNumberPassesForOne) {
  for (const double value : {0.5, 0x1p-1074, 0x1p-52, 1.0 - 0x1p-53, 1.0 + 0x1p-52, 0x1p50 + 0.25, 0x1p51 - 0.25,
                             0x1p51 + 0.5, 0x1p51 + 1.5, 0x1p52 - 0.5}) {
    EXPECT_FALSE(exact::is_whole(value)) << value;
    EXPECT_FALSE(exact::is_whole(-value)) << value;
  }
}

TEST(Whole, WhatIsNoFiniteNumberIsNone) {
  EXPECT_FALSE(exact::is_whole(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(exact::is_whole(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace waywright::test
