#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/scenario.hpp"
#include "waywright/scene.hpp"

#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

/// Reads the rows of a map, or returns the error in it.
class MapReader {
 public:
  MapReader(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Result<std::vector<std::string_view>> run() {
    if (!header_line("type", "octile") || !size_line("height", height_) || !size_line("width", width_) ||
        !header_line("map", {}) || !read_rows()) {
      return std::move(error_);
    }
    return std::move(rows_);
  }

 private:
  /// Reads a line that consists of `key` and, unless it is empty, `value`.
  bool header_line(std::string_view key, std::string_view value);
  bool size_line(std::string_view key, std::uint64_t& size);
  bool read_rows();
  bool read_row(std::string_view row);
  bool fail(std::string_view expected, std::string_view found);

  text::LineReader lines_;
  std::string_view name_;
  std::uint64_t height_ = 0;
  std::uint64_t width_ = 0;
  std::vector<std::string_view> rows_;
  Error error_;
};

bool MapReader::fail(std::string_view expected, std::string_view found) {
  std::string what = "expected ";
  what += expected;
  what += ", found ";
  what += found;
  error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(), what);
  return false;
}

bool MapReader::header_line(std::string_view key, std::string_view value) {
  std::string expected = "'";
  expected += key;
  if (!value.empty()) {
    expected += ' ';
    expected += value;
  }
  expected += '\'';
  std::string_view line;
  if (!lines_.next(line)) return fail(expected, "the end of the text");
  text::WordReader words(line);
  std::string_view word;
  const bool matches =
      words.next(word) && word == key && (value.empty() || (words.next(word) && word == value)) && words.at_end();
  return matches || fail(expected, text::in_quotes(line));
}

bool MapReader::size_line(std::string_view key, std::uint64_t& size) {
  std::string expected = "'";
  expected += key;
  expected += "' and a number, 1 or more";
  std::string_view line;
  if (!lines_.next(line)) return fail(expected, "the end of the text");
  text::WordReader words(line);
  std::string_view word;
  if (words.next(word) && word == key && words.next(word) && words.at_end()) {
    size = text::read_unsigned(word).value_or(0);
  }
  return size > 0 || fail(expected, text::in_quotes(line));
}

bool MapReader::read_row(std::string_view row) {
  constexpr std::string_view kAlphabet = ".GS@OTW";
  const std::size_t unknown = row.find_first_not_of(kAlphabet);
  if (unknown != std::string_view::npos) {
    return fail("tiles out of '.GS@OTW'", text::in_quotes(row.substr(unknown, 1)));
  }
  if (row.size() == width_) return true;
  return fail(base::with_number("a row of ", width_, " tiles"), base::with_number("", row.size(), ""));
}

bool MapReader::read_rows() {
  std::string_view line;
  while (rows_.size() < height_) {
    if (!lines_.next(line)) {
      return fail(base::with_number("", height_, " rows"),
                  base::with_number("the end of the text after ", rows_.size(), ""));
    }
    if (!read_row(line)) return false;
    rows_.push_back(line);
  }
  while (lines_.next(line)) {
    if (!text::WordReader(line).at_end()) {
      return fail(base::with_number("the end of the text after ", height_, " rows"), text::in_quotes(line));
    }
  }
  return true;
}

/// The sides of a tile, in the order in which a ring follows them. If y points up, the tile is then to the left.
/// Direction (s + 3) mod 4 leads out of the tile across side s.
enum Side : std::uint8_t { top, right, bottom, left };

/// The blocked tiles of a map, and the rings around their groups. A group is a set of blocked tiles that are connected
/// through their sides.
///
/// At a lattice point where two blocked tiles touch diagonally and the other two tiles are free, a ring can turn in two
/// directions. If the blocked tiles are in different groups, each ring turns around its own tile: the rings stay
/// separate. If they are in one group, they are also connected elsewhere. The group then encloses one of the two free
/// tiles and separates it from the other. At such a point the ring passes from one blocked tile to the other, and so
/// stays at the same free tile. Thus every ring bounds one region of the area that the group leaves free, and passes no
/// point twice: every ring is simple, and two rings of a group meet only in points.
class Tracer {
 public:
  explicit Tracer(const std::vector<std::string_view>& rows);

  /// Returns the groups as polygons, in the order of their first tiles, row by row. Each has its outer ring first, then
  /// the holes.
  std::vector<Item> run();

 private:
  /// A step along a ring: a side of a tile.
  struct Step {
    std::size_t tile = 0;
    Side side = top;

    friend bool operator==(const Step&, const Step&) = default;
  };

  /// Writes `group` into all tiles of the group that contains `first`.
  void fill(std::size_t first, std::size_t group);
  std::vector<Point> trace(std::size_t first);
  [[nodiscard]] Step next(Step at) const;
  [[nodiscard]] std::size_t neighbour(std::size_t tile, unsigned direction) const;
  /// The lattice point at which the ring starts to follow a side.
  [[nodiscard]] Point start_of(Step at) const;

  /// The number of a tile's group. Groups count from kFirstGroup; smaller numbers mean that the tile is in no group.
  static constexpr std::size_t kFree = 0;
  static constexpr std::size_t kUnmarked = 1;
  static constexpr std::size_t kFirstGroup = 2;

  std::size_t stride_;              ///< tiles per row, including a free tile at each end
  std::vector<std::size_t> group_;  ///< by tile, including a free row above and one below
  std::vector<bool> top_traced_;    ///< by tile: whether a ring has passed its top side
  std::vector<std::size_t> stack_;  ///< scratch of fill()
};

Tracer::Tracer(const std::vector<std::string_view>& rows)
    : stride_(rows.front().size() + 2), group_(stride_ * (rows.size() + 2), kFree), top_traced_(group_.size()) {
  std::size_t tile = stride_ + 1;
  for (const std::string_view row : rows) {
    for (const char c : row) group_[tile++] = c == '.' || c == 'G' || c == 'S' ? kFree : kUnmarked;
    tile += 2;
  }
}

std::size_t Tracer::neighbour(std::size_t tile, unsigned direction) const {
  switch (direction % 4) {
    case 0:
      return tile + 1;
    case 1:
      return tile + stride_;
    case 2:
      return tile - 1;
    default:
      return tile - stride_;
  }
}

std::vector<Item> Tracer::run() {
  std::vector<Item> items;
  for (std::size_t tile = stride_; tile < group_.size() - stride_; ++tile) {
    if (group_[tile] == kFree) continue;
    if (group_[tile] == kUnmarked) {
      fill(tile, kFirstGroup + items.size());
      items.push_back({ItemId{items.size() + 1}, Shape{ItemKind::polygon, {}}});
    }
    // Every ring has a top side. The first top side in a group's first tile belongs to the outer ring.
    if (group_[tile - stride_] == kFree && !top_traced_[tile]) {
      items[group_[tile] - kFirstGroup].shape.rings.push_back(trace(tile));
    }
  }
  return items;
}

void Tracer::fill(std::size_t first, std::size_t group) {
  group_[first] = group;
  stack_.push_back(first);
  while (!stack_.empty()) {
    const std::size_t tile = stack_.back();
    stack_.pop_back();
    for (const unsigned direction : {0U, 1U, 2U, 3U}) {
      const std::size_t other = neighbour(tile, direction);
      if (group_[other] != kUnmarked) continue;
      group_[other] = group;
      stack_.push_back(other);
    }
  }
}

Tracer::Step Tracer::next(Step at) const {
  const auto outwards = static_cast<Side>((at.side + 3) % 4);
  const std::size_t ahead = neighbour(at.tile, at.side);
  const std::size_t diagonal = neighbour(ahead, outwards);
  if (group_[ahead] != kFree) return group_[diagonal] != kFree ? Step{diagonal, outwards} : Step{ahead, at.side};
  if (group_[diagonal] == group_[at.tile]) return {diagonal, outwards};
  return {at.tile, static_cast<Side>((at.side + 1) % 4)};
}

Point Tracer::start_of(Step at) const {
  const std::size_t x = at.tile % stride_ - 1 + (at.side == right || at.side == bottom ? 1 : 0);
  const std::size_t y = at.tile / stride_ - 1 + (at.side == bottom || at.side == left ? 1 : 0);
  return {static_cast<double>(x), static_cast<double>(y)};
}

std::vector<Point> Tracer::trace(std::size_t first) {
  // The first top side in scan order starts at a corner: the scan would have met a side before it on the same line
  // earlier.
  const Step start{first, top};
  std::vector<Point> ring{start_of(start)};
  top_traced_[first] = true;
  for (Step at = next(start), before = start; at != start; before = at, at = next(at)) {
    if (at.side != before.side) ring.push_back(start_of(at));
    if (at.side == top) top_traced_[at.tile] = true;
  }
  return ring;
}

}  // namespace

Result<Scene> parse_movingai_map(std::string_view text, std::string_view name) {
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  Result<std::vector<std::string_view>> rows = MapReader(text, name).run();
  if (!rows.ok()) return rows.error();
  const Point far_corner{static_cast<double>(rows->front().size()), static_cast<double>(rows->size())};
  return Scene{.domain = {{0.0, 0.0}, far_corner}, .items = Tracer(*rows).run(), .y_down = true};
}

namespace {

constexpr std::size_t kFields = 9;

/// Returns half a unit of the last digit of a decimal number. Reads the result from a text, because std::pow rounds
/// differently on other machines.
double precision_of(std::string_view word) {
  constexpr double kBeyondDoubles = 400.0;
  const std::size_t point = word.find('.');
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const double digits = point == std::string_view::npos ? 0.0 : static_cast<double>(end - point - 1);
  const double exponent = end < word.size() ? text::read_number(word.substr(end + 1)).value_or(0.0) : 0.0;
  const double position = std::clamp(exponent - digits - 1.0, -kBeyondDoubles, kBeyondDoubles);
  return text::read_number("5e" + std::to_string(static_cast<int>(position))).value_or(0.0);
}

/// Reads one scenario. Each function that returns bool returns false after it has stored an error in `error_`.
class ScenarioParser {
 public:
  ScenarioParser(std::string_view text, std::string_view name) : lines_(text), name_(name) {}

  Result<std::vector<ScenarioQuery>> run();

 private:
  bool read_header();
  bool read_query(const std::vector<std::string_view>& fields);
  bool tiles(std::string_view field, std::string_view word, std::uint64_t& value);
  bool number(std::string_view field, std::string_view word, double& value);
  bool fail(std::string_view what);

  text::LineReader lines_;
  std::string_view name_;
  std::vector<ScenarioQuery> queries_;
  Error error_;
};

bool ScenarioParser::fail(std::string_view what) {
  error_ = text::error_at(ErrorCode::malformed, name_, lines_.number(), what);
  return false;
}

bool ScenarioParser::read_header() {
  std::string_view line;
  std::string_view word;
  std::string_view version;
  if (!lines_.next(line)) {
    return fail("expected 'version 1', as scenarios of Moving AI begin, found the end of the text");
  }
  text::WordReader words(line);
  const bool matches = words.next(word) && word == "version" && words.next(version) && words.at_end() &&
                       (version == "1" || version == "1.0");
  return matches || fail("expected 'version 1', as scenarios of Moving AI begin, found " + text::in_quotes(line));
}

bool ScenarioParser::tiles(std::string_view field, std::string_view word, std::uint64_t& value) {
  const std::optional<std::uint64_t> read = text::read_unsigned(word);
  value = read.value_or(0);
  std::string what = "expected a whole number of tiles as the ";
  what += field;
  what += ", found ";
  return read || fail(what + text::in_quotes(word));
}

bool ScenarioParser::number(std::string_view field, std::string_view word, double& value) {
  const std::optional<double> read = text::read_number(word);
  value = read.value_or(0.0);
  std::string what = "expected a finite number as the ";
  what += field;
  what += ", found ";
  return (read && std::isfinite(*read)) || fail(what + text::in_quotes(word));
}

bool ScenarioParser::read_query(const std::vector<std::string_view>& fields) {
  if (fields.size() != kFields) {
    return fail(base::with_number(
        "expected 9 fields (bucket, map, width, height, start x, start y, goal x, goal y, length), found ",
        fields.size(), ""));
  }
  ScenarioQuery query;
  query.line = static_cast<std::uint32_t>(lines_.number());
  query.map = fields[1];
  const bool ok = tiles("width", fields[2], query.width) && tiles("height", fields[3], query.height) &&
                  number("start's x", fields[4], query.start.x) && number("start's y", fields[5], query.start.y) &&
                  number("goal's x", fields[6], query.goal.x) && number("goal's y", fields[7], query.goal.y) &&
                  number("length", fields[8], query.length);
  query.precision = precision_of(fields[8]);
  if (ok) queries_.push_back(std::move(query));
  return ok;
}

Result<std::vector<ScenarioQuery>> ScenarioParser::run() {
  if (!read_header()) return std::move(error_);
  std::string_view line;
  std::vector<std::string_view> fields;
  while (lines_.next(line)) {
    fields.clear();
    text::WordReader words(line);
    std::string_view word;
    while (words.next(word)) fields.push_back(word);
    if (!fields.empty() && !read_query(fields)) return std::move(error_);
  }
  if (queries_.empty()) {
    fail("expected a query after 'version 1', found the end of the text");
    return std::move(error_);
  }
  return std::move(queries_);
}

}  // namespace

Result<std::vector<ScenarioQuery>> parse_movingai_scenario(std::string_view text, std::string_view name) {
  const base::FloatEnvironment environment;
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  return ScenarioParser(text, name).run();
}

}  // namespace waywright
