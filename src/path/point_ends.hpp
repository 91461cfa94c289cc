#pragma once

#include <optional>
#include <vector>

#include "waywright/path.hpp"

#include "constraint/cover_finder.hpp"
#include "nav/abstraction.hpp"
#include "path/free_positions.hpp"

namespace waywright::path {

/// Returns the default of PathQuery::end_tolerance, the largest distance by which the search may move an end: the
/// largest magnitude of a coordinate of the domain, times 2^-20 (about a millionth).
[[nodiscard]] double default_end_tolerance(const Box& domain);

/// The start and the goal of a path, and the faces around each of them that no polygon covers. If there is no such face
/// around an end, the class moves the end to the nearest free position, if this position is near enough. Use one object
/// for many queries, because it keeps its memory.
class PointEnds {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Locates the start. `tolerance` is the largest distance by which an end may be moved; the default is
  /// default_end_tolerance(). Uses `abstraction` if it is not null. Requires: the triangulation and the abstraction do
  /// not change during the query; the start lies in the domain; `tolerance` is not negative.
  void set_start(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Point& start,
                 const std::optional<double>& tolerance);
  /// Moves the start if it is blocked. Call it before the first goal in a query with many goals, so that all paths
  /// begin at the same point.
  void move_blocked_start();
  /// Tests the straight line to the goal and, if it is not clear, locates the goal. Returns the status of the path if
  /// no search is necessary, for example because the straight line is clear, because an end is blocked, or because the
  /// abstraction says that the ends are not connected. Otherwise returns nothing. Requires: the goal lies in the
  /// domain.
  std::optional<PathStatus> find_status_without_search(const Point& goal);

  /// Writes to `path` which ends were moved and, if `status` says that an end is blocked, which polygons block it.
  /// Requires: `path.blockers` is empty.
  void write_ends(PathStatus status, Path& path) {
    if (status != PathStatus::found || has_moved()) write_moved_and_blocked(status, path);
  }

  /// The start and the goal of the path: the ends in the query or, if the class has moved them, their new positions.
  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& goal() const { return goal_; }
  [[nodiscard]] const locate::Located& start_location() const { return start_location_; }
  /// The open faces around the start, and those around the goal. A half-edge stands for each face.
  /// constraint::CoverFinder::open_faces() describes which half-edge, and the order of the faces. Requires:
  /// find_status_without_search() returned nothing.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& start_faces() const { return start_faces_; }
  [[nodiscard]] const std::vector<mesh::HalfEdge>& goal_faces() const { return goal_faces_; }
  /// Returns whether a polygon now covers one of the faces around an end. Requires: find_status_without_search()
  /// returned nothing, and no change has touched these faces since.
  [[nodiscard]] bool are_covered();
  [[nodiscard]] bool is_goal(mesh::Face f) const {
    for (const mesh::HalfEdge h : goal_faces_) {
      if (mesh::face(h) == f) return true;
    }
    return false;
  }
  /// The edges that the straight line crosses, as half-edges of the faces that it leaves. Requires: the straight line
  /// is clear.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& crossed() const { return crossed_; }
  /// The edges that the straight line crosses before the wall or the vertex that stops it. Requires: the straight line
  /// is not clear.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& crossed_before_stop() const { return crossed_before_stop_; }
  [[nodiscard]] bool has_moved() const { return moved_start_ || moved_goal_; }

 private:
  class StraightLine;

  [[nodiscard]] bool sees_goal();
  [[nodiscard]] double tolerance() const {
    return tolerance_ ? *tolerance_ : default_end_tolerance(triangulation_->domain());
  }
  void write_moved_and_blocked(PathStatus status, Path& path);
  void find_start_faces();
  void find_goal_faces();
  [[nodiscard]] std::optional<PathStatus> known_status();
  [[nodiscard]] bool move_blocked_ends();
  [[nodiscard]] std::optional<Point> find_free_position(const Point& end, const locate::Located& location,
                                                        const std::vector<mesh::HalfEdge>& other_faces);
  [[nodiscard]] std::optional<Point> find_connected_position(const Point& end, const locate::Located& location,
                                                             const std::vector<mesh::HalfEdge>& other_faces,
                                                             double limit);
  [[nodiscard]] bool move_end_across_wall();
  void move_start(const std::vector<mesh::HalfEdge>& goal_faces);
  void move_start_to(const Point& point);
  void move_goal_to(const Point& point);
  [[nodiscard]] bool are_connected(const nav::Components& components) const;

  const Triangulation* triangulation_ = nullptr;
  const nav::Abstraction* abstraction_ = nullptr;  ///< or null
  Point start_;
  Point goal_;
  std::optional<double> tolerance_;
  locate::Located start_location_;
  locate::Located goal_location_;
  bool is_start_known_ = false;  ///< whether `start_faces_` is up to date
  bool may_start_move_ = true;
  std::optional<MovedEnd> moved_start_;
  std::optional<MovedEnd> moved_goal_;
  std::vector<mesh::HalfEdge> start_faces_;
  std::vector<mesh::HalfEdge> goal_faces_;
  std::vector<mesh::HalfEdge> crossed_;
  std::vector<mesh::HalfEdge> crossed_before_stop_;
  nav::ComponentCoverFinder cover_finder_;
  FreePositions free_positions_;
};

}  // namespace waywright::path
