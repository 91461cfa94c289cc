#pragma once

#include <string>

#include "constraint/exact_triangulation.hpp"

namespace waywright::constraint {

/// The mesh as canonical text, its coordinates as reduced fractions: see World::dump.
[[nodiscard]] std::string dump(const ExactTriangulation& triangulation);

}  // namespace waywright::constraint
