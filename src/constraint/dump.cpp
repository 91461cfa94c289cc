#include "constraint/dump.hpp"

#include "constraint/canonical.hpp"
#include "exact/crossing.hpp"

namespace waywright::constraint {

std::string dump(const constraint::ExactTriangulation& triangulation) {
  constraint::CanonicalOrder order;
  MeshSnapshot snapshot;
  constraint::take_snapshot(triangulation, order, snapshot);
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
