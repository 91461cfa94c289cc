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

/// Takes the byte order mark of UTF-8 off the front of `text`. Returns an error on line 1 of `name` where the text is
/// encoded as UTF-16 or UTF-32, with a byte order mark or without. Errors: malformed.
[[nodiscard]] std::optional<Error> skip_byte_order_mark(std::string_view& text, std::string_view name);

/// Hands out the lines of a text, one after the other, without their line ends (LF or CRLF). A line end closes a line:
/// it starts none, so a text that ends in one has no empty last line.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// Puts the next line into `line`; false at the end of the text.
  [[nodiscard]] bool next(std::string_view& line);

  /// The number of the line last handed out, from 1. Before the first line, and in an empty text, it is 1 too: that is
  /// where a message about what is missing points.
  [[nodiscard]] std::uint64_t number() const { return number_ == 0 ? 1 : number_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

/// Hands out the words of a line: what blanks and tabs part.
class WordReader {
 public:
  WordReader() = default;
  explicit WordReader(std::string_view line) : rest_(line) { skip_blanks(); }

  /// Puts the next word into `word`; false at the end of the line.
  [[nodiscard]] bool next(std::string_view& word);

  /// The word that next() hands out next; empty at the end of the line.
  [[nodiscard]] std::string_view peek() const;

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  /// How many characters are left: a bound for what a count may claim to follow.
  [[nodiscard]] std::size_t remaining() const { return rest_.size(); }

 private:
  void skip_blanks();

  std::string_view rest_;
};

/// The line up to its first `#`.
[[nodiscard]] std::string_view without_comment(std::string_view line);

/// The nearest double to a decimal number; null where the word is none. A leading `+` is taken. What is too large reads
/// as infinity, what is too small as zero or the nearest denormal, the words for infinity and NaN as what they say: the
/// number is not finite then, but it is well formed.
[[nodiscard]] std::optional<double> read_number(std::string_view word);

/// An unsigned integer of digits alone; null where the word is none, or beyond 2^64 - 1.
[[nodiscard]] std::optional<std::uint64_t> read_unsigned(std::string_view word);

/// An id from 1 to 2^63 - 1; null where the word is none.
[[nodiscard]] std::optional<ItemId> read_id(std::string_view word);

/// Appends the shortest text that reads back as the same double; -0.0 as `0`.
void append_number(std::string& out, double value);

void append_unsigned(std::string& out, std::uint64_t value);

/// `before`, the number in digits, `after`.
[[nodiscard]] std::string with_number(std::string_view before, std::uint64_t number, std::string_view after);

/// A word in quotes for a message: clipped where it is long, bytes that do not print as `\xNN`.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// An error whose message is `NAME:LINE: what` and whose index is the line.
[[nodiscard]] Error error_at(ErrorCode code, std::string_view name, std::uint64_t line, std::string_view what);

}  // namespace waywright::text
