#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include "clearance/cells.hpp"
#include "exact/gap.hpp"

namespace waywright::clearance {

/// A gate, with its length in doubles.
struct MeasuredGate {
  CellEdge edge;
  double length;
};

/// Compares the lengths of two gates exactly. Doubles decide if the lengths differ by more than the rounding errors.
/// Positions decide between gates of equal length, so that the answer does not depend on the order in which a search
/// sees them.
[[nodiscard]] inline bool is_shorter(const Cells& cells, const MeasuredGate& p, const MeasuredGate& q) {
  constexpr double kRoundingMargin = 0x1p-40;
  if (std::abs(p.length - q.length) > kRoundingMargin * std::max(p.length, q.length)) return p.length < q.length;
  const auto order = exact::compare_lengths(cells.gap(p.edge), cells.gap(q.edge));
  if (order != 0) return order < 0;
  const exact::Gap p_gap = cells.canonical_gap(p.edge);
  const exact::Gap q_gap = cells.canonical_gap(q.edge);
  const auto key = [](const exact::Gap& gap) {
    return std::tie(gap.from.x, gap.from.y, gap.a.x, gap.a.y, gap.b.x, gap.b.y);
  };
  return key(p_gap) < key(q_gap);
}

}  // namespace waywright::clearance
