#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "waywright/export.hpp"
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
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ItemKind kind);

/// The geometry of an item, free of any world: one ring of one point for a point, of two for a segment, of N for a
/// polyline; a polygon has one ring or more, their closing sides implied.
struct Shape {
  ItemKind kind = ItemKind::point;
  std::vector<std::vector<Point>> rings;

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// A copy of the shape, moved. Coordinates are sums of doubles, rounded to nearest.
[[nodiscard]] WAYWRIGHT_API Shape translated(const Shape& shape, double dx, double dy);

/// The middle of a shape, in plain doubles: of a polygon the centre of its area, rings within an odd number of others
/// counted as holes; of one without area, and of anything else, the mean of its points. Of rings that cross, or of a
/// ring that crosses itself, it is an approximation. Requires: there is a point. Source: Bourke, *Calculating the area
/// and centroid of a polygon*, 1988.
[[nodiscard]] WAYWRIGHT_API Point centroid(const Shape& shape);

/// A shape under its id.
struct Item {
  ItemId id;
  Shape shape;

  friend bool operator==(const Item&, const Item&) = default;
};

}  // namespace waywright
