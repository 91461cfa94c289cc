#include "path/tra_star.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>

#include "nav/point_agent.hpp"

namespace waywright::path {

using mesh::Face;
using mesh::HalfEdge;

void TraStar::begin(const Triangulation& triangulation, const nav::Abstraction& abstraction, const PointEnds& ends) {
  ends_ = &ends;
  mesh_ = &triangulation.topology();
  geometry_ = &triangulation.triangulation().geometry();
  core_ = &abstraction.core();
  components_ = &abstraction.components();
}

void TraStar::find(Path& path) {
  nodes_.clear();
  open_.clear();
  clear_marks();
  mark_faces_above_goal();
  for (const HalfEdge h : ends_->start_faces()) mark(mesh::face(h), kChosen);
  for (const HalfEdge h : ends_->start_faces()) {
    if (is_connected_to_goal(mesh::face(h))) leave_start_face(h);
  }
  while (!open_.empty()) {
    const std::uint32_t index = open_.pop();
    const ChannelNode node = nodes_[index];
    const Face f = mesh::face(node.entry);
    const std::uint32_t marks = marks_of(f);
    if ((marks & kGoal) != 0) {
      collect_channel(index);
      return write_path(path);
    }
    if ((marks & kChosen) != 0) continue;
    mark(f, kChosen);
    ++path.expansions;
    leave(node, index);
  }
}

void TraStar::clear_marks() {
  stamp_.next(kMarks, marks_);
  marks_.grow_to(mesh_->face_slots());
}

void TraStar::mark(Face f, std::uint32_t mark) {
  std::uint32_t& marks = marks_[number(f)];
  marks = (marks >= stamp_.value() ? marks : stamp_.value()) | mark;
}

bool TraStar::is_connected_to_goal(Face f) const {
  const auto& goals = ends_->goal_faces();
  return std::any_of(goals.begin(), goals.end(), [&](HalfEdge h) {
    return components_->component_of(mesh::face(h)) == components_->component_of(f);
  });
}

void TraStar::mark_faces_above_goal() {
  tops_.clear();
  for (const HalfEdge h : ends_->goal_faces()) climb_from_goal(mesh::face(h));
  if (ends_->goal_faces().size() > 1) mark_faces_with_goal_outside();
}

void TraStar::climb_from_goal(Face goal) {
  mark(goal, kGoal);
  for (Face f = goal; (marks_of(f) & kAboveGoal) == 0;) {
    mark(f, kAboveGoal);
    const HalfEdge up = core_->is_core(f) ? mesh::kNoHalfEdge : core_->towards_core(f);
    if (up == mesh::kNoHalfEdge) return tops_.push_back(f);
    f = mesh::face(mesh_->twin(up));
  }
}

/// Sets the mark kGoalOutside at those faces above the goal from which a passage up leads to the goal, too. These are
/// the faces whose component has goal faces that do not lie below them:
/// - a top (the last face on the way up from a goal face), if its component has a second top;
/// - a face that hangs on a goal face, on a face with two passages down to the goal, or on a face with the mark
///   kGoalOutside.
void TraStar::mark_faces_with_goal_outside() {
  const auto component = [&](Face top) { return components_->component_of(top); };
  std::sort(tops_.begin(), tops_.end(), [&](Face a, Face b) { return component(a) < component(b); });
  for (std::size_t i = 1; i < tops_.size(); ++i) {
    if (component(tops_[i - 1]) != component(tops_[i])) continue;
    mark(tops_[i - 1], kGoalOutside);
    mark(tops_[i], kGoalOutside);
  }
  while (!tops_.empty()) {
    const Face f = tops_.back();
    tops_.pop_back();
    const unsigned down = passages_down(f);
    const bool has_goal_outside = (marks_of(f) & (kGoal | kGoalOutside)) != 0 || std::popcount(down) > 1;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if ((down >> i & 1U) == 0) continue;
      const Face below = mesh::face(mesh_->twin(mesh::half_edge(f, i)));
      if (has_goal_outside) mark(below, kGoalOutside);
      tops_.push_back(below);
    }
  }
}

/// Returns the passages that lead down towards the goal and, if the face has the mark kGoalOutside, also those that
/// lead up. In a tree without a core, the result of passages_to_goal() does not depend on which face is the root.
unsigned TraStar::passages_above_goal(Face f, std::uint32_t marks) const {
  return (marks & kGoalOutside) == 0 ? passages_down(f) : passages_down(f) | core_->passages_towards_core(f);
}

unsigned TraStar::passages_down(Face f) const {
  unsigned passages = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge exit = mesh::half_edge(f, i);
    if (!nav::PointAgent::can_cross(*mesh_, exit)) continue;
    const HalfEdge entry = mesh_->twin(exit);
    const Face below = mesh::face(entry);
    const bool hangs_here = core_->leads_up(entry);
    if (hangs_here && (marks_of(below) & kAboveGoal) != 0) passages |= 1U << i;
  }
  return passages;
}

// Seen from inside the face, the left end of an edge is its target.
void TraStar::leave_start_face(HalfEdge h) {
  const Face f = mesh::face(h);
  const unsigned passages = passages_to_goal(f, marks_of(f));
  for (const HalfEdge exit : {h, mesh::next(h), mesh::previous(h)}) {
    if ((passages >> mesh::index_in(f, exit) & 1U) == 0) continue;
    follow(exit, ChannelNode::kNone,
           {ends_->start(), position_of(mesh_->target(exit)), position_of(mesh_->origin(exit))});
  }
}

void TraStar::leave(const ChannelNode& node, std::uint32_t index) {
  const HalfEdge left = mesh::previous(node.entry);
  const HalfEdge right = mesh::next(node.entry);
  const Point& apex = position_of(mesh_->origin(left));
  Sight to_right = node.sight;
  to_right.move_left(apex, position_of(mesh_->origin(right)));
  Sight to_left = node.sight;
  to_left.move_right(apex, position_of(mesh_->origin(node.entry)));
  follow(right, index, to_right);
  follow(left, index, to_left);
}

//          c             The channel has entered a face across `entry`, from below: the left end is the edge's origin,
//        /   \           the right end its target. If it leaves to the right, across target - c, c becomes the left end
//      /       \         of the portal. If it leaves to the left, across c - origin, c becomes the right end.
//  origin --> target
//
/// Follows the channel for as long as there is no choice.
void TraStar::follow(HalfEdge exit, std::uint32_t before, Sight sight) {
  for (HalfEdge out = exit;;) {
    const HalfEdge entry = mesh_->twin(out);
    const Face f = mesh::face(entry);
    const std::uint32_t marks = marks_of(f);
    if ((marks & kChosen) != 0) return;
    const HalfEdge left = mesh::previous(entry);
    const HalfEdge right = mesh::next(entry);
    const unsigned passages = passages_to_goal(f, marks);
    const bool goes_left = (passages >> mesh::index_in(f, left) & 1U) != 0;
    const bool goes_right = (passages >> mesh::index_in(f, right) & 1U) != 0;
    if ((marks & kGoal) != 0 || (goes_left && goes_right)) return open(exit, entry, before, sight);
    if (!goes_left && !goes_right) return;
    const Point& apex = position_of(mesh_->origin(left));
    if (goes_left) {
      sight.move_right(apex, position_of(mesh_->origin(entry)));
    } else {
      sight.move_left(apex, position_of(mesh_->origin(right)));
    }
    out = goes_left ? left : right;
  }
}

/// Opens a node. The bound includes a small fraction of the distance from the goal. So if the estimates of two channels
/// are about equal, the search prefers the channel that is closer to the goal, because more of its length is known.
void TraStar::open(HalfEdge exit, HalfEdge entry, std::uint32_t before, const Sight& sight) {
  constexpr double kTieBreakWeight = 1.0 / 128;
  const Point& goal = ends_->goal();
  const double bound = sight.length_to(goal) + kTieBreakWeight * distance(position_of(mesh_->origin(entry)), goal);
  open_.push(bound, static_cast<std::uint32_t>(nodes_.size()));
  nodes_.push_back({exit, entry, before, sight});
}

void TraStar::collect_channel(std::uint32_t goal_node) {
  chosen_.clear();
  exits_.clear();
  for (std::uint32_t node = goal_node; node != ChannelNode::kNone; node = nodes_[node].before) chosen_.push_back(node);
  std::reverse(chosen_.begin(), chosen_.end());
  for (const std::uint32_t index : chosen_) {
    const ChannelNode& node = nodes_[index];
    exits_.push_back(node.exit);
    for (HalfEdge entry = mesh_->twin(node.exit); entry != node.entry; entry = mesh_->twin(exits_.back())) {
      const Face f = mesh::face(entry);
      const HalfEdge left = mesh::previous(entry);
      const bool goes_left = (passages_to_goal(f, marks_of(f)) >> mesh::index_in(f, left) & 1U) != 0;
      exits_.push_back(goes_left ? left : mesh::next(entry));
    }
  }
}

void TraStar::write_path(Path& path) {
  string_.begin(*geometry_, ends_->start(), mesh_->target(exits_[0]), mesh_->origin(exits_[0]), exits_.size());
  for (std::size_t i = 1; i < exits_.size(); ++i) {
    const HalfEdge entry = mesh_->twin(exits_[i - 1]);
    const mesh::Vertex apex = mesh_->apex(entry);
    exits_[i] == mesh::next(entry) ? string_.move_left(apex) : string_.move_right(apex);
  }
  const Point& goal = ends_->goal();
  string_.end_at(goal);
  path.status = PathStatus::found;
  path.length = string_.length();
  path.lower_bound = std::min(distance(ends_->start(), goal), path.length);
  const std::span<const Point> points = string_.points();
  path.points.assign(1, goal);
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    if (*point != path.points.back()) path.points.push_back(*point);
  }
  std::reverse(path.points.begin(), path.points.end());
}

void TraStar::write_channel(Path& path) const {
  path.channel.clear();
  for (const HalfEdge exit : exits_)
    path.channel.push_back({position_of(mesh_->target(exit)), position_of(mesh_->origin(exit))});
}

}  // namespace waywright::path
