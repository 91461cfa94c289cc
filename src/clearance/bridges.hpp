#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/memory_use.hpp"

#include "clearance/bridge_finder.hpp"
#include "clearance/changed_region.hpp"
#include "clearance/changed_walls.hpp"
#include "constraint/exact_triangulation.hpp"
#include "memory/free_list.hpp"
#include "memory/journaled_array.hpp"
#include "memory/zeroed_array.hpp"

namespace waywright::clearance {

/// All bridges of a mesh. BridgeFinder says what a bridge is.
///
/// Let a disc of radius r fit at two positions. Consider all walls, and the bridges that are shorter than 2 r. The disc
/// can move from one position to the other if and only if these lines together do not separate the two positions. So
/// the bridges say for every radius where a disc can pass. The class stores no data for any particular radius.
///
/// A bridge between two vertices is an edge of the mesh. A bridge to the inside of a wall is a *foot bridge*: it starts
/// at a corner of a face, crosses free edges and ends at its foot. Each wall has a list of the foot bridges that end on
/// its left, in the order of their feet.
///
/// update() updates the bridges after a change of the mesh: it looks only at corners and edges near the change
/// (ChangedRegion). The result always equals a rebuild. Memory: eight bytes per half-edge, and twelve per foot bridge.
///
/// Requires: each vertex of the mesh is the end of a wall.
class Bridges {
 public:
  using Triangulation = constraint::ExactTriangulation;

  static constexpr std::uint32_t kNone = memory::FreeList::kEnd;

  /// A foot bridge. The code names it by its foot, the end inside a wall.
  struct Foot {
    mesh::HalfEdge corner;  ///< the bridge starts at the origin and runs into the face of this half-edge
    mesh::HalfEdge wall;    ///< has the bridge on its left
    std::uint32_t next;     ///< the next foot in the direction of `wall`, or kNone
  };

  /// Finds all bridges. Cost: n log n in the number of faces, plus the faces that possible foot bridges cross
  /// (BridgeFinder::follow_diameter), plus the faces that the discs of possible bridges touch.
  explicit Bridges(const Triangulation& triangulation);
  /// Copies the bridges. The copy belongs to a copy of the triangulation. Requires: no update is in progress.
  Bridges(const Bridges& other)
      : corners_(other.corners_),
        walls_(other.walls_),
        feet_(other.feet_),
        free_feet_(other.free_feet_),
        free_feet_before_(other.free_feet_before_) {}
  Bridges& operator=(const Bridges&) = delete;
  ~Bridges() = default;

  /// Returns whether the edge of `h` is a bridge.
  [[nodiscard]] bool is_bridge(mesh::HalfEdge h) const { return (corners_[number(h)] & kIsBridge) != 0; }
  /// The foot bridge that starts at the origin of `h` and runs into the face of `h`, or kNone.
  [[nodiscard]] std::uint32_t foot_at(mesh::HalfEdge h) const { return ((corners_[number(h)] >> 1) - 1) & kNone; }
  /// The first foot on the left of `wall`, or kNone.
  [[nodiscard]] std::uint32_t first_foot_on(mesh::HalfEdge wall) const { return (walls_[number(wall)] - 1) & kNone; }
  [[nodiscard]] const Foot& foot(std::uint32_t i) const { return feet_[i]; }
  /// The number of slots of feet, including free slots. The number of every foot is below it.
  [[nodiscard]] std::size_t foot_slots() const { return feet_.size(); }

  /// Updates the bridges to the triangulation. Requires: the operation of the triangulation is still open, and
  /// `touched` are the faces that it has touched, and `changed` contains all walls that it has inserted or removed, and
  /// ChangedWalls::make_tree() was called. If memory runs out, nothing changes. Cost: depends on what changed and on
  /// the bridges near it.
  void update(const Triangulation& triangulation, const mesh::TouchedFaces& touched, const ChangedWalls& changed);
  /// Undoes the last update(). Requires: since then, neither commit() nor roll_back() was called. Allocates nothing.
  void roll_back();
  /// Frees memory that only roll_back() needs.
  void commit() { before_rebuild_.reset(); }

  /// Returns the first difference from a rebuild, or nothing if there is none. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault(const Triangulation& triangulation) const;

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: no update is in progress.
  void shrink_to_fit();

 private:
  class Guard;

  static constexpr std::uint32_t kIsBridge = 1;

  void begin();
  void swap_bridges(Bridges& other);
  void rebuild(const Triangulation& triangulation);
  void grow_to_mesh(const mesh::TriangleMesh& mesh);

  void clear_face(mesh::Face f);
  void find_in_touched(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder);
  void find_beyond(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder);
  void note_angles(const BridgeFinder& finder, mesh::Face f);
  void find_at_corners(BridgeFinder& finder, mesh::Face f);
  void find_at_corner(BridgeFinder& finder, mesh::HalfEdge corner);
  void find_at_edge(const Triangulation& triangulation, BridgeFinder& finder, mesh::HalfEdge h);
  /// Returns false only if the edge of the two half-edges is no bridge. Requires: `acute_` has the angles of both
  /// faces.
  [[nodiscard]] bool may_be_bridge(mesh::HalfEdge h, mesh::HalfEdge twin) const;
  void set_bridge(mesh::HalfEdge h, bool is_bridge);

  void add_foot(mesh::HalfEdge corner, mesh::HalfEdge wall);
  [[nodiscard]] bool comes_before(const Triangulation& triangulation, const Foot& foot, const Foot& other) const;
  void link_new_feet(const Triangulation& triangulation);
  void remove_foot(std::uint32_t foot);
  void free_foot(std::uint32_t foot);
  void link(mesh::HalfEdge wall, std::uint32_t before, std::uint32_t foot);
  void write_corner(mesh::HalfEdge h, std::uint32_t value);

  memory::JournaledArray<std::uint32_t> corners_;  ///< by half-edge: bit 0 is kIsBridge; the rest: foot_at() + 1, or 0
  memory::JournaledArray<std::uint32_t> walls_;    ///< by half-edge: first_foot_on() + 1, or 0
  memory::JournaledArray<Foot> feet_;
  memory::FreeList free_feet_;  ///< linked by Foot::next
  memory::FreeList free_feet_before_;
  std::unique_ptr<Bridges> before_rebuild_;  ///< the bridges before the last update(), if it was a rebuild

  // Scratch.
  ChangedRegion region_;
  std::vector<std::uint32_t> new_feet_;      ///< the feet that are in no list yet
  memory::ZeroedArray<std::uint8_t> acute_;  ///< by face: BridgeFinder::acute_angles()
  BridgeScratch scratch_;
};

}  // namespace waywright::clearance
