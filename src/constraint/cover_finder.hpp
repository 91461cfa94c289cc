#pragma once

#include <cstdint>
#include <vector>

#include "constraint/constrained_triangulation.hpp"
#include "locate/walk.hpp"

namespace waywright::constraint {

/// Finds the polygons that cover a face or a location. Use one object for many queries, because it keeps its memory.
class CoverFinder {
 public:
  CoverFinder() = default;
  virtual ~CoverFinder() = default;
  CoverFinder(CoverFinder&&) noexcept = default;  // GCOVR_EXCL_LINE: std::optional requires it, but uses the assignment
  CoverFinder& operator=(CoverFinder&&) noexcept = default;

  /// The polygons, by slot, that cover the inside of the face of `h`, in no particular order. This implementation goes
  /// through faces to the domain's border, and its result is sorted. A subclass that stores the polygons of each face
  /// overrides it with a faster implementation.
  virtual const std::vector<std::uint32_t>& of_face(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h);

  /// Whether a polygon covers the inside of the face of `h`.
  virtual bool is_covered(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h) {
    return !of_face(triangulation, h).empty();
  }

  /// The polygons, by slot, that cover the location or have it on their boundary; each once, in no particular order.
  const std::vector<std::uint32_t>& of_location(const ConstrainedTriangulation& triangulation,
                                                const locate::Located& location);

  /// Whether the location lies strictly inside a polygon: the polygon covers it and has no side or corner there.
  bool is_strictly_inside(const ConstrainedTriangulation& triangulation, const locate::Located& location);

  /// The polygons, by slot, in whose interior the location lies; each once, in no particular order.
  const std::vector<std::uint32_t>& strictly_covering(const ConstrainedTriangulation& triangulation,
                                                      const locate::Located& location);

  /// The faces around the location that no polygon covers, each as one of its half-edges. If the location is a vertex,
  /// this half-edge starts there. If the location is an edge, the half-edge lies on that edge. If the location is a
  /// face, the half-edge starts at the vertex of the face that comes first in (x, y) order. The order of the faces
  /// depends only on the positions of the vertices and on the edges. At a vertex they are counter-clockwise, from its
  /// first neighbour in (x, y) order on. At an edge, directed in (x, y) order, the face on its left comes first.
  const std::vector<mesh::HalfEdge>& open_faces(const ConstrainedTriangulation& triangulation,
                                                const locate::Located& location);

 private:
  void collect_touching(const ConstrainedTriangulation& triangulation, const locate::Located& location);

  std::vector<std::uint32_t> crossed_;   ///< an entry for each side crossed; then the polygons that cover the face
  std::vector<std::uint32_t> touching_;  ///< the polygons with a side or corner at the location; ascending
  std::vector<std::uint32_t> covering_;
  std::vector<mesh::HalfEdge> around_;
  std::vector<mesh::HalfEdge> open_;
};

/// Finds the faces that meet at the location, by the half-edges and in the order that CoverFinder::open_faces
/// describes, without ghost faces.
void faces_at(const ConstrainedTriangulation& triangulation, const locate::Located& location,
              std::vector<mesh::HalfEdge>& faces);

/// The winding number of the polygon in the face of `h`. For an even-odd polygon only its parity counts. The function
/// crosses the same edges as CoverFinder::of_face. If `first_corner` is the polygon's first corner in (x, y) order, the
/// function does not go to the border of the domain: it ends as soon as it reaches a vertex that comes before this
/// corner in (x, y) order.
[[nodiscard]] std::int32_t winding_number(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h,
                                          std::uint32_t polygon, mesh::Vertex first_corner = mesh::kNoVertex);

// The winding number of a polygon in a face: how many times its rings go around the face. Across an edge, the number
// changes by the polygon's sides on the edge. For an even-odd polygon only the parity of the number counts, and every
// side changes the parity, whatever its direction. So the code never reads the directions of the sides of an even-odd
// polygon.

/// The winding numbers of one polygon; for an even-odd polygon only their parity counts. Each fill rule has its own
/// code, because most polygons are even-odd and their code is faster.
template <FillRule rule>
class Winding {
 public:
  /// Requires: `rule` is the fill rule of the polygon.
  Winding(const ConstrainedTriangulation& triangulation, std::uint32_t polygon)
      : triangulation_(triangulation), polygon_(polygon) {}

  [[nodiscard]] std::uint32_t polygon() const { return polygon_; }

  /// Whether the polygon covers a face in which it has this winding number.
  [[nodiscard]] static bool covers(std::int32_t winding_number) { return is_filled(rule, winding_number); }

  /// The winding number in the face of `h` minus the winding number in the face of the twin of `h`.
  [[nodiscard]] std::int32_t across(mesh::HalfEdge h) const {
    std::int32_t change = 0;
    triangulation_.for_each_side(h, [&](const Side& side) {
      if (side.item != polygon_) return;
      if constexpr (rule == FillRule::even_odd) {
        change ^= 1;
      } else {
        change += runs_along(triangulation_, side, h) ? 1 : -1;
      }
    });
    return change;
  }

  /// Whether the winding number changes across the edge. If it does not, the polygon covers both faces or neither.
  [[nodiscard]] bool changes_across(mesh::HalfEdge h) const { return covers(across(h)); }

 private:
  const ConstrainedTriangulation& triangulation_;
  std::uint32_t polygon_;
};

/// Calls visit(winding) with the Winding of a polygon. Returns the result.
template <class Visit>
auto with_winding(const ConstrainedTriangulation& triangulation, std::uint32_t polygon, Visit&& visit) {
  if (triangulation.items().fill(polygon) == FillRule::even_odd) {
    return visit(Winding<FillRule::even_odd>(triangulation, polygon));
  }
  return visit(Winding<FillRule::nonzero>(triangulation, polygon));
}

}  // namespace waywright::constraint
