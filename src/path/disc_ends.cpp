#include "path/disc_ends.hpp"

namespace waywright::path {

void DiscEnds::begin(const DiscMap& map, const Point& start, const Point& goal) {
  start_ = start - map.origin;
  goal_ = goal - map.origin;
  at_start_ = map.triangulation.triangulation().locate(start);
  const locate::Located at_goal = map.triangulation.triangulation().locate(goal);
  goal_face_ = at_goal.h;
  goal_faces_[0] = goal_faces_[1] = mesh::face(at_goal.h);
  if (at_goal.kind == locate::LocatedKind::edge) goal_faces_[1] = mesh::face(map.mesh().twin(at_goal.h));
  const bool is_start_on_edge = at_start_.kind == locate::LocatedKind::edge;
  have_common_face_ = is_goal_face(mesh::face(at_start_.h)) ||
                      (is_start_on_edge && is_goal_face(mesh::face(map.mesh().twin(at_start_.h))));
  const std::size_t count = goal_faces_[0] == goal_faces_[1] ? 1 : 2;
  dead_ends_.begin(map.mesh(), map.core, std::span(goal_faces_, count));
}

}  // namespace waywright::path
