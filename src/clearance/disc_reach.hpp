#pragma once

#include <cstdint>
#include <vector>

#include "clearance/cells.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// Finds the cells from which a disc can move to a goal: the cells that are connected with the cell of the goal by
/// gates that are not shorter than the diameter (*wide* gates). Use one object for many queries, because it keeps its
/// memory.
class DiscReach {
 public:
  /// Starts with the cell of the goal. Requires: until the last call of is_reached(), the mesh and the bridges of
  /// `cells` exist and do not change.
  void begin(const Cells& cells, const CellEdge& goal, double radius);
  /// Returns whether the disc can move from the cell of `edge` to the goal. The decision is exact. Cost: two searches
  /// run alternately, one from the goal and one from the cell. They stop when they meet, or when one of them has
  /// entered all cells that it can reach. The object keeps the state of each entered cell, so no later call for the
  /// same goal enters this cell again: a call for one of its edges costs O(1).
  [[nodiscard]] bool is_reached(const Cells& cells, const CellEdge& edge);

 private:
  /// What the searches know about a cell. All edges of a cell have the same state.
  enum class State : std::uint8_t {
    unknown,
    reached,      ///< the disc can move from the cell to the goal
    not_reached,  ///< the disc cannot move from the cell to the goal
    entered,      ///< the present search from a cell has entered the cell, and the result is not known yet
  };

  [[nodiscard]] State state(const Cells& cells, const CellEdge& edge) const;
  void set_state(std::uint32_t key, State state) { states_[key] = stamp_.value() + static_cast<std::uint32_t>(state); }
  void enter(const Cells& cells, const CellEdge& edge, State state, std::vector<CellEdge>& gates);
  void finish(State state);

  double radius_ = 0.0;
  memory::ZeroedArray<std::uint32_t> states_;  ///< by key of an edge: the number of the query, plus the state
  memory::Stamp stamp_;
  std::vector<CellEdge> from_goal_;     ///< wide gates of reached cells that the search has not crossed yet
  std::vector<CellEdge> from_cell_;     ///< the same for the cells that the search from the cell has entered
  std::vector<std::uint32_t> entered_;  ///< the keys with the state `entered`
};

}  // namespace waywright::clearance
