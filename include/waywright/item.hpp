#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "waywright/export.hpp"
#include "waywright/id.hpp"
#include "waywright/point.hpp"
#include "waywright/rings.hpp"

namespace waywright {

/// @addtogroup items
/// @{

/// The kind of an item.
enum class ItemKind : std::uint8_t {
  point,     ///< a vertex; it is not a wall
  segment,   ///< a straight line that no agent can cross; a segment of length zero acts as a point
  polyline,  ///< an open chain of straight lines that no agent can cross
  polygon,   ///< a solid obstacle of one or more closed rings; its FillRule says what lies inside
};

/// Returns the name of a kind in world scripts: `point`, `segment`, `polyline`, `polygon`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ItemKind kind);

/// The rule that says which positions lie inside a polygon. It uses the winding number of the position: how often the
/// rings go around it counter-clockwise, minus how often they go around it clockwise. The property `fill-rule` of SVG
/// has the same two values.
enum class FillRule : std::uint8_t {
  even_odd,  ///< inside if the winding number is odd: a ring in a ring bounds a hole, whatever its direction
  nonzero,   ///< inside if the winding number is not 0: a ring in a ring bounds a hole only if their directions differ
};

/// Returns whether a polygon with this rule covers the positions that have this winding number.
[[nodiscard]] constexpr bool is_filled(FillRule rule, std::int32_t winding_number) {
  return rule == FillRule::even_odd ? winding_number % 2 != 0 : winding_number != 0;
}

/// Returns the name of a fill rule: `even-odd`, `nonzero`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(FillRule rule);

/// The form of an item, independent of any world. A point has one ring of one point, a segment one ring of two
/// points, a polyline one ring of one or more points. A polygon has one or more rings. In a polygon, the side from the
/// last point of a ring to its first point belongs to the ring, so you need not repeat the first point.
///
/// @code{.cpp}
/// const Shape house = Shape::rectangle({{2, 2}, {6, 5}});
/// const Shape tower = Shape::regular_polygon({8, 8}, 1.5, 12);
/// const Shape court = Shape::polygon({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}});  // a hole
/// world.insert(translated(house, 10, 10)).value();
/// @endcode
struct Shape {
  ItemKind kind = ItemKind::point;
  Rings rings;
  FillRule fill = FillRule::even_odd;  ///< for a polygon; a world ignores it for other kinds

  friend bool operator==(const Shape&, const Shape&) = default;

  /// Returns a point.
  [[nodiscard]] static Shape point(const Point& point) { return {ItemKind::point, {{point}}}; }
  /// Returns the segment from `a` to `b`.
  [[nodiscard]] static Shape segment(const Point& a, const Point& b) { return {ItemKind::segment, {{a, b}}}; }
  /// Returns the polyline through `points`.
  [[nodiscard]] static Shape polyline(PointSpan points) { return {ItemKind::polyline, points}; }
  /// Returns a polygon of one or more rings: `Shape::polygon({{0, 0}, {4, 0}, {4, 4}})`, `Shape::polygon({outside,
  /// hole})`.
  [[nodiscard]] static Shape polygon(Rings rings, FillRule fill = FillRule::even_odd) {
    return {ItemKind::polygon, std::move(rings), fill};
  }
  /// Returns the polygon of a box, counter-clockwise from the lower left corner.
  [[nodiscard]] static Shape rectangle(const Box& box) {
    return {ItemKind::polygon, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
  }
  /// Returns the polygon of `corner_count` corners on a circle, counter-clockwise. The first corner lies to the right
  /// of the centre. The function rounds each corner to doubles. The result is the same on every machine. The radius is
  /// in the unit of the coordinates.
  /// A polygon has 3 corners or more: for a smaller `corner_count`, the shape has no rings, and a world refuses it
  /// (bad_shape).
  /// Cost: linear in the corners.
  [[nodiscard]] WAYWRIGHT_API static Shape regular_polygon(const Point& centre, double radius,
                                                           std::size_t corner_count);
};

/// @name Functions of shapes
///
/// @code{.cpp}
/// const Shape house = Shape::rectangle({{2, 2}, {6, 4}});
/// const Point centre = centroid(translated(house, 10, 0));  // == Point{14, 3}
/// @endcode
/// @{

/// Returns a copy of the shape, moved by (`dx`, `dy`). The coordinates are sums of doubles, rounded to nearest.
/// Cost: linear in the points of the shape.
[[nodiscard]] WAYWRIGHT_API Shape translated(const Shape& shape, double dx, double dy);

/// Returns the centroid of a shape, computed in plain doubles. For a polygon, this is the centroid of the area inside
/// it by its fill rule. For a polygon without area and for the other kinds, it is the mean of the points. If rings
/// cross each other or themselves, the result is an approximation.
/// Requires: the shape has a point.
/// Cost: linear in the points of the shape; for a polygon, the number of rings times the number of points.
/// Source: Bourke, *Calculating the area and centroid of a polygon*, 1988.
[[nodiscard]] WAYWRIGHT_API Point centroid(const Shape& shape);

/// @}

/// An item whose sides a segment meets: an element of the answer of World::items_crossed.
///
/// @code{.cpp}
/// for (const CrossedItem& crossed : world.items_crossed(start, goal).value()) {
///   std::printf("item %ju at (%g, %g)\n", std::uintmax_t{crossed.id.value}, crossed.at.x, crossed.at.y);
/// }
/// @endcode
struct CrossedItem {
  ItemId id;
  Point at;  ///< where the segment meets a side of the item, each coordinate rounded to the nearest double

  friend bool operator==(const CrossedItem&, const CrossedItem&) = default;
};

/// A shape and its id.
///
/// @code{.cpp}
/// const std::vector<Item> items = {{11, Shape::segment({5, 5}, {9, 5})}, {12, Shape::rectangle({{2, 2}, {4, 4}})}};
/// world.insert_all(items).value();
/// for (const ItemId id : world.item_ids()) {
///   const Shape shape = world.shape(id).value();
///   std::printf("item %ju is a %s\n", std::uintmax_t{id.value}, to_string(shape.kind).data());
/// }
/// const ItemId wall = world.insert_segment({10, 2}, {10, 9}).value();  // == 13
/// world.replace(wall, Shape::segment({11, 2}, {11, 9})).value();
/// world.remove(12).value();
/// const bool has_item = world.contains(12);  // == false
/// @endcode
struct Item {
  ItemId id;
  Shape shape;

  friend bool operator==(const Item&, const Item&) = default;
};

/// @}

}  // namespace waywright
