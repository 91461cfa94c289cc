#pragma once

#include <cstdint>

#include "waywright/memory_use.hpp"

#include "memory/journal.hpp"

namespace waywright::constraint {

/// A list of the users of an edge or a vertex, as one 32-bit number. 0 is the empty list. A list of one user, which is
/// by far the most common, is encoded in the number itself and takes no memory.
using Uses = std::uint32_t;

/// Stores lists of users. A user is a number from 0 to kLargestUser. The lists are unordered, and may contain a user
/// more than once. An undo log records all changes; roll_back() returns to the last begin().
///
/// A longer list is a search tree by user. The hash of a user is its priority: no node has a child of higher priority.
/// So the structure of a tree depends only on its users. Source: Seidel and Aragon, *Randomized search trees*,
/// Algorithmica 1996. Cost: expected O(log n) for add(), remove() and contains() in a list of n users; O(n) for copy(),
/// release() and for_each().
class UseLists {
 public:
  static constexpr Uses kNone = 0;
  /// The largest number of a user. (The encoding also has room for the next number, 2^31 - 2, but not for 2^31 - 1: the
  /// highest bit of single() must be 0, because this bit marks the lists that have nodes.)
  static constexpr std::uint32_t kLargestUser = 0x7ffffffd;

  /// Returns the list of one user. Allocates nothing.
  [[nodiscard]] static constexpr Uses single(std::uint32_t user) { return user + 1; }

  [[nodiscard]] Uses add(Uses list, std::uint32_t user) { return list == kNone ? single(user) : add_to(list, user); }
  [[nodiscard]] Uses copy(Uses list) { return is_node(list) ? copy_nodes(list) : list; }
  /// Removes one entry of `user` and returns the new list. Requires: `user` is in the list.
  [[nodiscard]] Uses remove(Uses list, std::uint32_t user) {
    return is_node(list) ? remove_from_nodes(list, user) : kNone;
  }
  /// Frees the memory of a list. The caller must not use the list any more.
  void release(Uses list);
  [[nodiscard]] bool contains(Uses list, std::uint32_t user) const {
    while (is_node(list)) {
      const Node& node = node_of(list);
      if (node.user == user) return true;
      list = user < node.user ? node.less : node.greater;
    }
    return list == single(user);
  }

  /// Returns true only if the list has five entries or more: a node at the root of the tree, two entries or more with
  /// lower numbers, and two or more with higher numbers. For a list of n different users, n >= 5, the result is false
  /// with a probability of about 4 / n. Cost: O(1).
  [[nodiscard]] bool has_many(Uses list) const {
    return is_node(list) && is_node(node_of(list).less) && is_node(node_of(list).greater);
  }

  /// Empties the undo log.
  void begin();
  /// Undoes all changes since begin(). Allocates nothing.
  void roll_back();

  /// Calls visit(user) for each user in the list.
  template <class Visit>
  void for_each(Uses list, Visit&& visit) const {
    while (is_node(list)) {
      const Node& node = node_of(list);
      for (std::uint32_t i = 0; i < node.count; ++i) visit(node.user);
      if (node.less != kNone) for_each(node.less, visit);
      list = node.greater;
    }
    if (list != kNone) visit(list - 1);
  }

  /// One of the users. Requires: the list is not empty.
  [[nodiscard]] std::uint32_t any(Uses list) const { return is_node(list) ? node_of(list).user : list - 1; }

  /// Adds the memory of the lists to `part`.
  void count_memory(MemoryUse& use, std::size_t MemoryUse::*part) const { nodes_.count_memory(use, part); }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() { nodes_.shrink_to_fit(); }

 private:
  static constexpr std::uint32_t kNode = 0x80000000;

  /// A user, the number of its entries in the list, and the lists of the users with lower and with higher numbers. A
  /// node with count 1 has another user below it.
  struct Node {
    std::uint32_t user;
    std::uint32_t count;
    Uses less;  ///< of a free node: the next free node
    Uses greater;
  };

  [[nodiscard]] static bool is_node(Uses list) { return (list & kNode) != 0; }
  [[nodiscard]] const Node& node_of(Uses list) const { return nodes_[list & ~kNode]; }

  [[nodiscard]] Uses add_to(Uses list, std::uint32_t user);
  [[nodiscard]] Uses copy_nodes(Uses list);
  [[nodiscard]] Uses remove_from_nodes(Uses list, std::uint32_t user);
  void split(Uses list, std::uint32_t user, Uses& less, Uses& greater);
  [[nodiscard]] Uses merge(Uses less, Uses greater);
  [[nodiscard]] Uses add_node(const Node& node);
  [[nodiscard]] Uses write_node(Uses list, const Node& node);
  void free_node(Uses list);

  memory::JournaledArray<Node> nodes_;
  memory::FreeList free_nodes_;  ///< linked by Node::less
};

}  // namespace waywright::constraint
