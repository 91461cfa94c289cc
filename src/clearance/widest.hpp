#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/clearance.hpp"
#include "waywright/point.hpp"

#include "clearance/bridges.hpp"
#include "clearance/cells.hpp"
#include "clearance/near_walls.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/scratch.hpp"

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
/// If the query is about one disc, a gate that is not shorter than the diameter is *wide*. Wide gates need not be
/// compared with each other: a search crosses all of them before it has a level. If the two searches meet before one of
/// them has a level, the disc can move from one cell to the other.
///
/// Source: the bottleneck path (Pollack, *The maximum capacity through a network*, 1960).
class WidestSearch {
 public:
  /// Returns the narrowest gate of the widest connection from the cell of `start` to the cell of `goal`. All
  /// comparisons of lengths are exact. Cost: linear in the edges on the borders of the cells that it enters, and n log
  /// n in the number of gates on these borders.
  [[nodiscard]] Narrowest find(const Cells& cells, const CellEdge& start, const CellEdge& goal);

  /// Starts a search for a disc. Requires: until the last call of step(), the mesh and the bridges of `cells` exist and
  /// do not change.
  void begin(const Cells& cells, const CellEdge& start, const CellEdge& goal, double radius);
  /// Continues until the search has crossed `count` more gates, or has ended. Returns whether it has ended.
  bool step(const Cells& cells, std::size_t count);
  /// Returns whether it is certain that the disc cannot move from one cell to the other. The search may still have to
  /// find the gate that stops the disc. Requires: begin() has started the search.
  [[nodiscard]] bool is_refused() const {
    return has_ended_ ? !result_.is_connected || result_.gate : searches_[0].level || searches_[1].level;
  }
  /// The answer. If the disc can move from one cell to the other, the answer has no gate. Requires: the search has
  /// ended.
  [[nodiscard]] const Narrowest& result() const { return result_; }

  /// The cells that the search knows on one side of the gate that stops the disc, by the keys of their gates.
  struct Side {
    CellEdge gate;  ///< the gate that stops the disc, on the border of a cell of this side
    std::span<const std::uint32_t> keys;
  };
  /// The sides of the gate that stops the disc. All cells of a side are connected by longer gates. No gate that leads
  /// away from the cells of `complete` is longer. Requires: the search has ended, and the answer has a gate.
  struct Sides {
    Side complete;
    Side others[2];
  };
  [[nodiscard]] Sides sides(const Cells& cells) const;
  /// The gates of the cells that are connected with one of the two ends, if the ends are not connected: no gate leads
  /// away from these cells. Requires: the search has ended, and the cells are not connected.
  [[nodiscard]] std::span<const std::uint32_t> enclosed_keys() const { return searches_[current_].entered; }

 private:
  /// A gate that is not shorter than the level of its search.
  struct OpenGate {
    CellEdge edge;
    double squared_distance;  ///< approximate, from the other end
  };
  /// The search from one end.
  struct Search {
    Point target;                       ///< a position near the other end
    std::uint32_t stamp;                ///< marks the gates of the cells that this search has entered
    std::optional<MeasuredGate> level;  ///< nothing as long as the search has crossed no gate, or only wide ones
    std::vector<OpenGate> open;         ///< a heap; the gate nearest to the target comes first
    /// A heap of the gates that are shorter than the level. As long as there is no level: of all gates that the search
    /// has seen and that are not wide. The longest comes first.
    std::vector<MeasuredGate> shorter;
    std::vector<std::uint32_t> entered;    ///< the keys of the gates of the entered cells
    std::size_t entered_before_level = 0;  ///< the number of these keys when the search got its level
  };

  void begin_both(const Cells& cells, const CellEdge& start, const CellEdge& goal);
  static void begin(const Cells& cells, Search& search, const CellEdge& target, std::uint32_t stamp);
  [[nodiscard]] static bool has_gates(const Search& search) { return !search.open.empty() || !search.shorter.empty(); }
  [[nodiscard]] bool is_open(const Cells& cells, const Search& search, const CellEdge& gate,
                             const exact::Gap& gap) const;
  [[nodiscard]] CellEdge pop(const Cells& cells, Search& search);
  [[nodiscard]] bool enter(const Cells& cells, Search& search, const CellEdge& from, const CellEdge* other_end);
  void see(const Cells& cells, Search& search, const CellEdge& gate);
  [[nodiscard]] const Search* search_with_narrower_level(const Cells& cells) const;

  Search searches_[2];            ///< the search from the start, the search from the goal
  std::optional<double> radius_;  ///< of the disc, or nothing: then no gate is wide
  int current_ = 0;               ///< the search that crosses the next gate
  bool has_ended_ = false;
  Narrowest result_;
  memory::ZeroedArray<std::uint32_t> visited_;  ///< by key: the stamp of the search that has entered the gate's cell
  memory::Stamp stamp_;
};

/// Finds the widest gap between two positions. The answer depends only on the positions of the walls. Use one object
/// for many queries, because it keeps its memory.
class WidestGapFinder {
 public:
  /// Requires: `bridges` belongs to the triangulation, and both points lie in its domain. A position on a wall is
  /// connected with no other.
  void find(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges, NearWalls& near_walls,
            const Point& start, const Point& goal, WidestPath& result);

 private:
  WidestSearch search_;
};

/// Makes `result` the answer for two positions that are not connected. Keeps the memory of its lists.
void clear(WidestPath& result);
/// Writes the answer of a search.
void write_widest(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges,
                  const Narrowest& narrowest, WidestPath& result);

}  // namespace waywright::clearance
