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
  corner_uses_log_.clear();
}

// Each member has its own undo log and undoes its own changes without reading the other members.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::roll_back() {
  triangulation_.roll_back();
  items_.roll_back();
  uses_.roll_back();
  for (; !corner_uses_log_.empty(); corner_uses_log_.pop_back()) {
    const auto& [v, uses] = corner_uses_log_.back();
    corner_uses_[number(v)] = uses;
  }
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::count_memory(MemoryUse& use) const {
  triangulation_.count_memory(use);
  items_.count_memory(use);
  uses_.count_memory(use, &MemoryUse::walls);
  memory::count(use, &MemoryUse::vertices, corner_uses_);
  memory::count_spare(use, corner_uses_log_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::shrink_to_fit() {
  begin();  // empties all logs
  triangulation_.shrink_to_fit();
  items_.shrink_to_fit();
  uses_.shrink_to_fit();
  memory::shrink(corner_uses_);
  memory::release(corner_uses_log_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

template <class Geometry>
void ConstrainedTriangulation<Geometry>::set_corner_uses(mesh::Vertex v, Uses uses) {
  corner_uses_log_.emplace_back(v, corner_uses_[number(v)]);
  corner_uses_[number(v)] = uses;
}

/// Makes room for the list of every vertex. The list of a new vertex is empty.
template <class Geometry>
void ConstrainedTriangulation<Geometry>::grow_corner_uses() {
  if (corner_uses_.size() < topology().vertex_slots()) corner_uses_.resize(topology().vertex_slots(), UseLists::kNone);
}

}  // namespace waywright::constraint
