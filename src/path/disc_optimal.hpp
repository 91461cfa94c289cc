#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "path/disc_ends.hpp"
#include "path/disc_line.hpp"
#include "path/disc_map.hpp"
#include "path/disc_pieces.hpp"
#include "path/disc_turn.hpp"
#include "path/guide_labels.hpp"
#include "path/open_list.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// Finds the shortest path of a disc by A*. The path is a sequence of straight lines and of arcs around wall vertices;
/// each line touches the arcs at its ends. A *contact* is a vertex together with the direction in which the path turns
/// around it: left or right. The *root* of a line is the contact that it leaves, or the start. A *turn node* is
/// a line from a root to a contact, or to the goal. A *window* is an edge of the mesh together with two rays from the
/// vertex of a root.
///
/// With windows, the search finds the vertices that are visible from the vertex of a root. They move from face to face,
/// as in Optimal. If a disc can move along a straight line from one contact to another, then the two vertices see each
/// other. Before a path uses a line, DiscLine tests it. If the line has an obstacle (DiscLine::Obstacle), the search
/// adds a turn node for this vertex. From there it then tries a line to the end of the old line.
///
/// The search decides exactly whether a disc passes a gap: windows and tested lines cross no gap that is too narrow.
/// All other numbers are doubles. ARCHITECTURE.md ("Discs") explains why the result is the shortest path.
///
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya), for a
/// point on a convex mesh.
class DiscOptimal {
 public:
  /// Starts a search for a path that is not longer than `limit`. `labels` are the labels of a guide for this map, these
  /// ends and this limit, or null. Requires: `ends` belongs to `map`. None of them changes during the search.
  void begin(const DiscMap& map, const DiscEnds& ends, double limit, const GuideLabels* labels);
  /// Continues until `expansions` reaches `limit` or the search has ended. Returns whether it has ended.
  bool step(std::size_t limit, std::size_t& expansions);
  /// A lower bound of the length of each path that is not longer than the limit. Requires: step() has returned false.
  [[nodiscard]] double least_bound() const { return open_.least_bound(); }
  [[nodiscard]] bool is_found() const { return is_found_; }
  [[nodiscard]] double length() const { return length_; }
  /// Writes the pieces of the path. Requires: is_found().
  void write_path(std::vector<DiscPiece>& pieces);

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A contact that the search has reached, or the start.
  struct Root {
    DiscLine::End end;
    mesh::HalfEdge corner;         ///< starts at the vertex and contains the position of the disc when it arrives
    Point direction;               ///< in which the path reaches it
    double length = 0.0;           ///< of the path up to there
    std::uint32_t before = kNone;  ///< the root at which the straight line to this contact starts
    TurnLimit limit{};             ///< how far the path can turn here
    std::uint32_t next = kNone;    ///< another root at the same contact
    Point position{};              ///< of the disc when it arrives
    double distance = 0.0;         ///< from there to the goal
  };

  /// A bound of a window: a ray from the centre of its root.
  struct Bound {
    Point direction;
    mesh::Vertex anchor = mesh::kNoVertex;  ///< the vertex through which the line leads, or kNoVertex
  };
  struct Window {
    mesh::HalfEdge entry;  ///< in the face beyond the edge
    std::uint32_t root;
    Bound right;
    Bound left;
  };
  /// The positions of the two ends of a window's edge, on the left and on the right of the window.
  struct Edge {
    Point left;
    Point right;
  };
  /// A line to a contact or to the goal, which DiscLine has not tested yet.
  struct TurnNode {
    mesh::HalfEdge corner;  ///< starts at the contact; at the goal: a half-edge of its face
    std::uint32_t root;
    mesh::Vertex vertex;  ///< kNoVertex at the goal
    int turn;             ///< around the vertex; kNoTurn at the goal
    Tangent line;
    double length;       ///< of the path to the end of the line
    std::uint32_t then;  ///< the turn node that the search tries after this one, in `turn_nodes_`, or kNone
  };

  /// A turn node that the search has added, and the turn node that the search tries after it.
  struct Noted {
    std::uint32_t root;
    std::uint32_t then;  ///< in `turn_nodes_`, or kNone
    std::uint32_t before;
  };

  /// A line that failed its test.
  struct Failed {
    std::uint32_t root;  ///< where the line starts
    std::uint32_t next;
    DiscLine::Obstacle left;
    DiscLine::Obstacle right;
  };

  struct Reached {
    std::uint32_t query;
    std::uint32_t root;    ///< the last root at this contact
    std::uint32_t noted;   ///< the last turn node that ends at this contact, in `noted_`
    std::uint32_t failed;  ///< the last line to this contact that failed its test, in `failed_`
  };

  [[nodiscard]] Reached& reached_at(mesh::Vertex v, int turn);
  /// Returns a number that is positive if the position lies left of a bound of a window of this root, negative if it
  /// lies right of the bound, and 0 if it lies on the bound.
  [[nodiscard]] static double orientation(const Root& root, const Bound& bound, const Point& position) {
    return cross(bound.direction, position - root.end.contact.centre);
  }
  /// The ends of the edge of `exit`, for a window that leaves the face of `exit` across this edge.
  [[nodiscard]] Edge edge_of(mesh::HalfEdge exit) const {
    return {map_->position(map_->mesh().target(exit)), map_->position(map_->mesh().origin(exit))};
  }
  [[nodiscard]] bool turns_back(const Root& root, const Point& direction) const;
  [[nodiscard]] DiscLine::End end_at(mesh::Vertex v, int turn) const { return {{map_->position(v), turn}, v}; }

  /// Returns whether the search does not follow lines from a contact across the edge `exit`, whose ends are `edge`: no
  /// disc has its centre there, or a dead end lies beyond, or the guide has not crossed the edge.
  [[nodiscard]] bool is_excluded(const Contact& from, mesh::HalfEdge exit, const Edge& edge) const {
    if (labels_ != nullptr ? !labels_->is_crossed(exit) : ends_->dead_ends().is_no_exit(mesh::face(exit), exit))
      return true;
    const double squared = squared_length(edge.left - edge.right);
    return squared <= map_->surely_long && is_too_short(from, exit, edge, squared);
  }
  [[nodiscard]] bool is_too_short(const Contact& from, mesh::HalfEdge exit, const Edge& edge, double squared) const;
  [[nodiscard]] bool is_outside(const Root& root, const Point& left, const Point& right, mesh::HalfEdge exit,
                                const Edge& edge) const;
  [[nodiscard]] bool is_far_behind(const Root& root, const Point& bound, const Edge& edge) const;
  std::uint32_t add_root(const Root& root);
  void leave_start(const locate::Located& location);
  void follow(Window window);
  [[nodiscard]] bool divide(Window& window, Edge& edge, const Point& apex);
  void note_turn(const Window& window, int turn, bool sees_apex);
  void push_turn(std::uint32_t root, mesh::HalfEdge corner, int turn, const Tangent& line, std::uint32_t then);
  [[nodiscard]] bool is_same_chain(std::uint32_t a, std::uint32_t b) const;
  void reach_goal(const Window& window);
  void push_goal(std::uint32_t root, const Tangent& line);
  void offer(const Window& window, const Edge& edge);

  void expand(std::uint32_t index);
  void try_goal(std::uint32_t index);
  void push_obstacles(std::uint32_t index, const DiscLine::Obstacle& left, const DiscLine::Obstacle& right);
  void push_limit(std::uint32_t index);
  void push_next_line(std::uint32_t root, std::uint32_t then);
  [[nodiscard]] std::uint32_t dominating_root(const TurnNode& node, mesh::HalfEdge corner, std::uint32_t first) const;
  [[nodiscard]] bool is_shorter_with_other_turn(const TurnNode& node, mesh::HalfEdge corner);
  [[nodiscard]] std::uint32_t failed_line(const TurnNode& node, std::uint32_t first) const;
  [[nodiscard]] bool are_on_one_arc(mesh::HalfEdge from, mesh::HalfEdge to, int turn) const;
  void leave_root(std::uint32_t root, mesh::HalfEdge corner);

  [[nodiscard]] double length_to(const Root& root, const Point& direction) const {
    return root.length + arc_length(root.end.contact, root.direction, direction, map_->radius);
  }
  [[nodiscard]] double bound(const Window& window, const Edge& edge) const;
  [[nodiscard]] double bound_of_guide(const Window& window, const Edge& edge) const;

  const DiscMap* map_ = nullptr;
  const DiscEnds* ends_ = nullptr;
  const GuideLabels* labels_ = nullptr;  ///< of the guide, or null
  bool is_found_ = false;
  double length_ = 0.0;
  double limit_ = 0.0;  ///< the search leaves out each node whose bound is larger
  std::uint32_t last_root_ = kNone;
  Point last_direction_;
  double at_once_bound_ = 0.0;  ///< the search follows windows at once if their bound is not above this
  std::size_t expansions_ = 0;

  std::vector<Root> roots_;
  std::vector<Window> windows_;
  std::vector<TurnNode> turn_nodes_;
  std::vector<Failed> failed_;
  std::vector<Noted> noted_;
  std::vector<Window> at_once_;  ///< windows to follow before the next node of the open list
  OpenList open_;                ///< 2 x index in `windows_`, or 2 x index in `turn_nodes_` + 1
  DiscLine line_;
  std::vector<DiscStop> stops_;           ///< of the path that was found
  memory::ZeroedArray<Reached> reached_;  ///< by vertex and turn
  memory::Stamp stamp_;
};

}  // namespace waywright::path
