#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "workloads.hpp"

namespace waywright::bench {

/// CGAL's Constrained_triangulation_plus_2 with polylines under ids. Its remove_constraint leaves corners and crossings
/// in the mesh. This contender removes the vertices that no item needs any more, so that the mesh returns to its
/// earlier state, as far as the kernel allows.
template <class Kernel, class Intersections>
class CgalPolylines {
  /// How many corners of items lie on a vertex.
  struct Uses {
    std::uint32_t corners = 0;
  };
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Uses, Kernel>;
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, Intersections>;
  using Base = CGAL::Constrained_triangulation_plus_2<Delaunay>;

  /// The base's insert_constraint() always searches a polyline's first point from the mesh's border. This one starts
  /// from a vertex.
  struct Plus : Base {
    using Base::insert_constraint;

    /// Requires: two vertices or more; neighbours differ.
    typename Base::Constraint_id insert_constraint(const std::vector<typename Base::Vertex_handle>& vertices) {
      const typename Base::Constraint_id id = this->hierarchy.insert_constraint(vertices[0], vertices[1]);
      this->insert_subconstraint(vertices[0], vertices[1]);
      for (std::size_t i = 2; i < vertices.size(); ++i) {
        this->hierarchy.append_constraint(id, vertices[i - 1], vertices[i]);
        this->insert_subconstraint(vertices[i - 1], vertices[i]);
      }
      return id;
    }
  };
  using Vertex = typename Plus::Vertex_handle;
  using ConstraintId = typename Plus::Constraint_id;
  using Corner = typename Plus::Point;

  /// The structures of an item in the mesh: a constraint for each ring, or a vertex for a ring that is a single point.
  struct Live {
    std::vector<ConstraintId> constraints;
    std::vector<Vertex> points;
  };

 public:
  explicit CgalPolylines(const Box& domain) {
    const std::vector<Point> ring = {
        domain.min, {domain.max.x, domain.min.y}, domain.max, {domain.min.x, domain.max.y}};
    insert({ItemId{0}, {ItemKind::polygon, {ring}}});
  }

  void insert(const Item& item) {
    const std::size_t id = item.id.value;
    if (live_.size() <= id) live_.resize(std::max(id + 1, 2 * live_.size()));
    for (const PointSpan& ring : item.shape.rings) insert_ring(ring, item.shape.kind, live_[id]);
  }

  void update(const Update& update) {
    if (!update.removed.is_null()) remove(update.removed);
    if (!update.inserted.id.is_null()) insert(update.inserted);
  }

  [[nodiscard]] std::size_t vertex_count() const { return plus_.number_of_vertices(); }
  [[nodiscard]] std::string fault() const { return plus_.is_valid() ? "" : "is_valid() says no"; }

 private:
  void insert_ring(const std::vector<Point>& ring, ItemKind kind, Live& live) {
    vertices_.clear();
    for (const Point& p : ring) {
      const auto start = recent_ == Vertex() ? typename Plus::Face_handle() : recent_->face();
      recent_ = plus_.insert(Corner(p.x, p.y), start);
      if (vertices_.empty() || vertices_.back() != recent_) vertices_.push_back(recent_);
    }
    if (kind == ItemKind::polygon && vertices_.front() != vertices_.back()) vertices_.push_back(vertices_.front());
    if (vertices_.size() == 1) {
      live.points.push_back(vertices_[0]);
      ++vertices_[0]->info().corners;
      return;
    }
    live.constraints.push_back(plus_.insert_constraint(vertices_));
    const auto end = plus_.vertices_in_constraint_end(live.constraints.back());
    for (auto it = plus_.vertices_in_constraint_begin(live.constraints.back()); it != end; ++it) {
      if (it.input()) ++(*it)->info().corners;
    }
  }

  void remove(ItemId item) {
    Live& live = live_[item.value];
    touched_ = live.points;
    for (const Vertex v : live.points) --v->info().corners;
    for (const ConstraintId id : live.constraints) {
      const auto end = plus_.vertices_in_constraint_end(id);
      for (auto it = plus_.vertices_in_constraint_begin(id); it != end; ++it) {
        if (it.input()) --(*it)->info().corners;
        touched_.push_back(*it);
      }
      plus_.remove_constraint(id);
    }
    live.constraints.clear();
    live.points.clear();
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const Vertex v : touched_) clean_up(v);
  }

  /// Removes a vertex if no item has a corner there and no two constraints cross there.
  void clean_up(Vertex v) {
    if (v->info().corners > 0) return;
    std::size_t constrained = 0;
    Vertex along;   // the other end of a constrained edge
    Vertex beside;  // the other end of any edge
    auto edge = plus_.incident_edges(v);
    const auto start = edge;
    do {
      const Vertex one = edge->first->vertex(Plus::ccw(edge->second));
      const Vertex end = one == v ? edge->first->vertex(Plus::cw(edge->second)) : one;
      if (!plus_.is_infinite(end)) beside = end;
      if (!edge->first->is_constrained(edge->second)) continue;
      ++constrained;
      along = end;
    } while (++edge != start);
    if (constrained != 0 && constrained != 2) return;
    if (v == recent_) recent_ = beside;
    if (constrained == 0) {
      plus_.remove(v);
    } else {
      // simplify() joins the two pieces in all polylines that contain them.
      auto position = plus_.context(along, v).current();
      if (*position != v) ++position;
      plus_.simplify(position);
    }
  }

  Plus plus_;
  std::vector<Live> live_;
  std::vector<Vertex> vertices_;
  std::vector<Vertex> touched_;
  Vertex recent_;  ///< where the next search starts
};

}  // namespace waywright::bench
