#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "locate/walk.hpp"

namespace waywright::path {

/// Decides exactly whether a point agent can walk along a polyline. The agent may touch walls and vertices and may walk
/// along walls. It must not pass through a wall or through the interior of a polygon. At a point where walls meet, it
/// must not pass from one wedge between these walls to another.
///
/// The walk follows the agent from face to face. At each position it keeps a list of the faces in which the agent may
/// be, inside or on the border. The agent can leave a vertex in a direction only if this direction lies in the closed
/// wedge, between two walls, that contains one of these faces.
///
/// Use one object for many polylines, because it keeps its memory.
class PolylineWalk {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Returns whether the agent can walk from the first point to the last along straight segments. A point between the
  /// first and the last may mean this point, or any crossing of sides that has the same rounded coordinates, because a
  /// path contains the rounded coordinates of a crossing. Returns false if there are no points, or if the first lies
  /// strictly inside a polygon. Requires: all points lie in the domain. Cost: the point location of the first point,
  /// and the faces that the segments cross.
  [[nodiscard]] bool is_clear(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                              std::span<const Point> points);

  /// The answer of find_stretch_state(). A *stretch* of a polyline consists of one or more of its straight lines, one
  /// after the other.
  enum class StretchState : std::uint8_t {
    clear,    ///< the agent can pass it, in the same wedges as before
    blocked,  ///< the agent cannot pass it
    unsure    ///< the agent may have to pass a wall on its left instead of its right, or the reverse
  };

  /// Looks at the stretch from points[first] to points[last] of a polyline that was clear before some operations. If
  /// the stretches that these operations touch are all clear, is_clear() is true for the whole polyline. If one of them
  /// is blocked, is_clear() is false. The result is `unsure` if the stretch runs along a wall, or has a point with the
  /// rounded coordinates of a crossing.
  ///
  /// Requires: the stretch has at least two points. No operation has changed anything at its first and its last point,
  /// except at the ends of the polyline, and none has removed an item where the polyline turns. Cost: the cost of
  /// is_clear() for the stretch.
  [[nodiscard]] StretchState find_stretch_state(const Triangulation& triangulation,
                                                constraint::CoverFinder& cover_finder, std::span<const Point> points,
                                                std::size_t first, std::size_t last);

 private:
  using View = exact::Geometry::View;

  /// A position of the agent, in one of the faces there. `h` is a half-edge of that face: any of the three if the
  /// position lies inside the face, the half-edge along the edge if it lies on an edge, the outgoing half-edge if it is
  /// a vertex.
  struct State {
    locate::LocatedKind kind;
    mesh::HalfEdge h;
    View position;
  };

  [[nodiscard]] const exact::Geometry& geometry() const { return triangulation_->triangulation().geometry(); }
  [[nodiscard]] View view(mesh::Vertex v) const { return geometry().view(number(v)); }
  [[nodiscard]] exact::Sign orientation(mesh::Vertex v) const;
  [[nodiscard]] bool is_ahead(const View& p, const View& q) const;
  [[nodiscard]] bool ends_before(mesh::Vertex v) const;

  void use(const Triangulation& triangulation);
  locate::Located start_at(constraint::CoverFinder& cover_finder, const Point& point);
  void walk_to(std::span<const Point> points, std::size_t i);
  void collect_crossings_at(const Point& point);
  void walk_segment(const View& target);
  void leave(const State& state);
  void leave_vertex(mesh::HalfEdge h);
  [[nodiscard]] bool leave_vertex_through(mesh::HalfEdge h);
  void leave_edge(mesh::HalfEdge h);
  void leave_face(mesh::HalfEdge h);
  void run_along(mesh::HalfEdge edge, mesh::HalfEdge at_end);
  void cross_faces(mesh::HalfEdge exit);
  void enter(mesh::HalfEdge entry);
  void arrive(locate::LocatedKind kind, mesh::HalfEdge h);
  void add_arrived(const State& state);
  void reach_vertex(mesh::HalfEdge outgoing);
  [[nodiscard]] mesh::HalfEdge first_of_wedge(mesh::HalfEdge outgoing) const;

  const Triangulation* triangulation_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  exact::Geometry::Line line_;          ///< of the segment that the agent walks along
  bool ascends_ = false;                ///< whether the segment's end comes after its start in (x, y) order
  bool is_unsure_ = false;              ///< for find_stretch_state()
  std::vector<View> possible_ends_;     ///< exact positions: the segment's end may be any of them
  std::vector<State> states_;           ///< at the start of the segment
  std::vector<State> arrived_;          ///< at the end of the segment
  std::vector<State> waiting_;          ///< at vertices on the segment
  std::vector<mesh::HalfEdge> wedges_;  ///< the first half-edge of each wedge that the walk has reached on the segment
  std::vector<mesh::Face> flooded_;
};

}  // namespace waywright::path
