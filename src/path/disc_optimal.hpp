#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "memory/scratch.hpp"
#include "path/disc_ends.hpp"
#include "path/disc_line.hpp"
#include "path/disc_map.hpp"
#include "path/disc_turn.hpp"
#include "path/guide_distances.hpp"
#include "path/open_list.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// Finds the shortest path of a disc by A*. The path is a sequence of straight lines and of arcs around wall vertices;
/// each line touches the arcs at its ends. A *pivot* is the circle around a wall vertex, with the radius of the
/// disc, together with the direction in which the path turns around it: left or right. A *root* is the start, or a
/// pivot together with a path to it. A line leaves its root. A *turn node* is a line from a root to a pivot, or to the
/// goal. A *window* is an edge of the mesh together with two rays from the vertex of a root.
///
/// With windows, the search finds the vertices that are visible from the vertex of a root. Windows move from face to
/// face, as in Optimal. If a disc can move along a straight line from one pivot to another, then the two vertices see
/// each other. Before a path uses a line, DiscLine tests it. If the line has an obstacle (DiscLine::Obstacle), the
/// search adds a turn node for this vertex. From this vertex, the search then tries a line to the end of the old line.
/// It does the same with the vertex that limits the turn before the line, if the path cannot turn far enough for it.
///
/// The search decides exactly whether a disc passes a gap: a line that has passed its test crosses no gap that is too
/// narrow. (A window crosses no narrow bridge that is an edge of the mesh, but it may cross narrow foot bridges.) All
/// other numbers are doubles. ARCHITECTURE.md ("Discs") gives the reasons for the rules of the search.
///
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya, which
/// finds paths of points on convex meshes).
class DiscOptimal {
 public:
  /// Starts a search for a path that is not longer than `limit`. `distances` are the distances of a guide for this map,
  /// these ends and this limit, or null. Requires: `ends` belongs to `map`. None of them changes during the search.
  void begin(const DiscMap& map, const DiscEnds& ends, double limit, const GuideDistances* distances);
  /// Continues until `expansions` reaches `limit` or the search has ended. Returns whether it has ended.
  bool step(std::size_t limit, std::size_t& expansions);
  /// Returns a lower bound of the length of each path that the search can still find. These paths are not longer than
  /// the `limit` of begin(). Requires: step() has returned false.
  [[nodiscard]] double least_bound() const { return open_.least_bound(); }
  [[nodiscard]] bool is_found() const { return is_found_; }
  [[nodiscard]] double length() const { return length_; }
  /// Writes the pieces of the path. Requires: is_found().
  void write_path(std::vector<DiscPiece>& pieces);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // A member that names a root, a turn node or a record contains its index in `roots_`, `turn_nodes_`, `noted_` or
  // `failed_`, or kNone if there is none.

  /// A pivot, and a path to it. DiscLine has accepted the last line of this path. If several paths lead to a pivot,
  /// the pivot has several roots. `roots_[0]` is the start, not a pivot.
  struct Root {
    DiscLine::End end;             ///< the pivot, or the start
    mesh::HalfEdge corner;         ///< the corner of a face at the vertex of the pivot, in the direction of `position`
    Point direction;               ///< the direction in which the path arrives at the pivot; at the start: not used
    double length = 0.0;           ///< the length of the path from the start to `position`
    std::uint32_t before = kNone;  ///< the root before this one on the path
    TurnLimit turn_limit{};        ///< how far the path can turn around the vertex
    std::uint32_t older = kNone;   ///< the root that the search has made before for the same pivot, or kNone
    Point position{};              ///< the position of the disc's centre when the path arrives at the pivot
    double distance = 0.0;         ///< the distance from `position` to the goal
  };

  /// One of the two rays that bound a window. It starts at the vertex of the window's root, or at the start of the
  /// path.
  struct Ray {
    Point direction;
    mesh::Vertex anchor = mesh::kNoVertex;  ///< the last vertex on the ray that the search has found, or kNoVertex
    /// Whether note_turn() has returned true for an earlier vertex on this ray, with the direction of turn of the
    /// window's root. A path that turns at the earlier vertex continues along the ray and reaches the anchor. So the
    /// search needs no turn node for the anchor.
    bool has_turn = false;
  };
  struct Window {
    mesh::HalfEdge entry;  ///< the edge of the window, as a half-edge of the face beyond this edge
    std::uint32_t root;    ///< the root from whose vertex the window is visible
    Ray right;
    Ray left;
  };
  /// The positions of the two ends of a window's edge, on the left and on the right of the window.
  struct Edge {
    Point left;
    Point right;
  };
  /// A line from a root to a pivot, or to the goal. When the search takes the turn node from the open list, DiscLine
  /// tests the line.
  struct TurnNode {
    mesh::HalfEdge corner;  ///< starts at the vertex of the pivot; at the goal: DiscEnds::goal_face()
    std::uint32_t root;     ///< the root at which the line starts
    mesh::Vertex vertex;    ///< the vertex of the pivot; kNoVertex at the goal
    int turn;               ///< the direction in which the path turns around the vertex; kNoTurn at the goal
    Tangent line;
    double length;  ///< the length of the path from the start to the end of the line
    /// An earlier turn node, if this pivot is an obstacle of the earlier line, or limits the turn before that line.
    /// After the turn around this pivot, the search tries a line to the end of the earlier line.
    std::uint32_t earlier;
  };

  /// A record of a turn node that push_turn() has handled, so that the search does not add this turn node again. The
  /// records of one pivot form a linked list, which starts at Reached::noted.
  struct Noted {
    std::uint32_t root;     ///< TurnNode::root
    std::uint32_t earlier;  ///< TurnNode::earlier
    std::uint32_t older;    ///< the record of this list that the search has made before, or kNone
  };

  /// A record of a line that failed its test, with the obstacles that the test found. The records of one pivot form a
  /// linked list, which starts at Reached::failed.
  struct Failed {
    std::uint32_t root;   ///< the root at which the line starts
    std::uint32_t older;  ///< the record of this list that the search has made before, or kNone
    DiscLine::Obstacle left;
    DiscLine::Obstacle right;
  };

  /// What the search knows about a pivot.
  struct Reached {
    std::uint32_t query;   ///< the number of the query that wrote this entry
    std::uint32_t root;    ///< the last root of this pivot
    std::uint32_t noted;   ///< the last record of a turn node that ends at this pivot
    std::uint32_t failed;  ///< the last record of a line to this pivot that failed its test
  };

  /// Returns the entry of a pivot. Clears it if an earlier query wrote it.
  [[nodiscard]] Reached& reached_at(mesh::Vertex v, int turn);
  /// Returns a number that is positive if the position lies left of a ray of a window of this root, negative if it lies
  /// right of the ray, and 0 if it lies on the ray.
  [[nodiscard]] static double orientation(const Root& root, const Ray& ray, const Point& position) {
    return cross(ray.direction, position - root.end.pivot.centre);
  }
  /// The ends of the edge of `exit`, for a window that leaves the face of `exit` across this edge.
  [[nodiscard]] Edge edge_of(mesh::HalfEdge exit) const {
    return {map_->position(map_->mesh().target(exit)), map_->position(map_->mesh().origin(exit))};
  }
  [[nodiscard]] bool turns_back(const Root& root, const Point& direction) const;
  [[nodiscard]] DiscLine::End end_at(mesh::Vertex v, int turn) const { return {{map_->position(v), turn}, v}; }

  /// Returns whether the search follows no window of the pivot `from` across the edge `exit`, whose ends are `edge`.
  /// There are four reasons: the edge is a wall; beyond the edge lies only a dead end without the goal; the guide
  /// could have crossed the edge and has not; the edge is too short for the disc (is_too_short()).
  [[nodiscard]] bool is_excluded(const Pivot& from, mesh::HalfEdge exit, const Edge& edge) const {
    if (distances_ != nullptr && !distances_->is_crossed(exit) && !distances_->is_unknown(exit)) return true;
    if (!ends_->dead_ends().may_lead_to_goal(mesh::face(exit), exit)) return true;
    const double squared = squared_length(edge.left - edge.right);
    return squared <= map_->surely_long && is_too_short(from, exit, edge, squared);
  }
  [[nodiscard]] bool is_too_short(const Pivot& from, mesh::HalfEdge exit, const Edge& edge, double squared) const;
  [[nodiscard]] bool is_window_excluded(const Root& root, const Point& left, const Point& right, mesh::HalfEdge exit,
                                        const Edge& edge) const;
  /// Decides the second reason of is_window_excluded(), for one ray of the window.
  [[nodiscard]] bool is_far_on_other_side(const Root& root, const Point& ray, const Edge& edge) const;
  std::uint32_t add_root(const Root& root);
  /// Makes the windows of the start, on the edges of the faces that contain it.
  void leave_start(const locate::Located& location);
  /// Moves a window from face to face, until the search divides the window, drops it or computes its bound again.
  void follow(Window window);
  [[nodiscard]] bool divide(Window& window, Edge& edge, const Point& apex);
  /// Adds a turn node for an end of the window's edge. Requires: a ray of the window passes through this end.
  /// `sees_apex` is false if the apex of the face lies on this ray.
  bool note_turn(const Window& window, int turn, bool sees_apex);
  /// Calls note_turn(), unless Ray::has_turn says that the search needs no turn node there.
  void pass_end(const Window& window, Ray& ray, int turn, bool sees_apex);
  void push_turn(std::uint32_t root, mesh::HalfEdge corner, int turn, const Tangent& line, std::uint32_t earlier);
  /// Returns whether two chains of turn nodes (TurnNode::earlier) have the same pivots in the same order.
  [[nodiscard]] bool is_same_chain(std::uint32_t a, std::uint32_t b) const;
  /// Adds a turn node for the goal if the goal lies between the two rays of the window.
  void reach_goal(const Window& window);
  /// Adds a turn node for a line from a root to the goal, unless the path would have to turn back at the root.
  void push_goal(std::uint32_t root, const Tangent& line);
  /// Adds a window to the open list or, if its bound is not above `at_once_bound_`, to `at_once_`. Leaves it out if its
  /// bound is above `limit_`.
  void offer(const Window& window, const Edge& edge);

  /// Tests the line of a turn node, unless a known path to its pivot is at least as short. If the line passes the
  /// test, makes a root at its end. If it fails, adds turn nodes for its obstacles.
  void expand(std::uint32_t index);
  /// Tests the line of a turn node that ends at the goal. If the line passes the test, the search has found the path.
  void try_goal(std::uint32_t index);
  void push_obstacles(std::uint32_t index, const DiscLine::Obstacle& left, const DiscLine::Obstacle& right);
  void push_turn_limit(std::uint32_t index);
  void push_next_line(std::uint32_t root, std::uint32_t earlier);
  [[nodiscard]] std::uint32_t dominating_root(const TurnNode& node, mesh::HalfEdge corner, std::uint32_t newest) const;
  [[nodiscard]] bool is_shorter_with_other_turn(const TurnNode& node, mesh::HalfEdge corner);
  [[nodiscard]] std::uint32_t failed_line(const TurnNode& node, std::uint32_t newest) const;
  [[nodiscard]] bool are_on_one_arc(mesh::HalfEdge from, mesh::HalfEdge to, int turn) const;
  void leave_root(std::uint32_t root, mesh::HalfEdge corner);

  [[nodiscard]] double length_to(const Root& root, const Point& direction) const {
    return root.length + arc_length(root.end.pivot, root.direction, direction, map_->radius);
  }
  [[nodiscard]] double bound(const Window& window, const Edge& edge) const;
  [[nodiscard]] double bound_of_guide(const Window& window, const Edge& edge) const;

  const DiscMap* map_ = nullptr;
  const DiscEnds* ends_ = nullptr;
  const GuideDistances* distances_ = nullptr;  ///< the distances of the guide, or null
  bool is_found_ = false;
  double length_ = 0.0;
  double limit_ = 0.0;               ///< the search leaves out each node whose bound is larger
  std::uint32_t last_root_ = kNone;  ///< the root at which the last line of the path starts
  Point last_direction_;             ///< the direction of this line
  double at_once_bound_ = 0.0;       ///< the search follows windows at once if their bound is not above this
  std::size_t expansions_ = 0;

  std::vector<Root> roots_;
  std::vector<Window> windows_;
  std::vector<TurnNode> turn_nodes_;
  std::vector<Failed> failed_;
  std::vector<Noted> noted_;
  std::vector<Window> at_once_;  ///< windows to follow before the next node of the open list
  OpenList open_;                ///< 2 i stands for the window i, 2 i + 1 for the turn node i
  DiscLine line_;
  std::vector<DiscStop> stops_;           ///< the start and the pivots of the path, for write_path()
  memory::ZeroedArray<Reached> reached_;  ///< by vertex and turn: see reached_at()
  memory::Stamp stamp_;
};

}  // namespace waywright::path
