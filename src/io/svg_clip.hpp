#pragma once

#include <vector>

#include "waywright/point.hpp"

namespace waywright::io {

/// Cuts a segment to a closed box; false where they have no point in common, or the segment isn't finite. Ends inside
/// the box stay as they are. Source: Liang and Barsky, *A new concept and method for line clipping*, 1984.
[[nodiscard]] bool clip_segment(const Box& box, Point& a, Point& b);

/// Cuts a ring to a box. How often the ring winds around a place inside the box does not change. Source: Sutherland and
/// Hodgman, *Reentrant polygon clipping*, 1974.
void clip_ring(const Box& box, std::vector<Point>& ring, std::vector<Point>& scratch);

}  // namespace waywright::io
