#pragma once

#include <cstddef>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::bench {

/// One timed operation: an item goes, another comes. Either may be missing (its id is null).
struct Update {
  ItemId removed;
  Item inserted;
};

/// What every contender does: `before` off the clock, `updates` on it. Always the same, from fixed seeds.
struct Workload {
  Box domain;
  std::vector<Item> before;
  std::vector<Update> updates;
};

/// Chen 2009, experiment 3: random whole points in ±8000, in random order.
[[nodiscard]] Workload thesis_points(std::size_t count);

/// Random points in the unit square with all 53 bits, in random order.
[[nodiscard]] Workload uniform_points(std::size_t count);

/// The same points along a Hilbert curve, so that each lies near the one before.
[[nodiscard]] Workload sorted_points(std::size_t count);

/// `side` x `side` points of a lattice, every four neighbours on a circle, in rows that run to and fro.
[[nodiscard]] Workload lattice_points(std::size_t side);

/// Half of `count` random whole points in 2^20 go, in random order.
[[nodiscard]] Workload point_removal(std::size_t count);

/// Chen 2009, experiment 5: axis-aligned segments of length 200 in ±8000.
[[nodiscard]] Workload short_segments(std::size_t count);

/// Chen 2009, experiment 5: axis-aligned segments from one side of ±8000 to the other.
[[nodiscard]] Workload long_segments(std::size_t count);

/// Chen 2009, experiment 5: segments between random whole points in ±8000.
[[nodiscard]] Workload random_segments(std::size_t count);

/// How the square of experiment 6 lies.
enum class Turn : unsigned char {
  none,   ///< axis-aligned: its sides come to lie on walls
  by_45,  ///< whole corners, rational crossings
  by_30,  ///< corners are no whole numbers: 30 degrees have no rational sine and cosine
};

/// Chen 2009, experiment 6: in ±100,000 with nested squares every 10,000 a small square moves along the diagonal by
/// (10, 10), under one id.
[[nodiscard]] Workload moving_square(Turn turn, std::size_t steps);

/// How the polygons of rts() lie.
enum class Crowd : unsigned char {
  overlapping,  ///< up to 8,000 from their centres: many overlap
  sparse,       ///< up to 2,000 from their centres: few overlap
  disjoint,     ///< up to 8,000 from their centres, and none touches another
};

/// A real-time strategy game: 2,000 polygons of 4 to 8 corners in 2^20; each step one of them goes and another comes at
/// a random place.
[[nodiscard]] Workload rts(Crowd crowd, std::size_t steps);

/// A wall between the ends of a narrow band of `count` random points. It crosses about half as many edges.
[[nodiscard]] Workload long_wall(std::size_t count);

/// Disjoint axis-aligned squares in a domain of 2^14, what paths are asked for in.
[[nodiscard]] Workload random_squares(std::size_t count);

/// Places in the unit square to be found among others, as many of each.
struct Locations {
  std::vector<Point> points;   ///< the vertices
  std::vector<Point> targets;  ///< what is asked for, in order
};

/// Random places, in random order.
[[nodiscard]] Locations random_locations(std::size_t count);
/// The same, the targets along a Hilbert curve.
[[nodiscard]] Locations sorted_locations(std::size_t count);
/// In random order; of the vertices and of the targets nine in ten crowd into a hundredth of the square.
[[nodiscard]] Locations uneven_locations(std::size_t count);

/// `count` segments, none of which touches another: one in each cell of a lattice, in random order.
[[nodiscard]] Workload disjoint_segments(std::size_t count);

/// Random whole points of the workload's domain that lie in none of its items' bounding boxes.
[[nodiscard]] std::vector<Point> free_points(const Workload& workload, std::size_t count);

}  // namespace waywright::bench
