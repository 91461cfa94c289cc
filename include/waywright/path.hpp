#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "waywright/point.hpp"

namespace waywright {

/// How a path is searched for.
enum class PathAlgorithm : std::uint8_t {
  ta,       ///< triangulation A* (Demyen and Buro 2006): A* over triangles, then the funnel
  tra,      ///< triangulation reduction A*; not supported yet
  optimal,  ///< the shortest path there is; not supported yet
};

/// Asks for a path of a disc from start to goal.
struct PathQuery {
  Point start;
  Point goal;
  double radius = 0.0;  ///< of the agent, >= 0; only 0 is supported yet
  PathAlgorithm algorithm = PathAlgorithm::ta;
};

/// How a search ended. No path is an answer, not an error.
enum class PathStatus : std::uint8_t {
  found,
  start_blocked,  ///< the start lies strictly inside a polygon
  goal_blocked,   ///< the goal lies strictly inside a polygon
  no_path,        ///< both ends are free, and walls part them
};

/// The status as the world script prints it: `found`, `start-blocked`, `goal-blocked`, `no-path`.
[[nodiscard]] std::string_view to_string(PathStatus status);

/// A path and what finding it took. Reuse one object for many queries: its memory is kept.
struct Path {
  PathStatus status = PathStatus::no_path;
  double length = 0.0;         ///< Euclidean; 0 unless found
  std::vector<Point> points;   ///< from start to goal, the corners between them; empty unless found
  std::size_t expansions = 0;  ///< triangles entered by the search
};

}  // namespace waywright
