#include "path/disc_guide.hpp"

namespace waywright::path {

using mesh::HalfEdge;

void DiscGuide::begin(const DiscMap& map, const DiscEnds& ends, const Point& start, const Point& goal) {
  const mesh::TriangleMesh& mesh = map.mesh();
  const HalfEdge at_goal = ends.goal_face();
  const bool is_goal_on_edge = ends.is_goal_on_edge();
  const locate::Located& at_start = ends.at_start();
  radius_ = map.radius;
  first_.assign({at_goal});
  if (is_goal_on_edge) first_.push_back(mesh.twin(at_goal));
  last_.assign({at_start.h});
  if (at_start.kind == locate::LocatedKind::edge) last_.push_back(mesh.twin(at_start.h));
  mesh::Face start_faces[2];
  for (std::size_t i = 0; i < last_.size(); ++i) start_faces[i] = mesh::face(last_[i]);
  distances_.begin(map, ends.start(), std::span(start_faces, last_.size()));
  for (const HalfEdge h : first_) distances_.enter(mesh::face(h));
  if (is_goal_on_edge) distances_.cross(mesh::face(at_goal), at_goal);
  const locate::LocatedKind kind = is_goal_on_edge ? locate::LocatedKind::edge : locate::LocatedKind::face;
  search_.begin(map.triangulation, nullptr, {goal, kind, first_}, true);
  search_.guide(distances_);
  search_.add_goal(start, last_);
  search_.start();
}

std::span<const HalfEdge> DiscGuide::collect_exits() {
  exits_.clear();
  search_.for_each_portal(0, [&](HalfEdge entry) { exits_.push_back(entry); });
  return exits_;
}

void DiscGuide::continue_to(double length) {
  // The terms with a power of 2 allow for rounding.
  const double limit = length * (1.0 + 0x1p-32) + (2.0 + 0x1p-4) * radius_;
  search_.continue_to(limit);
  distances_.set_limit(limit);
}

}  // namespace waywright::path
