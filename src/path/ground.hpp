#pragma once

#include "clearance/bridges.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "nav/abstraction.hpp"

namespace waywright::path {

/// What the searches see of a world. Point agents move in the mesh of all items. Discs move in the mesh of the walls:
/// it is the same mesh or, if an item has a ring with one corner, another one.
struct Ground {
  const constraint::ConstrainedTriangulation& triangulation;  ///< of all items
  const nav::Abstraction* abstraction;                        ///< of `triangulation`, or null
  const constraint::ConstrainedTriangulation* walls;          ///< null if the world keeps no bridges
  const nav::Abstraction* abstraction_of_walls;               ///< of `walls`, or null
  const clearance::Bridges* bridges;                          ///< of `walls`, or null
};

}  // namespace waywright::path
