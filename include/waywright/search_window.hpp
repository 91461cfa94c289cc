#pragma once

#include "waywright/path.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// @addtogroup paths
/// @{

/// A window that a search has followed: an element of PathSearch::windows. A window is the piece of an edge of the mesh
/// that is visible from its *root*, through the triangles that the search has crossed. The root is the start of the
/// path, or a turn of the path.
///
/// For each window, the search enters one triangle. The windows of several roots can lie beside each other on one edge,
/// if the roots are consecutive turns of one path, for example around the corners of a convex obstacle. (The first of
/// these roots may be the start of the path.) The search may enter the triangle with all these windows in one step. The
/// windows of such a step follow each other in the list. Usually the triangle lies beyond the edge, as seen from the
/// root. Directly after a turn, it lies between the root and the edge: the root is one of its vertices, and the edge is
/// opposite to this vertex.
///
/// The coordinates are rounded: use them only for pictures. The search itself decides exactly, without these
/// coordinates. The ends of the interval are the positions where two rays from the root meet the edge. If a ray is
/// nearly parallel to the edge, so that doubles cannot express where they meet, then the end of the edge on the same
/// side (left or right) is the end of the interval.
struct SearchWindow {
  Point root;           ///< the last turn of the path, or its start
  Portal edge;          ///< the whole edge; left and right as seen from the root
  Portal interval;      ///< the piece of the edge that is visible from the root
  double length = 0.0;  ///< the length of the path from the start to the root
  double bound = 0.0;   ///< up to rounding, no path through the window to the goal is shorter than this

  friend bool operator==(const SearchWindow&, const SearchWindow&) = default;
};

/// @}

}  // namespace waywright
