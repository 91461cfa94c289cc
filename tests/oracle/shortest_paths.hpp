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

/// The lengths of a point agent's shortest paths through a scene, between some places named beforehand: Dijkstra's
/// algorithm on an exact visibility graph of the items themselves; there is no triangulation. A node is a vertex in one
/// of the *wedges* that the walls at it leave free, so no path changes from one wedge to another through a point where
/// walls meet. Decisions are exact; lengths are sums in long double between nearest doubles.
/// Source: Lozano-Pérez and Wesley, *An algorithm for planning collision-free paths among polyhedral obstacles*, 1979.
class ShortestPaths {
 public:
  /// Requires: the scene is one for Oracle, the ends lie in its domain and range too.
  ShortestPaths(OracleScene scene, const std::vector<OraclePoint>& ends);
  ~ShortestPaths();
  ShortestPaths(ShortestPaths&&) noexcept;
  ShortestPaths& operator=(ShortestPaths&&) noexcept;

  /// Requires: both are among the ends. Cost: up to O(n^2) pairs of vertices, each against all walls, once.
  [[nodiscard]] ShortestPath between(OraclePoint start, OraclePoint goal);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace waywright::oracle
