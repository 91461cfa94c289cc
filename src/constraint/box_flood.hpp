#pragma once

#include <vector>

#include "constraint/box_test.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// Visits the faces of the domain that meet a closed box, and sometimes a few faces that only constructed vertices,
/// rounded onto the border of the box, connect with it. Calls reach(f) for a face when it arrives there: `reach`
/// returns whether this is the first time. Calls visit(h, meets) for each half-edge of these faces: `meets` says
/// whether the edge meets the box. Requires: a position of the box lies in the face of `start`, which is a face of the
/// domain. Overwrites `faces`.
template <class Reach, class Visit>
void flood_box(const ExactTriangulation& triangulation, const BoxTest& box, mesh::HalfEdge start,
               std::vector<mesh::HalfEdge>& faces, const Reach& reach, const Visit& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto arrive = [&](mesh::HalfEdge h) {
    if (!triangulation.triangulation().is_ghost_face(h) && reach(mesh::face(h))) faces.push_back(h);
  };
  faces.clear();
  arrive(start);
  while (!faces.empty()) {
    const mesh::HalfEdge face = faces.back();
    faces.pop_back();
    for (const mesh::HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) {
      const bool meets = box.meets(geometry.exact(number(mesh.origin(h))), geometry.exact(number(mesh.target(h))));
      visit(h, meets);
      if (meets) arrive(mesh.twin(h));
    }
  }
}

}  // namespace waywright::constraint
