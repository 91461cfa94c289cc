#pragma once

#include <cstdint>

#include "waywright/point.hpp"

#include "clearance/cells.hpp"
#include "constraint/exact_triangulation.hpp"
#include "exact/gap.hpp"
#include "nav/point_agent.hpp"

namespace waywright {

// The graphs whose areas (Areas) agents cannot leave.

/// The faces, and the edges that a point agent can cross.
class FaceGraph {
 public:
  using Edge = mesh::HalfEdge;

  explicit FaceGraph(const constraint::ExactTriangulation& triangulation)
      : mesh_(triangulation.topology()), geometry_(triangulation.triangulation().geometry()) {}

  [[nodiscard]] Edge across(Edge h) const { return mesh_.twin(h); }
  [[nodiscard]] std::uint32_t key(Edge h) const { return number(mesh::face(h)); }
  [[nodiscard]] std::size_t key_count() const { return mesh_.face_slots(); }
  template <class AddKey, class AddExit>
  void enter(Edge edge, const AddKey& add_key, const AddExit& add_exit, Box& bounds) const {
    add_key(key(edge));
    for (const Edge h : {edge, mesh::next(edge), mesh::previous(edge)}) {
      bounds.expand(geometry_.rounded(number(mesh_.origin(h))));
      if (nav::PointAgent::can_cross(mesh_, h)) add_exit(h);
    }
  }

 private:
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
};

/// The cells, and the gates that a disc can cross.
class CellGraph {
 public:
  using Edge = clearance::CellEdge;

  CellGraph(const constraint::ExactTriangulation& walls, const clearance::Bridges& bridges, double radius)
      : cells_(walls, bridges), radius_(radius) {}

  [[nodiscard]] Edge across(const Edge& gate) const { return cells_.across(gate); }
  [[nodiscard]] std::uint32_t key(const Edge& edge) const { return cells_.key(edge); }
  [[nodiscard]] std::size_t key_count() const { return cells_.key_count(); }
  template <class AddKey, class AddExit>
  void enter(const Edge& edge, const AddKey& add_key, const AddExit& add_exit, Box& bounds) const {
    Edge at = edge;
    do {
      add_key(key(at));
      bounds.expand(cells_.position_near(at));
      if (at.is_gate()) {
        const exact::Gap gap = cells_.gap(at);
        bounds.expand(exact::end_of(gap));
        if (exact::compare_to_diameter(gap, radius_) >= 0) add_exit(at);
      }
      at = cells_.next(at);
    } while (at != edge);
  }

 private:
  clearance::Cells cells_;
  double radius_;
};

}  // namespace waywright
