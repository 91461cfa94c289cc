#pragma once

#include <string>

namespace waywright {

/// @addtogroup world
/// @{

/// The answer of World::validate. The function checks the links between triangles; the orientation of each triangle;
/// that the triangles fill the domain and do not overlap; the constrained edges against the items; the empty-circle
/// property of each free edge, and which of two possible edges the mesh contains if four vertices lie on one circle;
/// and that the path abstraction and the bridges equal an abstraction and bridges that it builds anew from the mesh.
///
/// @code{.cpp}
/// const Validation validation = world.validate();
/// if (!validation.ok) std::puts(validation.fault.c_str());
/// @endcode
struct Validation {
  bool ok = true;
  std::string fault;  ///< the first fault; empty if `ok`
};

/// @}

}  // namespace waywright
