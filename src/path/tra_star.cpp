#include "path/tra_star.hpp"

#include <algorithm>

namespace waywright::path {

using mesh::Face;
using mesh::HalfEdge;

void TraStar::begin(const Triangulation& triangulation, const Abstraction& abstraction, const Ends& ends) {
  ends_ = &ends;
  mesh_ = &triangulation.topology();
  geometry_ = &triangulation.triangulation().geometry();
  core_ = &abstraction.core();
}

void TraStar::find(Path& path) {
  nodes_.clear();
  open_.clear();
  forget_marks();
  mark_ways_to_goal();
  for (const HalfEdge h : ends_->start_faces()) mark(mesh::face(h), kChosen);
  for (const HalfEdge h : ends_->start_faces()) leave_start_face(h);
  while (!open_.empty()) {
    const std::uint32_t position = open_.pop();
    const HalfEdge entry = nodes_[position].entry;
    const Face f = mesh::face(entry);
    if (is_marked(f, kGoal)) {
      collect_channel(position);
      return write_path(path);
    }
    if (is_marked(f, kChosen)) continue;
    mark(f, kChosen);
    ++path.expansions;
    leave(position, mesh::next(entry));
    leave(position, mesh::previous(entry));
  }
}

void TraStar::forget_marks() {
  query_ += kMarks;
  if (query_ == 0) {  // the count went once around
    std::fill(marks_.begin(), marks_.end(), 0);
    query_ = kMarks;
  }
  if (marks_.size() < mesh_->face_slots()) marks_.resize(mesh_->face_slots(), 0);
}

void TraStar::mark(Face f, std::uint32_t mark) {
  std::uint32_t& marks = marks_[number(f)];
  marks = (marks >= query_ ? marks : query_) | mark;
}

void TraStar::mark_ways_to_goal() {
  for (const HalfEdge h : ends_->goal_faces()) {
    Face f = mesh::face(h);
    mark(f, kGoal);
    while (!is_marked(f, kAboveGoal)) {
      mark(f, kAboveGoal);
      const HalfEdge up = core_->is_core(f) ? mesh::kNoHalfEdge : core_->towards_core(f);
      if (up == mesh::kNoHalfEdge) break;
      f = mesh::face(mesh_->twin(up));
    }
  }
}

/// Whether the way out of a face by `exit` can be one to the goal. Above the goal only the way down is; in a dead end
/// only the way up; in the core all that stay in the core are.
bool TraStar::leads_on(HalfEdge exit) const {
  const Face f = mesh::face(exit);
  if (is_marked(f, kAboveGoal)) {
    if (mesh_->is_fixed(exit)) return false;
    const HalfEdge entry = mesh_->twin(exit);
    const Face below = mesh::face(entry);
    return is_marked(below, kAboveGoal) && !core_->is_core(below) && core_->towards_core(below) == entry;
  }
  return core_->is_core(f) ? core_->is_way(exit) : core_->towards_core(f) == exit;
}

// Seen from inside the face, an edge's left end is its target.
void TraStar::leave_start_face(HalfEdge h) {
  for (const HalfEdge exit : {h, mesh::next(h), mesh::previous(h)}) {
    if (leads_on(exit)) follow(exit, kNone, {ends_->start(), place(mesh_->target(exit)), place(mesh_->origin(exit))});
  }
}

void TraStar::leave(std::uint32_t position, HalfEdge exit) {
  Sight sight = nodes_[position].sight;
  cross(nodes_[position].entry, exit, sight);
  follow(exit, position, sight);
}

//          c             The face was entered across `entry` from below: its left end is the edge's origin, its right
//        /   \           end the target. Going on across target - c moves the left end to c, across c - origin the
//      /       \         right end.
//  origin --> target
void TraStar::cross(HalfEdge entry, HalfEdge exit, Sight& sight) const {
  const Point& apex = place(mesh_->apex(entry));
  if (exit == mesh::next(entry)) {
    sight.move_left(apex, place(mesh_->target(entry)));
  } else {
    sight.move_right(apex, place(mesh_->origin(entry)));
  }
}

/// Goes on for as long as there is no choice.
void TraStar::follow(HalfEdge exit, std::uint32_t before, Sight sight) {
  for (HalfEdge out = exit;;) {
    const HalfEdge entry = mesh_->twin(out);
    const Face f = mesh::face(entry);
    if (is_marked(f, kChosen)) return;
    const bool goes_left = leads_on(mesh::previous(entry));
    const bool goes_right = leads_on(mesh::next(entry));
    if (is_marked(f, kGoal) || (goes_left && goes_right)) {
      nodes_.push_back({exit, entry, before, sight});
      return open_.push(sight.length_to(ends_->goal()), static_cast<std::uint32_t>(nodes_.size() - 1));
    }
    if (!goes_left && !goes_right) return;
    out = goes_left ? mesh::previous(entry) : mesh::next(entry);
    cross(entry, out, sight);
  }
}

void TraStar::collect_channel(std::uint32_t goal_node) {
  chosen_.clear();
  exits_.clear();
  for (std::uint32_t node = goal_node; node != kNone; node = nodes_[node].before) chosen_.push_back(node);
  std::reverse(chosen_.begin(), chosen_.end());
  for (const std::uint32_t position : chosen_) {
    const Node& node = nodes_[position];
    exits_.push_back(node.exit);
    for (HalfEdge entry = mesh_->twin(node.exit); entry != node.entry; entry = mesh_->twin(exits_.back())) {
      const HalfEdge left = mesh::previous(entry);
      exits_.push_back(leads_on(left) ? left : mesh::next(entry));
    }
  }
}

void TraStar::write_path(Path& path) {
  tree_.reset(*geometry_, ends_->start());
  Funnel funnel{TautTree::kRoot, tree_.add_seen(mesh_->target(exits_[0])), tree_.add_seen(mesh_->origin(exits_[0]))};
  for (std::size_t i = 1; i < exits_.size(); ++i) {
    const HalfEdge entry = mesh_->twin(exits_[i - 1]);
    const mesh::Vertex apex = mesh_->apex(entry);
    funnel = exits_[i] == mesh::next(entry) ? tree_.move_left(funnel, apex) : tree_.move_right(funnel, apex);
  }
  const Point& goal = ends_->goal();
  const std::uint32_t corner = tree_.last_corner(funnel, goal);
  path.status = PathStatus::found;
  path.length = tree_.length(corner) + distance(tree_.point(corner), goal);
  path.lower_bound = std::min(distance(ends_->start(), goal), path.length);
  path.points.clear();
  path.points.push_back(goal);
  for (std::uint32_t node = corner;; node = tree_.parent(node)) {
    if (tree_.point(node) != path.points.back()) path.points.push_back(tree_.point(node));
    if (node == TautTree::kRoot) break;
  }
  std::reverse(path.points.begin(), path.points.end());
}

void TraStar::write_channel(Path& path) const {
  path.channel.clear();
  for (const HalfEdge exit : exits_) path.channel.push_back({place(mesh_->target(exit)), place(mesh_->origin(exit))});
}

}  // namespace waywright::path
