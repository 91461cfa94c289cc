#pragma once

#include <bit>
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
#include "clearance/feet.hpp"
#include "clearance/wall_tree.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/journal.hpp"
#include "memory/scratch.hpp"

namespace waywright::clearance {

/// All bridges of a mesh. BridgeFinder says what a bridge is.
///
/// Let a disc of radius r fit at two positions. Consider all walls, and the bridges that are shorter than 2 r. The disc
/// can move from one position to the other if and only if these lines together do not separate the two positions. So
/// the bridges say for every radius where a disc can pass. The class stores no data for any particular radius.
///
/// A bridge between two vertices is an edge of the mesh. A bridge to the inside of a wall is a *foot bridge*: it starts
/// at a corner of a face, crosses free edges and ends at its foot. Feet stores them, and for each wall the row of the
/// feet on its left.
///
/// update() updates the bridges after a change of the mesh. The result always equals a rebuild:
///
/// 1. A row of feet moves with its wall, and a foot bridge moves with its corner, if they belong to touched faces and
///    no changed wall touches the closed disc of the bridge: such a bridge stays.
/// 2. All other bridges of touched faces are found anew, and so are the bridges of the corners and edges of other faces
///    that the change may concern (ChangedRegion).
///
/// Searches go from face to face. If this takes too long, because many corners face one long wall, they use a tree of
/// the walls (WallTree).
///
/// Memory: eight bytes per half-edge, 20 per foot bridge, 48 per wall with a foot, and if the tree exists about 100 per
/// wall and four per half-edge.
///
/// Requires: each vertex of the mesh is the end of a wall.
class Bridges {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  static constexpr std::uint32_t kNone = Feet::kNone;

  /// Finds all bridges. Cost: n log n in the number of faces.
  explicit Bridges(const Triangulation& triangulation, const SearchLimits& limits = {});
  /// Copies the bridges. The copy belongs to a copy of the triangulation. Requires: no update is in progress.
  Bridges(const Bridges& other)
      : corners_(other.corners_),
        walls_(other.walls_),
        feet_(other.feet_),
        tree_(other.tree_),
        limits_(other.limits_) {}
  Bridges& operator=(const Bridges&) = delete;
  ~Bridges() = default;

  [[nodiscard]] const SearchLimits& limits() const { return limits_; }
  /// A number above 0 that says which bridges these are: it changes whenever the bridges or the slots of the mesh
  /// change, and no other object has ever had it. So a query can recognise the bridges about which it has learnt
  /// something.
  [[nodiscard]] std::uint64_t state() const { return state_; }

  /// Returns whether the edge of `h` is a bridge.
  [[nodiscard]] bool is_bridge(mesh::HalfEdge h) const { return (corners_[number(h)] & kIsBridge) != 0; }
  /// The foot bridge that starts at the origin of `h` and runs into the face of `h`, or kNone. The code names a foot
  /// bridge by its foot, the end inside a wall.
  [[nodiscard]] std::uint32_t foot_at(mesh::HalfEdge h) const { return ((corners_[number(h)] >> 1) - 1) & kNone; }
  /// The half-edge h with foot_at(h) == foot.
  [[nodiscard]] mesh::HalfEdge corner_of(std::uint32_t foot) const { return feet_.foot(foot).corner; }
  /// The wall that has the foot bridge on its left. Cost: logarithmic in the number of feet on the wall.
  [[nodiscard]] mesh::HalfEdge wall_of(std::uint32_t foot) const { return feet_.row(feet_.row_of(foot)).wall; }
  /// The first foot on the left of `wall`, or kNone.
  [[nodiscard]] std::uint32_t first_foot_on(mesh::HalfEdge wall) const {
    const std::uint32_t row = walls_[number(wall)];
    return row == 0 ? kNone : feet_.first(row - 1);
  }
  /// The next foot on the same wall, or kNone.
  [[nodiscard]] std::uint32_t next_foot(std::uint32_t foot) const { return feet_.next(foot); }
  /// The last foot on the left of `wall` for which is_before(foot) is true, or kNone. Requires: if it is true for a
  /// foot, it is true for the feet before it. Cost: logarithmic in the number of feet on the wall.
  template <class IsBefore>
  [[nodiscard]] std::uint32_t last_foot_before(mesh::HalfEdge wall, IsBefore&& is_before) const {
    const std::uint32_t row = walls_[number(wall)];
    return row == 0 ? kNone : feet_.last_before(row - 1, is_before);
  }
  /// The number of slots of feet, including free slots. The number of every foot is below it.
  [[nodiscard]] std::size_t foot_slots() const { return feet_.slots(); }

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
  struct LooseRow {
    mesh::Vertex from, to;  ///< the ends of the wall before the operation
    std::uint32_t row;
  };
  struct NewWall {
    std::size_t row;  ///< an index in `lost_rows_`: the first row with a side on the wall
    mesh::HalfEdge wall;
  };
  struct KeptFoot {
    mesh::Vertex from;
    std::uint32_t foot;
  };

  static constexpr std::uint32_t kIsBridge = 1;

  [[nodiscard]] static std::uint64_t new_state();
  void begin();
  void swap_bridges(Bridges& other);
  void rebuild(const Triangulation& triangulation);
  void grow_to_mesh(const mesh::TriangleMesh& mesh);

  void note_made_vertices(const mesh::TriangleMesh& mesh);
  [[nodiscard]] bool is_lost(const mesh::TriangleMesh& mesh, mesh::Vertex v) const {
    return !mesh.is_live(v) || is_made_[number(v)];
  }
  void clear_face(mesh::Face f);
  void move_rows(const Triangulation& triangulation);
  void put_row_on(const mesh::TriangleMesh& mesh, std::uint32_t row, mesh::HalfEdge wall);
  void collect_new_walls(const Triangulation& triangulation);
  void deal_out_feet(const Triangulation& triangulation, std::span<std::uint32_t> rows, std::span<const NewWall> walls);
  void drop_tree(std::uint32_t tree);
  void keep_feet(const Triangulation& triangulation, const ChangedWalls& changed, const BridgeFinder& finder);
  [[nodiscard]] bool is_kept(const Triangulation& triangulation, const ChangedWalls& changed,
                             const BridgeFinder& finder, std::uint32_t foot) const;
  [[nodiscard]] exact::Gap gap_of(const Triangulation& triangulation, std::uint32_t foot) const;
  void adopt(const Triangulation& triangulation, const BridgeFinder& finder, mesh::HalfEdge corner);
  void find_in_touched(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder);
  void find_beyond(const Triangulation& triangulation, const ChangedWalls& changed, BridgeFinder& finder);
  void note_angles(const BridgeFinder& finder, mesh::Face f);
  /// Calls visit(corner) for the corners of the face at which a foot bridge may start. Requires: note_angles() was
  /// called for the face.
  template <class Visit>
  void for_each_corner_with_foot(mesh::Face f, Visit&& visit) const {
    for (unsigned corners = BridgeFinder::corners_with_foot(acute_[number(f)]); corners != 0; corners &= corners - 1) {
      visit(mesh::half_edge(f, static_cast<std::uint32_t>(std::countr_zero(corners))));
    }
  }
  void find_at_corners(const Triangulation& triangulation, BridgeFinder& finder, mesh::Face f);
  [[nodiscard]] mesh::HalfEdge find_far_wall(const mesh::TriangleMesh& mesh, BridgeFinder& finder,
                                             mesh::HalfEdge corner) const;
  void find_at_corner(const Triangulation& triangulation, BridgeFinder& finder, mesh::HalfEdge corner);
  void find_at_edge(const Triangulation& triangulation, BridgeFinder& finder, mesh::HalfEdge h);
  /// Returns false only if the edge of the two half-edges is no bridge. Requires: `acute_` has the angles of both
  /// faces.
  [[nodiscard]] bool may_be_bridge(mesh::HalfEdge h, mesh::HalfEdge twin) const;
  void set_bridge(mesh::HalfEdge h, bool is_bridge);

  void add_foot(const Triangulation& triangulation, mesh::HalfEdge corner, mesh::HalfEdge wall);
  void remove_foot(std::uint32_t foot);
  void write_corner(mesh::HalfEdge h, std::uint32_t value);

  memory::JournaledArray<std::uint32_t> corners_;  ///< by half-edge: bit 0 is kIsBridge; the rest: foot_at() + 1, or 0
  memory::JournaledArray<std::uint32_t> walls_;    ///< by half-edge: the row of the wall + 1, or 0
  Feet feet_;
  WallTree tree_;
  SearchLimits limits_;
  std::uint64_t state_ = new_state();
  std::unique_ptr<Bridges> before_rebuild_;  ///< the bridges before the last update(), if it was a rebuild

  // Scratch.
  ChangedRegion region_;
  std::vector<mesh::Vertex> made_;           ///< the vertices that the operation has made
  std::vector<bool> is_made_;                ///< by vertex: whether `made_` contains it
  std::vector<std::uint32_t> loose_feet_;    ///< the feet whose corners belonged to touched faces
  std::vector<LooseRow> loose_rows_;         ///< the rows of walls of touched faces, in the order of the ends
  std::vector<std::uint32_t> lost_rows_;     ///< loose rows whose wall no longer exists, in the order of their lines
  std::vector<NewWall> new_walls_;           ///< walls of touched faces with a side on the line of a lost row
  std::vector<KeptFoot> kept_feet_;          ///< feet that stay but have no corner yet, in the order of `from`
  memory::ZeroedArray<std::uint8_t> acute_;  ///< by face: BridgeFinder::acute_angles()
  BridgeScratch scratch_;
};

}  // namespace waywright::clearance
