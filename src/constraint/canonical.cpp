#include "constraint/canonical.hpp"

#include <algorithm>

namespace waywright::constraint {

namespace {

std::array<std::uint32_t, 3> from_smallest(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a < b && a < c) return {a, b, c};
  if (b < c) return {b, c, a};
  return {c, a, b};
}

void append_constraint(const ExactTriangulation& triangulation, mesh::HalfEdge h, std::uint32_t i, std::uint32_t j,
                       MeshSnapshot& snapshot) {
  MeshSnapshot::ConstrainedEdge edge{{i, j}, static_cast<std::uint32_t>(snapshot.ids.size()), 0};
  triangulation.for_each_side(h,
                              [&](const Side& side) { snapshot.ids.push_back(triangulation.items().id(side.item)); });
  const auto first = snapshot.ids.begin() + static_cast<std::ptrdiff_t>(edge.first_id);
  std::sort(first, snapshot.ids.end());
  snapshot.ids.erase(std::unique(first, snapshot.ids.end()), snapshot.ids.end());
  edge.id_count = static_cast<std::uint32_t>(snapshot.ids.size()) - edge.first_id;
  snapshot.constraints.push_back(edge);
}

}  // namespace

CanonicalMesh canonical_mesh(const ExactTriangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  CanonicalMesh result;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const mesh::Vertex v{i};
    if (mesh.is_alive(v) && v != delaunay.ghost()) result.order.push_back(v);
  }
  std::sort(result.order.begin(), result.order.end(),
            [&](mesh::Vertex p, mesh::Vertex q) { return delaunay.comes_before(p, q); });

  std::vector<std::uint32_t> rank(mesh.vertex_slots(), 0);
  MeshSnapshot& snapshot = result.snapshot;
  for (std::uint32_t i = 0; i < result.order.size(); ++i) {
    rank[number(result.order[i])] = i;
    snapshot.vertices.push_back(delaunay.geometry().nearest(number(result.order[i])));
  }

  struct Edge {
    std::uint32_t i, j;
    mesh::HalfEdge h;
  };
  std::vector<Edge> fixed;
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const mesh::Face f{i};
    if (!delaunay.is_in_box(f)) continue;
    mesh::HalfEdge h = mesh::first(f);
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
      corner = rank[number(mesh.origin(h))];
      const std::uint32_t end = rank[number(mesh.target(h))];
      const bool is_listed_here = corner < end || delaunay.is_ghost_face(mesh.twin(h));
      if (mesh.is_fixed(h) && is_listed_here) fixed.push_back({std::min(corner, end), std::max(corner, end), h});
      h = mesh::next(h);
    }
    snapshot.triangles.push_back(from_smallest(corners[0], corners[1], corners[2]));
  }
  std::sort(snapshot.triangles.begin(), snapshot.triangles.end());
  std::sort(fixed.begin(), fixed.end(),
            [](const Edge& p, const Edge& q) { return p.i != q.i ? p.i < q.i : p.j < q.j; });
  for (const Edge& edge : fixed) append_constraint(triangulation, edge.h, edge.i, edge.j, snapshot);
  return result;
}

}  // namespace waywright::constraint
