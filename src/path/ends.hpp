#pragma once

#include <cstdint>
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

  /// Finds both ends, with the help of an abstraction if there is one. Returns how the search ends where there is
  /// nothing to search: an end is blocked or walled in, or the straight way is free because both ends lie at one face
  /// or in one place. Requires: both lie in the domain.
  std::optional<PathStatus> find(const Triangulation& triangulation, const Abstraction* abstraction, const Point& start,
                                 const Point& goal);

  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& goal() const { return goal_; }
  [[nodiscard]] const locate::Located& start_place() const { return start_place_; }
  [[nodiscard]] const locate::Located& goal_place() const { return goal_place_; }
  /// The open faces around the end, as constraint::Cover::open_faces names and orders them.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& start_faces() const { return start_faces_; }
  [[nodiscard]] const std::vector<mesh::HalfEdge>& goal_faces() const { return goal_faces_; }
  [[nodiscard]] bool is_goal(mesh::Face f) const {
    for (const mesh::HalfEdge h : goal_faces_) {
      if (mesh::face(h) == f) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool are_joined(const Components& components) const;

  Point start_;
  Point goal_;
  locate::Located start_place_;
  locate::Located goal_place_;
  std::vector<mesh::HalfEdge> start_faces_;
  std::vector<mesh::HalfEdge> goal_faces_;
  KeptCover cover_;
};

}  // namespace waywright::path
