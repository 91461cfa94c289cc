#pragma once

#include <cstddef>
#include <cstdint>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "memory/journal.hpp"
#include "mesh/index.hpp"

namespace waywright::clearance {

/// The foot bridges of a mesh, and for each wall a *row*: the feet on the left of the wall, in its direction.
///
///           c1      c2  c3           corners
///     ------|-------|---|------>     a wall, with the feet of three bridges on its left
///           f1      f2  f3           its row
///
/// A row is a treap, so it does not matter how many corners face one wall:
///
///     feet_[i] = {corner, from, left, right, parent}   left and right are 0 or an index + 1
///     rows_[r] = {wall, line, root}
///
/// - The feet below `left` come before foot i on the wall, and those below `right` after it.
/// - The priority of a foot, a hash of its index, is at least as large as the priorities of the feet below it.
/// - The parent of a root is kIsRow plus the index of its row. A row is never empty.
///
/// A row can move to another half-edge, be split, and be joined with the next one, without a change of most of its
/// feet. All costs are the depth of the treap, which is expected to be the logarithm of the number of feet.
/// roll_back() undoes all changes since begin(), and allocates nothing.
class Feet {
 public:
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;

  struct Foot {
    mesh::HalfEdge corner;  ///< the bridge starts at the origin and runs into the face of this half-edge
    mesh::Vertex from;      ///< the origin of `corner`, as it was when the foot was made
    std::uint32_t left, right, parent;
  };
  /// The feet on a wall.
  struct Row {
    mesh::HalfEdge wall;       ///< has the bridges on its left
    mesh::Vertex from, to;     ///< the ends of the wall
    std::uint32_t root = 0;    ///< a foot
    Point line_from, line_to;  ///< the ends of a side on the wall, in the direction of the wall
  };

  [[nodiscard]] const Foot& foot(std::uint32_t i) const { return feet_[i]; }
  [[nodiscard]] const Row& row(std::uint32_t r) const { return rows_[r]; }
  /// The number of slots of feet, including free slots. The number of every foot is below it.
  [[nodiscard]] std::size_t slots() const { return feet_.size(); }
  [[nodiscard]] std::uint32_t row_of(std::uint32_t foot) const;
  /// The first foot of a row.
  [[nodiscard]] std::uint32_t first(std::uint32_t row) const { return leftmost(rows_[row].root); }
  /// The next foot of the same row, or kNone.
  [[nodiscard]] std::uint32_t next(std::uint32_t foot) const;
  /// The last foot of the row for which is_before(foot) is true, or kNone. Requires: if it is true for a foot, it is
  /// true for the feet before it.
  template <class IsBefore>
  [[nodiscard]] std::uint32_t last_before(std::uint32_t row, IsBefore&& is_before) const {
    std::uint32_t result = kNone;
    for (std::uint32_t link = rows_[row].root + 1; link != 0;) {
      const std::uint32_t i = link - 1;
      const bool is_left = is_before(i);
      if (is_left) result = i;
      link = is_left ? feet_[i].right : feet_[i].left;
    }
    return result;
  }

  /// Makes a foot that belongs to no row yet.
  [[nodiscard]] std::uint32_t add(mesh::HalfEdge corner, mesh::Vertex from);
  /// Makes a row that consists of the tree with this root.
  [[nodiscard]] std::uint32_t add_row(const Row& row);
  /// Puts a foot that belongs to no row into the row, behind the feet for which is_before(foot) is true.
  template <class IsBefore>
  void insert(std::uint32_t row, std::uint32_t foot, IsBefore&& is_before) {
    // Goes down to the tree whose root has a lower priority, splits it, and makes the parts the children of the foot.
    std::uint32_t parent = kIsRow | row;
    bool is_left = false;
    std::uint32_t link = rows_[row].root + 1;
    while (link != 0 && priority(link - 1) >= priority(foot)) {
      parent = link - 1;
      is_left = !is_before(parent);
      link = is_left ? feet_[parent].left : feet_[parent].right;
    }
    const auto [left, right] = split(link, is_before);
    Foot changed = feet_[foot];
    changed.left = left;
    changed.right = right;
    changed.parent = parent;
    feet_.write(foot, changed);
    set_parent(left, foot);
    set_parent(right, foot);
    set_child(parent, is_left, foot + 1);
  }
  /// Takes a foot out of its row and frees it. Returns the row if it was the last foot of the row, which is then freed,
  /// too; otherwise kNone.
  std::uint32_t remove(std::uint32_t foot);
  void set_corner(std::uint32_t foot, mesh::HalfEdge corner);
  void set_row(std::uint32_t row, const Row& changed) { rows_.write(row, changed); }

  // Trees without a row. A tree is 0 or the index of its root + 1.

  /// Frees the row, and returns its tree.
  [[nodiscard]] std::uint32_t take(std::uint32_t row);
  struct Parts {
    std::uint32_t before, after;
  };
  /// Splits a tree into the feet for which is_before(foot) is true, and the others.
  template <class IsBefore>
  [[nodiscard]] Parts split(std::uint32_t tree, IsBefore&& is_before) {
    if (tree == 0) return {0, 0};
    const std::uint32_t root = tree - 1;
    if (is_before(root)) {
      const Parts parts = split(feet_[root].right, is_before);
      set_link(root, &Foot::right, parts.before);
      return {tree, parts.after};
    }
    const Parts parts = split(feet_[root].left, is_before);
    set_link(root, &Foot::left, parts.after);
    return {parts.before, tree};
  }
  /// Joins two trees. Requires: all feet of the first come before all feet of the second.
  [[nodiscard]] std::uint32_t join(std::uint32_t before, std::uint32_t after);
  /// Frees all feet of a tree. Calls visit(corner) for each.
  template <class Visit>
  void free_tree(std::uint32_t tree, Visit&& visit) {
    if (tree == 0) return;
    const Foot foot = feet_[tree - 1];
    free_tree(foot.left, visit);
    free_tree(foot.right, visit);
    visit(foot.corner);
    free_foot(tree - 1);
  }

  void begin();
  void roll_back();
  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

  /// Returns whether the trees obey the rules above.
  [[nodiscard]] bool is_valid() const;

 private:
  static constexpr std::uint32_t kIsRow = 0x80000000;

  /// A bijection with well mixed bits (the finaliser of MurmurHash3, public domain).
  [[nodiscard]] static constexpr std::uint32_t priority(std::uint32_t foot) {
    foot ^= foot >> 16;
    foot *= 0x85ebca6b;
    foot ^= foot >> 13;
    foot *= 0xc2b2ae35;
    return foot ^ foot >> 16;
  }

  [[nodiscard]] std::uint32_t leftmost(std::uint32_t foot) const;
  void set_link(std::uint32_t foot, std::uint32_t Foot::*side, std::uint32_t tree);
  void set_parent(std::uint32_t tree, std::uint32_t parent);
  void set_child(std::uint32_t parent, bool is_left, std::uint32_t tree);
  void free_foot(std::uint32_t foot);
  void free_row(std::uint32_t row);

  memory::JournaledArray<Foot> feet_;
  memory::JournaledArray<Row> rows_;
  memory::FreeList free_feet_;  ///< linked by Foot::left
  memory::FreeList free_rows_;  ///< linked by Row::root
};

}  // namespace waywright::clearance
