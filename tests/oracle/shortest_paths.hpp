#pragma once

#include <memory>
#include <vector>

#include "oracle/oracle.hpp"

namespace waywright::oracle {

enum class OracleStatus : std::uint8_t { found, start_blocked, goal_blocked, no_path };

struct ShortestPath {
  OracleStatus status = OracleStatus::no_path;
  double length = 0.0;  ///< Euclidean; 0 unless found
};

/// Computes the lengths of a point agent's shortest paths through a scene, between given points. Uses Dijkstra's
/// algorithm on an exact visibility graph of the items themselves, without a triangulation. A node is a vertex in one
/// of the *wedges*, the free areas between the walls at that vertex. So no path changes from one wedge to another
/// through a point where walls meet. Decisions are exact; lengths are sums in long double between nearest doubles.
/// Source: Lozano-Pérez and Wesley, *An algorithm for planning collision-free paths among polyhedral obstacles*, 1979.
class ShortestPaths {
 public:
  /// Requires: Oracle accepts the scene, and the ends lie in the scene's domain and in the range of coordinates.
  ShortestPaths(OracleScene scene, const std::vector<OraclePoint>& ends);
  ~ShortestPaths();
  ShortestPaths(ShortestPaths&&) noexcept;
  ShortestPaths& operator=(ShortestPaths&&) noexcept;

  /// Returns the shortest path between two of the ends. Requires: both are among the ends. Cost: up to O(n^2) pairs of
  /// vertices, each against all walls, once.
  [[nodiscard]] ShortestPath between(OraclePoint start, OraclePoint goal);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace waywright::oracle
