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

}  // namespace

Narrowest WidestSearch::find(const Cells& cells, const CellEdge& start, const CellEdge& goal) {
  visited_.grow_to(cells.key_count());
  stamp_.next(1, visited_);
  open_.clear();
  if (enter(cells, start, goal, nullptr)) return {true, std::nullopt};
  const auto is_less = [&](const Entry& p, const Entry& q) {
    return is_shorter(cells, p.narrowest, p.length, q.narrowest, q.length);
  };
  std::make_heap(open_.begin(), open_.end(), is_less);
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), is_less);
    const Entry entry = open_.back();
    open_.pop_back();
    const CellEdge beyond = cells.across(entry.gate);
    if (visited_[cells.key(beyond)] == stamp_.value()) continue;
    const std::size_t count = open_.size();
    if (enter(cells, beyond, goal, &entry)) return {true, entry.narrowest};
    for (std::size_t i = count; i < open_.size(); ++i) {
      std::push_heap(open_.begin(), open_.begin() + static_cast<std::ptrdiff_t>(i) + 1, is_less);
    }
  }
  return {};
}

/// Enters the cell of `from`, and appends its gates to `open_`. Returns whether it is the cell of `goal`.
bool WidestSearch::enter(const Cells& cells, const CellEdge& from, const CellEdge& goal, const Entry* before) {
  CellEdge edge = from;
  do {
    if (edge == goal) return true;
    if (edge.is_gate()) {
      visited_[cells.key(edge)] = stamp_.value();
      const double length = exact::length(cells.gap(edge));
      const bool is_narrowest = before == nullptr || is_shorter(cells, edge, length, before->narrowest, before->length);
      open_.push_back({edge, is_narrowest ? edge : before->narrowest, is_narrowest ? length : before->length});
    }
    edge = cells.next(edge);
  } while (edge != from);
  return false;
}

}  // namespace waywright::clearance
