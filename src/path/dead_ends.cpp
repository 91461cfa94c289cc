#include "path/dead_ends.hpp"

namespace waywright::path {

void DeadEnds::begin(const mesh::TriangleMesh& mesh, const nav::TwoCore* core, std::span<const mesh::Face> goals) {
  mesh_ = &mesh;
  core_ = core;
  goal_count_ = goals.size();
  has_core_ = false;
  bits_above_goals_ = 0;
  if (core == nullptr) return;
  stamp_.next(1, goals_below_);
  goals_below_.grow_to(mesh.face_slots());
  for_each_above_goal(goals, [&](mesh::Face f) {
    GoalsBelow& below = goals_below_[number(f)];
    if (below.query != stamp_.value()) below = {stamp_.value(), 0};
    ++below.count;
    bits_above_goals_ |= bit_of(f);
    has_core_ = has_core_ || core->is_core(f);
  });
}

unsigned DeadEnds::find_edges_towards_goal(mesh::Face f) const {
  unsigned passages = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const mesh::HalfEdge exit = mesh::half_edge(f, i);
    if (may_lead_to_goal(f, exit)) passages |= 1U << i;
  }
  return passages;
}

}  // namespace waywright::path
