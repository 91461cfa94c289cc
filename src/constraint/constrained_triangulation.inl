#pragma once

// The definitions of ConstrainedTriangulation's members, for the source files that instantiate it or its member
// templates.

#include "constraint/bulk.inl"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/find_fault.inl"
#include "constraint/insert_item.inl"
#include "constraint/operation.inl"
#include "constraint/remove_item.inl"
#include "delaunay/triangulation.inl"
