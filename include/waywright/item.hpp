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

/// What a world is made of.
enum class ItemKind : std::uint8_t {
  point,     ///< a vertex, no wall
  segment,   ///< a wall; of length zero it acts as a point
  polyline,  ///< an open chain of walls
  polygon,   ///< a solid obstacle of one closed ring or more; its FillRule says what lies inside
};

/// The kind as the world script names it: `point`, `segment`, `polyline`, `polygon`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(ItemKind kind);

/// Which places lie inside a polygon. It counts how often all rings together turn around a place, each turn
/// counter-clockwise as 1 and each turn clockwise as -1. This sum is the winding number. SVG's `fill-rule` has the same
/// two rules.
enum class FillRule : std::uint8_t {
  even_odd,  ///< where the winding number is odd: a ring in a ring is a hole, whichever way it turns
  nonzero,   ///< where the winding number is not 0: a ring in a ring is a hole only if it turns the other way
};

/// The fill rule's name: `even-odd`, `nonzero`.
[[nodiscard]] WAYWRIGHT_API std::string_view to_string(FillRule rule);

/// The geometry of an item, free of any world: one ring of one point for a point, of two for a segment, of N for a
/// polyline; a polygon has one ring or more, their closing sides implied.
struct Shape {
  ItemKind kind = ItemKind::point;
  Rings rings;
  FillRule fill = FillRule::even_odd;  ///< of a polygon; a world ignores it for other kinds

  friend bool operator==(const Shape&, const Shape&) = default;

  [[nodiscard]] static Shape point(const Point& point) { return {ItemKind::point, {{point}}}; }
  [[nodiscard]] static Shape segment(const Point& a, const Point& b) { return {ItemKind::segment, {{a, b}}}; }
  [[nodiscard]] static Shape polyline(PointSpan points) { return {ItemKind::polyline, points}; }
  /// Of one ring or several: `Shape::polygon({{0, 0}, {4, 0}, {4, 4}})`, `Shape::polygon({outside, hole})`.
  [[nodiscard]] static Shape polygon(Rings rings, FillRule fill = FillRule::even_odd) {
    return {ItemKind::polygon, std::move(rings), fill};
  }
  /// The polygon of a box, counter-clockwise from its lower left corner.
  [[nodiscard]] static Shape rectangle(const Box& box) {
    return {ItemKind::polygon, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
  }
  /// The polygon of `corner_count` corners on a circle, counter-clockwise from the one to the right of the centre, each
  /// rounded to doubles and the same on every machine. Requires: `corner_count` is 3 or more.
  [[nodiscard]] WAYWRIGHT_API static Shape regular_polygon(const Point& centre, double radius,
                                                           std::size_t corner_count);
};

/// A copy of the shape, moved. Coordinates are sums of doubles, rounded to nearest.
[[nodiscard]] WAYWRIGHT_API Shape translated(const Shape& shape, double dx, double dy);

/// The middle of a shape, in plain doubles: of a polygon the centre of its area by its fill rule; of one without
/// area, and of anything else, the mean of its points. Of rings that cross, or of a ring that crosses itself, it is an
/// approximation. Requires: there is a point. Source: Bourke, *Calculating the area and centroid of a polygon*, 1988.
[[nodiscard]] WAYWRIGHT_API Point centroid(const Shape& shape);

/// Where a segment meets an item's side: an answer of World::items_crossed.
struct CrossedItem {
  ItemId id;
  Point at;  ///< nearest doubles

  friend bool operator==(const CrossedItem&, const CrossedItem&) = default;
};

/// A shape under its id.
struct Item {
  ItemId id;
  Shape shape;

  friend bool operator==(const Item&, const Item&) = default;
};

}  // namespace waywright
