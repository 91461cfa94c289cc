#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>

#include "waywright/point.hpp"

#include "delaunay/triangulation.hpp"
#include "exact/geometry.hpp"
#include "mesh/index.hpp"

namespace waywright::test {

/// The corners of a face as points, ascending.
using FaceCorners = std::array<std::pair<double, double>, 3>;

inline FaceCorners face_corners(const Point& a, const Point& b, const Point& c) {
  FaceCorners corners = {std::pair{a.x, a.y}, {b.x, b.y}, {c.x, c.y}};
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The faces in the domain.
inline std::set<FaceCorners> faces_of(const delaunay::Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto point = [&](mesh::Vertex v) { return triangulation.geometry().rounded(number(v)); };
  std::set<FaceCorners> faces;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!triangulation.is_in_domain(mesh::Face{f})) continue;
    const mesh::HalfEdge h = mesh::first(mesh::Face{f});
    faces.insert(face_corners(point(mesh.origin(h)), point(mesh.target(h)), point(mesh.apex(h))));
  }
  return faces;
}

}  // namespace waywright::test
