#pragma once

#include "constraint/constrained_triangulation.hpp"

namespace waywright::constraint {
using ExactTriangulation = ConstrainedTriangulation;
}
