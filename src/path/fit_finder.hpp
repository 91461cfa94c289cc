#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/clearance.hpp"
#include "waywright/path.hpp"

#include "clearance/near_walls.hpp"
#include "clearance/nearest_fit.hpp"
#include "nav/abstraction.hpp"
#include "path/free_positions.hpp"
#include "path/ground.hpp"

namespace waywright::path {

/// Says whether an agent fits at a position, and finds the nearest position at which it fits. Use one object for many
/// queries, because it keeps its memory.
class FitFinder {
 public:
  /// Says what stops the agent at a position: a point agent, only polygons. Requires: the centre lies in the
  /// domain.
  void fit(const Ground& ground, const Point& centre, const Agent& agent, DiscFit& fit);
  /// Returns whether the disc fits at the position. If not, blockers() are the items that stop it.
  [[nodiscard]] bool fits(const Ground& ground, const Point& centre, const Agent& agent) {
    fit(ground, centre, agent, fit_);
    return fit_.fits;
  }
  [[nodiscard]] const std::vector<ItemId>& blockers() const { return fit_.items; }

  /// Answers World::nearest_fit(). Requires: the query has no error.
  void find_nearest(const Ground& ground, const NearestFitQuery& query, NearestFit& fit);

  /// Moves the ends of a query for a disc at which the disc does not fit. Returns whether it fits at both ends now. If
  /// not, writes to `path` which end is blocked. Requires: `path.blockers` is empty.
  [[nodiscard]] bool move_blocked_ends(const Ground& ground, PathQuery& query, Path& path);

  /// Returns the connected areas to which each point belongs, by number, ascending. An agent can move from one point to
  /// another if they have an area in common. A point on a wall can belong to several areas, a blocked point belongs to
  /// none. For a point agent, the areas are the components, so the world must keep its abstraction. For a disc, the
  /// number of an area is the index of its first point, and the world must keep its bridges.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> find_areas(const Ground& ground, std::span<const Point> points,
                                                                   const Agent& agent);

  /// Returns the edge of the cell that contains the position, or nothing if the position lies on a wall. Requires: the
  /// world keeps its bridges.
  [[nodiscard]] std::optional<clearance::CellEdge> find_cell(const Ground& ground, const Point& position) {
    return near_walls_.find_cell(*ground.walls, *ground.bridges, position);
  }
  [[nodiscard]] clearance::NearWalls& near_walls() { return near_walls_; }

 private:
  using Areas = std::vector<std::uint32_t>;

  [[nodiscard]] std::vector<Areas> find_areas_of_disc(const Ground& ground, std::span<const Point> points,
                                                      const Agent& agent);
  [[nodiscard]] std::optional<Point> find_nearest_of_disc(const Ground& ground, const NearestFitQuery& query);
  [[nodiscard]] std::optional<Point> find_nearest_free(const Ground& ground, const NearestFitQuery& query);
  [[nodiscard]] bool move_blocked_end(const Ground& ground, PathQuery& query, bool is_start,
                                      const std::optional<Point>& other, Path& path);
  [[nodiscard]] std::optional<Point> find_end(const Ground& ground, const PathQuery& query, const Point& end,
                                              const std::optional<Point>& other);

  nav::ComponentCoverFinder cover_finder_;
  clearance::NearWalls near_walls_;
  clearance::NearestFit nearest_fit_;
  FreePositions free_positions_;
  DiscFit fit_;
  std::vector<std::uint32_t> slots_;
  std::vector<mesh::HalfEdge> goal_faces_;
};

}  // namespace waywright::path
