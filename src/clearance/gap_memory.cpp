#include "clearance/gap_memory.hpp"

#include <algorithm>
#include <utility>

#include "exact/gap.hpp"

namespace waywright::clearance {

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

}  // namespace waywright::clearance
