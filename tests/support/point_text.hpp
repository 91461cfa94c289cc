#pragma once

#include <array>
#include <charconv>
#include <string>

#include "waywright/point.hpp"

namespace waywright::test {

/// Returns `X Y` in the format of a world script, so that a reader can copy the query of a message into a script.
[[nodiscard]] inline std::string text_of(Point p) {
  std::array<char, 80> buffer{};
  char* end = std::to_chars(buffer.data(), buffer.data() + 39, p.x).ptr;
  *end++ = ' ';
  end = std::to_chars(end, buffer.data() + buffer.size(), p.y).ptr;
  return {buffer.data(), end};
}

}  // namespace waywright::test
