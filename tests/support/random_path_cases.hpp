#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "waywright/point.hpp"
#include "waywright/scene.hpp"

#include "support/random_scenes.hpp"

namespace waywright::test {

/// The obstacles in a scene made for paths.
enum class Obstacles : std::uint8_t {
  boxes,      ///< axis-parallel and rotated rectangles, and triangles, which touch and overlap
  walls,      ///< single walls, many of which touch or cross
  polylines,  ///< chains of walls, open and closed
  tiles,      ///< blocked tiles of a grid: shared sides, corners that touch, rings that visit a corner twice
  mixture,    ///< all of these
  rounds,     ///< convex polygons with many corners among a mixture
};

inline constexpr std::array kObstacles{Obstacles::boxes, Obstacles::walls,   Obstacles::polylines,
                                       Obstacles::tiles, Obstacles::mixture, Obstacles::rounds};

[[nodiscard]] std::string_view to_string(Obstacles obstacles);
[[nodiscard]] std::optional<Obstacles> obstacles_of(std::string_view name);

struct Ends {
  Point start;
  Point goal;
};

/// A scene and the path queries for it.
struct PathCase {
  Scene scene;
  std::vector<Ends> queries;
};

/// Returns 10 to 60 items, and path queries. A third of their ends are corners of items, so that some paths start and
/// end on walls. The result is the same on every platform for the same arguments.
[[nodiscard]] PathCase random_path_case(Obstacles obstacles, std::uint64_t seed, std::size_t query_count);
/// Returns a random scene, whose items are full of degeneracies, with path queries as above.
[[nodiscard]] PathCase random_path_case(Flavour flavour, std::uint64_t seed, std::size_t item_count,
                                        std::size_t query_count);

}  // namespace waywright::test
