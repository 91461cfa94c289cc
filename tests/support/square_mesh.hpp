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
    std::vector<mesh::TriangleMesh::Corner> corners;
    for (const auto& face : faces) {
      for (const Vertex v : face) corners.push_back({0, v});
    }
    const auto target = [&](std::uint32_t h) { return corners[h - h % 3 + (h + 1) % 3].origin; };
    for (std::uint32_t g = 0; g < corners.size(); ++g) {
      for (std::uint32_t h = 0; h < corners.size(); ++h) {
        if (corners[g].origin == target(h) && corners[h].origin == target(g)) corners[g].twin = h;
      }
    }
    mesh = mesh::TriangleMesh(corners, 5);
  }
};

}  // namespace waywright::test
