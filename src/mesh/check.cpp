#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace waywright::mesh {

namespace {

std::string named(const char* what, std::uint32_t index) { return std::string(what) + ' ' + std::to_string(index); }

std::optional<std::string> find_fault_at(const TriangleMesh& mesh, HalfEdge h) {
  const HalfEdge t = mesh.twin(h);
  if (number(t) >= mesh.face_slots() * 3 || !mesh.is_live(face(t))) {
    return named("half-edge", number(h)) + " has no living twin";
  }
  if (t == h || mesh.twin(t) != h) return named("half-edge", number(h)) + " is not its twin's twin";
  if (mesh.origin(h) != mesh.target(t) || mesh.target(h) != mesh.origin(t)) {
    return named("half-edge", number(h)) + " and its twin join different vertices";
  }
  if (mesh.label(h) != mesh.label(t)) return named("half-edge", number(h)) + " and its twin carry different labels";
  const Vertex v = mesh.origin(h);
  if (number(v) >= mesh.vertex_slots() || !mesh.is_live(v)) {
    return named("half-edge", number(h)) + " starts at a dead vertex";
  }
  if (v == mesh.target(h)) return named("half-edge", number(h)) + " is a loop";
  return std::nullopt;
}

}  // namespace

// A closed surface in one piece is a sphere if V - E + F = 2. The loop around each vertex must contain all half-edges
// that start there; otherwise the faces at this vertex form more than one loop.
std::optional<std::string> TriangleMesh::find_fault() const {
  std::vector<std::uint32_t> degree(vertex_slots(), 0);
  std::size_t faces = 0;
  for (std::uint32_t i = 0; i < face_slots(); ++i) {
    const Face f{i};
    if (!is_live(f)) continue;
    ++faces;
    HalfEdge h = first(f);
    for (int corner = 0; corner < 3; ++corner, h = next(h)) {
      if (auto fault = find_fault_at(*this, h)) return fault;
      ++degree[number(origin(h))];
    }
  }
  if (faces != face_count()) return "the count of faces is wrong";
  std::size_t vertices = 0;
  for (std::uint32_t i = 0; i < vertex_slots(); ++i) {
    const Vertex v{i};
    if (!is_live(v)) continue;
    ++vertices;
    const HalfEdge start = outgoing(v);
    if (number(start) >= half_edges_.size() || origin(start) != v) return named("vertex", i) + " has no half-edge";
    std::uint32_t loop = 0;
    HalfEdge h = start;
    do {
      if (origin(h) != v || ++loop > degree[i]) return named("vertex", i) + " has a broken loop";
      h = next_around(h);
    } while (h != start);
    if (loop != degree[i]) return named("vertex", i) + " has more than one loop";
  }
  if (vertices != vertex_count()) return "the count of vertices is wrong";
  if (2 * vertices != faces + 4) return "the surface is no sphere: 2 V != F + 4";
  return std::nullopt;
}

}  // namespace waywright::mesh
