#include "path/ta_star.hpp"

#include <algorithm>
#include <limits>

#include "nav/point_agent.hpp"

namespace waywright::path {

void TaStar::begin(const Triangulation& triangulation, const PointEnds& ends, LookedAt* looked_at) {
  ends_ = &ends;
  looked_at_ = looked_at;
  mesh_ = &triangulation.topology();
  tree_.reset(triangulation.triangulation().geometry(), ends.start());
  nodes_.clear();
  open_.clear();
  is_found_ = false;
  dropped_bound_ = std::numeric_limits<double>::infinity();
  clear_entries();
  for (const mesh::HalfEdge h : ends.start_faces()) leave_start_face(h);
}

void TaStar::clear_entries() {
  stamp_.next(1, entered_);
  grow_to_mesh();
}

bool TaStar::step(std::size_t limit, Path& path) {
  while (!open_.empty() && path.expansions < limit) {
    if (is_found_ && open_.least_bound() >= best_length_) break;
    const std::uint32_t index = open_.pop();
    const Node& node = nodes_[index];
    std::uint32_t& entered = entered_[number(node.entry)];
    if (entered == stamp_.value()) {
      dropped_bound_ = std::min(dropped_bound_, node.bound);
      continue;
    }
    entered = stamp_.value();
    ++path.expansions;
    if (looked_at_ != nullptr) looked_at_->look(mesh::face(node.entry));
    if (!ends_->is_goal(mesh::face(node.entry))) {
      leave(index);
    } else if (arrive(index)) {
      write_path(path);
      return false;
    }
  }
  if (is_found_) path.lower_bound = lower_bound();
  return open_.empty() || (is_found_ && open_.least_bound() >= best_length_);
}

double TaStar::lower_bound() const {
  const double open_bound = open_.empty() ? best_length_ : open_.least_bound();
  return std::min({open_bound, dropped_bound_, best_length_});
}

// Seen from inside the face, the left end of an edge is its target.
void TaStar::leave_start_face(mesh::HalfEdge h) {
  for (const mesh::HalfEdge exit : {h, mesh::next(h), mesh::previous(h)}) {
    if (!nav::PointAgent::can_cross(*mesh_, exit)) continue;
    const std::uint32_t left = tree_.add_visible_from_start(mesh_->target(exit));
    const std::uint32_t right = tree_.add_visible_from_start(mesh_->origin(exit));
    open(exit, kNone, {TautTree::kStart, left, right});
  }
}

//          c             The channel has entered the face across `entry`, from below: the left end is the edge's
//        /   \           origin, the right end its target. If the channel leaves across the edge from the target to c,
//      /       \         then c becomes the left end of the portal. If it leaves across the edge from c to the origin,
//  origin --> target     then c becomes the right end.
void TaStar::leave(std::uint32_t index) {
  const Node node = nodes_[index];
  const mesh::Vertex apex = mesh_->apex(node.entry);
  const mesh::HalfEdge right_exit = mesh::next(node.entry);
  const mesh::HalfEdge left_exit = mesh::previous(node.entry);
  if (nav::PointAgent::can_cross(*mesh_, right_exit)) open(right_exit, index, tree_.move_left(node.funnel, apex));
  if (nav::PointAgent::can_cross(*mesh_, left_exit)) open(left_exit, index, tree_.move_right(node.funnel, apex));
}

void TaStar::open(mesh::HalfEdge exit, std::uint32_t before, const Funnel& funnel) {
  nodes_.push_back({mesh_->twin(exit), before, funnel, bound(funnel)});
  open_.push(nodes_.back().bound, static_cast<std::uint32_t>(nodes_.size() - 1));
}

bool TaStar::arrive(std::uint32_t index) {
  const std::uint32_t turn = tree_.last_turn(nodes_[index].funnel, ends_->goal());
  const double length = tree_.length(turn) + distance(tree_.point(turn), ends_->goal());
  if (is_found_ && length >= best_length_) return false;
  is_found_ = true;
  best_length_ = length;
  best_turn_ = turn;
  best_node_ = index;
  return true;
}

double TaStar::bound(const Funnel& funnel) const {
  return tree_.length(funnel.apex) + distance_via_segment(tree_.point(funnel.apex), tree_.point(funnel.left),
                                                          tree_.point(funnel.right), ends_->goal());
}

void TaStar::write_path(Path& path) const {
  path.status = PathStatus::found;
  path.length = best_length_;
  path.lower_bound = lower_bound();
  path.points.clear();
  path.points.push_back(ends_->goal());
  for (std::uint32_t node = best_turn_;; node = tree_.parent(node)) {
    if (tree_.point(node) != path.points.back()) path.points.push_back(tree_.point(node));
    if (node == TautTree::kStart) break;
  }
  std::reverse(path.points.begin(), path.points.end());
}

void TaStar::write_channel(Path& path) const {
  path.channel.clear();
  for (std::uint32_t node = best_node_; node != kNone; node = nodes_[node].before) {
    const mesh::HalfEdge entry = nodes_[node].entry;
    path.channel.push_back({tree_.position_of(mesh_->origin(entry)), tree_.position_of(mesh_->target(entry))});
  }
  std::reverse(path.channel.begin(), path.channel.end());
}

}  // namespace waywright::path
