#include "exact/wide_integer.hpp"

#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "exact/homogeneous.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using exact::Integer;
using exact::WideInteger;

template <std::size_t kLimbs>
Integer value_of(const WideInteger<kLimbs>& number) {
  Integer value = number.is_negative() ? -1 : 0;
  for (std::size_t i = kLimbs; i-- > 0;) value = value * (Integer(1) << 64) + number.limb(i);
  return value;
}

/// Returns a random number of `bits` bits and a sign. It is often next to a power of two, where carries run far.
template <std::size_t kLimbs>
WideInteger<kLimbs> random_number(Random& random, std::size_t bits) {
  WideInteger<kLimbs> number = random.chance(30) ? WideInteger<kLimbs>(1) : WideInteger<kLimbs>(0);
  for (std::size_t i = 0; i < bits; ++i) {
    number += number;
    if (random.chance(number.is_negative() ? 0 : 50) && !random.chance(20)) number += WideInteger<kLimbs>(1);
  }
  if (random.chance(30)) number -= WideInteger<kLimbs>(random.between(-2, 2));
  return random.chance(50) ? -number : number;
}

template <std::size_t kA, std::size_t kB>
void check_products(Random& random) {
  for (int i = 0; i < 2000; ++i) {
    const auto a = random_number<kA>(random, random.below(64 * kA - 2));
    const auto b = random_number<kB>(random, random.below(64 * kB - 2));
    ASSERT_EQ(value_of(a * b), value_of(a) * value_of(b));
  }
}

TEST(WideInteger, MultipliesAsIntegersDo) {
  Random random(1);
  check_products<1, 1>(random);
  check_products<1, 3>(random);
  check_products<2, 2>(random);
  check_products<5, 6>(random);
  check_products<10, 10>(random);
}

TEST(WideInteger, MultipliesItsSmallestNumbers) {
  const WideInteger<1> smallest(INT64_MIN);
  EXPECT_EQ(value_of(smallest * smallest), Integer(1) << 126);
  EXPECT_EQ(value_of(smallest * WideInteger<1>(-1)), Integer(1) << 63);
  EXPECT_EQ(value_of(smallest * WideInteger<1>(INT64_MAX)), Integer(INT64_MIN) * INT64_MAX);
}

TEST(WideInteger, AddsSubtractsAndShifts) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const auto a = random_number<3>(random, random.below(189));
    const auto b = random_number<3>(random, random.below(189));
    ASSERT_EQ(value_of(a + b), value_of(a) + value_of(b));
    ASSERT_EQ(value_of(a - b), value_of(a) - value_of(b));
    ASSERT_EQ(value_of(-a), -value_of(a));
    ASSERT_EQ(a.sign(), exact::sign_of(value_of(a)));
    ASSERT_EQ(value_of(a.resize<5>()), value_of(a));
    ASSERT_EQ(value_of(a.resize<5>().resize<3>()), value_of(a));
    const auto c = random_number<3>(random, random.below(90));
    const auto bits = static_cast<int>(random.below(98));
    ASSERT_EQ(value_of(c << bits), value_of(c) * (Integer(1) << static_cast<unsigned>(bits)));
  }
}

TEST(WideInteger, ReportsItsWidthAndAboutItsSize) {
  Random random(3);
  EXPECT_EQ(WideInteger<2>(0).bit_width(), 0);
  EXPECT_EQ(WideInteger<2>(0).approximate(), 0.0);
  for (int i = 0; i < 5000; ++i) {
    auto a = random_number<4>(random, random.below(250));
    const Integer value = value_of(a);
    const auto expected = static_cast<double>(value);
    ASSERT_LE(std::abs(a.approximate() - expected), std::abs(expected) * 0x1p-50);
    if (a.is_negative()) a = -a;
    ASSERT_EQ(a.bit_width(), value == 0 ? 0 : static_cast<int>(msb(Integer(abs(value)))) + 1);
  }
}

// Tests both implementations of the product of 64-bit numbers; a compiler uses only one of them.
TEST(WideInteger, MultipliesByHalvesAsTheCompilerDoes) {
  Random random(4);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t a = random.chance(10) ? ~std::uint64_t{0} : random.next() >> random.below(64);
    const std::uint64_t b = random.chance(10) ? ~std::uint64_t{0} : random.next() >> random.below(64);
    const std::uint64_t c = random.chance(20) ? ~std::uint64_t{0} : random.next();
    const std::uint64_t d = random.chance(20) ? ~std::uint64_t{0} : random.next();
    const exact::Halves one = exact::multiply(a, b, c, d);
    const exact::Halves other = exact::multiply_by_halves(a, b, c, d);
    ASSERT_EQ(one.low, other.low);
    ASSERT_EQ(one.high, other.high);
    ASSERT_EQ((Integer(one.high) << 64) + one.low, Integer(a) * b + c + d);
  }
}

}  // namespace
}  // namespace waywright::test
