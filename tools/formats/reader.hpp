#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "waywright/error.hpp"
#include "waywright/point.hpp"
#include "waywright/scene.hpp"

#include "text/text.hpp"

namespace waywright::formats {

/// Reports how many bytes of a text a reader has read. Empty for no report.
using ReadProgress = std::function<void(std::size_t done, std::size_t total)>;

/// The exception with which a reader refuses its text. read_scene_text() turns it into an Error.
struct Refusal {
  std::size_t offset = 0;  ///< the offset of the error in the text
  std::string what;
  ErrorCode code = ErrorCode::malformed;
};

/// Throws a Refusal with the message `expected ..., found ...`.
[[noreturn]] void refuse(std::size_t offset, std::string_view expected, std::string_view found);

/// Returns the number of the line that contains a position, counted from 1. If only blanks and line ends follow the
/// position, returns the last line that contains something else.
[[nodiscard]] std::size_t line_of(std::string_view text, std::size_t offset);

/// Returns the coordinate that a word stands for. Throws a Refusal if it is no number, or out of range for a world.
[[nodiscard]] double coordinate_of(std::string_view word, std::size_t offset);

/// Returns the value if a world accepts it. Otherwise throws a Refusal that contains `word`.
[[nodiscard]] double checked_coordinate(double value, std::string_view word, std::size_t offset);

/// Calls `read(text)` for the text without its byte order mark. Returns the scene, or the error that `read` threw.
template <class Read>
[[nodiscard]] Result<Scene> read_scene_text(std::string_view text, std::string_view name, Read read) {
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  try {
    return read(text);
  } catch (const Refusal& refusal) {
    return text::error_at(refusal.code, name, line_of(text, refusal.offset), refusal.what);
  }
}

/// Reads words and marks from a text in which line ends count as blanks.
class Cursor {
 public:
  /// `marks` are the characters that end a word and are words of their own.
  explicit Cursor(std::string_view text, std::string_view marks = {}) : text_(text), marks_(marks) { skip_blanks(); }

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  /// The offset of the next word.
  [[nodiscard]] std::size_t offset() const { return at_; }
  /// Returns the next word, but does not move; empty at the end of the text.
  [[nodiscard]] std::string_view peek() const;
  /// Returns the next word and moves behind it; empty at the end of the text.
  std::string_view next();
  /// If the next word is `mark`, moves behind it and returns true.
  bool skip(std::string_view mark);
  /// The next word for a message: in quotes, or `the end of the text`.
  [[nodiscard]] std::string found() const;

 private:
  void skip_blanks();

  std::string_view text_;
  std::string_view marks_;
  std::size_t at_ = 0;
};

}  // namespace waywright::formats
