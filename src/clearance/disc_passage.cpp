#include "clearance/disc_passage.hpp"

#include <limits>

namespace waywright::clearance {

void DiscPassage::begin(const constraint::ExactTriangulation& triangulation, const Bridges& bridges,
                        std::uint64_t state, const Point& start, const Point& goal, double radius) {
  triangulation_ = &triangulation;
  bridges_ = &bridges;
  start_ = start;
  goal_ = goal;
  radius_ = radius;
  knows_cells_ = false;
  has_begun_ = false;
  known_.reset();
  memory_.use(cells(), state);
}

/// Finds the cells of the two ends. Returns whether both ends have one.
bool DiscPassage::find_cells(NearWalls& near_walls) {
  if (!knows_cells_) {
    start_cell_ = near_walls.find_cell(*triangulation_, *bridges_, start_);
    goal_cell_ = near_walls.find_cell(*triangulation_, *bridges_, goal_);
    knows_cells_ = true;
  }
  return start_cell_ && goal_cell_;
}

bool DiscPassage::remembers_refusal(NearWalls& near_walls) {
  if (!find_cells(near_walls)) return false;
  const auto refusal = memory_.find(cells(), *start_cell_, *goal_cell_, radius_);
  if (refusal && refusal->is_known) known_ = refusal->narrowest;
  return refusal.has_value();
}

/// Starts the search unless it has begun. Returns false if an end has no cell.
bool DiscPassage::begin_search(NearWalls& near_walls) {
  if (has_begun_) return true;
  if (!find_cells(near_walls)) return false;
  search_.begin(cells(), *start_cell_, *goal_cell_, radius_);
  has_begun_ = true;
  return true;
}

std::optional<bool> DiscPassage::search(NearWalls& near_walls, std::size_t count) {
  if (!begin_search(near_walls)) return std::nullopt;
  const bool has_ended = search_.step(cells(), count);
  if (search_.is_refused()) return false;
  return has_ended ? std::optional(true) : std::nullopt;
}

void DiscPassage::find_gap(NearWalls& near_walls, WidestGap& gap) {
  gap.clear();
  if (!known_ && memory_.may_refuse(radius_)) (void)remembers_refusal(near_walls);
  if (!known_) {
    if (!begin_search(near_walls)) return;
    search_.step(cells(), std::numeric_limits<std::size_t>::max());
    if (search_.is_refused()) {
      known_ = search_.result();
      memory_.add(cells(), search_);
    } else {
      known_ = search_.find(cells(), *start_cell_, *goal_cell_);
      has_begun_ = false;
    }
  }
  write_gap(*triangulation_, *bridges_, *known_, gap);
}

}  // namespace waywright::clearance
