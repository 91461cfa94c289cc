#include "constraint/use_lists.hpp"

namespace waywright::constraint {

Uses UseLists::add(Uses list, std::uint32_t user) {
  if (list == kNone) return of(user);
  if (first_free_ == kNone) {
    nodes_.push_back({user, list});
    return static_cast<Uses>(nodes_.size() - 1) | kNode;
  }
  const Uses result = first_free_;
  const Uses next_free = nodes_[result & ~kNode].rest;
  write(result, {user, list});
  first_free_ = next_free;
  return result;
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
    if (node.user != user && node.rest != of(user)) {
      before = at;
      at = node.rest;
      continue;
    }
    const Uses rest = node.user == user ? node.rest : of(node.user);
    if (before != kNone) write(before, {nodes_[before & ~kNode].user, rest});
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
  return list == of(user);
}

void UseLists::free_node(Uses list) {
  write(list, {nodes_[list & ~kNode].user, first_free_});
  first_free_ = list;
}

void UseLists::write(Uses list, const Node& node) {
  const std::uint32_t index = list & ~kNode;
  log_.push_back({index, nodes_[index]});
  nodes_[index] = node;
}

void UseLists::begin() {
  log_.clear();
  size_before_ = nodes_.size();
  first_free_before_ = first_free_;
}

void UseLists::roll_back() {
  for (; !log_.empty(); log_.pop_back()) nodes_[log_.back().index] = log_.back().node;
  nodes_.resize(size_before_);
  first_free_ = first_free_before_;
}

}  // namespace waywright::constraint
