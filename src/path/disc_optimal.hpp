#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "path/cell_view.hpp"
#include "path/open_list.hpp"
#include "path/tangent.hpp"

namespace waywright::path {

/// A piece of the path of a disc's centre: a straight line, then an arc around the vertex at its end. The last piece
/// has no arc.
struct DiscPiece {
  Point from;
  Point to;
  Point centre;         ///< of the arc
  int side = 0;         ///< 1 if the arc turns left, -1 if it turns right, 0 if there is none
  Point direction;      ///< of the line, where the arc starts
  Point end_direction;  ///< of the path where the arc ends
};

/// Finds the shortest path of a disc by A* over windows and contacts. The path is a sequence of straight lines and of
/// arcs around wall vertices; each line touches the arcs at its ends. A *contact* is a vertex together with the
/// direction in which the path turns around it: left or right. A *window* is a gate together with the directions in
/// which straight lines from a contact (or from the start) cross the gate.
///
/// The search works on the cells of clearance::Cells. A disc in a cell touches only walls of this cell. So each step
/// looks at one cell. It finds the corners around which the lines of a window can turn there, and the gates through
/// which they can leave. Exact predicates decide whether a gate is wide enough for the disc. All other computations are
/// in doubles. Their rounding errors may make a window too wide. So before the search uses a contact, it tests the line
/// to the contact against all cells that the line crosses.
///
/// Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya), for a
/// point on a convex mesh. Differences: roots are circles, windows are sets of directions, and cells replace convex
/// polygons.
class DiscOptimal {
 public:
  /// Starts a search. Requires: the disc is free at both ends, which lie in the cells of the two edges. `map` does not
  /// change during the search.
  void begin(const DiscMap& map, const Point& start, const clearance::CellEdge& start_cell, const Point& goal,
             const clearance::CellEdge& goal_cell);
  /// Continues until `expansions` reaches `limit` or the search has ended. Returns whether it has ended.
  bool step(std::size_t limit, std::size_t& expansions);
  [[nodiscard]] bool is_found() const { return is_found_; }
  [[nodiscard]] double length() const { return length_; }
  /// Appends the pieces of the path. Requires: is_found().
  void write_path(std::vector<DiscPiece>& pieces) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A contact that the search has reached, or the start.
  struct Root {
    Contact contact;
    mesh::Vertex vertex = mesh::kNoVertex;
    Point direction;               ///< in which the path reaches it
    double length = 0.0;           ///< of the path up to there
    clearance::CellEdge cell;      ///< of the position at which the path reaches it
    std::uint32_t before = kNone;  ///< the root from which the straight line comes, in the same direction
    double reach = 0.0;            ///< how far the path can turn here, as turning_order() from `direction`
    std::uint32_t next = kNone;    ///< another root at the same contact
  };

  enum class Kind : std::uint8_t { window, contact, goal };

  struct Node {
    Kind kind;
    int side = 0;  ///< of a contact: 1 if the path turns left around it, -1 if right
    std::uint32_t root;
    mesh::Vertex vertex = mesh::kNoVertex;  ///< of a contact
    /// Of a window: the gate, as an edge of the cell beyond it. Of a contact: an edge that starts at the vertex and
    /// whose cell contains the position of the contact.
    clearance::CellEdge edge;
    clearance::CellEdge cell;  ///< the cell in which the straight line leaves the root
    Point right;               ///< window: its right bound; contact, goal: the direction of the line, as in `left`
    Point left;
    double length = 0.0;  ///< contact, goal: of the path
  };

  /// The directions in which lines leave a root within one cell or enter a cell.
  struct View {
    std::uint32_t root;
    clearance::CellEdge cell;
    bool is_inside;  ///< whether the root lies in the cell, so that there is no gate behind
    bool is_full;    ///< whether all directions are in view
    Point right;
    Point left;
  };

  void expand_contact(const Node& node);
  void turn(std::uint32_t root, const clearance::CellEdge& first);
  void look(const View& view);
  void look_for_contacts(const View& view);
  void look_for_goal(const View& view);
  void look_through_gates(const View& view);
  void look_through(const View& view, std::size_t gate);
  [[nodiscard]] bool crosses(const View& view, std::size_t gate, const Point& direction) const;
  void offer(const View& view, std::size_t gate, const Point& right, const Point& left);
  [[nodiscard]] bool is_in_view(const View& view, const Point& direction) const;
  [[nodiscard]] bool is_behind(std::size_t gate, const Point& position) const;
  [[nodiscard]] bool is_in_corner(std::size_t corner, const Point& direction) const;
  [[nodiscard]] bool is_clear(const clearance::CellEdge& cell, const Point& from, const Point& to,
                              mesh::Vertex from_vertex, mesh::Vertex to_vertex);
  [[nodiscard]] bool is_dominated(const Node& node, std::uint32_t first) const;
  [[nodiscard]] bool is_obstructed(const Root& root, const Point& direction, double length, mesh::Vertex target) const;
  void clip_at_start(const View& view, std::size_t gate, std::size_t corner, const Point& right, const Point& left);
  void close_in(const View& view, std::size_t gate, std::size_t corner, int side, const Point& other,
                Point& bound) const;
  /// The length of the arc at a root after which the path leaves it in a direction. A turn in the wrong direction is a
  /// rounding error and counts as no turn.
  [[nodiscard]] double arc(const Root& root, const Point& direction) const;
  [[nodiscard]] double length_to(const Root& root, const Point& direction) const {
    return root.length + arc(root, direction);
  }
  void push(double bound, const Node& node);

  const DiscMap* map_ = nullptr;
  Point start_;
  Point goal_;
  clearance::CellEdge goal_cell_;
  bool is_found_ = false;
  double length_ = 0.0;
  std::uint32_t last_root_ = kNone;
  Point last_direction_;

  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  OpenList open_;
  CellView view_;
  CellView walk_;  ///< the cell that is_clear() looks at
  struct Reached {
    std::uint32_t query;
    std::uint32_t root;  ///< the last root there
  };
  memory::ZeroedArray<Reached> reached_;  ///< by vertex and side
  memory::Stamp stamp_;
};

}  // namespace waywright::path
