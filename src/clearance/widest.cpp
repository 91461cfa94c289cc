#include "clearance/widest.hpp"

#include <algorithm>
#include <limits>

#include "clearance/walls.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

namespace {

/// The order of the heap of open gates.
constexpr auto kIsFarther = [](const auto& p, const auto& q) { return p.squared_distance > q.squared_distance; };

}  // namespace

Narrowest WidestSearch::find(const Cells& cells, const CellEdge& start, const CellEdge& goal) {
  radius_.reset();
  begin_both(cells, start, goal);
  step(cells, std::numeric_limits<std::size_t>::max());
  return result_;
}

void WidestSearch::begin(const Cells& cells, const CellEdge& start, const CellEdge& goal, double radius) {
  radius_ = radius;
  begin_both(cells, start, goal);
}

void WidestSearch::begin_both(const Cells& cells, const CellEdge& start, const CellEdge& goal) {
  visited_.grow_to(cells.key_count());
  constexpr std::uint32_t kStamps = 2;
  stamp_.next(kStamps, visited_);
  begin(cells, searches_[0], goal, stamp_.value());
  begin(cells, searches_[1], start, stamp_.value() + 1);
  current_ = 0;
  has_ended_ = enter(cells, searches_[0], start, &goal);
  result_ = {has_ended_, std::nullopt};
  if (!has_ended_) (void)enter(cells, searches_[1], goal, nullptr);
}

bool WidestSearch::step(const Cells& cells, std::size_t count) {
  for (; !has_ended_ && count > 0; --count) {
    Search& search = searches_[current_];
    if (!has_gates(search)) {
      has_ended_ = true;
      break;
    }
    const CellEdge beyond = cells.across(pop(cells, search));
    const std::uint32_t visited = visited_[cells.key(beyond)];
    if (visited == searches_[1 - current_].stamp) {
      has_ended_ = true;
      result_.is_connected = true;
      if (const Search* narrower = search_with_narrower_level(cells)) result_.gate = narrower->level->edge;
      break;
    }
    if (visited != search.stamp) (void)enter(cells, search, beyond, nullptr);
    current_ = 1 - current_;
  }
  return has_ended_;
}

void WidestSearch::begin(const Cells& cells, Search& search, const CellEdge& target, std::uint32_t stamp) {
  search.target = cells.position_near(target);
  search.stamp = stamp;
  search.level.reset();
  search.open.clear();
  search.shorter.clear();
  search.entered.clear();
  search.entered_before_level = 0;
}

/// Removes the next gate to cross. If none is as long as the level, lowers the level. Requires: the search has gates.
CellEdge WidestSearch::pop(const Cells& cells, Search& search) {
  if (!search.open.empty()) {
    std::pop_heap(search.open.begin(), search.open.end(), kIsFarther);
    const CellEdge gate = search.open.back().edge;
    search.open.pop_back();
    return gate;
  }
  std::pop_heap(search.shorter.begin(), search.shorter.end(),
                [&](const MeasuredGate& p, const MeasuredGate& q) { return is_shorter(cells, p, q); });
  search.level = search.shorter.back();
  search.shorter.pop_back();
  search.entered_before_level = search.entered.size();
  return search.level->edge;
}

/// Enters the cell of `from` and looks at its gates. Returns whether `other_end` is an edge of this cell.
bool WidestSearch::enter(const Cells& cells, Search& search, const CellEdge& from, const CellEdge* other_end) {
  CellEdge edge = from;
  do {
    if (other_end != nullptr && edge == *other_end) return true;
    if (edge.is_gate()) {
      const std::uint32_t key = cells.key(edge);
      visited_[key] = search.stamp;
      search.entered.push_back(key);
      see(cells, search, edge);
    }
    edge = cells.next(edge);
  } while (edge != from);
  return false;
}

/// Adds a gate of a cell that the search has entered, unless the search has entered the cell beyond it, too.
void WidestSearch::see(const Cells& cells, Search& search, const CellEdge& gate) {
  if (visited_[cells.key(cells.across(gate))] == search.stamp) return;
  const exact::Gap gap = cells.gap(gate);
  if (!search.level && radius_ && exact::compare_to_diameter(gap, *radius_) >= 0) {
    search.open.push_back({gate, squared_length(search.target - gap.from)});
    std::push_heap(search.open.begin(), search.open.end(), kIsFarther);
    return;
  }
  const MeasuredGate seen{gate, exact::length(gap)};
  if (search.level && !is_shorter(cells, seen, *search.level)) {
    search.open.push_back({gate, squared_length(search.target - gap.from)});
    std::push_heap(search.open.begin(), search.open.end(), kIsFarther);
    return;
  }
  search.shorter.push_back(seen);
  std::push_heap(search.shorter.begin(), search.shorter.end(),
                 [&](const MeasuredGate& p, const MeasuredGate& q) { return is_shorter(cells, p, q); });
}

/// Returns the search with the shorter level, or null if no search has a level. This level is the narrowest gate on the
/// connection through the cell where the searches meet.
const WidestSearch::Search* WidestSearch::search_with_narrower_level(const Cells& cells) const {
  const std::optional<MeasuredGate>& a = searches_[0].level;
  const std::optional<MeasuredGate>& b = searches_[1].level;
  if (!a || !b) return a ? &searches_[0] : b ? &searches_[1] : nullptr;
  return is_shorter(cells, *a, *b) ? &searches_[0] : &searches_[1];
}

// When the search with the narrower level got this level, it had entered all cells that it could reach through longer
// gates. It has crossed only longer gates since, apart from the gate of the level. The other search has crossed only
// longer gates.
WidestSearch::Sides WidestSearch::sides(const Cells& cells) const {
  const Search& narrower = *search_with_narrower_level(cells);
  const Search& other = &narrower == &searches_[0] ? searches_[1] : searches_[0];
  const std::span<const std::uint32_t> keys = narrower.entered;
  const CellEdge beyond = cells.across(narrower.level->edge);
  return {{narrower.level->edge, keys.first(narrower.entered_before_level)},
          {{beyond, keys.subspan(narrower.entered_before_level)}, {beyond, other.entered}}};
}

namespace {

/// Sorts a list and removes repeated elements.
void keep_one_of_each(std::vector<ItemId>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

}  // namespace

void WidestGapFinder::find(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges,
                           NearWalls& near_walls, const Point& start, const Point& goal, WidestPath& result) {
  clear(result);
  const auto start_cell = near_walls.find_cell(triangulation, bridges, start);
  if (!start_cell) return;
  const auto goal_cell = near_walls.find_cell(triangulation, bridges, goal);
  if (!goal_cell) return;
  write_widest(triangulation, bridges, search_.find(Cells(triangulation, bridges), *start_cell, *goal_cell), result);
}

void clear(WidestPath& result) {
  result.is_connected = result.is_limited = false;
  result.radius = 0.0;
  result.from = result.to = {};
  result.from_items.clear();
  result.to_items.clear();
}

void write_widest(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges,
                  const Narrowest& narrowest, WidestPath& result) {
  clear(result);
  result.is_connected = narrowest.is_connected;
  if (!narrowest.is_connected) return;
  if (!narrowest.gate) {
    result.radius = std::numeric_limits<double>::infinity();
    return;
  }
  const Cells cells(triangulation, bridges);
  const CellEdge& gate = *narrowest.gate;
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Gap gap = cells.canonical_gap(gate);
  result.is_limited = true;
  result.radius = exact::largest_radius(gap);
  result.from = gap.from;
  result.to = exact::end_of(gap);
  const bool starts_at_origin =
      gap.from == triangulation.triangulation().geometry().rounded(number(mesh.origin(gate.h)));
  const mesh::Vertex from = starts_at_origin ? mesh.origin(gate.h) : mesh.target(gate.h);
  const mesh::Vertex to = starts_at_origin ? mesh.target(gate.h) : mesh.origin(gate.h);
  const auto add_to = [&](std::vector<ItemId>& ids) {
    return [&triangulation, &ids](std::uint32_t slot) { ids.push_back(triangulation.items().id(slot)); };
  };
  for_each_item_at(triangulation, from, add_to(result.from_items));
  if (gate.kind == CellEdge::Kind::bridge) {
    for_each_item_at(triangulation, to, add_to(result.to_items));
  } else {
    for_each_item_on(triangulation, bridges.wall_of(gate.foot), add_to(result.to_items));
  }
  keep_one_of_each(result.from_items);
  keep_one_of_each(result.to_items);
}

}  // namespace waywright::clearance
