#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "path/disc_ends.hpp"
#include "path/disc_line.hpp"
#include "path/disc_map.hpp"
#include "path/disc_turn.hpp"

namespace waywright::path {

/// The taut string of a disc through a channel: straight lines, and arcs around vertices.
///
/// First a funnel, whose strings run around circles, finds the vertices of the channel around which the string turns.
/// Then DiscLine tests each line, and turn_around() tests each arc, because a wall outside the channel may be nearer
/// than the radius. If a line has an obstacle (DiscLine::Obstacle), the class inserts this vertex into the string. If
/// the string would turn in the wrong direction at a vertex, the class removes this vertex from the string.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (the funnel for circles).
class DiscString {
 public:
  /// Computes the string. `exits` are the edges that the channel crosses, and `goal_face` is a half-edge of the face in
  /// which it ends. Returns whether it has found a string. The string is then a path of the disc. If it has found none,
  /// there may still be a path.
  [[nodiscard]] bool find(const DiscMap& map, const DiscEnds& ends, std::span<const mesh::HalfEdge> exits,
                          mesh::HalfEdge goal_face);
  /// The length of the path. Requires: the last call of find() returned true.
  [[nodiscard]] double length() const;
  /// Writes the pieces of the path. Requires: the last call of find() returned true.
  void write_path(std::vector<DiscPiece>& pieces);

 private:
  /// A pivot of the string, or one of its ends.
  struct Stop {
    DiscLine::End end;
    mesh::HalfEdge corner;  ///< starts at the vertex; kNoHalfEdge at the start and at the goal
    Tangent line;           ///< the line to the next stop
  };

  /// A vertex on a string of the funnel, or the start.
  struct Bend {
    Point centre;
    mesh::HalfEdge corner;  ///< starts at the vertex; kNoHalfEdge at the start
  };

  void run_funnel(std::span<const mesh::HalfEdge> exits);
  void move(mesh::HalfEdge corner, int turn);
  void end_at_goal();
  [[nodiscard]] bool turns(std::size_t before, const Bend& at, const Bend& after, int turn);
  [[nodiscard]] bool is_across(const Pivot& end, const Pivot& other);
  /// The pivot at the apex of the funnel.
  [[nodiscard]] Pivot apex() const { return {row_[apex_].centre, apex_turn_}; }
  void move_apex(std::size_t to, int turn);
  void add_apex();
  [[nodiscard]] Bend bend_at(mesh::HalfEdge corner) const;
  [[nodiscard]] Stop stop_at(mesh::HalfEdge corner, int turn) const;

  [[nodiscard]] bool straighten();
  /// What straighten() does after the test of a stop.
  enum class Step {
    forward,  ///< the stop passed the test: go to the next one
    again,    ///< the test changed the string: test from the same stop again
    failed,   ///< give up
  };
  [[nodiscard]] Step test(std::size_t i);
  [[nodiscard]] Step replace_hidden(std::size_t i, mesh::HalfEdge wall);
  [[nodiscard]] Step insert_obstacle(std::size_t i);
  [[nodiscard]] Step insert(std::size_t i, const Stop& stop);
  [[nodiscard]] Step test_arc(std::size_t i);

  const DiscMap* map_ = nullptr;
  Point start_;
  Point goal_;
  mesh::HalfEdge goal_face_;
  bool is_funnel_open_ = true;  ///< whether the funnel found each tangent that it needed
  // Both strings of the funnel: first the left one from its end to the apex, then the right one from the apex to its
  // end. The left string turns left around each of its vertices, the right one turns right.
  std::vector<Bend> row_;
  std::size_t left_ = 0;   ///< the index of the left end in `row_`
  std::size_t apex_ = 0;   ///< the index of the apex in `row_`
  std::size_t right_ = 0;  ///< the index of the right end in `row_`
  int apex_turn_ = kNoTurn;
  std::vector<Stop> stops_;
  std::vector<DiscStop> path_;
  DiscLine line_;
};

}  // namespace waywright::path
