#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "support/disc_oracle.hpp"

namespace waywright::test::disc {

/// The motion of a disc: its centre moves straight from `from` to `to`.
struct Motion {
  Point from;
  Point to;
  double radius = 0.0;
};

/// A moment of a motion: the exact fraction whole - sqrt(square) of the length of the motion.
struct Moment {
  Rational whole;
  Rational square;
};

/// Returns the first moment at which the distance from the centre to the wall is at most the radius, or nothing. The
/// square of this distance is a quadratic function of the time, in three pieces: while the first end, the inside or the
/// second end of the wall is nearest. Requires: the ends of the wall differ.
[[nodiscard]] std::optional<Moment> first_moment(const Motion& motion, const std::pair<Point, Point>& wall);

/// Returns -1, 0 or 1: the first moment is earlier, equal or later.
[[nodiscard]] int compare(const Moment& p, const Moment& q);

/// The walls that a moving disc touches first.
struct FirstTouch {
  std::vector<std::size_t> walls;  ///< ascending; empty if the disc touches none
  Point centre;
  std::vector<Point> contacts;  ///< for each of the walls, its position that is nearest to the centre
};

/// Returns the first touch: brute force over all walls.
[[nodiscard]] FirstTouch first_touch(const Walls& walls, const Motion& motion);

}  // namespace waywright::test::disc
