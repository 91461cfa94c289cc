#include "base/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

#include "base/compiler.hpp"
#include "support/case_count.hpp"
#include "support/random.hpp"

#if __has_include(<fast_float/fast_float.h>)
#if !defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
#define WAYWRIGHT_NUMBERS_BY_FAST_FLOAT
#endif
#define WAYWRIGHT_TEST_READS
#endif
#if __has_include(<fmt/format.h>)
#if !defined(WAYWRIGHT_NUMBERS_BY_FMT)
#define WAYWRIGHT_NUMBERS_BY_FMT
#endif
#define WAYWRIGHT_TEST_WRITES
#endif
#include "base/number_text_fallbacks.hpp"

// Compares the replacements for functions that some standard libraries lack with the standard functions. Needs a
// standard library that has these functions.
namespace waywright::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Returns doubles of all kinds: random bits, whole numbers of any size, powers of two and of ten and their neighbours,
/// decimals.
std::vector<double> doubles() {
  std::vector<double> values{0.0, 5e-324, std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    values.insert(values.end(), {power, std::nextafter(power, 0.0), std::nextafter(power, kInfinity)});
  }
  for (int exponent = -320; exponent <= 308; ++exponent) {
    const double power = std::pow(10.0, exponent);
    values.insert(values.end(), {power, 12.0 * power / 10.0, std::nextafter(power, 0.0)});
  }
  Random random(5);
  for (int i = 0; i < case_count(200000, 20); ++i) {
    const std::uint64_t bits = random.next();
    const auto value = base::bit_cast<double>(bits);
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(static_cast<double>(bits >> (bits % 64)));
    values.push_back(static_cast<double>(random.between(-1000000, 1000000)) / 1000.0);
    values.push_back(std::ldexp(static_cast<double>(bits >> 11), static_cast<int>(random.below(60)) - 30));
  }
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) values.push_back(-values[i]);
  return values;
}

#if defined(WAYWRIGHT_TEST_WRITES) && defined(__cpp_lib_to_chars)

TEST(NumberText, FmtWritesTheShortestTextAsTheStandardDoes) {
  for (const double value : doubles()) {
    std::array<char, 32> ours{};
    std::array<char, 32> standard{};
    const char* const end = base::write_shortest_by_fmt(ours.data(), ours.data() + ours.size(), value);
    const char* const expected = std::to_chars(standard.data(), standard.data() + standard.size(), value).ptr;
    ASSERT_EQ(std::string_view(ours.data(), end), std::string_view(standard.data(), expected));
  }
}

TEST(NumberText, FmtRoundsAsTheStandardDoes) {
  for (const double value : doubles()) {
    for (const int digits : {1, 5, 12}) {
      std::array<char, 40> ours{};
      std::array<char, 40> standard{};
      const char* const end = base::write_rounded_by_fmt(ours.data(), ours.data() + ours.size(), value, digits);
      const char* const expected =
          std::to_chars(standard.data(), standard.data() + standard.size(), value, std::chars_format::general, digits)
              .ptr;
      ASSERT_EQ(std::string_view(ours.data(), end), std::string_view(standard.data(), expected));
    }
  }
}

#endif

#if defined(WAYWRIGHT_TEST_READS) && defined(__cpp_lib_to_chars)

void expect_same_reading(std::string_view text) {
  double ours = 17.0;
  double standard = 17.0;
  const auto [end, fault] = base::read_by_fast_float(text.data(), text.data() + text.size(), ours);
  const auto [expected_end, expected_fault] = std::from_chars(text.data(), text.data() + text.size(), standard);
  ASSERT_EQ(fault, expected_fault) << text;
  ASSERT_EQ(end, expected_end) << text;
  ASSERT_EQ(base::bit_cast<std::uint64_t>(ours), base::bit_cast<std::uint64_t>(standard)) << text;
}

TEST(NumberText, FastFloatReadsAsTheStandardDoes) {
  for (const double value : doubles()) {
    std::array<char, 64> text{};
    for (const int digits : {3, 17, 22}) {
      const auto* const end =
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits).ptr;
      expect_same_reading({text.data(), end});
    }
  }
}

TEST(NumberText, FastFloatReadsOddWordsAsTheStandardDoes) {
  for (const std::string_view text : {"",
                                      "-",
                                      "+1",
                                      "--1",
                                      ".",
                                      ".e1",
                                      "e1",
                                      "1e",
                                      "1e+",
                                      "1e-",
                                      "1.5.2",
                                      "1.",
                                      ".5",
                                      "-.5",
                                      "007",
                                      "0e999",
                                      "1e400",
                                      "-1e400",
                                      "1e-400",
                                      "-1e-400",
                                      "0.000e-9999",
                                      "1e99999999999999999999",
                                      "1e-99999999999999999999",
                                      "inf",
                                      "-inf",
                                      "infinity",
                                      "INF",
                                      "-nan",
                                      "infinite",
                                      "0x10",
                                      "1 ",
                                      " 1",
                                      "1e5x",
                                      "12345678901234567890123456789",
                                      "1.7976931348623159e308",
                                      "1.7976931348623157e308",
                                      "2.4703282292062327e-324",
                                      "2.4703282292062328e-324"}) {
    expect_same_reading(text);
  }
}

#endif

}  // namespace
}  // namespace waywright::test
