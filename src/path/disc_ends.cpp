#include "path/disc_ends.hpp"

#include "constraint/cover_finder.hpp"

namespace waywright::path {

void DiscEnds::begin(const DiscMap& map, const Point& start, const Point& goal) {
  start_ = start - map.origin;
  goal_ = goal - map.origin;
  at_start_ = locate(map, start);
  const locate::Located at_goal = locate(map, goal);
  goal_face_ = at_goal.h;
  goal_faces_[0] = goal_faces_[1] = mesh::face(at_goal.h);
  if (at_goal.kind == locate::LocatedKind::edge) goal_faces_[1] = mesh::face(map.mesh().twin(at_goal.h));
  const bool is_start_on_edge = at_start_.kind == locate::LocatedKind::edge;
  have_common_face_ = is_goal_face(mesh::face(at_start_.h)) ||
                      (is_start_on_edge && is_goal_face(mesh::face(map.mesh().twin(at_start_.h))));
  const std::size_t count = goal_faces_[0] == goal_faces_[1] ? 1 : 2;
  dead_ends_.begin(map.mesh(), map.core, std::span(goal_faces_, count));
}

/// Locates an end. The half-edge of the result depends only on the positions of the vertices and on the edges of the
/// mesh, so that the searches take the edges at an end in the same order in each world with the same items.
locate::Located DiscEnds::locate(const DiscMap& map, const Point& end) {
  locate::Located location = map.triangulation.triangulation().locate(end);
  constraint::faces_at(map.triangulation, location, faces_);
  location.h = faces_.front();
  return location;
}

}  // namespace waywright::path
