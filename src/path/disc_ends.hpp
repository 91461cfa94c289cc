#pragma once

#include <span>
#include <vector>

#include "locate/walk.hpp"
#include "nav/components.hpp"
#include "path/dead_ends.hpp"
#include "path/disc_map.hpp"

namespace waywright::path {

/// Where the two ends of a disc's path lie on the mesh, and which dead ends a path between them does not enter.
class DiscEnds {
 public:
  /// Locates the ends. Requires: the disc fits at both. Cost: two point locations, and the cost of
  /// DeadEnds::begin().
  void begin(const DiscMap& map, const Point& start, const Point& goal);

  /// The ends, relative to the origin of the map.
  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& goal() const { return goal_; }
  /// Where the start lies on the mesh. The half-edge is the first one of constraint::faces_at(): it does not depend on
  /// the history of the mesh.
  [[nodiscard]] const locate::Located& at_start() const { return at_start_; }
  /// A half-edge of a face that contains the goal, chosen like the half-edge of at_start(). If the goal lies on an
  /// edge, the half-edge is this edge.
  [[nodiscard]] mesh::HalfEdge goal_face() const { return goal_face_; }
  [[nodiscard]] bool is_goal_on_edge() const { return goal_faces_[0] != goal_faces_[1]; }
  /// Returns whether the face contains the goal, or has it on its border.
  [[nodiscard]] bool is_goal_face(mesh::Face f) const { return f == goal_faces_[0] || f == goal_faces_[1]; }
  /// Returns whether a face at the start is a face at the goal.
  [[nodiscard]] bool have_common_face() const { return have_common_face_; }
  /// Returns whether the faces at both ends belong to the same component. If not, no path leads from one to the other.
  /// Requires: `components` are the components of the map's triangulation.
  [[nodiscard]] bool are_connected(const nav::Components& components) const {
    return components.component_of(mesh::face(at_start_.h)) == components.component_of(goal_faces_[0]);
  }
  [[nodiscard]] const DeadEnds& dead_ends() const { return dead_ends_; }
  /// Calls visit(face) as DeadEnds::for_each_above_goal() does.
  template <class Visit>
  void for_each_above_goal(Visit&& visit) const {
    dead_ends_.for_each_above_goal(goal_faces_, visit);
  }

 private:
  [[nodiscard]] locate::Located locate(const DiscMap& map, const Point& end);

  Point start_;
  Point goal_;
  locate::Located at_start_;
  mesh::HalfEdge goal_face_;
  /// If the goal lies on an edge: the faces on the left and on the right of this edge. Otherwise: the face that
  /// contains the goal, twice.
  mesh::Face goal_faces_[2];
  bool have_common_face_ = false;
  DeadEnds dead_ends_;
  std::vector<mesh::HalfEdge> faces_;  ///< scratch of locate()
};

}  // namespace waywright::path
