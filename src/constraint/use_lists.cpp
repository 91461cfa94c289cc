#include "constraint/use_lists.hpp"

namespace waywright::constraint {

Uses UseLists::add(Uses list, std::uint32_t user) {
  if (list == kNone) return single(user);
  if (free_nodes_.is_empty()) {
    nodes_.append({user, list});
    return static_cast<Uses>(nodes_.size() - 1) | kNode;
  }
  const std::uint32_t index = free_nodes_.first();
  const std::uint32_t next_free = nodes_[index].rest;
  nodes_.write(index, {user, list});
  free_nodes_.pop(next_free);
  return index | kNode;
}

Uses UseLists::copy(Uses list) {
  Uses result = kNone;
  while (is_node(list)) {
    const Node node = nodes_[list & ~kNode];
    result = add(result, node.user);
    list = node.rest;
  }
  return list == kNone ? result : add(result, list - 1);
}

// The last node of a list stands for two users: its own, and the single one in `rest`. The removal of either frees the
// node.
Uses UseLists::remove(Uses list, std::uint32_t user) {
  if (!is_node(list)) return kNone;
  Uses before = kNone;
  for (Uses at = list;;) {
    const Node node = nodes_[at & ~kNode];
    if (node.user != user && node.rest != single(user)) {
      before = at;
      at = node.rest;
      continue;
    }
    const Uses rest = node.user == user ? node.rest : single(node.user);
    if (before != kNone) nodes_.write(before & ~kNode, {nodes_[before & ~kNode].user, rest});
    free_node(at);
    return before == kNone ? rest : list;
  }
}

void UseLists::release(Uses list) {
  while (is_node(list)) {
    const Uses rest = nodes_[list & ~kNode].rest;
    free_node(list);
    list = rest;
  }
}

bool UseLists::contains(Uses list, std::uint32_t user) const {
  for (; is_node(list); list = nodes_[list & ~kNode].rest) {
    if (nodes_[list & ~kNode].user == user) return true;
  }
  return list == single(user);
}

// write() comes first: it may run out of memory.
void UseLists::free_node(Uses list) {
  const std::uint32_t index = list & ~kNode;
  nodes_.write(index, {nodes_[index].user, free_nodes_.first()});
  (void)free_nodes_.push(index);
}

void UseLists::begin() {
  nodes_.begin();
  free_nodes_before_ = free_nodes_;
}

void UseLists::roll_back() {
  nodes_.roll_back();
  free_nodes_ = free_nodes_before_;
}

}  // namespace waywright::constraint
