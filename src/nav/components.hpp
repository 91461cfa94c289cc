#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "constraint/cover.hpp"
#include "constraint/exact_triangulation.hpp"
#include "constraint/use_lists.hpp"
#include "memory/free_list.hpp"
#include "memory/journaled_array.hpp"
#include "memory/pages.hpp"

namespace waywright::nav {

/// The faces of the box in components: two are in one when a way over free edges joins them. All faces of a component
/// are covered by the same polygons, which it keeps.
///
/// Kept up from one mesh to the next: where something was parted, searches from all sides of it run in turn until one
/// side at most is still unfinished; where components meet, the smaller ones take the label of the largest. A label is
/// good for comparing, no more: which component has which depends on history. Four bytes a face, and up to four more
/// as scratch.
class Components {
 public:
  using Label = std::uint32_t;
  static constexpr Label kNone = 0xffffffff;

  /// Those of a triangulation. Cost: linear, and no memory besides what stays but for walls between components.
  explicit Components(const constraint::ExactTriangulation& triangulation);

  /// The component of a face of the box.
  [[nodiscard]] Label of(mesh::Face f) const { return labels_[number(f)]; }
  [[nodiscard]] std::size_t count() const { return records_.size() - free_count_; }
  /// The number of its faces.
  [[nodiscard]] std::uint32_t size(Label component) const { return records_[component].size; }
  /// Whether a polygon covers the face.
  [[nodiscard]] bool is_covered(mesh::Face f) const { return records_[of(f)].cover != constraint::UseLists::kNone; }
  /// Calls visit(slot) for each polygon that covers the face.
  template <class Visit>
  void for_each_cover(mesh::Face f, Visit&& visit) const {
    covers_.for_each(records_[of(f)].cover, visit);
  }

  /// What changed since the last time. `gone` are the faces, by slot, that were made, rebuilt or freed, `made` those of
  /// them that are now faces of the box, each once. `removed` and `inserted` are the polygons, by slot, that went and
  /// came, ascending; those that did both are in neither.
  struct Changes {
    std::span<const mesh::Face> gone;
    std::span<const mesh::Face> made;
    std::span<const std::uint32_t> removed;
    std::span<const std::uint32_t> inserted;
  };
  /// Brings everything up to the triangulation. Whatever it changes is logged first.
  void update(const constraint::ExactTriangulation& triangulation, const Changes& changes);

  /// update() where `made` fill the place of `gone` with no wall in or around it, before or after, and no polygon came
  /// or went.
  void refill(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> gone, std::span<const mesh::Face> made);

  /// Where other components of the same faces differ, or nothing.
  [[nodiscard]] std::optional<std::string> find_difference(const Components& other,
                                                           std::span<const mesh::Face> faces) const;

  /// Calls visit(face) for each face that got another label since begin().
  template <class Visit>
  void for_each_relabelled_face(Visit&& visit) const {
    labels_.for_each_written([&](std::uint32_t f) { visit(mesh::Face{f}); });
  }

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back();

  void count_memory(MemoryUse& use) const;
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit();

 private:
  using Uses = constraint::Uses;
  using Triangulation = constraint::ExactTriangulation;

  struct Record {
    std::uint32_t size = 0;  ///< of a free record, the next free one
    Uses cover = constraint::UseLists::kNone;
  };
  /// New faces that are joined to one another without an old one's help.
  struct Group {
    std::uint32_t begin, end;  ///< in `faces_`
    Label label = kNone;
    std::uint32_t size = 0;  ///< of the component that it becomes
  };
  /// An old face with a free edge to a group.
  struct Contact {
    Label component;  ///< its own
    std::uint32_t group;
    mesh::Face face;
  };
  /// A search through what is left of an old component, from contacts in groups that are joined.
  struct Search {
    std::uint32_t group;
    std::vector<mesh::Face> found;
    std::size_t next = 0;  ///< the first face of `found` to be looked at
  };
  /// What is left of an old component, or a piece that came off it.
  struct Part {
    Label component;
    std::uint32_t group;  ///< one that it is joined to
    std::uint32_t size;
    bool is_piece;
    std::uint32_t begin, end;  ///< a piece's faces, in `parted_`; else the old component's contacts, in `contacts_`
  };

  // A mesh that nothing is known of.
  /// A wall half-edge of a face of the component, or of a ghost face, with another component beyond it.
  struct Door {
    Label component;
    mesh::HalfEdge h;
  };
  [[nodiscard]] static std::vector<Label> join_faces(const Triangulation& triangulation);
  void number_components(std::vector<Label>& labels);
  void cover_components(const Triangulation& triangulation);
  [[nodiscard]] std::vector<Door> find_doors(const mesh::TriangleMesh& mesh) const;

  // Labels.
  void make_room(const mesh::TriangleMesh& mesh);
  void take_out(std::span<const mesh::Face> gone);
  void find_groups(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> made);
  void find_parts(const mesh::TriangleMesh& mesh);
  void part(const mesh::TriangleMesh& mesh, std::uint32_t begin, std::uint32_t end);
  void start_searches(std::span<const Contact> contacts);
  [[nodiscard]] std::uint32_t search_until_one_is_left(const mesh::TriangleMesh& mesh);
  void step(const mesh::TriangleMesh& mesh, Search& search);
  void find(Search& search, mesh::Face f);
  void add_piece(std::uint32_t search, Label component);
  void label_parts(const mesh::TriangleMesh& mesh);
  void relabel(const mesh::TriangleMesh& mesh, const Part& part, Label label);
  void write_label(mesh::Face f, Label label) { labels_.write(number(f), label); }
  [[nodiscard]] Label add_record(const Record& record);
  void free_record(Label component);

  // Sets of groups, or of searches, as trees that lead to their first member.
  [[nodiscard]] static std::uint32_t top(std::vector<std::uint32_t>& sets, std::uint32_t i);
  static void unite(std::vector<std::uint32_t>& sets, std::uint32_t i, std::uint32_t j);

  // Marks.
  [[nodiscard]] std::uint32_t mark(mesh::Face f) const { return marks_.has_room(number(f)) ? marks_[number(f)] : 0; }
  void set_mark(mesh::Face f, std::uint32_t mark) {
    marks_.make_room(number(f));
    marks_[number(f)] = mark;
  }

  // Covers.
  void drop_removed(const Triangulation& triangulation, const Changes& changes);
  void find_covered(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> made, std::uint32_t polygon);
  void cover_new_groups(const Triangulation& triangulation, const Changes& changes);
  [[nodiscard]] bool cover_from_beyond(const Triangulation& triangulation, const Changes& changes, std::uint32_t group);
  void cover_group(const Triangulation& triangulation, const Changes& changes, std::uint32_t group,
                   mesh::HalfEdge beyond);
  [[nodiscard]] Uses cover_beyond(const Triangulation& triangulation, mesh::HalfEdge h,
                                  std::span<const std::uint32_t> inserted);
  [[nodiscard]] mesh::HalfEdge outer_half_edge(const Triangulation& triangulation, mesh::Vertex v);
  void cover_with(const Triangulation& triangulation, std::uint32_t polygon);
  template <class Winding>
  void cover_with(const Triangulation& triangulation, const Winding& winding);
  void set_cover(Label component, Uses cover);

  memory::JournaledArray<Label> labels_;  ///< by face
  memory::JournaledArray<Record> records_;
  constraint::UseLists covers_;
  memory::FreeList free_records_;  ///< linked by Record::size
  std::size_t free_count_ = 0;
  memory::FreeList free_records_before_;
  std::size_t free_count_before_ = 0;

  // Scratch, kept for its memory.
  memory::Pages<std::uint32_t> marks_;  ///< by face: numbers that are never used twice
  std::uint32_t next_mark_ = 1;
  std::uint32_t group_mark_ = 0;   ///< the first group's; the one before is that of new faces without a group yet
  std::uint32_t search_mark_ = 0;  ///< the first search's
  std::vector<mesh::Face> faces_;  ///< new faces, group by group
  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_sets_;
  std::vector<Contact> contacts_;
  std::vector<Search> searches_;
  std::vector<std::uint32_t> search_sets_;
  std::vector<Part> parts_;
  std::vector<mesh::Face> parted_;
  std::vector<mesh::Face> stack_;
  std::vector<Label> flooded_;
  std::vector<std::uint32_t> reached_;
  std::vector<mesh::HalfEdge> around_;
  constraint::Outline outline_;
  std::vector<std::uint32_t> sides_;
  std::vector<std::uint32_t> polygons_;
};

}  // namespace waywright::nav
