#include "clearance/widest.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "exact/gap.hpp"

namespace waywright::clearance {

namespace {

/// Compares the lengths of two gates exactly. Doubles decide if the lengths differ by more than the rounding errors.
/// Positions decide between gates of equal length, so that the answer does not depend on the order in which the search
/// sees them.
bool is_shorter(const Cells& cells, const CellEdge& p, double p_length, const CellEdge& q, double q_length) {
  constexpr double kRoundingMargin = 0x1p-40;
  if (std::abs(p_length - q_length) > kRoundingMargin * std::max(p_length, q_length)) return p_length < q_length;
  const auto order = exact::compare_lengths(cells.gap(p), cells.gap(q));
  if (order != 0) return order < 0;
  const exact::Gap p_gap = cells.canonical_gap(p);
  const exact::Gap q_gap = cells.canonical_gap(q);
  const auto key = [](const exact::Gap& gap) {
    return std::tie(gap.from.x, gap.from.y, gap.a.x, gap.a.y, gap.b.x, gap.b.y);
  };
  return key(p_gap) < key(q_gap);
}

/// The order of the heap of open gates.
constexpr auto kIsFarther = [](const auto& p, const auto& q) { return p.squared_distance > q.squared_distance; };

}  // namespace

Narrowest WidestSearch::find(const Cells& cells, const CellEdge& start, const CellEdge& goal) {
  visited_.grow_to(cells.key_count());
  constexpr std::uint32_t kStamps = 2;
  stamp_.next(kStamps, visited_);
  begin(cells, searches_[0], goal, stamp_.value());
  begin(cells, searches_[1], start, stamp_.value() + 1);
  if (enter(cells, searches_[0], start, &goal)) return {true, std::nullopt};
  (void)enter(cells, searches_[1], goal, nullptr);
  for (int current = 0; has_gates(searches_[current]); current = 1 - current) {
    Search& search = searches_[current];
    const CellEdge beyond = cells.across(pop(cells, search));
    const std::uint32_t visited = visited_[cells.key(beyond)];
    if (visited == searches_[1 - current].stamp) return narrower_level(cells);
    if (visited != search.stamp) (void)enter(cells, search, beyond, nullptr);
  }
  return {};
}

void WidestSearch::begin(const Cells& cells, Search& search, const CellEdge& target, std::uint32_t stamp) {
  search.target = cells.position_near(target);
  search.stamp = stamp;
  search.level.reset();
  search.open.clear();
  search.shorter.clear();
}

/// Removes the next gate to cross. If none is as long as the level, lowers the level. Requires: the search has gates.
CellEdge WidestSearch::pop(const Cells& cells, Search& search) {
  if (!search.open.empty()) {
    std::pop_heap(search.open.begin(), search.open.end(), kIsFarther);
    const CellEdge gate = search.open.back().edge;
    search.open.pop_back();
    return gate;
  }
  const auto is_less = [&](const Gate& p, const Gate& q) {
    return is_shorter(cells, p.edge, p.length, q.edge, q.length);
  };
  std::pop_heap(search.shorter.begin(), search.shorter.end(), is_less);
  search.level = search.shorter.back();
  search.shorter.pop_back();
  return search.level->edge;
}

/// Enters the cell of `from` and looks at its gates. Returns whether `other_end` is an edge of this cell.
bool WidestSearch::enter(const Cells& cells, Search& search, const CellEdge& from, const CellEdge* other_end) {
  CellEdge edge = from;
  do {
    if (other_end != nullptr && edge == *other_end) return true;
    if (edge.is_gate()) {
      visited_[cells.key(edge)] = search.stamp;
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
  const Gate seen{gate, exact::length(gap)};
  if (search.level && !is_shorter(cells, seen.edge, seen.length, search.level->edge, search.level->length)) {
    search.open.push_back({gate, squared_length(search.target - gap.from)});
    std::push_heap(search.open.begin(), search.open.end(), kIsFarther);
    return;
  }
  search.shorter.push_back(seen);
  std::push_heap(search.shorter.begin(), search.shorter.end(),
                 [&](const Gate& p, const Gate& q) { return is_shorter(cells, p.edge, p.length, q.edge, q.length); });
}

/// Returns the shorter of the two levels: the narrowest gate on the connection through the cell where the searches
/// meet.
Narrowest WidestSearch::narrower_level(const Cells& cells) const {
  const std::optional<Gate>& a = searches_[0].level;
  const std::optional<Gate>& b = searches_[1].level;
  if (!b) return {true, a->edge};
  if (!a) return {true, b->edge};
  return {true, is_shorter(cells, a->edge, a->length, b->edge, b->length) ? a->edge : b->edge};
}

}  // namespace waywright::clearance
