#include "path/ends.hpp"

#include <algorithm>

namespace waywright::path {

std::optional<PathStatus> Ends::find(const Triangulation& triangulation, const Abstraction* abstraction,
                                     const Point& start, const Point& goal) {
  const auto& delaunay = triangulation.triangulation();
  start_ = start;
  goal_ = goal;
  start_place_ = delaunay.locate(start);
  goal_place_ = delaunay.locate(goal);
  cover_.use(abstraction);
  if (cover_.is_strictly_inside(triangulation, start_place_)) return PathStatus::start_blocked;
  if (cover_.is_strictly_inside(triangulation, goal_place_)) return PathStatus::goal_blocked;
  if (start == goal) return PathStatus::found;
  start_faces_ = cover_.open_faces(triangulation, start_place_);
  goal_faces_ = cover_.open_faces(triangulation, goal_place_);
  if (start_faces_.empty() || goal_faces_.empty()) return PathStatus::no_path;
  if (abstraction != nullptr && !are_joined(abstraction->components())) return PathStatus::no_path;
  const bool is_straight =
      std::any_of(start_faces_.begin(), start_faces_.end(), [&](mesh::HalfEdge h) { return is_goal(mesh::face(h)); });
  if (is_straight) return PathStatus::found;
  return std::nullopt;
}

bool Ends::are_joined(const Components& components) const {
  for (const mesh::HalfEdge start : start_faces_) {
    for (const mesh::HalfEdge goal : goal_faces_) {
      if (components.of(mesh::face(start)) == components.of(mesh::face(goal))) return true;
    }
  }
  return false;
}

}  // namespace waywright::path
