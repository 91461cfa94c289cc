#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "path/pieces.hpp"
#include "path/tangent.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

/// Returns the larger error of the two coordinates, against the functions of the C library for long double.
long double error_at(double angle, double rest = 0.0) {
  const Point unit = path::unit_vector(angle, rest);
  const long double exact = static_cast<long double>(angle) + static_cast<long double>(rest);
  return std::max(std::fabs(unit.x - std::cos(exact)), std::fabs(unit.y - std::sin(exact)));
}

TEST(UnitVector, IsNearTheExactOneAtEveryAngle) {
  Random random(5);
  long double worst = 0.0L;
  for (std::uint64_t i = 0; i < 2000 * case_count(); ++i) {
    const double fraction =
        static_cast<double>(random.between(-(std::int64_t{1} << 52), std::int64_t{1} << 52)) * 0x1p-52;
    worst = std::max({worst, error_at(fraction * 10.0), error_at(fraction * 0x1p19)});
    // A long double has the digits for the sum.
    worst = std::max(worst, error_at(fraction * 10.0, std::floor(fraction * 1024) * 0x1p-60));
  }
  EXPECT_LT(worst, 0x1p-51L);
  RecordProperty("worst", std::to_string(worst * 0x1p53L) + " * 2^-53");
}

// Here the multiple of pi / 2 changes, or a coordinate is 0.
TEST(UnitVector, IsNearTheExactOneAtEighthsOfATurn) {
  for (int eighths = -4000; eighths <= 4000; ++eighths) {
    const double angle = eighths * (path::kPi / 4);
    for (const double near : {angle, std::nextafter(angle, -1e9), std::nextafter(angle, 1e9)}) {
      EXPECT_LT(error_at(near), 0x1p-51L) << eighths;
    }
  }
  EXPECT_EQ(path::unit_vector(0.0), (Point{1, 0}));
}

TEST(UnitVector, HasTheAngleThatItWasMadeOf) {
  for (int i = -1000; i <= 1000; ++i) {
    const double angle = i * (path::kPi / 1001);
    EXPECT_NEAR(path::angle_of(path::unit_vector(angle)), angle, 0x1p-50);
  }
}

}  // namespace
}  // namespace waywright::test
