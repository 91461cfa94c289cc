#pragma once

#include "waywright/path.hpp"

#include "path/scratch.hpp"

namespace waywright::path {

/// Triangulation A* for a point: A* over faces entered by an edge, each entry once, then the taut string through the
/// channel. A node's bound is the string's length to the funnel's apex and on, by way of the portal, to the goal: a
/// lower bound for its channel; the search goes on until no open bound is below the best length found.
///
/// Channels cross free edges and never vertices, so no path passes a wall or a point where walls meet.
/// Requires: start and goal lie in the domain.
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Departure: their bound g is a
/// maximum of estimates from the portals' ends; ours keeps each channel's funnel as it grows, which is tighter and as
/// cheap.
class TaStar {
 public:
  TaStar(const constraint::ExactTriangulation& triangulation, Scratch& scratch)
      : triangulation_(triangulation), mesh_(triangulation.topology()), scratch_(scratch) {}

  void find(const PathQuery& query, Path& path);

 private:
  [[nodiscard]] bool prepare(const PathQuery& query, Path& path);
  void mark_goal_faces();
  /// Puts the faces around a start face, or beyond a node's face, on the open list.
  void leave_start_face(mesh::HalfEdge h);
  void leave(const SearchNode& node);
  void open(mesh::HalfEdge exit, const Funnel& funnel);
  void arrive(const SearchNode& node);
  void write_path(Path& path) const;
  [[nodiscard]] std::uint32_t pop();
  [[nodiscard]] bool comes_later(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] double bound(const Funnel& funnel) const;

  const constraint::ExactTriangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  Scratch& scratch_;
  Point goal_;
  double best_length_ = 0.0;
  std::uint32_t best_corner_ = 0;
  bool is_found_ = false;
};

}  // namespace waywright::path
