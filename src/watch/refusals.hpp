#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "waywright/change.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"

#include "clearance/cells.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "exact/gap.hpp"
#include "memory/scratch.hpp"
#include "nav/point_agent.hpp"
#include "watch/box_grid.hpp"

namespace waywright::watch {

/// The watched paths of queries that have found no path, and where a change can make a path possible.
///
/// A change can make a path possible in three cases:
/// - It is near an end: then the query may move this end to another position.
/// - It removes a wall of the *barrier*: the border of an area that contains one of the ends, but not the other one.
/// - The class does not know a barrier, because nobody has looked for one, or because a path is already possible.
class Refusals {
 public:
  explicit Refusals(const Box& domain) : domain_(domain), boxes_(domain) {}

  /// What the query said.
  struct Refusal {
    QueryEnds ends;
    Agent agent;
  };

  /// Adds the path of a slot. `tolerance` is the largest distance by which the query moves an end. If memory runs out,
  /// nothing changes.
  void add(std::uint32_t slot, const Refusal& refusal, double tolerance);
  /// Removes the path of a slot, if it has one. Allocates nothing.
  void remove(std::uint32_t slot) noexcept;
  [[nodiscard]] bool is_empty() const { return slots_.empty(); }
  [[nodiscard]] const Refusal& refusal(std::uint32_t slot) const { return entries_[slot].refusal; }

  /// Lists the slots of the paths that changes may have made possible: first those of point agents, then those of discs
  /// with ascending radii. If `all` is true, lists all slots. If `all_points` is true, lists all slots of point agents.
  [[nodiscard]] std::span<const std::uint32_t> list(std::span<const ChangedBox> changes, bool all, bool all_points);
  /// Returns whether the agent fits at both ends without a move, because it did so at the last test and list() has seen
  /// no change near an end.
  [[nodiscard]] bool fits_at_ends(std::uint32_t slot) const {
    return entries_[slot].did_fit && !entries_[slot].is_changed;
  }
  /// Says that a path is possible now.
  void set_possible(std::uint32_t slot) noexcept { forget_barrier(slot); }
  /// Says that no path is possible now. Only the removal of a wall that meets the box can change this, or a change near
  /// an end. Without a box, only a change near an end can change this. `fits` says whether the agent fits at both ends
  /// without a move.
  void set_barrier(std::uint32_t slot, const std::optional<Box>& box, bool fits);

 private:
  enum Index : std::uint8_t { kStart, kGoal, kBarrier, kCount };
  struct BoxOfPath {
    std::uint32_t slot;
    Index index;
  };
  using Boxes = BoxGrid<BoxOfPath>;

  struct Entry {
    Refusal refusal;
    bool is_used = false;
    bool is_decided = false;  ///< whether it is known where a removal makes a path possible
    bool did_fit = false;     ///< whether the agent fitted at both ends at the last test
    bool is_changed = false;  ///< in the list: whether something may have changed near an end
    bool is_listed = false;
    std::uint32_t index = 0;  ///< in `slots_`
    std::optional<Boxes::Handle> boxes[kCount];
  };

  void forget_barrier(std::uint32_t slot) noexcept;
  void put(std::uint32_t slot, bool is_changed);

  Box domain_;
  Boxes boxes_;
  std::vector<Entry> entries_;        ///< by slot
  std::vector<std::uint32_t> slots_;  ///< of all paths
  std::size_t undecided_ = 0;         ///< the number of paths that are not decided
  std::vector<std::uint32_t> listed_;
};

/// Finds out for many pairs of nodes of a graph whether a chain of edges connects them. Two searches run alternately,
/// one from each node, until they meet or one of them has entered all nodes that it can reach. The nodes that a search
/// has entered are an *area*. A later question continues the searches of earlier questions, so all questions together
/// enter each node at most once.
///
/// `Graph` has a type `Edge`, a way out of a node, and these functions:
/// - `Edge across(Edge)`: the same edge, as an edge of the node beyond it;
/// - `std::uint32_t key(Edge)`: a number that only edges of one node have;
/// - `enter(Edge, add_key, add_exit, bounds)`: calls `add_key` for the keys of all edges of the node, calls `add_exit`
///   for the edges that an agent can cross, and makes the box `bounds` so large that it contains the border of the
///   node.
template <class Graph>
class Areas {
 public:
  using Edge = typename Graph::Edge;
  using Id = std::uint32_t;

  /// Forgets all areas. Requires: until the last question, `graph` exists and does not change, and its keys are below
  /// `key_count`.
  void begin(const Graph& graph, std::size_t key_count) {
    graph_ = &graph;
    constexpr std::uint32_t kMost = 0x40000000;  // one graph has fewer areas than this
    const std::uint64_t next = std::uint64_t{first_} + areas_.size();
    labels_.grow_to(key_count);
    if (next > kMost) labels_.clear();
    first_ = next > kMost ? 1 : static_cast<std::uint32_t>(next);
    // Keeps the memory of the lists.
    for (Area& area : areas_) area.exits.clear();
    for (Area& area : areas_) spare_.push_back(std::move(area.exits));
    areas_.clear();
  }

  /// Returns whether a chain of edges connects the nodes of two edges. If not, the box then contains the border of one
  /// of the two connected parts of the graph.
  [[nodiscard]] bool are_connected(const Edge& a, const Edge& b, Box& enclosed) {
    Id one = area_at(a);
    Id other = area_at(b);
    for (;;) {
      one = root(one);
      other = root(other);
      if (one == other) return true;
      if (areas_[one].exits.empty()) break;
      cross_next(one);
      std::swap(one, other);
    }
    enclosed = areas_[one].bounds;
    return false;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr Box kNothing{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};

  struct Area {
    Id parent;                ///< of a root: itself
    std::vector<Edge> exits;  ///< of a root: the edges that the search has not crossed yet
    Box bounds;               ///< of a root: contains the borders of the nodes
    std::size_t nodes;        ///< of a root
  };

  Id root(Id id) {
    while (areas_[id].parent != id) {
      areas_[id].parent = areas_[areas_[id].parent].parent;
      id = areas_[id].parent;
    }
    return id;
  }
  /// Returns the area of the node of an edge. Makes a new one if no search has entered the node.
  Id area_at(const Edge& edge) {
    const std::uint32_t label = labels_[graph_->key(edge)];
    if (label >= first_) return label - first_;
    const auto id = static_cast<Id>(areas_.size());
    areas_.push_back({id, {}, kNothing, 0});
    if (!spare_.empty()) {
      areas_.back().exits = std::move(spare_.back());
      spare_.pop_back();
    }
    enter(id, edge);
    return id;
  }
  void enter(Id id, const Edge& edge) {
    Area& area = areas_[id];
    ++area.nodes;
    graph_->enter(
        edge, [&](std::uint32_t key) { labels_[key] = first_ + id; },
        [&](const Edge& exit) { area.exits.push_back(exit); }, area.bounds);
  }
  void cross_next(Id id) {
    const Edge beyond = graph_->across(areas_[id].exits.back());
    areas_[id].exits.pop_back();
    const std::uint32_t label = labels_[graph_->key(beyond)];
    if (label < first_) return enter(id, beyond);
    const Id other = root(label - first_);
    if (other != id) unite(id, other);
  }
  void unite(Id id, Id other) {
    if (areas_[id].nodes < areas_[other].nodes) std::swap(id, other);
    Area& larger = areas_[id];
    Area& smaller = areas_[other];
    smaller.parent = id;
    larger.exits.insert(larger.exits.end(), smaller.exits.begin(), smaller.exits.end());
    larger.bounds.expand(smaller.bounds.min);
    larger.bounds.expand(smaller.bounds.max);
    larger.nodes += smaller.nodes;
  }

  const Graph* graph_ = nullptr;
  memory::ZeroedArray<std::uint32_t> labels_;  ///< by key: `first_` plus the area of the node, if it has been entered
  std::uint32_t first_ = 1;
  std::vector<Area> areas_;
  std::vector<std::vector<Edge>> spare_;  ///< empty lists with memory
};

// The graphs whose areas (Areas) agents cannot leave.

/// The faces, and the edges that a point agent can cross.
class FaceGraph {
 public:
  using Edge = mesh::HalfEdge;

  explicit FaceGraph(const constraint::ConstrainedTriangulation& triangulation)
      : mesh_(triangulation.topology()), geometry_(triangulation.triangulation().geometry()) {}

  [[nodiscard]] Edge across(Edge h) const { return mesh_.twin(h); }
  [[nodiscard]] std::uint32_t key(Edge h) const { return number(mesh::face(h)); }
  [[nodiscard]] std::size_t key_count() const { return mesh_.face_slots(); }
  template <class AddKey, class AddExit>
  void enter(Edge edge, const AddKey& add_key, const AddExit& add_exit, Box& bounds) const {
    add_key(key(edge));
    for (const Edge h : {edge, mesh::next(edge), mesh::previous(edge)}) {
      bounds.expand(geometry_.rounded(number(mesh_.origin(h))));
      if (nav::PointAgent::can_cross(mesh_, h)) add_exit(h);
    }
  }

 private:
  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
};

/// The cells, and the gates that a disc can cross.
class CellGraph {
 public:
  using Edge = clearance::CellEdge;

  CellGraph(const constraint::ConstrainedTriangulation& walls, const clearance::Bridges& bridges, double radius)
      : cells_(walls, bridges), radius_(radius) {}

  [[nodiscard]] Edge across(const Edge& gate) const { return cells_.across(gate); }
  [[nodiscard]] std::uint32_t key(const Edge& edge) const { return cells_.key(edge); }
  [[nodiscard]] std::size_t key_count() const { return cells_.key_count(); }
  template <class AddKey, class AddExit>
  void enter(const Edge& edge, const AddKey& add_key, const AddExit& add_exit, Box& bounds) const {
    Edge at = edge;
    do {
      add_key(key(at));
      bounds.expand(cells_.position_near(at));
      if (at.is_gate()) {
        const exact::Gap gap = cells_.gap(at);
        bounds.expand(exact::end_of(gap));
        if (exact::compare_to_diameter(gap, radius_) >= 0) add_exit(at);
      }
      at = cells_.next(at);
    } while (at != edge);
  }

 private:
  clearance::Cells cells_;
  double radius_;
};

}  // namespace waywright::watch
