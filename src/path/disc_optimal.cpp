#include "path/disc_optimal.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/compiler.hpp"
#include "path/distance.hpp"

namespace waywright::path {

using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// When the search has followed a window over this many faces, it computes the bound of the window again.
constexpr int kFacesBetweenOffers = 8;

/// Consider the line through the vertex of a root, in the direction in which the path arrives there. Suppose that the
/// path turns left at the root and another vertex lies right of this line, or the reverse. If this vertex is farther
/// than this many radii from the line, the next line of the path does not lead to the vertex. The exact factor is 2.
/// The rest allows for rounding.
constexpr double kMostRadiiOnOtherSide = 2.125;

/// Returns the direction of the vector. Returns (1, 0) if its length is 0.
Point unit(const Point& v) {
  const double size = length(v);
  return size > 0.0 ? Point{v.x / size, v.y / size} : Point{1.0, 0.0};
}

}  // namespace

void DiscOptimal::begin(const DiscMap& map, const DiscEnds& ends, double limit, const GuideDistances* distances) {
  distances_ = distances;
  map_ = &map;
  ends_ = &ends;
  limit_ = limit * (1.0 + 0x1p-40);  // allows for rounding
  is_found_ = false;
  roots_.clear();
  windows_.clear();
  turn_nodes_.clear();
  failed_.clear();
  noted_.clear();
  at_once_.clear();
  open_.clear();
  stamp_.next(1, reached_);
  reached_.grow_to(std::size_t{2} * map.mesh().vertex_slots());
  add_root({{{ends_->start(), kNoTurn}, mesh::kNoVertex}, mesh::kNoHalfEdge, {1.0, 0.0}});
  leave_start(ends.at_start());
}

/// Returns whether the search needs no window across the edge `exit` for lines from `from`, which is a pivot or the
/// start of the path. There are two cases: the edge is closed (DiscMap::is_closed()); or the edge is shorter than the
/// disc is wide and, if `from` is a pivot, the distance of the edge from its vertex is larger than the radius. (If a
/// shorter edge is nearer to the vertex, a line may begin beyond the edge.)
/// Requires: the edge is not surely long (DiscMap::surely_long); `squared` is its squared length.
bool DiscOptimal::is_too_short(const Pivot& from, HalfEdge exit, const Edge& edge, double squared) const {
  if (map_->is_closed(exit)) return true;
  if (squared >= map_->surely_short) return false;
  return from.turn == kNoTurn ||
         squared_distance_to_segment(from.centre, edge.right, edge.left) > map_->radius * map_->radius;
}

/// Returns true if the search does not follow a window between the rays `left` and `right` across the edge `exit`,
/// whose ends are `edge`. There are two reasons. First, is_excluded() is true. Second, the piece of the edge that the
/// window sees is too far from the line through the vertex of the root, in the direction in which the path arrives
/// there: the path turns left at the root and the piece lies right of this line, or the reverse, and the distance of
/// the piece from the line is larger than the diameter of the disc. A line from the root to a vertex that the window
/// sees beyond this piece would turn back.
WAYWRIGHT_ALWAYS_INLINE
bool DiscOptimal::is_window_excluded(const Root& root, const Point& left, const Point& right, HalfEdge exit,
                                     const Edge& edge) const {
  const Pivot& from = root.end.pivot;
  if (is_excluded(from, exit, edge)) return true;
  const bool is_left = from.turn == kTurnLeft;
  const Point& ray_on_turn_side = is_left ? left : right;
  if (from.turn * cross(root.direction, ray_on_turn_side) >= 0.0) return false;
  return is_far_on_other_side(root, ray_on_turn_side, edge) && is_far_on_other_side(root, is_left ? right : left, edge);
}

/// Returns whether the point where a ray of a window meets the edge is too far from the line through the vertex of the
/// root: see is_window_excluded().
bool DiscOptimal::is_far_on_other_side(const Root& root, const Point& ray, const Edge& edge) const {
  const Pivot& from = root.end.pivot;
  const std::optional<Point> end = meeting({0.0, 0.0}, ray, edge.right - from.centre, edge.left - edge.right);
  return end && from.turn * cross(root.direction, *end) < -kMostRadiiOnOtherSide * map_->radius;
}

std::uint32_t DiscOptimal::add_root(const Root& root) {
  roots_.push_back(root);
  Root& added = roots_.back();
  added.position = touching_position(root.end.pivot, root.direction, map_->radius);
  added.distance = distance(added.position, ends_->goal());
  return static_cast<std::uint32_t>(roots_.size() - 1);
}

bool DiscOptimal::step(std::size_t limit, std::size_t& expansions) {
  expansions_ = expansions;
  while (!is_found_ && !open_.empty() && expansions_ < limit) {
    at_once_bound_ = open_.least_bound();
    const std::uint32_t node = open_.pop();
    if (node % 2 != 0) {
      expand(node / 2);
    } else {
      follow(windows_[node / 2]);
    }
    while (!at_once_.empty()) {
      const Window next = at_once_.back();
      at_once_.pop_back();
      follow(next);
    }
  }
  expansions = expansions_;
  return is_found_ || open_.empty();
}

/// Returns whether a path that leaves the root in this direction turns back there: it would turn right at the root of a
/// left turn, or left at the root of a right turn. Allows for rounding.
bool DiscOptimal::turns_back(const Root& root, const Point& direction) const {
  return root.end.pivot.turn * cross(root.direction, direction) < -kTurnsBack;
}

void DiscOptimal::leave_start(const locate::Located& location) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  at_once_bound_ = -1.0;
  const bool is_on_edge = location.kind == locate::LocatedKind::edge;
  for (const HalfEdge first : {location.h, mesh.twin(location.h)}) {
    if (first != location.h && !is_on_edge) break;
    if (ends_->is_goal_face(mesh::face(first)))
      push_goal(0, {unit(ends_->goal() - ends_->start()), waywright::length(ends_->goal() - ends_->start())});
    for (const HalfEdge h : {first, mesh::next(first), mesh::previous(first)}) {
      const Edge edge = edge_of(h);
      if ((h == first && is_on_edge) || is_excluded(roots_[0].end.pivot, h, edge)) continue;
      const Ray right{edge.right - ends_->start(), mesh.origin(h)};
      const Ray left{edge.left - ends_->start(), mesh.target(h)};
      offer({mesh.twin(h), 0, right, left}, edge);
    }
  }
}

//        apex            The window enters the face across the half-edge `entry`, from below. The origin of `entry` is
//       /    \           the left end of the edge, and its target is the right end.
//   origin - target
void DiscOptimal::follow(Window window) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root& root = roots_[window.root];
  Edge edge{map_->position(mesh.origin(window.entry)), map_->position(mesh.target(window.entry))};
  for (int faces = 1;; ++faces) {
    ++expansions_;
    if (ends_->is_goal_face(mesh::face(window.entry))) reach_goal(window);
    const Point apex = map_->position(mesh.apex(window.entry));
    HalfEdge exit = mesh::kNoHalfEdge;
    if (const double from_left = orientation(root, window.left, apex); from_left >= 0.0) {
      if (window.left.anchor == mesh.origin(window.entry)) pass_end(window, window.left, kTurnLeft, from_left > 0.0);
      exit = mesh::next(window.entry);
      edge.left = apex;
      if (from_left == 0.0) window.left.anchor = mesh.apex(window.entry);
    } else if (const double from_right = orientation(root, window.right, apex); from_right <= 0.0) {
      if (window.right.anchor == mesh.target(window.entry))
        pass_end(window, window.right, kTurnRight, from_right < 0.0);
      exit = mesh::previous(window.entry);
      edge.right = apex;
      if (from_right == 0.0) window.right.anchor = mesh.apex(window.entry);
    }
    if (exit == mesh::kNoHalfEdge) {
      if (!divide(window, edge, apex)) return;
    } else {
      if (is_window_excluded(root, window.left.direction, window.right.direction, exit, edge)) return;
      window.entry = mesh.twin(exit);
    }
    if (faces % kFacesBetweenOffers == 0) return offer(window, edge);
  }
}

/// Continues a window, whose edge has the ends `edge`, in a face whose apex lies between the rays of the window. If the
/// search follows the window across only one of the two other edges of the face, the function changes `window` and
/// `edge` and returns true.
bool DiscOptimal::divide(Window& window, Edge& edge, const Point& apex) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root& root = roots_[window.root];
  const Ray towards_apex{apex - root.end.pivot.centre, mesh.apex(window.entry)};
  const HalfEdge left_exit = mesh::previous(window.entry);
  const HalfEdge right_exit = mesh::next(window.entry);
  const Edge left_edge{edge.left, apex};
  const Edge right_edge{apex, edge.right};
  const bool goes_left = !is_window_excluded(root, window.left.direction, towards_apex.direction, left_exit, left_edge);
  const bool goes_right =
      !is_window_excluded(root, towards_apex.direction, window.right.direction, right_exit, right_edge);
  if (goes_left && goes_right) {
    offer({mesh.twin(left_exit), window.root, towards_apex, window.left}, left_edge);
    offer({mesh.twin(right_exit), window.root, window.right, towards_apex}, right_edge);
    return false;
  }
  window.entry = mesh.twin(goes_left ? left_exit : right_exit);
  (goes_left ? window.right : window.left) = towards_apex;
  edge = goes_left ? left_edge : right_edge;
  return goes_left || goes_right;
}

/// The ray passes through the end of the window's edge, and the apex does not lie between the rays. Adds a turn node
/// for the end of the edge, as note_turn() does.
///
/// If a path turns at its root in the direction `turn`, the lines from the root to all vertices on this ray are one
/// line. A path that touches a later vertex on the ray also touches the first one. So the search adds a turn node for
/// the first vertex alone, and the windows of the new root see the next one. Without this rule, n vertices on a line
/// would have n^2 turn nodes.
void DiscOptimal::pass_end(const Window& window, Ray& ray, int turn, bool sees_apex) {
  if (!ray.has_turn && note_turn(window, turn, sees_apex)) ray.has_turn = roots_[window.root].end.pivot.turn == turn;
}

/// Adds a turn node for an end of the window's edge: the left end if `turn` is kTurnLeft, the right end if it is
/// kTurnRight. Requires: a ray of the window passes through this end. Does nothing if no path can continue after the
/// turn: neither through the two other edges of the face, nor to a goal in one of the two faces at the window's edge.
/// (Because of rounding, the goal may lie before this edge.) The *far edge* is
/// the one edge of the face on which this end of the window's edge does not lie. `sees_apex` is false if the apex lies
/// on this ray. If, in addition, the path turns in the direction `turn` at its root, the path goes along the ray to the
/// apex, and does not cross the far edge.
/// Returns true if a path may continue after this turn and if there is a tangent from the root to the vertex. The
/// result is then true even if push_turn() has left out the turn node.
bool DiscOptimal::note_turn(const Window& window, int turn, bool sees_apex) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const bool is_left = turn == kTurnLeft;
  const HalfEdge corner = is_left ? window.entry : mesh::next(window.entry);
  const Vertex v = mesh.origin(corner);
  const HalfEdge near_edge = is_left ? mesh::previous(window.entry) : mesh::next(window.entry);
  const HalfEdge far_edge = is_left ? mesh::next(window.entry) : mesh::previous(window.entry);
  const Pivot& from = roots_[window.root].end.pivot;
  const Pivot pivot = end_at(v, turn).pivot;
  const bool may_cross_far_edge = (sees_apex || from.turn != turn) && !is_excluded(pivot, far_edge, edge_of(far_edge));
  const bool is_goal_near =
      ends_->is_goal_face(mesh::face(window.entry)) || ends_->is_goal_face(mesh::face(mesh.twin(window.entry)));
  if (!is_goal_near && !may_cross_far_edge && is_excluded(pivot, near_edge, edge_of(near_edge))) return false;
  const auto line = tangent(from, pivot, map_->radius);
  if (line) push_turn(window.root, corner, turn, *line, kNone);
  return line.has_value();
}

/// Adds a turn node, unless the path would have to turn back at the root to reach this pivot: a path that turns back
/// is not the shortest. Also leaves out a pivot whose vertex is not useful (GuideDistances::is_useful()).
void DiscOptimal::push_turn(std::uint32_t root, HalfEdge corner, int turn, const Tangent& line, std::uint32_t earlier) {
  if (turns_back(roots_[root], line.direction)) return;
  const Vertex v = map_->mesh().origin(corner);
  const Point centre = map_->position(v);
  const bool has_distance = distances_ != nullptr && !distances_->is_unknown(corner);
  if (has_distance && !distances_->is_useful(v, centre)) return;
  Reached& reached = reached_at(v, turn);
  for (std::uint32_t i = reached.noted; i != kNone; i = noted_[i].older) {
    if (noted_[i].root == root && is_same_chain(noted_[i].earlier, earlier)) return;
  }
  noted_.push_back({root, earlier, reached.noted});
  reached.noted = static_cast<std::uint32_t>(noted_.size() - 1);
  const double length = length_to(roots_[root], line.direction) + line.length;
  const Point touching = touching_position({centre, turn}, line.direction, map_->radius);
  double rest = distance(touching, ends_->goal());
  if (has_distance) rest = std::max(rest, distances_->least_length(v, centre) - map_->radius);
  const double least = length + rest;
  if (least > limit_) return;
  turn_nodes_.push_back({corner, root, v, turn, line, length, earlier});
  open_.push(least, static_cast<std::uint32_t>(2 * turn_nodes_.size() - 1));
}

/// Returns whether the two chains of turn nodes that start at `a` and at `b` (TurnNode::earlier) have the same pivots
/// in the same order.
bool DiscOptimal::is_same_chain(std::uint32_t a, std::uint32_t b) const {
  while (a != b) {
    if (a == kNone || b == kNone || turn_nodes_[a].vertex != turn_nodes_[b].vertex ||
        turn_nodes_[a].turn != turn_nodes_[b].turn) {
      return false;
    }
    a = turn_nodes_[a].earlier;
    b = turn_nodes_[b].earlier;
  }
  return true;
}

DiscOptimal::Reached& DiscOptimal::reached_at(Vertex v, int turn) {
  Reached& reached = reached_[2 * number(v) + (turn == kTurnLeft ? 1 : 0)];
  if (reached.query != stamp_.value()) reached = {stamp_.value(), kNone, kNone, kNone};
  return reached;
}

void DiscOptimal::reach_goal(const Window& window) {
  const Root& root = roots_[window.root];
  if (orientation(root, window.left, ends_->goal()) > 0.0) return;
  if (orientation(root, window.right, ends_->goal()) < 0.0) return;
  const auto line = tangent(root.end.pivot, {ends_->goal(), kNoTurn}, map_->radius);
  if (line) push_goal(window.root, *line);
}

void DiscOptimal::push_goal(std::uint32_t root, const Tangent& line) {
  if (turns_back(roots_[root], line.direction)) return;
  const double length = length_to(roots_[root], line.direction) + line.length;
  if (length > limit_) return;
  turn_nodes_.push_back({ends_->goal_face(), root, mesh::kNoVertex, 0, line, length, kNone});
  open_.push(length, static_cast<std::uint32_t>(2 * turn_nodes_.size() - 1));
}

void DiscOptimal::offer(const Window& window, const Edge& edge) {
  const double least = bound(window, edge);
  if (least <= at_once_bound_) {
    at_once_.push_back(window);
    return;
  }
  if (least > limit_) return;
  windows_.push_back(window);
  open_.push(least, static_cast<std::uint32_t>(2 * windows_.size() - 2));
}

/// A lower bound of the length of the paths through the window, whose edge has the ends `edge`. If the disc is beyond
/// the edge when it reaches the root, the bound does not depend on the edge.
///
/// A path that turns around an end of the edge, or around a vertex close behind the edge, need not cross the edge, but
/// its distance from the edge is at most the radius. A detour to the edge and back makes it longer by at most the
/// diameter.
double DiscOptimal::bound(const Window& window, const Edge& edge) const {
  const Root& root = roots_[window.root];
  const Point& from = root.position;
  if (cross(edge.right - edge.left, from - edge.left) > 0.0) return root.length + root.distance;
  double rest =
      std::max(root.distance, distance_via_segment(from, edge.left, edge.right, ends_->goal()) - 2.0 * map_->radius);
  if (distances_ != nullptr) rest = std::max(rest, bound_of_guide(window, edge));
  return root.length + rest;
}

/// A lower bound of the length of the paths through the window, from the root to the goal.
///
/// Let x be the position of the edge at the distance t from the left end. The guide's path from x to the goal is not
/// shorter than the path from an end of the edge to the goal minus the distance from x to this end. So there are two
/// lower bounds of its length: one falls with t, the other rises, both by 1 for each unit of t. The distance from the
/// root to x changes by at most 1 for each unit of t. So the sum of this distance and the larger one of the two bounds
/// is smallest where the two bounds are equal, or at an end of the edge if they are equal nowhere. The path of the disc
/// may pass the edge at a distance of up to the radius, so the function subtracts the diameter (see bound()). A second
/// lower bound is the distance of the root's vertex from the goal minus the radius. The function leaves out a bound if
/// the guide does not know its distances.
double DiscOptimal::bound_of_guide(const Window& window, const Edge& edge) const {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root& root = roots_[window.root];
  double rest = 0.0;
  if (!distances_->is_unknown(window.entry)) {
    const double left_rest = distances_->least_length(mesh.origin(window.entry), edge.left);
    const double right_rest = distances_->least_length(mesh.target(window.entry), edge.right);
    const double size = distance(edge.left, edge.right);
    const double t = std::clamp(0.5 * (left_rest - right_rest + size), 0.0, size);
    const Point x = size > 0.0 ? lerp(edge.left, edge.right, t / size) : edge.left;
    rest = distance(root.position, x) + std::max(left_rest - t, right_rest - (size - t)) - 2.0 * map_->radius;
  }
  if (root.end.vertex == mesh::kNoVertex || distances_->is_unknown(root.corner)) return rest;
  return std::max(rest, distances_->least_length(root.end.vertex, root.end.pivot.centre) - map_->radius);
}

// Copies the node: new nodes may move the memory of `turn_nodes_`.
void DiscOptimal::expand(std::uint32_t index) {
  ++expansions_;
  const TurnNode node = turn_nodes_[index];
  const Root& from = roots_[node.root];
  if (is_beyond(from.turn_limit, from.end.pivot, from.direction, node.line.direction)) return push_turn_limit(index);
  if (node.vertex == mesh::kNoVertex) return try_goal(index);
  Reached& reached = reached_at(node.vertex, node.turn);
  if (const std::uint32_t failed = failed_line(node, reached.failed); failed != kNone) {
    return push_obstacles(index, failed_[failed].left, failed_[failed].right);
  }
  const DiscLine::End end = end_at(node.vertex, node.turn);
  const Point touching = touching_position(end.pivot, node.line.direction, map_->radius);
  const HalfEdge corner = corner_towards(*map_, node.corner, touching - end.pivot.centre, node.turn);
  if (corner == mesh::kNoHalfEdge) return;
  if (const std::uint32_t better = dominating_root(node, corner, reached.root); better != kNone) {
    return push_next_line(better, node.earlier);
  }
  if (is_shorter_with_other_turn(node, corner)) return;
  const DiscLine::FaceAt face = DiscLine::face_at(*map_, end.pivot.centre, touching, corner);
  if (face.is_behind_wall) return;
  if (!line_.is_clear(*map_, from.end, end, node.line, face.h)) {
    failed_.push_back({node.root, reached.failed, line_.left(), line_.right()});
    reached.failed = static_cast<std::uint32_t>(failed_.size() - 1);
    return push_obstacles(index, line_.left(), line_.right());
  }
  reached.root = add_root({end, corner, node.line.direction, node.length, node.root, {}, reached.root});
  leave_root(reached.root, corner);
  push_next_line(static_cast<std::uint32_t>(roots_.size() - 1), node.earlier);
}

void DiscOptimal::try_goal(std::uint32_t index) {
  const TurnNode node = turn_nodes_[index];
  if (!line_.is_clear(*map_, roots_[node.root].end, {{ends_->goal(), kNoTurn}, mesh::kNoVertex}, node.line,
                      ends_->goal_face())) {
    return push_obstacles(index, line_.left(), line_.right());
  }
  is_found_ = true;
  length_ = node.length;
  last_root_ = node.root;
  last_direction_ = node.line.direction;
  at_once_.clear();
}

/// Adds turn nodes for the vertices that are too near to the line of a turn node. After such a turn, the path continues
/// to the end of this line.
void DiscOptimal::push_obstacles(std::uint32_t index, const DiscLine::Obstacle& left, const DiscLine::Obstacle& right) {
  for (const int turn : {kTurnLeft, kTurnRight}) {
    const DiscLine::Obstacle obstacle = turn == kTurnLeft ? left : right;
    if (obstacle.vertex == mesh::kNoVertex) continue;
    bool is_repeated = false;
    for (std::uint32_t i = index; i != kNone; i = turn_nodes_[i].earlier) {
      is_repeated = is_repeated || (turn_nodes_[i].vertex == obstacle.vertex && turn_nodes_[i].turn == turn);
    }
    if (!is_repeated) push_turn(turn_nodes_[index].root, obstacle.corner, turn, obstacle.line, index);
  }
}

/// Adds a turn node for the vertex that limits the turn around the root of a line. After the turn around that vertex,
/// the path continues to the end of the line. This is necessary even if a window has found the end of the line: the
/// windows of the vertex that limits the turn need not find it.
void DiscOptimal::push_turn_limit(std::uint32_t index) {
  const Root& root = roots_[turn_nodes_[index].root];
  const HalfEdge corner = root.turn_limit.corner;
  if (corner == mesh::kNoHalfEdge) return;
  const int turn = root.end.pivot.turn;
  const Vertex v = map_->mesh().origin(corner);
  const auto line = tangent(root.end.pivot, end_at(v, turn).pivot, map_->radius);
  DiscLine::Obstacle limit;
  if (line) limit = {v, corner, *line};
  push_obstacles(index, turn == kTurnLeft ? limit : DiscLine::Obstacle{},
                 turn == kTurnLeft ? DiscLine::Obstacle{} : limit);
}

/// If `earlier` is the index of a turn node, adds a turn node for the line from the root to the end of the line of
/// `earlier`. The pivot of the root is in the way of that line, or limits the turn before it, so the path turns around
/// this pivot first.
void DiscOptimal::push_next_line(std::uint32_t root, std::uint32_t earlier) {
  if (earlier == kNone) return;
  const TurnNode next = turn_nodes_[earlier];
  if (next.vertex == mesh::kNoVertex) {
    if (const auto line = tangent(roots_[root].end.pivot, {ends_->goal(), kNoTurn}, map_->radius))
      push_goal(root, *line);
    return;
  }
  const auto line = tangent(roots_[root].end.pivot, end_at(next.vertex, next.turn).pivot, map_->radius);
  if (line && next.vertex != roots_[root].end.vertex) push_turn(root, next.corner, next.turn, *line, next.earlier);
}

/// Returns a root at the same pivot from which the disc can reach the end of the line along the circle, in one of the
/// two directions, by a path that is not longer. Returns kNone if there is none.
std::uint32_t DiscOptimal::dominating_root(const TurnNode& node, HalfEdge corner, std::uint32_t newest) const {
  for (std::uint32_t i = newest; i != kNone; i = roots_[i].older) {
    const Root& root = roots_[i];
    if (root.length > node.length) continue;
    const bool is_before = node.turn * cross(root.direction, node.line.direction) >= 0.0;
    const double angle = turning_angle(root.direction, node.line.direction, is_before ? node.turn : -node.turn);
    if (root.length + map_->radius * angle > node.length) continue;
    if (is_before ? are_on_one_arc(root.corner, corner, node.turn) : are_on_one_arc(corner, root.corner, node.turn)) {
      return i;
    }
  }
  return kNone;
}

/// Consider a path that turns around the same vertex in the other direction, and continues along the circle. Returns
/// whether such a path reaches the end of the line and is not longer. If one does, no shortest path contains this line:
/// the other path and the rest of this path form an angle at the point where they meet, so a shorter path exists.
bool DiscOptimal::is_shorter_with_other_turn(const TurnNode& node, HalfEdge corner) {
  // At a start that touches the vertex, both turns have the length 0, and neither path has a direction of arrival.
  if (node.length == 0.0) return false;
  for (std::uint32_t i = reached_at(node.vertex, -node.turn).root; i != kNone; i = roots_[i].older) {
    const Root& root = roots_[i];
    if (root.length > node.length) continue;
    // This is the direction in which a path with the turn of `node` touches the circle where the path of `root` touches
    // it.
    const Point arrival = -root.direction;
    const int orientation = cross(arrival, node.line.direction) >= 0.0 ? 1 : -1;
    const double angle = turning_angle(arrival, node.line.direction, orientation);
    if (root.length + map_->radius * angle > node.length) continue;
    if (are_on_one_arc(root.corner, corner, orientation)) return true;
  }
  return false;
}

/// Returns the entry in `failed_` of the line from the same root to the same pivot, or kNone.
std::uint32_t DiscOptimal::failed_line(const TurnNode& node, std::uint32_t newest) const {
  for (std::uint32_t i = newest; i != kNone; i = failed_[i].older) {
    if (failed_[i].root == node.root) return i;
  }
  return kNone;
}

/// Returns whether a disc can move along the circle around a vertex from one corner to another, in the direction of the
/// turn.
bool DiscOptimal::are_on_one_arc(HalfEdge from, HalfEdge to, int turn) const {
  const mesh::TriangleMesh& mesh = map_->mesh();
  for (HalfEdge at = from;;) {
    if (map_->has_narrow_bridge_foot(at)) return false;
    if (at == to) return true;
    const HalfEdge spoke = turn == kTurnLeft ? mesh.next_around(at) : at;
    if (map_->is_closed(spoke)) return false;
    at = turn == kTurnLeft ? spoke : mesh.previous_around(at);
    if (at == from) return false;
  }
}

/// Makes the windows of a root, and notes how far the path can turn there. `corner` contains the position at which the
/// path reaches the root.
void DiscOptimal::leave_root(std::uint32_t root_index, HalfEdge corner) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root root = roots_[root_index];
  const Pivot& pivot = root.end.pivot;
  Ray first{{pivot.turn * root.direction.y, -pivot.turn * root.direction.x}, mesh::kNoVertex};
  const auto visit = [&](HalfEdge at, HalfEdge spoke, double order) {
    const Vertex end = mesh.target(spoke);
    Ray last{map_->position(end) - pivot.centre, end};
    // The spoke lies beyond a turn of 180 degrees (turn_around()).
    if (order > 2.0) last = {-root.direction, mesh::kNoVertex};
    if (ends_->is_goal_face(mesh::face(at))) {
      if (const auto line = tangent(pivot, {ends_->goal(), kNoTurn}, map_->radius)) push_goal(root_index, *line);
    }
    const HalfEdge exit = mesh::next(at);
    const Edge edge = edge_of(exit);
    Window window{mesh.twin(exit), root_index, first, last};
    if (pivot.turn == kTurnRight) std::swap(window.right, window.left);
    if (!is_window_excluded(root, window.left.direction, window.right.direction, exit, edge)) offer(window, edge);
    first = last;
  };
  roots_[root_index].turn_limit = turn_around(*map_, pivot, root.direction, corner, visit);
}

void DiscOptimal::write_path(std::vector<DiscPiece>& pieces) {
  stops_.clear();
  Point departure = last_direction_;
  for (std::uint32_t i = last_root_; i != kNone; i = roots_[i].before) {
    stops_.push_back({roots_[i].end.pivot, departure});
    departure = roots_[i].direction;
  }
  std::reverse(stops_.begin(), stops_.end());
  write_disc_pieces(*map_, stops_, ends_->goal(), pieces);
}

}  // namespace waywright::path
