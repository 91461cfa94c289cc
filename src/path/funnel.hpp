#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/exact_triangulation.hpp"
#include "path/distance.hpp"

namespace waywright::path {

/// The funnel of a channel that has come to a portal: the taut strings from the start to the portal's two ends run
/// together to `apex` and then part, each turning only towards its own side. The three are positions in a TautTree.
struct Funnel {
  std::uint32_t apex = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
};

/// The taut strings of all channels of one search, as a tree: every node's string runs through its parent. Channels
/// that share their beginning share their strings.
///
/// Source: Lee and Preparata, *Euclidean shortest paths in the presence of rectilinear barriers*, 1984 (the funnel).
class TautTree {
 public:
  using Geometry = exact::Geometry;

  /// Starts anew from a point. Its funnel is itself.
  void reset(const Geometry& geometry, const Point& start);

  /// The node of a vertex that the start sees: of the root itself where the vertex is at the start.
  [[nodiscard]] std::uint32_t add_seen(mesh::Vertex v);
  /// The funnel after the portal's left, or right, end has moved on to `v`.
  [[nodiscard]] Funnel move_left(const Funnel& funnel, mesh::Vertex v);
  [[nodiscard]] Funnel move_right(const Funnel& funnel, mesh::Vertex v);
  /// The node from which the taut string through the funnel runs straight to `goal`, just beyond the portal.
  [[nodiscard]] std::uint32_t last_corner(const Funnel& funnel, const Point& goal);

  [[nodiscard]] Point point(std::uint32_t node) const { return {nodes_[node].place.x, nodes_[node].place.y}; }
  [[nodiscard]] const Point& place(mesh::Vertex v) const { return geometry_->nearest(number(v)); }
  /// The length of the string from the start.
  [[nodiscard]] double length(std::uint32_t node) const { return nodes_[node].length; }
  [[nodiscard]] std::uint32_t parent(std::uint32_t node) const { return nodes_[node].parent; }
  static constexpr std::uint32_t kRoot = 0;

 private:
  struct Node {
    Geometry::View place;
    std::uint32_t parent;
    double length;
  };

  /// Which side of the string from `p` to `q` `v` lies on.
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
