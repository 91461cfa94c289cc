#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace waywright::test {

/// The smallest triangulated box: a square with the corners a, b, c, d, counter-clockwise, divided along a - c, and the
/// ghost vertex connected to all four.
struct SquareMesh {
  mesh::TriangleMesh mesh;
  mesh::Vertex ghost{0}, a{1}, b{2}, c{3}, d{4};

  SquareMesh() {
    using mesh::Vertex;
    const std::array<std::array<Vertex, 3>, 6> faces = {{
        {a, b, c},
        {a, c, d},
        {b, a, ghost},
        {c, b, ghost},
        {d, c, ghost},
        {a, d, ghost},
    }};
    memory::Array<mesh::TriangleMesh::HalfEdgeRecord> half_edges;
    for (const auto& face : faces) {
      for (const Vertex v : face) half_edges.push_back({0, v});
    }
    const auto target = [&](std::uint32_t h) { return half_edges[h - h % 3 + (h + 1) % 3].origin; };
    for (std::uint32_t g = 0; g < half_edges.size(); ++g) {
      for (std::uint32_t h = 0; h < half_edges.size(); ++h) {
        if (half_edges[g].origin == target(h) && half_edges[h].origin == target(g)) half_edges[g].twin = h;
      }
    }
    mesh = mesh::TriangleMesh(std::move(half_edges), 5);
  }
};

}  // namespace waywright::test
