#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "waywright/path.hpp"

#include "memory/scratch.hpp"
#include "nav/abstraction.hpp"
#include "nav/point_agent.hpp"
#include "path/guide_distances.hpp"
#include "path/looked_at.hpp"
#include "path/open_list.hpp"
#include "path/point_ends.hpp"

namespace waywright::path {

/// Finds the shortest path of a point agent by A* over windows. A window is the piece of an edge of the mesh that is
/// visible from its *root*. The root is a turn of the path, or its start.
///
/// A window consists of the edge, the root, and the two vertices that bound the cone of sight on the left and on the
/// right. When a cone has entered a face across an edge, it leaves the face across one or both of the other edges. The
/// face's apex is the vertex that is not on the edge of entry. If the apex lies inside the cone, the cone leaves across
/// each of the two edges that an agent can cross. If the apex lies left or right of the cone, the cone leaves across
/// one edge, if an agent can cross it. So only orientations of mesh vertices decide where a cone continues. Lengths
/// decide only which window or turn the search expands first, and which of two paths is shorter. Where a cone touches a
/// vertex with walls, a path can turn around these walls. The vertex is then the root of new windows.
///
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya): the
/// search, its bound, and the rule that drops a root if a shorter path to its vertex is known. Differences:
/// - To decide where a window continues, the search never computes the positions of the window's ends.
/// - It makes the windows beyond a turn only when no other node in the open list has a smaller bound.
/// - If the bound of a new window is not above the least bound of the open list, the search follows this window at
///   once, without the open list.
/// - It drops a window if a known path through an end of its edge reaches all positions of the window sooner (Xin and
///   Wang, *Improving Chen and Han's algorithm on the discrete geodesic problem*, ACM TOG 2009).
/// - Windows that lie beside each other on one edge, and whose roots follow each other on one path and form a convex
///   chain, move as one *bundle*.
class Optimal {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;
  using Geometry = exact::Geometry;

  /// Where a search starts: a point, where it lies on the mesh, and a half-edge of each open face around it. If the
  /// point lies on an edge or at a vertex, each of these half-edges is this edge, or starts at this vertex.
  struct Start {
    Point point;
    locate::LocatedKind kind;
    std::span<const mesh::HalfEdge> faces;
  };

  /// Starts a new search. If `looked_at` is not null, the search records in it the faces at which it looks. Then the
  /// triangulation and the abstraction may change during the search, if no change touches one of these faces
  /// (Finder::begin() says what touches a face), and if the caller calls grow_to_mesh() before the next step().
  /// Requires: without `looked_at`, the triangulation and the abstraction (if there is one) do not change during the
  /// search; `start.faces` does not change before start().
  void begin(const Triangulation& triangulation, const nav::Abstraction* abstraction, const Start& start,
             bool wants_channel, LookedAt* looked_at = nullptr);
  /// Call this after begin(): the search becomes a guide. It crosses only edges for which distances.can_cross() is
  /// true, and it records in `distances` what it sees. A guide has one goal. When step() has found the shortest path,
  /// it returns true, but continue_to() can continue the search.
  void guide(GuideDistances& distances) { distances_ = &distances; }
  /// Makes the next calls of step() follow all windows of a guide whose bound is below `limit`.
  void continue_to(double limit) { longest_ = stop_bound_ = limit; }
  /// Call this after begin(): the search then appends each window that it follows to `windows`: one or more for each
  /// triangle that it enters. Requires: begin() was called with `looked_at`.
  void record_windows(std::vector<SearchWindow>& windows) { windows_ = &windows; }
  /// Adds a goal and the open faces around it. A search without goals finds nothing. Requires: no face contains
  /// both the start and the goal. (A face also contains the positions on its border.)
  void add_goal(const Point& goal, const std::vector<mesh::HalfEdge>& faces);
  /// Call this after the last add_goal(). The search leaves out paths that are not shorter than `known_length`.
  void start(double known_length = std::numeric_limits<double>::infinity());

  /// Makes room for faces and vertices that were added to the mesh after begin().
  void grow_to_mesh();

  /// Continues the search until `expansions` reaches `limit`, or until the search is finished: it has then found the
  /// shortest path to each goal that is connected with the start. Returns whether the search is finished.
  bool step(std::size_t limit, std::size_t& expansions);
  /// A lower bound of the length of each path that the search has not found yet. Requires: step() has returned false.
  [[nodiscard]] double least_bound() const { return open_.least_bound(); }

  /// Returns whether the search has found a path to the goal. Goals are numbered in the order in which they were added.
  [[nodiscard]] bool is_found(std::size_t goal) const { return goals_[goal].root != kNone; }
  /// The length of the path to the goal. Requires: is_found(goal).
  [[nodiscard]] double length(std::size_t goal) const { return goals_[goal].length; }
  /// Writes the status, the length and, if `wants_points` is true, the points. Requires: is_found(goal).
  void write_path(std::size_t goal, bool wants_points, Path& path) const;
  /// Writes to Path::channel the edges that the path to the goal crosses. Requires: begin() was called with
  /// `wants_channel`, and is_found(goal).
  void write_channel(std::size_t goal, Path& path) const;
  /// Calls visit(h) for each edge that the path to the goal crosses, from the goal back to the start. `h` is a
  /// half-edge of the face that the path enters. Requires: as write_channel().
  template <class Visit>
  void for_each_portal(std::size_t goal, Visit&& visit) const {
    for (std::uint32_t at = goals_[goal].trace; at != kNone; at = traces_[at].before) visit(traces_[at].entry);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  /// The value of Node::left or Node::right if no vertex bounds the cone there. The straight continuation of the path's
  /// last segment, beyond the root, then bounds the cone.
  static constexpr mesh::Vertex kContinuation = mesh::kNoVertex;

  /// A turn of paths, or their start.
  struct Root {
    Point point;
    mesh::Vertex vertex;  ///< kNoVertex for the start
    std::uint32_t before;
    double length;        ///< of the path from the start to this root
    std::uint32_t depth;  ///< number of roots before this one on the path
    /// An earlier root of the path, as in a skip list: a few jumps lead from a root to any earlier root. The jump of
    /// the start is the start itself.
    std::uint32_t jump;
  };

  enum class Kind : std::uint8_t { window, left_turn, right_turn };

  /// A window, a bundle of windows, or a turn whose windows have not been made yet.
  ///
  /// A bundle consists of the windows of two or more roots on one edge. Its roots follow each other on one path. The
  /// first root may be the start or any turn. The others are all left turns or all right turns. So each of these
  /// windows ends where the next one begins: on the continuation of the path beyond the later root. If they are right
  /// turns, the first root has the leftmost window, and the last root has the rightmost one.
  struct Node {
    Kind kind;
    bool has_window;           ///< of a turn: whether a window waits in this node until the search makes the turn
    mesh::HalfEdge entry;      ///< of a window: its edge, in the face beyond it; of a turn: an edge at the turn
    std::uint32_t left_root;   ///< the root of the leftmost window; of a left turn: the root before it
    std::uint32_t right_root;  ///< the root of the rightmost window; of a right turn: the root before it
    mesh::Vertex left;         ///< the vertex that bounds the cone on the left; of a left turn, where the path turns
    mesh::Vertex right;        ///< the vertex that bounds the cone on the right; of a right turn, where the path turns
    std::uint32_t trace;       ///< index in `traces_` of the last edge that the search has crossed, or kNone

    [[nodiscard]] bool is_bundle() const { return left_root != right_root; }
    /// A root has a smaller index than the roots after it.
    [[nodiscard]] std::uint32_t first_root() const { return std::min(left_root, right_root); }
    [[nodiscard]] std::uint32_t last_root() const { return std::max(left_root, right_root); }
  };

  /// A goal and the best path to it so far.
  struct Goal {
    Point point;
    double length;
    std::uint32_t root;   ///< where the path turns last; kNone as long as there is no path
    std::uint32_t trace;  ///< index in `traces_` of the last edge that the path crosses, or kNone
  };
  struct GoalFace {
    mesh::Face face;
    std::uint32_t goal;
  };

  /// An edge that the search has crossed. Recorded only if the query wants the channel.
  struct Trace {
    mesh::HalfEdge entry;
    std::uint32_t before;
  };

  /// The shortest path found to a vertex at which a path may turn. Valid only in query number `query`.
  struct Reached {
    double length = 0.0;
    std::uint32_t query = 0;
    mesh::HalfEdge spoke{};  ///< an edge at the vertex, in the wedge between walls through which the path arrives
  };

  /// For a face in a dead end: how many goal faces lie in its subtree, including the face itself. Valid only in query
  /// number `query`.
  struct GoalsBelow {
    std::uint32_t query = 0;
    std::uint32_t count = 0;
  };

  /// How many goal faces lie in a component.
  struct GoalsInComponent {
    nav::Components::Id component;
    std::uint32_t count;
  };

  class Cone;

  void clear_last_query();
  void list_components();
  [[nodiscard]] std::size_t index_of(nav::Components::Id component) const;
  void count_goal_face(mesh::Face f);
  [[nodiscard]] std::uint32_t goals_in_component_of(mesh::Face f) const;
  void leave_start();
  void look(mesh::Face f) {
    if (looked_at_ != nullptr) looked_at_->look(f);
  }
  /// Records, if the caller wants it, that the search has entered the face with this window. A guide marks the edges
  /// that it crosses instead.
  void enter(mesh::Face f, const Node& window) {
    if (looked_at_ != nullptr) record(f, window);
  }
  /// Tells the distances of a guide that the root sees the vertex.
  void see(mesh::Vertex v, std::uint32_t root) const {
    if (distances_ != nullptr)
      distances_->see(v, roots_[root].length, squared_length(position_of(v) - roots_[root].point));
  }
  void record(mesh::Face f, const Node& window);
  void follow(Node node);
  void follow_window(const Node& window) {
    return distances_ == nullptr ? follow_window_as<false>(window) : follow_window_as<true>(window);
  }
  template <bool kIsGuide>
  void follow_window_as(Node window);
  void narrow_left(Node& window, Cone& cone, mesh::Vertex apex, std::uint32_t root) const;
  void narrow_right(Node& window, Cone& cone, mesh::Vertex apex, std::uint32_t root) const;
  void divide(const Node& window, const Cone& cone, mesh::Vertex apex);
  void reach_goals(const Node& window, const Cone& cone);
  bool note_turn(const Node& window, const Cone& cone, Kind kind, bool turn_sees_apex);
  [[nodiscard]] bool can_wait(const Node& window, const Cone& cone, Kind kind, double least) const;
  void push_waiting(const Node& turn);
  template <Kind kTurn>
  void make_turn(const Node& turn);
  [[nodiscard]] std::uint32_t add_root(mesh::Vertex v, std::uint32_t before);
  void push(const Node& window, const Point& left, const Point& right);
  void push(const Node& window);
  template <class IsBeyond>
  [[nodiscard]] std::uint32_t find_root(const Node& window, IsBeyond&& is_beyond) const;
  [[nodiscard]] std::uint32_t root_that_sees(const Node& window, const Geometry::View& p) const;
  [[nodiscard]] bool is_dominated(const Node& window, mesh::HalfEdge from_end) const {
    const Reached& known = reached_[number(mesh_->origin(from_end))];
    return known.query == stamp_.value() && known.spoke != mesh::kNoHalfEdge &&
           is_dominated_by(known, window, from_end);
  }
  [[nodiscard]] bool is_dominated_by(const Reached& known, const Node& window, mesh::HalfEdge from_end) const;
  [[nodiscard]] bool are_in_one_wedge(mesh::HalfEdge g, mesh::HalfEdge h) const;
  /// Returns whether there may be a goal at the face. For most faces the answer is false.
  [[nodiscard]] bool may_have_goals(mesh::Face f) const { return (goal_bits_ & bit_of(f)) != 0; }
  [[nodiscard]] static std::uint64_t bit_of(mesh::Face f) { return std::uint64_t{1} << number(f) % 64; }
  /// Calls visit(goal) for each goal at the face.
  template <class Visit>
  void for_each_goal(mesh::Face f, Visit&& visit) const;
  void store_path(std::uint32_t goal, std::uint32_t root, std::uint32_t trace);
  void update_longest();

  /// Returns whether no path leaves the face `f` through its half-edge `exit`: the agent cannot cross it, or it
  /// leads to no goal face. A guide has no core, so it asks its distances.
  template <bool kIsGuide>
  [[nodiscard]] bool is_excluded(mesh::Face f, mesh::HalfEdge exit) const {
    if constexpr (kIsGuide) return !distances_->can_cross(exit);
    if (core_ == nullptr) return !nav::PointAgent::can_cross(*mesh_, exit);
    return !core_->is_core_passage(f, exit) && (!nav::PointAgent::can_cross(*mesh_, exit) || leads_to_no_goal(exit));
  }
  [[nodiscard]] bool is_excluded(mesh::HalfEdge exit) const {
    return distances_ == nullptr ? is_excluded<false>(mesh::face(exit), exit) : !can_guide_cross(exit);
  }
  /// Returns whether the agent can cross an edge.
  [[nodiscard]] bool can_cross(mesh::HalfEdge h) const {
    return distances_ == nullptr ? nav::PointAgent::can_cross(*mesh_, h) : can_guide_cross(h);
  }
  [[nodiscard]] bool can_guide_cross(mesh::HalfEdge h) const;
  [[nodiscard]] bool leads_to_no_goal(mesh::HalfEdge exit) const;
  [[nodiscard]] std::uint32_t goals_below(mesh::Face f) const {
    const GoalsBelow& below = goals_below_[number(f)];
    return below.query == stamp_.value() ? below.count : 0;
  }
  [[nodiscard]] bool has_walls(mesh::Vertex v) const;
  [[nodiscard]] Reached& reached(mesh::Vertex v);
  /// Records, if the query wants the channel, that a window whose last trace is `before` crosses the edge `entry`.
  /// Returns the value for Node::trace.
  [[nodiscard]] std::uint32_t traced(mesh::HalfEdge entry, std::uint32_t before) {
    if (!wants_channel_) return kNone;
    const std::size_t index = trace_count_++;
    if (index == traces_.size()) [[unlikely]]
      grow_traces();
    traces_[index] = {entry, before};
    return static_cast<std::uint32_t>(index);
  }
  void grow_traces();
  [[nodiscard]] const Point& position_of(mesh::Vertex v) const { return geometry_->rounded(number(v)); }
  [[nodiscard]] Geometry::View view(const Root& root) const;
  [[nodiscard]] double bound(const Node& window, const Point& left, const Point& right) const;
  [[nodiscard]] double bound_of_bundle(const Node& window, const Point& left, const Point& right) const;
  void record_window(const Node& window);
  [[nodiscard]] double bound_from(const Point& p) const;

  Start start_{};
  const nav::TwoCore* core_ = nullptr;  ///< null without an abstraction
  const nav::Components* components_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const Geometry* geometry_ = nullptr;
  bool wants_channel_ = false;
  GuideDistances* distances_ = nullptr;           ///< of a guide; otherwise null
  LookedAt* looked_at_ = nullptr;                 ///< or null
  std::vector<SearchWindow>* windows_ = nullptr;  ///< or null; null if `looked_at_` is null

  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  OpenList open_;              ///< indices in `nodes_`
  std::vector<Node> at_once_;  ///< windows to follow before the next node of the open list
  std::vector<Trace> traces_;  ///< the first `trace_count_` are in use
  std::size_t trace_count_ = 0;
  memory::ZeroedArray<Reached> reached_;               ///< by vertex
  memory::ZeroedArray<GoalsBelow> goals_below_;        ///< by face outside the core
  std::vector<GoalsInComponent> goals_in_components_;  ///< one entry for each component of a start face, ascending
  std::vector<Goal> goals_;
  std::vector<GoalFace> goal_faces_;
  std::uint64_t goal_bits_ = 0;  ///< the union of bit_of() for all goal faces
  memory::Stamp stamp_;

  std::size_t expansions_ = 0;
  double at_once_bound_ = 0.0;  ///< the search follows windows at once if their bound is not above this
  double known_length_ = 0.0;
  double longest_ = 0.0;  ///< the search needs only paths that are shorter than this
  double stop_bound_ =
      0.0;  ///< the search ends when no bound is below this: `longest_`, or the length of a guide's path
  std::size_t longest_count_ = 0;  ///< number of goals with min(Goal::length, known_length_) equal to `longest_`
};

}  // namespace waywright::path
