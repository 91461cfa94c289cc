#include "clearance/wall_tree.hpp"

#include <tuple>

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;

Box WallTree::box_of(const Triangulation& triangulation, HalfEdge wall) {
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const Point& p = geometry.rounded(number(triangulation.topology().origin(wall)));
  const Point& q = geometry.rounded(number(triangulation.topology().target(wall)));
  return both({p, p}, {q, q});
}

void WallTree::begin() {
  nodes_.begin();
  leaf_at_.begin();
  free_nodes_.begin();
  trees_before_ = trees_;
}

void WallTree::roll_back() {
  nodes_.roll_back();
  leaf_at_.roll_back();
  free_nodes_.roll_back();
  trees_.swap(trees_before_);
}

// Before the first build(), `leaf_at_` is empty or has old entries, of a build() that was undone. So undoing this one
// need not restore them.
void WallTree::build(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  leaf_at_.grow_to(std::size_t{3} * mesh.face_slots(), 0);
  to_build_.clear();
  for (std::uint32_t i = 0; i < leaf_at_.size(); ++i) leaf_at_.unrecorded(i) = 0;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (!triangulation.triangulation().is_in_domain(mesh::face(h)) || !mesh.is_fixed(h)) continue;
    const HalfEdge twin = mesh.twin(h);
    if (twin < h && triangulation.triangulation().is_in_domain(mesh::face(twin))) continue;
    to_build_.emplace_back(box_of(triangulation, h), h);
  }
  nodes_.reserve(2 * to_build_.size());
  std::sort(to_build_.begin(), to_build_.end(),
            [](const auto& p, const auto& q) { return size_of(p.first) > size_of(q.first); });
  for (std::uint32_t begin = 0; begin < to_build_.size();) {
    const int size = size_of(to_build_[begin].first);
    std::uint32_t end = begin;
    while (end < to_build_.size() && size_of(to_build_[end].first) == size) ++end;
    trees_.push_back({size, build_range(begin, end, kNone)});
    begin = end;
  }
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_.unrecorded(i);
    if (!node.is_leaf()) continue;
    leaf_at_.unrecorded(number(node.wall())) = i + 1;
    node.left = number(mesh.origin(node.wall()));
    node.right = number(mesh.target(node.wall()));
  }
  memory::release(to_build_);
}

/// Builds the tree of a range of `to_build_`. Returns its root.
std::uint32_t WallTree::build_range(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto i = static_cast<std::uint32_t>(nodes_.size());
  if (end - begin == 1) {
    nodes_.append({to_build_[begin].first, parent, 0, 0, kIsLeaf | number(to_build_[begin].second)});
    return i;
  }
  Box bounds = to_build_[begin].first;
  for (std::uint32_t k = begin; k < end; ++k) bounds = both(bounds, to_build_[k].first);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t k) { return to_build_.begin() + static_cast<std::ptrdiff_t>(k); };
  const bool is_wide = bounds.width() > bounds.height();
  std::nth_element(at(begin), at(middle), at(end), [&](const auto& p, const auto& q) {
    return is_wide ? p.first.min.x + p.first.max.x < q.first.min.x + q.first.max.x
                   : p.first.min.y + p.first.max.y < q.first.min.y + q.first.max.y;
  });
  nodes_.append({bounds, parent, 0, 0, 0});
  const std::uint32_t left = build_range(begin, middle, i);
  const std::uint32_t right = build_range(middle, end, i);
  const std::uint32_t height = 1 + std::max(nodes_[left].height(), nodes_[right].height());
  nodes_.unrecorded(i) = {bounds, parent, left, right, height};
  return i;
}

// A touched face may have another wall at each of its half-edges. Most walls of touched faces exist before and after
// the operation: their leaves only get another half-edge. A vertex may be another one although its number is the same,
// but then the wall has another box.
void WallTree::update(const Triangulation& triangulation, const mesh::TouchedFaces& touched) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  leaf_at_.grow_to(std::size_t{3} * mesh.face_slots(), 0);
  loose_.clear();
  new_walls_.clear();
  for (const Face f : touched.faces()) {
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      if (leaf_at_[i] == 0) continue;
      const Node& leaf = nodes_[leaf_at_[i] - 1];
      loose_.push_back({std::min(leaf.left, leaf.right), std::max(leaf.left, leaf.right), leaf_at_[i] - 1});
      leaf_at_.write(i, 0);
    }
  }
  std::sort(loose_.begin(), loose_.end(), [](const Loose& p, const Loose& q) {
    return std::tie(p.from, p.to, p.leaf) < std::tie(q.from, q.to, q.leaf);
  });
  for (const Face f : touched.faces()) {
    if (!triangulation.triangulation().is_in_domain(f)) continue;
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (!mesh.is_fixed(h) || leaf_at_[number(mesh.twin(h))] != 0) continue;
      const std::uint32_t leaf = take_loose(triangulation, h);
      if (leaf == kNone) {
        new_walls_.push_back(h);
        // Marks the wall, so that its other half-edge does not count as another wall.
        leaf_at_.write(i, kNone);
        continue;
      }
      Node changed = nodes_[leaf];
      changed.wall_or_height = kIsLeaf | i;
      nodes_.write(leaf, changed);
      leaf_at_.write(i, leaf + 1);
    }
  }
  for (const HalfEdge h : new_walls_) insert(triangulation, h);  // first, so that the tree is never empty
  for (const Loose& loose : loose_) {
    if (loose.leaf != kNone) remove(loose.leaf);
  }
}

/// Returns the leaf of the wall among `loose_`, and takes it out of there; or kNone.
std::uint32_t WallTree::take_loose(const Triangulation& triangulation, HalfEdge wall) {
  const std::uint32_t p = number(triangulation.topology().origin(wall));
  const std::uint32_t q = number(triangulation.topology().target(wall));
  const std::pair ends(std::min(p, q), std::max(p, q));
  const auto comes_before = [](const Loose& loose, const auto& pair) {
    return std::tie(loose.from, loose.to) < std::tie(pair.first, pair.second);
  };
  auto at = std::lower_bound(loose_.begin(), loose_.end(), ends, comes_before);
  for (; at != loose_.end() && at->from == ends.first && at->to == ends.second; ++at) {
    if (at->leaf != kNone && nodes_[at->leaf].box == box_of(triangulation, wall)) return std::exchange(at->leaf, kNone);
  }
  return kNone;
}

void WallTree::insert(const Triangulation& triangulation, HalfEdge wall) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Box box = box_of(triangulation, wall);
  const std::uint32_t leaf =
      add_node({box, kNone, number(mesh.origin(wall)), number(mesh.target(wall)), kIsLeaf | number(wall)});
  leaf_at_.write(number(wall), leaf + 1);
  Tree& tree = tree_of(box);
  if (tree.root == kNone) {
    tree.root = leaf;
    return;
  }
  const std::uint32_t sibling = sibling_for(tree.root, box);
  const std::uint32_t parent = nodes_[sibling].parent;
  const std::uint32_t inner = add_node({both(box, nodes_[sibling].box), parent, sibling, leaf, 1});
  replace_child(parent, sibling, inner, box);
  set_parent(sibling, inner);
  set_parent(leaf, inner);
  mend_from(parent, box);
}

/// Returns the tree for a box. If there is none, makes an empty one.
WallTree::Tree& WallTree::tree_of(const Box& box) {
  const int size = size_of(box);
  const auto at = std::find_if(trees_.begin(), trees_.end(), [&](const Tree& tree) { return tree.size <= size; });
  return at != trees_.end() && at->size == size ? *at : *trees_.insert(at, Tree{size, kNone});
}

/// Goes down from the root to a leaf, always to the child whose box grows less.
std::uint32_t WallTree::sibling_for(std::uint32_t root, const Box& box) const {
  std::uint32_t at = root;
  while (!nodes_[at].is_leaf()) {
    const Box& left = nodes_[nodes_[at].left].box;
    const Box& right = nodes_[nodes_[at].right].box;
    const double left_growth = extent_of(both(left, box)) - extent_of(left);
    const double right_growth = extent_of(both(right, box)) - extent_of(right);
    at = left_growth <= right_growth ? nodes_[at].left : nodes_[at].right;
  }
  return at;
}

void WallTree::remove(std::uint32_t leaf) {
  const Box box = nodes_[leaf].box;
  const std::uint32_t parent = nodes_[leaf].parent;
  free_node(leaf);
  if (parent == kNone) {
    std::erase_if(trees_, [&](const Tree& tree) { return tree.root == leaf; });
    return;
  }
  const Node inner = nodes_[parent];
  const std::uint32_t sibling = inner.left == leaf ? inner.right : inner.left;
  replace_child(inner.parent, parent, sibling, box);
  set_parent(sibling, inner.parent);
  free_node(parent);
  mend_from(inner.parent, box);
}

/// Makes the boxes, heights and balance of a node and of the nodes above it right. The node belongs to the tree for a
/// box.
void WallTree::mend_from(std::uint32_t i, const Box& box) {
  while (i != kNone) {
    const Box old_box = nodes_[i].box;
    const std::uint32_t old_height = nodes_[i].height();
    i = balanced(i, box);
    Node node = nodes_[i];
    node.box = both(nodes_[node.left].box, nodes_[node.right].box);
    node.wall_or_height = 1 + std::max(nodes_[node.left].height(), nodes_[node.right].height());
    nodes_.write(i, node);
    if (node.box == old_box && node.height() == old_height) return;
    i = node.parent;
  }
}

/// Lifts the higher child of a node if it is more than 1 higher than the other. Returns the node at the place of `i`.
std::uint32_t WallTree::balanced(std::uint32_t i, const Box& box) {
  const std::uint32_t left = nodes_[nodes_[i].left].height();
  const std::uint32_t right = nodes_[nodes_[i].right].height();
  if (left > right + 1) return lift(i, true, box);
  if (right > left + 1) return lift(i, false, box);
  return i;
}

/// Makes the left or right child c of i its parent. The higher child of c stays with c, and the other one goes to i:
///
///         i                c
///        / .              / .
///       c   b    ->  high    i
///      / .                  / .
///   high  low             low   b
std::uint32_t WallTree::lift(std::uint32_t i, bool is_left, const Box& box) {
  Node node = nodes_[i];
  const std::uint32_t c = is_left ? node.left : node.right;
  Node child = nodes_[c];
  const bool is_left_high = nodes_[child.left].height() > nodes_[child.right].height();
  const std::uint32_t high = is_left_high ? child.left : child.right;
  const std::uint32_t low = is_left_high ? child.right : child.left;
  replace_child(node.parent, i, c, box);
  child.parent = std::exchange(node.parent, c);
  child.left = high;
  child.right = i;
  (is_left ? node.left : node.right) = low;
  node.box = both(nodes_[node.left].box, nodes_[node.right].box);
  node.wall_or_height = 1 + std::max(nodes_[node.left].height(), nodes_[node.right].height());
  nodes_.write(i, node);
  nodes_.write(c, child);
  set_parent(low, i);
  return c;
}

void WallTree::set_parent(std::uint32_t i, std::uint32_t parent) {
  if (nodes_[i].parent == parent) return;
  Node changed = nodes_[i];
  changed.parent = parent;
  nodes_.write(i, changed);
}

/// Replaces a child of `parent` or, if there is none, the root of the tree for a box.
void WallTree::replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by, const Box& box) {
  if (parent == kNone) {
    tree_of(box).root = by;
    return;
  }
  Node changed = nodes_[parent];
  (changed.left == child ? changed.left : changed.right) = by;
  nodes_.write(parent, changed);
}

std::uint32_t WallTree::add_node(const Node& node) {
  if (free_nodes_.is_empty()) {
    nodes_.append(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t i = free_nodes_.first();
  const std::uint32_t next_free = nodes_[i].parent;
  nodes_.write(i, node);
  return free_nodes_.pop(next_free);
}

// Calls write() before push(): write() can throw std::bad_alloc, push() cannot.
void WallTree::free_node(std::uint32_t i) {
  nodes_.write(i, {{}, free_nodes_.first(), 0, 0, 0});
  (void)free_nodes_.push(i);
}

std::optional<std::string> WallTree::find_fault(const Triangulation& triangulation) const {
  if (!is_built()) return std::nullopt;
  const mesh::TriangleMesh& mesh = triangulation.topology();
  std::size_t walls = 0;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (!triangulation.triangulation().is_in_domain(mesh::face(h)) || !mesh.is_fixed(h)) continue;
    const auto leaf_of = [&](HalfEdge of) { return number(of) < leaf_at_.size() ? leaf_at_[number(of)] : 0; };
    const HalfEdge twin = mesh.twin(h);
    const bool is_other_inside = triangulation.triangulation().is_in_domain(mesh::face(twin));
    const std::uint32_t other = is_other_inside ? leaf_of(twin) : 0;
    if ((leaf_of(h) == 0) == (other == 0)) return "the tree has not one leaf for the wall " + std::to_string(i);
    if (leaf_of(h) == 0) continue;
    const Node& leaf = nodes_[leaf_of(h) - 1];
    ++walls;
    if (!leaf.is_leaf() || leaf.wall() != h || !(leaf.box == box_of(triangulation, h)) ||
        std::min(leaf.left, leaf.right) != std::min(number(mesh.origin(h)), number(mesh.target(h))) ||
        std::max(leaf.left, leaf.right) != std::max(number(mesh.origin(h)), number(mesh.target(h)))) {
      return "the tree has a wrong leaf for the wall " + std::to_string(i);
    }
  }
  std::size_t leaves = 0;
  std::vector<std::uint32_t> stack;
  for (const Tree& tree : trees_) stack.push_back(tree.root);
  while (!stack.empty()) {
    const std::uint32_t i = stack.back();
    stack.pop_back();
    const Node& node = nodes_[i];
    leaves += node.is_leaf() ? 1 : 0;
    if (node.is_leaf()) continue;
    const Node& left = nodes_[node.left];
    const Node& right = nodes_[node.right];
    const bool is_right = left.parent == i && right.parent == i && node.box == both(left.box, right.box) &&
                          node.height() == 1 + std::max(left.height(), right.height()) &&
                          left.height() + 1 >= right.height() && right.height() + 1 >= left.height();
    if (!is_right) return "the tree of walls is wrong at the node " + std::to_string(i);
    stack.push_back(node.left);
    stack.push_back(node.right);
  }
  return leaves == walls ? std::nullopt : std::optional<std::string>("the tree has a leaf without a wall");
}

void WallTree::count_memory(MemoryUse& use) const {
  nodes_.count_memory(use, &MemoryUse::bridges);
  leaf_at_.count_memory(use, &MemoryUse::bridges);
  memory::count_spare(use, trees_, trees_before_, loose_, new_walls_, to_build_);
}

void WallTree::shrink_to_fit() {
  nodes_.shrink_to_fit();
  leaf_at_.shrink_to_fit();
  memory::shrink(trees_);
  memory::release(trees_before_, loose_, new_walls_, to_build_);
}

}  // namespace waywright::clearance
