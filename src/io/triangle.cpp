#include "io/triangle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/scene.hpp"

#include "base/domain_bounds.hpp"
#include "base/float_environment.hpp"
#include "base/number_text.hpp"
#include "text/text.hpp"

namespace waywright {
namespace {

/// The vertices of a file. Their ids are first_id, first_id + 1, ...
struct VertexList {
  std::uint64_t first_id = 1;
  std::vector<Point> points;
};

/// Two indices in a vertex list.
using Ends = std::array<std::size_t, 2>;

/// Reads the sections of one file. Each function that returns bool returns false after it has stored an error, except
/// next_line().
class SectionReader {
 public:
  SectionReader(std::string_view text, std::string_view name) : lines_(text), text_size_(text.size()), name_(name) {}

  [[nodiscard]] Error take_error() { return std::move(error_); }

  bool vertices(VertexList& list);
  bool segments(const VertexList& list, std::vector<Ends>& segments);
  bool holes();
  /// Reads the only section that may be missing.
  bool regions();
  bool end();

  bool fail(std::string_view expected, std::string_view found, ErrorCode code = ErrorCode::malformed);

 private:
  /// Moves to the next line that contains a word. Returns false at the end of the text, which is not an error.
  bool next_line();
  /// Moves to the first line of a section and reads the number of its entries.
  bool section(std::string_view counted, std::uint64_t& count);
  /// Moves to the line of an entry and reads its id, which must be one more than the last id. The first id must be 0 or
  /// 1.
  bool entry(std::string_view kind, std::uint64_t index, std::uint64_t& first_id);
  bool word(std::string_view expected, std::string_view& value);
  bool integer(std::string_view expected, std::uint64_t& value);
  /// Reads an integer that may be missing at the end of the line; it is then 0.
  bool optional_integer(std::string_view expected, std::uint64_t largest, std::uint64_t& value);
  bool coordinates(Point& point);
  /// Reads numbers, checks them and drops them.
  bool numbers(std::string_view expected, std::uint64_t count);
  bool end_of_line();

  text::LineReader lines_;
  std::size_t text_size_;
  std::string_view name_;
  text::WordReader words_;
  Error error_;
};

bool SectionReader::fail(std::string_view expected, std::string_view found, ErrorCode code) {
  std::string what = "expected ";
  what += expected;
  what += ", found ";
  what += found;
  error_ = text::error_at(code, name_, lines_.number(), what);
  return false;
}

bool SectionReader::next_line() {
  std::string_view line;
  while (lines_.next(line)) {
    words_ = text::WordReader(text::without_comment(line));
    if (!words_.at_end()) return true;
  }
  return false;
}

bool SectionReader::word(std::string_view expected, std::string_view& value) {
  return words_.next(value) || fail(expected, "the end of the line");
}

bool SectionReader::integer(std::string_view expected, std::uint64_t& value) {
  std::string_view text;
  if (!word(expected, text)) return false;
  const std::optional<std::uint64_t> read = text::read_unsigned(text);
  if (!read) return fail(expected, text::in_quotes(text));
  value = *read;
  return true;
}

bool SectionReader::optional_integer(std::string_view expected, std::uint64_t largest, std::uint64_t& value) {
  value = 0;
  if (words_.at_end()) return true;
  if (!integer(expected, value)) return false;
  return value <= largest || fail(expected, base::with_number("", value, ""));
}

bool SectionReader::coordinates(Point& point) {
  for (double* const value : {&point.x, &point.y}) {
    constexpr std::string_view kExpected = "a coordinate";
    std::string_view text;
    if (!word(kExpected, text)) return false;
    const std::optional<double> read = text::read_number(text);
    if (!read) return fail(kExpected, text::in_quotes(text));
    if (!is_in_range(*read)) {
      return fail("a coordinate that is 0 or has a size from 2^-100 to 2^100", text::in_quotes(text),
                  ErrorCode::coordinate_range);
    }
    *value = *read;
  }
  return true;
}

bool SectionReader::numbers(std::string_view expected, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    std::string_view text;
    if (!word(expected, text)) return false;
    if (!text::read_number(text)) return fail(expected, text::in_quotes(text));
  }
  return true;
}

bool SectionReader::end_of_line() {
  std::string_view text;
  return !words_.next(text) || fail("the end of the line", text::in_quotes(text));
}

bool SectionReader::section(std::string_view counted, std::uint64_t& count) {
  std::string expected = "the number of ";
  expected += counted;
  if (!next_line()) return fail(expected, "the end of the text");
  return integer(expected, count);
}

bool SectionReader::entry(std::string_view kind, std::uint64_t index, std::uint64_t& first_id) {
  std::string expected(kind);
  expected += index == 0 ? std::string(" 0 or 1") : base::with_number(" ", first_id + index, "");
  if (!next_line()) return fail(expected, "the end of the text");
  std::uint64_t id = 0;
  if (!integer(expected, id)) return false;
  if (index == 0) first_id = std::min<std::uint64_t>(id, 1);
  return id == first_id + index || fail(expected, base::with_number("", id, ""));
}

bool SectionReader::vertices(VertexList& list) {
  std::uint64_t count = 0;
  std::uint64_t dimension = 2;
  std::uint64_t attributes = 0;
  std::uint64_t markers = 0;
  if (!section("vertices", count)) return false;
  if (!words_.at_end() && !integer("dimension 2", dimension)) return false;
  if (dimension != 2) return fail("dimension 2", base::with_number("", dimension, ""));
  if (!optional_integer("the number of attributes", UINT64_MAX, attributes) ||
      !optional_integer("0 or 1 boundary markers", 1, markers) || !end_of_line()) {
    return false;
  }
  // A vertex takes a line of at least six characters. So a count that is too large for the text does not cost memory.
  list.points.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, text_size_ / 6 + 1)));
  for (std::uint64_t i = 0; i < count; ++i) {
    Point point;
    if (!entry("vertex", i, list.first_id) || !coordinates(point) || !numbers("an attribute", attributes) ||
        !numbers("a boundary marker", markers) || !end_of_line()) {
      return false;
    }
    list.points.push_back(point);
  }
  return true;
}

bool SectionReader::segments(const VertexList& list, std::vector<Ends>& segments) {
  std::uint64_t count = 0;
  std::uint64_t markers = 0;
  if (!section("segments", count) || !optional_integer("0 or 1 boundary markers", 1, markers) || !end_of_line()) {
    return false;
  }
  std::uint64_t first_id = 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!entry("segment", i, first_id)) return false;
    Ends ends{};
    for (std::size_t& end : ends) {
      constexpr std::string_view kExpected = "the id of a vertex";
      std::uint64_t id = 0;
      if (!integer(kExpected, id)) return false;
      if (id < list.first_id || id - list.first_id >= list.points.size()) {
        return fail(kExpected, base::with_number("", id, ", which no vertex has"));
      }
      end = static_cast<std::size_t>(id - list.first_id);
    }
    if (!numbers("a boundary marker", markers) || !end_of_line()) return false;
    segments.push_back(ends);
  }
  return true;
}

bool SectionReader::holes() {
  std::uint64_t count = 0;
  if (!section("holes", count) || !end_of_line()) return false;
  std::uint64_t first_id = 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!entry("hole", i, first_id) || !numbers("a coordinate", 2) || !end_of_line()) return false;
  }
  return true;
}

bool SectionReader::regions() {
  if (!next_line()) return true;
  std::uint64_t count = 0;
  if (!integer("the number of regions", count) || !end_of_line()) return false;
  std::uint64_t first_id = 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!entry("region", i, first_id) || !numbers("a coordinate", 2) || !numbers("an attribute", 1)) return false;
    if (!words_.at_end() && !numbers("a largest area", 1)) return false;
    if (!end_of_line()) return false;
  }
  return true;
}

bool SectionReader::end() { return !next_line() || fail("the end of the text", "one more line"); }

Box domain_around(const std::vector<Point>& points) {
  Box box;
  if (!points.empty()) box = {points.front(), points.front()};
  for (const Point p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  const base::Bounds bounds = base::domain_bounds({box.min.x, box.min.y, box.max.x, box.max.y}, kLargestCoordinate);
  return {{bounds.min_x, bounds.min_y}, {bounds.max_x, bounds.max_y}};
}

Scene to_scene(const VertexList& list, const std::vector<Ends>& segments) {
  Scene scene{.domain = domain_around(list.points), .items = {}, .y_down = false};
  std::vector<bool> on_segment(list.points.size());
  for (const Ends ends : segments) on_segment[ends[0]] = on_segment[ends[1]] = true;
  const auto add = [&](ItemKind kind, std::vector<Point> points) {
    scene.items.push_back({ItemId{scene.items.size() + 1}, Shape{kind, {std::move(points)}}});
  };
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    if (!on_segment[i]) add(ItemKind::point, {list.points[i]});
  }
  for (const Ends ends : segments) add(ItemKind::segment, {list.points[ends[0]], list.points[ends[1]]});
  return scene;
}

}  // namespace

namespace io {

bool lacks_vertices(std::string_view poly_text) {
  if (text::skip_byte_order_mark(poly_text, {})) return false;
  text::LineReader lines(poly_text);
  std::string_view line;
  while (lines.next(line)) {
    text::WordReader words(text::without_comment(line));
    std::string_view word;
    if (words.next(word)) return text::read_unsigned(word) == 0;
  }
  return false;
}

}  // namespace io

Result<Scene> parse_triangle_poly(std::string_view text, std::string_view name, std::string_view node_text,
                                  std::string_view node_name) {
  const base::FloatEnvironment environment;
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  if (auto error = text::skip_byte_order_mark(node_text, node_name)) return *std::move(error);
  SectionReader poly(text, name);
  VertexList list;
  if (!poly.vertices(list)) return poly.take_error();
  if (list.points.empty() && !node_text.empty()) {
    SectionReader node(node_text, node_name);
    if (!node.vertices(list) || !node.end()) return node.take_error();
  } else if (list.points.empty()) {
    poly.fail("vertices, here or in a .node file of the same name", "none");
    return poly.take_error();
  }
  std::vector<Ends> segments;
  if (!poly.segments(list, segments) || !poly.holes() || !poly.regions() || !poly.end()) return poly.take_error();
  return to_scene(list, segments);
}

Result<Scene> parse_triangle_node(std::string_view text, std::string_view name) {
  const base::FloatEnvironment environment;
  if (auto error = text::skip_byte_order_mark(text, name)) return *std::move(error);
  SectionReader node(text, name);
  VertexList list;
  if (!node.vertices(list) || !node.end()) return node.take_error();
  return to_scene(list, {});
}

}  // namespace waywright
