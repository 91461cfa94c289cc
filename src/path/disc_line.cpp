#include "path/disc_line.hpp"

#include <algorithm>
#include <cmath>

#include "path/distance.hpp"

namespace waywright::path {

using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// If the distance of a vertex from the line is at most the radius plus this many times DiscMap::slack, the test also
/// looks at the foot bridges that start at the vertex. It decides exactly whether they are wide enough.
constexpr double kTouching = 16.0;

/// The walk follows the line from its end. If it leaves a face before this share of the length of the line, the line
/// surely continues beyond the face, in spite of rounding.
constexpr double kSurelyBefore = 0.875;

}  // namespace

DiscLine::Offset DiscLine::offset(Vertex v) const {
  const Point position = map_->position(v);
  const Point to = position - end_;
  return {position, dot(back_, to), cross(back_, to)};
}

/// Returns the square of the distance from a position to the line.
double DiscLine::squared_distance(const Offset& at) const {
  if (at.along <= 0.0) return squared_length(at.position - end_);
  if (at.along >= length_) return squared_length(at.position - start_);
  return at.across * at.across;
}

bool DiscLine::is_clear(const DiscMap& map, const End& from, const End& to, const Tangent& line, HalfEdge face) {
  map_ = &map;
  from_ = from;
  to_ = to;
  direction_ = line.direction;
  back_ = -direction_;
  length_ = line.length;
  start_ = touching_position(from.pivot, direction_, map.radius);
  end_ = touching_position(to.pivot, direction_, map.radius);
  least_squared_ = map.least_distance() * map.least_distance();
  reach_ = map.radius + kTouching * map.slack;
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
  const auto is_beyond = [&](const Offset& origin, const Offset& target) {
    if (std::max(origin.along, target.along) < kSurelyBefore * length_) return true;
    return cross(target.position - origin.position, start_ - origin.position) < 0.0;
  };
  visited_[number(mesh::face(face))] = stamp_.value();
  const HalfEdge edges[3] = {face, mesh::next(face), mesh::previous(face)};
  const Offset ends[3] = {offset(mesh.origin(edges[0])), offset(mesh.origin(edges[1])), offset(mesh.origin(edges[2]))};
  int first = 3;
  for (int i = 0; i < 3; ++i) {
    look_at_vertex(edges[i], ends[i]);
    const Offset& target = ends[(i + 1) % 3];
    if (first == 3 && ends[i].across <= 0.0 && target.across >= 0.0 && is_beyond(ends[i], target)) first = i;
  }
  for (int i = 0; i < 3; ++i) {
    if (i != first) look_beside(edges[i], ends[i], ends[(i + 1) % 3]);
  }
  if (first == 3) return;
  HalfEdge exit = edges[first];
  Offset right = ends[first];
  Offset left = ends[(first + 1) % 3];
  for (;;) {
    if (map_->is_closed(exit, squared_length(left.position - right.position))) return note_ends_as_obstacles(exit);
    const HalfEdge entry = mesh.twin(exit);
    visited_[number(mesh::face(entry))] = stamp_.value();
    const HalfEdge before = mesh::previous(entry);
    const HalfEdge after = mesh::next(entry);
    const Offset apex = offset(mesh.origin(before));
    look_at_vertex(before, apex);
    // The line crosses one of the two other edges of the face. The other one lies left or right of the line.
    if (apex.across > 0.0) {
      if (std::min(apex.across, left.across) <= map_->radius) visit_beside(before, apex, left);
      exit = after;
      left = apex;
    } else {
      if (std::max(right.across, apex.across) >= -map_->radius) visit_beside(after, right, apex);
      exit = before;
      right = apex;
    }
    if (is_beyond(right, left)) continue;
    return look_beside(exit, right, left);
  }
}

/// The line crosses a wall or a gap that is too narrow. Looks at the two ends of this wall or gap. If an end is nearer
/// to the line than the radius, the path has to turn around this end.
void DiscLine::note_ends_as_obstacles(HalfEdge exit) {
  is_blocked_ = true;
  for (const HalfEdge corner : {exit, map_->mesh().twin(exit)}) {
    const Vertex v = map_->mesh().origin(corner);
    if (v == from_.vertex || v == to_.vertex || squared_distance(offset(v)) >= least_squared_) continue;
    note_obstacle(corner);
  }
}

/// Returns whether a position on the edge is nearer to the line than the radius. Requires: the edge does not cross the
/// line.
bool DiscLine::is_edge_near(const Offset& a, const Offset& b) const {
  // The distance between the edge and the line is the distance of an end of the edge from the line, or of an end of the
  // line from the edge. An end of the line can be the nearest position only if the edge reaches beyond it.
  if (std::min(squared_distance(a), squared_distance(b)) < least_squared_) return true;
  const auto is_near = [&](const Point& end) {
    return squared_distance_to_segment(end, a.position, b.position) < least_squared_;
  };
  return (std::min(a.along, b.along) < 0.0 && is_near(end_)) ||
         (std::max(a.along, b.along) > length_ && is_near(start_));
}

void DiscLine::visit_beside(HalfEdge h, const Offset& origin, const Offset& target) {
  if (!enter_beside(h, origin, target)) return;
  entered_.clear();
  entered_.push_back({h, origin, target});
  while (!entered_.empty()) {
    // The visit has entered the face beyond this edge.
    const Entered at = entered_.back();
    entered_.pop_back();
    const HalfEdge beyond = map_->mesh().twin(at.h);
    const Offset apex = offset(map_->mesh().apex(beyond));
    look_at_vertex(mesh::previous(beyond), apex);
    if (enter_beside(mesh::next(beyond), at.origin, apex)) entered_.push_back({mesh::next(beyond), at.origin, apex});
    if (enter_beside(mesh::previous(beyond), apex, at.target))
      entered_.push_back({mesh::previous(beyond), apex, at.target});
  }
}

/// Returns whether the visit enters the face beyond the edge. It does so if a position on the edge is near the line,
/// the edge is no wall and no bridge, and the test has not visited the face yet. If the edge is a wall near the line,
/// the function looks at the wall.
bool DiscLine::enter_beside(HalfEdge at, const Offset& origin, const Offset& target) {
  if (is_aside(origin, target)) return false;
  const mesh::TriangleMesh& mesh = map_->mesh();
  if (mesh.is_fixed(at)) {
    look_at_wall(origin.position, target.position);
    return false;
  }
  std::uint32_t& visited = visited_[number(mesh::face(mesh.twin(at)))];
  if (visited == stamp_.value() || map_->bridges.is_bridge(at) || !is_edge_near(origin, target)) return false;
  visited = stamp_.value();
  return true;
}

// The line does not cross the wall. Suppose that a position strictly inside the wall is nearer to the line than both
// ends of the wall are. Then an end of the line is the nearest position of the line. So the function looks only at the
// ends of the line.
void DiscLine::look_at_wall(const Point& a, const Point& b) {
  const auto is_near = [&](const Point& p) {
    const Point along = b - a;
    const double share = dot(p - a, along);
    if (share <= 0.0 || share >= squared_length(along)) return false;
    const double across = cross(along, p - a);
    return across * across < least_squared_ * squared_length(along);
  };
  if (is_near(end_) || is_near(start_)) is_blocked_ = true;
}

void DiscLine::look_at_near_vertex(HalfEdge corner, const Offset& at) {
  const double squared = squared_distance(at);
  if (squared > reach_ * reach_) return;
  const Vertex v = map_->mesh().origin(corner);
  if (v == from_.vertex || v == to_.vertex) return;
  look_at_feet(v);
  if (squared >= least_squared_) return;
  note_obstacle(corner);
}

/// Notes an obstacle. The straight line between the centres of the two pivots says how the path passes the obstacle:
/// if the obstacle lies left of this line, it also lies left of the path, and the path turns left around it. If it lies
/// on the line, both turns are possible.
void DiscLine::note_obstacle(HalfEdge corner) {
  const Vertex v = map_->mesh().origin(corner);
  const Point position = map_->position(v);
  is_blocked_ = true;
  const double across = cross(to_.pivot.centre - from_.pivot.centre, position - from_.pivot.centre);
  for (const int turn : {kTurnLeft, kTurnRight}) {
    if (turn * across < 0.0) continue;
    const auto line = tangent(from_.pivot, {position, turn}, map_->radius);
    if (!line) continue;
    Obstacle& first = obstacles_[turn == kTurnLeft ? 1 : 0];
    const bool is_first = first.vertex == mesh::kNoVertex || turn * cross(line->direction, first.line.direction) > 0.0;
    if (is_first) first = {v, corner, *line};
  }
}

/// Fails the test if the line crosses a narrow foot bridge that starts at the vertex.
void DiscLine::look_at_feet(Vertex v) {
  map_->mesh().for_each_outgoing(v, [&](HalfEdge h) {
    if (crosses_foot(h)) is_blocked_ = true;
  });
}

bool DiscLine::crosses_foot(HalfEdge corner) const {
  const auto foot = map_->narrow_bridge_foot(corner);
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
