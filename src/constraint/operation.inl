#pragma once

#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"

namespace waywright::constraint {

template <class Geometry>
void ConstrainedTriangulation<Geometry>::begin() {
  triangulation_.begin();
  begin_records();
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::begin_records() {
  items_.begin();
  uses_.begin();
  corner_uses_.begin();
  new_walls_.begin();
}

// Each member has its own undo log and undoes its own changes without reading the other members.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::roll_back() {
  triangulation_.roll_back();
  items_.roll_back();
  uses_.roll_back();
  corner_uses_.roll_back();
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::count_memory(MemoryUse& use) const {
  triangulation_.count_memory(use);
  items_.count_memory(use);
  uses_.count_memory(use, &MemoryUse::walls);
  corner_uses_.count_memory(use, &MemoryUse::vertices);
  memory::count_spare(use, late_corners_, order_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::shrink_to_fit() {
  begin();  // empties all logs
  triangulation_.shrink_to_fit();
  items_.shrink_to_fit();
  uses_.shrink_to_fit();
  corner_uses_.shrink_to_fit();
  memory::release(late_corners_, order_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::set_corner_uses(mesh::Vertex v, Uses uses) {
  corner_uses_.write(number(v), uses);
}

/// Makes room for the list of every vertex. The list of a new vertex is empty.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::grow_corner_uses() {
  corner_uses_.grow_to(topology().vertex_slots(), UseLists::kNone);
}

}  // namespace waywright::constraint
