#pragma once

#include <array>

#include "constraint/constrained_triangulation.hpp"
#include "locate/walk.hpp"

namespace waywright::constraint {

/// The events of a segment walk. A visitor derives from this class and redefines the functions for the events that it
/// needs. If a function returns false, the walk ends.
class SegmentVisitor {
 public:
  /// The segment runs through the vertex, or starts or ends there.
  bool at_vertex(mesh::Vertex) { return true; }
  /// The segment crosses the edge and comes from the face of `h`, or it starts or ends on the edge.
  bool at_edge(mesh::HalfEdge /*h*/, bool /*ends_here*/) { return true; }
  /// The segment runs through the inside of the face of `h`.
  bool through_face(mesh::HalfEdge /*h*/) { return true; }
};

/// Follows a straight segment through the mesh from `from` to `to`. It reports, in order, every vertex on the segment,
/// every edge that the segment crosses or on which it starts, every edge on which it ends (unless it reaches its end
/// along this edge), and every face that it runs through, both ends included. All decisions are exact.
class SegmentWalk {
 public:
  using Delaunay = ConstrainedTriangulation::Triangulation;

  /// Requires: both ends lie in the domain; `start` is the location of `from`.
  SegmentWalk(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to,
              const locate::Located& start)
      : delaunay_(triangulation.triangulation()),
        mesh_(triangulation.topology()),
        line_(exact::Geometry::view(from), exact::Geometry::view(to)),
        ascends_(geometry().order(this->from(), this->to()) < 0),
        start_(start) {}

  /// Calls the functions of a SegmentVisitor.
  template <class Visitor>
  void run(Visitor&& visitor);

 private:
  using Sign = exact::Sign;

  /// A stop of the walk: at a vertex, or at an edge through which the segment is about to leave a face.
  struct Stop {
    mesh::Vertex vertex = mesh::kNoVertex;
    mesh::HalfEdge exit = mesh::kNoHalfEdge;
    bool has_ended = false;  ///< the segment ends before this vertex or edge
    bool ends_on_exit = false;
    /// A half-edge of the face through which the segment reaches this stop. kNoHalfEdge if the segment reaches the stop
    /// along an edge, or starts at the stop.
    mesh::HalfEdge through = mesh::kNoHalfEdge;
  };

  [[nodiscard]] const exact::Geometry& geometry() const { return delaunay_.geometry(); }
  [[nodiscard]] const exact::Geometry::View& from() const { return line_.from; }
  [[nodiscard]] const exact::Geometry::View& to() const { return line_.to; }
  [[nodiscard]] Sign orientation(mesh::Vertex v) const {
    return v == delaunay_.ghost() ? Sign::zero : geometry().orientation(line_, delaunay_.view(v));
  }
  /// Whether the segment ends before `v`. Requires: `v` lies on the segment's line, ahead.
  [[nodiscard]] bool ends_before(mesh::Vertex v) const {
    const auto order = geometry().order(to(), delaunay_.view(v));
    return ascends_ ? order < 0 : order > 0;
  }
  [[nodiscard]] bool is_ahead(mesh::Vertex u, mesh::Vertex v) const { return delaunay_.comes_before(u, v) == ascends_; }

  [[nodiscard]] Stop leave_vertex(mesh::Vertex u) const;
  [[nodiscard]] Stop stop_on_start_edge() const;
  [[nodiscard]] Stop leave_face(mesh::HalfEdge any) const;
  template <class Visitor>
  [[nodiscard]] mesh::HalfEdge cross_faces(mesh::HalfEdge exit, Visitor&& visitor) const;
  [[nodiscard]] Stop stop_at_vertex(mesh::Vertex v, mesh::HalfEdge through = mesh::kNoHalfEdge) const {
    return {v, mesh::kNoHalfEdge, ends_before(v), false, through};
  }
  [[nodiscard]] Stop stop_at_edge(mesh::HalfEdge exit) const;

  const Delaunay& delaunay_;
  const mesh::TriangleMesh& mesh_;
  exact::Geometry::Line line_;
  bool ascends_;  ///< whether from() comes before to() in the order of x, then y
  locate::Located start_;
};

/// The stop at an exit edge. The segment ends beyond the edge, on it, or before it, inside the face.
inline SegmentWalk::Stop SegmentWalk::stop_at_edge(mesh::HalfEdge exit) const {
  const Sign end_side =
      geometry().orientation(delaunay_.view(mesh_.origin(exit)), delaunay_.view(mesh_.target(exit)), to());
  return {mesh::kNoVertex, exit, end_side == Sign::positive, end_side == Sign::zero, exit};
}

/// Leaves a face through `exit`, and then one face after the other, as long as the segment crosses the inside of an
/// edge and continues. If it reaches a vertex, returns the half-edge through which it has entered the last face; the
/// vertex is its apex. Returns kNoHalfEdge if the segment has ended, or if the visitor has ended the walk. A walk
/// spends nearly all of its time in this function.
template <class Visitor>
mesh::HalfEdge SegmentWalk::cross_faces(mesh::HalfEdge exit, Visitor&& visitor) const {
  exact::Geometry::View right = delaunay_.view(mesh_.origin(exit));
  exact::Geometry::View left = delaunay_.view(mesh_.target(exit));
  for (;;) {
    const mesh::HalfEdge entry = mesh_.twin(exit);
    const exact::Geometry::View apex = delaunay_.view(mesh_.apex(entry));
    const Sign apex_side = geometry().orientation(line_, apex);
    if (apex_side == Sign::zero) return entry;
    const bool is_left = apex_side == Sign::positive;
    exit = is_left ? mesh::next(entry) : mesh::previous(entry);
    (is_left ? left : right) = apex;
    if (!visitor.through_face(exit)) return mesh::kNoHalfEdge;
    const Sign end_side = geometry().orientation(right, left, to());
    if (end_side == Sign::positive) return mesh::kNoHalfEdge;
    if (!visitor.at_edge(exit, end_side == Sign::zero) || end_side == Sign::zero) return mesh::kNoHalfEdge;
  }
}

template <class Visitor>
void SegmentWalk::run(Visitor&& visitor) {
  Stop stop;
  if (start_.kind == locate::LocatedKind::vertex) {
    stop = stop_at_vertex(mesh_.origin(start_.h));
  } else if (start_.kind == locate::LocatedKind::edge) {
    stop = stop_on_start_edge();
    if (stop.vertex != mesh::kNoVertex && !visitor.at_edge(start_.h, false)) return;
  } else {
    if (geometry().order(from(), to()) == 0) return;
    stop = leave_face(start_.h);
  }
  for (;;) {
    if (stop.through != mesh::kNoHalfEdge && !visitor.through_face(stop.through)) return;
    if (stop.has_ended) return;
    if (stop.vertex != mesh::kNoVertex) {
      if (!visitor.at_vertex(stop.vertex)) return;
      if (geometry().order(to(), delaunay_.view(stop.vertex)) == 0) return;
      stop = leave_vertex(stop.vertex);
    } else {
      if (!visitor.at_edge(stop.exit, stop.ends_on_exit)) return;
      if (stop.ends_on_exit) return;
      const mesh::HalfEdge entry = cross_faces(stop.exit, visitor);
      if (entry == mesh::kNoHalfEdge) return;
      stop = stop_at_vertex(mesh_.apex(entry), entry);
    }
  }
}

}  // namespace waywright::constraint
