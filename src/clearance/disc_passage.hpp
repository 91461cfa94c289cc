#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "waywright/point.hpp"

#include "clearance/bridges.hpp"
#include "clearance/cells.hpp"
#include "clearance/near_walls.hpp"
#include "clearance/widest.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// Finds the cells from which a disc can move to a goal: the cells that are connected with the cell of the goal by
/// gates that are not shorter than the diameter (*wide* gates). Use one object for many queries, because it keeps its
/// memory.
class DiscReach {
 public:
  /// Starts with the cell of the goal. Requires: until the last call of is_reached(), the mesh and the bridges of
  /// `cells` exist and do not change.
  void begin(const Cells& cells, const CellEdge& goal, double radius);
  /// Returns whether the disc can move from the cell of `edge` to the goal. The decision is exact. Cost: two searches
  /// run alternately, one from the goal and one from the cell. They stop when they meet, or when one of them has
  /// entered all cells that it can reach. The object keeps the state of each entered cell, so no later call for the
  /// same goal enters this cell again: a call for one of its edges costs O(1).
  [[nodiscard]] bool is_reached(const Cells& cells, const CellEdge& edge);

 private:
  /// What the searches know about a cell. All edges of a cell have the same state.
  enum class State : std::uint8_t {
    unknown,
    reached,      ///< the disc can move from the cell to the goal
    not_reached,  ///< the disc cannot move from the cell to the goal
    entered,      ///< the present search from a cell has entered the cell, and the result is not known yet
  };

  [[nodiscard]] State state(const Cells& cells, const CellEdge& edge) const;
  void set_state(std::uint32_t key, State state) { states_[key] = stamp_.value() + static_cast<std::uint32_t>(state); }
  void enter(const Cells& cells, const CellEdge& edge, State state, std::vector<CellEdge>& gates);
  void finish(State state);

  double radius_ = 0.0;
  memory::ZeroedArray<std::uint32_t> states_;  ///< by key of an edge: the number of the query, plus the state
  memory::Stamp stamp_;
  std::vector<CellEdge> from_goal_;     ///< wide gates of reached cells that the search has not crossed yet
  std::vector<CellEdge> from_cell_;     ///< the same for the cells that the search from the cell has entered
  std::vector<std::uint32_t> entered_;  ///< the keys with the state `entered`
};

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
  /// numbers (Bridges::state()).
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

/// Decides exactly whether a disc can move from one position to another, beside another search for its path. The caller
/// decides how much work the object does, and when. If the disc cannot move to the goal, the object finds the gap that
/// stops it. Use one object for many queries: it remembers which gaps have stopped discs, as long as the bridges do not
/// change.
class DiscPassage {
 public:
  /// Starts a decision. Requires: the disc fits at both positions; the triangulation and the bridges exist and do not
  /// change until the decision ends. Cost: O(1).
  void begin(const constraint::ConstrainedTriangulation& triangulation, const Bridges& bridges, const Point& start,
             const Point& goal, double radius);
  /// Returns whether an earlier decision in this state knows a gap that is too narrow for the disc.
  [[nodiscard]] bool may_remember() const { return memory_.may_refuse(radius_); }
  /// Returns whether an earlier decision shows that the disc cannot move to the goal. Cost: find_cell() for both ends.
  [[nodiscard]] bool remembers_refusal(NearWalls& near_walls);
  /// Searches: crosses up to `count` gates. Returns whether the search is certain that the disc can move to the goal,
  /// or that it cannot. The result is nothing as long as this is not known.
  [[nodiscard]] std::optional<bool> search(NearWalls& near_walls, std::size_t count);
  /// Finds the gap that limits the discs that can move to the goal. If it stops this disc, remembers it.
  void find_gap(NearWalls& near_walls, WidestPath& gap);

 private:
  [[nodiscard]] Cells cells() const { return {*triangulation_, *bridges_}; }
  [[nodiscard]] bool find_cells(NearWalls& near_walls);
  [[nodiscard]] bool begin_search(NearWalls& near_walls);

  const constraint::ConstrainedTriangulation* triangulation_ = nullptr;
  const Bridges* bridges_ = nullptr;
  Point start_;
  Point goal_;
  double radius_ = 0.0;
  bool knows_cells_ = false;  ///< whether the code has looked for the cells of the two ends
  bool has_begun_ = false;    ///< whether `search_` has begun
  std::optional<CellEdge> start_cell_;
  std::optional<CellEdge> goal_cell_;
  std::optional<Narrowest> known_;  ///< the answer, if the memory knows it
  WidestSearch search_;
  GapMemory memory_;
};

}  // namespace waywright::clearance
