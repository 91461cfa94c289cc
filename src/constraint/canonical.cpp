#include "constraint/canonical.hpp"

#include <algorithm>

#include "exact/crossing.hpp"

namespace waywright::constraint {

namespace {

std::array<std::uint32_t, 3> from_smallest(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a < b && a < c) return {a, b, c};
  if (b < c) return {b, c, a};
  return {c, a, b};
}

void append_constraint(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h, std::uint32_t i,
                       std::uint32_t j, MeshSnapshot& snapshot) {
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

void take_snapshot(const ConstrainedTriangulation& triangulation, CanonicalOrder& order, MeshSnapshot& snapshot) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  auto& [vertices, index, fixed] = order;
  vertices.clear();
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const mesh::Vertex v{i};
    if (mesh.is_live(v) && v != delaunay.ghost()) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end(),
            [&](mesh::Vertex p, mesh::Vertex q) { return delaunay.comes_before(p, q); });

  snapshot.vertices.clear();
  snapshot.triangles.clear();
  snapshot.constraints.clear();
  snapshot.ids.clear();
  index.assign(mesh.vertex_slots(), 0);
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    index[number(vertices[i])] = i;
    snapshot.vertices.push_back(delaunay.geometry().rounded(number(vertices[i])));
  }

  fixed.clear();
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const mesh::Face f{i};
    if (!delaunay.is_in_domain(f)) continue;
    mesh::HalfEdge h = mesh::first(f);
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
      corner = index[number(mesh.origin(h))];
      const std::uint32_t end = index[number(mesh.target(h))];
      const bool is_listed_here = corner < end || delaunay.is_ghost_face(mesh.twin(h));
      if (mesh.is_fixed(h) && is_listed_here) fixed.push_back({std::min(corner, end), std::max(corner, end), h});
      h = mesh::next(h);
    }
    snapshot.triangles.push_back(from_smallest(corners[0], corners[1], corners[2]));
  }
  std::sort(snapshot.triangles.begin(), snapshot.triangles.end());
  std::sort(fixed.begin(), fixed.end(), [](const CanonicalOrder::FixedEdge& p, const CanonicalOrder::FixedEdge& q) {
    return p.i != q.i ? p.i < q.i : p.j < q.j;
  });
  for (const auto& [i, j, h] : fixed) append_constraint(triangulation, h, i, j, snapshot);
}

std::string dump(const ConstrainedTriangulation& triangulation) {
  CanonicalOrder order;
  MeshSnapshot snapshot;
  take_snapshot(triangulation, order, snapshot);
  std::string text = "vertices " + std::to_string(order.vertices.size()) + '\n';
  for (const mesh::Vertex v : order.vertices) {
    text += exact::to_fractions(triangulation.triangulation().geometry().exact(number(v)));
    text += '\n';
  }
  text += "triangles " + std::to_string(snapshot.triangles.size()) + '\n';
  for (const auto& [i, j, k] : snapshot.triangles) {
    text += std::to_string(i) + ' ' + std::to_string(j) + ' ' + std::to_string(k) + '\n';
  }
  text += "constraints " + std::to_string(snapshot.constraints.size()) + '\n';
  for (const MeshSnapshot::ConstrainedEdge& edge : snapshot.constraints) {
    text += std::to_string(edge.vertices[0]) + ' ' + std::to_string(edge.vertices[1]);
    for (std::uint32_t i = 0; i < edge.id_count; ++i) {
      text += ' ' + std::to_string(snapshot.ids[edge.first_id + i].value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace waywright::constraint
