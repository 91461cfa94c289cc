#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/journal.hpp"
#include "nav/cover_tree.hpp"

namespace waywright::nav {

/// The components of the faces in the domain. Two faces are in one component if a chain of passages connects them. The
/// same polygons cover all faces of a component. So the class stores the cover once for each component.
///
/// ComponentUpdate updates the components after a change of the mesh. Compare ids only for equality, because the id of
/// a component depends on the history of changes. An undo log records all changes. Memory: four bytes per face.
class Components {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffff;
  using Set = CoverTree::Set;
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Finds the components of a triangulation. Cost: linear. Needs scratch memory for the components and the walls
  /// between them.
  explicit Components(const Triangulation& triangulation);

  /// Returns the component of a face in the domain.
  [[nodiscard]] Id component_of(mesh::Face f) const { return ids_[number(f)]; }
  /// Prefetches the entry of a face. The next function prefetches the record of its component.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Face f) const { base::prefetch_to_write(&ids_[number(f)]); }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_component(mesh::Face f) const {
    if (component_of(f) != kNone) base::prefetch_to_write(&records_[component_of(f)]);
  }
  [[nodiscard]] std::size_t count() const { return records_.size() - free_count_; }
  /// The number of faces in the component.
  [[nodiscard]] std::uint32_t size(Id component) const { return records_[component].size; }
  /// Returns whether a polygon covers the face.
  [[nodiscard]] bool is_covered(mesh::Face f) const { return cover(component_of(f)) != CoverTree::kEmpty; }
  /// Calls visit(slot) for each polygon that covers the face.
  template <class Visit>
  void for_each_cover(mesh::Face f, Visit&& visit) const {
    covers_.for_each(cover(component_of(f)), visit);
  }

  /// Compares the components of `faces` in this object with their components in `other`. Returns the first difference,
  /// or nothing if there is none. Requires: both objects contain these faces.
  [[nodiscard]] std::optional<std::string> find_difference(const Components& other,
                                                           std::span<const mesh::Face> faces) const;

  /// Calls visit(face) for each face whose id has changed since begin().
  template <class Visit>
  void for_each_changed_face(Visit&& visit) const {
    ids_.for_each_written([&](std::uint32_t f) { visit(mesh::Face{f}); });
  }

  // Changes of the components.

  /// Makes room for this number of faces. A new face belongs to no component.
  void make_room(std::size_t face_slots) { ids_.grow_to(face_slots, kNone); }
  void set_component(mesh::Face f, Id id) { ids_.write(number(f), id); }
  /// Makes a component. The caller sets the component of its faces.
  [[nodiscard]] Id add(std::uint32_t size, Set cover);
  void set_size(Id component, std::uint32_t size);
  /// Removes a component without faces.
  void remove(Id component);

  // Covers.

  /// The polygons that cover the component.
  [[nodiscard]] Set cover(Id component) const { return records_[component].cover; }
  void set_cover(Id component, Set cover);
  [[nodiscard]] const CoverTree& covers() const { return covers_; }
  [[nodiscard]] CoverTree& covers() { return covers_; }
  /// Removes these polygons from all covers.
  void remove_from_covers(std::span<const std::uint32_t> polygons);
  /// Returns the polygons that cover the face beyond `h`. Leaves out the polygons in `inserted`: no cover contains them
  /// yet. Requires: the cover of the face of `h` is known, or it is a ghost face; `inserted` ascends.
  [[nodiscard]] Set cover_beyond(const Triangulation& triangulation, mesh::HalfEdge h,
                                 std::span<const std::uint32_t> inserted);

  /// Clears the undo log.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  struct Record {
    std::uint32_t size = 0;  ///< of a free record: the next free one
    Set cover = CoverTree::kEmpty;
    Id next = kNone;  ///< the next component with the same `cover`; unused if the cover is empty
    Id previous = kNone;
  };

  void number_components(memory::Array<Id>& ids);
  void cover_components(const Triangulation& triangulation);
  void link_cover(Id component, Set cover);
  void unlink_cover(Id component);

  memory::JournaledArray<Id> ids_;  ///< by face
  memory::JournaledArray<Record> records_;
  CoverTree covers_;
  memory::FreeList free_records_;  ///< linked by Record::size
  std::size_t free_count_ = 0;
  std::size_t free_count_before_ = 0;

  // Scratch.
  std::vector<std::uint32_t> polygons_;   ///< an entry for each polygon side on the edge of cover_beyond()
  std::vector<std::uint32_t> contained_;  ///< those of `polygons_` that the cover beside this edge contains
  std::vector<std::uint32_t> removed_;    ///< the polygons that CoverTree::change() removes from a set
  std::vector<std::uint32_t> added_;      ///< the polygons that CoverTree::change() adds to it
};

// Disjoint sets of the numbers below n, stored as trees: `sets[i]` is the parent of i, or i itself if i is a root. The
// root of a tree is the smallest number of the set.
// Source: Galler and Fischer, *An improved equivalence algorithm*, CACM 1964.

/// Returns the root of the set of `i`. Halves the way to it.
[[nodiscard]] inline std::uint32_t root_of(std::span<std::uint32_t> sets, std::uint32_t i) {
  while (sets[i] != i) i = sets[i] = sets[sets[i]];
  return i;
}

/// Unites the sets of `i` and `j`.
inline void unite(std::span<std::uint32_t> sets, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t a = root_of(sets, i);
  const std::uint32_t b = root_of(sets, j);
  sets[std::max(a, b)] = std::min(a, b);
}

}  // namespace waywright::nav
