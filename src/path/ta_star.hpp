#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "waywright/path.hpp"

#include "memory/stamp.hpp"
#include "memory/zeroed_array.hpp"
#include "path/ends.hpp"
#include "path/funnel.hpp"
#include "path/looked_at.hpp"
#include "path/open_list.hpp"

namespace waywright::path {

/// Triangulation A* for a point: A* over faces entered by an edge, each entry once, then the taut string through the
/// channel. A node's bound is the string's length to the funnel's apex and on, by way of the portal, to the goal: a
/// lower bound for its channel; the search goes on until no open bound is below the best length found.
///
/// Channels cross free edges and never vertices, so no path passes a wall or a point where walls meet.
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Departure: their bound g is a
/// maximum of estimates from the portals' ends; ours keeps each channel's funnel as it grows, which is tighter and as
/// cheap.
class TaStar {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Starts a search between ends that are not at one face. They and the triangulation must stay as they are.
  /// `looked_at`, if it is not null, notes the faces that the search looks at.
  void begin(const Triangulation& triangulation, const Ends& ends, LookedAt* looked_at);
  /// The mesh has grown since begin().
  void cover_mesh() { entered_.cover(std::size_t{3} * mesh_->face_slots()); }
  /// Searches on until `path.expansions` comes to `limit`, a path better than the one in `path` is found, or neither
  /// is to come; returns whether the latter.
  bool step(std::size_t limit, Path& path);
  /// Writes the edges that the best path crosses.
  void write_channel(Path& path) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A channel that the search has followed to the edge of a face.
  struct Node {
    mesh::HalfEdge entry;  ///< the edge by which the channel comes into the face, as a half-edge of that face
    std::uint32_t before;  ///< the node whose face it comes from, or kNone
    Funnel funnel;
    double bound;  ///< no path from start to goal along this channel is shorter
  };

  void forget_entries();
  /// Puts the faces around a start face, or beyond a node's face, on the open list.
  void leave_start_face(mesh::HalfEdge h);
  void leave(std::uint32_t position);
  void open(mesh::HalfEdge exit, std::uint32_t before, const Funnel& funnel);
  /// Follows the node's string to the goal. Returns whether that betters the best path.
  bool arrive(std::uint32_t position);
  void write_path(Path& path) const;
  [[nodiscard]] double bound(const Funnel& funnel) const;
  [[nodiscard]] double lower_bound() const;

  const Ends* ends_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;
  LookedAt* looked_at_ = nullptr;  ///< or null
  TautTree tree_;
  std::vector<Node> nodes_;
  OpenList open_;                               ///< positions in `nodes_`
  memory::ZeroedArray<std::uint32_t> entered_;  ///< by half-edge: the query that entered a face by it last
  memory::Stamp stamp_;
  bool is_found_ = false;
  double best_length_ = 0.0;
  std::uint32_t best_corner_ = 0;
  std::uint32_t best_node_ = 0;
  double given_up_bound_ = 0.0;  ///< no channel that was given up because its edge had been entered goes below
};

}  // namespace waywright::path
