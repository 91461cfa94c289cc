#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"

#include "delaunay/polygon_triangles.hpp"
#include "delaunay/tie_rule.hpp"
#include "exact/sign.hpp"

namespace waywright::delaunay {

/// Triangulates the cavity that the removal of a vertex with many neighbours leaves. The border of the cavity, seen
/// from the lifted vertex, is a convex polygon. The new faces are the facets of the convex hull of the lifted border
/// that face the vertex. So in-circle tests and the order along the border decide everything, as in a triangulation of
/// a convex polygon.
///
/// The class inserts the vertices of the border in random order. Each insertion removes the triangles whose circle
/// contains the new vertex. The first of them is known: it lies on the edge between the two neighbours of the new
/// vertex in the polygon. Cost: expected linear in the number of border vertices.
///
/// Source: Chew, *Building Voronoi diagrams for convex polygons in linear expected time*, Dartmouth 1990.
template <class Geometry>
class LargeCavity {
 public:
  using View = typename Geometry::View;
  using Triangle = mesh::TriangleMesh::Triangle;

  /// Fills `triangles` with the triangles of the cavity; each comes after the triangle on whose edge it lies, and the
  /// first one lies on the base. `positions` are the positions of the border's vertices, counter-clockwise. The base
  /// runs from the last of them to the first. `seed` decides in which order the function inserts the vertices
  /// (InsertionOrder::reset()). Requires: three or more positions.
  void triangulate(const Geometry& geometry, std::span<const View> positions, std::uint64_t seed,
                   std::vector<Triangle>& triangles) {
    const auto replaces = [&](Index h, Index p) { return is_in_circle(geometry, positions, h, p); };
    triangles_.triangulate(positions.size(), seed, {}, replaces, triangles);
  }

  void count_memory(MemoryUse& use) const { triangles_.count_memory(use); }
  void release() { triangles_.release(); }

 private:
  using Index = PolygonTriangles::Index;

  /// Whether the circle of the triangle of `h` contains `p`. Seen from the removed vertex, every triangle is
  /// counter-clockwise. In the plane it can be clockwise, and then "contains" means the outside of the circle. The sign
  /// of the determinant is right for both. In a tie, one of the four lifted points is lowered: see tie_rule.hpp.
  [[nodiscard]] bool is_in_circle(const Geometry& geometry, std::span<const View> positions, Index h, Index p) const {
    const View& a = positions[triangles_.origin(h)];
    const View& b = positions[triangles_.target(h)];
    const View& c = positions[triangles_.apex(h)];
    const View& d = positions[p];
    const exact::Sign sign = geometry.in_circle(a, b, c, d);
    if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
    const bool comes_first = geometry.order(d, a) < 0 && geometry.order(d, b) < 0 && geometry.order(d, c) < 0;
    if (comes_first) return geometry.orientation(a, b, c) == exact::Sign::positive;
    return tied_circle_contains(geometry, a, b, c, d);
  }

  PolygonTriangles triangles_;
};

}  // namespace waywright::delaunay
