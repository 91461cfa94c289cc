#pragma once

#include <cstddef>

#include "waywright/point.hpp"

namespace waywright::constraint {

/// Calls visit(point) for each corner of a ring. Consecutive points that are equal are one corner. In a closed ring,
/// the last points are one corner with the first point if they are equal to it. The function adds 0 to each coordinate,
/// which changes -0 into 0. So equal points have equal bits.
template <class Ring, class Visit>
void for_each_corner(const Ring& ring, bool is_closed, Visit&& visit) {
  std::size_t end = ring.size();
  while (is_closed && end > 1 && ring[end - 1] == ring[0]) --end;
  for (std::size_t i = 0; i < end; ++i) {
    if (i == 0 || ring[i] != ring[i - 1]) visit(Point{ring[i].x + 0.0, ring[i].y + 0.0});
  }
}

/// The number of corners that for_each_corner visits.
template <class Ring>
[[nodiscard]] std::size_t count_corners(const Ring& ring, bool is_closed) {
  std::size_t count = 0;
  for_each_corner(ring, is_closed, [&](const Point&) { ++count; });
  return count;
}

}  // namespace waywright::constraint
