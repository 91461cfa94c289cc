#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "support/disc_oracle.hpp"
#include "support/random.hpp"

namespace waywright::test::disc {

/// A scene for paths of discs, with queries and radii to try.
struct NamedScene {
  std::string name;
  Box domain;
  Walls walls;                                   ///< without the sides of the domain; all within the domain
  std::vector<std::pair<Point, Point>> queries;  ///< start and goal
  std::array<double, 4> radii{};                 ///< ascending
};

/// Returns the walls of the scene and, after them, the four sides of the domain.
[[nodiscard]] Walls walls_of(const NamedScene& scene);

/// Returns the largest magnitude of a coordinate in the box.
[[nodiscard]] double largest_coordinate(const Box& box);

/// Returns scenes that are made to break implementations: bottlenecks between a vertex and a wall of a long alley,
/// gaps of exactly the diameter and of one unit in the last place more or less, combs, spirals, touching arcs, starts
/// in acute angles, rooms that a disc fills exactly. The coordinates are whole, decimal, huge (1e12) or tiny (1e-9).
/// The seed varies the sizes; the same seed gives the same scenes on every platform.
[[nodiscard]] std::vector<NamedScene> trap_scenes(std::uint64_t seed);
/// Returns the trap scenes that a test of all of them checks: in its fast form, every eleventh.
[[nodiscard]] std::vector<NamedScene> checked_trap_scenes(std::uint64_t seed);

enum class SceneKind : std::uint8_t {
  boxes,          ///< axis-parallel boxes on a grid of integers; they touch and overlap
  rotated_boxes,  ///< boxes in any direction
  segments,       ///< segments that cross
  polylines,      ///< chains of segments
  lattice,        ///< segments on a small lattice: many ties, T-junctions, overlaps, rectangles of four ends
  tiles,          ///< maps of tiles with steps of length 1; radii 0.25, 0.5, 1 and 1.5, ends at centres of tiles
  alleys,         ///< long walls, most of them nearly parallel, with ends near them
  touching,       ///< segments, most of them on a lattice; at most starts and goals, the disc touches the end of a wall
  mixture,        ///< all of these
};

inline constexpr std::array kSceneKinds{SceneKind::boxes,     SceneKind::rotated_boxes, SceneKind::segments,
                                        SceneKind::polylines, SceneKind::lattice,       SceneKind::tiles,
                                        SceneKind::alleys,    SceneKind::touching,      SceneKind::mixture};

[[nodiscard]] std::string_view to_string(SceneKind kind);

/// Returns a scene of 1 to 30 walls (60 of the kind `tiles`) with four queries and four radii. The radii are random
/// doubles, with two exceptions: one radius of about half of the scenes of the kinds `boxes` and `lattice` is half a
/// whole number, and the radii of `tiles` and `touching` are fixed multiples of 1/4.
[[nodiscard]] NamedScene random_scene(Random& random, SceneKind kind);

}  // namespace waywright::test::disc
