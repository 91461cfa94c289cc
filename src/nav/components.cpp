#include "nav/components.hpp"

#include <algorithm>

#include "memory/count.hpp"
#include "nav/point_agent.hpp"

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

// update() works in four steps:
// - It takes the changed faces out of their components.
// - It divides the new faces into groups. A group is connected through new faces alone.
// - It finds the pieces into which the change has divided the old components, and makes one component of each set of
//   groups and pieces that are connected with each other.
// - It updates the covers.
void Components::update(const Triangulation& triangulation, const Changes& changes) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  make_room(mesh);
  constexpr std::uint32_t kMarksToSpare = 0x40000000;  // one update uses fewer marks than this
  if (next_mark_ > ~kMarksToSpare) {
    marks_.clear();
    next_mark_ = 1;
  }
  remove_changed_faces(changes.changed);
  find_groups(mesh, changes.new_faces);
  remove_from_covers(changes);
  find_old_parts(mesh, changes.may_divide);
  assign_components(mesh);
  cover_new_groups(triangulation, changes);
  cover_with_all(triangulation, changes.inserted);
}

void Components::update_in_open_space(const mesh::TriangleMesh& mesh, std::span<const Face> changed,
                                      std::span<const Face> new_faces) {
  make_room(mesh);
  Id component = kNone;
  std::uint32_t removed_count = 0;
  for (const Face f : changed) {
    if (ids_[number(f)] == kNone) continue;
    component = ids_[number(f)];
    ++removed_count;
    set_id(f, kNone);
  }
  for (const Face f : new_faces) set_id(f, component);
  Record record = records_[component];
  record.size += static_cast<std::uint32_t>(new_faces.size()) - removed_count;
  records_.write(component, record);
}

void Components::make_room(const mesh::TriangleMesh& mesh) {
  marks_.grow_to(mesh.face_slots());
  ids_.grow_to(mesh.face_slots(), kNone);
}

/// Takes the changed faces out of their components. Frees a component that has no face left.
void Components::remove_changed_faces(std::span<const Face> changed) {
  may_have_connected_ = false;
  Id open = kNone;  // a component that no polygon covers
  Id id = kNone;
  Record record;
  const auto write = [&] {
    if (id == kNone) return;
    records_.write(id, record);
    if (record.size == 0) free_record(id);
  };
  for (const Face f : changed) {
    const Id own = ids_[number(f)];
    if (own == kNone) continue;
    set_id(f, kNone);
    if (own != id) {
      write();
      id = own;
      record = records_[own];
      if (record.cover == CoverTree::kEmpty) {
        may_have_connected_ = may_have_connected_ || (open != kNone && open != own);
        open = own;
      }
    }
    --record.size;
  }
  write();
}

/// Finds the groups of new faces and their old neighbours. An old face is a face that has not changed, and its edges
/// have not changed, either. So if an old component has lost faces, each of its remaining pieces has a passage to a new
/// face: each piece contains an old neighbour of a group.
void Components::find_groups(const mesh::TriangleMesh& mesh, std::span<const Face> new_faces) {
  groups_.clear();
  group_sets_.clear();
  regions_.clear();
  faces_.clear();
  old_neighbours_.clear();
  const std::uint32_t no_group = next_mark_++;
  group_mark_ = next_mark_;
  for (const Face f : new_faces) set_mark(f, no_group);
  for (const Face f : new_faces) {
    if (mark(f) != no_group) continue;
    const auto group = static_cast<std::uint32_t>(groups_.size());
    const auto begin = static_cast<std::uint32_t>(faces_.size());
    const std::uint32_t group_mark = next_mark_++;
    group_sets_.push_back(group);
    set_mark(f, group_mark);
    faces_.push_back(f);
    for (std::size_t i = begin; i < faces_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge h = mesh::half_edge(faces_[i], k);
        if (!PointAgent::can_cross(mesh, h)) continue;
        const Face other = mesh::face(mesh.twin(h));
        if (ids_[number(other)] != kNone) {
          old_neighbours_.push_back({ids_[number(other)], group, other});
        } else if (mark(other) == no_group) {
          set_mark(other, group_mark);
          faces_.push_back(other);
        }
      }
    }
    groups_.push_back({begin, static_cast<std::uint32_t>(faces_.size())});
  }
  std::sort(old_neighbours_.begin(), old_neighbours_.end(), [](const OldNeighbour& a, const OldNeighbour& b) {
    return a.component != b.component ? a.component < b.component : a.group < b.group;
  });
}

// Makes one component of each set of connected groups and the old parts that they connect. An old part is either a
// piece, whose faces a search has listed, or the rest of an old component after its pieces (OldPart). If the set has
// such rests, the component takes the id of the largest of them.
void Components::assign_components(const mesh::TriangleMesh& mesh) {
  for (const OldPart& part : old_parts_) {
    Group& group = groups_[root_of(group_sets_, part.group)];
    if (part.is_piece || (group.id != kNone && part.size <= group.size)) continue;
    group.id = part.component;
    group.size = part.size;
  }
  for (Group& group : groups_) group.size = 0;
  for (const OldPart& part : old_parts_) {
    Group& group = groups_[root_of(group_sets_, part.group)];
    if (group.id == kNone) group.id = add_record(0, records_[part.component].cover);
    group.size += part.size;
  }
  for (const OldPart& part : old_parts_) move_to(mesh, part, groups_[root_of(group_sets_, part.group)].id);
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    Group& group = groups_[i];
    Group& first = groups_[root_of(group_sets_, i)];
    first.size += group.end - group.begin;
    group.id = first.id;
    if (group.id == kNone) continue;
    for (std::uint32_t k = group.begin; k < group.end; ++k) set_id(faces_[k], group.id);
  }
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    if (group.id == kNone || root_of(group_sets_, i) != i) continue;
    set_size(group.id, group.size);
  }
}

void Components::move_to(const mesh::TriangleMesh& mesh, const OldPart& part, Id id) {
  if (id == part.component) return;
  if (part.is_piece) {
    for (std::uint32_t i = part.begin; i < part.end; ++i) set_id(piece_faces_[i], id);
    return;
  }
  stack_.clear();
  const auto visit = [&](Face f) {
    if (ids_[number(f)] != part.component) return;
    set_id(f, id);
    stack_.push_back(f);
  };
  for (std::uint32_t i = part.begin; i < part.end; ++i) {
    if (root_of(group_sets_, old_neighbours_[i].group) == root_of(group_sets_, part.group))
      visit(old_neighbours_[i].face);
  }
  while (!stack_.empty()) {
    const Face f = stack_.back();
    stack_.pop_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h = mesh::half_edge(f, i);
      if (PointAgent::can_cross(mesh, h)) visit(mesh::face(mesh.twin(h)));
    }
  }
  free_record(part.component);
}

Components::Id Components::add_record(std::uint32_t size, Set cover) {
  auto id = static_cast<Id>(records_.size());
  if (free_records_.is_empty()) {
    records_.append({size});
  } else {
    id = free_records_.first();
    const Id next_free = records_[id].size;
    records_.write(id, {size});
    free_records_.pop(next_free);
    --free_count_;
  }
  link_cover(id, cover);
  return id;
}

void Components::set_size(Id component, std::uint32_t size) {
  Record record = records_[component];
  record.size = size;
  records_.write(component, record);
}

void Components::free_record(Id component) {
  const Set cover = records_[component].cover;
  unlink_cover(component);
  covers_.free_unused(cover);
  records_.write(component, {free_records_.first()});
  (void)free_records_.push(component);
  ++free_count_;
}

void Components::begin() {
  covers_.begin();
  ids_.begin();
  records_.begin();
  free_records_before_ = free_records_;
  free_count_before_ = free_count_;
}

void Components::roll_back() {
  covers_.roll_back();
  ids_.roll_back();
  records_.roll_back();
  free_records_ = free_records_before_;
  free_count_ = free_count_before_;
}

void Components::count_memory(MemoryUse& use) const {
  ids_.count_memory(use, &MemoryUse::abstraction);
  marks_.count_memory(use, &MemoryUse::abstraction);
  records_.count_memory(use, &MemoryUse::abstraction);
  covers_.count_memory(use, &MemoryUse::abstraction);
  memory::count_spare(use, faces_, groups_, group_sets_, regions_, old_neighbours_, searches_, search_sets_,
                      alternating_, old_parts_, piece_faces_, stack_, flooded_, reached_, around_, sides_, polygons_,
                      contained_, removed_, added_, to_cover_, enclosed_, covered_, edges_, outline_.corners,
                      outline_.ring_ends);
  for (const Search& search : searches_) memory::count_spare(use, search.found);
  for (const constraint::SlotSet* const set : {&are_in_covers_, &touching_, &tested_, &is_enclosed_})
    set->count_spare(use);
}

void Components::shrink_to_fit() {
  ids_.shrink_to_fit();
  records_.shrink_to_fit();
  marks_.shrink_to_fit();
  covers_.shrink_to_fit();
  memory::release(faces_, groups_, group_sets_, regions_, old_neighbours_, searches_, search_sets_, alternating_,
                  old_parts_, piece_faces_, stack_, flooded_, reached_, around_, sides_, polygons_, contained_,
                  removed_, added_, to_cover_, enclosed_, covered_, edges_, outline_.corners, outline_.ring_ends);
  for (constraint::SlotSet* const set : {&are_in_covers_, &touching_, &tested_, &is_enclosed_}) set->release();
}

}  // namespace waywright::nav
