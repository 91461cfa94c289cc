#include "constraint/use_lists.hpp"

#include "constraint/item_hash.hpp"

namespace waywright::constraint {

namespace {

/// Whether the node of user `p` lies above the node of user `q`.
bool is_above(std::uint32_t p, std::uint32_t q) { return mix(p) > mix(q); }

}  // namespace

/// Adds a user to a list that is not empty.
Uses UseLists::add_to(Uses list, std::uint32_t user) {
  const bool is_single = !is_node(list);
  Node node = is_single ? Node{list - 1, 1, kNone, kNone} : node_of(list);
  if (node.user == user) {
    ++node.count;
    return is_single ? add_node(node) : write_node(list, node);
  }
  if (is_above(user, node.user)) {
    Node root{user, 1, kNone, kNone};
    split(list, user, root.less, root.greater);
    return add_node(root);
  }
  Uses& child = user < node.user ? node.less : node.greater;
  child = add(child, user);
  return is_single ? add_node(node) : write_node(list, node);
}

/// Divides a list without `user` into the users with lower and with higher numbers.
void UseLists::split(Uses list, std::uint32_t user, Uses& less, Uses& greater) {
  if (!is_node(list)) {
    less = greater = kNone;
    (list != kNone && list - 1 < user ? less : greater) = list;
    return;
  }
  Node node = node_of(list);
  if (node.user < user) {
    split(node.greater, user, node.greater, greater);
    less = write_node(list, node);
  } else {
    split(node.less, user, less, node.less);
    greater = write_node(list, node);
  }
}

/// Makes one list of two. Requires: each user in `less` is lower than each user in `greater`.
Uses UseLists::merge(Uses less, Uses greater) {
  if (less == kNone) return greater;
  if (greater == kNone) return less;
  const bool is_less_above = is_above(any(less), any(greater));
  const Uses list = is_less_above ? less : greater;
  Node root = is_node(list) ? node_of(list) : Node{list - 1, 1, kNone, kNone};
  if (is_less_above) {
    root.greater = merge(root.greater, greater);
  } else {
    root.less = merge(less, root.less);
  }
  return is_node(list) ? write_node(list, root) : add_node(root);
}

Uses UseLists::remove_from_nodes(Uses list, std::uint32_t user) {
  Node node = node_of(list);
  if (node.user == user) {
    if (node.count == 1) {
      free_node(list);
      return merge(node.less, node.greater);
    }
    --node.count;
  } else {
    Uses& child = user < node.user ? node.less : node.greater;
    child = remove(child, user);
  }
  return write_node(list, node);
}

Uses UseLists::copy_nodes(Uses list) {
  Node node = node_of(list);
  node.less = copy(node.less);
  node.greater = copy(node.greater);
  return add_node(node);
}

void UseLists::release(Uses list) {
  while (is_node(list)) {
    const Node node = node_of(list);
    free_node(list);
    release(node.less);
    list = node.greater;
  }
}

Uses UseLists::add_node(const Node& node) {
  if (free_nodes_.is_empty()) {
    nodes_.append(node);
    return static_cast<Uses>(nodes_.size() - 1) | kNode;
  }
  const std::uint32_t index = free_nodes_.first();
  const std::uint32_t next_free = nodes_[index].less;
  nodes_.write(index, node);
  free_nodes_.pop(next_free);
  return index | kNode;
}

/// Changes a node. Returns the list: a number without a node, if only one user is left.
Uses UseLists::write_node(Uses list, const Node& node) {
  if (node.count == 1 && node.less == kNone && node.greater == kNone) {
    free_node(list);
    return single(node.user);
  }
  nodes_.write(list & ~kNode, node);
  return list;
}

// write() comes first: it may run out of memory.
void UseLists::free_node(Uses list) {
  const std::uint32_t index = list & ~kNode;
  nodes_.write(index, {nodes_[index].user, 0, free_nodes_.first(), kNone});
  (void)free_nodes_.push(index);
}

void UseLists::begin() {
  nodes_.begin();
  free_nodes_.begin();
}

void UseLists::roll_back() {
  nodes_.roll_back();
  free_nodes_.roll_back();
}

}  // namespace waywright::constraint
