#pragma once

#include "constraint/constrained_triangulation.hpp"

namespace waywright::path {

// The funnel algorithm: it computes the new taut strings to the two ends of a portal when one of the ends moves. The
// functions decide with exact predicates. They are templates over the class that stores the strings: `TautTree` stores
// the strings of all channels of a search, `TautString` stores the strings of one channel.
//
// Two taut strings run from the start of a channel to the left and the right end of a portal. They are identical up to
// the apex. From there on, the left string turns only to the left, and the right string only to the right. The *nodes*
// of a string are its start, the vertices at which it turns, and its end. A template argument `kString` says which
// string is meant: `positive` the left one, `negative` the right one. A position lies *outwards* of a piece of the left
// string if it lies left of the piece, and outwards of a piece of the right string if it lies right of the piece.
//
// A class `Strings` has a type `Node` and these members:
// - `apex()` and `end<kString>()` return a node;
// - `before<kString>(node)` returns the next node towards the apex;
// - `from_apex<kString>()` returns an object with the nodes from the apex (without it) to the end: `is_empty()`,
//   `first()`, and `take_first()`, which removes the first one and returns it;
// - `orientation(p, q, v)` returns the orientation of the nodes p and q and the position v.
//
// Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*, 1984.

/// The result of find_turn().
template <class Strings>
struct LastTurn {
  typename Strings::Node node;  ///< the node at which the new string leaves the old strings
  typename Strings::Node apex;  ///< the apex of the new funnel
};

/// Follows a string from the apex, as long as `v` lies outwards of the next piece. Returns the node where it stops.
template <exact::Sign kString, class Strings>
[[nodiscard]] inline typename Strings::Node follow_from_apex(Strings strings, const exact::Geometry::View& v) {
  typename Strings::Node node = strings.apex();
  auto rest = strings.template from_apex<kString>();
  while (!rest.is_empty() && strings.orientation(node, rest.first(), v) == kString) node = rest.take_first();
  return node;
}

/// The end of the string `kString` moves to `v`. Returns where the new string to `v` turns last.
///
/// In the picture, `own` is a node of the string whose end moves. The new string leaves its own string at a node:
/// the first node, seen from the end, for which v lies outwards of the piece before it. If there is no such node,
/// the new string follows the other string from the apex on, as long as v lies beyond the next piece.
///
///          own end . . . . . v
///         /              .'
///       own         . '
///      /       . '
///   apex --- other --- other end
template <exact::Sign kString, class Strings>
[[nodiscard]] inline LastTurn<Strings> find_turn(Strings strings, const exact::Geometry::View& v) {
  for (typename Strings::Node node = strings.template end<kString>(); node != strings.apex();) {
    const typename Strings::Node before = strings.template before<kString>(node);
    if (strings.orientation(before, node, v) == kString) return {node, strings.apex()};
    node = before;
  }
  const typename Strings::Node node = follow_from_apex<-kString>(strings, v);
  return {node, node};
}

/// Returns the last node at which the taut string through the funnel to `goal` turns, or the apex if it does not turn
/// after the apex. Requires: `goal` lies in the face beyond the portal.
template <class Strings>
[[nodiscard]] inline typename Strings::Node find_last_turn(Strings strings, const exact::Geometry::View& goal) {
  const typename Strings::Node node = follow_from_apex<exact::Sign::positive>(strings, goal);
  return node != strings.apex() ? node : follow_from_apex<exact::Sign::negative>(strings, goal);
}

/// Returns whether the first piece of a string from `start` to `v` has length zero. A piece of length zero has no
/// direction, so the algorithm could not decide whether the next piece turns left or right. So a funnel whose portal
/// has an end at the start uses the start itself as this end.
[[nodiscard]] inline bool is_at_start(const exact::Geometry& geometry, const exact::Geometry::View& start,
                                      mesh::Vertex v) {
  return geometry.order(start, geometry.view(number(v))) == 0;
}

}  // namespace waywright::path
