#include "oracle/dump_text.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "oracle/exact.hpp"

namespace waywright::oracle {
namespace {

bool is_integer(std::string_view word) {
  const bool negative = !word.empty() && word.front() == '-';
  const std::string_view digits = word.substr(negative ? 1 : 0);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return false;
  }
  return digits.front() != '0' || (digits.size() == 1 && !negative);
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t end = line.find(' ');
    words.push_back(line.substr(0, end));
    if (end == std::string_view::npos) return words;
    line.remove_prefix(end + 1);
  }
}

std::optional<std::uint32_t> index_of(std::string_view word) {
  if (!is_integer(word)) return std::nullopt;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  std::optional<std::string_view> next() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  /// Returns the lines of a section after its heading `NAME COUNT`.
  std::optional<std::vector<std::string_view>> section(std::string_view name, std::string& fault) {
    const auto heading = next();
    const auto words = heading ? words_of(*heading) : std::vector<std::string_view>{};
    const auto count = words.size() == 2 && words[0] == name ? index_of(words[1]) : std::nullopt;
    if (!count) {
      fault = "expected '" + std::string(name) + " COUNT'" + (heading ? ", got '" + std::string(*heading) + "'" : "");
      return std::nullopt;
    }
    std::vector<std::string_view> lines;
    for (std::uint32_t i = 0; i < *count; ++i) {
      const auto line = next();
      if (!line) {
        fault = "the section " + std::string(name) + " ends after " + std::to_string(i) + " of " +
                std::to_string(*count) + " lines";
        return std::nullopt;
      }
      lines.push_back(*line);
    }
    return lines;
  }

 private:
  std::string_view rest_;
};

}  // namespace

std::optional<DumpText> read_dump(std::string_view dump, std::string& fault) {
  Lines lines(dump);
  DumpText result;
  const auto vertices = lines.section("vertices", fault);
  if (!vertices) return std::nullopt;
  result.vertices = *vertices;
  const auto triangles = lines.section("triangles", fault);
  if (!triangles) return std::nullopt;
  for (const std::string_view line : *triangles) {
    const auto words = words_of(line);
    std::array<std::uint32_t, 3> triangle{};
    bool right = words.size() == 3;
    for (std::size_t k = 0; right && k < 3; ++k) {
      const auto index = index_of(words[k]);
      right = index.has_value() && *index < result.vertices.size();
      if (right) triangle[k] = *index;
    }
    if (!right) {
      fault = "triangle '" + std::string(line) + "' is not three vertices";
      return std::nullopt;
    }
    result.triangles.push_back(triangle);
  }
  const auto constraints = lines.section("constraints", fault);
  if (!constraints) return std::nullopt;
  result.constraints = *constraints;
  if (!lines.at_end()) {
    fault = "there is text after the last constraint";
    return std::nullopt;
  }
  return result;
}

std::optional<std::string> vertex_line_fault(std::string_view line) {
  const auto words = words_of(line);
  if (words.size() != 4 || !std::all_of(words.begin(), words.end(), is_integer)) return "is not four integers";
  for (std::size_t k = 0; k < 4; k += 2) {
    const Integer numerator{std::string(words[k])};
    const Integer denominator{std::string(words[k + 1])};
    if (denominator.sign() <= 0) return "has a denominator that is not positive";
    if (gcd(numerator, denominator) != 1) return "has a fraction that is not reduced";
  }
  return std::nullopt;
}

}  // namespace waywright::oracle
