#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/point.hpp"

#include "memory/free_list.hpp"

namespace waywright {

/// A set of boxes, each with a number. The set finds its boxes that overlap a given box.
///
/// The set is a loose quadtree over a domain. Each node has a cell, and contains boxes whose centres lie in this
/// cell. A box belongs to the deepest possible node whose cell is at least as wide and as high as the box. A node knows
/// the bounding box of all boxes below it, which is at most twice as large as its cell. So a search visits few nodes in
/// which no box overlaps the given box. Boxes may reach beyond the domain.
///
/// Source: Ulrich, *Loose octrees*, in Game Programming Gems, 2000.
class BoxTree {
 public:
  using Handle = std::uint32_t;

  explicit BoxTree(const Box& domain) : domain_(domain) {}

  /// Adds a box with a number. Returns a handle for remove(). If memory runs out, the set does not change. Cost: the
  /// depth of the tree, at most 12.
  Handle insert(const Box& box, std::uint32_t number);
  /// Removes a box. Allocates nothing. Cost: the depth of the tree.
  void remove(Handle handle);

  /// Calls visit(number) for each box that overlaps `box`. Boxes overlap if they have a point in common. Allocates
  /// nothing. `visit` must not change the set.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    if (!nodes_.empty()) visit_below(0, box, visit);
  }

 private:
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;
  static constexpr std::size_t kDeepest = 12;

  struct Entry {
    Box box;
    std::uint32_t number;
    std::uint32_t node;
    std::uint32_t previous;  ///< in the list of the node
    std::uint32_t next;      ///< in the list of the node; of a free entry: the next free one
  };
  struct Node {
    std::array<std::uint32_t, 4> children{kNone, kNone, kNone, kNone};
    std::uint32_t parent = kNone;  ///< of a free node: the next free one
    std::uint32_t first = kNone;   ///< the first entry of its list
    std::size_t count = 0;         ///< the number of entries here and below
    Box bounds;                    ///< contains all boxes here and below
  };

  template <class Visit>
  void visit_below(std::uint32_t node, const Box& box, const Visit& visit) const {
    for (std::uint32_t i = nodes_[node].first; i != kNone; i = entries_[i].next) {
      if (entries_[i].box.overlaps(box)) visit(entries_[i].number);
    }
    for (const std::uint32_t child : nodes_[node].children) {
      if (child != kNone && nodes_[child].count != 0 && nodes_[child].bounds.overlaps(box)) {
        visit_below(child, box, visit);
      }
    }
  }
  [[nodiscard]] std::uint32_t node_for(const Box& box);
  [[nodiscard]] std::uint32_t make_node(std::uint32_t parent);
  void free_if_empty(std::uint32_t node);

  Box domain_;
  std::vector<Node> nodes_;  ///< the first is the root
  std::vector<Entry> entries_;
  memory::FreeList free_nodes_;    ///< linked by Node::parent
  memory::FreeList free_entries_;  ///< linked by Entry::next
};

}  // namespace waywright
