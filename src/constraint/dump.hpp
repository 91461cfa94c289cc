#pragma once

#include <string>

#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// Returns the mesh as canonical text, with its coordinates as reduced fractions: see World::dump.
[[nodiscard]] std::string dump(const ExactTriangulation& triangulation);

}  // namespace waywright::constraint
