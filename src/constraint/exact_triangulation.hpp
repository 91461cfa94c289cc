#pragma once

#include "constraint/constrained_triangulation.hpp"
