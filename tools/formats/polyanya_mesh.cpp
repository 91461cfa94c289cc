#include "formats/polyanya_mesh.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "formats/scene_builder.hpp"

namespace waywright::formats {

namespace {

/// A side of a polygon, from one vertex to the next one. The polygon lies to its left.
struct Side {
  std::size_t from = 0;
  std::size_t to = 0;
  std::int64_t polygon = 0;
  std::int64_t neighbour = -1;  ///< the polygon to its right; -1 for none
  std::size_t offset = 0;       ///< where the polygon is in the text

  [[nodiscard]] std::pair<std::size_t, std::size_t> ends() const { return {from, to}; }
};

class MeshReader {
 public:
  MeshReader(std::string_view text, const ReadProgress& progress)
      : size_(text.size()), cursor_(text), progress_(progress) {}

  Scene read();

 private:
  void read_header();
  void read_vertex();
  void read_polygon(std::int64_t number);
  /// Reads a whole number from `least` to `most`.
  [[nodiscard]] std::int64_t read_integer(const std::string& expected, std::int64_t least, std::int64_t most);
  [[nodiscard]] double read_coordinate();
  /// Checks that two polygons at one side name each other. Requires: the sides are sorted.
  void check_neighbours() const;
  /// Returns the rings of the sides without a neighbour. Requires: the neighbours are checked.
  [[nodiscard]] std::vector<std::vector<Point>> border() const;

  std::size_t size_;
  Cursor cursor_;
  const ReadProgress& progress_;
  std::int64_t vertex_count_ = 0;
  std::int64_t polygon_count_ = 0;
  std::vector<Point> vertices_;
  std::vector<Side> sides_;
};

std::int64_t MeshReader::read_integer(const std::string& expected, std::int64_t least, std::int64_t most) {
  const std::size_t offset = cursor_.offset();
  const std::string_view word = cursor_.peek();
  std::int64_t value = 0;
  const auto [stop, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_number = fault == std::errc{} && stop == word.data() + word.size() && !word.empty();
  if (!is_number || value < least || value > most) refuse(offset, expected, cursor_.found());
  cursor_.next();
  return value;
}

double MeshReader::read_coordinate() {
  const std::size_t offset = cursor_.offset();
  if (cursor_.at_end()) refuse(offset, "a coordinate", cursor_.found());
  return coordinate_of(cursor_.next(), offset);
}

void MeshReader::read_header() {
  if (!cursor_.skip("mesh"))
    refuse(cursor_.offset(), "the word 'mesh', which starts a mesh of Polyanya", cursor_.found());
  if (cursor_.peek() == "1") {
    refuse(cursor_.offset(), "version 2",
           "version 1; move the last neighbour of each polygon to the front of its neighbours, and write 2 here");
  }
  if (!cursor_.skip("2")) refuse(cursor_.offset(), "version 2", cursor_.found());
  // Each vertex and each polygon takes more than one character of the text.
  const auto most = static_cast<std::int64_t>(size_);
  vertex_count_ = read_integer("the number of vertices, at most the length of the file", 3, most);
  polygon_count_ = read_integer("the number of polygons, at least 1 and at most the length of the file", 1, most);
}

void MeshReader::read_vertex() {
  const double x = read_coordinate();
  const double y = read_coordinate();
  vertices_.push_back({x, y});
  const auto most = static_cast<std::int64_t>(size_);
  const std::int64_t count = read_integer("the number of polygons at the vertex", 0, most);
  for (std::int64_t i = 0; i < count; ++i) {
    static_cast<void>(read_integer("a polygon at the vertex, from -1 to " + std::to_string(polygon_count_ - 1), -1,
                                   polygon_count_ - 1));
  }
}

void MeshReader::read_polygon(std::int64_t number) {
  const std::size_t offset = cursor_.offset();
  const auto most = static_cast<std::int64_t>(size_);
  const std::int64_t count = read_integer("the number of corners of a polygon, at least 3", 3, most);
  const std::size_t first = sides_.size();
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t vertex = read_integer(
        "a corner of the polygon: a vertex from 0 to " + std::to_string(vertex_count_ - 1), 0, vertex_count_ - 1);
    sides_.push_back({.from = 0, .to = static_cast<std::size_t>(vertex), .polygon = number, .offset = offset});
  }
  // The neighbour i is across the side from corner i - 1 to corner i.
  for (std::size_t i = first; i < sides_.size(); ++i)
    sides_[i].from = sides_[i == first ? sides_.size() - 1 : i - 1].to;
  for (std::size_t i = first; i < sides_.size(); ++i) {
    sides_[i].neighbour = read_integer("a neighbour of the polygon, from -1 to " + std::to_string(polygon_count_ - 1),
                                       -1, polygon_count_ - 1);
  }
  if (progress_) progress_(cursor_.offset(), size_);
}

void MeshReader::check_neighbours() const {
  const auto by_ends = [](const Side& side, const std::pair<std::size_t, std::size_t>& ends) {
    return side.ends() < ends;
  };
  const auto refuse_side = [](const Side& side, const std::string& found) {
    refuse(side.offset, "polygons that share a side to name each other",
           found + " at the side from vertex " + std::to_string(side.from) + " to vertex " + std::to_string(side.to) +
               " of polygon " + std::to_string(side.polygon));
  };
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& side = sides_[i];
    if (i > 0 && sides_[i - 1].ends() == side.ends()) {
      refuse_side(side, "polygon " + std::to_string(sides_[i - 1].polygon) + " on the same side");
    }
    if (side.neighbour < 0) continue;
    const auto twin = std::lower_bound(sides_.begin(), sides_.end(), std::pair(side.to, side.from), by_ends);
    const bool is_mutual = twin != sides_.end() && twin->ends() == std::pair(side.to, side.from) &&
                           twin->polygon == side.neighbour && twin->neighbour == side.polygon;
    if (!is_mutual) refuse_side(side, "the neighbour " + std::to_string(side.neighbour) + ", which does not,");
  }
}

std::vector<std::vector<Point>> MeshReader::border() const {
  std::vector<Side> open;
  for (const Side& side : sides_) {
    if (side.neighbour < 0) open.push_back(side);
  }
  // At each vertex as many sides of the border start as end, because the sides of each polygon form a ring and sides
  // with a neighbour come in pairs. So a chain of unused sides ends where it starts.
  std::vector<std::size_t> next_at(vertices_.size() + 1, 0);
  for (const Side& side : open) ++next_at[side.from + 1];
  for (std::size_t i = 1; i < next_at.size(); ++i) next_at[i] += next_at[i - 1];
  std::vector<bool> is_used(open.size());
  std::vector<std::vector<Point>> rings;
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (is_used[start]) continue;
    std::vector<Point>& ring = rings.emplace_back();
    std::size_t at = open[start].from;
    do {
      const std::size_t side = next_at[at]++;
      is_used[side] = true;
      ring.push_back(vertices_[at]);
      at = open[side].to;
    } while (at != open[start].from);
  }
  return rings;
}

Scene MeshReader::read() {
  read_header();
  for (std::int64_t i = 0; i < vertex_count_; ++i) read_vertex();
  for (std::int64_t i = 0; i < polygon_count_; ++i) read_polygon(i);
  if (!cursor_.at_end()) refuse(cursor_.offset(), "the end of the text after the last polygon", cursor_.found());
  std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) { return a.ends() < b.ends(); });
  check_neighbours();
  Box box{vertices_.front(), vertices_.front()};
  for (const Point& vertex : vertices_) box = with_point(box, vertex);
  const Box domain = domain_around(box);
  Rings rings{std::vector<Point>{domain.min, {domain.max.x, domain.min.y}, domain.max, {domain.min.x, domain.max.y}}};
  for (const std::vector<Point>& ring : border()) rings.push_back(ring);
  SceneBuilder builder;
  builder.set_domain(domain);
  builder.add(Shape::polygon(std::move(rings)));
  return builder.take();
}

}  // namespace

Result<Scene> parse_polyanya_mesh(std::string_view text, std::string_view name, const ReadProgress& progress) {
  return read_scene_text(text, name, [&](std::string_view read) { return MeshReader(read, progress).read(); });
}

}  // namespace waywright::formats
