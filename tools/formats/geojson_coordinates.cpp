#include "formats/geojson_coordinates.hpp"

#include <utility>

#include "formats/polygon_rings.hpp"
#include "formats/reader.hpp"
#include "formats/scene_builder.hpp"

namespace waywright::formats {

namespace {

/// Returns how many arrays contain each number of a geometry.
std::size_t depth_of(std::string_view type) {
  if (type == "Point") return 1;
  if (type == "LineString" || type == "MultiPoint") return 2;
  return type == "MultiPolygon" ? 4 : 3;
}

std::string arrays_text(std::size_t depth) {
  if (depth == 1) return "one array";
  return "arrays in arrays, " + std::to_string(depth) + " deep";
}

}  // namespace

void Coordinates::open_array(std::size_t offset) {
  if (depth_ == kDeepest) refuse(offset, "a number", "an array more than 4 deep");
  if (depth_ > 0) {
    if (contents_[depth_ - 1] == Content::numbers) refuse(offset, "a number in a position", "an array");
    contents_[depth_ - 1] = Content::arrays;
  }
  contents_[depth_++] = Content::none;
  number_count_ = 0;
}

void Coordinates::add_number(double number, std::size_t offset) {
  if (depth_ == 0) refuse(offset, "an array of coordinates", "a number");
  Content& content = contents_[depth_ - 1];
  if (content == Content::arrays) refuse(offset, "an array", "a number");
  content = Content::numbers;
  if (number_count_ == 2) refuse(offset, "a position of two numbers", "a third number" + std::string(kFlattenHint));
  numbers_[number_count_++] = number;
}

void Coordinates::close_array(std::size_t offset) {
  const Content content = contents_[--depth_];
  if (content == Content::numbers) return close_position(offset);
  if (depth_ == 0) return;  // an empty array is an empty geometry
  if (content == Content::none) refuse(offset, "positions or numbers in an array", "nothing");
  const bool holds_positions = depth_ + 2 == position_depth_;
  ends_[depth_ - 1].push_back(holds_positions ? points_.size() : ends_[depth_].size());
}

void Coordinates::close_position(std::size_t offset) {
  if (number_count_ < 2) refuse(offset, "a position of two numbers", "one number");
  if (position_depth_ == 0) position_depth_ = depth_ + 1;
  if (position_depth_ != depth_ + 1) {
    refuse(offset, "all positions equally deep: in " + arrays_text(position_depth_), arrays_text(depth_ + 1));
  }
  points_.push_back({numbers_[0], numbers_[1]});
}

std::vector<Point> Coordinates::points_between(std::size_t first, std::size_t last) const {
  return {points_.begin() + static_cast<std::ptrdiff_t>(first), points_.begin() + static_cast<std::ptrdiff_t>(last)};
}

Shape Coordinates::polygon(const std::vector<std::size_t>& ring_ends, std::size_t first, std::size_t last,
                           std::size_t offset) const {
  Rings rings;
  for (std::size_t i = first; i < last; ++i) {
    std::vector<Point> ring = points_between(i == 0 ? 0 : ring_ends[i - 1], ring_ends[i]);
    open_ring(ring, "ring " + std::to_string(i + 1) + " of these coordinates", offset);
    rings.push_back(ring);
  }
  return Shape::polygon(std::move(rings));
}

void Coordinates::append_shapes(std::string_view type, std::size_t offset, std::vector<Shape>& shapes) {
  if (points_.empty()) return;
  if (position_depth_ != depth_of(type)) {
    refuse(offset, "the coordinates of a " + std::string(type) + ": " + arrays_text(depth_of(type)),
           arrays_text(position_depth_));
  }
  if (type == "Point" || type == "MultiPoint") {
    for (const Point& point : points_) shapes.push_back(Shape::point(point));
  } else if (type == "LineString") {
    check_line(points_, "a LineString", offset);
    shapes.push_back(line_of_points(std::move(points_)));
  } else if (type == "MultiLineString") {
    std::size_t first = 0;
    for (const std::size_t last : ends_[0]) {
      std::vector<Point> line = points_between(first, last);
      check_line(line, "each line of a MultiLineString", offset);
      shapes.push_back(line_of_points(std::move(line)));
      first = last;
    }
  } else if (type == "Polygon") {
    shapes.push_back(polygon(ends_[0], 0, ends_[0].size(), offset));
  } else {
    std::size_t first = 0;
    for (const std::size_t last : ends_[0]) {
      shapes.push_back(polygon(ends_[1], first, last, offset));
      first = last;
    }
  }
}

}  // namespace waywright::formats
