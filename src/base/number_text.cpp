#include "base/number_text.hpp"

#include <array>
#include <system_error>

#include "base/number_text_fallbacks.hpp"

namespace waywright::base {

std::from_chars_result read_double(const char* first, const char* last, double& value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FAST_FLOAT)
  return read_by_fast_float(first, last, value);
#else
  return std::from_chars(first, last, value);
#endif
}

char* write_shortest(char* first, char* last, double value) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_shortest_by_fmt(first, last, value);
#else
  return std::to_chars(first, last, value).ptr;
#endif
}

char* write_rounded(char* first, char* last, double value, int digits) {
#if defined(WAYWRIGHT_NUMBERS_BY_FMT)
  return write_rounded_by_fmt(first, last, value, digits);
#else
  return std::to_chars(first, last, value, std::chars_format::general, digits).ptr;
#endif
}

void append_number(std::string& out, double value) {
  std::array<char, 32> buffer{};
  // Adding 0 changes -0.0 into 0.0 and leaves every other value as it is.
  out.append(buffer.data(), write_shortest(buffer.data(), buffer.data() + buffer.size(), value + 0.0));
}

void append_unsigned(std::string& out, std::uint64_t value) {
  std::array<char, 24> buffer{};
  out.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

std::string with_number(std::string_view before, std::uint64_t number, std::string_view after) {
  std::string text(before);
  append_unsigned(text, number);
  text += after;
  return text;
}

}  // namespace waywright::base
