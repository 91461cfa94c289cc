#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "waywright/memory_use.hpp"

#include "clearance/bridge_finder.hpp"
#include "clearance/changed_walls.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "mesh/touched_faces.hpp"

namespace waywright::clearance {

/// The corners and edges beyond the region R of the faces that an operation has touched, if the operation may have
/// changed their bridges. Keep the object: later operations use its memory again.
class ChangedRegion {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Starts an update. Requires: the operation of the triangulation is still open, `touched` are the faces that it has
  /// touched, and the object is empty.
  void begin(const Triangulation& triangulation, const mesh::TouchedFaces& touched);
  /// Adds a free edge between a touched face of the domain and a face that is not touched: the half-edge of the touched
  /// face.
  void add_border(mesh::HalfEdge h) { border_.push_back(h); }
  /// Adds a corner.
  void add_corner(mesh::HalfEdge corner);
  /// Collects the corners and edges of other faces whose bridges may have appeared or vanished because of the changed
  /// walls. Cost: a search beyond each edge on the border of R. Requires: add_border() was called for each of these
  /// edges.
  void collect_beyond(const ChangedWalls& changed, BridgeFinder& finder, BridgeScratch& scratch);
  /// Makes the object empty. Cost: proportional to what it contains.
  void clear();

  [[nodiscard]] const mesh::TouchedFaces& touched() const { return *touched_; }
  /// The corners beyond R at which foot bridges may have changed: each one is a half-edge that starts at the corner.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& corners() const { return corners_; }
  /// The free edges beyond R that may have become bridges or may be bridges no more. Each edge has one half-edge here.
  [[nodiscard]] const std::vector<mesh::HalfEdge>& edges() const { return edges_; }

  void count_memory(MemoryUse& use) const;
  /// Frees all memory. Requires: the object is empty.
  void release();

 private:
  /// What one call of collect_beyond() needs.
  struct Search {
    const ChangedWalls& changed;
    BridgeFinder& finder;
    BridgeScratch& scratch;

    [[nodiscard]] bool may_touch(const Disc& disc) const { return finder.may_touch(disc, changed); }
    /// Returns false only if the disc whose diameter is the edge of `h` touches no changed wall, or `border` does not
    /// meet the open disc. Requires: `border` is another edge.
    [[nodiscard]] bool may_be_near(mesh::HalfEdge h, mesh::HalfEdge border) const {
      return may_touch(finder.disc_of(h)) && finder.may_disc_meet(h, border);
    }
  };

  void search_beyond(const Search& search, mesh::HalfEdge border);
  void follow_fan(const Search& search, mesh::HalfEdge h, mesh::HalfEdge border, bool is_counter_clockwise);
  [[nodiscard]] bool is_border(mesh::HalfEdge h) const { return touched_->contains(mesh::face(mesh_->twin(h))); }
  void visit_hub(const Search& search, mesh::Vertex w);
  void add_corners(std::initializer_list<mesh::HalfEdge> corners);
  void add_edge(mesh::HalfEdge h);

  const mesh::TriangleMesh* mesh_ = nullptr;     ///< the mesh that the operation has changed
  const mesh::TouchedFaces* touched_ = nullptr;  ///< the faces of R
  std::vector<mesh::HalfEdge> border_;           ///< see add_border()
  std::vector<mesh::HalfEdge> corners_;
  std::vector<mesh::HalfEdge> edges_;
  std::vector<mesh::Vertex> hubs_;  ///< the vertices that visit_hub() has visited
  std::vector<bool> is_corner_;     ///< by half-edge: whether `corners_` contains it
  std::vector<bool> is_edge_;       ///< by half-edge: whether `edges_` contains it
};

}  // namespace waywright::clearance
