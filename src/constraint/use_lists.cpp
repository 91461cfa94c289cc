#include "constraint/use_lists.hpp"

namespace waywright::constraint {

Uses UseLists::add(Uses list, std::uint32_t user) {
  if (list == kNone) return of(user);
  if (first_free_ == kNone) {
    nodes_.push_back({user, list});
    return static_cast<Uses>(nodes_.size() - 1) | kNode;
  }
  const Uses result = first_free_;
  Node& node = nodes_[result & ~kNode];
  first_free_ = node.rest;
  node = {user, list};
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

// The last node of a list holds two users, its own and the lone one that is its rest; it goes when either does.
Uses UseLists::remove(Uses list, std::uint32_t user) {
  if (!is_node(list)) return kNone;
  Uses at = list;
  Uses* link = &list;
  for (;;) {
    const Node node = nodes_[at & ~kNode];
    if (node.user == user || node.rest == of(user)) {
      *link = node.user == user ? node.rest : of(node.user);
      free_node(at);
      return list;
    }
    link = &nodes_[at & ~kNode].rest;
    at = node.rest;
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
  nodes_[list & ~kNode].rest = first_free_;
  first_free_ = list;
}

}  // namespace waywright::constraint
