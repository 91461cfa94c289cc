#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/path.hpp"

#include "path/ends.hpp"
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
/// shorter; windows whose bound is hardly above the least one are followed at once, without passing the open list.
class Optimal {
 public:
  using Triangulation = constraint::ExactTriangulation;
  using Geometry = exact::Geometry;

  /// Starts a search between ends that are not at one face. They and the triangulation must stay as they are.
  void begin(const Triangulation& triangulation, const Ends& ends, bool wants_channel);
  /// Searches on until `path.expansions` comes to `limit` or the shortest path is found; returns whether it is, or
  /// there is none.
  bool step(std::size_t limit, Path& path);
  /// Writes the edges that the path crosses. Requires: the search was begun for it, a path is found.
  void write_channel(Path& path) const;

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

  /// The search has crossed an edge: kept only where the channel is asked for.
  struct Trace {
    mesh::HalfEdge entry;
    std::uint32_t before;
  };

  /// The shortest way to a vertex at which a path may turn, in the query that saw it last.
  struct Reached {
    double length = 0.0;
    std::uint32_t query = 0;
  };

  class Cone;

  void forget_lengths();
  void leave_start();
  void follow(const Node& node);
  void follow_window(Node window);
  void part(const Node& window, const Cone& cone, mesh::Vertex apex);
  void meet_goal(const Node& window, const Cone& cone);
  void note_turn(const Node& window, const Cone& cone, Kind kind, bool sees_apex);
  void make_left_turn(const Node& turn);
  void make_right_turn(const Node& turn);
  [[nodiscard]] std::uint32_t add_root(mesh::Vertex v, std::uint32_t before);
  void offer(const Node& window, const Cone& cone);
  void offer(const Node& window);
  void end_at_goal(std::uint32_t root, std::uint32_t trace);
  void write_path(Path& path) const;

  [[nodiscard]] bool is_barred(mesh::HalfEdge exit) const { return mesh_->is_fixed(exit); }
  [[nodiscard]] bool has_walls(mesh::Vertex v) const;
  [[nodiscard]] Reached& reached(mesh::Vertex v);
  [[nodiscard]] std::uint32_t traced(mesh::HalfEdge entry, std::uint32_t before);
  [[nodiscard]] const Point& place(mesh::Vertex v) const { return geometry_->nearest(number(v)); }
  [[nodiscard]] Geometry::View view(const Root& root) const;
  [[nodiscard]] double bound(const Node& window, const Cone& cone) const;

  const Ends* ends_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const Geometry* geometry_ = nullptr;
  bool wants_channel_ = false;

  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  OpenList open_;              ///< positions in `nodes_`
  std::vector<Node> at_once_;  ///< windows to follow before the next of the open list
  std::vector<Trace> traces_;
  std::vector<Reached> reached_;  ///< by vertex
  std::uint32_t query_ = 0;

  std::size_t expansions_ = 0;
  double at_once_bound_ = 0.0;
  double best_length_ = std::numeric_limits<double>::infinity();
  std::uint32_t best_root_ = 0;
  std::uint32_t best_trace_ = kNone;
};

}  // namespace waywright::path
