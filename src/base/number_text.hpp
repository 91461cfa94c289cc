#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

/// Conversions between numbers and text: independent of the locale, exact, with the same bytes on every machine. All
/// conversions between doubles and text use these functions. Some standard libraries have the standard functions for
/// integers only: libc++ reads doubles from version 20 on and writes them from version 14 on. With older versions,
/// cmake/number_text.cmake defines macros for number_text.cpp, and fast_float and fmt do the conversions.
namespace waywright::base {

/// Does what std::from_chars(first, last, value) does.
std::from_chars_result read_double(const char* first, const char* last, double& value);

/// Does what std::to_chars(first, last, value) does: writes the shortest text that reads back as the same double.
/// Returns the end of the text. Requires: the buffer has room for 32 characters.
char* write_shortest(char* first, char* last, double value);

/// Does what std::to_chars with std::chars_format::general does: writes the value, rounded to `digits` significant
/// digits. Returns the end of the text. Requires: the buffer has room for `digits` + 16 characters.
char* write_rounded(char* first, char* last, double value, int digits);

/// Appends the shortest text that reads back as the same double, and `0` for -0.0.
void append_number(std::string& out, double value);

void append_unsigned(std::string& out, std::uint64_t value);

/// Returns `before`, the digits of the number, and `after` as one text.
[[nodiscard]] std::string with_number(std::string_view before, std::uint64_t number, std::string_view after);

}  // namespace waywright::base
