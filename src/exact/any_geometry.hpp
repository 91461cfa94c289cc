#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "waywright/point.hpp"

#include "exact/sign.hpp"

namespace waywright::exact {

/// What the triangulations ask of the arithmetic below them: the places of vertices, named by index, and four questions
/// about them; all lie in the box that it is made with. `exact::Geometry` is the library's; its members say what each
/// of these does. Any other that answers the questions alike may take its place; one whose answers are wrong (rounded
/// ones) gets meshes that are.
///
/// `View` is how a place is handed to a question. One of a vertex stays valid until a vertex is added; one of a point
/// does so for as long as it is kept.
template <class G>
concept AnyGeometry = std::constructible_from<G, const Box&> && std::semiregular<typename G::View> &&
    requires(G& changed, const G& asked, std::uint32_t vertex, const Point& point, const typename G::View& view) {
  // Places come and go, and can be taken back to the last begin().
  changed.place(vertex, point);
  changed.place_crossing(vertex, vertex, vertex, vertex, vertex);
  changed.clear(vertex);
  changed.begin();
  changed.roll_back();

  { asked.view(vertex) } -> std::convertible_to<typename G::View>;
  { asked.view(point) } -> std::convertible_to<typename G::View>;
  // The place in doubles, for output and for hints on where to search.
  { asked.nearest(vertex) } -> std::convertible_to<Point>;

  // The other three questions: which side of a line, inside which circle, which comes first.
  { asked.orientation(view, view, view) } -> std::same_as<Sign>;
  { asked.in_circle(view, view, view, view) } -> std::same_as<Sign>;
  { asked.order(view, view) } -> std::same_as<std::strong_ordering>;
};

}  // namespace waywright::exact
