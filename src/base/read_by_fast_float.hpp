#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fast_float/fast_float.h>
#include <system_error>

namespace waywright::base {

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

}  // namespace waywright::base
