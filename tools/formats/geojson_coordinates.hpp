#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::formats {

/// The value of the member `coordinates` of a GeoJSON geometry: arrays in arrays, whose meaning depends on the type of
/// the geometry. The type may follow after the coordinates, so this class keeps the arrays of every type.
class Coordinates {
 public:
  /// Each function throws a Refusal at `offset` if no geometry can have these coordinates.
  void open_array(std::size_t offset);
  void close_array(std::size_t offset);
  void add_number(double number, std::size_t offset);

  /// Whether the outermost array is closed.
  [[nodiscard]] bool is_complete() const { return depth_ == 0; }
  /// Appends the shapes of a geometry of this type. Throws a Refusal at `offset` if the coordinates do not fit the
  /// type. Requires: is_complete(); `type` is one of the six types with coordinates.
  void append_shapes(std::string_view type, std::size_t offset, std::vector<Shape>& shapes);

 private:
  static constexpr std::size_t kDeepest = 4;  // the depth of the positions of a MultiPolygon

  enum class Content : unsigned char { none, numbers, arrays };

  void close_position(std::size_t offset);
  [[nodiscard]] std::vector<Point> points_between(std::size_t first, std::size_t last) const;
  /// Returns the polygon of the rings from index `first` to `last` in `ring_ends`.
  [[nodiscard]] Shape polygon(const std::vector<std::size_t>& ring_ends, std::size_t first, std::size_t last,
                              std::size_t offset) const;

  std::size_t depth_ = 0;                     // the number of open arrays
  std::array<Content, kDeepest> contents_{};  // of the open arrays
  std::array<double, 2> numbers_{};           // of the open position
  std::size_t number_count_ = 0;
  std::size_t position_depth_ = 0;  // 0 until there is a position
  std::vector<Point> points_;
  /// For each closed array of depth 2 (element 0) and 3 (element 1): the number of positions or arrays of the next
  /// depth up to its end.
  std::array<std::vector<std::size_t>, 2> ends_;
};

}  // namespace waywright::formats
