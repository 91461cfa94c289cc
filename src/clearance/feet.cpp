#include "clearance/feet.hpp"

namespace waywright::clearance {

using mesh::HalfEdge;

std::uint32_t Feet::row_of(std::uint32_t foot) const {
  while ((feet_[foot].parent & kIsRow) == 0) foot = feet_[foot].parent;
  return feet_[foot].parent & ~kIsRow;
}

std::uint32_t Feet::leftmost(std::uint32_t foot) const {
  while (feet_[foot].left != 0) foot = feet_[foot].left - 1;
  return foot;
}

std::uint32_t Feet::next(std::uint32_t foot) const {
  if (feet_[foot].right != 0) return leftmost(feet_[foot].right - 1);
  for (;;) {
    const std::uint32_t parent = feet_[foot].parent;
    if ((parent & kIsRow) != 0) return kNone;
    if (feet_[parent].left == foot + 1) return parent;
    foot = parent;
  }
}

std::uint32_t Feet::add(HalfEdge corner, mesh::Vertex from) {
  const Foot added{corner, from, 0, 0, kIsRow};
  if (free_feet_.is_empty()) {
    feet_.append(added);
    return static_cast<std::uint32_t>(feet_.size() - 1);
  }
  const std::uint32_t foot = free_feet_.first();
  const std::uint32_t next_free = feet_[foot].left;
  feet_.write(foot, added);
  return free_feet_.pop(next_free);
}

std::uint32_t Feet::add_row(const Row& row) {
  auto r = static_cast<std::uint32_t>(rows_.size());
  if (free_rows_.is_empty()) {
    rows_.append(row);
  } else {
    r = free_rows_.first();
    const std::uint32_t next_free = rows_[r].root;
    rows_.write(r, row);
    (void)free_rows_.pop(next_free);
  }
  set_parent(row.root + 1, kIsRow | r);
  return r;
}

std::uint32_t Feet::remove(std::uint32_t foot) {
  const Foot removed = feet_[foot];
  const std::uint32_t tree = join(removed.left, removed.right);
  const bool is_root = (removed.parent & kIsRow) != 0;
  set_parent(tree, removed.parent);
  if (is_root && tree == 0) {
    free_foot(foot);
    free_row(removed.parent & ~kIsRow);
    return removed.parent & ~kIsRow;
  }
  set_child(removed.parent, !is_root && feet_[removed.parent].left == foot + 1, tree);
  free_foot(foot);
  return kNone;
}

void Feet::set_corner(std::uint32_t foot, HalfEdge corner) {
  Foot changed = feet_[foot];
  changed.corner = corner;
  feet_.write(foot, changed);
}

std::uint32_t Feet::take(std::uint32_t row) {
  const std::uint32_t tree = rows_[row].root + 1;
  free_row(row);
  return tree;
}

std::uint32_t Feet::join(std::uint32_t before, std::uint32_t after) {
  if (before == 0) return after;
  if (after == 0) return before;
  if (priority(before - 1) >= priority(after - 1)) {
    set_link(before - 1, &Foot::right, join(feet_[before - 1].right, after));
    return before;
  }
  set_link(after - 1, &Foot::left, join(before, feet_[after - 1].left));
  return after;
}

void Feet::set_link(std::uint32_t foot, std::uint32_t Foot::*side, std::uint32_t tree) {
  if (feet_[foot].*side == tree) return;
  Foot changed = feet_[foot];
  changed.*side = tree;
  feet_.write(foot, changed);
  set_parent(tree, foot);
}

void Feet::set_parent(std::uint32_t tree, std::uint32_t parent) {
  if (tree == 0 || feet_[tree - 1].parent == parent) return;
  Foot changed = feet_[tree - 1];
  changed.parent = parent;
  feet_.write(tree - 1, changed);
}

void Feet::set_child(std::uint32_t parent, bool is_left, std::uint32_t tree) {
  if ((parent & kIsRow) != 0) {
    Row changed = rows_[parent & ~kIsRow];
    changed.root = tree - 1;
    rows_.write(parent & ~kIsRow, changed);
  } else {
    set_link(parent, is_left ? &Foot::left : &Foot::right, tree);
  }
}

// Calls write() before push(): write() can throw std::bad_alloc, push() cannot.
void Feet::free_foot(std::uint32_t foot) {
  feet_.write(foot, {mesh::kNoHalfEdge, mesh::kNoVertex, free_feet_.first(), 0, 0});
  (void)free_feet_.push(foot);
}

void Feet::free_row(std::uint32_t row) {
  rows_.write(row, {mesh::kNoHalfEdge, mesh::kNoVertex, mesh::kNoVertex, free_rows_.first(), {}, {}});
  (void)free_rows_.push(row);
}

void Feet::begin() {
  feet_.begin();
  rows_.begin();
  free_feet_.begin();
  free_rows_.begin();
}

void Feet::roll_back() {
  feet_.roll_back();
  rows_.roll_back();
  free_feet_.roll_back();
  free_rows_.roll_back();
}

void Feet::count_memory(MemoryUse& use) const {
  feet_.count_memory(use, &MemoryUse::bridges);
  rows_.count_memory(use, &MemoryUse::bridges);
}

void Feet::shrink_to_fit() {
  feet_.shrink_to_fit();
  rows_.shrink_to_fit();
}

bool Feet::is_valid() const {
  const auto is_child = [&](std::uint32_t link, std::uint32_t parent) {
    return link == 0 || (feet_[link - 1].parent == parent && priority(link - 1) <= priority(parent));
  };
  for (std::uint32_t i = 0; i < feet_.size(); ++i) {
    const Foot& at = feet_[i];
    if (at.corner == mesh::kNoHalfEdge) continue;
    if (!is_child(at.left, i) || !is_child(at.right, i)) return false;
    if ((at.parent & kIsRow) != 0 && rows_[at.parent & ~kIsRow].root != i) return false;
  }
  return true;
}

}  // namespace waywright::clearance
