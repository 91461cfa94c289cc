#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "path/distance.hpp"

namespace waywright::path {

/// The funnel of a channel at a portal, as three nodes of a TautTree. `funnel.hpp` says what a funnel is.
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
