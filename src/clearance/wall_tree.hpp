#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"
#include "mesh/touched_faces.hpp"

namespace waywright::clearance {

/// Trees of boxes over the walls of a mesh. A search in them goes straight to far walls, where a search from face to
/// face would cross very many edges. Most worlds never need them, so nobody builds them before the first such search;
/// from then on, each operation updates them.
///
///     trees_[t]   = {size, root}                        a tree for walls of similar size; the longest walls come first
///     nodes_[i]   = {box, parent, left, right, wall}
///     leaf_at_[h] = the leaf of the wall of h, + 1, or 0; at one of the two half-edges of each wall
///
/// - The walls of one tree differ in size by a factor below 4. So one long wall does not make the boxes above many
///   short walls large.
/// - A leaf has the box of one wall (from the rounded positions of its ends), and `wall` is the half-edge with
///   leaf_at_[wall] == leaf + 1. Its members `left` and `right` are the ends of the wall.
/// - The box of another node contains the boxes of its two children, whose heights differ by at most 1.
///
/// Cost: an insertion and a removal change O(log n) nodes. Source: Catto, *Dynamic bounding volume hierarchies*, 2019
/// (balance by rotations, as in an AVL tree).
class WallTree {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// The border of the domain always has walls, so a tree that is built is never empty.
  [[nodiscard]] bool is_built() const { return !trees_.empty(); }
  /// Builds the tree. Cost: n log n in the walls.
  void build(const Triangulation& triangulation);
  /// Updates the tree. Requires: the tree is built, the operation of the triangulation is open, and `touched` are the
  /// faces that it has touched.
  void update(const Triangulation& triangulation, const mesh::TouchedFaces& touched);

  void begin();
  /// Undoes all changes since begin(), also a build(). Allocates nothing.
  void roll_back();

  /// Calls visit(wall) for each wall whose box overlaps `box`, but leaves out some walls in a box for which meets(box)
  /// is false. If visit() returns false, stops and returns false.
  template <class Meets, class Visit>
  bool for_each_in(const Box& box, Meets&& meets, Visit&& visit) const {
    std::array<std::uint32_t, kLargestHeight + 2> stack;
    for (const Tree& tree : trees_) {
      std::size_t count = 0;
      const auto push = [&](std::uint32_t i) {
        stack[count] = i;
        count += nodes_[i].box.overlaps(box) ? 1 : 0;
      };
      push(tree.root);
      while (count > 0) {
        const Node& node = nodes_[stack[--count]];
        // The test of a wall takes about as long as that of a box.
        if (node.height() > 1 && !meets(node.box)) continue;
        if (node.is_leaf()) {
          if (!visit(node.wall())) return false;
          continue;
        }
        push(node.left);
        push(node.right);
      }
    }
    return true;
  }
  /// Calls visit(wall) for walls whose boxes overlap `box`, at each node the nearer child to `from` first. visit() may
  /// make the box smaller, to leave out walls.
  template <class Visit>
  void search(const Box& box, const Point& from, Visit&& visit) const {
    std::array<std::uint32_t, kLargestHeight + 2> stack;
    for (const Tree& tree : trees_) {
      std::size_t count = 0;
      stack[count++] = tree.root;
      while (count > 0) {
        const Node& node = nodes_[stack[--count]];
        if (!node.box.overlaps(box)) continue;
        if (node.is_leaf()) {
          visit(node.wall());
          continue;
        }
        const bool is_left_nearer = distance(nodes_[node.left].box, from) <= distance(nodes_[node.right].box, from);
        stack[count++] = is_left_nearer ? node.right : node.left;
        stack[count++] = is_left_nearer ? node.left : node.right;
      }
    }
  }

  /// Returns the first difference from the walls of the mesh, or nothing. Cost: n log n.
  [[nodiscard]] std::optional<std::string> find_fault(const Triangulation& triangulation) const;
  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;
  static constexpr std::uint32_t kIsLeaf = 0x80000000;
  static constexpr std::size_t kLargestHeight = 48;  ///< of a balanced tree with 2^32 nodes

  struct Node {
    Box box;
    std::uint32_t parent, left, right;
    std::uint32_t wall_or_height;  ///< of a leaf: kIsLeaf plus the half-edge; otherwise the height

    [[nodiscard]] bool is_leaf() const { return (wall_or_height & kIsLeaf) != 0; }
    [[nodiscard]] std::uint32_t height() const { return is_leaf() ? 0 : wall_or_height; }
    [[nodiscard]] mesh::HalfEdge wall() const { return mesh::HalfEdge{wall_or_height & ~kIsLeaf}; }
  };
  struct Tree {
    int size;
    std::uint32_t root;
  };
  /// A leaf whose half-edge belonged to a touched face.
  struct Loose {
    std::uint32_t from, to, leaf;
  };

  /// The distance of a box from a position, where the distance of two positions is the larger of their differences in x
  /// and in y.
  [[nodiscard]] static double distance(const Box& box, const Point& p) {
    return std::max({box.min.x - p.x, p.x - box.max.x, box.min.y - p.y, p.y - box.max.y});
  }
  [[nodiscard]] static Box box_of(const Triangulation& triangulation, mesh::HalfEdge wall);
  [[nodiscard]] static Box both(const Box& p, const Box& q) {
    return {{std::min(p.min.x, q.min.x), std::min(p.min.y, q.min.y)},
            {std::max(p.max.x, q.max.x), std::max(p.max.y, q.max.y)}};
  }
  [[nodiscard]] static double extent_of(const Box& box) { return box.width() + box.height(); }
  /// See Tree::size.
  [[nodiscard]] static int size_of(const Box& box) {
    int exponent = 0;
    (void)std::frexp(std::max(box.width(), box.height()), &exponent);
    return (exponent + 4096) / 2;
  }
  [[nodiscard]] Tree& tree_of(const Box& box);

  [[nodiscard]] std::uint32_t build_range(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  [[nodiscard]] std::uint32_t take_loose(const Triangulation& triangulation, mesh::HalfEdge wall);
  void insert(const Triangulation& triangulation, mesh::HalfEdge wall);
  void remove(std::uint32_t leaf);
  [[nodiscard]] std::uint32_t sibling_for(std::uint32_t root, const Box& box) const;
  [[nodiscard]] std::uint32_t add_node(const Node& node);
  void free_node(std::uint32_t i);
  void mend_from(std::uint32_t i, const Box& box);
  [[nodiscard]] std::uint32_t balanced(std::uint32_t i, const Box& box);
  [[nodiscard]] std::uint32_t lift(std::uint32_t i, bool is_left, const Box& box);
  void set_parent(std::uint32_t i, std::uint32_t parent);
  void replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by, const Box& box);

  memory::JournaledArray<Node> nodes_;
  memory::JournaledArray<std::uint32_t> leaf_at_;
  memory::FreeList free_nodes_;  ///< linked by Node::parent
  std::vector<Tree> trees_, trees_before_;

  // Scratch.
  std::vector<Loose> loose_;
  std::vector<mesh::HalfEdge> new_walls_;
  std::vector<std::pair<Box, mesh::HalfEdge>> to_build_;
};

}  // namespace waywright::clearance
