#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "waywright/error.hpp"
#include "waywright/id.hpp"

#include "base/ieee.hpp"

namespace waywright::text {

/// Removes the byte order mark of UTF-8 from the front of `text`. Returns an error on line 1 of `name` if the text is
/// encoded as UTF-16 or UTF-32, with or without a byte order mark. Errors: malformed.
[[nodiscard]] std::optional<Error> skip_byte_order_mark(std::string_view& text, std::string_view name);

/// Returns the lines of a text one after the other, without their line ends (LF or CRLF). If the text ends with a line
/// end, there is no empty line after it.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// Puts the next line into `line`. Returns false at the end of the text.
  [[nodiscard]] bool next(std::string_view& line);

  /// The number of the line that next() returned last, counted from 1. It is also 1 before the first line and for an
  /// empty text, because messages about missing text name line 1.
  [[nodiscard]] std::uint64_t number() const { return number_ == 0 ? 1 : number_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

/// Returns the words of a line one after the other. Blanks and tabs separate words.
class WordReader {
 public:
  WordReader() = default;
  explicit WordReader(std::string_view line) : rest_(line) { skip_blanks(); }

  /// Puts the next word into `word`. Returns false at the end of the line.
  [[nodiscard]] bool next(std::string_view& word);

  /// The word that next() will return; empty at the end of the line.
  [[nodiscard]] std::string_view peek() const;

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  /// The number of characters that are left. If a word of the text says how many words follow, a caller can use this
  /// number as an upper bound.
  [[nodiscard]] std::size_t remaining() const { return rest_.size(); }

 private:
  void skip_blanks();

  std::string_view rest_;
};

/// Returns the line up to its first `#`.
[[nodiscard]] std::string_view without_comment(std::string_view line);

/// Returns the double nearest to a decimal number, or null if the word is no number. A leading `+` is allowed. For a
/// number that is too large, the result is infinity. For a number that is too small, it is zero or the nearest
/// subnormal double. The words for infinity and NaN are well formed: the result is infinity or NaN.
[[nodiscard]] std::optional<double> read_number(std::string_view word);

/// Reads an unsigned integer. Returns null if the word contains anything but digits, or if the number is above 2^64 -
/// 1.
[[nodiscard]] std::optional<std::uint64_t> read_unsigned(std::string_view word);

/// Reads an id from 1 to 2^63 - 1. Returns null if the word is no such id.
[[nodiscard]] std::optional<ItemId> read_id(std::string_view word);

/// Returns a word in quotes, for a message. Shortens a long word, and writes bytes that are not printable as `\xNN`.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Returns an error with the message `NAME:LINE: what` and with the line as its index.
[[nodiscard]] Error error_at(ErrorCode code, std::string_view name, std::uint64_t line, std::string_view what);

}  // namespace waywright::text
