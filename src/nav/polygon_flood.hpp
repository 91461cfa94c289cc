#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/cover_finder.hpp"
#include "constraint/slot_sets.hpp"
#include "memory/pages.hpp"
#include "nav/components.hpp"

namespace waywright::nav {

/// Marks of faces: scratch for searches and floods. No mark is used twice, so nobody needs to remove marks. Memory: up
/// to four bytes per face.
class FaceMarks {
 public:
  /// Starts an update that uses fewer than 2^30 marks.
  void begin(std::size_t face_slots) {
    constexpr std::uint32_t kMarksToSpare = 0x40000000;
    if (next_ > ~kMarksToSpare) {
      marks_.clear();
      next_ = 1;
    }
    marks_.grow_to(face_slots);
  }
  /// Returns a new mark. The second function returns the mark that the first one will return next.
  std::uint32_t next() { return next_++; }
  [[nodiscard]] std::uint32_t upcoming() const { return next_; }

  [[nodiscard]] std::uint32_t get(mesh::Face f) const { return marks_.has_room(number(f)) ? marks_[number(f)] : 0; }
  void set(mesh::Face f, std::uint32_t mark) {
    marks_.make_room(number(f));
    marks_[number(f)] = mark;
  }
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Face f) const { marks_.prefetch(number(f)); }

  void count_memory(MemoryUse& use) const { marks_.count_memory(use, &MemoryUse::abstraction); }
  void shrink_to_fit() { marks_.shrink_to_fit(); }

 private:
  memory::Pages<std::uint32_t> marks_;  ///< by face
  std::uint32_t next_ = 1;
};

/// Adds an inserted polygon to the covers of the components inside it: floods the faces inside it, beginning along its
/// boundary. The object keeps its scratch between calls.
class PolygonFlood {
 public:
  /// Adds the inserted polygons to the covers of `components`, which contain none of them yet. Requires: `inserted`
  /// ascends, and the components are those of the triangulation.
  void cover_with_all(Components& components, FaceMarks& marks,
                      const constraint::ConstrainedTriangulation& triangulation,
                      std::span<const std::uint32_t> inserted);

  void count_memory(MemoryUse& use) const;
  void release();

 private:
  using Set = CoverTree::Set;

  /// An inserted polygon, and its first corner in (x, y) order.
  struct ToCover {
    mesh::Vertex first_corner;
    std::uint32_t polygon;
  };
  /// Something that refers to the set `set` in the tree of covers: a component with this cover, or a node of the tree
  /// with this parent. `index` is the component or the node.
  struct Covered {
    Set set;
    std::uint32_t index;
    bool is_node;
  };

  void cover_with(const ToCover& next);
  template <class Winding>
  void visit_boundary(const Winding& winding, mesh::Vertex first_of_all);
  template <class Winding>
  void flood(const Winding& winding);
  void visit(mesh::Face f);
  [[nodiscard]] bool is_on_enclosed(mesh::HalfEdge h);
  [[nodiscard]] bool is_enclosed(std::uint32_t polygon);
  void collect_touching();
  void visit_around(std::uint32_t enclosed);
  [[nodiscard]] bool is_covered_by_enclosed(Set cover) const;
  void add_to_covers();
  [[nodiscard]] mesh::HalfEdge outer_half_edge(mesh::Vertex v);

  // The arguments of the call under way.
  Components* components_ = nullptr;
  FaceMarks* marks_ = nullptr;
  const constraint::ConstrainedTriangulation* triangulation_ = nullptr;
  std::span<const std::uint32_t> inserted_;

  std::vector<ToCover> to_cover_;
  constraint::SlotSet are_in_covers_;  ///< the inserted polygons that the covers already contain

  // The polygon that cover_with() handles. Another polygon is *enclosed* if it has one ring, all of it lies inside this
  // polygon, and its boundary does not touch the boundary of this polygon.
  std::uint32_t covering_ = 0;
  constraint::Outline outline_;
  std::vector<std::uint32_t> sides_;           ///< by slot, ring after ring
  Set cover_at_boundary_ = CoverTree::kEmpty;  ///< the cover of a face inside this polygon, at its boundary
  std::uint32_t flood_ = 0;                    ///< the mark of the faces that the flood has visited
  bool may_enclose_ = false;                   ///< whether the flood looks for enclosed polygons
  bool knows_touching_ = false;                ///< whether `touching_` is complete
  constraint::SlotSet touching_;               ///< the polygons whose boundary touches the boundary of `covering_`
  constraint::SlotSet tested_;                 ///< polygons that is_enclosed() has tested
  constraint::SlotSet is_enclosed_;
  std::vector<std::uint32_t> enclosed_;  ///< the elements of `is_enclosed_`

  // Scratch.
  std::vector<mesh::Face> stack_;        ///< visited faces whose neighbours are not visited yet
  std::vector<Components::Id> flooded_;  ///< the components that the flood has visited
  std::vector<mesh::HalfEdge> around_;   ///< the faces around the vertex of outer_half_edge()
  std::vector<Covered> covered_;
  std::vector<std::pair<mesh::HalfEdge, std::int32_t>> edges_;  ///< see WindingOfSides
};

}  // namespace waywright::nav
