#pragma once

#include <array>
#include <compare>
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
#include "constraint/operation.hpp"
#include "constraint/use_lists.hpp"
#include "delaunay/triangulation.hpp"
#include "locate/curve.hpp"
#include "memory/journal.hpp"

namespace waywright::constraint {

/// A constrained Delaunay triangulation: the sides of items lie on its fixed edges. It records which items use each
/// edge and each vertex. From these records it decides which vertices are still necessary.
///
/// The label of an edge is the number of the list of the sides that lie on it (UseLists). A vertex exists because items
/// have corners there (`corner_uses`, a list of item slots) or because two sides cross there. If a vertex has no
/// corners and at most two fixed edges, no item needs it, and the class removes it.
class ConstrainedTriangulation {
 public:
  using Triangulation = delaunay::Triangulation;

  explicit ConstrainedTriangulation(const Box& domain) : ConstrainedTriangulation(domain, PointBatch{}) {}
  /// Makes the triangulation that insert_all() would make from a triangulation without items, but faster. If it needs
  /// more vertices than the limits allow, the triangulation is incomplete, and has_too_many_vertices() returns true.
  template <class Batch>
  ConstrainedTriangulation(const Box& domain, const Batch& batch, const threads::ThreadTeam& team = {},
                           const VertexLimits& limits = {});

  [[nodiscard]] const Box& domain() const { return domain_; }
  [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
  [[nodiscard]] const mesh::TriangleMesh& topology() const { return triangulation_.topology(); }
  [[nodiscard]] const ItemTable& items() const { return items_; }
  /// Marks an id as used: the table never chooses it for a new item.
  void mark_used(ItemId id) { items_.mark_used(id); }
  /// Sets the largest id seen, as a change of the operation under way. Requires: no item has a larger id.
  void set_largest_id_seen(ItemId id) { items_.set_largest_id_seen(id); }
  [[nodiscard]] const UseLists& uses() const { return uses_; }
  /// Whether the fixed edges that the operation under way has made may divide a region of the domain into two.
  [[nodiscard]] bool may_have_divided() const { return new_walls_.may_divide(); }
  /// The items with a corner at `v`, by slot. The list contains an item once for each corner that it has there.
  [[nodiscard]] Uses corner_uses(mesh::Vertex v) const { return corner_uses_[number(v)]; }
  /// Prefetches the memory that says which items have a corner at `v`.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_corner_uses(mesh::Vertex v) const {
    base::prefetch_to_write(&corner_uses_[number(v)]);
  }

  /// One operation, all or nothing. If the object is destroyed before commit(), for example because memory ran out, the
  /// destructor undoes all changes since the object was made. Requires: no other operation is under way.
  class UndoGuard {
   public:
    explicit UndoGuard(ConstrainedTriangulation& triangulation, const VertexLimits& limits = {})
        : triangulation_(triangulation) {
      triangulation_.begin();
      triangulation_.budget_ = VertexBudget(limits);
    }
    ~UndoGuard() {
      if (!is_committed_) triangulation_.roll_back();
    }
    UndoGuard(const UndoGuard&) = delete;
    UndoGuard& operator=(const UndoGuard&) = delete;

    void commit() { is_committed_ = true; }

   private:
    ConstrainedTriangulation& triangulation_;
    bool is_committed_ = false;
  };

  /// Whether the operation has made more vertices than its limits allow. insert() and insert_all() then return before
  /// they are done, and the operation must be undone.
  [[nodiscard]] bool has_too_many_vertices() const { return budget_.is_exceeded(); }
  [[nodiscard]] const VertexBudget& budget() const { return budget_; }
  /// The index in its batch of an item at which the number of vertices exceeded a limit. Requires:
  /// has_too_many_vertices() is true after the insertion of a batch.
  [[nodiscard]] std::size_t refused_index() const { return refused_index_; }

  /// Inserts an item. Requires: all points lie in the domain and are in range, no item has this id, and no ring is
  /// empty. Source: Chen 2009, section 3.3, after Anglada 1997.
  void insert(const Shape& shape, ItemId id);

  /// Inserts many items at once, a ShapeBatch or a PointBatch: their corners along a curve, then their sides. Reports
  /// progress with team.report(): first the number of corners that are inserted, then the number of all corners plus
  /// the number of items whose sides are inserted. Requires: for each item, what insert() requires.
  template <class Batch>
  void insert_all(const Batch& batch, const threads::ThreadTeam& team = {});

  /// Removes an item from the lists of its edges and corners. Makes edges without items free. Removes vertices that are
  /// not needed any more. If another side passes through such a vertex, its two pieces become one edge. Requires: an
  /// item with this id exists. Source: Chen 2009, section 3.4, algorithms 15 to 17, completed for overlaps and shared
  /// crossings.
  void remove(ItemId id);

  /// Calls visit(side) for each side that lies on the edge of `h`.
  template <class Visit>
  void for_each_side(mesh::HalfEdge h, Visit&& visit) const {
    uses_.for_each(topology().label(h), [&](std::uint32_t slot) { visit(items_.side(slot)); });
  }

  /// One of the sides that lie on the edge of `h`. Requires: the edge is constrained.
  [[nodiscard]] const Side& any_side(mesh::HalfEdge h) const { return items_.side(uses_.any(topology().label(h))); }

  /// Checks everything, exactly: the topology; the orientation of each face; that the faces cover the domain once; the
  /// empty circles; and that the mesh has exactly the vertices and fixed edges that the items need. Returns a
  /// description of the first fault, or nothing.
  [[nodiscard]] std::optional<std::string> find_fault() const;

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: no operation is under way.
  void shrink_to_fit();

 private:
  static constexpr std::size_t kItemsBetweenReports = 1024;
  static constexpr std::size_t kTestsPerVertex = 32;  ///< allowed edge tests for a new vertex: three times the usual
  static constexpr std::size_t kEdgesPerVertex = 18;  ///< allowed edges of a removed vertex: three times the usual
  static constexpr std::size_t kEdgesPerSide = 16;    ///< allowed crossed edges of a side of a batch: usually 0 to 3
  /// add_records() prefetches the data of the item, and of the corner, that it needs this many steps later.
  static constexpr std::size_t kIdsAhead = 8;
  static constexpr std::size_t kCornersAhead = 16;
  /// A bulk load divides the domain into this many regions, if each of them then has a number of vertices between the
  /// next two numbers.
  static constexpr std::size_t kUsualRegions = 64;
  static constexpr std::size_t kSmallestRegion = 2048;
  static constexpr std::size_t kLargestRegion = 65536;
  /// If there are more points than this for each item with sides, one thread inserts all sides.
  static constexpr std::size_t kPointsPerItem = 64;
  /// The first four sides are the sides of the domain.
  static constexpr std::array<mesh::Label, 4> kSidesOfDomain = {UseLists::single(0), UseLists::single(1),
                                                                UseLists::single(2), UseLists::single(3)};

  /// The next piece of a side. It first crosses the free edges in `crossed_`. It ends at `vertex`, or at the edge
  /// `fixed`.
  struct Step {
    mesh::Vertex vertex{};
    mesh::HalfEdge along = mesh::kNoHalfEdge;  ///< the edge to `vertex`, if it exists already
    mesh::HalfEdge fixed = mesh::kNoHalfEdge;  ///< the half-edge from the right of the side to its left, if any
  };

  /// An item with sides: the rank of its first corner, and its slot.
  struct RankedItem {
    std::uint32_t rank, slot;
    friend auto operator<=>(const RankedItem&, const RankedItem&) = default;
  };
  /// A side of a batch: the index of its item in the list of RankedItem, and its slot.
  struct SideOfBatch {
    std::uint32_t item, side;
  };

  void begin();
  void begin_records();
  void roll_back();
  void set_corner_uses(mesh::Vertex v, Uses uses);
  /// Whether many items have a corner at `v`.
  [[nodiscard]] bool is_hub(mesh::Vertex v) const { return uses_.has_many(corner_uses_[number(v)]); }
  void grow_corner_uses();

  /// Makes the record of the domain. Its corners are the vertices of these ranks.
  void add_domain(std::span<const std::uint32_t> ranks);
  /// Makes the records of a batch's items. The corners of the items, one after the other, lie at the vertices of these
  /// ranks. The caller must insert their sides afterwards. Does not add their hashes. Returns the items with
  /// sides, in the order of the items' first corners.
  template <class Batch, class VertexOf, class AfterRecord>
  [[nodiscard]] std::vector<RankedItem> add_records(const Batch& batch, std::span<const std::uint32_t> ranks,
                                                    VertexOf&& vertex_of, AfterRecord&& after_record);
  /// Makes a vertex at each point. If this exceeds a limit, stops and returns the index of the point.
  [[nodiscard]] std::optional<std::uint32_t> insert_sorted(std::span<const Point> points,
                                                           const threads::ThreadTeam& team,
                                                           std::vector<mesh::Vertex>& vertices);
  /// Inserts the sides of these items of a batch into a triangulation that has no other items. The report counts
  /// `corners` corners as done. If this exceeds a limit, stops and sets `refused_index_`.
  template <class Batch>
  void insert_sides_by_region(const Batch& batch, std::span<const RankedItem> items, std::size_t corners,
                              const threads::ThreadTeam& team);
  [[nodiscard]] std::vector<SideOfBatch> insert_local_sides(std::span<const RankedItem> items, std::size_t corners,
                                                            const threads::ThreadTeam& team);
  std::size_t insert_local_sides(std::span<const RankedItem> items, std::size_t begin, std::size_t end, bool defers_all,
                                 std::vector<SideOfBatch>& late);
  template <class Batch, class AfterSide>
  void insert_sides(const Batch& batch, std::span<const RankedItem> items, std::span<const SideOfBatch> sides,
                    AfterSide&& after_side);
  template <class Batch>
  [[nodiscard]] bool is_refused_at(const Batch& batch, std::uint32_t slot);

  [[nodiscard]] ItemHash::Words hash_of(std::uint32_t slot, const Outline& outline) const;
  void insert_corners(const Rings& rings, std::uint32_t slot);
  void insert_late_corners(std::uint32_t slot);
  void add_corner(mesh::Vertex v, std::uint32_t item);
  void end_ring();
  /// Sets the corners of an item, which are in `outline_`, and its sides, and adds its hash.
  void end_item(std::uint32_t item);
  /// Updates the records after the insertion of a corner: makes room for the list of the vertex and, if the vertex has
  /// split a fixed edge, calls record_split(). Returns the vertex.
  mesh::Vertex insert_vertex(const Triangulation::Inserted& inserted);
  void insert_side(std::uint32_t slot);
  /// The first step of a side, from its corner `u`.
  [[nodiscard]] Step leave_corner(mesh::Vertex u, const Side& side);
  /// The next step of a side from a vertex on it. Call the first function at a vertex that existed before, and the
  /// second one at a vertex that cut() has just made. `behind` is the half-edge from this vertex back along the side.
  /// `leading_side` is another side that lies on the edge of `behind` and continues beyond the vertex, if there is one.
  [[nodiscard]] Step leave_vertex(mesh::HalfEdge behind, const Side& side, std::optional<std::uint32_t> leading_side);
  [[nodiscard]] Step leave_crossing(mesh::HalfEdge behind, const Side& side);
  /// The next step from a vertex, into the angle between two half-edges that start there. The target of `right` lies
  /// right of the side, or behind the vertex. The target of `left` lies left of the side, or behind the vertex.
  [[nodiscard]] Step leave_between(mesh::HalfEdge right, mesh::HalfEdge left, const Side& side);
  [[nodiscard]] Step step_across(mesh::HalfEdge exit, const Side& side);
  /// Splits a fixed edge at its crossing with the side. Returns the new vertex.
  mesh::Vertex cut(mesh::HalfEdge fixed, const Side& side);
  /// The step from `u` to the new vertex `x`. `crossed_` lists the edges that the side crossed before `x` was made.
  [[nodiscard]] Step step_to_crossing(mesh::Vertex u, mesh::Vertex x);
  /// Returns a side that lies on the edge of `along` and does not end at its target, or nothing.
  [[nodiscard]] std::optional<std::uint32_t> side_beyond(mesh::HalfEdge along) const;
  /// Makes the piece from `u` to the step's vertex an edge that `side` uses. Returns its half-edge from `u`.
  mesh::HalfEdge add_piece(mesh::Vertex u, const Step& step, std::uint32_t side);
  /// Updates the records after a new vertex has split a fixed edge. `half` starts at this vertex.
  void record_split(mesh::HalfEdge half);
  void remove_side(std::uint32_t slot);
  void remove_corner_use(mesh::Vertex v, std::uint32_t item);
  void remove_unneeded();
  /// Removes `v` if neither a corner nor a crossing needs it. Returns the number of its edges, or 0 if it stays.
  std::size_t remove_if_unneeded(mesh::Vertex v);
  /// The edge on which `side` leaves `u` or `w`, as a half-edge that starts there. Requires: the edges of `side` lead
  /// from `u` to `w`, and no other edge contains `side`. Cost: O(1) plus the smaller degree of the two.
  [[nodiscard]] mesh::HalfEdge edge_of_side(mesh::Vertex u, mesh::Vertex w, std::uint32_t side) const;

  [[nodiscard]] std::optional<std::string> find_orientation_fault() const;
  [[nodiscard]] std::optional<std::string> find_delaunay_fault() const;
  [[nodiscard]] std::optional<std::string> find_use_fault() const;
  [[nodiscard]] std::optional<std::string> find_vertex_fault() const;
  /// The number of edges on which the side lies, or 0 if they do not lead to its end.
  [[nodiscard]] std::size_t count_edges(std::uint32_t slot) const;

  Box domain_;
  ItemTable items_;
  UseLists uses_;
  Triangulation triangulation_;
  memory::JournaledArray<Uses> corner_uses_;  ///< by vertex: the items with a corner there
  VertexBudget budget_;                       ///< of the operation
  std::size_t refused_index_ = 0;

  /// A corner of the item that the operation inserts. Its vertex is not made yet.
  struct LateCorner {
    Point point;
    std::uint32_t index;  ///< the index of the corner in `outline_`
  };

  // Scratch.
  std::vector<LateCorner> late_corners_;
  std::vector<std::uint32_t> order_;
  std::vector<mesh::HalfEdge> crossed_;
  std::size_t crossed_count_ = 0;      ///< how many free edges insert_side() has crossed
  std::vector<mesh::Vertex> touched_;  ///< the vertices of the removed item; there may be no reason for them any more
  NewWalls new_walls_;
  Outline outline_;  ///< of the item that the operation inserts or removes
};

/// Whether a side that lies on the edge of `h` runs in the direction of `h`. If it does, and its ring is
/// counter-clockwise, the inside of the ring is left of `h`. The side and the edge lie on one line, so the (x, y) order
/// of their ends says whether they have the same direction.
[[nodiscard]] inline bool runs_along(const ConstrainedTriangulation& triangulation, const Side& side,
                                     mesh::HalfEdge h) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto& delaunay = triangulation.triangulation();
  return delaunay.comes_before(side.from, side.to) == delaunay.comes_before(mesh.origin(h), mesh.target(h));
}

}  // namespace waywright::constraint
