#pragma once

#include <cstdint>

#include "waywright/memory_use.hpp"

#include "memory/free_list.hpp"
#include "memory/journaled_array.hpp"

namespace waywright::constraint {

/// A list of the users of an edge or a vertex, as one 32-bit number. 0 is the empty list. A list of one user, which is
/// by far the most common, is encoded in the number itself and takes no memory.
using Uses = std::uint32_t;

/// Stores lists of users, which are numbers below 2^31 - 1. The lists are unordered, and may contain a user more than
/// once. An undo log records all changes; roll_back() returns to the last begin().
class UseLists {
 public:
  static constexpr Uses kNone = 0;
  static constexpr std::uint32_t kLargestUser = 0x7ffffffd;

  /// Returns the list of one user. Allocates nothing.
  [[nodiscard]] static constexpr Uses single(std::uint32_t user) { return user + 1; }

  [[nodiscard]] Uses add(Uses list, std::uint32_t user);
  [[nodiscard]] Uses copy(Uses list);
  /// Removes one entry of `user` and returns the new list. Requires: `user` is in the list.
  [[nodiscard]] Uses remove(Uses list, std::uint32_t user);
  /// Frees the memory of a list. The caller must not use the list any more.
  void release(Uses list);
  [[nodiscard]] bool contains(Uses list, std::uint32_t user) const;

  /// Empties the undo log.
  void begin();
  /// Undoes all changes since begin(). Allocates nothing.
  void roll_back();

  /// Calls visit(user) for each user in the list.
  template <class Visit>
  void for_each(Uses list, Visit&& visit) const {
    for (; is_node(list); list = nodes_[list & ~kNode].rest) visit(nodes_[list & ~kNode].user);
    if (list != kNone) visit(list - 1);
  }

  /// One of the users. Requires: the list is not empty.
  [[nodiscard]] std::uint32_t any(Uses list) const { return is_node(list) ? nodes_[list & ~kNode].user : list - 1; }

  /// Adds the memory of the lists to `part`.
  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const { nodes_.count_memory(use, part); }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() { nodes_.shrink_to_fit(); }

 private:
  static constexpr std::uint32_t kNode = 0x80000000;

  /// A list of two or more users: a user, and the list of the others.
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
