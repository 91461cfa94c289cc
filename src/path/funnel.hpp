#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/exact_triangulation.hpp"
#include "path/distance.hpp"

namespace waywright::path {

/// The funnel of a channel at a portal. Two taut strings run from the start to the left and the right end of the
/// portal. They are identical up to `apex`. From there on, the left string turns only to the left, and the right string
/// only to the right. The three numbers are nodes of a TautTree.
struct Funnel {
  std::uint32_t apex = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};

/// The taut strings of all channels of one search, as a tree: the string to each node runs through its parent. If two
/// channels begin with the same faces, their strings share the nodes there.
///
/// Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*, 1984 (the funnel).
class TautTree {
 public:
  using Geometry = exact::Geometry;

  /// Starts a new tree whose root is the point `start`. The funnel at the root consists of the root alone.
  void reset(const Geometry& geometry, const Point& start);

  /// Returns the node of a vertex that is visible from the start. If the vertex lies at the start, this is the root.
  [[nodiscard]] std::uint32_t add_seen(mesh::Vertex v);
  /// Returns the funnel after the left (or right) end of the portal has moved to `v`.
  [[nodiscard]] Funnel move_left(const Funnel& funnel, mesh::Vertex v);
  [[nodiscard]] Funnel move_right(const Funnel& funnel, mesh::Vertex v);
  /// Returns the last node at which the taut string through the funnel to `goal` turns. Requires: `goal` lies in the
  /// face beyond the portal.
  [[nodiscard]] std::uint32_t last_corner(const Funnel& funnel, const Point& goal);

  [[nodiscard]] Point point(std::uint32_t node) const { return {nodes_[node].position.x, nodes_[node].position.y}; }
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_->rounded(number(v)); }
  /// The length of the string from the start to the node.
  [[nodiscard]] double length(std::uint32_t node) const { return nodes_[node].length; }
  [[nodiscard]] std::uint32_t parent(std::uint32_t node) const { return nodes_[node].parent; }
  static constexpr std::uint32_t kRoot = 0;

 private:
  struct Node {
    Geometry::View position;
    std::uint32_t parent;
    double length;
  };

  /// Returns whether `v` lies left of (positive), right of (negative) or on (zero) the line from `p` to `q`.
  [[nodiscard]] exact::Sign side(std::uint32_t p, std::uint32_t q, const Geometry::View& v) const;
  void collect(std::uint32_t end, std::uint32_t apex, std::vector<std::uint32_t>& chain) const;
  [[nodiscard]] std::uint32_t add(mesh::Vertex v, std::uint32_t parent);
  [[nodiscard]] std::uint32_t bend(const Funnel& funnel, std::uint32_t own_end, std::uint32_t other_end,
                                   exact::Sign outwards, const Geometry::View& v);
  [[nodiscard]] std::uint32_t apex_after(const Funnel& funnel, std::uint32_t corner, std::uint32_t own_end) const;

  const Geometry* geometry_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> chain_;
};

}  // namespace waywright::path
