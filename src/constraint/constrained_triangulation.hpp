#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/item.hpp"

#include "base/compiler.hpp"
#include "constraint/batch.hpp"
#include "constraint/item_table.hpp"
#include "constraint/use_lists.hpp"
#include "delaunay/triangulation.hpp"
#include "locate/curve.hpp"
#include "memory/journaled_array.hpp"

namespace waywright::constraint {

/// A Delaunay triangulation constrained by items: which of them use each edge and each vertex, and why a vertex is
/// there.
///
/// An edge's label is the list of the sides that cover it. A vertex is kept by the corners at it (`corner_uses`, a list
/// of item slots) or by the crossing of two sides that run on through it: without a corner, it has more than two fixed
/// edges, or no reason to be.
template <class Geometry>
class ConstrainedTriangulation {
 public:
  using Triangulation = delaunay::Triangulation<Geometry>;

  explicit ConstrainedTriangulation(const Box& domain) : ConstrainedTriangulation(domain, PointBatch{}) {}
  /// What insert_all makes of nothing, but faster.
  template <class Batch>
  ConstrainedTriangulation(const Box& domain, const Batch& batch, const threads::Crew& crew = {});

  [[nodiscard]] const Box& domain() const { return domain_; }
  [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] const mesh::TriangleMesh& topology() const { return triangulation_.topology(); }
  [[nodiscard]] const ItemTable& items() const { return items_; }
  /// Takes note of an id that is not to be handed out again.
  void see(ItemId id) { items_.see(id); }
  [[nodiscard]] const UseLists& uses() const { return uses_; }
  /// The items with a corner at `v`, by slot; one as often as it has corners there.
  [[nodiscard]] Uses corner_uses(mesh::Vertex v) const { return corner_uses_[number(v)]; }

  /// Everything from its making to commit() happens or, if it goes before that (memory ran out), has never happened.
  /// One at a time.
  class Operation {
   public:
    explicit Operation(ConstrainedTriangulation& triangulation) : triangulation_(triangulation) {
      triangulation_.begin();
    }
    ~Operation() {
      if (!is_committed_) triangulation_.roll_back();
    }
    Operation(const Operation&) = delete;
    Operation& operator=(const Operation&) = delete;

    void commit() { is_committed_ = true; }

   private:
    ConstrainedTriangulation& triangulation_;
    bool is_committed_ = false;
  };

  /// Inserts an item. Requires: every point lies in the domain and in range, the id is free, no ring is empty.
  /// Source: Chen 2009, section 3.3, after Anglada 1997.
  void insert(const Shape& shape, ItemId id);

  /// Inserts many items at once: their corners along a curve, then their sides. A batch has a size(), and for i below
  /// that an id(i), a kind(i), a fill(i) and rings(i), a range of ranges of points: see batch.hpp. Reports corners
  /// done, and after them items whose sides are. Requires: as insert, of each.
  template <class Batch>
  void insert_all(const Batch& batch, const threads::Crew& crew = {});

  /// Takes an item out: ids off the edges; edges without ids are free again; vertices without a reason go, and the
  /// pieces of what ran straight through them are one edge again. Requires: an item of that id is alive. Source: Chen
  /// 2009, section 3.4, algorithms 15 to 17, completed for overlaps and shared crossings.
  void remove(ItemId id);

  /// Calls visit(side) for each side that covers the edge of `h`.
  template <class Visit>
  void for_each_side(mesh::HalfEdge h, Visit&& visit) const {
    uses_.for_each(topology().label(h), [&](std::uint32_t slot) { visit(items_.side(slot)); });
  }

  /// Everything there is to check, exactly: topology, orientation, cover, empty circles, and that edges and vertices
  /// are those which the items ask for. The first fault found, or nothing.
  [[nodiscard]] std::optional<std::string> find_fault() const;

  void count_memory(MemoryUse& use) const;
  /// Gives back spare memory. Requires: no operation is under way.
  void shrink_to_fit();

 private:
  static constexpr std::size_t kItemsBetweenReports = 1024;
  static constexpr std::size_t kIdsAhead = 8;
  static constexpr std::size_t kCornersAhead = 16;
  /// The first sides are the domain's.
  static constexpr std::array<mesh::Label, 4> kSidesOfBox = {UseLists::of(0), UseLists::of(1), UseLists::of(2),
                                                             UseLists::of(3)};

  /// What a side meets next on its way: a vertex, after crossing the free edges in `crossed_`, or a fixed edge.
  struct Step {
    mesh::Vertex vertex{};
    mesh::HalfEdge along = mesh::kNoHalfEdge;  ///< the edge to `vertex`, where there is one already
    mesh::HalfEdge fixed = mesh::kNoHalfEdge;  ///< the fixed edge in the way, from its right to its left
  };

  void begin();
  void begin_records();
  void roll_back();
  void set_corner_uses(mesh::Vertex v, Uses uses);
  /// Has the memory fetched that tells which items have a corner at `v`.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_corner_uses(mesh::Vertex v) const {
    base::prefetch_to_write(&corner_uses_[number(v)]);
  }
  void grow_corner_uses();

  /// Gives the domain its record, of corners of these ranks.
  void add_domain(std::span<const std::uint32_t> ranks);
  /// Gives a batch's items their records: corner after corner at the vertices of these ranks, and sides that are still
  /// to be inserted. Their hashes are not counted in. Returns the slots of the items with sides, in the order of their
  /// first corners.
  template <class Batch, class VertexOf, class AfterRecord>
  [[nodiscard]] std::vector<std::uint32_t> add_records(const Batch& batch, std::span<const std::uint32_t> ranks,
                                                       VertexOf&& vertex_of, AfterRecord&& after_record);
  template <class AfterItem>
  void insert_sides(const std::vector<std::uint32_t>& items, AfterItem&& after_item);

  [[nodiscard]] ItemHash::Words hash_of(std::uint32_t slot, const Outline& outline) const;
  void insert_ring(std::span<const Point> ring, std::uint32_t slot);
  void add_corner(mesh::Vertex v, std::uint32_t item);
  void end_ring();
  /// Gives an item its corners, those in `outline_`, and its sides, and counts its hash in.
  void end_item(std::uint32_t item);
  /// Accounts for a vertex that came in as a corner, and for the fixed edge that it may have parted.
  mesh::Vertex insert_vertex(const typename Triangulation::Inserted& inserted);
  void insert_side(std::uint32_t slot);
  /// The first step of a side, from its corner `u`.
  [[nodiscard]] Step leave_corner(mesh::Vertex u, const Side& side);
  /// The next step from a vertex on the way, to which the half-edge `behind` points back; from one that was there, and
  /// from one that cut() has just made. `guide` is a side that lies behind as well, and runs on through the vertex.
  [[nodiscard]] Step leave_vertex(mesh::HalfEdge behind, const Side& side, std::optional<std::uint32_t> guide);
  [[nodiscard]] Step leave_crossing(mesh::HalfEdge behind, const Side& side);
  /// Between two half-edges from one vertex: what `right` points to lies on the side's right, or behind; what `left`
  /// points to on its left, or behind.
  [[nodiscard]] Step leave_between(mesh::HalfEdge right, mesh::HalfEdge left, const Side& side);
  [[nodiscard]] Step step_across(mesh::HalfEdge exit, const Side& side);
  /// Parts a fixed edge where the side crosses it.
  mesh::Vertex cut(mesh::HalfEdge fixed, const Side& side);
  /// The step from `u` to the new vertex, after the edges in `crossed_` as they were before it was made.
  [[nodiscard]] Step step_to_crossing(mesh::Vertex u, mesh::Vertex x);
  /// A side that covers the edge and doesn't end where it ends.
  [[nodiscard]] std::optional<std::uint32_t> guide_along(mesh::HalfEdge along) const;
  /// Makes the piece from `u` to the step's vertex an edge that `side` uses. Returns its half-edge from `u`.
  mesh::HalfEdge take(mesh::Vertex u, const Step& step, std::uint32_t side);
  void split_uses(mesh::HalfEdge half);
  void strip_side(std::uint32_t slot);
  void strip_corner(mesh::Vertex v, std::uint32_t item);
  /// Takes `v` out if neither a corner nor a crossing needs it.
  void drop_if_unneeded(mesh::Vertex v);
  /// The edge over which `side` leaves `u`. Requires: it does, and has been stripped from the edge by which it came.
  [[nodiscard]] mesh::HalfEdge edge_of_side(mesh::Vertex u, std::uint32_t side) const;

  [[nodiscard]] std::optional<std::string> find_shape_fault() const;
  [[nodiscard]] std::optional<std::string> find_delaunay_fault() const;
  [[nodiscard]] std::optional<std::string> find_use_fault() const;
  [[nodiscard]] std::optional<std::string> find_vertex_fault() const;
  /// The edges that the side runs over, 0 where they don't lead to its end.
  [[nodiscard]] std::size_t count_edges(std::uint32_t slot) const;

  Box domain_;
  ItemTable items_;
  UseLists uses_;
  Triangulation triangulation_;
  memory::JournaledArray<Uses> corner_uses_;  ///< by vertex: the items with a corner there

  // Scratch, kept for its memory.
  std::vector<mesh::HalfEdge> crossed_;
  std::vector<mesh::Vertex> touched_;
  Outline outline_;  ///< of the item that comes or goes
};

}  // namespace waywright::constraint
