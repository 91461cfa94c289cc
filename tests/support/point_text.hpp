#pragma once

#include <array>
#include <charconv>
#include <string>

#include "waywright/point.hpp"

namespace waywright::test {

/// `X Y` as a world script has them, so that a message's query can be put into one.
[[nodiscard]] inline std::string text_of(Point p) {
  std::array<char, 80> buffer{};
  char* end = std::to_chars(buffer.data(), buffer.data() + 39, p.x).ptr;
  *end++ = ' ';
  end = std::to_chars(end, buffer.data() + buffer.size(), p.y).ptr;
  return {buffer.data(), end};
}

}  // namespace waywright::test
