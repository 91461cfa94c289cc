#include "path/disc_channel.hpp"

#include <algorithm>

namespace waywright::path {

using mesh::HalfEdge;

namespace {

/// If i is the number of a half-edge in its face, kNext[i] is the number of the next half-edge, and kPrevious[i] is the
/// number of the previous one. These tables cost less than mesh::next(), which divides.
constexpr std::uint32_t kNext[3] = {1, 2, 0};
constexpr std::uint32_t kPrevious[3] = {2, 0, 1};

/// The search adds this share of the distance to the goal to a bound. So of channels of about the same length, it takes
/// the channel that is nearer to the goal first. If follow() pauses, it opens a node whose bound has no such term.
/// Along a channel, the estimated length never becomes smaller, but this term can. So the bound of this node is not
/// larger than the bounds of the later nodes of the channel, and the pause does not delay them.
constexpr double kTieBreakWeight = 1.0 / 128;

}  // namespace

void DiscChannel::begin(const DiscMap& map, const DiscEnds& ends) {
  map_ = &map;
  ends_ = &ends;
  is_found_ = false;
  marks_.grow_to(std::size_t{3} * map.mesh().face_slots());
  goal_face_ = ends.goal_face();
  marks_faces_ = true;
  has_seen_foot_ = false;
  restart();
}

void DiscChannel::restart() {
  nodes_.clear();
  open_.clear();
  exits_.clear();
  stamp_.next(kMarks, marks_);
  ends_->for_each_above_goal([&](mesh::Face f) { add_mark(f, kAboveGoal); });
  const locate::Located& start = ends_->at_start();
  add_mark(mesh::face(start.h), kEntered);
  if (start.kind == locate::LocatedKind::edge) add_mark(mesh::face(map_->mesh().twin(start.h)), kEntered);
  leave_start(ends_->at_start());
}

/// Adds a mark to a face and to its half-edges.
void DiscChannel::add_mark(mesh::Face f, std::uint32_t added) {
  for (const HalfEdge h : {mesh::first(f), mesh::next(mesh::first(f)), mesh::previous(mesh::first(f))}) {
    std::uint32_t& mark = mark_of(f, h);
    mark = std::max(mark, stamp_.value()) | added;
  }
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
      const bool leads_on = contains(ends_->dead_ends().edges_towards_goal(mesh::face(h)), mesh::face(h), h);
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
    std::uint32_t& mark = mark_of(mesh::face(entry), entry);
    const std::uint32_t marks = mark >= stamp_.value() ? mark : stamp_.value();
    if ((marks & kEntered) != 0) continue;
    mark = marks | kEntered;
    leave(node, index);
  }
  return is_found_;
}

//          c             The channel has entered a face across `entry`, from below. The left end of this edge is its
//        /   \           origin, and the right end is its target. The channel leaves to the left across the edge from c
//      /       \         to the origin, and to the right across the edge from the target to c. A foot bridge that
//  origin --> target     starts at the origin separates the left edge from `entry`.
//
/// Returns whether the channel can leave a face across an edge. Only a foot bridge that starts at the origin of
/// `corner` can separate this edge from the edge of entry. The decision is exact.
bool DiscChannel::decide_is_open(HalfEdge exit, double squared, HalfEdge corner) {
  if (!can_cross(exit, squared)) return false;
  if (!map_->has_narrow_bridge_foot(corner)) return true;
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
  const Point apex = map_->position(mesh.apex(entry));
  if ((node.exits & kRight) != 0) {
    Channel right = channel;
    right.move_left(mesh::next(entry), apex);
    follow(right, index);
  }
  if ((node.exits & kLeft) != 0) {
    Channel left = channel;
    left.move_right(mesh::previous(entry), apex);
    follow(left, index);
  }
}

/// Follows the channel as long as there is no choice. Pauses (opens a node) where another channel has a smaller bound.
/// So the search does not follow a long corridor that leads away from the goal. Ends the channel at a face that
/// another channel has entered, and at the faces that contain the start: leave_start() has followed all channels that
/// leave them.
void DiscChannel::follow(Channel channel, std::uint32_t before) {
  constexpr unsigned kFacesPerPause = 16;  // To compute a bound costs about as much as to enter a face.
  const mesh::TriangleMesh& mesh = map_->mesh();
  const DeadEnds& dead_ends = ends_->dead_ends();
  const HalfEdge exit = channel.out;
  for (unsigned faces = 1;; ++faces) {
    const HalfEdge entry = mesh.twin(channel.out);
    const mesh::Face f = mesh::face(entry);
    std::uint32_t& mark = mark_of(f, entry);
    const std::uint32_t marks = mark >= stamp_.value() ? mark : stamp_.value();
    if ((marks & kEntered) != 0) return;
    const bool is_above_goal = (marks & kAboveGoal) != 0;
    const std::uint32_t i = mesh::index_in(f, entry);
    const HalfEdge left_exit = mesh::half_edge(f, kPrevious[i]);
    const HalfEdge right_exit = mesh::half_edge(f, kNext[i]);
    const Point apex = map_->position(mesh.origin(left_exit));
    const unsigned edges = is_above_goal ? dead_ends.edges_towards_goal(f) : dead_ends.edges_towards_core(f);
    unsigned exits = 0;
    if ((edges >> kPrevious[i] & 1U) != 0 && is_open(left_exit, squared_length(apex - channel.left), entry)) {
      exits |= kLeft;
    }
    if ((edges >> kNext[i] & 1U) != 0 && is_open(right_exit, squared_length(apex - channel.right), right_exit)) {
      exits |= kRight;
    }
    const bool has_choice = exits == (kLeft | kRight) || (is_above_goal && ends_->is_goal_face(f));
    if (has_choice || (faces % kFacesPerPause == 0 && exits != 0)) {
      const double length = channel.sight.length_to(ends_->goal());
      if (has_choice || (!open_.empty() && length > open_.least_bound())) {
        const double bound = has_choice ? length + kTieBreakWeight * distance(channel.left, ends_->goal()) : length;
        open_.push(bound, static_cast<std::uint32_t>(nodes_.size()));
        nodes_.push_back({{exit, entry, before, channel.sight}, exits});
        return;
      }
    }
    if (exits == 0) return;
    mark = marks | kEntered | exits;
    if (exits == kLeft) {
      channel.move_right(left_exit, apex);
    } else {
      channel.move_left(right_exit, apex);
    }
  }
}

void DiscChannel::collect(std::uint32_t node) {
  is_found_ = true;
  const mesh::TriangleMesh& mesh = map_->mesh();
  goal_face_ = nodes_[node].channel.entry;
  for (std::uint32_t i = node; i != ChannelNode::kNone; i = nodes_[i].channel.before) {
    // The nodes give the exits from the goal to the start. Between two nodes, the marks of the faces give the exits in
    // the other direction, so the code reverses this piece of the list.
    const std::size_t first = exits_.size();
    for (HalfEdge exit = nodes_[i].channel.exit;;) {
      exits_.push_back(exit);
      const HalfEdge entry = mesh.twin(exit);
      if (entry == nodes_[i].channel.entry) break;
      const bool goes_left = (mark_of(mesh::face(entry), entry) & kLeft) != 0;
      exit = goes_left ? mesh::previous(entry) : mesh::next(entry);
    }
    std::reverse(exits_.begin() + static_cast<std::ptrdiff_t>(first), exits_.end());
  }
  std::reverse(exits_.begin(), exits_.end());
}

}  // namespace waywright::path
