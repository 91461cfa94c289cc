#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "waywright/point.hpp"

#include "clearance/bridges.hpp"
#include "clearance/cells.hpp"
#include "clearance/gap_memory.hpp"
#include "clearance/near_walls.hpp"
#include "clearance/widest.hpp"
#include "clearance/widest_gap.hpp"
#include "constraint/exact_triangulation.hpp"

namespace waywright::clearance {

/// Decides exactly whether a disc can move from one position to another, beside another search for its path. The caller
/// decides how much work the object does, and when. If the disc cannot move to the goal, the object finds the gap that
/// stops it. Use one object for many queries: it remembers which gaps have stopped discs, as long as the bridges do not
/// change.
class DiscPassage {
 public:
  /// Starts a decision. Requires: the disc fits at both positions; `state` is the number of the bridges
  /// (Clearance::state()); the triangulation and the bridges exist and do not change until the decision ends. Cost:
  /// O(1).
  void begin(const constraint::ExactTriangulation& triangulation, const Bridges& bridges, std::uint64_t state,
             const Point& start, const Point& goal, double radius);
  /// Returns whether an earlier decision in this state knows a gap that is too narrow for the disc.
  [[nodiscard]] bool may_remember() const { return memory_.may_refuse(radius_); }
  /// Returns whether an earlier decision shows that the disc cannot move to the goal. Cost: find_cell() for both ends.
  [[nodiscard]] bool remembers_refusal(NearWalls& near_walls);
  /// Searches: crosses up to `count` gates. Returns whether the search is certain that the disc can move to the goal,
  /// or that it cannot. The result is nothing as long as this is not known.
  [[nodiscard]] std::optional<bool> search(NearWalls& near_walls, std::size_t count);
  /// Finds the gap that limits the discs that can move to the goal. If it stops this disc, remembers it.
  void find_gap(NearWalls& near_walls, WidestGap& gap);

 private:
  [[nodiscard]] Cells cells() const { return {*triangulation_, *bridges_}; }
  [[nodiscard]] bool find_cells(NearWalls& near_walls);
  [[nodiscard]] bool begin_search(NearWalls& near_walls);

  const constraint::ExactTriangulation* triangulation_ = nullptr;
  const Bridges* bridges_ = nullptr;
  Point start_;
  Point goal_;
  double radius_ = 0.0;
  bool knows_cells_ = false;  ///< whether the code has looked for the cells of the two ends
  bool has_begun_ = false;    ///< whether `search_` has begun
  std::optional<CellEdge> start_cell_;
  std::optional<CellEdge> goal_cell_;
  std::optional<Narrowest> known_;  ///< the answer, if the memory knows it
  WidestSearch search_;
  GapMemory memory_;
};

}  // namespace waywright::clearance
