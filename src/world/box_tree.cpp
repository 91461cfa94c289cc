#include "world/box_tree.hpp"

#include <algorithm>

#include "base/ieee.hpp"

namespace waywright {

std::uint32_t BoxTree::make_node(std::uint32_t parent) {
  if (free_nodes_.is_empty()) {
    nodes_.emplace_back();
    nodes_.back().parent = free_nodes_.push(static_cast<std::uint32_t>(nodes_.size() - 1));
  }
  const std::uint32_t node = free_nodes_.pop(nodes_[free_nodes_.first()].parent);
  nodes_[node] = {};
  nodes_[node].parent = parent;
  return node;
}

/// Returns the node for a box. Makes this node and its ancestors if they do not exist.
std::uint32_t BoxTree::node_for(const Box& box) {
  if (nodes_.empty()) static_cast<void>(make_node(kNone));
  std::uint32_t node = 0;
  Box cell = domain_;
  const Point centre = 0.5 * (box.min + box.max);
  for (std::size_t depth = 0; depth < kDeepest; ++depth) {
    const Point half = 0.5 * (cell.max - cell.min);
    if (!(box.max.x - box.min.x <= half.x && box.max.y - box.min.y <= half.y)) break;
    const Point middle = cell.min + half;
    const bool is_right = centre.x > middle.x;
    const bool is_upper = centre.y > middle.y;
    (is_right ? cell.min.x : cell.max.x) = middle.x;
    (is_upper ? cell.min.y : cell.max.y) = middle.y;
    const std::size_t quadrant = (is_right ? 1U : 0U) + (is_upper ? 2U : 0U);
    if (nodes_[node].children[quadrant] == kNone) {
      const std::uint32_t child = make_node(node);
      nodes_[node].children[quadrant] = child;
    }
    node = nodes_[node].children[quadrant];
  }
  return node;
}

BoxTree::Handle BoxTree::insert(const Box& box, std::uint32_t number) {
  if (free_entries_.is_empty()) {
    entries_.push_back({});
    entries_.back().next = free_entries_.push(static_cast<std::uint32_t>(entries_.size() - 1));
  }
  const std::uint32_t node = node_for(box);
  // Nothing can fail from here on.
  const Handle handle = free_entries_.pop(entries_[free_entries_.first()].next);
  std::uint32_t& first = nodes_[node].first;
  entries_[handle] = {box, number, node, kNone, first};
  if (first != kNone) entries_[first].previous = handle;
  first = handle;
  for (std::uint32_t at = node; at != kNone; at = nodes_[at].parent) {
    Box& bounds = nodes_[at].bounds;
    if (nodes_[at].count++ == 0) bounds = box;
    bounds.expand(box.min);
    bounds.expand(box.max);
  }
  return handle;
}

void BoxTree::remove(Handle handle) {
  const Entry& entry = entries_[handle];
  const std::uint32_t node = entry.node;
  (entry.previous == kNone ? nodes_[node].first : entries_[entry.previous].next) = entry.next;
  if (entry.next != kNone) entries_[entry.next].previous = entry.previous;
  entries_[handle].next = free_entries_.push(handle);
  for (std::uint32_t at = node; at != kNone;) {
    const std::uint32_t parent = nodes_[at].parent;
    --nodes_[at].count;
    free_if_empty(at);
    at = parent;
  }
}

/// Frees a node without boxes. The root stays.
void BoxTree::free_if_empty(std::uint32_t node) {
  const std::uint32_t parent = nodes_[node].parent;
  const auto is_node = [](std::uint32_t child) { return child != kNone; };
  if (nodes_[node].count != 0 || parent == kNone) return;
  if (std::any_of(nodes_[node].children.begin(), nodes_[node].children.end(), is_node)) return;
  std::replace(nodes_[parent].children.begin(), nodes_[parent].children.end(), node, kNone);
  nodes_[node].parent = free_nodes_.push(node);
}

}  // namespace waywright
