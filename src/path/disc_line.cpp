#include "path/disc_line.hpp"

#include <algorithm>
#include <cmath>

#include "path/distance.hpp"

namespace waywright::path {

using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// If a line comes as near to touching a vertex as this many times the slack of the map, the test decides exactly
/// whether the gaps at the vertex are wide enough.
constexpr double kTouching = 16.0;

}  // namespace

double DiscLine::squared_distance(const Point& p) const {
  const Point to = p - start_;
  const double along = dot(direction_, to);
  if (along <= 0.0) return squared_length(to);
  if (along >= length_) return squared_length(p - end_);
  const double across = cross(direction_, to);
  return across * across;
}

bool DiscLine::is_clear(const DiscMap& map, const End& from, const End& to, const Tangent& line, HalfEdge face) {
  map_ = &map;
  from_ = from;
  to_ = to;
  direction_ = line.direction;
  length_ = line.length;
  start_ = touching_point(from.contact, direction_, map.radius);
  end_ = touching_point(to.contact, direction_, map.radius);
  least_ = map.least_distance() * map.least_distance();
  const double touched = map.radius + kTouching * map.slack;
  touched_ = touched * touched;
  is_blocked_ = false;
  obstacles_[0].vertex = obstacles_[1].vertex = mesh::kNoVertex;
  visited_.grow_to(map.mesh().face_slots());
  stamp_.next(1, visited_);
  for (const Vertex v : {from.vertex, to.vertex}) {
    if (v != mesh::kNoVertex) look_at_feet(v);
  }
  if (!is_blocked_) walk(face);
  return !is_blocked_;
}

/// Follows the line from its end to its start, so left and right are exchanged.
void DiscLine::walk(HalfEdge face) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Point back{-direction_.x, -direction_.y};
  const auto offset = [&](Vertex v) { return cross(back, map_->position(v) - end_); };
  const auto is_beyond = [&](HalfEdge h) {
    const Point a = map_->position(mesh.origin(h));
    return cross(map_->position(mesh.target(h)) - a, start_ - a) < 0.0;
  };
  HalfEdge exit = mesh::kNoHalfEdge;
  visited_[number(mesh::face(face))] = stamp_.value();
  for (const HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) {
    look_at_vertex(h);
    const bool is_exit =
        exit == mesh::kNoHalfEdge && is_beyond(h) && offset(mesh.origin(h)) <= 0.0 && offset(mesh.target(h)) >= 0.0;
    if (is_exit) exit = h;
  }
  for (const HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) {
    if (h != exit) look_beside(h);
  }
  while (exit != mesh::kNoHalfEdge) {
    if (map_->is_closed(exit)) return look_at_closed(exit);
    const HalfEdge entry = mesh.twin(exit);
    visited_[number(mesh::face(entry))] = stamp_.value();
    const bool is_apex_left = offset(mesh.apex(entry)) > 0.0;
    look_at_vertex(mesh::previous(entry));
    const HalfEdge left = mesh::previous(entry);
    const HalfEdge right = mesh::next(entry);
    exit = is_apex_left ? right : left;
    look_beside(is_apex_left ? left : right);
    if (is_beyond(exit)) continue;
    look_beside(exit);
    return;
  }
}

/// Looks at a wall, or a gap that is too narrow, which the line crosses. If an end of this wall or gap is nearer to the
/// line than the radius, the path has to turn around this end.
void DiscLine::look_at_closed(HalfEdge exit) {
  is_blocked_ = true;
  for (const HalfEdge corner : {exit, map_->mesh().twin(exit)}) {
    const Vertex v = map_->mesh().origin(corner);
    const Point position = map_->position(v);
    if (v == from_.vertex || v == to_.vertex || squared_distance(position) >= least_) continue;
    note_obstacle(corner);
  }
}

/// Returns whether the edge lies so far left or right of the line through the two ends that no position on it is nearer
/// than the radius.
bool DiscLine::is_aside(const Point& a, const Point& b) const {
  const double one = cross(direction_, a - start_);
  const double other = cross(direction_, b - start_);
  return std::min(one, other) > map_->radius || std::max(one, other) < -map_->radius;
}

/// Visits the faces beyond `h` that are near the line.
void DiscLine::look_beside(HalfEdge h) {
  to_enter_.clear();
  for (HalfEdge at = h;; at = to_enter_.back(), to_enter_.pop_back()) {
    if (const HalfEdge beyond = enter_beside(at); beyond != mesh::kNoHalfEdge) {
      to_enter_.push_back(mesh::next(beyond));
      to_enter_.push_back(mesh::previous(beyond));
    }
    if (to_enter_.empty()) return;
  }
}

/// Looks at the edge, and at the vertex beyond it if that face is near the line. Returns the half-edge through which
/// the visit enters this face, or kNoHalfEdge if it does not.
HalfEdge DiscLine::enter_beside(HalfEdge at) {
  const mesh::TriangleMesh& mesh = map_->mesh();
  const Point a = map_->position(mesh.origin(at));
  const Point b = map_->position(mesh.target(at));
  if (is_aside(a, b)) return mesh::kNoHalfEdge;
  if (mesh.is_fixed(at)) {
    look_at_wall(at);
    return mesh::kNoHalfEdge;
  }
  if (map_->bridges.is_bridge(at)) return mesh::kNoHalfEdge;
  const HalfEdge beyond = mesh.twin(at);
  std::uint32_t& visited = visited_[number(mesh::face(beyond))];
  if (visited == stamp_.value()) return mesh::kNoHalfEdge;
  // The edge does not cross the line. So the nearest positions include an end of the edge or an end of the line.
  const double nearest = std::min({squared_distance(a), squared_distance(b), squared_distance_to_segment(start_, a, b),
                                   squared_distance_to_segment(end_, a, b)});
  if (nearest >= least_) return mesh::kNoHalfEdge;
  visited = stamp_.value();
  look_at_vertex(mesh::previous(beyond));
  return beyond;
}

// The line does not cross the wall. If a position strictly inside the wall is nearer to the line than both ends of the
// wall are, it is the position nearest to an end of the line. So the function looks only at the ends of the line.
void DiscLine::look_at_wall(HalfEdge h) {
  const Point a = map_->position(map_->mesh().origin(h));
  const Point b = map_->position(map_->mesh().target(h));
  const auto is_near = [&](const Point& p) {
    const Point along = b - a;
    const double share = dot(p - a, along);
    if (share <= 0.0 || share >= squared_length(along)) return false;
    const double across = cross(along, p - a);
    return across * across < least_ * squared_length(along);
  };
  if (is_near(end_) || is_near(start_)) is_blocked_ = true;
}

/// Looks at the vertex at which `corner` starts.
void DiscLine::look_at_vertex(HalfEdge corner) {
  const Vertex v = map_->mesh().origin(corner);
  if (v == from_.vertex || v == to_.vertex) return;
  const Point position = map_->position(v);
  const double squared = squared_distance(position);
  if (squared > touched_) return;
  look_at_feet(v);
  if (squared >= least_) return;
  note_obstacle(corner);
}

/// Notes an obstacle. The straight line between the centres of the two contacts says how the path passes the obstacle:
/// if the obstacle lies left of this line, it also lies left of the path, and the path turns left around it. If it lies
/// on the line, both turns are possible.
void DiscLine::note_obstacle(HalfEdge corner) {
  const Vertex v = map_->mesh().origin(corner);
  const Point position = map_->position(v);
  is_blocked_ = true;
  const double across = cross(to_.contact.centre - from_.contact.centre, position - from_.contact.centre);
  for (const int turn : {kTurnLeft, kTurnRight}) {
    if (turn * across < 0.0) continue;
    const auto line = tangent(from_.contact, {position, turn}, map_->radius);
    if (!line) continue;
    Obstacle& first = obstacles_[turn == kTurnLeft ? 1 : 0];
    const bool is_first = first.vertex == mesh::kNoVertex || turn * cross(line->direction, first.line.direction) > 0.0;
    if (is_first) first = {v, corner, *line};
  }
}

/// Tests the bridges from the vertex to feet that the line crosses.
void DiscLine::look_at_feet(Vertex v) {
  map_->mesh().for_each_outgoing(v, [&](HalfEdge h) {
    if (crosses_foot(h)) is_blocked_ = true;
  });
}

bool DiscLine::crosses_foot(HalfEdge corner) const {
  const auto foot = map_->closed_foot(corner);
  if (!foot) return false;
  const Point from = map_->position(map_->mesh().origin(corner));
  const double one = cross(direction_, from - start_);
  const double other = cross(direction_, *foot - start_);
  if (one * other > 0.0 || one == other) return false;
  const double at = dot(direction_, lerp(from, *foot, one / (one - other)) - start_);
  const double slack = kTouching * map_->explicit_slack;
  return at > -slack && at < length_ + slack;
}

DiscLine::FaceAt DiscLine::face_at(const DiscMap& map, const Point& vertex, const Point& touching, HalfEdge corner) {
  const mesh::TriangleMesh& mesh = map.mesh();
  const Point direction = touching - vertex;
  HalfEdge exit = mesh::next(corner);
  for (;;) {
    const Point a = map.position(mesh.origin(exit));
    if (cross(map.position(mesh.target(exit)) - a, touching - a) >= 0.0) return {exit, false};
    if (mesh.is_fixed(exit)) return {exit, true};
    const HalfEdge entry = mesh.twin(exit);
    exit = cross(direction, map.position(mesh.apex(entry)) - vertex) > 0.0 ? mesh::next(entry) : mesh::previous(entry);
  }
}

}  // namespace waywright::path
