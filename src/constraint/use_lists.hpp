#pragma once

#include <cstdint>

#include "waywright/memory_use.hpp"

#include "memory/free_list.hpp"
#include "memory/journaled_array.hpp"

namespace waywright::constraint {

/// A list of the users of an edge or a vertex, as one 32-bit number: 0 for none; a lone user, by far the most common
/// list, is told by the number itself and takes no memory.
using Uses = std::uint32_t;

/// Keeps lists of users, numbers below 2^31 - 1. The lists are unordered; a user may be in one more than once. What
/// happens to them is logged and can be taken back to the last begin().
class UseLists {
 public:
  static constexpr Uses kNone = 0;
  static constexpr std::uint32_t kLargestUser = 0x7ffffffd;

  [[nodiscard]] static constexpr Uses of(std::uint32_t user) { return user + 1; }

  [[nodiscard]] Uses add(Uses list, std::uint32_t user);
  [[nodiscard]] Uses copy(Uses list);
  /// The list less one entry of `user`. Requires: `user` is in it.
  [[nodiscard]] Uses remove(Uses list, std::uint32_t user);
  /// Gives back what a list holds; the list is not to be used again.
  void release(Uses list);
  [[nodiscard]] bool contains(Uses list, std::uint32_t user) const;

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  /// Calls visit(user) for each.
  template <class Visit>
  void for_each(Uses list, Visit&& visit) const {
    for (; is_node(list); list = nodes_[list & ~kNode].rest) visit(nodes_[list & ~kNode].user);
    if (list != kNone) visit(list - 1);
  }

  /// Any one of the users. Requires: the list isn't empty.
  [[nodiscard]] std::uint32_t any(Uses list) const { return is_node(list) ? nodes_[list & ~kNode].user : list - 1; }

  /// Counts what lists hold in with that part.
  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const { nodes_.count_memory(use, part); }
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() { nodes_.shrink_to_fit(); }

 private:
  static constexpr std::uint32_t kNode = 0x80000000;

  /// A user in front of a shorter list.
  struct Node {
    std::uint32_t user;
    Uses rest;
  };

  [[nodiscard]] static bool is_node(Uses list) { return (list & kNode) != 0; }

  void free_node(Uses list);

  memory::JournaledArray<Node> nodes_;
  memory::FreeList free_nodes_;  ///< linked by Node::rest
  memory::FreeList free_nodes_before_;
};

}  // namespace waywright::constraint
