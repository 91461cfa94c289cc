#include "text/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>

#include "base/number_text.hpp"

namespace waywright::text {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Whether an unsigned decimal number outside the range of doubles is too large; if not, it is too small. Such a number
/// is above 1e308 or below 1e-308, so the position of its first non-zero digit decides.
bool is_too_large(std::string_view number) {
  const std::size_t mantissa_end = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  const auto decimal_exponent = first < point ? static_cast<std::int64_t>(point - first) - 1
                                              : static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);

  std::string_view exponent_text = number.substr(std::min(mantissa_end + 1, number.size()));
  const bool is_negative = exponent_text.starts_with('-');
  if (is_negative || exponent_text.starts_with('+')) exponent_text.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto [end, status] =
      std::from_chars(exponent_text.data(), exponent_text.data() + exponent_text.size(), exponent);
  if (status == std::errc::result_out_of_range) return !is_negative;
  // `decimal_exponent` is at most the length of a text. Hence the sum cannot overflow, except where the exponent of the
  // text decides alone.
  constexpr std::int64_t kDecisive = std::numeric_limits<std::int64_t>::max() / 2;
  if (exponent > kDecisive) return !is_negative;
  return decimal_exponent + (is_negative ? -exponent : exponent) > 0;
}

/// The encoding of a text that is not UTF-8, under the name that iconv uses; empty for UTF-8 and for bytes that are no
/// text.
std::string_view foreign_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xff\xfe\0\0"sv)) return "UTF-32LE";
  if (text.starts_with("\0\0\xfe\xff"sv)) return "UTF-32BE";
  if (text.starts_with("\xff\xfe"sv)) return "UTF-16LE";
  if (text.starts_with("\xfe\xff"sv)) return "UTF-16BE";
  // If there is no byte order mark, the NUL bytes around the first character reveal the encoding, because all texts
  // that the library reads begin with an ASCII character.
  const auto is_ascii = [&](std::size_t i) { return text[i] != '\0' && static_cast<unsigned char>(text[i]) < 0x80; };
  if (text.size() >= 4 && is_ascii(0) && text.substr(1, 3) == "\0\0\0"sv) return "UTF-32LE";
  if (text.size() >= 4 && is_ascii(3) && text.substr(0, 3) == "\0\0\0"sv) return "UTF-32BE";
  if (text.size() >= 2 && is_ascii(0) && text[1] == '\0') return "UTF-16LE";
  if (text.size() >= 2 && is_ascii(1) && text[0] == '\0') return "UTF-16BE";
  return {};
}

}  // namespace

std::optional<Error> skip_byte_order_mark(std::string_view& text, std::string_view name) {
  constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
  if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
  const std::string_view encoding = foreign_encoding(text);
  if (encoding.empty()) return std::nullopt;
  std::string what = "expected UTF-8, found ";
  what += encoding;
  what += "; save the text as UTF-8, or convert it with 'iconv -f ";
  what += encoding;
  what += " -t UTF-8'";
  return error_at(ErrorCode::malformed, name, 1, what);
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view WordReader::peek() const {
  const auto end = std::find_if(rest_.begin(), rest_.end(), is_blank);
  return rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
}

bool WordReader::next(std::string_view& word) {
  if (rest_.empty()) return false;
  word = peek();
  rest_.remove_prefix(word.size());
  skip_blanks();
  return true;
}

void WordReader::skip_blanks() {
  const auto first = std::find_if_not(rest_.begin(), rest_.end(), is_blank);
  rest_.remove_prefix(static_cast<std::size_t>(first - rest_.begin()));
}

std::string_view without_comment(std::string_view line) { return line.substr(0, line.find('#')); }

std::optional<double> read_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, status] = base::read_double(word.data(), end, value);
  if (stop != end || status == std::errc::invalid_argument) return std::nullopt;
  if (status == std::errc::result_out_of_range) {
    const bool is_negative = word.starts_with('-');
    const double size = is_too_large(word.substr(is_negative ? 1 : 0)) ? std::numeric_limits<double>::infinity() : 0.0;
    return is_negative ? -size : size;
  }
  return value;
}

std::optional<std::uint64_t> read_unsigned(std::string_view word) {
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, status] = std::from_chars(word.data(), end, value);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<ItemId> read_id(std::string_view word) {
  const std::optional<std::uint64_t> value = read_unsigned(word);
  if (!value || *value == 0 || *value > ItemId::kLargest) return std::nullopt;
  return ItemId{*value};
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "'";
  for (const char c : word.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      out += c;
    } else {
      out += "\\x";
      out += kHex[byte >> 4];
      out += kHex[byte & 0xf];
    }
  }
  if (word.size() > kLongest) out += "...";
  return out += '\'';
}

Error error_at(ErrorCode code, std::string_view name, std::uint64_t line, std::string_view what) {
  std::string message(name);
  message += base::with_number(":", line, ": ");
  message += what;
  return Error{.code = code, .words = std::move(message), .item = {}, .index = line};
}

}  // namespace waywright::text
