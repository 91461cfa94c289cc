#pragma once

#include <cstdint>
#include <vector>

#include "waywright/path.hpp"

#include "memory/scratch.hpp"
#include "nav/abstraction.hpp"
#include "path/channel.hpp"
#include "path/open_list.hpp"
#include "path/point_ends.hpp"
#include "path/taut_string.hpp"

namespace waywright::path {

/// Triangulation reduction A* for a point agent: A* over the faces where the search has a choice. The search has no
/// choice while it leaves a dead end, while it enters the dead end that contains the goal, and in a corridor. It never
/// enters any other dead end. The path is the taut string through the first channel that reaches the goal.
///
/// The search is fast, and its paths are good. There are two reasons why a path is not always the shortest one. The
/// search orders the channels by an approximate length in doubles, which it updates as a channel grows. And it makes
/// its choice at each face only once.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Differences: one rule says through
/// which edges the search leaves a face, while the paper distinguishes cases by where start and goal lie. The search
/// follows a corridor face by face. This costs little, and the estimate of the length takes into account through
/// which edge the search has entered the corridor.
class TraStar {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Starts a search between two ends. Requires: the ends are connected; no face contains both ends; the ends, the
  /// triangulation and its abstraction do not change during the search.
  void begin(const Triangulation& triangulation, const nav::Abstraction& abstraction, const PointEnds& ends);
  /// Finds the path.
  void find(Path& path);
  /// Writes to Path::channel the edges that the path crosses. Requires: find() has found the path.
  void write_channel(Path& path) const;

 private:
  // Marks of a face in this query. *Up* means along TwoCore::towards_core(): towards the core or, in a component
  // without a core, towards its root. At a face of the core, the passages to other faces of the core lead up. *Down* is
  // the opposite direction.
  static constexpr std::uint32_t kGoal = 1;
  static constexpr std::uint32_t kAboveGoal = 2;  ///< a goal face, or a face on the way up from one
  /// A face with the mark kAboveGoal from which a passage up leads to a goal face, too.
  static constexpr std::uint32_t kGoalOutside = 4;
  static constexpr std::uint32_t kChosen = 8;  ///< the search has made its choice here
  static constexpr std::uint32_t kMarks = 16;

  void clear_marks();
  [[nodiscard]] std::uint32_t marks_of(mesh::Face f) const {
    return marks_[number(f)] >= stamp_.value() ? marks_[number(f)] - stamp_.value() : 0;
  }
  void mark(mesh::Face f, std::uint32_t mark);
  [[nodiscard]] bool is_connected_to_goal(mesh::Face f) const;
  void mark_faces_above_goal();
  void climb_from_goal(mesh::Face goal);
  void mark_faces_with_goal_outside();
  /// Returns the passages through which a path to the goal can leave the face, as one bit for each of its half-edges.
  [[nodiscard]] unsigned passages_to_goal(mesh::Face f, std::uint32_t marks) const {
    return (marks & kAboveGoal) == 0 ? core_->passages_towards_core(f) : passages_above_goal(f, marks);
  }
  [[nodiscard]] unsigned passages_above_goal(mesh::Face f, std::uint32_t marks) const;
  [[nodiscard]] unsigned passages_down(mesh::Face f) const;
  void leave_start_face(mesh::HalfEdge h);
  void leave(const ChannelNode& node, std::uint32_t index);
  void follow(mesh::HalfEdge exit, std::uint32_t before, Sight sight);
  void open(mesh::HalfEdge exit, mesh::HalfEdge entry, std::uint32_t before, const Sight& sight);
  void collect_channel(std::uint32_t goal_node);
  void write_path(Path& path);
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_->rounded(number(v)); }

  const PointEnds* ends_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const exact::Geometry* geometry_ = nullptr;
  const nav::TwoCore* core_ = nullptr;
  const nav::Components* components_ = nullptr;

  std::vector<ChannelNode> nodes_;
  OpenList open_;                             ///< indices in `nodes_`
  memory::ZeroedArray<std::uint32_t> marks_;  ///< by face: the stamp plus the marks, if this search wrote them
  memory::Stamp stamp_;                       ///< its value is a multiple of kMarks
  /// The last faces on the ways up from the goal faces. mark_faces_with_goal_outside() then visits the faces below
  /// them, and uses the list as a stack.
  std::vector<mesh::Face> tops_;
  std::vector<std::uint32_t> chosen_;  ///< the nodes of the path, from the start to the goal
  std::vector<mesh::HalfEdge> exits_;  ///< the edges that the channel crosses, in the faces that it leaves
  TautString string_;
};

}  // namespace waywright::path
