#include "path/polyline_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "constraint/boxes.hpp"
#include "nav/point_agent.hpp"

namespace waywright::path {

using exact::Sign;
using locate::LocatedKind;
using mesh::HalfEdge;

bool PolylineWalk::is_clear(const Triangulation& triangulation, constraint::CoverFinder& cover_finder,
                            std::span<const Point> points) {
  if (points.empty()) return false;
  use(triangulation);
  const locate::Located start = start_at(cover_finder, points.front());
  if (states_.empty()) {
    const bool stays = std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points.front(); });
    return stays && !cover_finder.is_strictly_inside(triangulation, start);
  }
  for (std::size_t i = 1; i < points.size() && !states_.empty(); ++i) walk_to(points, i);
  return !states_.empty();
}

// The agent reaches the first point of the stretch in the same wedges as before, but this function does not know in
// which. So it starts in all of them. If the agent cannot pass from any of them, the stretch is blocked. Otherwise it
// can pass from the one wedge into which the segment leads: only a segment along a wall leads into two wedges. For the
// same reason it reaches the last point in the same wedge as before, and the rest of the polyline is as it was.
PolylineWalk::StretchState PolylineWalk::find_stretch_state(const Triangulation& triangulation,
                                                            constraint::CoverFinder& cover_finder,
                                                            std::span<const Point> points, std::size_t first,
                                                            std::size_t last) {
  use(triangulation);
  if (first > 0) {
    possible_ends_.clear();
    collect_crossings_at(points[first]);
    if (!possible_ends_.empty()) return StretchState::unsure;
  }
  static_cast<void>(start_at(cover_finder, points[first]));
  if (states_.empty()) return StretchState::unsure;
  for (std::size_t i = first + 1; i <= last && !states_.empty(); ++i) walk_to(points, i);
  if (states_.empty()) return StretchState::blocked;
  return is_unsure_ ? StretchState::unsure : StretchState::clear;
}

void PolylineWalk::use(const Triangulation& triangulation) {
  triangulation_ = &triangulation;
  mesh_ = &triangulation.topology();
  is_unsure_ = false;
}

/// Sets `states_` to all faces in which an agent at `point` can be. Returns where the point is.
locate::Located PolylineWalk::start_at(constraint::CoverFinder& cover_finder, const Point& point) {
  const locate::Located start = triangulation_->triangulation().locate(point);
  arrived_.clear();
  for (const HalfEdge h : cover_finder.open_faces(*triangulation_, start)) {
    const HalfEdge canonical = start.kind == LocatedKind::vertex ? first_of_wedge(h) : h;
    add_arrived({start.kind, canonical, exact::Geometry::view(point)});
  }
  std::swap(states_, arrived_);
  return start;
}

/// Walks from points[i - 1] to points[i].
void PolylineWalk::walk_to(std::span<const Point> points, std::size_t i) {
  possible_ends_.assign(1, exact::Geometry::view(points[i]));
  if (i + 1 < points.size()) collect_crossings_at(points[i]);
  if (possible_ends_.size() > 1) is_unsure_ = true;
  arrived_.clear();
  for (const View& end : possible_ends_) walk_segment(end);
  std::swap(states_, arrived_);
}

namespace {

/// Returns a small box that contains all positions whose rounded coordinates are the coordinates of `point`. All
/// coordinates of the box are in range.
Box box_of_rounded(const Point& point) {
  constexpr double kTiny = 2.0 * kSmallestCoordinate;
  const auto margin = [&](double coordinate) {
    return std::abs(coordinate) <= kTiny ? 2.0 * kTiny : std::abs(coordinate) * 0x1p-51;
  };
  const double dx = margin(point.x);
  const double dy = margin(point.y);
  const auto shift = [&](double coordinate, double by) { return std::abs(coordinate) <= kTiny ? by : coordinate + by; };
  return {{shift(point.x, -dx), shift(point.y, -dy)}, {shift(point.x, dx), shift(point.y, dy)}};
}

}  // namespace

/// Adds to `possible_ends_` the constructed vertices whose rounded coordinates are the coordinates of `point`. Each of
/// them lies within box_of_rounded(point), so it is a vertex of a face that meets this box.
void PolylineWalk::collect_crossings_at(const Point& point) {
  if (!geometry().has_constructed()) return;
  const constraint::BoxTest box(box_of_rounded(point));
  const auto reach = [&](HalfEdge h) {
    if (triangulation_->triangulation().is_ghost_face(h)) return;
    const mesh::Face f = mesh::face(h);
    if (std::find(flooded_.begin(), flooded_.end(), f) == flooded_.end()) flooded_.push_back(f);
  };
  flooded_.clear();
  const HalfEdge near = triangulation_->triangulation().locate(point).h;
  reach(near);
  reach(mesh_->twin(near));
  for (std::size_t i = 0; i < flooded_.size(); ++i) {
    HalfEdge h = mesh::first(flooded_[i]);
    for (int corner = 0; corner < 3; ++corner, h = mesh::next(h)) {
      const auto v = number(mesh_->origin(h));
      const bool is_possible_end = !geometry().is_explicit(v) && geometry().rounded(v) == point;
      const auto is_known = [&](const View& end) { return end.vertex == v; };
      if (is_possible_end && std::none_of(possible_ends_.begin(), possible_ends_.end(), is_known))
        possible_ends_.push_back(geometry().view(v));
      if (box.meets(geometry().exact(v), geometry().exact(number(mesh_->target(h))))) reach(mesh_->twin(h));
    }
  }
}

/// Walks from all states straight to `target`, and adds the states there to `arrived_`.
void PolylineWalk::walk_segment(const View& target) {
  for (const State& start : states_) {
    line_ = {start.position, target};
    const auto order = geometry().order(start.position, target);
    if (order == 0) {
      add_arrived(start);
      continue;
    }
    ascends_ = order < 0;
    wedges_.clear();
    waiting_.assign(1, start);
    for (std::size_t next = 0; next < waiting_.size(); ++next) {
      const State state = waiting_[next];
      leave(state);
    }
  }
}

Sign PolylineWalk::orientation(mesh::Vertex v) const { return geometry().orientation(line_, view(v)); }

/// Returns whether `q` comes after `p` on the segment. Requires: both lie on its line.
bool PolylineWalk::is_ahead(const View& p, const View& q) const {
  const auto order = geometry().order(p, q);
  return ascends_ ? order < 0 : order > 0;
}

/// Returns whether the segment ends before `v`. Requires: `v` lies on the segment's line, ahead of the agent.
bool PolylineWalk::ends_before(mesh::Vertex v) const { return is_ahead(line_.to, view(v)); }

void PolylineWalk::leave(const State& state) {
  switch (state.kind) {
    case LocatedKind::vertex:
      return leave_vertex(state.h);
    case LocatedKind::edge:
      return leave_edge(state.h);
    case LocatedKind::face:
      return leave_face(state.h);
  }
}

/// Leaves the origin of `h` from the wedge that contains the face of `h`. Tries the wedge's faces counter-clockwise
/// from its first face.
void PolylineWalk::leave_vertex(HalfEdge h) {
  const HalfEdge first = first_of_wedge(h);
  h = first;
  do {
    if (leave_vertex_through(h)) return;
    h = mesh::previous(h);
    if (!nav::PointAgent::can_cross(*mesh_, h)) return;
    h = mesh_->twin(h);
  } while (h != first);
}

/// Leaves the origin of `h` through the face of `h`, if the segment runs through the face's interior or along one of
/// its two edges at the vertex. Returns whether leave_vertex() can skip the other faces of the wedge.
//
//    apex
//     |  \          The face lies on the left of the edge to the target, and on the right of the edge to the apex.
//     v - target
bool PolylineWalk::leave_vertex_through(HalfEdge h) {
  const View at = view(mesh_->origin(h));
  const mesh::Vertex target = mesh_->target(h);
  const mesh::Vertex apex = mesh_->apex(h);
  const Sign target_side = orientation(target);
  const Sign apex_side = orientation(apex);
  if (target_side == Sign::negative && apex_side == Sign::positive) {
    cross_faces(mesh::next(h));
    return true;
  }
  if (target_side == Sign::zero && is_ahead(at, view(target))) run_along(h, mesh::next(h));
  if (apex_side == Sign::zero && is_ahead(at, view(apex))) run_along(mesh::previous(h), mesh::previous(h));
  return false;
}

/// Leaves a position on the edge of `h`. The agent is in the face of `h`.
void PolylineWalk::leave_edge(HalfEdge h) {
  const mesh::Vertex from = mesh_->origin(h);
  const mesh::Vertex to = mesh_->target(h);
  const Sign end_side = geometry().orientation(view(from), view(to), line_.to);
  if (end_side == Sign::positive) return enter(h);
  if (end_side == Sign::negative) {
    if (nav::PointAgent::can_cross(*mesh_, h)) enter(mesh_->twin(h));
    return;
  }
  const bool goes_to_target = is_ahead(view(from), view(to));
  run_along(h, goes_to_target ? mesh::next(h) : h);
}

/// Leaves a position inside the face of `h`.
void PolylineWalk::leave_face(HalfEdge h) {
  const std::array<HalfEdge, 3> edges = {h, mesh::next(h), mesh::previous(h)};
  std::array<Sign, 3> corner{};
  for (std::size_t i = 0; i < 3; ++i) corner[i] = orientation(mesh_->origin(edges[i]));
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign after = corner[(i + 1) % 3];
    const Sign before = corner[(i + 2) % 3];
    // A corner on the line lies ahead if the next corner is to the left of the line and the previous one to its right.
    if (corner[i] == Sign::zero && after == Sign::positive && before == Sign::negative) {
      if (ends_before(mesh_->origin(edges[i]))) return arrive(LocatedKind::face, h);
      return reach_vertex(edges[i]);
    }
    if (corner[i] == Sign::negative && after == Sign::positive) return cross_faces(edges[i]);
  }
}

/// Follows `edge`, in its face, to a vertex or to the end of the segment. `at_end` is the half-edge of the same face
/// that starts at that vertex.
void PolylineWalk::run_along(HalfEdge edge, HalfEdge at_end) {
  if (!nav::PointAgent::can_cross(*mesh_, edge)) is_unsure_ = true;
  if (ends_before(mesh_->origin(at_end))) return arrive(LocatedKind::edge, edge);
  reach_vertex(at_end);
}

/// Leaves a face through the interior of its edge `exit`, unless the segment ends before or on that edge.
void PolylineWalk::cross_faces(HalfEdge exit) {
  const Sign end_side = geometry().orientation(view(mesh_->origin(exit)), view(mesh_->target(exit)), line_.to);
  if (end_side == Sign::positive) return arrive(LocatedKind::face, exit);
  if (end_side == Sign::zero) return arrive(LocatedKind::edge, exit);
  if (nav::PointAgent::can_cross(*mesh_, exit)) enter(mesh_->twin(exit));
}

/// Enters a face through the interior of `entry`, and continues as long as the segment crosses passages.
void PolylineWalk::enter(HalfEdge entry) {
  for (;;) {
    const Sign apex_side = orientation(mesh_->apex(entry));
    if (apex_side == Sign::zero) {
      if (ends_before(mesh_->apex(entry))) return arrive(LocatedKind::face, entry);
      return reach_vertex(mesh::previous(entry));
    }
    const HalfEdge exit = apex_side == Sign::positive ? mesh::next(entry) : mesh::previous(entry);
    const Sign end_side = geometry().orientation(view(mesh_->origin(exit)), view(mesh_->target(exit)), line_.to);
    if (end_side == Sign::positive) return arrive(LocatedKind::face, exit);
    if (end_side == Sign::zero) return arrive(LocatedKind::edge, exit);
    if (!nav::PointAgent::can_cross(*mesh_, exit)) return;
    entry = mesh_->twin(exit);
  }
}

void PolylineWalk::arrive(LocatedKind kind, HalfEdge h) { add_arrived({kind, h, line_.to}); }

void PolylineWalk::add_arrived(const State& state) {
  const auto is_same = [&](const State& other) {
    return other.h == state.h && other.kind == state.kind && other.position.vertex == state.position.vertex;
  };
  if (std::none_of(arrived_.begin(), arrived_.end(), is_same)) arrived_.push_back(state);
}

/// Reaches the origin of `outgoing` through the face of `outgoing`. The segment ends there or continues from there.
void PolylineWalk::reach_vertex(HalfEdge outgoing) {
  const HalfEdge wedge = first_of_wedge(outgoing);
  // The agent reaches the vertices in their order on the line. It reaches each of them at most once from
  // the left of the line and at most once from the right.
  const auto recent = wedges_.end() - static_cast<std::ptrdiff_t>(std::min<std::size_t>(wedges_.size(), 4));
  if (std::find(recent, wedges_.end(), wedge) != wedges_.end()) return;
  wedges_.push_back(wedge);
  const View position = view(mesh_->origin(outgoing));
  if (geometry().order(position, line_.to) == 0) return arrive(LocatedKind::vertex, wedge);
  waiting_.push_back({LocatedKind::vertex, wedge, position});
}

/// Returns the name of the wedge between walls that contains the face of `outgoing`: the first half-edge of the wedge,
/// counter-clockwise. A vertex without walls has one wedge; its name is the half-edge with the smallest number.
HalfEdge PolylineWalk::first_of_wedge(HalfEdge outgoing) const {
  HalfEdge least = outgoing;
  HalfEdge h = outgoing;
  while (nav::PointAgent::can_cross(*mesh_, h)) {
    h = mesh_->previous_around(h);
    if (h == outgoing) return least;
    least = std::min(least, h);
  }
  return h;
}

}  // namespace waywright::path
