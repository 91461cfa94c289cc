#include <algorithm>

#include "constraint/constrained_triangulation.hpp"

namespace waywright::constraint {

namespace {

std::string edge_name(const mesh::TriangleMesh& mesh, mesh::HalfEdge h) {
  return "edge " + std::to_string(number(mesh.origin(h))) + " - " + std::to_string(number(mesh.target(h)));
}

}  // namespace

std::optional<std::string> ConstrainedTriangulation::find_fault() const {
  if (auto fault = topology().find_fault()) return fault;
  if (auto fault = find_orientation_fault()) return fault;
  if (auto fault = find_use_fault()) return fault;
  if (auto fault = find_vertex_fault()) return fault;
  return find_delaunay_fault();
}

// The triangulation covers the domain exactly once if the mesh is a sphere, all faces in the domain are
// counter-clockwise, and the border between them and the ghost faces runs exactly once around the domain.
std::optional<std::string> ConstrainedTriangulation::find_orientation_fault() const {
  const mesh::TriangleMesh& mesh = topology();
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const mesh::Face f{i};
    if (!mesh.is_live(f)) continue;
    const mesh::HalfEdge h = mesh::first(f);
    if (triangulation_.is_ghost_face(h)) continue;
    if (triangulation_.orientation(mesh.origin(h), mesh.target(h), mesh.apex(h)) != exact::Sign::positive) {
      return "face " + std::to_string(i) + " is not counter-clockwise";
    }
  }
  // The neighbours of the ghost vertex are the vertices on the border. Clockwise around the ghost vertex means
  // counter-clockwise around the domain.
  std::size_t corner = 0;
  const auto& corners = triangulation_.domain_corners();
  mesh::HalfEdge h = mesh.find(triangulation_.ghost(), corners[0]);
  if (h == mesh::kNoHalfEdge) return "a corner of the domain is not on the border";
  do {
    h = mesh.previous_around(h);
    const mesh::Vertex v = mesh.target(h);
    const mesh::Vertex from = corners[corner];
    const mesh::Vertex to = corners[(corner + 1) % 4];
    if (v == to) {
      if (++corner == 4) break;
    } else if (triangulation_.orientation(from, to, v) != exact::Sign::zero) {
      return "vertex " + std::to_string(number(v)) + " on the border is not on the domain's side";
    }
  } while (mesh.target(h) != corners[0]);
  return corner == 4 ? std::nullopt : std::optional<std::string>("the border misses a corner of the domain");
}

std::optional<std::string> ConstrainedTriangulation::find_delaunay_fault() const {
  const mesh::TriangleMesh& mesh = topology();
  for (std::uint32_t i = 0; i < mesh.face_slots() * 3; ++i) {
    const mesh::HalfEdge h{i};
    if (!mesh.is_live(mesh::face(h)) || h > mesh.twin(h) || triangulation_.is_ghost_face(h)) continue;
    if (triangulation_.is_ghost_face(mesh.twin(h))) {
      if (!mesh.is_fixed(h)) return edge_name(mesh, h) + " on the border is not fixed";
    } else if (!mesh.is_fixed(h) && !triangulation_.is_legal(h)) {
      return edge_name(mesh, h) + " is neither fixed nor Delaunay";
    }
  }
  return std::nullopt;
}

// Follows every side from end to end over the edges that list it. The lists of the edges must not have more entries
// than these edges.
std::optional<std::string> ConstrainedTriangulation::find_use_fault() const {
  const mesh::TriangleMesh& mesh = topology();
  std::size_t uses_by_edges = 0;
  for (std::uint32_t i = 0; i < mesh.face_slots() * 3; ++i) {
    const mesh::HalfEdge h{i};
    if (!mesh.is_live(mesh::face(h)) || h > mesh.twin(h)) continue;
    uses_.for_each(mesh.label(h), [&](std::uint32_t) { ++uses_by_edges; });
  }
  std::size_t uses_by_sides = 0;
  std::vector<std::uint32_t> slots;
  const auto append = [&](std::uint32_t item) {
    items_.for_each_side(item, [&](std::uint32_t side) { slots.push_back(side); });
  };
  append(ItemTable::kDomain);
  for (const ItemId id : items_.ids()) append(items_.slot(id));
  for (const std::uint32_t slot : slots) {
    const Side& side = items_.side(slot);
    const std::size_t edges = count_edges(slot);
    if (edges == 0) {
      return "a side of item " + std::to_string(items_.id(side.item).value) + " does not reach its end over its edges";
    }
    uses_by_sides += edges;
  }
  if (uses_by_edges != uses_by_sides) return "edges name sides that do not run over them";
  return std::nullopt;
}

std::size_t ConstrainedTriangulation::count_edges(std::uint32_t slot) const {
  const mesh::TriangleMesh& mesh = topology();
  const Side& side = items_.side(slot);
  const bool ascends = triangulation_.comes_before(side.from, side.to);
  std::size_t edges = 0;
  for (mesh::Vertex u = side.from; u != side.to; ++edges) {
    mesh::HalfEdge step = mesh::kNoHalfEdge;
    mesh.for_each_outgoing(u, [&](mesh::HalfEdge h) {
      if (!mesh.is_fixed(h) || triangulation_.comes_before(u, mesh.target(h)) != ascends) return;
      if (uses_.contains(mesh.label(h), slot)) step = h;
    });
    if (step == mesh::kNoHalfEdge) return 0;
    u = mesh.target(step);
    if (triangulation_.orientation(side.from, side.to, u) != exact::Sign::zero) return 0;
  }
  return edges;
}

// The corners of the items and the corner uses of the vertices must be the same pairs. A vertex without corner uses
// must be a crossing of sides.
std::optional<std::string> ConstrainedTriangulation::find_vertex_fault() const {
  const mesh::TriangleMesh& mesh = topology();
  using Corner = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Corner> by_items;
  Outline outline;
  const auto append = [&](std::uint32_t item) {
    items_.outline(item, outline);
    for (const mesh::Vertex v : outline.corners) by_items.emplace_back(number(v), item);
  };
  append(ItemTable::kDomain);
  for (const ItemId id : items_.ids()) append(items_.slot(id));
  std::vector<Corner> by_vertices;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const mesh::Vertex v{i};
    if (!mesh.is_live(v) || v == triangulation_.ghost()) continue;
    uses_.for_each(corner_uses_[i], [&](std::uint32_t item) { by_vertices.emplace_back(i, item); });
    if (corner_uses_[i] != UseLists::kNone) continue;
    std::size_t fixed_edges = 0;
    mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) { fixed_edges += mesh.is_fixed(h) ? 1 : 0; });
    if (fixed_edges <= 2) return "vertex " + std::to_string(i) + " is not needed: it has no corner and no crossing";
  }
  std::sort(by_items.begin(), by_items.end());
  std::sort(by_vertices.begin(), by_vertices.end());
  if (by_items != by_vertices) return "the corners at vertices are not the corners of items";
  return std::nullopt;
}

}  // namespace waywright::constraint
