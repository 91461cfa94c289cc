#include "path/disc_optimal.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "path/distance.hpp"

namespace waywright::path {

using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// Two directions that differ by less than this count as equal. If a window is too wide, this only costs time.
constexpr double kSameDirection = 0x1p-40;
/// Allows for rounding: a line may be nearer to a vertex than the radius, by at most this fraction of the radius.
constexpr double kNearness = 0x1p-34;
/// When the search has followed a window over this many faces, it computes the bound of the window again.
constexpr int kFacesBetweenLooks = 8;

Point opposite(const Point& v) { return {-v.x, -v.y}; }

double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = squared_length(along);
  const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return squared_length(p - lerp(a, b, share));
}

/// Returns (1, 0) if the length is 0.
Point unit(const Point& v) {
  const double size = length(v);
  return size > 0.0 ? Point{v.x / size, v.y / size} : Point{1.0, 0.0};
}

}  // namespace

void DiscOptimal::begin(const DiscMap& map, const Point& start, const Point& goal) {
  map_ = &map;
  start_ = start - map.origin;
  goal_ = goal - map.origin;
  is_found_ = false;
  least_ = map.radius * (1.0 - kNearness);
  roots_.clear();
  windows_.clear();
  turns_.clear();
  failed_.clear();
  at_once_.clear();
  open_.clear();
  stamp_.next(1, reached_, goals_below_);
  reached_.grow_to(std::size_t{2} * map.mesh().vertex_slots());
  const locate::Located at_goal = map.walls.triangulation().locate(goal);
  goal_face_ = at_goal.h;
  goal_faces_[0] = goal_faces_[1] = mesh::face(at_goal.h);
  if (at_goal.kind == locate::LocatedKind::edge) goal_faces_[1] = mesh::face(map.mesh().twin(at_goal.h));
  count_goal_faces();
  roots_.push_back({{{start_, 0}, mesh::kNoVertex}, mesh::kNoHalfEdge, {1.0, 0.0}, 0.0, kNone, kNone});
  leave_start(map.walls.triangulation().locate(start));
}

/// Counts the goal faces at each face of the chains that lead from them up to the core.
void DiscOptimal::count_goal_faces() {
  if (map_->core == nullptr) return;
  const nav::TwoCore& core = *map_->core;
  goals_below_.grow_to(map_->mesh().face_slots());
  const std::size_t count = goal_faces_[0] == goal_faces_[1] ? 1 : 2;
  for (std::size_t i = 0; i < count; ++i) {
    for (mesh::Face f = goal_faces_[i]; !core.is_core(f);) {
      GoalsBelow& below = goals_below_[number(f)];
      if (below.query != stamp_.value()) below = {stamp_.value(), 0};
      ++below.count;
      const HalfEdge up = core.towards_core(f);
      if (up == mesh::kNoHalfEdge) break;
      f = mesh::face(map_->mesh().twin(up));
    }
  }
}

/// Returns whether a dead end without the goal lies beyond the edge. Requires: the edge is no wall.
bool DiscOptimal::is_dead_end(HalfEdge exit) const {
  const nav::TwoCore& core = *map_->core;
  const auto goals_below = [&](mesh::Face f) {
    const GoalsBelow& below = goals_below_[number(f)];
    return below.query == stamp_.value() ? below.count : 0;
  };
  if (core.leads_up(exit)) return goals_below(mesh::face(exit)) == (goal_faces_[0] == goal_faces_[1] ? 1U : 2U);
  return goals_below(mesh::face(map_->mesh().twin(exit))) == 0;
}

/// Returns whether the search does not follow lines from a root across the edge: no disc has its centre there, or a dead
/// end lies beyond. If the edge is shorter than the disc is wide, no position on it is free; but a line may begin
/// beyond the edge.
bool DiscOptimal::is_excluded(const Root& root, HalfEdge exit) const {
  if (map_->is_closed(exit)) return true;
  if (map_->core != nullptr && !map_->core->is_passage(exit) && is_dead_end(exit)) return true;
  const Point a = map_->position(map_->mesh().origin(exit));
  const Point b = map_->position(map_->mesh().target(exit));
  if (squared_length(b - a) >= 4 * least_ * least_) return false;
  return root.end.contact.side == 0 ||
         squared_distance_to_segment(root.end.contact.centre, a, b) > map_->radius * map_->radius;
}

bool DiscOptimal::step(std::size_t limit, std::size_t& expansions) {
  expansions_ = expansions;
  while (!is_found_ && !open_.empty() && expansions_ < limit) {
    at_once_bound_ = open_.least_bound();
    const std::uint32_t node = open_.pop();
    if (node % 2 != 0) {
      expand(Turn(turns_[node / 2]));
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

// If the position lies behind the beginning of the line, the path has passed it on its way around the root.
int DiscOptimal::side_of(const Root& root, const Point& direction, const Point& position) const {
  const Point to = position - root.end.contact.centre;
  const int turn = root.end.contact.side;
  const double offset = cross(direction, to) + turn * map_->radius;
  if (turn != 0 && dot(direction, to) < 0.0 && turn * offset < map_->radius) return -turn;
  return offset > 0.0 ? 1 : offset < 0.0 ? -1 : 0;
}

void DiscOptimal::leave_start(const locate::Located& location) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  at_once_bound_ = -1.0;
  const bool is_on_edge = location.kind == locate::LocatedKind::edge;
  for (const HalfEdge first : {location.h, mesh.twin(location.h)}) {
    if (first != location.h && !is_on_edge) break;
    if (is_goal_face(mesh::face(first))) push_goal(0, {unit(goal_ - start_), waywright::length(goal_ - start_)});
    for (const HalfEdge h : {first, mesh::next(first), mesh::previous(first)}) {
      if ((h == first && is_on_edge) || is_excluded(roots_[0], h)) continue;
      const Vertex left = mesh.target(h);
      const Vertex right = mesh.origin(h);
      offer({mesh.twin(h),
             0,
             {{unit(map_->position(right) - start_), right}, {unit(map_->position(left) - start_), left}}});
    }
  }
}

//        apex            The window has entered the face across `entry`, from below: its left end is the edge's
//       /    \           origin.
//   origin - target
void DiscOptimal::follow(Window window) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  for (int faces = 1;; ++faces) {
    ++expansions_;
    if (is_goal_face(mesh::face(window.entry))) reach_goal(window);
    const Root& root = roots_[window.root];
    const Point apex = map_->position(mesh.apex(window.entry));
    const HalfEdge right_exit = mesh::next(window.entry);
    const HalfEdge left_exit = mesh::previous(window.entry);
    HalfEdge exit{};
    if (const int from_left = side_of(root, window.bounds[1].direction, apex); from_left >= 0) {
      note_turn(window, 1, from_left > 0);
      exit = right_exit;
      if (from_left == 0) window.bounds[1].anchor = mesh.apex(window.entry);
    } else if (const int from_right = side_of(root, window.bounds[0].direction, apex); from_right <= 0) {
      note_turn(window, -1, from_right < 0);
      exit = left_exit;
      if (from_right == 0) window.bounds[0].anchor = mesh.apex(window.entry);
    } else {
      return divide(window, apex);
    }
    if (is_excluded(root, exit)) return;
    window.entry = mesh.twin(exit);
    if (faces % kFacesBetweenLooks == 0) return offer(window);
  }
}

/// Continues a window in a face whose apex lies between the bounds of the window.
void DiscOptimal::divide(const Window& window, const Point& apex) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const auto line = tangent(roots_[window.root].end.contact, {apex, 0}, map_->radius);
  if (!line) return;
  for (const int side : {1, 0}) {
    const HalfEdge exit = side > 0 ? mesh::previous(window.entry) : mesh::next(window.entry);
    if (is_excluded(roots_[window.root], exit)) continue;
    Window beyond = window;
    beyond.entry = mesh.twin(exit);
    beyond.bounds[1 - side] = {line->direction, mesh.apex(window.entry)};
    offer(beyond);
  }
}

/// Notes the turn around the end of the window's edge if the bound on this side goes through it and there may be a path
/// behind it. `sees_apex` says whether a path that turns can leave the face across the far edge.
void DiscOptimal::note_turn(const Window& window, int side, bool sees_apex) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const HalfEdge corner = side > 0 ? window.entry : mesh::next(window.entry);
  const Vertex v = mesh.origin(corner);
  const Bound& at = window.bounds[side > 0 ? 1 : 0];
  if (at.anchor != v && !(at.anchor == kContinuation && is_touched_by(window, side, v))) return;
  const HalfEdge near_edge = side > 0 ? mesh::previous(window.entry) : mesh::next(window.entry);
  const HalfEdge far_edge = side > 0 ? mesh::next(window.entry) : mesh::previous(window.entry);
  const Root& root = roots_[window.root];
  const bool can_continue = !is_excluded(root, near_edge) || (sees_apex && !is_excluded(root, far_edge));
  if (!can_continue && !is_goal_face(mesh::face(window.entry))) return;
  const auto line = tangent(root.end.contact, end_at(v, side).contact, map_->radius);
  if (line) push_turn(window.root, corner, side, *line);
}

/// Returns whether the disc touches the vertex if it goes on from the root in the direction in which it has come.
/// `side` is the side of the line on which the vertex lies.
bool DiscOptimal::is_touched_by(const Window& window, int side, Vertex v) const {
  const Root& root = roots_[window.root];
  const Point& direction = window.bounds[side > 0 ? 1 : 0].direction;
  const Point to = map_->position(v) - root.end.contact.centre;
  const double offset = cross(direction, to) + root.end.contact.side * map_->radius;
  return dot(direction, to) > 0.0 && std::abs(offset) < map_->radius;
}

void DiscOptimal::push_turn(std::uint32_t root, HalfEdge corner, int turn, const Tangent& line) {
  const Vertex v = map_->mesh().origin(corner);
  Reached& reached = reached_[2 * number(v) + (turn > 0 ? 1 : 0)];
  if (reached.query != stamp_.value()) reached = {stamp_.value(), kNone, kNone, kNone};
  if (std::exchange(reached.noted, root) == root) return;
  const double length = length_to(roots_[root], line.direction) + line.length;
  const Point touching = touching_point({map_->position(v), turn}, line.direction, map_->radius);
  turns_.push_back({corner, root, v, turn, line, length});
  open_.push(length + distance(touching, goal_), static_cast<std::uint32_t>(2 * turns_.size() - 1));
}

void DiscOptimal::reach_goal(const Window& window) {
  const auto line = tangent(roots_[window.root].end.contact, {goal_, 0}, map_->radius);
  if (!line) return;
  if (cross(window.bounds[0].direction, line->direction) < -kSameDirection) return;
  if (cross(line->direction, window.bounds[1].direction) < -kSameDirection) return;
  push_goal(window.root, *line);
}

void DiscOptimal::push_goal(std::uint32_t root, const Tangent& line) {
  const double length = length_to(roots_[root], line.direction) + line.length;
  turns_.push_back({goal_face_, root, mesh::kNoVertex, 0, line, length});
  open_.push(length, static_cast<std::uint32_t>(2 * turns_.size() - 1));
}

void DiscOptimal::offer(const Window& window) {
  if (cross(window.bounds[0].direction, window.bounds[1].direction) < -kSameDirection) return;
  const double least = bound(window);
  if (least <= at_once_bound_) {
    at_once_.push_back(window);
    return;
  }
  windows_.push_back(window);
  open_.push(least, static_cast<std::uint32_t>(2 * windows_.size() - 2));
}

/// A lower bound of the length of the paths through the window. If the line begins beyond the edge, the edge says nothing
/// about the length.
double DiscOptimal::bound(const Window& window) const {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root& root = roots_[window.root];
  const Point& nearest = window.bounds[root.end.contact.side < 0 ? 1 : 0].direction;
  const Point from = touching_point(root.end.contact, nearest, map_->radius);
  const Point left_end = map_->position(mesh.origin(window.entry));
  const Point edge = map_->position(mesh.target(window.entry)) - left_end;
  if (cross(edge, from - left_end) > 0.0) return root.length + least_arc(root, nearest) + distance(from, goal_);
  const Point goal = on_left(left_end, edge, goal_);
  for (const int side : {1, -1}) {
    const Point& direction = window.bounds[side > 0 ? 1 : 0].direction;
    const Point begin = touching_point(root.end.contact, direction, map_->radius);
    const bool is_before_edge = cross(edge, begin - left_end) <= 0.0 && cross(edge, direction) > 0.0;
    if (!is_before_edge || !(side * cross(direction, goal - begin) > 0.0)) continue;
    const std::optional<Point> end = meeting(begin, direction, left_end, edge);
    if (!end) break;
    return root.length + least_arc(root, direction) + distance_via_point(begin, *end, goal);
  }
  return root.length + least_arc(root, nearest) + distance(from, goal);
}

void DiscOptimal::expand(const Turn& turn) {
  ++expansions_;
  if (turn.vertex == mesh::kNoVertex) {
    if (!test(turn, {{goal_, 0}, mesh::kNoVertex}, goal_face_)) return;
    is_found_ = true;
    length_ = turn.length;
    last_root_ = turn.root;
    last_direction_ = turn.line.direction;
    at_once_.clear();
    return;
  }
  Reached& reached = reached_[2 * number(turn.vertex) + (turn.turn > 0 ? 1 : 0)];
  if (has_failed(turn, reached.failed)) return;
  const DiscLine::End end = end_at(turn.vertex, turn.turn);
  const Point touching = touching_point(end.contact, turn.line.direction, map_->radius);
  const HalfEdge corner = corner_towards(turn.corner, touching - end.contact.centre, turn.turn);
  if (corner == mesh::kNoHalfEdge || is_dominated(turn, corner, reached.root)) return;
  const HalfEdge face = DiscLine::face_at(*map_, end.contact.centre, touching, corner);
  if (face == mesh::kNoHalfEdge || !test(turn, end, face)) {
    failed_.push_back({turn.root, reached.failed});
    reached.failed = static_cast<std::uint32_t>(failed_.size() - 1);
    return;
  }
  roots_.push_back({end, corner, turn.line.direction, turn.length, turn.root, reached.root});
  reached.root = static_cast<std::uint32_t>(roots_.size() - 1);
  turn_around(reached.root, corner);
}

/// Returns whether an earlier path to the contact, continued along the circle in either direction, is not longer.
bool DiscOptimal::is_dominated(const Turn& turn, HalfEdge corner, std::uint32_t first) const {
  for (std::uint32_t i = first; i != kNone; i = roots_[i].next) {
    const Root& root = roots_[i];
    if (root.length > turn.length) continue;
    const bool is_before = turn.turn * cross(root.direction, turn.line.direction) >= 0.0;
    const double angle = turning_angle(root.direction, turn.line.direction, is_before ? turn.turn : -turn.turn);
    if (root.length + map_->radius * angle > turn.length) continue;
    if (is_before ? are_on_one_arc(root.corner, corner, turn.turn) : are_on_one_arc(corner, root.corner, turn.turn)) {
      return true;
    }
  }
  return false;
}

/// Returns whether a disc can move along the circle around a vertex from one corner to another, in the direction of the
/// turn.
bool DiscOptimal::are_on_one_arc(HalfEdge from, HalfEdge to, int turn) const {
  const mesh::TriangleMesh& mesh = map_->mesh();
  for (HalfEdge at = from;;) {
    if (map_->closed_foot(at)) return false;
    if (at == to) return true;
    const HalfEdge spoke = turn > 0 ? mesh.next_around(at) : at;
    if (map_->is_closed(spoke)) return false;
    at = turn > 0 ? spoke : mesh.previous_around(at);
    if (at == from) return false;
  }
}

/// Returns whether the line from the same root to the same contact failed its test before.
bool DiscOptimal::has_failed(const Turn& turn, std::uint32_t first) const {
  for (std::uint32_t i = first; i != kNone; i = failed_[i].next) {
    if (failed_[i].root == turn.root) return true;
  }
  return false;
}

/// Tests the line of a turn. If vertices beside the line are in the way, adds the turns around them.
bool DiscOptimal::test(const Turn& turn, const DiscLine::End& end, HalfEdge face) {
  if (line_.is_clear(*map_, roots_[turn.root].end, end, turn.line, face)) return true;
  for (const int side : {1, -1}) {
    const DiscLine::Obstacle& obstacle = side > 0 ? line_.left() : line_.right();
    if (obstacle.vertex != mesh::kNoVertex) push_turn(turn.root, obstacle.corner, side, obstacle.line);
  }
  return false;
}

/// Returns the corner at the same vertex that contains a direction. Looks at `corner` first and then goes against the
/// direction of the turn. Returns kNoHalfEdge if the direction leads out of the domain.
HalfEdge DiscOptimal::corner_towards(HalfEdge corner, const Point& direction, int turn) const {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Point from = map_->position(mesh.origin(corner));
  const auto contains = [&](HalfEdge h) {
    return !map_->walls.triangulation().is_ghost_face(h) &&
           cross(map_->position(mesh.target(h)) - from, direction) >= 0.0 &&
           cross(map_->position(mesh.apex(h)) - from, direction) < 0.0;
  };
  HalfEdge at = corner;
  do {
    if (contains(at)) return at;
    at = turn > 0 ? mesh.previous_around(at) : mesh.next_around(at);
  } while (at != corner);
  return mesh::kNoHalfEdge;
}

/// Makes the windows of the lines that leave a root. `corner` contains the position at which the path reaches the root.
/// Goes from corner to corner in the direction of the turn, up to a wall or a bridge that is too short, or until the
/// path has turned by 180 degrees.
///
/// Directions are numbers, their *orders*: 0 is the direction in which the path arrives, 1 and 2 are 90 and 180 degrees
/// farther in the direction of the turn. -1 is the direction from the vertex to the position of arrival.
void DiscOptimal::turn_around(std::uint32_t root_index, HalfEdge corner) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Root root = roots_[root_index];
  const Contact& contact = root.end.contact;
  const int turn = contact.side;
  const auto order_of = [&](const Point& direction, double least) {
    const double order = turning_order(root.direction, direction, turn);
    return order - 4.0 >= least - kSameDirection ? order - 4.0 : order >= least - kSameDirection ? order : order + 4.0;
  };
  Bound first{root.direction, kContinuation};
  double first_order = 0.0;
  double spoke_order = -1.0;
  HalfEdge at = corner;
  do {
    // `spoke` is the edge at the vertex to which the turn comes next.
    const HalfEdge spoke = turn > 0 ? mesh.next_around(at) : at;
    const Vertex end = mesh.target(spoke);
    // A closed bridge to a foot in this corner ends the turn before the spoke.
    const auto foot = map_->closed_foot(at);
    const bool has_foot = foot && order_of(*foot - contact.centre, spoke_order) <=
                                      order_of(map_->position(end) - contact.centre, spoke_order);
    const bool is_closed = has_foot || map_->is_closed(spoke);
    const Point to_end = has_foot ? *foot - contact.centre : map_->position(end) - contact.centre;
    const double end_order = order_of(to_end, spoke_order);
    const auto line_to_end = tangent(contact, {contact.centre + to_end, 0}, map_->radius);
    const Bound next{line_to_end ? line_to_end->direction : unit(to_end), has_foot ? mesh::kNoVertex : end};
    const double next_order = order_of(next.direction, spoke_order);
    Bound last = next;
    double last_order = next_order;
    if (last_order > 2.0) last.direction = opposite(root.direction);
    if (end_order > 2.0 + kSameDirection) last.anchor = mesh::kNoVertex;
    if (is_goal_face(mesh::face(at))) {
      const auto line = tangent(contact, {goal_, 0}, map_->radius);
      const double order = line ? order_of(line->direction, first_order) : 4.0;
      if (order <= 2.0 + kSameDirection) push_goal(root_index, *line);
    }
    const HalfEdge far_edge = mesh::next(at);
    if (last_order >= first_order - kSameDirection && !is_excluded(root, far_edge)) {
      Window window{mesh.twin(far_edge), root_index, {first, last}};
      if (turn < 0) std::swap(window.bounds[0], window.bounds[1]);
      offer(window);
    }
    if (is_closed) return;
    spoke_order = end_order;
    if (next_order > first_order) {
      first = next;
      first_order = next_order;
    } else if (const auto line = tangent(contact, {contact.centre + to_end, -turn}, map_->radius);
               line && order_of(line->direction, 0.0) <= 2.0) {
      // The disc touches the vertex if it goes straight on.
      push_turn(root_index, mesh.twin(spoke), -turn, *line);
    }
    at = turn > 0 ? spoke : mesh.previous_around(at);
  } while (first_order <= 2.0 && spoke_order <= 2.0 && at != corner);
}

/// A lower bound of arc(): the first terms of the series that gives the angle from the length of the chord.
double DiscOptimal::least_arc(const Root& root, const Point& direction) const {
  if (root.end.contact.side == 0) return 0.0;
  const double square = squared_length(direction - root.direction);
  return map_->radius * std::sqrt(square) * (1.0 + square * (1.0 / 24 + square * (3.0 / 640)));
}

double DiscOptimal::arc(const Root& root, const Point& direction) const {
  if (root.end.contact.side == 0 || direction == root.direction) return 0.0;
  const double angle = turning_angle(root.direction, direction, root.end.contact.side);
  return angle < 2 * kPi - 1.0 ? map_->radius * angle : 0.0;
}

void DiscOptimal::write_path(std::vector<DiscPiece>& pieces) const {
  const std::size_t count = pieces.size();
  Point to = goal_;
  Point direction = last_direction_;
  std::uint32_t after_root = kNone;
  for (std::uint32_t i = last_root_; i != kNone; i = roots_[i].before) {
    const Root& root = roots_[i];
    const Contact& contact = root.end.contact;
    DiscPiece piece;
    piece.from = touching_point(contact, direction, map_->radius) + map_->origin;
    piece.to = to + map_->origin;
    piece.direction = direction;
    if (pieces.size() > count) {
      const DiscPiece& after = pieces.back();
      const Root& next = roots_[after_root];
      piece.centre = next.end.contact.centre + map_->origin;
      piece.turn = arc(next, after.direction) == 0.0 ? 0 : next.end.contact.side;
      piece.end_direction = after.direction;
    }
    if (pieces.size() > count && direction == pieces.back().direction) {
      pieces.back().from = piece.from;  // the line goes straight on past the contact
    } else {
      pieces.push_back(piece);
    }
    if (arc(root, direction) == 0.0 && root.before != kNone) {
      pieces.back().from = touching_point(contact, root.direction, map_->radius) + map_->origin;
    }
    to = touching_point(contact, root.direction, map_->radius);
    direction = root.direction;
    after_root = i;
  }
  std::reverse(pieces.begin() + static_cast<std::ptrdiff_t>(count), pieces.end());
}

}  // namespace waywright::path
