#include "constraint/cover_finder.hpp"

#include <algorithm>

#include "constraint/slot_sets.hpp"

namespace waywright::constraint {

namespace {

/// The half-edge from `v` to its neighbour that comes first in (x, y) order.
mesh::HalfEdge first_neighbour(const ConstrainedTriangulation& triangulation, mesh::Vertex v) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  mesh::HalfEdge best = mesh::kNoHalfEdge;
  mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) {
    if (mesh.target(h) == delaunay.ghost()) return;
    if (best == mesh::kNoHalfEdge || delaunay.comes_before(mesh.target(h), mesh.target(best))) best = h;
  });
  return best;
}

/// Appends the polygons whose sides lie on the edge of `h`, each once per side.
void append_polygons(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h,
                     std::vector<std::uint32_t>& polygons) {
  triangulation.for_each_side(h, [&](const Side& side) {
    if (triangulation.items().is_polygon(side.item)) polygons.push_back(side.item);
  });
}

/// Appends an entry for each polygon side on the edge: twice the polygon's slot, plus 1 if the side runs against `h`.
void append_directed(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h,
                     std::vector<std::uint32_t>& entries) {
  triangulation.for_each_side(h, [&](const Side& side) {
    if (!triangulation.items().is_polygon(side.item)) return;
    entries.push_back(2 * side.item + (runs_along(triangulation, side, h) ? 0 : 1));
  });
}

/// Replaces the entries of append_directed() by the polygons that cover the face. The winding number of a polygon is
/// the sum of its entries, and the fill rule says whether a polygon with this number covers the face.
void keep_covering(const ItemTable& items, std::vector<std::uint32_t>& entries) {
  std::sort(entries.begin(), entries.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size();) {
    const std::uint32_t polygon = entries[i] / 2;
    std::int32_t sum = 0;
    for (; i < entries.size() && entries[i] / 2 == polygon; ++i) sum += entries[i] % 2 == 0 ? 1 : -1;
    if (items.covers(polygon, sum)) entries[kept++] = polygon;
  }
  entries.resize(kept);
}

/// Goes from the face of `h` through faces to the outside of the domain. Calls visit(edge) for each edge that the
/// function crosses, with the half-edge in the face that it leaves. The function goes from face to face around a vertex
/// to the vertex's first neighbour in (x, y) order, then around this neighbour, and so on. At the domain's first corner
/// it leaves the domain. This ends, because every other vertex has a neighbour that comes before it. If `before` is a
/// vertex, the function ends as soon as it reaches a vertex that comes before it.
template <class Visit>
void leave_domain(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h, mesh::Vertex before, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  while (!delaunay.is_ghost_face(h)) {
    const mesh::Vertex v = mesh.origin(h);
    if (before != mesh::kNoVertex && delaunay.comes_before(v, before)) return;
    const bool is_last = v == delaunay.domain_corners()[0];
    const mesh::Vertex towards = is_last ? delaunay.ghost() : mesh.target(first_neighbour(triangulation, v));
    while (mesh.target(h) != towards) {
      visit(mesh::previous(h));
      h = mesh.next_around(h);
    }
    if (!is_last) h = mesh::next(h);
  }
}

}  // namespace

void faces_at(const ConstrainedTriangulation& triangulation, const locate::Located& location,
              std::vector<mesh::HalfEdge>& faces) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  faces.clear();
  const auto add = [&](mesh::HalfEdge h) {
    if (!delaunay.is_ghost_face(h)) faces.push_back(h);
  };
  if (location.kind == locate::LocatedKind::vertex) {
    const mesh::HalfEdge start = first_neighbour(triangulation, mesh.origin(location.h));
    mesh::HalfEdge h = start;
    do {
      add(h);
      h = mesh.next_around(h);
    } while (h != start);
  } else if (location.kind == locate::LocatedKind::edge) {
    const bool ascends = delaunay.comes_before(mesh.origin(location.h), mesh.target(location.h));
    const mesh::HalfEdge left = ascends ? location.h : mesh.twin(location.h);
    add(left);
    add(mesh.twin(left));
  } else {
    mesh::HalfEdge h = location.h;
    for (const mesh::HalfEdge other : {mesh::next(location.h), mesh::previous(location.h)}) {
      if (delaunay.comes_before(mesh.origin(other), mesh.origin(h))) h = other;
    }
    add(h);
  }
}

// The winding number of the face is the sum over the sides that leave_domain() crosses between the face and the outside
// of the domain. If all polygons are even-odd, the number of sides is enough.
const std::vector<std::uint32_t>& CoverFinder::of_face(const ConstrainedTriangulation& triangulation,
                                                       mesh::HalfEdge h) {
  crossed_.clear();
  if (!triangulation.items().has_polygons()) return crossed_;
  if (triangulation.items().has_nonzero_polygons()) {
    leave_domain(triangulation, h, mesh::kNoVertex,
                 [&](mesh::HalfEdge edge) { append_directed(triangulation, edge, crossed_); });
    keep_covering(triangulation.items(), crossed_);
  } else {
    leave_domain(triangulation, h, mesh::kNoVertex,
                 [&](mesh::HalfEdge edge) { append_polygons(triangulation, edge, crossed_); });
    keep_odd(crossed_);
  }
  return crossed_;
}

// The polygon contains no vertex that comes before its first corner. So the winding number is 0 in each face at such a
// vertex.
std::int32_t winding_number(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h, std::uint32_t polygon,
                            mesh::Vertex first_corner) {
  std::int32_t sum = 0;
  with_winding(triangulation, polygon, [&](const auto& winding) {
    leave_domain(triangulation, h, first_corner, [&](mesh::HalfEdge edge) { sum += winding.across(edge); });
  });
  return sum;
}

void CoverFinder::collect_touching(const ConstrainedTriangulation& triangulation, const locate::Located& location) {
  touching_.clear();
  if (location.kind == locate::LocatedKind::edge) append_polygons(triangulation, location.h, touching_);
  if (location.kind == locate::LocatedKind::vertex) {
    const mesh::TriangleMesh& mesh = triangulation.topology();
    const mesh::Vertex v = mesh.origin(location.h);
    mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) { append_polygons(triangulation, h, touching_); });
    triangulation.uses().for_each(triangulation.corner_uses(v), [&](std::uint32_t item) {
      if (triangulation.items().is_polygon(item)) touching_.push_back(item);
    });
  }
  keep_one_of_each(touching_);
}

const std::vector<std::uint32_t>& CoverFinder::of_location(const ConstrainedTriangulation& triangulation,
                                                           const locate::Located& location) {
  covering_.clear();
  if (!triangulation.items().has_polygons()) return covering_;
  collect_touching(triangulation, location);
  faces_at(triangulation, location, around_);
  // A polygon without a side or corner at this location covers either all faces around it or none.
  covering_ = of_face(triangulation, around_.front());
  covering_.insert(covering_.end(), touching_.begin(), touching_.end());
  keep_one_of_each(covering_);
  return covering_;
}

const std::vector<std::uint32_t>& CoverFinder::strictly_covering(const ConstrainedTriangulation& triangulation,
                                                                 const locate::Located& location) {
  collect_touching(triangulation, location);
  faces_at(triangulation, location, around_);
  covering_ = of_face(triangulation, around_.front());
  std::erase_if(covering_,
                [&](std::uint32_t item) { return std::binary_search(touching_.begin(), touching_.end(), item); });
  return covering_;
}

bool CoverFinder::is_strictly_inside(const ConstrainedTriangulation& triangulation, const locate::Located& location) {
  return !strictly_covering(triangulation, location).empty();
}

const std::vector<mesh::HalfEdge>& CoverFinder::open_faces(const ConstrainedTriangulation& triangulation,
                                                           const locate::Located& location) {
  faces_at(triangulation, location, open_);
  std::erase_if(open_, [&](mesh::HalfEdge h) { return is_covered(triangulation, h); });
  return open_;
}

}  // namespace waywright::constraint
