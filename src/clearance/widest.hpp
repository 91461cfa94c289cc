#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "clearance/cells.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// What limits the discs that can go from one cell to another.
struct Narrowest {
  bool is_connected = false;     ///< whether walls leave a connection at all
  std::optional<CellEdge> gate;  ///< the gate that limits the disc; nothing if both cells are the same or not connected
};

/// Finds the widest connection between two cells: the one whose narrowest gate is longest. Use one object for many
/// queries, because it keeps its memory.
///
/// Source: the bottleneck path (Pollack, *The maximum capacity through a network*, 1960), as a best-first search.
class WidestSearch {
 public:
  /// Returns the narrowest gate of the widest connection from the cell of `start` to the cell of `goal`. All
  /// comparisons of lengths are exact. Cost: n log n in the number of gates of the cells that it enters.
  [[nodiscard]] Narrowest find(const Cells& cells, const CellEdge& start, const CellEdge& goal);

 private:
  struct Entry {
    CellEdge gate;
    CellEdge narrowest;  ///< the narrowest gate up to this one, and this one included
    double length;       ///< of `narrowest`, in doubles
  };

  [[nodiscard]] bool enter(const Cells& cells, const CellEdge& from, const CellEdge& goal, const Entry* before);

  std::vector<Entry> open_;                     ///< a heap
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by key: the number of the last query that entered the gate's cell
  memory::Stamp stamp_;
};

}  // namespace waywright::clearance
