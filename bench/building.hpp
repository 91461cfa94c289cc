#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/point.hpp"

#include "random.hpp"

namespace waywright::bench {

/// Returns a regular polygon at a random position and angle in a square. `corner` is the least corner of the square.
inline Shape random_building(Random& random, const Point& corner, double square_size, std::size_t corner_count) {
  constexpr double kFullCircle = 6.283185307179586;
  const double radius = 8 + 16 * random.unit();
  const double play = square_size - 2 * radius;
  const Point centre = corner + Point{radius + play * random.unit(), radius + play * random.unit()};
  const double first = random.unit();
  std::vector<Point> ring;
  for (std::size_t i = 0; i < corner_count; ++i) {
    const double angle = kFullCircle * (first + static_cast<double>(i) / static_cast<double>(corner_count));
    ring.push_back(centre + Point{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return Shape::polygon(ring);
}

}  // namespace waywright::bench
