#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "waywright/point.hpp"

#include "exact/sign.hpp"

namespace waywright::exact {

/// The interface through which the triangulations use a geometry. A geometry stores the positions of vertices by index.
/// It has three predicates (orientation, in-circle and order), and it computes the crossing of two lines. The
/// constructor takes a box that contains all points. `exact::Geometry` is the library's implementation; the comments on
/// its members describe each function. Any class that gives the same answers can replace it. If a class rounds and
/// therefore gives wrong answers, the meshes are wrong.
///
/// A `View` is a position in the form that the predicates take. The view of a vertex stays valid until a vertex is
/// added. The view of a point stays valid as long as the caller keeps it.
template <class G>
concept AnyGeometry = std::constructible_from<G, const Box&> && std::semiregular<typename G::View> &&
    requires(G& changed, const G& asked, std::uint32_t vertex, const Point& point, const typename G::View& view) {
  // These functions set and clear positions. roll_back() takes all changes since the last begin() back.
  changed.set_position(vertex, point);
  changed.set_crossing(vertex, vertex, vertex, vertex, vertex);
  changed.clear(vertex);
  changed.begin();
  changed.roll_back();

  { asked.view(vertex) } -> std::convertible_to<typename G::View>;
  { asked.view(point) } -> std::convertible_to<typename G::View>;
  // The position, rounded to doubles: for output and for hints where to start a search.
  { asked.rounded(vertex) } -> std::convertible_to<Point>;

  // The three predicates: left or right of a line, inside or outside a circle, first or second in (x, y) order.
  { asked.orientation(view, view, view) } -> std::same_as<Sign>;
  { asked.in_circle(view, view, view, view) } -> std::same_as<Sign>;
  { asked.order(view, view) } -> std::same_as<std::strong_ordering>;
};

}  // namespace waywright::exact
