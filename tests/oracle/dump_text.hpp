#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waywright::oracle {

/// The three sections of a dump as written, the lines of the first and the last still text.
struct DumpText {
  std::vector<std::string_view> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::string_view> constraints;
};

/// Reads a dump; on a fault says which and returns nothing. Views into `dump`.
[[nodiscard]] std::optional<DumpText> read_dump(std::string_view dump, std::string& fault);

/// What is wrong with a vertex's line on its own: words that are no integers, denominators not positive, a fraction
/// not reduced. Nothing if it is well formed.
[[nodiscard]] std::optional<std::string> vertex_line_fault(std::string_view line);

}  // namespace waywright::oracle
