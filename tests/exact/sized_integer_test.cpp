#include <cstddef>
#include <cstdint>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include "exact/homogeneous.hpp"
#include "exact/wide_integer.hpp"

namespace waywright::test {

namespace {

using exact::Integer;
using exact::SizedInteger;

template <int kBits>
Integer to_integer(const SizedInteger<kBits>& number) {
  constexpr std::size_t kLimbs = SizedInteger<kBits>::kLimbs;
  if constexpr (kLimbs == 1) {
    return Integer(number.value());
  } else {
    Integer result = 0;
    for (std::size_t i = kLimbs; i-- > 0;) {
      result <<= 64;
      result += number.value().limb(i);
    }
    return number.value().is_negative() ? Integer(result - (Integer(1) << (64 * kLimbs))) : result;
  }
}

/// The largest number of a size.
template <int kBits>
SizedInteger<kBits> largest() {
  static_assert(kBits <= 63);
  return SizedInteger<kBits>(std::numeric_limits<std::int64_t>::max() >> (63 - kBits));
}

static_assert(SizedInteger<63>::kLimbs == 1 && SizedInteger<64>::kLimbs == 2);
static_assert(SizedInteger<127>::kLimbs == 2 && SizedInteger<128>::kLimbs == 3);

/// Computes with the largest magnitudes of both signs, up to products of four factors.
template <int kBits>
void check_extremes() {
  const SizedInteger<kBits> high = largest<kBits>();
  const SizedInteger<kBits> low = SizedInteger<kBits>(-high.value());
  const Integer h = to_integer(high);
  EXPECT_EQ(h, (Integer(1) << kBits) - 1);
  EXPECT_EQ(to_integer(high + high), 2 * h);
  EXPECT_EQ(to_integer(low - high), -2 * h);
  const auto square = high * high + low * low;
  EXPECT_EQ(to_integer(square), 2 * h * h);
  const auto difference = high * low - high * high;
  EXPECT_EQ(to_integer(difference), -2 * h * h);
  const auto fourth = square * square - difference * square;
  EXPECT_EQ(to_integer(fourth), 8 * h * h * h * h);
  EXPECT_EQ(to_integer(difference * difference * difference), -8 * h * h * h * h * h * h);
  EXPECT_EQ(sign_if_sure(fourth), exact::Sign::positive);
  EXPECT_EQ(sign_if_sure(difference * fourth), exact::Sign::negative);
  EXPECT_EQ(sign_if_sure(square + difference), exact::Sign::zero);
}

TEST(SizedIntegers, ComputeExactlyAtTheirLimits) {
  check_extremes<13>();
  check_extremes<14>();
  check_extremes<15>();
  check_extremes<16>();
  check_extremes<29>();
  check_extremes<30>();
  check_extremes<31>();
  check_extremes<32>();
  check_extremes<60>();
  check_extremes<61>();
  check_extremes<62>();
  check_extremes<63>();
}

}  // namespace
}  // namespace waywright::test
