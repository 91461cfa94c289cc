#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waywright::oracle {

/// The three sections of a dump. The lines of the first and the last section are unparsed text.
struct DumpText {
  std::vector<std::string_view> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::string_view> constraints;
};

/// Reads a dump. If it is malformed, returns nothing and sets `fault`. The result contains views into `dump`.
[[nodiscard]] std::optional<DumpText> read_dump(std::string_view dump, std::string& fault);

/// Returns what is wrong with a single vertex line: words that are not integers, a denominator that is not positive, or
/// a fraction that is not in lowest terms. Returns nothing if the line is well formed.
[[nodiscard]] std::optional<std::string> vertex_line_fault(std::string_view line);

}  // namespace waywright::oracle
