#pragma once

#include <algorithm>
#include <cmath>

#include "waywright/path.hpp"

#include "world/ellipse_bucket.hpp"
#include "world/path_slack.hpp"

namespace waywright {

/// A box that contains the ellipse.
inline Box bounds_of(const Ellipse& ellipse) {
  constexpr double kBeyondAllDomains = 2 * kLargestCoordinate;
  if (ellipse.length > kBeyondAllDomains) {
    return {{-kBeyondAllDomains, -kBeyondAllDomains}, {kBeyondAllDomains, kBeyondAllDomains}};
  }
  // Half the extent of the ellipse in one axis, if the foci differ by `other` in the other axis.
  const auto half_extent = [&](double other) {
    return 0.5 * std::sqrt(std::max(ellipse.length - other, 0.0) * (ellipse.length + other));
  };
  const Point& start = ellipse.start;
  const Point& goal = ellipse.goal;
  const Point centre = 0.5 * (start + goal);
  const Point across{half_extent(std::abs(goal.y - start.y)), half_extent(std::abs(goal.x - start.x))};
  return Box{centre - across, centre + across}.expanded(ellipse.reach + slack_of(start, goal));
}

/// Returns the ellipse that contains each shorter path. If the search has moved an end, the ellipse also contains each
/// position that is nearer to the end in the query than the moved end is. Suppose that the search has moved the start
/// from `s` to `t`, by the distance d. If a position p is nearer to `s` than `t` is, then p is at most d away from `s`,
/// and at most d + d + length away from the goal. So the sum of the two distances is at most the length of the path
/// plus 3 d, and this is Ellipse::length.
inline Ellipse ellipse_of(const Path& path) {
  const bool has_points = !path.points.empty();
  if (path.status != PathStatus::found || (!has_points && path.pieces.empty())) return {};
  Ellipse ellipse;
  ellipse.start = has_points ? path.points.front() : path.pieces.front().from;
  ellipse.goal = has_points ? path.points.back() : path.pieces.back().to;
  double moved = 0.0;
  const auto move_back = [&](Point& end, const MovedEnd& moved_end) {
    moved += distance(moved_end.from, moved_end.to);
    end = moved_end.from;
  };
  if (path.moved_start) move_back(ellipse.start, *path.moved_start);
  if (path.moved_goal) move_back(ellipse.goal, *path.moved_goal);
  // The length is a sum of rounded lengths. The last term covers the rounding of up to 4 million turns.
  const double largest = std::max(largest_coordinate(ellipse.start), largest_coordinate(ellipse.goal));
  ellipse.length = path.length + 3.0 * moved + 0x1p-30 * (path.length + largest);
  ellipse.reach = path.agent.radius * (1.0 + 0x1p-30);
  return ellipse;
}

}  // namespace waywright
