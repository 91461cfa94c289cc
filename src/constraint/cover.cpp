#include "constraint/cover.hpp"

#include <algorithm>

namespace waywright::constraint {

namespace {

void insert_once(std::vector<std::uint32_t>& set, std::uint32_t value) {
  if (std::find(set.begin(), set.end(), value) == set.end()) set.push_back(value);
}

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

}  // namespace

void faces_at(const ExactTriangulation& triangulation, const locate::Located& place,
              std::vector<mesh::HalfEdge>& faces) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  faces.clear();
  if (place.spot == locate::Spot::vertex) {
    const mesh::HalfEdge start = first_neighbour(triangulation, mesh.origin(place.h));
    mesh::HalfEdge h = start;
    do {
      faces.push_back(h);
      h = mesh.next_around(h);
    } while (h != start);
  } else if (place.spot == locate::Spot::edge) {
    const bool ascends = delaunay.comes_before(mesh.origin(place.h), mesh.target(place.h));
    const mesh::HalfEdge left = ascends ? place.h : mesh.twin(place.h);
    faces = {left, mesh.twin(left)};
  } else {
    mesh::HalfEdge h = place.h;
    for (const mesh::HalfEdge side : {mesh::next(place.h), mesh::previous(place.h)}) {
      if (delaunay.comes_before(mesh.origin(side), mesh.origin(h))) h = side;
    }
    faces.push_back(h);
  }
  std::erase_if(faces, [&](mesh::HalfEdge h) { return delaunay.is_ghost_face(h); });
}

// A polygon covers a face when a way from there to beyond the domain crosses an odd number of its sides. The way goes
// through faces around vertices that come ever earlier in (x, y) order, to the domain's first corner and out: every
// other vertex has an earlier neighbour, so no way is shorter to describe or surer to end.
const std::vector<std::uint32_t>& Cover::of_face(const ExactTriangulation& triangulation, mesh::HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  odd_.clear();
  if (!triangulation.items().has_polygons()) return odd_;
  while (!delaunay.is_ghost_face(h)) {
    const mesh::Vertex v = mesh.origin(h);
    const bool is_last = v == delaunay.box_corners()[0];
    const mesh::Vertex towards = is_last ? delaunay.ghost() : mesh.target(first_neighbour(triangulation, v));
    while (mesh.target(h) != towards) {
      toggle(triangulation, mesh::previous(h));
      h = mesh.next_around(h);
    }
    if (!is_last) h = mesh::next(h);
  }
  return odd_;
}

void Cover::toggle(const ExactTriangulation& triangulation, mesh::HalfEdge crossed) {
  triangulation.for_each_side(crossed, [&](const Side& side) {
    if (!triangulation.items().is_polygon(side.item)) return;
    const auto found = std::find(odd_.begin(), odd_.end(), side.item);
    if (found == odd_.end()) {
      odd_.push_back(side.item);
    } else {
      *found = odd_.back();
      odd_.pop_back();
    }
  });
}

void Cover::collect_touching(const ExactTriangulation& triangulation, const locate::Located& place) {
  touching_.clear();
  const auto collect_side = [&](const Side& side) {
    if (triangulation.items().is_polygon(side.item)) insert_once(touching_, side.item);
  };
  if (place.spot == locate::Spot::edge) triangulation.for_each_side(place.h, collect_side);
  if (place.spot != locate::Spot::vertex) return;
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const mesh::Vertex v = mesh.origin(place.h);
  mesh.for_each_outgoing(v, [&](mesh::HalfEdge h) { triangulation.for_each_side(h, collect_side); });
  triangulation.uses().for_each(triangulation.corner_uses(v), [&](std::uint32_t item) {
    if (triangulation.items().is_polygon(item)) insert_once(touching_, item);
  });
}

const std::vector<std::uint32_t>& Cover::of_place(const ExactTriangulation& triangulation,
                                                  const locate::Located& place) {
  covering_.clear();
  if (!triangulation.items().has_polygons()) return covering_;
  collect_touching(triangulation, place);
  faces_at(triangulation, place, around_);
  covering_ = touching_;
  // A polygon with no side here covers one of the faces around the place when it covers them all.
  for (const std::uint32_t item : of_face(triangulation, around_.front())) insert_once(covering_, item);
  return covering_;
}

bool Cover::is_strictly_inside(const ExactTriangulation& triangulation, const locate::Located& place) {
  collect_touching(triangulation, place);
  faces_at(triangulation, place, around_);
  const std::vector<std::uint32_t>& covering = of_face(triangulation, around_.front());
  return std::any_of(covering.begin(), covering.end(), [&](std::uint32_t item) {
    return std::find(touching_.begin(), touching_.end(), item) == touching_.end();
  });
}

const std::vector<mesh::HalfEdge>& Cover::open_faces(const ExactTriangulation& triangulation,
                                                     const locate::Located& place) {
  faces_at(triangulation, place, around_);
  open_.clear();
  for (const mesh::HalfEdge h : around_) {
    if (!is_covered(triangulation, h)) open_.push_back(h);
  }
  return open_;
}

}  // namespace waywright::constraint
