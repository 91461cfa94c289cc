#pragma once

#include <optional>
#include <vector>

#include "waywright/path.hpp"

#include "constraint/cover.hpp"
#include "path/abstraction.hpp"
#include "path/kept_cover.hpp"

namespace waywright::path {

/// Where a path starts and where it is to end: the faces around each end that no polygon covers. An object to keep for
/// its memory.
class Ends {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Finds the start, with the help of an abstraction if there is one; both must stay as they are. Requires: it lies in
  /// the domain.
  void set_start(const Triangulation& triangulation, const Abstraction* abstraction, const Point& start);
  /// Finds the goal. Returns how the search ends where there is nothing to search: the straight way is free, or an end
  /// is blocked or walled in. Requires: it lies in the domain.
  std::optional<PathStatus> set_goal(const Point& goal);

  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& goal() const { return goal_; }
  [[nodiscard]] const locate::Located& start_place() const { return start_place_; }
  /// The open faces around the end, as constraint::Cover::open_faces names and orders them. Requires: there is
  /// something to search.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& start_faces() const { return start_faces_; }
  [[nodiscard]] const std::vector<mesh::HalfEdge>& goal_faces() const { return goal_faces_; }
  [[nodiscard]] bool is_goal(mesh::Face f) const {
    for (const mesh::HalfEdge h : goal_faces_) {
      if (mesh::face(h) == f) return true;
    }
    return false;
  }
  /// The edges that the straight way crosses, in the faces before them. Requires: it is free.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& crossed() const { return crossed_; }

 private:
  class StraightWay;

  [[nodiscard]] bool sees_goal();
  void find_start_faces();
  [[nodiscard]] bool are_joined(const Components& components) const;

  const Triangulation* triangulation_ = nullptr;
  const Abstraction* abstraction_ = nullptr;  ///< or null
  Point start_;
  Point goal_;
  locate::Located start_place_;
  bool is_start_known_ = false;    ///< whether the next two are
  bool is_start_blocked_ = false;  ///< it lies strictly inside a polygon
  std::vector<mesh::HalfEdge> start_faces_;
  std::vector<mesh::HalfEdge> goal_faces_;
  std::vector<mesh::HalfEdge> crossed_;
  KeptCover cover_;
};

}  // namespace waywright::path
