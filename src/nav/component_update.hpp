#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "nav/components.hpp"
#include "nav/polygon_flood.hpp"

namespace waywright::nav {

/// Updates components after a change of the mesh. If the change may have divided a component into pieces, several
/// searches start from those faces of the component that are adjacent to new faces. If two searches meet, the class
/// unites them. The searches beside one region of new faces advance alternately, step by step, until at most one of
/// them is unfinished. Then the faces of all pieces but one are known, and these are enough to give each piece its id.
/// So several changes far from each other cost as much as the same changes one by one. If a change connects components,
/// the smaller ones take the id of the largest. The object keeps its scratch between calls. Memory: up to four bytes
/// per face.
class ComponentUpdate {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

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
  /// Updates the components to the triangulation.
  void run(Components& components, const Triangulation& triangulation, const Changes& changes);

  /// Returns whether the last run() may have connected two components that no polygon covered before. Such an update
  /// has changed faces of both.
  [[nodiscard]] bool may_have_connected() const { return may_have_connected_; }

  /// Does the same as run(), for a change with three properties: the faces in `new_faces` fill the area of the faces in
  /// `changed`; no wall lies inside that area or on its border, before or after; no polygon was inserted or removed.
  void run_in_open_space(Components& components, const mesh::TriangleMesh& mesh, std::span<const mesh::Face> changed,
                         std::span<const mesh::Face> new_faces);

  /// Prefetches what an update reads and writes of a face, apart from its component.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Face f) const { marks_.prefetch(f); }

  void count_memory(MemoryUse& use) const;
  void shrink_to_fit();

 private:
  using Id = Components::Id;
  static constexpr Id kNone = Components::kNone;

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

  void start(Components& components, const mesh::TriangleMesh& mesh);
  void remove_changed_faces(std::span<const mesh::Face> changed);
  void find_groups(std::span<const mesh::Face> new_faces);
  void assign_components();
  void move_to(const OldPart& part, Id id);

  // Finding pieces.
  void find_old_parts(bool may_be_divided);
  void find_pieces(std::uint32_t begin, std::uint32_t end);
  void find_regions();
  void start_searches(std::span<const OldNeighbour> old_neighbours);
  void start_search(std::uint32_t group);
  void search_beside(std::uint32_t region);
  void add_searches_beside(std::uint32_t search);
  void list_unfinished(std::uint32_t region);
  void join_regions_of(std::uint32_t set, std::uint32_t region);
  [[nodiscard]] bool is_finished(std::uint32_t set);
  void step(std::uint32_t set);
  void note_found(std::uint32_t search, mesh::Face f);
  void unite_searches(std::uint32_t i, std::uint32_t j);
  void add_piece(std::uint32_t set, Id component);

  // Covering new components.
  void cover_new_groups(const Triangulation& triangulation, std::span<const std::uint32_t> inserted);
  [[nodiscard]] bool cover_from_beyond(const Triangulation& triangulation, std::span<const std::uint32_t> inserted,
                                       std::uint32_t group);
  void cover_group(const Triangulation& triangulation, std::span<const std::uint32_t> inserted, std::uint32_t group,
                   mesh::HalfEdge beyond);

  // The arguments of the call under way.
  Components* components_ = nullptr;
  const mesh::TriangleMesh* mesh_ = nullptr;

  FaceMarks marks_;
  PolygonFlood flood_;
  bool may_have_connected_ = false;

  // Scratch.
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
  std::vector<std::uint32_t> reached_;  ///< covered groups whose neighbours cover_new_groups() has not looked at yet
};

}  // namespace waywright::nav
