#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "memory/scratch.hpp"
#include "path/disc_map.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// Tests whether a disc can move along a straight line. Each end of the line is a pivot or a point. The test visits
/// the faces that the line crosses, and the faces beside them that are nearer to the line than the radius. It does not
/// look beyond bridges: if both ends of a bridge are at least as far from the line as the radius, no wall beyond the
/// bridge is nearer than the radius.
class DiscLine {
 public:
  /// An end of the line: a pivot at a vertex, or a point.
  struct End {
    Pivot pivot;
    mesh::Vertex vertex = mesh::kNoVertex;  ///< kNoVertex at a point
  };

  /// A vertex that is nearer to the line than the radius. A path can pass the vertex only if it turns around it.
  struct Obstacle {
    mesh::Vertex vertex = mesh::kNoVertex;      ///< kNoVertex if there is none
    mesh::HalfEdge corner = mesh::kNoHalfEdge;  ///< starts at the vertex
    Tangent line;                               ///< from the first end of the line to the obstacle
  };

  /// Tests the line from `from` to `to` in a direction. `face` is a half-edge of the face that contains the position at
  /// which the line ends. Returns whether no wall is nearer to the line than the radius and the line crosses only gaps
  /// that are wide enough. If the result is false, left() and right() are the obstacles that the test has found, if
  /// there are any. Consider the straight line between the centres of the two pivots. Of the obstacles on its left,
  /// left() is the one whose tangent from `from` points farthest to the right. Of the obstacles on its right, right()
  /// is the one whose tangent from `from` points farthest to the left. An obstacle on this line counts as left and as
  /// right of it.
  [[nodiscard]] bool is_clear(const DiscMap& map, const End& from, const End& to, const Tangent& line,
                              mesh::HalfEdge face);
  [[nodiscard]] const Obstacle& left() const { return obstacles_[1]; }
  [[nodiscard]] const Obstacle& right() const { return obstacles_[0]; }

  /// The result of face_at().
  struct FaceAt {
    mesh::HalfEdge h;     ///< a half-edge of the face that contains the position; if `is_behind_wall`, the wall
    bool is_behind_wall;  ///< whether a wall lies between the vertex and the position
  };
  /// Finds the face that contains `touching`, the position at which a line touches a pivot. `vertex` is the position
  /// of the pivot's vertex, and `corner` starts at this vertex. The function follows the straight line from the
  /// vertex to `touching`. If this line meets a wall, the disc does not fit at `touching`. Requires: the line begins in
  /// the face of `corner`.
  [[nodiscard]] static FaceAt face_at(const DiscMap& map, const Point& vertex, const Point& touching,
                                      mesh::HalfEdge corner);

 private:
  /// A position, and its coordinates relative to the line. The test goes along the line from its end to its start, so
  /// the direction of these coordinates is `back_`.
  struct Offset {
    Point position;
    double along = 0.0;   ///< the coordinate in the direction `back_`: 0 at `end_`, `length_` at `start_`
    double across = 0.0;  ///< the distance from the straight line; positive on the left of the direction `back_`
  };

  [[nodiscard]] Offset offset(mesh::Vertex v) const;
  [[nodiscard]] double squared_distance(const Offset& at) const;
  [[nodiscard]] bool is_edge_near(const Offset& a, const Offset& b) const;
  void walk(mesh::HalfEdge face);
  /// Visits the faces beyond `h` that are near the line.
  void look_beside(mesh::HalfEdge h, const Offset& origin, const Offset& target) {
    if (!is_aside(origin, target)) visit_beside(h, origin, target);
  }
  /// Returns whether the edge does not meet the straight line through `start_` and `end_`, and each position on the
  /// edge is farther than the radius from this line.
  [[nodiscard]] bool is_aside(const Offset& origin, const Offset& target) const {
    return std::min(origin.across, target.across) > map_->radius ||
           std::max(origin.across, target.across) < -map_->radius;
  }
  void visit_beside(mesh::HalfEdge h, const Offset& origin, const Offset& target);
  [[nodiscard]] bool enter_beside(mesh::HalfEdge at, const Offset& origin, const Offset& target);
  void look_at_wall(const Point& a, const Point& b);
  void note_ends_as_obstacles(mesh::HalfEdge exit);
  /// Looks at the vertex at which `corner` starts.
  void look_at_vertex(mesh::HalfEdge corner, const Offset& at) {
    if (std::abs(at.across) <= reach_) look_at_near_vertex(corner, at);
  }
  void look_at_near_vertex(mesh::HalfEdge corner, const Offset& at);
  void note_obstacle(mesh::HalfEdge corner);
  /// Returns whether a foot bridge that is too narrow for the disc starts at `corner`, and the line crosses it.
  [[nodiscard]] bool crosses_foot(mesh::HalfEdge corner) const;
  void look_at_feet(mesh::Vertex v);

  /// An edge through which visit_beside() has entered a face. The visit has not looked at the other edges of this face
  /// yet.
  struct Entered {
    mesh::HalfEdge h;  ///< the edge, as a half-edge of the face before it
    Offset origin;
    Offset target;
  };

  const DiscMap* map_ = nullptr;
  End from_;
  End to_;
  Point start_;      ///< the position at which the line starts
  Point end_;        ///< the position at which it ends
  Point direction_;  ///< the direction of the line, from `start_` to `end_`
  Point back_;       ///< the opposite direction
  double length_ = 0.0;
  double least_squared_ = 0.0;  ///< the square of DiscMap::least_distance(), the least distance of a wall from the line
  double reach_ = 0.0;          ///< the test looks at the foot bridges of the vertices that are at most this far away
  bool is_blocked_ = false;     ///< whether the test has failed
  Obstacle obstacles_[2];       ///< obstacles_[0] is right(), obstacles_[1] is left()
  std::vector<Entered> entered_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by face: the number of the last test that visited it
  memory::Stamp stamp_;
};

}  // namespace waywright::path
