#pragma once

#include <cstddef>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/point.hpp"

namespace waywright::bench {

/// One timed operation: removes an item and inserts another. Either may be missing (its id is null).
struct Update {
  ItemId removed;
  Item inserted;
};

/// The updates that every contender performs: `before` is not timed, `updates` is. Always the same, from fixed seeds.
struct Workload {
  Box domain;
  std::vector<Item> before;
  std::vector<Update> updates;
};

/// Returns experiment 3 of Chen 2009: random whole points in ±8000, in random order.
[[nodiscard]] Workload thesis_points(std::size_t count);

/// Returns random points in the unit square with all 53 bits, in random order.
[[nodiscard]] Workload uniform_points(std::size_t count);

/// Returns the same points along a Hilbert curve, so that each lies near the one before.
[[nodiscard]] Workload sorted_points(std::size_t count);

/// Returns `row_length` x `row_length` points of a lattice. Every four neighbours lie on a circle. The rows run
/// alternately forth and back.
[[nodiscard]] Workload lattice_points(std::size_t row_length);

/// Returns the removal of half of `count` random whole points in 2^20, in random order.
[[nodiscard]] Workload point_removal(std::size_t count);

/// Returns axis-aligned segments of length 200 in ±8000, as in experiment 5 of Chen 2009.
[[nodiscard]] Workload short_segments(std::size_t count);

/// Returns axis-aligned segments across the whole square ±8000, as in experiment 5 of Chen 2009.
[[nodiscard]] Workload long_segments(std::size_t count);

/// Returns segments between random whole points in ±8000, as in experiment 5 of Chen 2009.
[[nodiscard]] Workload random_segments(std::size_t count);

/// The rotation of the square of experiment 6.
enum class Rotation : unsigned char {
  none,   ///< axis-aligned: its sides come to lie on walls
  by_45,  ///< whole corners, rational crossings
  by_30,  ///< corners are not whole numbers: 30 degrees have no rational sine and cosine
};

/// Returns experiment 6 of Chen 2009: in ±100,000 with nested squares every 10,000, a small square moves along the
/// diagonal by (10, 10) at each step, under one id.
[[nodiscard]] Workload moving_square(Rotation rotation, std::size_t steps);

/// How close the polygons of rts() are to each other.
enum class Crowd : unsigned char {
  overlapping,  ///< up to 8,000 from their centres: many overlap
  sparse,       ///< up to 2,000 from their centres: few overlap
  disjoint,     ///< up to 8,000 from their centres, and none touches another
};

/// Returns the updates of a real-time strategy game: 2,000 polygons of 4 to 8 corners in 2^20. Each step removes one of
/// them and inserts another at a random position.
[[nodiscard]] Workload rts(Crowd crowd, std::size_t steps);

/// Returns a segment between the ends of a narrow band of `count` random points. It crosses about half as many edges.
[[nodiscard]] Workload long_wall(std::size_t count);

/// Returns disjoint axis-aligned squares in a domain of 2^14, for path queries.
[[nodiscard]] Workload random_squares(std::size_t count);

/// Points in the unit square to locate among others, equally many of each.
struct PointsToLocate {
  std::vector<Point> points;   ///< the vertices
  std::vector<Point> targets;  ///< the points to locate, in order
};

/// Returns random points, in random order.
[[nodiscard]] PointsToLocate random_points_to_locate(std::size_t count);
/// Returns random points; the targets follow a Hilbert curve.
[[nodiscard]] PointsToLocate sorted_points_to_locate(std::size_t count);
/// Returns points in random order. Nine in ten of the vertices and of the targets lie in a hundredth of the square.
[[nodiscard]] PointsToLocate uneven_points_to_locate(std::size_t count);

/// Returns `count` segments, none of which touches another: one in each square of a lattice, in random order.
[[nodiscard]] Workload disjoint_segments(std::size_t count);

/// Returns random whole points of the workload's domain that lie in none of its items' bounding boxes.
[[nodiscard]] std::vector<Point> free_points(const Workload& workload, std::size_t count);

}  // namespace waywright::bench
