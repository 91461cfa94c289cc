#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clearance/cells.hpp"
#include "clearance/measured_gate.hpp"
#include "clearance/widest.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// Remembers which gaps have stopped discs, so that it can refuse the next disc without a search. It forgets everything
/// when the bridges change.
///
/// A *region* belongs to a gate of one of its cells: it consists of this cell, and of all cells that are connected with
/// it by gates that are longer than this gate. If no gate that leads away from a region is longer than its gate, no
/// disc that is wider than the gate leaves the region. Two regions are disjoint, or one of them contains the other:
/// then the gate of the outer region is shorter. So the regions form a forest. For each cell, the memory stores the
/// smallest region to which the cell is known to belong.
class GapMemory {
 public:
  /// Forgets everything unless `state` is the state of the last call. Different states of bridges have different
  /// numbers (Clearance::state()).
  void use(const Cells& cells, std::uint64_t state);
  /// Returns whether the memory knows a gap that is too narrow for the disc. Without such a gap, find() finds nothing.
  [[nodiscard]] bool may_refuse(double radius) const { return radius > 0.5 * shortest_; }

  struct Refusal {
    /// Whether the memory knows the gate that stops the disc, or that the cells are not connected.
    bool is_known = false;
    Narrowest narrowest;
  };
  /// Returns nothing unless it is certain that the disc cannot move from one cell to the other. Requires: use() has
  /// been called for the present state. Cost: linear in the edges on the borders of the two cells, and in the number of
  /// regions around them.
  [[nodiscard]] std::optional<Refusal> find(const Cells& cells, const CellEdge& start, const CellEdge& goal,
                                            double radius) const;
  /// Remembers what a search for a disc has found out. Requires: use() has been called for the present state; the
  /// search has ended, and it has refused the disc. Cost: linear in the cells that the search has entered.
  void add(const Cells& cells, const WidestSearch& search);

 private:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0;
  static constexpr Id kMost = 255;  ///< regions; when there are more, the memory forgets all

  struct Region {
    std::optional<MeasuredGate> gate;  ///< nothing if no gate leads away from the region
    Id outer;                          ///< the smallest region around it that the memory knows, or kNone
    bool is_complete;                  ///< whether the memory knows all cells of the region
  };

  void clear();
  [[nodiscard]] Id region_of(std::uint32_t key) const {
    return labels_[key] > stamp_.value() ? labels_[key] - stamp_.value() : kNone;
  }
  [[nodiscard]] Id region_of(const Cells& cells, const CellEdge& edge) const;
  [[nodiscard]] const Region& region(Id id) const { return regions_[id - 1]; }
  [[nodiscard]] bool has_shorter_gate(const Cells& cells, Id p, Id q) const;
  [[nodiscard]] bool is_inside(Id id, Id outer) const;
  [[nodiscard]] Id barrier(Id from, Id to) const;
  [[nodiscard]] Id find_region(const CellEdge& gate) const;
  void add_region(const Cells& cells, const std::optional<MeasuredGate>& gate, std::span<const std::uint32_t> keys,
                  bool is_complete);
  void put_into(const Cells& cells, std::uint32_t key, Id id);

  std::uint64_t state_ = 0;
  double shortest_ = std::numeric_limits<double>::infinity();  ///< less than the length of each gate of a region
  std::vector<Region> regions_;                                ///< the region with the id i is at i - 1
  memory::ZeroedArray<std::uint32_t> labels_;  ///< by key of a gate: the stamp, plus the region of the gate's cell
  memory::Stamp stamp_;                        ///< its value is a multiple of kMost + 1
};

}  // namespace waywright::clearance
