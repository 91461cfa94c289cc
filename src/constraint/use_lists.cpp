#include "constraint/use_lists.hpp"

namespace waywright::constraint {

Uses UseLists::add(Uses list, std::uint32_t user) {
  if (list == kNone) return of(user);
  nodes_.push_back({user, list});
  return static_cast<Uses>(nodes_.size() - 1) | kNode;
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

}  // namespace waywright::constraint
