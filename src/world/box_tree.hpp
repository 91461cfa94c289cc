#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "memory/free_list.hpp"

namespace waywright {

/// A set of boxes, each with a value. The set finds its boxes that overlap a given box.
///
/// The set is a loose quadtree over a domain. Each node has a rectangle: the root has the domain, and each child has a
/// quarter of its parent's rectangle. A box belongs to the deepest possible node whose rectangle contains the centre of
/// the box, and is at least as wide and as high as the box. A box that is wider or higher than the domain belongs to
/// the root. If the centre of a box lies outside the domain, the nearest position of the domain counts as its centre.
/// Node::bounds contains all boxes of a node and of the nodes below it. Except at the root, and apart from boxes whose
/// centres lie outside the domain, it is at most twice as wide and twice as high as the rectangle. So a search visits
/// few nodes in which no box overlaps the given box. Boxes may reach beyond the domain. Each node stores its boxes and
/// their values one after the other, because a search may visit thousands of them.
///
/// Source: Ulrich, *Loose octrees*, in Game Programming Gems, 2000.
///
/// `Bucket` stores the boxes and values of a node: see PieceBucket and EllipseBucket. It decides what it passes to
/// `visit` for a given box, and may leave out values that the box does not meet.
template <class Bucket>
class BoxTree {
 public:
  using Value = typename Bucket::Value;
  using Handle = std::uint32_t;

  explicit BoxTree(const Box& domain) : domain_(domain) {}

  /// Adds a box with a value. Returns a handle for remove(). If memory runs out, the set does not change. Cost: the
  /// depth of the tree, at most 12.
  Handle insert(const Box& box, const Value& value);
  /// Removes a box. Allocates nothing. Cost: the depth of the tree.
  void remove(Handle handle);

  /// Calls Bucket::for_each_overlapping(box, visit) for the root, and for each node below it whose bounds overlap
  /// `box`. Boxes overlap if they have a point in common. Allocates nothing. `visit` must not change the set.
  template <class Visit>
  void for_each_overlapping(const Box& box, const Visit& visit) const {
    if (!nodes_.empty()) visit_below(0, box, visit);
  }

 private:
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;
  static constexpr std::size_t kDeepest = 12;

  struct Node {
    explicit Node(const Box& domain) : entries(domain) {}
    std::array<std::uint32_t, 4> children{kNone, kNone, kNone, kNone};
    std::uint32_t parent = kNone;  ///< of a free node: the next free one
    std::size_t count = 0;         ///< the number of entries here and below
    Box bounds;                    ///< contains all boxes here and below
    Bucket entries;
  };
  /// Where the entry of a handle is.
  struct EntryOfHandle {
    std::uint32_t node;
    std::uint32_t index;  ///< of the entry; of a free handle: the next free one
  };

  template <class Visit>
  void visit_below(std::uint32_t node, const Box& box, const Visit& visit) const {
    nodes_[node].entries.for_each_overlapping(box, visit);
    for (const std::uint32_t child : nodes_[node].children) {
      if (child != kNone && nodes_[child].count != 0 && nodes_[child].bounds.overlaps(box)) {
        visit_below(child, box, visit);
      }
    }
  }
  /// The way from the root down to the node of a new box. If memory runs out, the destructor frees the new nodes.
  class Descent {
   public:
    explicit Descent(BoxTree& tree) : tree_(tree) {}
    ~Descent() {
      for (std::uint32_t at = is_kept_ ? kNone : node_; at != kNone;) {
        const std::uint32_t parent = tree_.nodes_[at].parent;
        tree_.free_if_empty(at);
        at = parent;
      }
    }
    Descent(const Descent&) = delete;
    Descent& operator=(const Descent&) = delete;

    [[nodiscard]] std::uint32_t node() const { return node_; }
    void go_to(std::uint32_t node) { node_ = node; }
    void keep() { is_kept_ = true; }

   private:
    BoxTree& tree_;
    std::uint32_t node_ = kNone;
    bool is_kept_ = false;
  };

  void descend(const Box& box, Descent& descent);
  [[nodiscard]] std::uint32_t make_node(std::uint32_t parent);
  void free_if_empty(std::uint32_t node);

  Box domain_;
  std::vector<Node> nodes_;  ///< the first is the root
  std::vector<EntryOfHandle> entries_of_handles_;
  memory::FreeList free_nodes_;    ///< linked by Node::parent
  memory::FreeList free_handles_;  ///< linked by EntryOfHandle::index
};

template <class Bucket>
std::uint32_t BoxTree<Bucket>::make_node(std::uint32_t parent) {
  if (free_nodes_.is_empty()) {
    nodes_.emplace_back(domain_);
    nodes_.back().parent = free_nodes_.push(static_cast<std::uint32_t>(nodes_.size() - 1));
  }
  const std::uint32_t node = free_nodes_.pop(nodes_[free_nodes_.first()].parent);
  nodes_[node] = Node(domain_);
  nodes_[node].parent = parent;
  return node;
}

/// Goes to the node for a box. Makes this node and its ancestors if they do not exist.
template <class Bucket>
void BoxTree<Bucket>::descend(const Box& box, Descent& descent) {
  if (nodes_.empty()) static_cast<void>(make_node(kNone));
  std::uint32_t node = 0;
  descent.go_to(node);
  Box square = domain_;
  const Point centre = 0.5 * (box.min + box.max);
  for (std::size_t depth = 0; depth < kDeepest; ++depth) {
    const Point half = 0.5 * (square.max - square.min);
    if (!(box.max.x - box.min.x <= half.x && box.max.y - box.min.y <= half.y)) break;
    const Point middle = square.min + half;
    const bool is_right = centre.x > middle.x;
    const bool is_upper = centre.y > middle.y;
    (is_right ? square.min.x : square.max.x) = middle.x;
    (is_upper ? square.min.y : square.max.y) = middle.y;
    const std::size_t quadrant = (is_right ? 1U : 0U) + (is_upper ? 2U : 0U);
    if (nodes_[node].children[quadrant] == kNone) {
      const std::uint32_t child = make_node(node);
      nodes_[node].children[quadrant] = child;
    }
    node = nodes_[node].children[quadrant];
    descent.go_to(node);
  }
}

template <class Bucket>
auto BoxTree<Bucket>::insert(const Box& box, const Value& value) -> Handle {
  if (free_handles_.is_empty()) {
    entries_of_handles_.push_back({});
    entries_of_handles_.back().index = free_handles_.push(static_cast<std::uint32_t>(entries_of_handles_.size() - 1));
  }
  Descent descent(*this);
  descend(box, descent);
  const std::uint32_t node = descent.node();
  Bucket& entries = nodes_[node].entries;
  entries.add(box, value, free_handles_.first());
  // Nothing can fail from here on.
  descent.keep();
  const Handle handle = free_handles_.pop(entries_of_handles_[free_handles_.first()].index);
  entries_of_handles_[handle] = {node, static_cast<std::uint32_t>(entries.size() - 1)};
  for (std::uint32_t at = node; at != kNone; at = nodes_[at].parent) {
    Box& bounds = nodes_[at].bounds;
    if (nodes_[at].count++ == 0) bounds = box;
    bounds.expand(box.min);
    bounds.expand(box.max);
  }
  return handle;
}

template <class Bucket>
void BoxTree<Bucket>::remove(Handle handle) {
  const auto [node, index] = entries_of_handles_[handle];
  Bucket& entries = nodes_[node].entries;
  entries.remove(index);
  if (index < entries.size()) entries_of_handles_[entries.handle(index)].index = index;
  entries_of_handles_[handle].index = free_handles_.push(handle);
  for (std::uint32_t at = node; at != kNone;) {
    const std::uint32_t parent = nodes_[at].parent;
    --nodes_[at].count;
    free_if_empty(at);
    at = parent;
  }
}

/// Frees a node without boxes. The root stays.
template <class Bucket>
void BoxTree<Bucket>::free_if_empty(std::uint32_t node) {
  const std::uint32_t parent = nodes_[node].parent;
  const auto is_node = [](std::uint32_t child) { return child != kNone; };
  if (nodes_[node].count != 0 || parent == kNone) return;
  if (std::any_of(nodes_[node].children.begin(), nodes_[node].children.end(), is_node)) return;
  std::replace(nodes_[parent].children.begin(), nodes_[parent].children.end(), node, kNone);
  nodes_[node].parent = free_nodes_.push(node);
}

}  // namespace waywright
