#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/cover_finder.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/slot_sets.hpp"
#include "memory/free_list.hpp"
#include "memory/journaled_array.hpp"
#include "memory/pages.hpp"
#include "nav/cover_tree.hpp"
#include "nav/disjoint_sets.hpp"

namespace waywright::nav {

/// The components of the faces in the domain. Two faces are in one component if a chain of passages connects them. The
/// same polygons cover all faces of a component. So the class stores the cover once for each component.
///
/// update() updates the components after a change of the mesh. If the change may have divided a component into pieces,
/// several searches start from those faces of the component that are adjacent to new faces. If two searches meet, the
/// class unites them. The searches beside one region of new faces advance alternately, step by step, until at most one
/// of them is unfinished (find_pieces.cpp). Then the faces of all pieces but one are known, and these are enough to
/// give each piece its id. So several changes far from each other cost as much as the same changes one by one. If a
/// change connects components, the smaller ones take the id of the largest. Compare ids only for equality, because the
/// id of a component depends on the history of changes. Memory: four bytes per face, and up to four more as scratch.
class Components {
 public:
  using Id = std::uint32_t;
  static constexpr Id kNone = 0xffffffff;

  /// Finds the components of a triangulation. Cost: linear. Needs scratch memory for the components and the walls
  /// between them.
  explicit Components(const constraint::ExactTriangulation& triangulation);

  /// Returns the component of a face in the domain.
  [[nodiscard]] Id component_of(mesh::Face f) const { return ids_[number(f)]; }
  /// Prefetches what an update reads and writes of a face. The next function prefetches the record of its component.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Face f) const {
    base::prefetch_to_write(&ids_[number(f)]);
    marks_.prefetch(number(f));
  }
  WAYWRIGHT_ALWAYS_INLINE void prefetch_component(mesh::Face f) const {
    if (component_of(f) != kNone) base::prefetch_to_write(&records_[component_of(f)]);
  }
  [[nodiscard]] std::size_t count() const { return records_.size() - free_count_; }
  /// The number of faces in the component.
  [[nodiscard]] std::uint32_t size(Id component) const { return records_[component].size; }
  /// Returns whether a polygon covers the face.
  [[nodiscard]] bool is_covered(mesh::Face f) const { return records_[component_of(f)].cover != CoverTree::kEmpty; }
  /// Calls visit(slot) for each polygon that covers the face.
  template <class Visit>
  void for_each_cover(mesh::Face f, Visit&& visit) const {
    covers_.for_each(records_[component_of(f)].cover, visit);
  }

  /// What has changed since the last update. `changed` lists the faces that were made, rebuilt or freed.
  /// `new_faces` lists the faces of `changed` that now lie in the domain. Each list contains a face once. `removed` and
  /// `inserted` list the polygons, by slot and in ascending order. A polygon that the operation inserted and removed
  /// again is in neither list. A replaced polygon is in both lists, with different slots.
  struct Changes {
    std::span<const mesh::Face> changed;
    std::span<const mesh::Face> new_faces;
    std::span<const std::uint32_t> removed;
    std::span<const std::uint32_t> inserted;
    /// If false, the walls that the operation made divide no component.
    bool may_divide;
  };
  /// Updates the components to the triangulation. Records each old value in the undo log before it overwrites the
  /// value.
  void update(const constraint::ExactTriangulation& triangulation, const Changes& changes);

  /// Returns whether the last update() may have connected two components that no polygon covered before. Such an update
  /// has changed faces of both.
  [[nodiscard]] bool may_have_connected() const { return may_have_connected_; }

  /// Does the same as update(), for a change with three properties: the faces in `new_faces` fill the area of the faces
  /// in `changed`; no wall lies inside that area or on its border, before or after; no polygon was inserted or removed.
  void update_in_open_space(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> changed,
                            std::span<const mesh::Face> new_faces);

  /// Compares the components of `faces` in this object with their components in `other`. Returns the first difference,
  /// or nothing if there is none. Requires: both objects contain these faces.
  [[nodiscard]] std::optional<std::string> find_difference(const Components& other,
                                                           std::span<const mesh::Face> faces) const;

  /// Calls visit(face) for each face whose id has changed since begin().
  template <class Visit>
  void for_each_changed_face(Visit&& visit) const {
    ids_.for_each_written([&](std::uint32_t f) { visit(mesh::Face{f}); });
  }

  /// Clears the undo log.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  using Set = CoverTree::Set;
  using Triangulation = constraint::ExactTriangulation;

  struct Record {
    std::uint32_t size = 0;  ///< of a free record: the next free one
    Set cover = CoverTree::kEmpty;
    Id next = kNone;  ///< the next component with the same `cover`; unused if the cover is empty
    Id previous = kNone;
  };
  /// New faces that passages connect with each other, through new faces alone.
  struct Group {
    std::uint32_t begin, end;  ///< in `faces_`
    Id id = kNone;
    std::uint32_t size = 0;  ///< size of the component to which the group will belong
    /// Valid only at a root of `group_sets_`, and only while searches run: the search that starts at the groups of this
    /// set.
    std::uint32_t search = kNone;
    std::uint32_t first_search = kNone;  ///< valid only at a root of `regions_`: a search that starts beside the region
  };
  /// An old face that has a passage to a face of a group.
  struct OldNeighbour {
    Id component;  ///< of the old face
    std::uint32_t group;
    mesh::Face face;
  };
  /// A search through the old faces of a component. It starts at the old neighbours of one group, or of several
  /// connected groups. Searches that have met are a *set*. The root of the set in `search_sets_` identifies it. Three
  /// members are links of circular lists: `next_of_set` links the searches of a set, `next_of_region` the searches
  /// beside a region, and `next_in_queue` the searches in the queue of a set.
  struct Search {
    std::uint32_t group = 0;
    std::vector<mesh::Face> found;
    std::size_t next = 0;              ///< index of the first face in `found` whose neighbours it has not looked at
    std::uint32_t next_of_set = 0;     ///< the next search of the same set
    std::uint32_t next_of_region = 0;  ///< the next search beside the same region
    std::uint32_t next_in_queue = 0;   ///< the next search in the queue of the searches of a set that may be unfinished
    std::uint32_t last_in_queue = 0;   ///< of a root: the last search in the queue of its set, or kNone
    std::uint32_t round = 0;           ///< of a root: the last round of list_unfinished() that has met its set
  };
  /// A connected part of the old faces of one component: a piece, whose faces a search has listed, or the rest of the
  /// component, whose faces no search has listed completely.
  struct OldPart {
    Id component;
    std::uint32_t group;  ///< a group to which it is connected
    std::uint32_t size;
    bool is_piece;
    /// For a piece: the range of its faces in `piece_faces_`. For the rest: the range of all old neighbours of its
    /// component in `old_neighbours_`. Some of them may belong to pieces.
    std::uint32_t begin, end;
  };

  // Finding the components of a whole triangulation.
  /// A half-edge on a wall between two components. Its face is in `component`, or is a ghost face: then `component` is
  /// kNone.
  struct SeparatingWall {
    Id component;
    mesh::HalfEdge h;
  };
  [[nodiscard]] static memory::Array<Id> join_faces(const Triangulation& triangulation);
  void number_components(memory::Array<Id>& ids);
  void cover_components(const Triangulation& triangulation);
  [[nodiscard]] std::vector<SeparatingWall> find_separating_walls(const mesh::TriangleMesh& mesh) const;

  // Updating ids.
  void make_room(const mesh::TriangleMesh& mesh);
  void remove_changed_faces(std::span<const mesh::Face> changed);
  void find_groups(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> new_faces);
  void assign_components(const mesh::TriangleMesh& mesh);
  void move_to(const mesh::TriangleMesh& mesh, const OldPart& part, Id id);
  void set_id(mesh::Face f, Id id) { ids_.write(number(f), id); }
  [[nodiscard]] Id add_record(std::uint32_t size, Set cover);
  void set_size(Id component, std::uint32_t size);
  void free_record(Id component);

  // Finding pieces.
  void find_old_parts(const mesh::TriangleMesh& mesh, bool may_be_divided);
  void find_pieces(const mesh::TriangleMesh& mesh, std::uint32_t begin, std::uint32_t end);
  void find_regions(const mesh::TriangleMesh& mesh);
  void start_searches(std::span<const OldNeighbour> old_neighbours);
  void start_search(std::uint32_t group);
  void search_beside(const mesh::TriangleMesh& mesh, std::uint32_t region);
  void add_searches_beside(std::uint32_t search);
  void list_unfinished(std::uint32_t region);
  void join_regions_of(std::uint32_t set, std::uint32_t region);
  [[nodiscard]] bool is_finished(std::uint32_t set);
  void step(const mesh::TriangleMesh& mesh, std::uint32_t set);
  void note_found(std::uint32_t search, mesh::Face f);
  void unite_searches(std::uint32_t i, std::uint32_t j);
  void add_piece(std::uint32_t set, Id component);

  // Marks of faces.
  [[nodiscard]] std::uint32_t mark(mesh::Face f) const { return marks_.has_room(number(f)) ? marks_[number(f)] : 0; }
  void set_mark(mesh::Face f, std::uint32_t mark) {
    marks_.make_room(number(f));
    marks_[number(f)] = mark;
  }

  // Updating covers.
  void remove_from_covers(const Changes& changes);
  void cover_new_groups(const Triangulation& triangulation, const Changes& changes);
  [[nodiscard]] bool cover_from_beyond(const Triangulation& triangulation, const Changes& changes, std::uint32_t group);
  void cover_group(const Triangulation& triangulation, const Changes& changes, std::uint32_t group,
                   mesh::HalfEdge beyond);
  [[nodiscard]] Set cover_beyond(const Triangulation& triangulation, mesh::HalfEdge h,
                                 std::span<const std::uint32_t> inserted);
  [[nodiscard]] mesh::HalfEdge outer_half_edge(const Triangulation& triangulation, mesh::Vertex v);
  void set_cover(Id component, Set cover);
  void link_cover(Id component, Set cover);
  void unlink_cover(Id component);

  // Covering with inserted polygons.
  /// An inserted polygon, and its first corner in (x, y) order.
  struct ToCover {
    mesh::Vertex first_corner;
    std::uint32_t polygon;
  };
  void cover_with_all(const Triangulation& triangulation, std::span<const std::uint32_t> inserted);
  void cover_with(const Triangulation& triangulation, const ToCover& next, std::span<const std::uint32_t> inserted);
  template <class Winding>
  void visit_boundary(const Triangulation& triangulation, const Winding& winding, mesh::Vertex first_of_all);
  template <class Winding>
  void flood(const Triangulation& triangulation, const Winding& winding);
  void visit(mesh::Face f);
  [[nodiscard]] bool is_on_enclosed(const Triangulation& triangulation, mesh::HalfEdge h);
  [[nodiscard]] bool is_enclosed(const Triangulation& triangulation, std::uint32_t polygon);
  void collect_touching(const Triangulation& triangulation);
  void visit_around(const Triangulation& triangulation, std::uint32_t enclosed);
  [[nodiscard]] bool is_covered_by_enclosed(Set cover) const;
  void add_to_covers();

  memory::JournaledArray<Id> ids_;  ///< by face
  memory::JournaledArray<Record> records_;
  CoverTree covers_;
  memory::FreeList free_records_;  ///< linked by Record::size
  std::size_t free_count_ = 0;
  memory::FreeList free_records_before_;
  std::size_t free_count_before_ = 0;

  // Scratch.
  memory::Pages<std::uint32_t>
      marks_;  ///< by face: the mark of the last flood, search or group there; no mark is used twice
  std::uint32_t next_mark_ = 1;
  bool may_have_connected_ = false;
  std::uint32_t group_mark_ = 0;   ///< mark of the first group; `group_mark_` - 1 marks new faces without a group
  std::uint32_t search_mark_ = 0;  ///< mark of the first search
  std::vector<mesh::Face> faces_;  ///< new faces, group by group
  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_sets_;     ///< the sets of connected groups, see root_of()
  std::vector<std::uint32_t> regions_;        ///< the sets of groups that share walls; empty until find_regions()
  std::vector<OldNeighbour> old_neighbours_;  ///< by component, then by group
  std::vector<Search> searches_;              ///< search_sets_.size() of them are in use, all in one old component
  std::vector<std::uint32_t> search_sets_;    ///< the sets of searches that have met, see root_of()
  std::vector<std::uint32_t> alternating_;    ///< the searches that search_beside() advances alternately
  std::uint32_t round_ = 0;                   ///< see Search::round
  std::vector<OldPart> old_parts_;            ///< of all old components
  std::vector<mesh::Face> piece_faces_;       ///< the faces of all pieces, piece by piece
  std::vector<mesh::Face> stack_;             ///< visited faces whose neighbours are not visited yet
  std::vector<Id> flooded_;                   ///< the components that the flood has visited
  std::vector<std::uint32_t> reached_;    ///< covered groups whose neighbours cover_new_groups() has not looked at yet
  std::vector<mesh::HalfEdge> around_;    ///< the faces around the vertex of outer_half_edge()
  constraint::Outline outline_;           ///< of the polygon `covering_`
  std::vector<std::uint32_t> sides_;      ///< of the polygon `covering_`, by slot, ring after ring
  std::vector<std::uint32_t> polygons_;   ///< an entry for each polygon side on the edge of cover_beyond()
  std::vector<std::uint32_t> contained_;  ///< those of `polygons_` that the cover beside this edge contains
  std::vector<std::uint32_t> removed_;    ///< the polygons that CoverTree::change() removes from a set
  std::vector<std::uint32_t> added_;      ///< the polygons that CoverTree::change() adds to it

  /// Something that refers to the set `set` in the tree of covers: a component with this cover, or a node of the tree
  /// with this parent. `index` is the component or the node.
  struct Covered {
    Set set;
    std::uint32_t index;
    bool is_node;
  };
  std::vector<ToCover> to_cover_;
  constraint::SlotSet are_in_covers_;  ///< the inserted polygons that the covers already contain
  // The polygon that cover_with() handles. Another polygon is *enclosed* if it has one ring, all of it lies inside this
  // polygon, and its boundary does not touch the boundary of this polygon.
  std::uint32_t covering_ = 0;
  Set cover_at_boundary_ = CoverTree::kEmpty;  ///< the cover of a face inside this polygon, at its boundary
  std::uint32_t flood_ = 0;                    ///< the mark of the faces that the flood has visited
  std::span<const std::uint32_t> inserted_;    ///< see Changes
  bool may_enclose_ = false;                   ///< whether the flood looks for enclosed polygons
  bool knows_touching_ = false;                ///< whether `touching_` is complete
  constraint::SlotSet touching_;               ///< the polygons whose boundary touches the boundary of `covering_`
  constraint::SlotSet tested_;                 ///< polygons that is_enclosed() has tested
  constraint::SlotSet is_enclosed_;
  std::vector<std::uint32_t> enclosed_;  ///< the elements of `is_enclosed_`
  std::vector<Covered> covered_;
  std::vector<std::pair<mesh::HalfEdge, std::int32_t>> edges_;  ///< see WindingOfSides in cover_polygon.cpp
};

}  // namespace waywright::nav
