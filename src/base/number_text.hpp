#pragma once

#include <charconv>
#include <system_error>

#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
#include "base/read_by_fast_float.hpp"
#endif
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
#include "base/write_by_fmt.hpp"
#endif

/// Converts doubles to text and back like std::to_chars and std::from_chars: independent of the locale, exact, with the
/// same bytes on every machine. All conversions between doubles and text use these functions. Some standard libraries
/// have the standard functions for integers only: libc++ reads doubles from version 20 on and writes them from version
/// 14 on. With older versions, cmake/number_text.cmake defines the macros above, and fast_float and fmt do the
/// conversions.
namespace waywright::base {

/// Does what std::from_chars(first, last, value) does.
inline std::from_chars_result read_double(const char* first, const char* last, double& value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
  return read_by_fast_float(first, last, value);
#else
  return std::from_chars(first, last, value);
#endif
}

/// Does what std::to_chars(first, last, value) does: writes the shortest text that reads back as the same double.
/// Returns the end of the text. Requires: the buffer has room for 32 characters.
inline char* write_shortest(char* first, char* last, double value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_shortest_by_fmt(first, last, value);
#else
  return std::to_chars(first, last, value).ptr;
#endif
}

/// Does what std::to_chars with std::chars_format::general does: writes the value, rounded to `digits` significant
/// digits. Returns the end of the text. Requires: the buffer has room for `digits` + 16 characters.
inline char* write_rounded(char* first, char* last, double value, int digits) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_rounded_by_fmt(first, last, value, digits);
#else
  return std::to_chars(first, last, value, std::chars_format::general, digits).ptr;
#endif
}

}  // namespace waywright::base
