#include "constraint/cover.hpp"

#include <algorithm>

#include "constraint/slot_sets.hpp"

namespace waywright::constraint {

namespace {

/// The neighbour of `v` that comes first in (x, y) order, as the half-edge to it.
mesh::HalfEdge first_neighbour(const ExactTriangulation& triangulation, mesh::Vertex v) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  mesh::HalfEdge best = mesh::kNoHalfEdge;
  mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) {
    if (mesh.target(h) == delaunay.ghost()) return;
    if (best == mesh::kNoHalfEdge || delaunay.comes_before(mesh.target(h), mesh.target(best))) best = h;
  });
  return best;
}

/// The polygons of an edge's sides, one as often as it has sides there.
void append_polygons(const ExactTriangulation& triangulation, mesh::HalfEdge h, std::vector<std::uint32_t>& polygons) {
  triangulation.for_each_side(h, [&](const Side& side) {
    if (triangulation.items().is_polygon(side.item)) polygons.push_back(side.item);
  });
}

}  // namespace

void faces_at(const ExactTriangulation& triangulation, const locate::Located& place,
              std::vector<mesh::HalfEdge>& faces) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  faces.clear();
  const auto add = [&](mesh::HalfEdge h) {
    if (!delaunay.is_ghost_face(h)) faces.push_back(h);
  };
  if (place.spot == locate::Spot::vertex) {
    const mesh::HalfEdge start = first_neighbour(triangulation, mesh.origin(place.h));
    mesh::HalfEdge h = start;
    do {
      add(h);
      h = mesh.next_around(h);
    } while (h != start);
  } else if (place.spot == locate::Spot::edge) {
    const bool ascends = delaunay.comes_before(mesh.origin(place.h), mesh.target(place.h));
    const mesh::HalfEdge left = ascends ? place.h : mesh.twin(place.h);
    add(left);
    add(mesh.twin(left));
  } else {
    mesh::HalfEdge h = place.h;
    for (const mesh::HalfEdge side : {mesh::next(place.h), mesh::previous(place.h)}) {
      if (delaunay.comes_before(mesh.origin(side), mesh.origin(h))) h = side;
    }
    add(h);
  }
}

// A polygon covers a face when a way from there to beyond the domain crosses an odd number of its sides. The way goes
// through faces around vertices that come ever earlier in (x, y) order, to the domain's first corner and out: every
// other vertex has an earlier neighbour, so no way is shorter to describe or surer to end.
const std::vector<std::uint32_t>& Cover::of_face(const ExactTriangulation& triangulation, mesh::HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  crossed_.clear();
  if (!triangulation.items().has_polygons()) return crossed_;
  while (!delaunay.is_ghost_face(h)) {
    const mesh::Vertex v = mesh.origin(h);
    const bool is_last = v == delaunay.box_corners()[0];
    const mesh::Vertex towards = is_last ? delaunay.ghost() : mesh.target(first_neighbour(triangulation, v));
    while (mesh.target(h) != towards) {
      append_polygons(triangulation, mesh::previous(h), crossed_);
      h = mesh.next_around(h);
    }
    if (!is_last) h = mesh::next(h);
  }
  keep_odd(crossed_);
  return crossed_;
}

void Cover::collect_touching(const ExactTriangulation& triangulation, const locate::Located& place) {
  touching_.clear();
  if (place.spot == locate::Spot::edge) append_polygons(triangulation, place.h, touching_);
  if (place.spot == locate::Spot::vertex) {
    const mesh::TriangleMesh& mesh = triangulation.topology();
    const mesh::Vertex v = mesh.origin(place.h);
    mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) { append_polygons(triangulation, h, touching_); });
    triangulation.uses().for_each(triangulation.corner_uses(v), [&](std::uint32_t item) {
      if (triangulation.items().is_polygon(item)) touching_.push_back(item);
    });
  }
  keep_one_of_each(touching_);
}

const std::vector<std::uint32_t>& Cover::of_place(const ExactTriangulation& triangulation,
                                                  const locate::Located& place) {
  covering_.clear();
  if (!triangulation.items().has_polygons()) return covering_;
  collect_touching(triangulation, place);
  faces_at(triangulation, place, around_);
  // A polygon with no side here covers one of the faces around the place when it covers them all.
  covering_ = of_face(triangulation, around_.front());
  covering_.insert(covering_.end(), touching_.begin(), touching_.end());
  keep_one_of_each(covering_);
  return covering_;
}

const std::vector<std::uint32_t>& Cover::strictly_covering(const ExactTriangulation& triangulation,
                                                           const locate::Located& place) {
  collect_touching(triangulation, place);
  faces_at(triangulation, place, around_);
  covering_ = of_face(triangulation, around_.front());
  std::erase_if(covering_,
                [&](std::uint32_t item) { return std::binary_search(touching_.begin(), touching_.end(), item); });
  return covering_;
}

bool Cover::is_strictly_inside(const ExactTriangulation& triangulation, const locate::Located& place) {
  return !strictly_covering(triangulation, place).empty();
}

const std::vector<mesh::HalfEdge>& Cover::open_faces(const ExactTriangulation& triangulation,
                                                     const locate::Located& place) {
  faces_at(triangulation, place, open_);
  std::erase_if(open_, [&](mesh::HalfEdge h) { return is_covered(triangulation, h); });
  return open_;
}

}  // namespace waywright::constraint
