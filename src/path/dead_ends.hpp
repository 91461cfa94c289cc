#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "memory/scratch.hpp"
#include "mesh/triangle_mesh.hpp"
#include "nav/point_agent.hpp"
#include "nav/two_core.hpp"

namespace waywright::path {

/// Says for one search which edges lead to no goal. The *tree faces* are the faces outside the two-core (TwoCore). The
/// subtree of a face consists of this face and of the tree faces whose passages towards the core lead through it. So
/// the subtree of a face of the core contains this face and the dead ends at its edges.
class DeadEnds {
 public:
  /// Starts a search with goal faces. `core` may be null: then the class knows no tree faces. Cost: the length of the
  /// chains from the goal faces to the core.
  void begin(const mesh::TriangleMesh& mesh, const nav::TwoCore* core, std::span<const mesh::Face> goals);
  /// Returns whether a path from the face `f` across its edge `exit` may lead to a goal. The result is false only if
  /// the edge is a wall, or no goal lies beyond it. Without a core, the function recognises only walls. With a core,
  /// the result is true for each passage between two faces of the core, and for each passage that leads towards the
  /// core. (If a foot bridge crosses such a passage, a disc may have to leave a dead end, go around an obstacle and
  /// return to the dead end across the same passage.)
  [[nodiscard]] bool may_lead_to_goal(mesh::Face f, mesh::HalfEdge exit) const {
    if (core_ == nullptr) return nav::PointAgent::can_cross(*mesh_, exit);
    return core_->is_core_passage(f, exit) || (nav::PointAgent::can_cross(*mesh_, exit) && !leads_to_no_goal(exit));
  }
  /// Returns the edges of a face for which may_lead_to_goal() is true. The result has one bit for each half-edge of the
  /// face.
  [[nodiscard]] unsigned edges_towards_goal(mesh::Face f) const {
    if (core_ != nullptr && goals_below_[number(f)].query == stamp_.value()) return find_edges_towards_goal(f);
    return edges_towards_core(f);
  }
  /// Returns edges_towards_goal(f). Requires: the face is none of those that for_each_above_goal() visits.
  [[nodiscard]] unsigned edges_towards_core(mesh::Face f) const {
    return core_ == nullptr ? find_edges_towards_goal(f) : core_->passages_towards_core(f);
  }
  /// Calls visit(face) for each goal face. If begin() was called with a core, also calls it for each face on the way
  /// from a goal face towards the core: up to the first face of the core or, in a component without a core, up to the
  /// root. May visit a face more than once.
  template <class Visit>
  void for_each_above_goal(std::span<const mesh::Face> goals, Visit&& visit) const {
    for (mesh::Face f : goals) {
      for (;;) {
        visit(f);
        if (core_ == nullptr || core_->is_core(f)) break;
        const mesh::HalfEdge up = core_->towards_core(f);
        if (up == mesh::kNoHalfEdge) break;
        f = mesh::face(mesh_->twin(up));
      }
    }
  }

 private:
  /// Returns whether no goal lies beyond the edge. Requires: begin() was called with a core, the edge is no wall, and
  /// it does not lead from one face of the core to another.
  [[nodiscard]] bool leads_to_no_goal(mesh::HalfEdge exit) const {
    if (core_->leads_up(exit)) return !has_core_ && goals_below(mesh::face(exit)) == goal_count_;
    return goals_below(mesh::face(mesh_->twin(exit))) == 0;
  }
  [[nodiscard]] unsigned find_edges_towards_goal(mesh::Face f) const;

  /// How many goal faces lie in the subtree of a face.
  struct GoalsBelow {
    std::uint32_t query;
    std::uint32_t count;
  };

  [[nodiscard]] static std::uint64_t bit_of(mesh::Face f) { return std::uint64_t{1} << number(f) % 64; }
  [[nodiscard]] std::uint32_t goals_below(mesh::Face f) const {
    if ((bits_above_goals_ & bit_of(f)) == 0) return 0;
    const GoalsBelow& below = goals_below_[number(f)];
    return below.query == stamp_.value() ? below.count : 0;
  }

  const mesh::TriangleMesh* mesh_ = nullptr;
  const nav::TwoCore* core_ = nullptr;
  std::size_t goal_count_ = 0;
  bool has_core_ = false;                        ///< whether the component of the goals has a core
  std::uint64_t bits_above_goals_ = 0;           ///< the union of bit_of() for all faces with goals in their subtrees
  memory::ZeroedArray<GoalsBelow> goals_below_;  ///< by face
  memory::Stamp stamp_;
};

}  // namespace waywright::path
