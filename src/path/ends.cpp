#include "path/ends.hpp"

#include <algorithm>
#include <utility>

#include "constraint/segment_walk.hpp"

namespace waywright::path {

using mesh::HalfEdge;

/// Stops a segment walk where the straight way between the ends is not surely free: at a wall, at a vertex on the way,
/// where a polygon covers the first face.
class Ends::StraightWay : public constraint::SegmentVisitor {
 public:
  explicit StraightWay(Ends& ends)
      : ends_(ends),
        mesh_(ends.triangulation_->topology()),
        is_at_start_(ends.start_place_.spot != locate::Spot::face) {
    ends_.crossed_.clear();
  }

  /// Whether the walk has come to the goal.
  [[nodiscard]] bool is_free() const { return is_inside_ && !is_stopped_; }

  bool through_face(HalfEdge h) {
    if (is_inside_) [[likely]]
      return true;
    if (ends_.cover_.is_covered(*ends_.triangulation_, h)) return stop();
    return is_inside_ = true;
  }

  bool at_edge(HalfEdge h, bool ends_here) {
    if (ends_here || (!is_inside_ && leaves_start())) return true;
    if (mesh_.is_fixed(h)) return stop();
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

  Ends& ends_;
  const mesh::TriangleMesh& mesh_;
  bool is_at_start_;
  bool is_inside_ = false;  ///< an open face
  bool is_stopped_ = false;
};

void Ends::set_start(const Triangulation& triangulation, const Abstraction* abstraction, const Point& start) {
  triangulation_ = &triangulation;
  abstraction_ = abstraction;
  cover_.use(abstraction);
  start_ = start;
  start_place_ = triangulation.triangulation().locate(start);
  is_start_known_ = false;
}

// Faces that free edges join are covered alike. So where the first on the straight way is open, all are, and no polygon
// can have an end strictly inside.
std::optional<PathStatus> Ends::set_goal(const Point& goal) {
  goal_ = goal;
  if (sees_goal()) return PathStatus::found;
  crossed_.clear();
  if (!is_start_known_) find_start_faces();
  if (is_start_blocked_) return PathStatus::start_blocked;
  const locate::Located goal_place = triangulation_->triangulation().locate(goal);
  goal_faces_ = cover_.open_faces(*triangulation_, goal_place);
  if (goal_faces_.empty() && cover_.is_strictly_inside(*triangulation_, goal_place)) return PathStatus::goal_blocked;
  if (start_ == goal_) return PathStatus::found;
  if (start_faces_.empty() || goal_faces_.empty()) return PathStatus::no_path;
  if (abstraction_ != nullptr && !are_joined(abstraction_->components())) return PathStatus::no_path;
  // Along an edge between them.
  const bool is_straight =
      std::any_of(start_faces_.begin(), start_faces_.end(), [&](HalfEdge h) { return is_goal(mesh::face(h)); });
  if (is_straight) return PathStatus::found;
  return std::nullopt;
}

bool Ends::sees_goal() {
  StraightWay way(*this);
  constraint::SegmentWalk(*triangulation_, start_, goal_, start_place_).run(way);
  return way.is_free();
}

// What lies strictly inside a polygon has no open face around it.
void Ends::find_start_faces() {
  start_faces_ = cover_.open_faces(*triangulation_, start_place_);
  is_start_blocked_ = start_faces_.empty() && cover_.is_strictly_inside(*triangulation_, start_place_);
  is_start_known_ = true;
}

bool Ends::are_joined(const Components& components) const {
  for (const HalfEdge start : start_faces_) {
    for (const HalfEdge goal : goal_faces_) {
      if (components.of(mesh::face(start)) == components.of(mesh::face(goal))) return true;
    }
  }
  return false;
}

}  // namespace waywright::path
