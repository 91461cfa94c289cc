#include "path/point_ends.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "constraint/segment_walk.hpp"
#include "exact/filter.hpp"
#include "nav/point_agent.hpp"

namespace waywright::path {

using mesh::HalfEdge;

/// Stops a segment walk as soon as it is not certain that the straight line between the ends is clear: at a wall,
/// at a vertex on the line, or if a polygon covers the first face.
class PointEnds::StraightLine : public constraint::SegmentVisitor {
 public:
  explicit StraightLine(PointEnds& ends)
      : ends_(ends),
        mesh_(ends.triangulation_->topology()),
        is_at_start_(ends.start_location_.kind != locate::LocatedKind::face) {
    ends_.crossed_.clear();
  }

  /// Returns whether the walk has reached the goal.
  [[nodiscard]] bool is_clear() const { return is_inside_ && !is_stopped_; }

  bool through_face(HalfEdge h) {
    if (is_inside_) [[likely]]
      return true;
    if (ends_.cover_finder_.is_covered(*ends_.triangulation_, h)) return stop();
    return is_inside_ = true;
  }

  bool at_edge(HalfEdge h, bool ends_here) {
    if (ends_here || (!is_inside_ && leaves_start())) return true;
    if (!nav::PointAgent::can_cross(mesh_, h)) return stop();
    ends_.crossed_.push_back(h);
    return true;
  }

  bool at_vertex(mesh::Vertex v) {
    if (leaves_start()) return true;
    const auto& geometry = ends_.triangulation_->triangulation().geometry();
    const bool is_goal = geometry.order(exact::Geometry::view(ends_.goal_), geometry.view(number(v))) == 0;
    return is_goal || stop();
  }

 private:
  bool leaves_start() { return std::exchange(is_at_start_, false); }
  bool stop() {
    is_stopped_ = true;
    return false;
  }

  PointEnds& ends_;
  const mesh::TriangleMesh& mesh_;
  bool is_at_start_;
  bool is_inside_ = false;  ///< whether the walk is inside an open face
  bool is_stopped_ = false;
};

// Rounding to float moves a coordinate by up to 2^-24 of its value, and a program computes a point in a few steps.
double default_end_tolerance(const Box& domain) { return 0x1p-20 * exact::filter::largest_magnitude(domain); }

void PointEnds::set_start(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Point& start,
                          const std::optional<double>& tolerance) {
  triangulation_ = &triangulation;
  abstraction_ = abstraction;
  cover_finder_.use(abstraction);
  start_ = start;
  tolerance_ = tolerance;
  start_location_ = triangulation.triangulation().locate(start);
  is_start_known_ = false;
  may_start_move_ = true;
  moved_start_.reset();
}

void PointEnds::move_blocked_start() {
  find_start_faces();
  if (start_faces_.empty()) move_start({});
  may_start_move_ = false;
}

// The same polygons cover the two faces that share a free edge. So if the straight line crosses no wall and its first
// face is open, all faces that it crosses are open. Then neither end lies strictly inside a polygon.
std::optional<PathStatus> PointEnds::find_status_without_search(const Point& goal) {
  goal_ = goal;
  moved_goal_.reset();
  if (sees_goal()) return PathStatus::found;
  if (!is_start_known_) find_start_faces();
  goal_location_ = triangulation_->triangulation().locate(goal_);
  find_goal_faces();
  const bool is_blocked = start_faces_.empty() || goal_faces_.empty();
  const bool has_moved = is_blocked ? move_blocked_ends() : move_end_across_wall();
  if (has_moved && sees_goal()) return PathStatus::found;
  return known_status();
}

/// Returns the status of the path if the straight line is not clear and no search is necessary. An end can have no open
/// face around it and still lie strictly inside no polygon: then it lies on the boundaries of the polygons that cover
/// its surroundings, and the status is no_path, unless the two ends are equal.
std::optional<PathStatus> PointEnds::known_status() {
  std::swap(crossed_before_stop_, crossed_);
  crossed_.clear();
  const bool is_start_blocked =
      start_faces_.empty() && cover_finder_.is_strictly_inside(*triangulation_, start_location_);
  if (is_start_blocked) return PathStatus::start_blocked;
  const bool is_goal_blocked = goal_faces_.empty() && cover_finder_.is_strictly_inside(*triangulation_, goal_location_);
  if (is_goal_blocked) return PathStatus::goal_blocked;
  if (start_ == goal_) return PathStatus::found;
  if (start_faces_.empty() || goal_faces_.empty()) return PathStatus::no_path;
  if (abstraction_ != nullptr && !are_connected(abstraction_->components())) return PathStatus::no_path;
  // If the ends have a face in common but the straight line is not clear, both ends lie on one edge of this face. The
  // path runs along the edge.
  const bool is_straight =
      std::any_of(start_faces_.begin(), start_faces_.end(), [&](HalfEdge h) { return is_goal(mesh::face(h)); });
  if (is_straight) return PathStatus::found;
  return std::nullopt;
}

bool PointEnds::sees_goal() {
  StraightLine line(*this);
  constraint::SegmentWalk(*triangulation_, start_, goal_, start_location_).run(line);
  return line.is_clear();
}

// A position strictly inside a polygon has no open face around it.
void PointEnds::find_start_faces() {
  start_faces_ = cover_finder_.open_faces(*triangulation_, start_location_);
  is_start_known_ = true;
}

void PointEnds::find_goal_faces() { goal_faces_ = cover_finder_.open_faces(*triangulation_, goal_location_); }

/// Moves the ends that have no open face around them. Returns whether both ends now have an open face around them.
bool PointEnds::move_blocked_ends() {
  if (start_faces_.empty() && may_start_move_) move_start(goal_faces_);
  if (goal_faces_.empty() && !start_faces_.empty()) {
    if (const auto found = find_free_position(goal_, goal_location_, start_faces_)) move_goal_to(*found);
  }
  return !start_faces_.empty() && !goal_faces_.empty();
}

/// A rounding error may have put an end beyond a wall. If the ends are not connected, and an end is at most a rounding
/// error away from a wall that separates them, moves this end across the wall. Returns whether it has moved an end.
bool PointEnds::move_end_across_wall() {
  if (abstraction_ == nullptr || !(tolerance() > 0.0) || are_connected(abstraction_->components())) return false;
  const double rounding = std::min(tolerance(), default_end_tolerance(triangulation_->domain()));
  if (may_start_move_) {
    if (const auto found = find_connected_position(start_, start_location_, goal_faces_, rounding)) {
      move_start_to(*found);
      return true;
    }
  }
  const auto found = find_connected_position(goal_, goal_location_, start_faces_, rounding);
  if (found) move_goal_to(*found);
  return found.has_value();
}

void PointEnds::move_start(const std::vector<HalfEdge>& goal_faces) {
  if (const auto found = find_free_position(start_, start_location_, goal_faces)) move_start_to(*found);
}

void PointEnds::move_start_to(const Point& point) {
  moved_start_ = MovedEnd{start_, point};
  start_ = point;
  start_location_ = triangulation_->triangulation().locate(start_);
  find_start_faces();
}

void PointEnds::move_goal_to(const Point& point) {
  moved_goal_ = MovedEnd{goal_, point};
  goal_ = point;
  goal_location_ = triangulation_->triangulation().locate(goal_);
  find_goal_faces();
}

/// Returns the free position nearest to an end. If some free positions within the limit are connected with the other
/// end, returns the nearest of these.
std::optional<Point> PointEnds::find_free_position(const Point& end, const locate::Located& location,
                                                   const std::vector<HalfEdge>& other_faces) {
  const double limit = tolerance();
  if (!(limit > 0.0)) return std::nullopt;
  if (abstraction_ != nullptr && !other_faces.empty()) {
    if (const auto found = find_connected_position(end, location, other_faces, limit)) return found;
  }
  return free_positions_.nearest(*triangulation_, cover_finder_, end, location, limit, {});
}

std::optional<Point> PointEnds::find_connected_position(const Point& end, const locate::Located& location,
                                                        const std::vector<HalfEdge>& other_faces, double limit) {
  return free_positions_.nearest(*triangulation_, cover_finder_, end, location, limit,
                                 {&abstraction_->components(), &other_faces});
}

void PointEnds::write_moved_and_blocked(PathStatus status, Path& path) {
  path.moved_start = moved_start_;
  path.moved_goal = moved_goal_;
  const bool is_start = status == PathStatus::start_blocked;
  if (!is_start && status != PathStatus::goal_blocked) return;
  for (const std::uint32_t slot :
       cover_finder_.strictly_covering(*triangulation_, is_start ? start_location_ : goal_location_)) {
    path.blockers.push_back(triangulation_->items().id(slot));
  }
  std::sort(path.blockers.begin(), path.blockers.end());
}

bool PointEnds::are_covered() {
  const auto is_covered = [&](HalfEdge h) { return cover_finder_.is_covered(*triangulation_, h); };
  return std::any_of(start_faces_.begin(), start_faces_.end(), is_covered) ||
         std::any_of(goal_faces_.begin(), goal_faces_.end(), is_covered);
}

bool PointEnds::are_connected(const nav::Components& components) const {
  for (const HalfEdge start : start_faces_) {
    for (const HalfEdge goal : goal_faces_) {
      if (components.component_of(mesh::face(start)) == components.component_of(mesh::face(goal))) return true;
    }
  }
  return false;
}

}  // namespace waywright::path
