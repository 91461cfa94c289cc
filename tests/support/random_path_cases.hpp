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

/// What stands in the way in a scene made for paths.
enum class Obstacles : std::uint8_t {
  boxes,      ///< rectangles upright and askew, and triangles, which touch and overlap
  walls,      ///< loose walls, many of which touch or cross
  polylines,  ///< chains of walls, open and closed
  cells,      ///< blocked cells of a grid: sides shared, corners that touch, rings that pinch themselves
  mixture,    ///< of all of these
};

inline constexpr std::array kObstacles{Obstacles::boxes, Obstacles::walls, Obstacles::polylines, Obstacles::cells,
                                       Obstacles::mixture};

[[nodiscard]] std::string_view to_string(Obstacles obstacles);
[[nodiscard]] std::optional<Obstacles> obstacles_of(std::string_view name);

struct Ends {
  Point start;
  Point goal;
};

/// A scene and the paths asked for in it.
struct PathCase {
  Scene scene;
  std::vector<Ends> queries;
};

/// 10 to 60 items, and paths between places that are corners of items a third of the time, so that some start and end
/// on walls. The same everywhere for the same arguments.
[[nodiscard]] PathCase random_path_case(Obstacles obstacles, std::uint64_t seed, std::size_t query_count);
/// The same for a random scene, whose items are full of degeneracies.
[[nodiscard]] PathCase random_path_case(Flavour flavour, std::uint64_t seed, std::size_t item_count,
                                        std::size_t query_count);

}  // namespace waywright::test
