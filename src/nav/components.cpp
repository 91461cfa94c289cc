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
// - It finds the pieces into which the change has divided the old components, and makes one component of all groups and
//   pieces that are connected.
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
  find_groups(mesh, changes.made);
  remove_from_covers(changes);
  find_remainders(mesh, changes.may_divide);
  assign_components(mesh);
  cover_new_groups(triangulation, changes);
  for (const std::uint32_t polygon : changes.inserted) cover_with(triangulation, polygon, changes.inserted);
}

void Components::update_in_open_space(const mesh::TriangleMesh& mesh, std::span<const Face> changed,
                                      std::span<const Face> made) {
  make_room(mesh);
  Id component = kNone;
  std::uint32_t removed_count = 0;
  for (const Face f : changed) {
    if (ids_[number(f)] == kNone) continue;
    component = ids_[number(f)];
    ++removed_count;
    set_id(f, kNone);
  }
  for (const Face f : made) set_id(f, component);
  Record record = records_[component];
  record.size += static_cast<std::uint32_t>(made.size()) - removed_count;
  records_.write(component, record);
}

void Components::make_room(const mesh::TriangleMesh& mesh) {
  marks_.grow_to(mesh.face_slots());
  ids_.grow_to(mesh.face_slots(), kNone);
}

/// Takes the changed faces out of their components. Frees a component that has no face left.
void Components::remove_changed_faces(std::span<const Face> changed) {
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
    }
    --record.size;
  }
  write();
}

/// Finds the groups of new faces and their old neighbours. An old face is a face that has not changed, and its edges
/// have not changed, either. So if an old component has lost faces, each of its remaining pieces has a passage to a new
/// face: each piece contains an old neighbour of a group.
void Components::find_groups(const mesh::TriangleMesh& mesh, std::span<const Face> made) {
  groups_.clear();
  group_sets_.clear();
  faces_.clear();
  old_neighbours_.clear();
  const std::uint32_t no_group = next_mark_++;
  group_mark_ = next_mark_;
  for (const Face f : made) set_mark(f, no_group);
  for (const Face f : made) {
    if (mark(f) != no_group) continue;
    const auto group = static_cast<std::uint32_t>(groups_.size());
    const auto begin = static_cast<std::uint32_t>(faces_.size());
    const std::uint32_t group_mark = next_mark_++;
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
    group_sets_.push_back(group);
    groups_.push_back({begin, static_cast<std::uint32_t>(faces_.size())});
  }
  std::sort(old_neighbours_.begin(), old_neighbours_.end(), [](const OldNeighbour& a, const OldNeighbour& b) {
    return a.component != b.component ? a.component < b.component : a.group < b.group;
  });
}

/// Finds the remaining faces of the old components. If none of them can be divided, all groups with an old neighbour in
/// one component are connected, and no search is necessary.
void Components::find_remainders(const mesh::TriangleMesh& mesh, bool may_be_divided) {
  remainders_.clear();
  piece_faces_.clear();
  const auto count = static_cast<std::uint32_t>(old_neighbours_.size());
  for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
    const OldNeighbour& first = old_neighbours_[begin];
    bool is_in_one = true;
    for (; end < count && old_neighbours_[end].component == first.component; ++end) {
      if (!may_be_divided) unite(group_sets_, old_neighbours_[end].group, first.group);
      is_in_one = is_in_one && root_of(group_sets_, old_neighbours_[end].group) == root_of(group_sets_, first.group);
    }
    if (is_in_one) {
      remainders_.push_back({first.component, first.group, records_[first.component].size, false, begin, end});
    } else {
      find_pieces(mesh, begin, end);
    }
  }
}

/// Finds the pieces of one old component by searches from its faces in `old_neighbours_`. Source: Even and Shiloach,
/// *An on-line edge-deletion problem*, JACM 1981 (searches that run alternately).
void Components::find_pieces(const mesh::TriangleMesh& mesh, std::uint32_t begin, std::uint32_t end) {
  start_searches({old_neighbours_.data() + begin, end - begin});
  const std::uint32_t rest = search_until_one_is_left(mesh);
  const Id component = old_neighbours_[begin].component;
  std::uint32_t size = records_[component].size;
  for (std::uint32_t i = 0; i < search_sets_.size(); ++i) {
    const std::uint32_t set = root_of(search_sets_, i);
    unite(group_sets_, searches_[set].group, searches_[i].group);
    if (set != i || set == rest) continue;
    add_piece(i, component);
    size -= remainders_.back().size;
  }
  remainders_.push_back({component, searches_[rest].group, size, false, begin, end});
}

/// Starts one search for each set of groups that are already known to be connected, from all their old neighbours.
void Components::start_searches(std::span<const OldNeighbour> old_neighbours) {
  search_mark_ = next_mark_;
  search_sets_.clear();
  for (const OldNeighbour& neighbour : old_neighbours) {
    const std::uint32_t group = root_of(group_sets_, neighbour.group);
    std::uint32_t i = 0;
    while (i < search_sets_.size() && searches_[i].group != group) ++i;
    if (i == search_sets_.size()) {
      search_sets_.push_back(i);
      ++next_mark_;  // before any face gets this mark: if memory runs out below, no later search gets the same mark
      if (i == searches_.size()) searches_.emplace_back();
      searches_[i].group = group;
      searches_[i].found.clear();
      searches_[i].next = 0;
    }
    note_found(searches_[i], neighbour.face);
  }
}

/// Runs all searches alternately, one face each. Stops when at most one set of searches is unfinished. Returns that
/// set, or an arbitrary set if all are finished.
std::uint32_t Components::search_until_one_is_left(const mesh::TriangleMesh& mesh) {
  const std::span searches(searches_.data(), search_sets_.size());
  const auto is_unfinished = [](const Search& search) { return search.next < search.found.size(); };
  for (;;) {
    for (Search& search : searches) {
      if (is_unfinished(search)) step(mesh, search);
    }
    std::uint32_t rest = 0;
    std::size_t unfinished_sets = 0;
    for (std::uint32_t i = 0; i < searches.size(); ++i) {
      if (!is_unfinished(searches[i]) || (unfinished_sets > 0 && root_of(search_sets_, i) == rest)) continue;
      rest = root_of(search_sets_, i);
      if (++unfinished_sets > 1) break;
    }
    if (unfinished_sets <= 1) return rest;
  }
}

/// Looks at the old faces adjacent to a face. Skips new faces, because all old neighbours of one group belong to one
/// search already.
void Components::step(const mesh::TriangleMesh& mesh, Search& search) {
  const Face f = search.found[search.next++];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge h = mesh::half_edge(f, i);
    const Face other = mesh::face(mesh.twin(h));
    if (PointAgent::can_cross(mesh, h) && ids_[number(other)] != kNone) note_found(search, other);
  }
}

/// Records that `search` has found the face. If another search has found it before, unites the two searches.
void Components::note_found(Search& search, Face f) {
  const auto own = static_cast<std::uint32_t>(&search - searches_.data());
  const std::uint32_t found_by = mark(f);
  if (found_by < search_mark_) {
    set_mark(f, search_mark_ + own);
    search.found.push_back(f);
  } else {
    unite(search_sets_, own, found_by - search_mark_);
  }
}

/// Adds the piece that a finished set of searches has found. `search` is the first search of the set.
void Components::add_piece(std::uint32_t search, Id component) {
  const auto begin = static_cast<std::uint32_t>(piece_faces_.size());
  for (std::uint32_t i = search; i < search_sets_.size(); ++i) {
    if (root_of(search_sets_, i) != search) continue;
    piece_faces_.insert(piece_faces_.end(), searches_[i].found.begin(), searches_[i].found.end());
  }
  const auto end = static_cast<std::uint32_t>(piece_faces_.size());
  remainders_.push_back({component, searches_[search].group, end - begin, true, begin, end});
}

// Makes one component of each set of connected groups and the remainders that they connect. A remainder is either a
// piece, whose faces a search has listed, or the rest of an old component after its pieces (Remainder). If the set has
// such rests, the component takes the id of the largest of them.
void Components::assign_components(const mesh::TriangleMesh& mesh) {
  for (const Remainder& remainder : remainders_) {
    Group& group = groups_[root_of(group_sets_, remainder.group)];
    if (remainder.is_piece || (group.id != kNone && remainder.size <= group.size)) continue;
    group.id = remainder.component;
    group.size = remainder.size;
  }
  for (Group& group : groups_) group.size = 0;
  for (const Remainder& remainder : remainders_) {
    Group& group = groups_[root_of(group_sets_, remainder.group)];
    if (group.id == kNone) group.id = add_record(0, records_[remainder.component].cover);
    group.size += remainder.size;
  }
  for (const Remainder& remainder : remainders_)
    move_to(mesh, remainder, groups_[root_of(group_sets_, remainder.group)].id);
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

void Components::move_to(const mesh::TriangleMesh& mesh, const Remainder& remainder, Id id) {
  if (id == remainder.component) return;
  if (remainder.is_piece) {
    for (std::uint32_t i = remainder.begin; i < remainder.end; ++i) set_id(piece_faces_[i], id);
    return;
  }
  stack_.clear();
  const auto visit = [&](Face f) {
    if (ids_[number(f)] != remainder.component) return;
    set_id(f, id);
    stack_.push_back(f);
  };
  for (std::uint32_t i = remainder.begin; i < remainder.end; ++i) {
    if (root_of(group_sets_, old_neighbours_[i].group) == root_of(group_sets_, remainder.group))
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
  free_record(remainder.component);
}

std::uint32_t Components::root_of(std::vector<std::uint32_t>& sets, std::uint32_t i) {
  while (sets[i] != i) i = sets[i] = sets[sets[i]];
  return i;
}

void Components::unite(std::vector<std::uint32_t>& sets, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t a = root_of(sets, i);
  const std::uint32_t b = root_of(sets, j);
  sets[std::max(a, b)] = std::min(a, b);
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
  memory::count_spare(use, faces_, groups_, group_sets_, old_neighbours_, searches_, search_sets_, remainders_,
                      piece_faces_, stack_, flooded_, reached_, around_, sides_, polygons_, removed_, added_, enclosed_,
                      covered_, edges_);
  for (const Search& search : searches_) memory::count_spare(use, search.found);
}

void Components::shrink_to_fit() {
  ids_.shrink_to_fit();
  records_.shrink_to_fit();
  marks_.shrink_to_fit();
  covers_.shrink_to_fit();
  memory::release(faces_, groups_, group_sets_, old_neighbours_, searches_, search_sets_, remainders_, piece_faces_,
                  stack_, flooded_, reached_, around_, sides_, polygons_, removed_, added_, enclosed_, covered_,
                  edges_);
}

}  // namespace waywright::nav
