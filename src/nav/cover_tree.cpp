#include "nav/cover_tree.hpp"

#include <algorithm>

#include "memory/count.hpp"

namespace waywright::nav {

CoverTree::Set CoverTree::add(Set set, std::uint32_t polygon) {
  firsts_.grow_to(std::size_t{polygon} + 1);
  firsts_.make_room(polygon);
  Node node{polygon, set};
  node.next_of_polygon = first_node(polygon);
  Set index = static_cast<Set>(nodes_.size());
  if (free_nodes_.is_empty()) {
    nodes_.append(node);
  } else {
    index = free_nodes_.first();
    const std::uint32_t next_free = nodes_[index].parent;
    nodes_.write(index, node);
    free_nodes_.pop(next_free);
  }
  if (node.next_of_polygon != kEmpty) edit(node.next_of_polygon, [&](Node& n) { n.previous_of_polygon = index; });
  set_first_node(polygon, index);
  link_to_parent(index);
  return index;
}

CoverTree::Set CoverTree::change(Set set, std::span<const std::uint32_t> removed,
                                 std::span<const std::uint32_t> added) {
  kept_.assign(added.begin(), added.end());
  for (std::size_t left = removed.size(); left > 0; set = nodes_[set].parent) {
    const std::uint32_t polygon = nodes_[set].polygon;
    if (std::binary_search(removed.begin(), removed.end(), polygon)) {
      --left;
    } else {
      kept_.push_back(polygon);
    }
  }
  for (auto polygon = kept_.rbegin(); polygon != kept_.rend(); ++polygon) set = add(set, *polygon);
  return set;
}

void CoverTree::find_contained(Set set, std::span<const std::uint32_t> polygons,
                               std::vector<std::uint32_t>& found) const {
  found.clear();
  std::size_t left = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if ((i == 0 || polygons[i] != polygons[i - 1]) && is_used(polygons[i])) ++left;
  }
  for (; left > 0 && set != kEmpty; set = nodes_[set].parent) {
    if (!std::binary_search(polygons.begin(), polygons.end(), nodes_[set].polygon)) continue;
    found.push_back(nodes_[set].polygon);
    --left;
  }
  std::sort(found.begin(), found.end());
}

void CoverTree::set_first_component(Set set, std::uint32_t component) {
  edit(set, [&](Node& node) { node.first_component = component; });
}

void CoverTree::move(Set node, Set parent) {
  const Set old = nodes_[node].parent;
  unlink_from_parent(node);
  edit(node, [&](Node& n) { n.parent = parent; });
  link_to_parent(node);
  free_unused(old);
}

// The children of the empty set need no links.
void CoverTree::remove(Set node) {
  const Set parent = nodes_[node].parent;
  for (Set child = nodes_[node].first_child; child != kEmpty;) {
    const Set next = nodes_[child].next;
    edit(child, [&](Node& n) {
      n.parent = parent;
      n.next = n.previous = kEmpty;
    });
    link_to_parent(child);
    child = next;
  }
  edit(node, [](Node& n) { n.first_child = kEmpty; });
  free_unused(node);
}

void CoverTree::free_unused(Set set) {
  while (set != kEmpty && nodes_[set].first_child == kEmpty && nodes_[set].first_component == kEmpty) {
    const Set parent = nodes_[set].parent;
    unlink_from_parent(set);
    unlink_from_polygon(set);
    free(set);
    set = parent;
  }
}

// Requires: firsts_ has room for the polygon.
void CoverTree::set_first_node(std::uint32_t polygon, Set node) {
  old_firsts_.add({polygon, first_node(polygon)});
  firsts_[polygon].node = node;
}

void CoverTree::link_to_parent(Set node) {
  const Set parent = nodes_[node].parent;
  if (parent == kEmpty) return;
  const Set next = nodes_[parent].first_child;
  if (next != kEmpty) edit(next, [&](Node& n) { n.previous = node; });
  edit(node, [&](Node& n) { n.next = next; });
  edit(parent, [&](Node& n) { n.first_child = node; });
}

void CoverTree::unlink_from_parent(Set node) {
  const Node old = nodes_[node];
  if (old.parent == kEmpty) return;
  if (old.previous == kEmpty) {
    edit(old.parent, [&](Node& n) { n.first_child = old.next; });
  } else {
    edit(old.previous, [&](Node& n) { n.next = old.next; });
  }
  if (old.next != kEmpty) edit(old.next, [&](Node& n) { n.previous = old.previous; });
  edit(node, [](Node& n) { n.next = n.previous = kEmpty; });
}

void CoverTree::unlink_from_polygon(Set node) {
  const Node old = nodes_[node];
  if (old.previous_of_polygon == kEmpty) {
    set_first_node(old.polygon, old.next_of_polygon);
  } else {
    edit(old.previous_of_polygon, [&](Node& n) { n.next_of_polygon = old.next_of_polygon; });
  }
  if (old.next_of_polygon == kEmpty) return;
  edit(old.next_of_polygon, [&](Node& n) { n.previous_of_polygon = old.previous_of_polygon; });
}

// write() comes first: it may run out of memory.
void CoverTree::free(Set node) {
  nodes_.write(node, {0, free_nodes_.first()});
  (void)free_nodes_.push(node);
}

void CoverTree::begin() {
  nodes_.begin();
  old_firsts_.begin();
  free_nodes_.begin();
}

void CoverTree::roll_back() {
  nodes_.roll_back();
  old_firsts_.roll_back([&](const OldFirst& old) { firsts_[old.polygon].node = old.node; });
  free_nodes_.roll_back();
}

void CoverTree::count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const {
  nodes_.count_memory(use, part);
  firsts_.count_memory(use, part);
  old_firsts_.count_memory(use);
  memory::count_spare(use, kept_);
}

void CoverTree::shrink_to_fit() {
  nodes_.shrink_to_fit();
  firsts_.shrink_to_fit();
  old_firsts_.release();
  memory::release(kept_);
}

}  // namespace waywright::nav
