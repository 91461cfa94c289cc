#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "waywright/point.hpp"

#include "memory/zeroed_array.hpp"

namespace waywright {

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

}  // namespace waywright
