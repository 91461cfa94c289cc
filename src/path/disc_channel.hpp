#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "memory/scratch.hpp"
#include "path/channel.hpp"
#include "path/disc_ends.hpp"
#include "path/disc_map.hpp"
#include "path/open_list.hpp"

namespace waywright::path {

/// Finds a channel for a disc by A* over the faces, like TraStar for points. The channel crosses no edge that is
/// shorter than the disc is wide, because no centre of a disc lies on this edge. In each of its faces, no narrow foot
/// bridge that starts at a vertex of this face separates the edge through which the channel enters the face from the
/// edge through which it leaves the face. But the channel may cross a narrow foot bridge that starts in another face,
/// so perhaps no path leads through the channel.
///
/// The search orders the channels by an approximate length. If it finds no channel, there is no path.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006.
class DiscChannel {
 public:
  /// Starts a search. Requires: `ends` belongs to `map`. Neither changes during the search.
  void begin(const DiscMap& map, const DiscEnds& ends);
  /// Continues until `expansions` reaches `limit` or the search has ended. Returns whether it has ended.
  bool step(std::size_t limit, std::size_t& expansions);
  [[nodiscard]] bool is_found() const { return is_found_; }
  /// The edges that the channel crosses. Each one is a half-edge of the face that the channel leaves. Requires:
  /// is_found().
  [[nodiscard]] std::span<const mesh::HalfEdge> exits() const { return exits_; }
  /// A half-edge of the face in which the channel ends. Requires: is_found().
  [[nodiscard]] mesh::HalfEdge goal_face() const { return goal_face_; }

 private:
  // Marks of a face in this search.
  static constexpr std::uint32_t kLeft = 1;   ///< a channel has left the face to the left, and had no choice
  static constexpr std::uint32_t kRight = 2;  ///< a channel has left the face to the right, and had no choice
  /// A channel has entered the face and has continued from there, or the face contains the start.
  static constexpr std::uint32_t kEntered = 4;
  static constexpr std::uint32_t kAboveGoal = 8;  ///< a goal face, or a face on the way from one to the core
  static constexpr std::uint32_t kMarks = 16;

  /// A channel that the search is following.
  struct Channel {
    mesh::HalfEdge out;  ///< the last edge that it crossed
    Point left;          ///< the ends of this edge
    Point right;
    Sight sight;

    void move_left(mesh::HalfEdge exit, const Point& to);
    void move_right(mesh::HalfEdge exit, const Point& to);
  };
  struct Node {
    ChannelNode channel;
    unsigned exits;  ///< where the channel can leave the face: kLeft, kRight, both or, in a goal face, perhaps 0
  };

  void restart();
  void add_mark(mesh::Face f, std::uint32_t added);
  void leave_start(const locate::Located& location);
  void follow(Channel channel, std::uint32_t before);
  void leave(const Node& node, std::uint32_t index);
  void collect(std::uint32_t node);
  /// Returns the marks of the face or, if marks_faces_ is false, the marks of its edge `entry`.
  [[nodiscard]] std::uint32_t& mark_of(mesh::Face f, mesh::HalfEdge entry) {
    return marks_[marks_faces_ ? number(f) : number(entry)];
  }
  /// Returns whether the centre of a disc can cross the edge. Requires: the edge is no wall. Only an edge about as long
  /// as the disc is wide needs the exact decision.
  [[nodiscard]] bool can_cross(mesh::HalfEdge exit, double squared) const {
    return squared > map_->surely_long || (squared >= map_->surely_short && !map_->is_closed(exit));
  }
  /// Returns whether `edges`, a result of DeadEnds::edges_towards_goal() for the face `f`, contains the edge `exit` of
  /// this face.
  [[nodiscard]] static bool contains(unsigned edges, mesh::Face f, mesh::HalfEdge exit) {
    return (edges >> mesh::index_in(f, exit) & 1U) != 0;
  }
  /// Returns whether the channel can leave a face across the edge `exit`, which is no wall. `squared` is the squared
  /// length of this edge. Only a foot bridge that starts at the origin of `corner` can separate this edge from the edge
  /// of entry.
  [[nodiscard]] bool is_open(mesh::HalfEdge exit, double squared, mesh::HalfEdge corner) {
    if (squared > map_->surely_long && map_->bridges.foot_at(corner) == clearance::Bridges::kNone) return true;
    return squared >= map_->surely_short && decide_is_open(exit, squared, corner);
  }
  [[nodiscard]] bool decide_is_open(mesh::HalfEdge exit, double squared, mesh::HalfEdge corner);

  const DiscMap* map_ = nullptr;
  const DiscEnds* ends_ = nullptr;
  mesh::HalfEdge goal_face_;
  bool is_found_ = false;
  bool marks_faces_ = true;     ///< whether the search enters each face only once
  bool has_seen_foot_ = false;  ///< whether a foot bridge stopped the disc between two edges of a face

  std::vector<Node> nodes_;
  OpenList open_;                             ///< indices in `nodes_`
  memory::ZeroedArray<std::uint32_t> marks_;  ///< mark_of(): the stamp plus the marks, if this search wrote them
  memory::Stamp stamp_;                       ///< its value is a multiple of kMarks
  std::vector<mesh::HalfEdge> exits_;
};

}  // namespace waywright::path
