#pragma once

#include <charconv>
#include <system_error>

#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
#include "base/read_by_fast_float.hpp"
#endif
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
#include "base/write_by_fmt.hpp"
#endif

/// Doubles to text and back, as std::to_chars and std::from_chars do it: independent of the locale, exact, the same
/// bytes on every machine. All text of doubles goes through these functions. Some standard libraries have the standard
/// functions for integers only: libc++ reads doubles from version 20 on and writes them from version 14 on. There
/// cmake/number_text.cmake defines the macros above, and fast_float and fmt do the work.
namespace waywright::base {

/// As std::from_chars(first, last, value).
inline std::from_chars_result read_double(const char* first, const char* last, double& value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
  return read_by_fast_float(first, last, value);
#else
  return std::from_chars(first, last, value);
#endif
}

/// As std::to_chars(first, last, value): the shortest text that reads back as the same double.
/// Requires: there is room for 32 characters.
inline char* write_shortest(char* first, char* last, double value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_shortest_by_fmt(first, last, value);
#else
  return std::to_chars(first, last, value).ptr;
#endif
}

/// As std::to_chars with std::chars_format::general: rounded to so many significant digits.
/// Requires: there is room for 16 characters more than digits.
inline char* write_rounded(char* first, char* last, double value, int digits) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_rounded_by_fmt(first, last, value, digits);
#else
  return std::to_chars(first, last, value, std::chars_format::general, digits).ptr;
#endif
}

}  // namespace waywright::base
