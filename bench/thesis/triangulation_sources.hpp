#pragma once

// All sources of the triangulation. A source file of this folder compiles them again over the geometry that the macro
// WAYWRIGHT_GEOMETRY names (delaunay/geometry.hpp). So that the classes differ from those of the library and of the
// other geometries, macros rename the two namespaces.

#include "constraint/bulk.cpp"
#include "constraint/constrained_triangulation.cpp"
#include "constraint/item_table.cpp"
#include "constraint/use_lists.cpp"
#include "delaunay/cavity_filler.cpp"
#include "delaunay/divide_and_conquer.cpp"
#include "delaunay/polygon_triangles.cpp"
#include "delaunay/triangulation.cpp"
