#pragma once

#include <array>

#include "constraint/exact_triangulation.hpp"
#include "locate/walk.hpp"

namespace waywright::constraint {

/// Follows a straight segment through the mesh and tells, in order from `from` to `to`, of every vertex it runs through
/// and every edge it crosses or starts or ends on, both ends included. Exact throughout.
class SegmentWalk {
 public:
  using Delaunay = ExactTriangulation::Triangulation;

  /// Requires: both ends lie in the domain, `start` is where `from` lies.
  SegmentWalk(const ExactTriangulation& triangulation, const Point& from, const Point& to, const locate::Located& start)
      : delaunay_(triangulation.triangulation()),
        mesh_(triangulation.topology()),
        from_(exact::explicit_point(from)),
        to_(exact::explicit_point(to)),
        ascends_(exact::compare(from_, to_) < 0),
        start_(start) {}

  /// Calls visitor.at_vertex(v) and visitor.at_edge(h) until one returns false or the segment ends.
  template <class Visitor>
  void run(Visitor&& visitor);

 private:
  using Sign = exact::Sign;

  /// Where the segment stands: at a vertex, or at the inner side of an edge that it is about to leave its face by.
  struct Stand {
    mesh::Vertex vertex = mesh::kNoVertex;
    mesh::HalfEdge exit = mesh::kNoHalfEdge;
    bool has_ended = false;  ///< before it gets there
    bool ends_on_exit = false;
  };

  [[nodiscard]] Sign side(mesh::Vertex v) const {
    return v == delaunay_.ghost() ? Sign::zero : exact::orientation(from_, to_, delaunay_.view(v));
  }
  /// Whether the end comes before `v`, a vertex on the segment's line ahead.
  [[nodiscard]] bool ends_before(mesh::Vertex v) const {
    const auto order = exact::compare(to_, delaunay_.view(v));
    return ascends_ ? order < 0 : order > 0;
  }
  [[nodiscard]] bool is_ahead(mesh::Vertex u, mesh::Vertex v) const { return delaunay_.comes_before(u, v) == ascends_; }

  [[nodiscard]] Stand leave_vertex(mesh::Vertex u) const;
  [[nodiscard]] Stand leave_start_edge() const;
  [[nodiscard]] Stand leave_face(mesh::HalfEdge any) const;
  [[nodiscard]] Stand enter_face(mesh::HalfEdge entry) const;
  [[nodiscard]] Stand stand_at(mesh::Vertex v) const { return {v, mesh::kNoHalfEdge, ends_before(v)}; }
  [[nodiscard]] Stand stand_before(mesh::HalfEdge exit) const;

  const Delaunay& delaunay_;
  const mesh::TriangleMesh& mesh_;
  exact::ExactPoint from_;
  exact::ExactPoint to_;
  bool ascends_;
  locate::Located start_;
};

template <class Visitor>
void SegmentWalk::run(Visitor&& visitor) {
  Stand stand;
  if (start_.spot == locate::Spot::vertex) {
    stand = stand_at(mesh_.origin(start_.h));
  } else if (start_.spot == locate::Spot::edge) {
    if (!visitor.at_edge(start_.h) || exact::compare(from_, to_) == 0) return;
    stand = leave_start_edge();
  } else {
    if (exact::compare(from_, to_) == 0) return;
    stand = leave_face(start_.h);
  }
  while (!stand.has_ended) {
    if (stand.vertex != mesh::kNoVertex) {
      if (!visitor.at_vertex(stand.vertex)) return;
      if (exact::compare(to_, delaunay_.view(stand.vertex)) == 0) return;
      stand = leave_vertex(stand.vertex);
    } else {
      if (!visitor.at_edge(stand.exit)) return;
      if (stand.ends_on_exit) return;
      stand = enter_face(mesh_.twin(stand.exit));
    }
  }
}

}  // namespace waywright::constraint
