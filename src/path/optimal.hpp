#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/path.hpp"

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "nav/abstraction.hpp"
#include "nav/point_agent.hpp"
#include "path/ends.hpp"
#include "path/looked_at.hpp"
#include "path/open_list.hpp"

namespace waywright::path {

/// The shortest path of a point: A* over the windows through which a corner of the path, its *root*, sees the edges of
/// the mesh.
///
/// A window is an edge, the root, and the cone of sight between the two vertices that bound it, left and right.
/// Crossing a face, a cone goes on over one or both of the other edges, by the sides on which the face's apex lies. So
/// only orientations of mesh vertices decide where a cone goes; lengths only decide what is looked at first, and which
/// of two ways is shorter. A path turns where a cone grazes a vertex with walls, around the walls; then that vertex is
/// the root of new windows.
///
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya): the
/// search, its bound, and leaving out roots that have been reached on a shorter way. Departures: no interval's end is
/// ever computed to decide where a search goes; the windows beyond a turn are made only when no other way looks
/// shorter; windows whose bound is not above the least one are followed at once, without passing the open list; windows
/// all of whose places are reached sooner by way of an end of their edge are left out (Xin and Wang, *Improving Chen
/// and Han's algorithm on the discrete geodesic problem*, ACM TOG 2009).
class Optimal {
 public:
  using Triangulation = constraint::ExactTriangulation;
  using Geometry = exact::Geometry;

  /// Starts anew. The ends' start, the triangulation and its abstraction, if it has one, must stay as they are.
  /// `looked_at`, if it is not null, notes the faces that the search looks at.
  void begin(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Ends& ends,
             bool wants_channel, LookedAt* looked_at = nullptr);
  /// A goal that isn't at a face of the start, and the open faces around it. Without any, there is nothing to find.
  void add_goal(const Point& goal, const std::vector<mesh::HalfEdge>& faces);
  /// To be called once all goals are known. Paths that are not shorter than `known_length` are left out.
  void start(double known_length = std::numeric_limits<double>::infinity());

  /// The mesh has grown since begin().
  void cover_mesh();

  /// Searches on until `expansions` comes to `limit` or the shortest path to each goal is found; returns whether they
  /// are, or there are none.
  bool step(std::size_t limit, std::size_t& expansions);
  /// No path that is yet to be found is shorter. Requires: step() has returned false.
  [[nodiscard]] double least_bound() const { return open_.least_bound(); }

  /// Goals are numbered in the order in which they were added.
  [[nodiscard]] bool is_found(std::size_t goal) const { return goals_[goal].root != kNone; }
  /// Writes status, length and, where they are wanted, points. Requires: a path to the goal is found.
  void write_path(std::size_t goal, bool wants_points, Path& path) const;
  /// Writes the edges that the path crosses. Requires: the search was begun for it, a path is found.
  void write_channel(std::size_t goal, Path& path) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  /// In place of a cone's tangent vertex: the cone is bounded by the way on which the path came to its root.
  static constexpr mesh::Vertex kStraightOn = mesh::kNoVertex;

  /// A point where paths turn, or start.
  struct Root {
    Point point;
    mesh::Vertex vertex;  ///< kNoVertex: the start
    std::uint32_t before;
    double length;  ///< of the path up to here
  };

  enum class Kind : std::uint8_t { window, left_turn, right_turn };

  /// A window, or a turn that has not been made yet.
  struct Node {
    Kind kind;
    mesh::HalfEdge entry;  ///< the edge as a half-edge of the face beyond; of a turn, an edge with an end there
    std::uint32_t root;    ///< of a turn, the root before
    mesh::Vertex left;     ///< the cone's left bound; of a left turn, where it is
    mesh::Vertex right;    ///< the same on the right
    std::uint32_t trace;   ///< how the search came here
  };

  /// A goal and the best path to it so far.
  struct Goal {
    Point point;
    double length;
    std::uint32_t root;   ///< where the path turns last; kNone while there is none
    std::uint32_t trace;  ///< how the search came there
  };
  struct GoalFace {
    mesh::Face face;
    std::uint32_t goal;
  };

  /// The search has crossed an edge: kept only where the channel is asked for.
  struct Trace {
    mesh::HalfEdge entry;
    std::uint32_t before;
  };

  /// The shortest way to a vertex at which a path may turn, in the query that saw it last.
  struct Reached {
    double length = 0.0;
    std::uint32_t query = 0;
    mesh::HalfEdge spoke{};  ///< an edge from there in the wedge between walls that the way came to
  };

  /// How many of the goals' faces lie at a face outside the core or beyond it, as seen from the core, in the query that
  /// counted last.
  struct GoalsBelow {
    std::uint32_t query = 0;
    std::uint32_t count = 0;
  };

  /// How many of the goals' faces lie in a component.
  struct GoalsInComponent {
    nav::Components::Label component;
    std::uint32_t count;
  };

  class Cone;

  void forget_last_query();
  void list_components();
  [[nodiscard]] std::size_t place_of(nav::Components::Label component) const;
  void count_goal_face(mesh::Face f);
  [[nodiscard]] std::uint32_t goals_around(mesh::Face f) const;
  void leave_start();
  void look(mesh::Face f) {
    if (looked_at_ != nullptr) looked_at_->look(f);
  }
  void follow(Node node);
  void follow_window(Node window);
  void part(const Node& window, const Cone& cone, mesh::Vertex apex);
  void meet_goals(const Node& window, const Cone& cone);
  void note_turn(const Node& window, const Cone& cone, Kind kind, bool sees_apex);
  void make_left_turn(const Node& turn);
  void make_right_turn(const Node& turn);
  [[nodiscard]] std::uint32_t add_root(mesh::Vertex v, std::uint32_t before);
  void offer(const Node& window, const Point& left, const Point& right);
  void offer(const Node& window);
  [[nodiscard]] bool is_outdone(const Node& window, mesh::HalfEdge from_end) const {
    const Reached& way = reached_[number(mesh_->origin(from_end))];
    return way.query == stamp_.value() && way.spoke != mesh::kNoHalfEdge && is_outdone_by(way, window, from_end);
  }
  [[nodiscard]] bool is_outdone_by(const Reached& way, const Node& window, mesh::HalfEdge from_end) const;
  [[nodiscard]] bool are_in_one_wedge(mesh::HalfEdge g, mesh::HalfEdge h) const;
  /// Whether there may be a goal at the face; nearly everywhere there is none.
  [[nodiscard]] bool may_have_goals(mesh::Face f) const { return (goal_bits_ & bit_of(f)) != 0; }
  [[nodiscard]] static std::uint64_t bit_of(mesh::Face f) { return std::uint64_t{1} << number(f) % 64; }
  /// Calls visit(goal) for each goal at the face.
  template <class Visit>
  void for_each_goal(mesh::Face f, Visit&& visit) const;
  void end_at(std::uint32_t goal, std::uint32_t root, std::uint32_t trace);
  void limit_lengths();

  /// Whether no path leaves the face `f` by its side `exit`: for a wall, or because beyond it there is a dead end
  /// without the goal.
  [[nodiscard]] bool is_barred(mesh::Face f, mesh::HalfEdge exit) const {
    if (core_ == nullptr) return !nav::PointAgent::can_cross(*mesh_, exit);
    return !core_->is_way(f, exit) && (!nav::PointAgent::can_cross(*mesh_, exit) || is_dead_end(exit));
  }
  [[nodiscard]] bool is_barred(mesh::HalfEdge exit) const { return is_barred(mesh::face(exit), exit); }
  [[nodiscard]] bool is_dead_end(mesh::HalfEdge exit) const;
  [[nodiscard]] std::uint32_t goals_below(mesh::Face f) const {
    const GoalsBelow& below = goals_below_[number(f)];
    return below.query == stamp_.value() ? below.count : 0;
  }
  [[nodiscard]] bool has_walls(mesh::Vertex v) const;
  [[nodiscard]] Reached& reached(mesh::Vertex v);
  [[nodiscard]] std::uint32_t traced(mesh::HalfEdge entry, std::uint32_t before);
  [[nodiscard]] const Point& place(mesh::Vertex v) const { return geometry_->nearest(number(v)); }
  [[nodiscard]] Geometry::View view(const Root& root) const;
  [[nodiscard]] double bound(const Node& window, const Point& left, const Point& right) const;
  [[nodiscard]] double bound_from(const Point& p) const;

  const Ends* ends_ = nullptr;
  const nav::TwoCore* core_ = nullptr;  ///< or null
  const nav::Components* components_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const Geometry* geometry_ = nullptr;
  bool wants_channel_ = false;
  LookedAt* looked_at_ = nullptr;  ///< or null

  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  OpenList open_;              ///< positions in `nodes_`
  std::vector<Node> at_once_;  ///< windows to follow before the next of the open list
  std::vector<Trace> traces_;
  memory::ZeroedArray<Reached> reached_;               ///< by vertex
  memory::ZeroedArray<GoalsBelow> goals_below_;        ///< by face outside the core
  std::vector<GoalsInComponent> goals_in_components_;  ///< of the start's components, in order
  std::vector<Goal> goals_;
  std::vector<GoalFace> goal_faces_;
  std::uint64_t goal_bits_ = 0;  ///< the bit_of each of their faces
  memory::Stamp stamp_;

  std::size_t expansions_ = 0;
  double at_once_bound_ = 0.0;  ///< windows whose bound is not above are followed at once
  double known_length_ = 0.0;
  double longest_ = 0.0;           ///< paths that are not shorter are of no use to any goal
  std::size_t longest_count_ = 0;  ///< goals whose best path, or the known length, is as long as that
};

}  // namespace waywright::path
