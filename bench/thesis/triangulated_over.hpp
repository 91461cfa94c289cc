#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>

#include "constraint/constrained_triangulation.hpp"
#include "exact/predicates.hpp"
#include "thesis/triangulated.hpp"

// Defines triangulate() for the geometry for which this source file compiles the triangulation.

namespace waywright::bench {
namespace {

class TriangulatedOver final : public Triangulated {
 public:
  explicit TriangulatedOver(const Box& domain) : triangulation_(domain) {}

  void insert(const Item& item) override {
    Triangulation::UndoGuard operation(triangulation_);
    triangulation_.insert(item.shape, item.id);
    operation.commit();
  }
  void update(const Update& update) override {
    if (!update.removed.is_null()) remove(update.removed);
    if (!update.inserted.id.is_null()) insert(update.inserted);
  }

  [[nodiscard]] MeshCounts counts() const override {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    MeshCounts counts{mesh.vertex_count() - 1, 0};  // without the ghost
    for_each_half_edge([&](mesh::HalfEdge h) { counts.fixed_edges += h < mesh.twin(h) && mesh.is_fixed(h) ? 1 : 0; });
    return counts;
  }

  [[nodiscard]] bool is_planar() const override {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    if (mesh.find_fault()) return false;
    bool is_planar = true;
    for_each_half_edge([&](mesh::HalfEdge h) {
      if (h != mesh::first(mesh::face(h)) || triangulation_.triangulation().is_ghost_face(h)) return;
      is_planar = is_planar && turns_left(mesh.origin(h), mesh.target(h), mesh.apex(h));
    });
    return is_planar;
  }

 private:
  using Triangulation = constraint::ConstrainedTriangulation;

  void remove(ItemId id) {
    Triangulation::UndoGuard operation(triangulation_);
    triangulation_.remove(id);
    operation.commit();
  }

  [[nodiscard]] bool turns_left(mesh::Vertex a, mesh::Vertex b, mesh::Vertex c) const {
    if constexpr (std::is_same_v<delaunay::Geometry::View, Point>) {
      const auto at = [&](mesh::Vertex v) {
        return exact::explicit_position(triangulation_.triangulation().geometry().rounded(number(v)));
      };
      return exact::orientation(at(a), at(b), at(c)) == exact::Sign::positive;
    } else {
      return triangulation_.triangulation().orientation(a, b, c) == exact::Sign::positive;
    }
  }

  template <class Visit>
  void for_each_half_edge(Visit&& visit) const {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    for (std::uint32_t i = 0; i < mesh.face_slots() * 3; ++i) {
      if (mesh.is_live(mesh::face(mesh::HalfEdge{i}))) visit(mesh::HalfEdge{i});
    }
  }

  Triangulation triangulation_;
};

}  // namespace

template <>
std::unique_ptr<Triangulated> triangulate<delaunay::Geometry>(const Box& domain) {
  return std::make_unique<TriangulatedOver>(domain);
}

}  // namespace waywright::bench
