#include "clearance/disc_reach.hpp"

#include "exact/gap.hpp"

namespace waywright::clearance {

void DiscReach::begin(const Cells& cells, const CellEdge& goal, double radius) {
  radius_ = radius;
  states_.grow_to(cells.key_count());
  stamp_.next(4, states_);
  from_goal_.clear();
  enter(cells, goal, State::reached, from_goal_);
}

DiscReach::State DiscReach::state(const Cells& cells, const CellEdge& edge) const {
  const std::uint32_t entry = states_[cells.key(edge)];
  return entry < stamp_.value() ? State::unknown : static_cast<State>(entry - stamp_.value());
}

/// Gives a cell its state, and appends its wide gates to `gates`.
void DiscReach::enter(const Cells& cells, const CellEdge& edge, State state, std::vector<CellEdge>& gates) {
  CellEdge at = edge;
  do {
    set_state(cells.key(at), state);
    if (state == State::entered) entered_.push_back(cells.key(at));
    if (at.is_gate() && exact::compare_to_diameter(cells.gap(at), radius_) >= 0) gates.push_back(at);
    at = cells.next(at);
  } while (at != edge);
}

/// Sets the final state of all cells that the search from a cell has entered.
void DiscReach::finish(State state) {
  for (const std::uint32_t key : entered_) set_state(key, state);
  if (state == State::reached) from_goal_.insert(from_goal_.end(), from_cell_.begin(), from_cell_.end());
}

bool DiscReach::is_reached(const Cells& cells, const CellEdge& edge) {
  const State known = state(cells, edge);
  if (known != State::unknown) return known == State::reached;
  entered_.clear();
  from_cell_.clear();
  enter(cells, edge, State::entered, from_cell_);
  while (!from_cell_.empty() && !from_goal_.empty()) {
    const CellEdge out = cells.across(from_cell_.back());
    from_cell_.pop_back();
    const State beyond = state(cells, out);
    if (beyond == State::reached) {
      finish(State::reached);
      return true;
    }
    if (beyond == State::unknown) enter(cells, out, State::entered, from_cell_);
    const CellEdge in = cells.across(from_goal_.back());
    from_goal_.pop_back();
    const State found = state(cells, in);
    if (found == State::entered) {
      finish(State::reached);
      return true;
    }
    if (found == State::unknown) enter(cells, in, State::reached, from_goal_);
  }
  // If the search from the goal has ended first, the other search may have entered only some of the cells that are
  // connected with its first cell. A later call for one of the others enters only that cell, and returns false, too.
  finish(State::not_reached);
  return false;
}

}  // namespace waywright::clearance
