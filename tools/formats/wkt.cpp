#include "formats/wkt.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "formats/polygon_rings.hpp"
#include "formats/scene_builder.hpp"

namespace waywright::formats {

namespace {

constexpr int kDeepestWkt = 64;  // of collections in collections

std::string upper_case(std::string_view word) {
  std::string upper(word);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

class WktReader {
 public:
  WktReader(std::string_view text, const ReadProgress& progress)
      : size_(text.size()), cursor_(text, "(),;="), progress_(progress) {}

  Scene read();

 private:
  /// Reads `SRID=N;` and returns N, if the geometry has this prefix.
  [[nodiscard]] std::optional<std::uint64_t> read_srid();
  void read_geometry(int depth);
  /// Refuses a geometry with heights or measures.
  void check_dimensions(const std::string& kind, std::size_t offset);
  void read_members(const std::string& kind, int depth);
  /// Reads `( ENTRY, ENTRY ... )`. Calls `read_entry` for each entry.
  template <class ReadEntry>
  void read_list(ReadEntry read_entry);
  /// Reads an entry of a MULTI geometry. Calls `read_entry` unless it is EMPTY.
  template <class ReadEntry>
  void read_unless_empty(ReadEntry read_entry);
  [[nodiscard]] Point read_position();
  [[nodiscard]] std::vector<Point> read_positions();
  void read_point();
  void read_point_of_many();
  void read_line();
  void read_polygon();
  void expect(std::string_view mark, std::string_view expected);

  std::size_t size_;
  Cursor cursor_;
  const ReadProgress& progress_;
  SceneBuilder builder_;
  std::optional<std::uint64_t> srid_;  ///< of the first geometry
};

Scene WktReader::read() {
  bool is_first = true;
  while (!cursor_.at_end()) {
    if (cursor_.skip(";")) continue;
    const std::size_t offset = cursor_.offset();
    const std::optional<std::uint64_t> srid = read_srid();
    if (is_first) srid_ = srid;
    is_first = false;
    const auto name_of = [](const auto& id) { return id ? "SRID " + std::to_string(*id) : std::string("no SRID"); };
    if (srid != srid_) {
      refuse(offset, name_of(srid_) + ", as before the first geometry",
             name_of(srid) + "; transform all geometries to one system first");
    }
    read_geometry(0);
    if (progress_) progress_(cursor_.offset(), size_);
  }
  return builder_.take();
}

std::optional<std::uint64_t> WktReader::read_srid() {
  if (upper_case(cursor_.peek()) != "SRID") return std::nullopt;
  cursor_.next();
  expect("=", "'=' after SRID");
  const std::optional<std::uint64_t> srid = text::read_unsigned(cursor_.peek());
  if (!srid) refuse(cursor_.offset(), "a whole number, the SRID", cursor_.found());
  cursor_.next();
  expect(";", "';' after the SRID");
  return srid;
}

void WktReader::expect(std::string_view mark, std::string_view expected) {
  if (!cursor_.skip(mark)) refuse(cursor_.offset(), expected, cursor_.found());
}

void WktReader::read_geometry(int depth) {
  const std::size_t offset = cursor_.offset();
  if (depth > kDeepestWkt) {
    throw Refusal{.offset = offset, .what = "collections lie in collections more than 64 deep; flatten them"};
  }
  const std::string found = cursor_.found();
  const std::string kind = upper_case(cursor_.next());
  static constexpr std::string_view kKinds[] = {"POINT",           "LINESTRING",   "POLYGON",           "MULTIPOINT",
                                                "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"};
  const auto known =
      std::find_if(std::begin(kKinds), std::end(kKinds), [&](std::string_view word) { return kind.starts_with(word); });
  const std::string_view rest = known == std::end(kKinds) ? kind : std::string_view(kind).substr(known->size());
  if (known == std::end(kKinds) || !(rest.empty() || rest == "Z" || rest == "M" || rest == "ZM")) {
    refuse(offset, "POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING, MULTIPOLYGON or GEOMETRYCOLLECTION",
           found + "; convert curves and surfaces to these, for example with PostGIS' ST_CurveToLine");
  }
  check_dimensions(rest.empty() ? upper_case(cursor_.peek()) : std::string(rest), offset);
  if (upper_case(cursor_.peek()) == "EMPTY") {
    cursor_.next();
    return;
  }
  read_members(kind, depth);
}

void WktReader::check_dimensions(const std::string& word, std::size_t offset) {
  if (word != "Z" && word != "M" && word != "ZM") return;
  refuse(offset, "a geometry with x and y only", "one with " + word + kFlattenHint);
}

void WktReader::read_members(const std::string& kind, int depth) {
  const auto each = [this](auto read_entry) { read_list([&] { read_unless_empty(read_entry); }); };
  if (kind == "POINT") return read_point();
  if (kind == "LINESTRING") return read_line();
  if (kind == "POLYGON") return read_polygon();
  if (kind == "MULTIPOINT") return each([this] { read_point_of_many(); });
  if (kind == "MULTILINESTRING") return each([this] { read_line(); });
  if (kind == "MULTIPOLYGON") return each([this] { read_polygon(); });
  read_list([&] { read_geometry(depth + 1); });
}

template <class ReadEntry>
void WktReader::read_list(ReadEntry read_entry) {
  expect("(", "'(' or EMPTY");
  do {
    read_entry();
  } while (cursor_.skip(","));
  expect(")", "',' or ')'");
}

template <class ReadEntry>
void WktReader::read_unless_empty(ReadEntry read_entry) {
  if (upper_case(cursor_.peek()) != "EMPTY") return read_entry();
  cursor_.next();
}

Point WktReader::read_position() {
  Point point;
  for (double* const value : {&point.x, &point.y}) {
    const std::size_t offset = cursor_.offset();
    if (cursor_.at_end()) refuse(offset, "a coordinate", cursor_.found());
    *value = coordinate_of(cursor_.next(), offset);
  }
  const std::string_view after = cursor_.peek();
  if (cursor_.at_end() || after == "," || after == ")") return point;
  if (text::read_number(after))
    refuse(cursor_.offset(), "a position of two numbers", "a third number" + std::string(kFlattenHint));
  refuse(cursor_.offset(), "',' or ')' after a position", cursor_.found());
}

std::vector<Point> WktReader::read_positions() {
  std::vector<Point> points;
  read_list([&] { points.push_back(read_position()); });
  return points;
}

void WktReader::read_point() {
  expect("(", "'(' or EMPTY");
  builder_.add(Shape::point(read_position()));
  expect(")", "')' after the position of a POINT");
}

void WktReader::read_point_of_many() {
  // Both `MULTIPOINT((1 2), (3 4))` and `MULTIPOINT(1 2, 3 4)` are in use.
  if (cursor_.peek() == "(") return read_point();
  builder_.add(Shape::point(read_position()));
}

void WktReader::read_line() {
  const std::size_t offset = cursor_.offset();
  std::vector<Point> points = read_positions();
  check_line(points, "a LINESTRING", offset);
  builder_.add(line_of_points(std::move(points)));
}

void WktReader::read_polygon() {
  Rings rings;
  read_list([&] {
    const std::size_t offset = cursor_.offset();
    std::vector<Point> ring = read_positions();
    open_ring(ring, "ring " + std::to_string(rings.size() + 1) + " of the polygon", offset);
    rings.push_back(ring);
  });
  builder_.add(Shape::polygon(std::move(rings)));
}

}  // namespace

Result<Scene> parse_wkt(std::string_view text, std::string_view name, const ReadProgress& progress) {
  return read_scene_text(text, name, [&](std::string_view read) { return WktReader(read, progress).read(); });
}

}  // namespace waywright::formats
