#pragma once

#include <optional>
#include <vector>

#include "waywright/path.hpp"

#include "constraint/cover.hpp"
#include "nav/abstraction.hpp"
#include "nav/kept_cover.hpp"
#include "path/free_places.hpp"

namespace waywright::path {

/// How far a blocked end may be moved if a query does not say: 2^-20, about a millionth, of the domain's largest
/// coordinate.
[[nodiscard]] double default_end_tolerance(const Box& domain);

/// Where a path starts and where it is to end: the faces around each end that no polygon covers. An end that polygons
/// cover is moved to the nearest free place, if that is near enough. Keep the object: its memory serves many queries.
class Ends {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Finds the start, with the help of an abstraction if there is one; both must stay as they are. `tolerance` says how
  /// far blocked ends may be moved; the default is default_end_tolerance(). Requires: the start lies in the domain,
  /// `tolerance` is not negative.
  void set_start(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Point& start,
                 const std::optional<double>& tolerance);
  /// Moves the start right away if it is blocked, whatever the goal is. For searches with many goals.
  void free_start();
  /// Finds the goal. Returns how the search ends where there is nothing to search: the straight way is free, or an end
  /// is blocked or walled in. Requires: the goal lies in the domain.
  std::optional<PathStatus> set_goal(const Point& goal);

  /// Writes which ends were moved and, if `status` says that an end is blocked, by which polygons. Requires: `path`
  /// names none yet.
  void write_ends(PathStatus status, Path& path) {
    if (status != PathStatus::found || has_moved()) write_moved_and_blocked(status, path);
  }

  /// The places that the path leads from and to: where the ends were moved to, if they were.
  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& goal() const { return goal_; }
  [[nodiscard]] const locate::Located& start_place() const { return start_place_; }
  /// The open faces around the end, as constraint::Cover::open_faces names and orders them. Requires: there is
  /// something to search.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& start_faces() const { return start_faces_; }
  [[nodiscard]] const std::vector<mesh::HalfEdge>& goal_faces() const { return goal_faces_; }
  /// Whether a polygon has come to cover the faces around an end. Requires: there is something to search, and none of
  /// these faces has been touched since.
  [[nodiscard]] bool are_covered();
  [[nodiscard]] bool is_goal(mesh::Face f) const {
    for (const mesh::HalfEdge h : goal_faces_) {
      if (mesh::face(h) == f) return true;
    }
    return false;
  }
  /// The edges that the straight way crosses, in the faces before them. Requires: it is free.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& crossed() const { return crossed_; }
  /// The edges that the straight way crosses before it meets a wall or a vertex. Requires: it is not free.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& tried() const { return tried_; }
  [[nodiscard]] bool has_moved() const { return moved_start_ || moved_goal_; }

 private:
  class StraightWay;

  [[nodiscard]] bool sees_goal();
  [[nodiscard]] double tolerance() const {
    return tolerance_ ? *tolerance_ : default_end_tolerance(triangulation_->domain());
  }
  void write_moved_and_blocked(PathStatus status, Path& path);
  void find_start_faces();
  void find_goal_faces();
  [[nodiscard]] std::optional<PathStatus> known_status();
  [[nodiscard]] bool move_blocked_ends();
  [[nodiscard]] std::optional<Point> find_free_place(const Point& end, const locate::Located& place,
                                                     const std::vector<mesh::HalfEdge>& other_faces);
  [[nodiscard]] std::optional<Point> find_joined_place(const Point& end, const locate::Located& place,
                                                       const std::vector<mesh::HalfEdge>& other_faces, double limit);
  [[nodiscard]] bool move_end_across_wall();
  void move_start(const std::vector<mesh::HalfEdge>& goal_faces);
  void move_start_to(const Point& place);
  void move_goal_to(const Point& place);
  [[nodiscard]] bool are_joined(const nav::Components& components) const;

  const Triangulation* triangulation_ = nullptr;
  const nav::Abstraction* abstraction_ = nullptr;  ///< or null
  Point start_;
  Point goal_;
  std::optional<double> tolerance_;
  locate::Located start_place_;
  locate::Located goal_place_;
  bool is_start_known_ = false;  ///< whether `start_faces_` is
  bool may_start_move_ = true;
  std::optional<MovedEnd> moved_start_;
  std::optional<MovedEnd> moved_goal_;
  std::vector<mesh::HalfEdge> start_faces_;
  std::vector<mesh::HalfEdge> goal_faces_;
  std::vector<mesh::HalfEdge> crossed_;
  std::vector<mesh::HalfEdge> tried_;
  nav::KeptCover cover_;
  FreePlaces free_places_;
};

}  // namespace waywright::path
