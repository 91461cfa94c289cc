#include "formats/reader.hpp"

#include <algorithm>

namespace waywright::formats {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

}  // namespace

void refuse(std::size_t offset, std::string_view expected, std::string_view found) {
  std::string what = "expected ";
  what += expected;
  what += ", found ";
  what += found;
  throw Refusal{.offset = offset, .what = std::move(what)};
}

std::size_t line_of(std::string_view text, std::size_t offset) {
  std::string_view before = text.substr(0, std::min(offset, text.size()));
  if (text.find_first_not_of(kBlanks, before.size()) == std::string_view::npos) {
    before = before.substr(0, before.find_last_not_of(kBlanks) + 1);
  }
  return static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
}

double checked_coordinate(double value, std::string_view word, std::size_t offset) {
  if (is_in_range(value)) return value;
  throw Refusal{.offset = offset,
                .what = "expected a coordinate that is 0 or has a size from 2^-100 to 2^100, found " +
                        text::in_quotes(word) + "; scale the coordinates",
                .code = ErrorCode::coordinate_range};
}

double coordinate_of(std::string_view word, std::size_t offset) {
  const std::optional<double> value = text::read_number(word);
  if (!value) refuse(offset, "a coordinate, a decimal number such as -1.5 or 2e3", text::in_quotes(word));
  return checked_coordinate(*value, word, offset);
}

std::string_view Cursor::peek() const {
  if (at_end()) return {};
  const auto is_mark = [&](char c) { return marks_.find(c) != std::string_view::npos; };
  if (is_mark(text_[at_])) return text_.substr(at_, 1);
  std::size_t end = at_;
  while (end < text_.size() && kBlanks.find(text_[end]) == std::string_view::npos && !is_mark(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Cursor::next() {
  const std::string_view word = peek();
  at_ += word.size();
  skip_blanks();
  return word;
}

bool Cursor::skip(std::string_view mark) {
  if (peek() != mark) return false;
  next();
  return true;
}

std::string Cursor::found() const { return at_end() ? "the end of the text" : text::in_quotes(peek()); }

void Cursor::skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

}  // namespace waywright::formats
