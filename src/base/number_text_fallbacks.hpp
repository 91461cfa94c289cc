#pragma once

// The conversions of number_text.hpp by fast_float and fmt, for standard libraries that lack the functions. Each half
// exists if its macro is defined.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "base/ieee.hpp"

#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
#include <fast_float/fast_float.h>
#endif
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
#if !defined(FMT_HEADER_ONLY)
#define FMT_HEADER_ONLY
#endif
#include <fmt/compile.h>
#endif

namespace waywright::base {

#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)

/// Does what std::from_chars(first, last, value) does, with the library fast_float.
inline std::from_chars_result read_by_fast_float(const char* first, const char* last, double& value) {
  double read = 0.0;
  const fast_float::from_chars_result result = fast_float::from_chars(first, last, read);
  if (result.ec != std::errc{}) return {result.ptr, result.ec};
  // Before version 5, fast_float reports no range error but returns infinity or 0. The digits before the exponent
  // reveal such an error: the words for infinity have no digits, and a true 0 has no digit other than 0.
  const char* const mantissa_end = std::find_if(first, result.ptr, [](char c) { return c == 'e' || c == 'E'; });
  const auto has = [&](char least) {
    return std::any_of(first, mantissa_end, [least](char c) { return c >= least && c <= '9'; });
  };
  if ((std::isinf(read) && has('0')) || (read == 0.0 && has('1'))) {
    return {result.ptr, std::errc::result_out_of_range};
  }
  value = read;
  return {result.ptr, std::errc{}};
}

#endif
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)

/// The shortest decimal digits that read back as the same double. The value is 0.d1 d2 d3 ... times 10^point.
struct ShortestDigits {
  std::array<char, 24> digits{};  ///< neither the first nor the last digit is 0
  std::ptrdiff_t count = 0;
  std::ptrdiff_t point = 0;
};

/// Requires: `value` is finite and positive.
inline ShortestDigits shortest_digits(double value) {
  std::array<char, 40> buffer{};
  const char* const end = fmt::format_to(buffer.data(), FMT_COMPILE("{}"), value);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t mantissa_size = std::min(text.find('e'), text.size());
  const std::size_t point = std::min(text.find('.'), mantissa_size);
  const std::size_t first = text.find_first_of("123456789");
  const std::size_t last = text.find_last_of("123456789", mantissa_size - 1);
  ShortestDigits result;
  for (std::size_t i = first; i <= last; ++i) {
    if (i != point) result.digits[static_cast<std::size_t>(result.count++)] = text[i];
  }
  // If the first digit comes after the decimal point, `first` counts the character of the point, too.
  result.point = static_cast<std::ptrdiff_t>(point) - static_cast<std::ptrdiff_t>(first) + (first > point ? 1 : 0);
  if (mantissa_size < text.size()) result.point += std::strtol(text.data() + mantissa_size + 1, nullptr, 10);
  return result;
}

/// Does what std::to_chars(first, last, value) does, with the library fmt: writes the shorter one of fixed notation and
/// scientific notation, and fixed notation if both have the same length. A whole number in fixed notation has all its
/// digits. Returns the end of the text.
inline char* write_shortest_by_fmt(char* first, char* last, double value) {
  if (!std::isfinite(value) || value == 0.0) return fmt::format_to(first, FMT_COMPILE("{}"), value);
  if (value < 0.0) *first++ = '-';
  const ShortestDigits shortest = shortest_digits(std::abs(value));
  const std::ptrdiff_t count = shortest.count;
  const std::ptrdiff_t point = shortest.point;
  const std::ptrdiff_t exponent = point - 1;
  const std::ptrdiff_t with_point = point <= 0 ? 2 - point + count : point < count ? count + 1 : point;
  const std::ptrdiff_t with_exponent = count + (count > 1 ? 1 : 0) + (std::abs(exponent) < 100 ? 4 : 5);
  const char* const digits = shortest.digits.data();
  if (with_exponent < with_point) {
    *first++ = digits[0];
    if (count > 1) *first++ = '.';
    first = std::copy(digits + 1, digits + count, first);
    *first++ = 'e';
    *first++ = exponent < 0 ? '-' : '+';
    if (std::abs(exponent) < 10) *first++ = '0';
    return std::to_chars(first, last, std::abs(exponent)).ptr;
  }
  if (point >= count) return fmt::format_to(first, FMT_COMPILE("{:.0f}"), std::abs(value));
  if (point > 0) {
    first = std::copy(digits, digits + point, first);
    *first++ = '.';
    return std::copy(digits + point, digits + count, first);
  }
  *first++ = '0';
  *first++ = '.';
  first = std::fill_n(first, -point, '0');
  return std::copy(digits, digits + count, first);
}

/// Does what std::to_chars(first, last, value, std::chars_format::general, digits) does, with the library fmt.
inline char* write_rounded_by_fmt(char* first, char* /*last*/, double value, int digits) {
  return fmt::format_to(first, FMT_COMPILE("{:.{}g}"), value, digits);
}

#endif

}  // namespace waywright::base
