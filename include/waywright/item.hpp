#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// What a world is made of.
enum class ItemKind : std::uint8_t {
  point,     ///< a vertex, no wall
  segment,   ///< a wall; of length zero it acts as a point
  polyline,  ///< an open chain of walls
  polygon,   ///< a solid obstacle, even-odd over all its rings
};

/// The kind as the world script names it: `point`, `segment`, `polyline`, `polygon`.
[[nodiscard]] std::string_view to_string(ItemKind kind);

/// The geometry of an item, free of any world: one ring of one point for a point, of two for a segment, of N for a
/// polyline; a polygon has one ring or more, their closing sides implied.
struct Shape {
  ItemKind kind = ItemKind::point;
  std::vector<std::vector<Point>> rings;

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// A shape under its id.
struct Item {
  ItemId id;
  Shape shape;

  friend bool operator==(const Item&, const Item&) = default;
};

}  // namespace waywright
