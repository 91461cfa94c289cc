#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "path/disc_map.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// Tests whether a disc can move along a straight line from one contact to another, or from or to a point. The test
/// visits the faces that the line crosses, and the faces beside them that are nearer to the line than the radius. It
/// does not look beyond bridges: if both ends of a bridge are far enough from the line, no wall beyond the bridge is
/// nearer.
class DiscLine {
 public:
  /// An end of the line: a contact at a vertex, or a point.
  struct End {
    Contact contact;
    mesh::Vertex vertex = mesh::kNoVertex;  ///< kNoVertex at a point
  };

  /// A vertex that is nearer to the line than the radius. A path can pass the vertex only if it turns around it.
  struct Obstacle {
    mesh::Vertex vertex = mesh::kNoVertex;  ///< kNoVertex if there is none
    mesh::HalfEdge corner;                  ///< starts at the vertex
    Tangent line;                           ///< from the first end of the line to the obstacle
  };

  /// Tests the line from `from` to `to` in a direction. `face` is a half-edge of the face that contains the position at
  /// which the line ends. Returns whether no wall is nearer to the line than the radius and the line crosses only gaps
  /// that are wide enough. If the result is false, left() and right() are obstacles, if the test has found any. left()
  /// is an obstacle left of the line: the obstacle whose tangent from `from` points farthest to the right. right() is
  /// an obstacle right of the line: the obstacle whose tangent from `from` points farthest to the left.
  [[nodiscard]] bool is_clear(const DiscMap& map, const End& from, const End& to, const Tangent& line,
                              mesh::HalfEdge face);
  [[nodiscard]] const Obstacle& left() const { return obstacles_[1]; }
  [[nodiscard]] const Obstacle& right() const { return obstacles_[0]; }

  /// A half-edge of the face that contains a position, or a wall before the position.
  struct FaceAt {
    mesh::HalfEdge h;
    bool is_behind_wall;
  };
  /// Finds the face that contains the position at which a line touches the contact at `vertex`, which is the origin of
  /// `corner`. The straight line from the vertex to the position begins in the face of `corner`. If it meets a wall,
  /// the disc does not fit at the position.
  [[nodiscard]] static FaceAt face_at(const DiscMap& map, const Point& vertex, const Point& touching,
                                      mesh::HalfEdge corner);

 private:
  /// A position relative to the line, which starts here at end_ and goes back to start_.
  struct Offset {
    Point position;
    double along = 0.0;   ///< from end_ to the foot of the position on the line
    double across = 0.0;  ///< positive on the left of the line from end_ to start_
  };

  [[nodiscard]] Offset offset(mesh::Vertex v) const;
  [[nodiscard]] double squared_distance(const Offset& at) const;
  [[nodiscard]] bool is_edge_near(const Offset& a, const Offset& b) const;
  void walk(mesh::HalfEdge face);
  /// Visits the faces beyond `h` that are near the line.
  void look_beside(mesh::HalfEdge h, const Offset& origin, const Offset& target) {
    if (!is_aside(origin, target)) visit_beside(h, origin, target);
  }
  /// Returns whether the whole edge lies left of the line, or the whole edge lies right of it, and the edge is farther
  /// than the radius from the straight line through the two ends of the line.
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
  [[nodiscard]] bool crosses_foot(mesh::HalfEdge corner) const;
  void look_at_feet(mesh::Vertex v);

  /// An edge beside the line that the visit has not looked at yet.
  struct Beside {
    mesh::HalfEdge h;
    Offset origin;
    Offset target;
  };

  const DiscMap* map_ = nullptr;
  End from_;
  End to_;
  Point start_;      ///< the position at which the line starts
  Point end_;        ///< the position at which it ends
  Point direction_;  ///< of the line
  Point back_;       ///< the opposite direction
  double length_ = 0.0;
  double least_ = 0.0;  ///< the square of the least distance that a wall may have
  double reach_ = 0.0;  ///< the disc touches vertices that are not farther than this
  bool is_blocked_ = false;
  Obstacle obstacles_[2];  ///< on the right, on the left
  std::vector<Beside> to_enter_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by face
  memory::Stamp stamp_;
};

}  // namespace waywright::path
