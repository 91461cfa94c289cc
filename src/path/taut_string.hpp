#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "path/distance.hpp"

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

/// The taut string through one channel. Use one object for many channels, because it keeps its memory.
///
/// The class keeps the funnel of the channel at the current portal. The apex is the last turn that
/// is certain. The array `row_` contains both strings of the funnel from the apex on: first the left one from its end
/// to the apex, then the right one from the apex to its end. Cost: O(1) per portal, amortised.
class TautString {
 public:
  using Geometry = exact::Geometry;

  /// Starts a new string from the point `start`, which sees the first portal of a channel of `portal_count` portals.
  void begin(const Geometry& geometry, const Point& start, mesh::Vertex left, mesh::Vertex right,
             std::size_t portal_count);
  /// Moves the left (or right) end of the portal to `v`.
  void move_left(mesh::Vertex v);
  void move_right(mesh::Vertex v);
  /// Ends the string at `goal`. Requires: `goal` lies in the face beyond the last portal.
  void end_at(const Point& goal);

  /// The start of the string and the points at which it turns, each coordinate rounded to the nearest double. The goal
  /// is not among them.
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  /// The length of the string. Requires: the string has ended.
  [[nodiscard]] double length() const { return length_; }

 private:
  using View = Geometry::View;

  struct Strings;

  /// Moves the apex along the string to the right (or left) end, to the node at the index `apex`.
  void move_apex_right(std::size_t apex) {
    while (apex_ < apex) turn_at(row_[apex_++]);
  }
  void move_apex_left(std::size_t apex) {
    while (apex_ > apex) turn_at(row_[apex_--]);
  }
  void turn_at(const View& node) { points_.push_back({node.x, node.y}); }

  const Geometry* geometry_ = nullptr;
  std::vector<View> row_;
  std::size_t left_ = 0;  ///< indices in `row_`: of the left end, of the apex, of the right end
  std::size_t apex_ = 0;
  std::size_t right_ = 0;
  std::vector<Point> points_;  ///< the nodes before the apex; after end_at(), all nodes except the goal
  double length_ = 0.0;
};

/// The funnel of a channel at a portal, as three nodes of a TautTree.
struct Funnel {
  std::uint32_t apex = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};

/// The taut strings of all channels of one search, as a tree: the string to each node runs through its parent. If two
/// channels begin with the same faces, their strings share the nodes there.
class TautTree {
 public:
  using Geometry = exact::Geometry;

  /// Starts a new tree whose root is the point `start`. The funnel at the root consists of the root alone.
  void reset(const Geometry& geometry, const Point& start);

  /// Returns the node of a vertex that is visible from the start. If the vertex lies at the start, this is the root.
  [[nodiscard]] std::uint32_t add_visible_from_start(mesh::Vertex v);
  /// Returns the funnel after the left (or right) end of the portal has moved to `v`.
  [[nodiscard]] Funnel move_left(const Funnel& funnel, mesh::Vertex v);
  [[nodiscard]] Funnel move_right(const Funnel& funnel, mesh::Vertex v);
  /// Returns the last node at which the taut string through the funnel to `goal` turns, or the apex if it does not turn
  /// after the apex. Requires: `goal` lies in the face beyond the portal.
  [[nodiscard]] std::uint32_t last_turn(const Funnel& funnel, const Point& goal);

  [[nodiscard]] Point point(std::uint32_t node) const { return {nodes_[node].position.x, nodes_[node].position.y}; }
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_->rounded(number(v)); }
  /// The length of the string from the start to the node.
  [[nodiscard]] double length(std::uint32_t node) const { return nodes_[node].length; }
  [[nodiscard]] std::uint32_t parent(std::uint32_t node) const { return nodes_[node].parent; }
  static constexpr std::uint32_t kStart = 0;

 private:
  struct Node {
    Geometry::View position;
    std::uint32_t parent;
    double length;
  };
  struct Strings;

  [[nodiscard]] std::uint32_t add(mesh::Vertex v, std::uint32_t parent);

  const Geometry* geometry_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> chain_;  ///< scratch of Strings: nodes of a string, from its end towards the apex
};

}  // namespace waywright::path
