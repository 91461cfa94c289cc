#pragma once

#include <cstdint>
#include <vector>

#include "waywright/path.hpp"

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "nav/abstraction.hpp"
#include "path/ends.hpp"
#include "path/open_list.hpp"
#include "path/sight.hpp"
#include "path/taut_string.hpp"

namespace waywright::path {

/// Triangulation reduction A* for a point: A* over the faces where a choice is to be made. Whoever comes out of a dead
/// end, or into one because the goal is there, has no choice, nor has whoever follows a corridor; all dead ends but
/// those of start and goal are passed by. The first channel that gets to the goal gives the path: its taut string.
///
/// Good paths for very little: what the search goes by is a channel's length in doubles, kept as it grows, and each
/// face is chosen from once.
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Departures: one rule for what leads
/// on from a face, where they distinguish where start and goal lie; corridors are followed face by face, which costs
/// little and tells their length exactly for the way on which they were entered.
class TraStar {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Starts a search between ends that are not at one face, but in one component. They, the triangulation and its
  /// abstraction must stay as they are.
  void begin(const Triangulation& triangulation, const nav::Abstraction& abstraction, const Ends& ends);
  /// Finds the path.
  void find(Path& path);
  /// Writes the edges that the path crosses. Requires: it has been found.
  void write_channel(Path& path) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A way that the search has followed to a face where it has a choice, or to the goal.
  struct Node {
    mesh::HalfEdge exit;   ///< by which it left the face of the node before
    mesh::HalfEdge entry;  ///< by which it came into its own face
    std::uint32_t before;  ///< kNone: from a start face
    Sight sight;
  };

  // What is known of a face in this query.
  static constexpr std::uint32_t kGoal = 1;
  static constexpr std::uint32_t kAboveGoal = 2;      ///< the goal itself or, from it, on the way towards the core
  static constexpr std::uint32_t kGoalElsewhere = 4;  ///< above the goal, but not above all its faces in the component
  static constexpr std::uint32_t kChosen = 8;         ///< a choice has been made here
  static constexpr std::uint32_t kMarks = 16;

  void forget_marks();
  [[nodiscard]] std::uint32_t marks_of(mesh::Face f) const {
    return marks_[number(f)] >= stamp_.value() ? marks_[number(f)] - stamp_.value() : 0;
  }
  void mark(mesh::Face f, std::uint32_t mark);
  [[nodiscard]] bool is_joined_to_goal(mesh::Face f) const;
  void mark_ways_to_goal();
  void climb_from_goal(mesh::Face goal);
  void mark_ways_between_goals();
  /// The sides of a face, a bit for each, by which a way to the goal can leave it.
  [[nodiscard]] unsigned ways_on(mesh::Face f, std::uint32_t marks) const {
    return (marks & kAboveGoal) == 0 ? ways_up(f) : ways_above_goal(f, marks);
  }
  /// In a dead end the way up; in the core all that stay in the core.
  [[nodiscard]] unsigned ways_up(mesh::Face f) const {
    if (core_->is_core(f)) return core_->ways(f);
    const mesh::HalfEdge up = core_->towards_core(f);
    return up == mesh::kNoHalfEdge ? 0 : 1U << (number(up) - 3 * number(f));
  }
  [[nodiscard]] unsigned ways_above_goal(mesh::Face f, std::uint32_t marks) const;
  [[nodiscard]] unsigned ways_down(mesh::Face f) const;
  void leave_start_face(mesh::HalfEdge h);
  void leave(const Node& node, std::uint32_t position);
  void follow(mesh::HalfEdge exit, std::uint32_t before, Sight sight);
  void open(mesh::HalfEdge exit, mesh::HalfEdge entry, std::uint32_t before, const Sight& sight);
  void collect_channel(std::uint32_t goal_node);
  void write_path(Path& path);
  [[nodiscard]] const Point& place(mesh::Vertex v) const { return geometry_->nearest(number(v)); }

  const Ends* ends_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const exact::Geometry* geometry_ = nullptr;
  const nav::TwoCore* core_ = nullptr;
  const nav::Components* components_ = nullptr;

  std::vector<Node> nodes_;
  OpenList open_;                             ///< positions in `nodes_`
  memory::ZeroedArray<std::uint32_t> marks_;  ///< by face: the stamp and marks, if this search wrote them
  memory::Stamp stamp_;                       ///< its value is a multiple of kMarks
  std::vector<mesh::Face> tops_;              ///< faces of the core, and roots, above the goal; then faces below them
  std::vector<std::uint32_t> chosen_;         ///< the nodes of the path, from the goal back
  std::vector<mesh::HalfEdge> exits_;         ///< the edges that the channel crosses, in the faces before them
  TautString string_;
};

}  // namespace waywright::path
