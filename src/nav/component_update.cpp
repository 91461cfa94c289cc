#include "nav/component_update.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "memory/count.hpp"
#include "nav/point_agent.hpp"

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

// run() works in four steps:
// - It takes the changed faces out of their components.
// - It divides the new faces into groups. A group is connected through new faces alone.
// - It finds the pieces into which the change has divided the old components, and makes one component of each set of
//   groups and pieces that are connected with each other.
// - It updates the covers.
void ComponentUpdate::run(Components& components, const Triangulation& triangulation, const Changes& changes) {
  start(components, triangulation.topology());
  remove_changed_faces(changes.changed);
  find_groups(changes.new_faces);
  components.remove_from_covers(changes.removed);
  find_old_parts(changes.may_divide);
  assign_components();
  cover_new_groups(triangulation, changes.inserted);
  flood_.cover_with_all(components, marks_, triangulation, changes.inserted);
}

void ComponentUpdate::run_in_open_space(Components& components, const mesh::TriangleMesh& mesh,
                                        std::span<const Face> changed, std::span<const Face> new_faces) {
  start(components, mesh);
  Id component = kNone;
  std::uint32_t removed_count = 0;
  for (const Face f : changed) {
    if (components.component_of(f) == kNone) continue;
    component = components.component_of(f);
    ++removed_count;
    components.set_component(f, kNone);
  }
  for (const Face f : new_faces) components.set_component(f, component);
  const auto added_count = static_cast<std::uint32_t>(new_faces.size());
  components.set_size(component, components.size(component) + added_count - removed_count);
}

void ComponentUpdate::start(Components& components, const mesh::TriangleMesh& mesh) {
  components_ = &components;
  mesh_ = &mesh;
  components.make_room(mesh.face_slots());
  marks_.begin(mesh.face_slots());
}

/// Takes the changed faces out of their components. Removes a component that has no face left.
void ComponentUpdate::remove_changed_faces(std::span<const Face> changed) {
  Components& components = *components_;
  may_have_connected_ = false;
  Id open = kNone;  // a component that no polygon covers
  Id id = kNone;
  std::uint32_t size = 0;
  const auto write = [&] {
    if (id == kNone) return;
    components.set_size(id, size);
    if (size == 0) components.remove(id);
  };
  for (const Face f : changed) {
    const Id own = components.component_of(f);
    if (own == kNone) continue;
    components.set_component(f, kNone);
    if (own != id) {
      write();
      id = own;
      size = components.size(own);
      if (components.cover(own) == CoverTree::kEmpty) {
        may_have_connected_ = may_have_connected_ || (open != kNone && open != own);
        open = own;
      }
    }
    --size;
  }
  write();
}

/// Finds the groups of new faces and their old neighbours. An old face is a face that has not changed, and its edges
/// have not changed, either. So if an old component has lost faces, each of its remaining pieces has a passage to a new
/// face: each piece contains an old neighbour of a group.
void ComponentUpdate::find_groups(std::span<const Face> new_faces) {
  const Components& components = *components_;
  const mesh::TriangleMesh& mesh = *mesh_;
  groups_.clear();
  group_sets_.clear();
  regions_.clear();
  faces_.clear();
  old_neighbours_.clear();
  const std::uint32_t no_group = marks_.next();
  group_mark_ = marks_.upcoming();
  for (const Face f : new_faces) marks_.set(f, no_group);
  for (const Face f : new_faces) {
    if (marks_.get(f) != no_group) continue;
    const auto group = static_cast<std::uint32_t>(groups_.size());
    const auto begin = static_cast<std::uint32_t>(faces_.size());
    const std::uint32_t group_mark = marks_.next();
    group_sets_.push_back(group);
    marks_.set(f, group_mark);
    faces_.push_back(f);
    for (std::size_t i = begin; i < faces_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge h = mesh::half_edge(faces_[i], k);
        if (!PointAgent::can_cross(mesh, h)) continue;
        const Face other = mesh::face(mesh.twin(h));
        if (components.component_of(other) != kNone) {
          old_neighbours_.push_back({components.component_of(other), group, other});
        } else if (marks_.get(other) == no_group) {
          marks_.set(other, group_mark);
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

// Finds the pieces into which a change of the mesh has divided the components.
//
// A *group* consists of new faces that passages connect with each other, through new faces alone. An *old neighbour* of
// a group is an old face that has a passage to a face of the group. A *region* consists of groups that are adjacent to
// each other across walls: it fills one connected part of the changed area. Before the change, a chain of passages
// connected each two old faces of a component. It led through old faces and through the areas of regions. So if the old
// faces beside each region are still connected with each other, no component is divided, and it is enough to look at
// one region after the other. Searches that have met form a *set* of searches. The searches that start beside one
// region advance alternately, until at most one of their sets is unfinished.
//
// The old faces that a finished set has found are a *piece*: no chain of passages leads from them to other old faces.
// The old chains that led through a piece are broken. So the old faces beside one of its regions may now be separated
// from the old faces beside another one, and it is no longer enough to look at each of these regions alone. Therefore
// all regions beside the piece count as one region from then on. When each region has at most one unfinished set, all
// unfinished sets are connected. Proof: suppose that two unfinished sets are not connected. Before the change they were
// connected, so a sequence in which regions and sets alternate leads from one to the other. Of all such pairs, take one
// with the shortest sequence. An unfinished set between the two would not be connected with one of them, and would have
// a shorter sequence to it. So all sets between the two are finished, all regions of the sequence count as one region,
// and this region has two unfinished sets: a contradiction.

/// Finds the connected parts of the old faces of each component. If no component can be divided, all groups with an old
/// neighbour in one component are connected, and no search is necessary.
void ComponentUpdate::find_old_parts(bool may_be_divided) {
  old_parts_.clear();
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
      old_parts_.push_back({first.component, first.group, components_->size(first.component), false, begin, end});
    } else {
      find_pieces(begin, end);
    }
  }
}

/// Finds the pieces of one old component by searches from its faces in `old_neighbours_`. Source: Even and Shiloach,
/// *An on-line edge-deletion problem*, JACM 1981 (searches that run alternately).
void ComponentUpdate::find_pieces(std::uint32_t begin, std::uint32_t end) {
  const std::span neighbours(old_neighbours_.data() + begin, end - begin);
  if (regions_.empty()) find_regions();
  start_searches(neighbours);
  const auto count = static_cast<std::uint32_t>(search_sets_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t region = root_of(regions_, searches_[i].group);
    if (groups_[region].first_search == i) search_beside(region);
  }

  std::uint32_t rest = kNone;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t set = root_of(search_sets_, i);
    unite(group_sets_, searches_[set].group, searches_[i].group);
    if (set != i || is_finished(set)) continue;
    if (rest == kNone) rest = i;
    unite(group_sets_, searches_[rest].group, searches_[i].group);
  }
  if (rest == kNone) rest = 0;  // all sets are finished: one of the pieces, whichever it is, counts as the rest
  const Id component = neighbours.front().component;
  std::uint32_t size = components_->size(component);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == rest || root_of(search_sets_, i) != i || !is_finished(i)) continue;
    add_piece(i, component);
    size -= old_parts_.back().size;
  }
  old_parts_.push_back({component, searches_[rest].group, size, false, begin, end});
}

/// Makes one region of each set of groups that share walls.
void ComponentUpdate::find_regions() {
  regions_.resize(groups_.size());
  std::iota(regions_.begin(), regions_.end(), 0U);
  for (std::uint32_t group = 1; group < groups_.size(); ++group) {
    for (std::uint32_t i = groups_[group].begin; i < groups_[group].end; ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = marks_.get(mesh::face(mesh_->twin(mesh::half_edge(faces_[i], k)))) - group_mark_;
        if (other < group) unite(regions_, group, other);
      }
    }
  }
}

/// Starts one search for each set of groups that are already known to be connected, from all their old neighbours.
void ComponentUpdate::start_searches(std::span<const OldNeighbour> old_neighbours) {
  search_mark_ = marks_.upcoming();
  search_sets_.clear();
  round_ = 0;
  for (const OldNeighbour& neighbour : old_neighbours) {
    const std::uint32_t group = root_of(group_sets_, neighbour.group);
    unite(regions_, group, neighbour.group);
    groups_[group].search = kNone;
    groups_[root_of(regions_, group)].first_search = kNone;
  }
  for (const OldNeighbour& neighbour : old_neighbours) {
    const std::uint32_t group = root_of(group_sets_, neighbour.group);
    if (groups_[group].search == kNone) start_search(group);
    note_found(groups_[group].search, neighbour.face);
  }
  for (std::uint32_t i = 0; i < search_sets_.size(); ++i) {
    std::uint32_t& first = groups_[root_of(regions_, searches_[i].group)].first_search;
    if (first == kNone) first = i;
    searches_[i].next_of_region = std::exchange(searches_[first].next_of_region, i);
  }
}

/// Makes a search for the connected groups whose root is `group`. It has found no face yet.
void ComponentUpdate::start_search(std::uint32_t group) {
  const auto i = static_cast<std::uint32_t>(search_sets_.size());
  search_sets_.push_back(i);
  marks_.next();  // before any face gets this mark: if memory runs out below, no later search gets the same mark
  if (i == searches_.size()) searches_.emplace_back();
  groups_[group].search = i;
  Search& search = searches_[i];
  search.group = group;
  search.found.clear();
  search.next = 0;
  search.next_of_set = search.next_of_region = search.next_in_queue = search.last_in_queue = i;
  search.round = 0;
}

/// Runs the searches beside a region alternately, one face of each set at a time, until at most one set is unfinished.
void ComponentUpdate::search_beside(std::uint32_t region) {
  alternating_.clear();
  add_searches_beside(groups_[region].first_search);
  for (;;) {
    list_unfinished(region);
    if (alternating_.size() <= 1) break;
    for (const std::uint32_t search : alternating_) step(root_of(search_sets_, search));
  }
  // If a later call joins this region to another one, it needs only the search of the unfinished set.
  std::uint32_t& first = groups_[root_of(regions_, region)].first_search;
  if (!alternating_.empty()) first = alternating_.front();
  searches_[first].next_of_region = first;
}

/// Adds all searches beside the region of a search to `alternating_`.
void ComponentUpdate::add_searches_beside(std::uint32_t search) {
  for (std::uint32_t i = searches_[search].next_of_region;; i = searches_[i].next_of_region) {
    alternating_.push_back(i);
    if (i == search) return;
  }
}

/// Keeps in `alternating_` one search of each unfinished set. If a set is finished, joins the regions beside its piece
/// to `region`, and adds the searches beside these regions.
void ComponentUpdate::list_unfinished(std::uint32_t region) {
  ++round_;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < alternating_.size(); ++i) {  // join_regions_of() makes the list longer
    const std::uint32_t set = root_of(search_sets_, alternating_[i]);
    if (searches_[set].round == round_) continue;
    searches_[set].round = round_;
    if (is_finished(set)) {
      join_regions_of(set, region);
    } else {
      alternating_[kept++] = alternating_[i];
    }
  }
  alternating_.resize(kept);
}

/// Joins the regions beside a piece to `region`, and adds the searches beside them to `alternating_`.
void ComponentUpdate::join_regions_of(std::uint32_t set, std::uint32_t region) {
  for (std::uint32_t i = searches_[set].next_of_set;; i = searches_[i].next_of_set) {
    const std::uint32_t own = root_of(regions_, region);
    const std::uint32_t other = root_of(regions_, searches_[i].group);
    if (other != own) {
      const std::uint32_t first = groups_[own].first_search;
      add_searches_beside(groups_[other].first_search);
      std::swap(searches_[first].next_of_region, searches_[groups_[other].first_search].next_of_region);
      unite(regions_, own, other);
      groups_[root_of(regions_, own)].first_search = first;
    }
    if (i == set) return;
  }
}

/// Returns whether the searches of a set have looked at the neighbours of all faces that they have found. Removes
/// finished searches from the start of the queue of the set.
bool ComponentUpdate::is_finished(std::uint32_t set) {
  while (searches_[set].last_in_queue != kNone) {
    const std::uint32_t last = searches_[set].last_in_queue;
    const std::uint32_t first = searches_[last].next_in_queue;
    if (searches_[first].next < searches_[first].found.size()) return false;
    searches_[last].next_in_queue = searches_[first].next_in_queue;
    if (first == last) searches_[set].last_in_queue = kNone;
  }
  return true;
}

/// The first search in the queue of a set looks at the old faces adjacent to one face, and goes to the end of the
/// queue. It skips new faces, because all old neighbours of one group belong to one search already.
void ComponentUpdate::step(std::uint32_t set) {
  if (is_finished(set)) return;
  const std::uint32_t search = searches_[searches_[set].last_in_queue].next_in_queue;
  searches_[set].last_in_queue = search;
  const Face f = searches_[search].found[searches_[search].next++];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge h = mesh::half_edge(f, i);
    const Face other = mesh::face(mesh_->twin(h));
    if (PointAgent::can_cross(*mesh_, h) && components_->component_of(other) != kNone) note_found(search, other);
  }
}

/// Records that `search` has found the face. If another search has found it before, unites the two searches.
void ComponentUpdate::note_found(std::uint32_t search, Face f) {
  const std::uint32_t found_by = marks_.get(f);
  if (found_by < search_mark_) {
    marks_.set(f, search_mark_ + search);
    searches_[search].found.push_back(f);
  } else {
    unite_searches(search, found_by - search_mark_);
  }
}

/// Unites the sets of two searches.
void ComponentUpdate::unite_searches(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t a = root_of(search_sets_, i);
  const std::uint32_t b = root_of(search_sets_, j);
  if (a == b) return;
  unite(search_sets_, a, b);
  Search& root = searches_[std::min(a, b)];
  Search& other = searches_[std::max(a, b)];
  std::swap(root.next_of_set, other.next_of_set);
  if (other.last_in_queue == kNone) return;
  if (root.last_in_queue != kNone)
    std::swap(searches_[root.last_in_queue].next_in_queue, searches_[other.last_in_queue].next_in_queue);
  root.last_in_queue = other.last_in_queue;
}

/// Adds the piece that a finished set of searches has found.
void ComponentUpdate::add_piece(std::uint32_t set, Id component) {
  const auto begin = static_cast<std::uint32_t>(piece_faces_.size());
  for (std::uint32_t i = searches_[set].next_of_set;; i = searches_[i].next_of_set) {
    piece_faces_.insert(piece_faces_.end(), searches_[i].found.begin(), searches_[i].found.end());
    if (i == set) break;
  }
  const auto end = static_cast<std::uint32_t>(piece_faces_.size());
  old_parts_.push_back({component, searches_[set].group, end - begin, true, begin, end});
}

// Makes one component of each set of connected groups and the old parts that they connect. An old part is either a
// piece, whose faces a search has listed, or the rest of an old component after its pieces (OldPart). If the set has
// such rests, the component takes the id of the largest of them.
void ComponentUpdate::assign_components() {
  Components& components = *components_;
  for (const OldPart& part : old_parts_) {
    Group& group = groups_[root_of(group_sets_, part.group)];
    if (part.is_piece || (group.id != kNone && part.size <= group.size)) continue;
    group.id = part.component;
    group.size = part.size;
  }
  for (Group& group : groups_) group.size = 0;
  for (const OldPart& part : old_parts_) {
    Group& group = groups_[root_of(group_sets_, part.group)];
    if (group.id == kNone) group.id = components.add(0, components.cover(part.component));
    group.size += part.size;
  }
  for (const OldPart& part : old_parts_) move_to(part, groups_[root_of(group_sets_, part.group)].id);
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    Group& group = groups_[i];
    Group& first = groups_[root_of(group_sets_, i)];
    first.size += group.end - group.begin;
    group.id = first.id;
    if (group.id == kNone) continue;
    for (std::uint32_t k = group.begin; k < group.end; ++k) components.set_component(faces_[k], group.id);
  }
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    if (group.id == kNone || root_of(group_sets_, i) != i) continue;
    components.set_size(group.id, group.size);
  }
}

void ComponentUpdate::move_to(const OldPart& part, Id id) {
  Components& components = *components_;
  const mesh::TriangleMesh& mesh = *mesh_;
  if (id == part.component) return;
  if (part.is_piece) {
    for (std::uint32_t i = part.begin; i < part.end; ++i) components.set_component(piece_faces_[i], id);
    return;
  }
  stack_.clear();
  const auto visit = [&](Face f) {
    if (components.component_of(f) != part.component) return;
    components.set_component(f, id);
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
  components.remove(part.component);
}

/// Makes a new component of each group that is not connected to an old face.
void ComponentUpdate::cover_new_groups(const Triangulation& triangulation, std::span<const std::uint32_t> inserted) {
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    if (groups_[i].id != kNone || !cover_from_beyond(triangulation, inserted, i)) continue;
    for (reached_.assign(1, i); !reached_.empty();) {
      const Group group = groups_[reached_.back()];
      reached_.pop_back();
      for (std::uint32_t k = group.begin; k < group.end; ++k) {
        for (std::uint32_t j = 0; j < 3; ++j) {
          const HalfEdge h = mesh::half_edge(faces_[k], j);
          const std::uint32_t other = marks_.get(mesh::face(mesh_->twin(h))) - group_mark_;
          if (other >= groups_.size() || groups_[other].id != kNone) continue;
          cover_group(triangulation, inserted, other, h);
          reached_.push_back(other);
        }
      }
    }
  }
}

/// Looks for a neighbour of the group that has a known cover or is a ghost face, and computes the group's cover from
/// it. Returns whether there is such a neighbour.
bool ComponentUpdate::cover_from_beyond(const Triangulation& triangulation, std::span<const std::uint32_t> inserted,
                                        std::uint32_t group) {
  for (std::uint32_t i = groups_[group].begin; i < groups_[group].end; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge beyond = mesh_->twin(mesh::half_edge(faces_[i], k));
      if (components_->component_of(mesh::face(beyond)) == kNone &&
          !triangulation.triangulation().is_ghost_face(beyond))
        continue;
      cover_group(triangulation, inserted, group, beyond);
      return true;
    }
  }
  return false;
}

/// Makes a component of the group and computes its cover. `beyond` is a half-edge on the group's border, in the face
/// outside the group. Requires: the cover of that face is known, or it is a ghost face.
void ComponentUpdate::cover_group(const Triangulation& triangulation, std::span<const std::uint32_t> inserted,
                                  std::uint32_t group, HalfEdge beyond) {
  const CoverTree::Set cover = components_->cover_beyond(triangulation, beyond, inserted);
  Group& added = groups_[group];
  added.id = components_->add(added.end - added.begin, cover);
  for (std::uint32_t i = added.begin; i < added.end; ++i) components_->set_component(faces_[i], added.id);
}

void ComponentUpdate::count_memory(MemoryUse& use) const {
  marks_.count_memory(use);
  flood_.count_memory(use);
  memory::count_spare(use, faces_, groups_, group_sets_, regions_, old_neighbours_, searches_, search_sets_,
                      alternating_, old_parts_, piece_faces_, stack_, reached_);
  for (const Search& search : searches_) memory::count_spare(use, search.found);
}

void ComponentUpdate::shrink_to_fit() {
  marks_.shrink_to_fit();
  flood_.release();
  memory::release(faces_, groups_, group_sets_, regions_, old_neighbours_, searches_, search_sets_, alternating_,
                  old_parts_, piece_faces_, stack_, reached_);
}

}  // namespace waywright::nav
