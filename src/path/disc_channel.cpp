#include "path/disc_channel.hpp"

#include <algorithm>

#include "base/compiler.hpp"

namespace waywright::path {

using mesh::HalfEdge;

void DiscChannel::begin(const DiscMap& map, const DiscEnds& ends) {
  map_ = &map;
  ends_ = &ends;
  is_found_ = false;
  visited_.grow_to(std::size_t{3} * map.mesh().face_slots());
  goal_face_ = ends.goal_face();
  marks_faces_ = true;
  has_seen_foot_ = false;
  restart();
}

void DiscChannel::restart() {
  nodes_.clear();
  open_.clear();
  exits_.clear();
  stamp_.next(1, visited_);
  leave_start(ends_->at_start());
}

void DiscChannel::leave_start(const locate::Located& location) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const bool is_on_edge = location.kind == locate::LocatedKind::edge;
  for (const HalfEdge first : {location.h, mesh.twin(location.h)}) {
    if (first != location.h && !is_on_edge) break;
    if (ends_->is_goal_face(mesh::face(first))) is_found_ = true;
  }
  if (is_found_) return;
  for (const HalfEdge first : {location.h, mesh.twin(location.h)}) {
    if (first != location.h && !is_on_edge) break;
    for (const HalfEdge h : {first, mesh::next(first), mesh::previous(first)}) {
      const Point left = map_->position(mesh.target(h));
      const Point right = map_->position(mesh.origin(h));
      const bool leads_on = is_passage(ends_->dead_ends().passages(mesh::face(h)), mesh::face(h), h);
      if ((h == first && is_on_edge) || !leads_on || !can_cross(h, squared_length(left - right))) continue;
      follow({h, left, right, {ends_->start(), left, right}}, ChannelNode::kNone);
    }
  }
}

bool DiscChannel::step(std::size_t limit, std::size_t& expansions) {
  while (!is_found_ && expansions < limit) {
    if (open_.empty()) {
      // Where a foot bridge divides a face, the exits depend on the edge through which the channel enters the face.
      if (!marks_faces_ || !has_seen_foot_) return true;
      marks_faces_ = false;
      restart();
      continue;
    }
    const std::uint32_t index = open_.pop();
    const Node node = nodes_[index];
    const HalfEdge entry = node.channel.entry;
    ++expansions;
    if (ends_->is_goal_face(mesh::face(entry))) {
      collect(index);
      return true;
    }
    if (is_visited(entry)) continue;
    visited_[marks_faces_ ? 3 * number(mesh::face(entry)) : number(entry)] = stamp_.value();
    leave(node, index);
  }
  return is_found_;
}

/// Returns whether the search has followed a channel through this entry already, or has made its choice at the face.
/// Without the first test, a channel without a choice could repeat the same cycle of faces forever.
bool DiscChannel::is_visited(HalfEdge entry) const {
  return visited_[number(entry)] == stamp_.value() ||
         (marks_faces_ && visited_[3 * number(mesh::face(entry))] == stamp_.value());
}

//          c             The channel has entered a face across `entry`, from below: the left end is the edge's origin,
//        /   \           the right end its target. It leaves to the left across c - origin, to the right across
//      /       \         target - c. A foot bridge that starts at the origin separates the left edge from the entry.
//  origin --> target
//
/// Finds the exits of the face of `entry`, whose ends lie at `left` and `right`.
WAYWRIGHT_ALWAYS_INLINE
DiscChannel::Exits DiscChannel::exits_of(HalfEdge entry, const Point& left, const Point& right) {
  const HalfEdge left_exit = mesh::previous(entry);
  const HalfEdge right_exit = mesh::next(entry);
  const mesh::Face f = mesh::face(entry);
  const unsigned passages = ends_->dead_ends().passages(f);
  const Point apex = map_->position(map_->mesh().origin(left_exit));
  return {is_passage(passages, f, left_exit) && is_open(left_exit, apex, left, entry),
          is_passage(passages, f, right_exit) && is_open(right_exit, right, apex, right_exit), apex};
}

/// Returns whether the channel can leave a face across the passage `exit`, whose ends lie at `p` and `q`. A foot bridge
/// that separates this edge from the entry starts at the origin of `corner`.
WAYWRIGHT_ALWAYS_INLINE
bool DiscChannel::is_open(HalfEdge exit, const Point& p, const Point& q, HalfEdge corner) {
  if (!can_cross(exit, squared_length(q - p))) return false;
  if (!map_->has_closed_foot(corner)) return true;
  has_seen_foot_ = true;
  return false;
}

/// Moves the left end of the portal to `to`.
void DiscChannel::Channel::move_left(HalfEdge exit, const Point& to) {
  out = exit;
  left = to;
  sight.move_left(left, right);
}

void DiscChannel::Channel::move_right(HalfEdge exit, const Point& to) {
  out = exit;
  right = to;
  sight.move_right(right, left);
}

void DiscChannel::leave(const Node& node, std::uint32_t index) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const HalfEdge entry = node.channel.entry;
  const Channel channel{mesh::kNoHalfEdge, map_->position(mesh.origin(entry)), map_->position(mesh.target(entry)),
                        node.channel.sight};
  if (node.exits.is_right_open) {
    Channel right = channel;
    right.move_left(mesh::next(entry), node.exits.apex);
    follow(right, index);
  }
  if (node.exits.is_left_open) {
    Channel left = channel;
    left.move_right(mesh::previous(entry), node.exits.apex);
    follow(left, index);
  }
}

/// Follows the channel for as long as there is no choice.
void DiscChannel::follow(Channel channel, std::uint32_t before) {
  // Of channels of about the same length, the search prefers those that are nearer to the goal.
  constexpr double kTieBreakWeight = 1.0 / 128;
  const mesh::TriangleMesh& mesh = map_->mesh();
  const HalfEdge exit = channel.out;
  for (;;) {
    const HalfEdge entry = mesh.twin(channel.out);
    const mesh::Face f = mesh::face(entry);
    if (is_visited(entry)) return;
    const Exits exits = exits_of(entry, channel.left, channel.right);
    if (ends_->is_goal_face(f) || (exits.is_left_open && exits.is_right_open)) {
      const double bound =
          channel.sight.length_to(ends_->goal()) + kTieBreakWeight * distance(channel.left, ends_->goal());
      open_.push(bound, static_cast<std::uint32_t>(nodes_.size()));
      nodes_.push_back({{exit, entry, before, channel.sight}, exits});
      return;
    }
    if (!exits.is_left_open && !exits.is_right_open) return;
    visited_[number(entry)] = stamp_.value();
    if (exits.is_left_open) {
      channel.move_right(mesh::previous(entry), exits.apex);
    } else {
      channel.move_left(mesh::next(entry), exits.apex);
    }
  }
}

void DiscChannel::collect(std::uint32_t node) {
  is_found_ = true;
  const mesh::TriangleMesh& mesh = map_->mesh();
  goal_face_ = nodes_[node].channel.entry;
  for (std::uint32_t i = node; i != ChannelNode::kNone; i = nodes_[i].channel.before) {
    // The nodes give the exits from the goal to the start. Between two nodes the code finds the exits in the other
    // direction, so it reverses this piece of the list.
    const std::size_t first = exits_.size();
    for (HalfEdge exit = nodes_[i].channel.exit;;) {
      exits_.push_back(exit);
      const HalfEdge entry = mesh.twin(exit);
      if (entry == nodes_[i].channel.entry) break;
      // One of the two other edges of the face is open.
      const HalfEdge left_exit = mesh::previous(entry);
      const mesh::Face f = mesh::face(entry);
      const bool leads_left = is_passage(ends_->dead_ends().passages(f), f, left_exit);
      const Point apex = map_->position(mesh.origin(left_exit));
      const Point left = map_->position(mesh.origin(entry));
      exit = leads_left && is_open(left_exit, apex, left, entry) ? left_exit : mesh::next(entry);
    }
    std::reverse(exits_.begin() + static_cast<std::ptrdiff_t>(first), exits_.end());
  }
  std::reverse(exits_.begin(), exits_.end());
}

}  // namespace waywright::path
