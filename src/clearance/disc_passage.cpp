#include "clearance/disc_passage.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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

void GapMemory::use(const Cells& cells, std::uint64_t state) {
  if (state == state_) return;
  state_ = state;
  labels_.grow_to(cells.key_count());
  clear();
}

void GapMemory::clear() {
  regions_.clear();
  shortest_ = std::numeric_limits<double>::infinity();
  stamp_.next(kMost + 1, labels_);
}

/// Returns the region of the cell of the edge. A cell without gates has none.
GapMemory::Id GapMemory::region_of(const Cells& cells, const CellEdge& edge) const {
  CellEdge at = edge;
  while (!at.is_gate()) {
    at = cells.next(at);
    if (at == edge) return kNone;
  }
  return region_of(cells.key(at));
}

/// Returns whether the gate of a region is shorter than the gate of another one. A region without a gate comes first.
bool GapMemory::has_shorter_gate(const Cells& cells, Id p, Id q) const {
  const Region& one = region(p);
  const Region& other = region(q);
  if (!one.gate || !other.gate) return !one.gate && other.gate;
  return is_shorter(cells, *one.gate, *other.gate);
}

/// Returns whether a region equals another one, or is known to lie in it.
bool GapMemory::is_inside(Id id, Id outer) const {
  while (id != kNone && id != outer) id = region(id).outer;
  return id == outer;
}

/// Returns the largest complete region that contains a cell of the region `from`, and does not contain a cell of the
/// region `to`. Larger regions have shorter gates.
GapMemory::Id GapMemory::barrier(Id from, Id to) const {
  Id found = kNone;
  for (; from != kNone; from = region(from).outer) {
    if (region(from).is_complete && !is_inside(to, from)) found = from;
  }
  return found;
}

GapMemory::Id GapMemory::find_region(const CellEdge& gate) const {
  const auto found = std::find_if(regions_.begin(), regions_.end(),
                                  [&](const Region& known) { return known.gate && known.gate->edge == gate; });
  return found == regions_.end() ? kNone : static_cast<Id>(found - regions_.begin()) + 1;
}

std::optional<GapMemory::Refusal> GapMemory::find(const Cells& cells, const CellEdge& start, const CellEdge& goal,
                                                  double radius) const {
  Id from = region_of(cells, start);
  Id to = region_of(cells, goal);
  const Id at_start = barrier(from, to);
  const Id at_goal = barrier(to, from);
  if (at_start == kNone && at_goal == kNone) return std::nullopt;
  Id narrowest = at_start;
  if (at_start == kNone || (at_goal != kNone && has_shorter_gate(cells, at_goal, at_start))) {
    narrowest = at_goal;
    std::swap(from, to);
  }
  const std::optional<MeasuredGate>& gate = region(narrowest).gate;
  if (!gate) return Refusal{true, {}};
  if (exact::compare_to_diameter(cells.gap(gate->edge), radius) >= 0) return std::nullopt;
  const Id beyond = find_region(cells.across(gate->edge));
  const bool is_known = beyond != kNone && is_inside(to, beyond);
  return Refusal{is_known, {true, gate->edge}};
}

void GapMemory::add(const Cells& cells, const WidestSearch& search) {
  constexpr std::size_t kMostPerSearch = 2;
  if (regions_.size() + kMostPerSearch > kMost) clear();
  if (!search.result().is_connected) return add_region(cells, std::nullopt, search.enclosed_keys(), true);
  const WidestSearch::Sides sides = search.sides(cells);
  const double length = exact::length(cells.gap(sides.complete.gate));
  add_region(cells, MeasuredGate{sides.complete.gate, length}, sides.complete.keys, true);
  for (const WidestSearch::Side& side : sides.others)
    add_region(cells, MeasuredGate{side.gate, length}, side.keys, false);
}

/// Adds cells to the region of a gate.
void GapMemory::add_region(const Cells& cells, const std::optional<MeasuredGate>& gate,
                           std::span<const std::uint32_t> keys, bool is_complete) {
  Id id = gate ? find_region(gate->edge) : kNone;
  if (id == kNone) {
    regions_.push_back({gate, kNone, false});
    id = static_cast<Id>(regions_.size());
    shortest_ = gate ? std::min(shortest_, gate->length * (1.0 - 0x1p-40)) : 0.0;
  }
  for (const std::uint32_t key : keys) put_into(cells, key, id);
  if (is_complete) regions_[id - 1].is_complete = true;
}

/// Puts the cell of a gate into a region. The regions that the memory knows around the cell stay nested.
void GapMemory::put_into(const Cells& cells, std::uint32_t key, Id id) {
  Id inner = region_of(key);
  if (inner == id) return;
  Region& added = regions_[id - 1];
  if (inner == kNone || has_shorter_gate(cells, inner, id)) {
    if (inner != kNone && added.outer == kNone) added.outer = inner;
    labels_[key] = stamp_.value() + id;
    return;
  }
  while (region(inner).outer != kNone && region(inner).outer != id &&
         !has_shorter_gate(cells, region(inner).outer, id)) {
    inner = region(inner).outer;
  }
  Id& outer = regions_[inner - 1].outer;
  if (outer == id) return;
  if (outer != kNone && added.outer == kNone) added.outer = outer;
  outer = id;
}

void DiscPassage::begin(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges,
                        const Point& start, const Point& goal, double radius) {
  triangulation_ = &triangulation;
  bridges_ = &bridges;
  start_ = start;
  goal_ = goal;
  radius_ = radius;
  knows_cells_ = false;
  has_begun_ = false;
  known_.reset();
  memory_.use(cells(), bridges.state());
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

void DiscPassage::find_gap(NearWalls& near_walls, WidestPath& gap) {
  clear(gap);
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
  write_widest(*triangulation_, *bridges_, *known_, gap);
}

}  // namespace waywright::clearance
