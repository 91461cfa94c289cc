#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/point.hpp"

#include "clearance/cells.hpp"
#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// What limits the discs that can move from one cell to another.
struct Narrowest {
  bool is_connected = false;     ///< whether a chain of gates connects the cells
  std::optional<CellEdge> gate;  ///< the gate that limits the disc; empty if the cells are equal or not connected
};

/// Finds the widest connection between two cells: the connection whose narrowest gate is longest. Use one object for
/// many queries, because it keeps its memory.
///
/// Two searches run alternately, one from each end, until one of them enters a cell that the other has entered. Each
/// search has a *level*: the narrowest gate that it has crossed so far. It first crosses all gates that it has seen and
/// that are not shorter than its level, those near the other end first. After that, it crosses the longest of the other
/// gates, which becomes its level. So a search that lowers its level has entered all cells that it can reach through
/// longer gates. When the two meet, the shorter of the two levels is therefore the gate that the query asks for. If one
/// end lies in a small enclosed area, its search soon leaves this area and continues straight towards the other end.
///
/// Source: the bottleneck path (Pollack, *The maximum capacity through a network*, 1960).
class WidestSearch {
 public:
  /// Returns the narrowest gate of the widest connection from the cell of `start` to the cell of `goal`. All
  /// comparisons of lengths are exact. Cost: linear in the edges on the borders of the cells that it enters, and n log
  /// n in the number of gates on these borders.
  [[nodiscard]] Narrowest find(const Cells& cells, const CellEdge& start, const CellEdge& goal);

 private:
  /// A gate that a search has seen but not crossed, with its length in doubles.
  struct Gate {
    CellEdge edge;
    double length;
  };
  /// A gate that is not shorter than the level of its search.
  struct OpenGate {
    CellEdge edge;
    double squared_distance;  ///< approximate, from the other end
  };
  /// The search from one end.
  struct Search {
    Point target;                ///< a position near the other end
    std::uint32_t stamp;         ///< marks the gates of the cells that this search has entered
    std::optional<Gate> level;   ///< nothing as long as the search has crossed no gate
    std::vector<OpenGate> open;  ///< a heap; the gate nearest to the target comes first
    /// A heap of the gates that are shorter than the level or, as long as there is no level, of all gates that the
    /// search has seen. The longest comes first.
    std::vector<Gate> shorter;
  };

  static void begin(const Cells& cells, Search& search, const CellEdge& target, std::uint32_t stamp);
  [[nodiscard]] static bool has_gates(const Search& search) { return !search.open.empty() || !search.shorter.empty(); }
  [[nodiscard]] CellEdge pop(const Cells& cells, Search& search);
  [[nodiscard]] bool enter(const Cells& cells, Search& search, const CellEdge& from, const CellEdge* other_end);
  void see(const Cells& cells, Search& search, const CellEdge& gate);
  [[nodiscard]] Narrowest narrower_level(const Cells& cells) const;

  Search searches_[2];                          ///< the search from the start, the search from the goal
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by key: the stamp of the search that has entered the gate's cell
  memory::Stamp stamp_;
};

}  // namespace waywright::clearance
