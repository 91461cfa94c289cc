#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/journal.hpp"
#include "memory/pages.hpp"

namespace waywright::nav {

/// The sets of polygons that cover components, as a tree. A node represents the set of its parent and one more polygon.
/// So covers share memory: each of n nested polygons takes one node, although n polygons cover the innermost component.
/// Several nodes can represent the same set. The *references* of a node are its children, and the components whose
/// cover is the set of this node. A node without references exists only until free_unused(). An undo log records all
/// changes; roll_back() returns to the last begin().
class CoverTree {
 public:
  /// A node, or kEmpty for the empty set.
  using Set = std::uint32_t;
  static constexpr Set kEmpty = 0xffffffff;

  /// Returns a new node: the set and one more polygon. It has no reference yet. Requires: the set does not contain the
  /// polygon. Cost: O(1).
  [[nodiscard]] Set add(Set set, std::uint32_t polygon);
  /// Returns the set without the polygons in `removed` and with the polygons in `added`. Requires: `removed` ascends;
  /// the set contains all of `removed` and none of `added`. Cost: the number of nodes from the set up to the
  /// farthest node with one of `removed`, times the logarithm of the length of `removed`; and O(1) for each of `added`.
  [[nodiscard]] Set change(Set set, std::span<const std::uint32_t> removed, std::span<const std::uint32_t> added);
  /// Writes those of the polygons that the set contains to `found`, ascending. Requires: `polygons` ascends. Cost: the
  /// size of the set times the logarithm of the number of polygons, or O(1) for each polygon if they cover nothing.
  void find_contained(Set set, std::span<const std::uint32_t> polygons, std::vector<std::uint32_t>& found) const;
  /// Returns whether a set contains the polygon.
  [[nodiscard]] bool is_used(std::uint32_t polygon) const { return first_node(polygon) != kEmpty; }
  /// Returns whether is(polygon) is true for at least one polygon of the set. If the node `end` is among the set's
  /// ancestors, the function leaves out the polygons of `end`.
  template <class Is>
  [[nodiscard]] bool has_any(Set set, Set end, Is&& is) const {
    for (; set != kEmpty && set != end; set = nodes_[set].parent) {
      if (is(nodes_[set].polygon)) return true;
    }
    return false;
  }
  /// A node that adds the polygon to the set of its parent, or kEmpty if no node does.
  [[nodiscard]] Set first_node(std::uint32_t polygon) const {
    const First* const first = firsts_.find(polygon);
    return first == nullptr ? kEmpty : first->node;
  }
  /// Calls visit(polygon) for each polygon of the set.
  template <class Visit>
  void for_each(Set set, Visit&& visit) const {
    for (; set != kEmpty; set = nodes_[set].parent) visit(nodes_[set].polygon);
  }
  /// Calls visit(node) for each node that adds the polygon to the set of its parent. `visit` must not change the tree.
  template <class Visit>
  void for_each_node(std::uint32_t polygon, Visit&& visit) const {
    for (Set node = first_node(polygon); node != kEmpty; node = nodes_[node].next_of_polygon) visit(node);
  }
  [[nodiscard]] Set parent(Set node) const { return nodes_[node].parent; }
  /// The first of the components whose cover is this set, or kEmpty. The caller stores the links to the others.
  [[nodiscard]] std::uint32_t first_component(Set set) const { return nodes_[set].first_component; }
  void set_first_component(Set set, std::uint32_t component);
  /// Makes a node a child of another node, or of the empty set.
  void move(Set node, Set parent);
  /// Takes a node without components out of the tree. Its children become children of its parent. Cost: the number of
  /// the children.
  void remove(Set node);
  /// Frees a node that has no reference, then its parent if the parent has no other reference, and so on.
  void free_unused(Set set);

  /// Empties the undo log.
  void begin();
  /// Takes back all changes since begin(). Allocates nothing.
  void roll_back();

  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  struct Node {
    std::uint32_t polygon;
    Set parent;  ///< of a free node: the next free node
    Set first_child = kEmpty;
    Set next = kEmpty;  ///< the next child of the parent; unused if the parent is the empty set
    Set previous = kEmpty;
    Set next_of_polygon = kEmpty;
    Set previous_of_polygon = kEmpty;
    std::uint32_t first_component = kEmpty;
  };

  /// Changes a node: calls change(node) with a copy, and writes the copy.
  template <class Change>
  void edit(Set node, Change&& change) {
    Node copy = nodes_[node];
    change(copy);
    nodes_.write(node, copy);
  }
  /// The first node that adds a polygon to the set of its parent.
  struct First {
    Set node = kEmpty;
  };
  struct OldFirst {
    std::uint32_t polygon;
    Set node;
  };

  void set_first_node(std::uint32_t polygon, Set node);
  void link_to_parent(Set node);
  void unlink_from_parent(Set node);
  void unlink_from_polygon(Set node);
  void free(Set node);

  memory::JournaledArray<Node> nodes_;
  memory::Pages<First> firsts_;  ///< by polygon; in a large world, perhaps only few items are polygons
  memory::Journal<OldFirst> old_firsts_;
  memory::FreeList free_nodes_;      ///< linked by Node::parent
  std::vector<std::uint32_t> kept_;  ///< scratch
};

}  // namespace waywright::nav
