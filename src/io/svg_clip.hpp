#pragma once

#include <vector>

#include "waywright/point.hpp"

namespace waywright::io {

/// Cuts a segment to a closed box. Returns false if they have no point in common, or if a coordinate of the segment is
/// not finite. Does not change an end that lies inside the box. Source: Liang and Barsky, *A new concept and method for
/// line clipping*, 1984.
[[nodiscard]] bool clip_segment(const Box& box, Point& a, Point& b);

/// Cuts a ring to a box. The winding number of the ring around each point inside the box stays the same. Source:
/// Sutherland and Hodgman, *Reentrant polygon clipping*, 1974.
void clip_ring(const Box& box, std::vector<Point>& ring, std::vector<Point>& scratch);

}  // namespace waywright::io
