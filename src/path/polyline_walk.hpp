#pragma once

#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"
#include "locate/walk.hpp"

namespace waywright::path {

/// Decides exactly whether a point agent can walk along a polyline. The agent may touch walls and vertices and may run
/// along walls. It must not pass through a wall, through the inside of a polygon, or through a point where walls meet
/// from one wedge between these walls to another.
///
/// The walk follows the agent from face to face. At each place it keeps the faces that the agent can be in, or at the
/// border of. The agent leaves a vertex in some direction only if that direction lies in the closed wedge, between two
/// walls, of such a face.
///
/// Keep the object: its memory serves many queries.
class PolylineWalk {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Whether the agent can walk from the first point to the last, in straight pieces. A point between the first and the
  /// last stands for itself, and also for each crossing of walls whose rounded coordinates it has: paths name such
  /// crossings by these. False if there are no points, or if the first lies strictly inside a polygon.
  /// Requires: all points lie in the domain. Cost: the location of the first point, and the faces that the pieces
  /// cross.
  [[nodiscard]] bool is_clear(const Triangulation& triangulation, constraint::Cover& cover,
                              std::span<const Point> points);

 private:
  using View = exact::Geometry::View;

  /// The agent at a place, in one of the faces there. `h` is a half-edge of that face: any of them if the place lies
  /// inside the face, the one along the edge if it lies on an edge, the outgoing one if it is a vertex.
  struct State {
    locate::Spot spot;
    mesh::HalfEdge h;
    View place;
  };

  [[nodiscard]] const exact::Geometry& geometry() const { return triangulation_->triangulation().geometry(); }
  [[nodiscard]] View view(mesh::Vertex v) const { return geometry().view(number(v)); }
  [[nodiscard]] exact::Sign side(mesh::Vertex v) const;
  [[nodiscard]] bool is_ahead(const View& p, const View& q) const;
  [[nodiscard]] bool ends_before(mesh::Vertex v) const;

  void collect_crossings_at(const Point& point);
  void walk_piece(const View& target);
  void leave(const State& state);
  void leave_vertex(mesh::HalfEdge h);
  [[nodiscard]] bool leave_vertex_through(mesh::HalfEdge h);
  void leave_edge(mesh::HalfEdge h);
  void leave_face(mesh::HalfEdge h);
  void run_along(mesh::HalfEdge edge, mesh::HalfEdge at_end);
  void cross_faces(mesh::HalfEdge exit);
  void enter(mesh::HalfEdge entry);
  void arrive(locate::Spot spot, mesh::HalfEdge h);
  void add_arrived(const State& state);
  void come_to_vertex(mesh::HalfEdge outgoing);
  [[nodiscard]] mesh::HalfEdge first_of_wedge(mesh::HalfEdge outgoing) const;

  const Triangulation* triangulation_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  exact::Geometry::Line line_;          ///< of the piece
  bool ascends_ = false;                ///< whether its end comes after its start in (x, y) order
  std::vector<View> meanings_;          ///< the places that the piece's end stands for
  std::vector<State> states_;           ///< at the start of the piece
  std::vector<State> arrived_;          ///< at its end
  std::vector<State> waiting_;          ///< at vertices on the way
  std::vector<mesh::HalfEdge> wedges_;  ///< the wedges that the piece has come to, each by its first half-edge
  std::vector<mesh::Face> flooded_;
};

}  // namespace waywright::path
