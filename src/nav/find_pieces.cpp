#include <algorithm>
#include <numeric>
#include <utility>

#include "nav/components.hpp"
#include "nav/point_agent.hpp"

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

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

/// Finds the connected parts of the old faces of each component. If no component can be divided, all groups with an old
/// neighbour in one component are connected, and no search is necessary.
void Components::find_old_parts(const mesh::TriangleMesh& mesh, bool may_be_divided) {
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
      old_parts_.push_back({first.component, first.group, records_[first.component].size, false, begin, end});
    } else {
      find_pieces(mesh, begin, end);
    }
  }
}

/// Finds the pieces of one old component by searches from its faces in `old_neighbours_`. Source: Even and Shiloach,
/// *An on-line edge-deletion problem*, JACM 1981 (searches that run alternately).
void Components::find_pieces(const mesh::TriangleMesh& mesh, std::uint32_t begin, std::uint32_t end) {
  const std::span neighbours(old_neighbours_.data() + begin, end - begin);
  if (regions_.empty()) find_regions(mesh);
  start_searches(neighbours);
  const auto count = static_cast<std::uint32_t>(search_sets_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t region = root_of(regions_, searches_[i].group);
    if (groups_[region].first_search == i) search_beside(mesh, region);
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
  std::uint32_t size = records_[component].size;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == rest || root_of(search_sets_, i) != i || !is_finished(i)) continue;
    add_piece(i, component);
    size -= old_parts_.back().size;
  }
  old_parts_.push_back({component, searches_[rest].group, size, false, begin, end});
}

/// Makes one region of each set of groups that share walls.
void Components::find_regions(const mesh::TriangleMesh& mesh) {
  regions_.resize(groups_.size());
  std::iota(regions_.begin(), regions_.end(), 0U);
  for (std::uint32_t group = 1; group < groups_.size(); ++group) {
    for (std::uint32_t i = groups_[group].begin; i < groups_[group].end; ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = mark(mesh::face(mesh.twin(mesh::half_edge(faces_[i], k)))) - group_mark_;
        if (other < group) unite(regions_, group, other);
      }
    }
  }
}

/// Starts one search for each set of groups that are already known to be connected, from all their old neighbours.
void Components::start_searches(std::span<const OldNeighbour> old_neighbours) {
  search_mark_ = next_mark_;
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
void Components::start_search(std::uint32_t group) {
  const auto i = static_cast<std::uint32_t>(search_sets_.size());
  search_sets_.push_back(i);
  ++next_mark_;  // before any face gets this mark: if memory runs out below, no later search gets the same mark
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
void Components::search_beside(const mesh::TriangleMesh& mesh, std::uint32_t region) {
  alternating_.clear();
  add_searches_beside(groups_[region].first_search);
  for (;;) {
    list_unfinished(region);
    if (alternating_.size() <= 1) break;
    for (const std::uint32_t search : alternating_) step(mesh, root_of(search_sets_, search));
  }
  // If a later call joins this region to another one, it needs only the search of the unfinished set.
  std::uint32_t& first = groups_[root_of(regions_, region)].first_search;
  if (!alternating_.empty()) first = alternating_.front();
  searches_[first].next_of_region = first;
}

/// Adds all searches beside the region of a search to `alternating_`.
void Components::add_searches_beside(std::uint32_t search) {
  for (std::uint32_t i = searches_[search].next_of_region;; i = searches_[i].next_of_region) {
    alternating_.push_back(i);
    if (i == search) return;
  }
}

/// Keeps in `alternating_` one search of each unfinished set. If a set is finished, joins the regions beside its piece
/// to `region`, and adds the searches beside these regions.
void Components::list_unfinished(std::uint32_t region) {
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
void Components::join_regions_of(std::uint32_t set, std::uint32_t region) {
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
bool Components::is_finished(std::uint32_t set) {
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
void Components::step(const mesh::TriangleMesh& mesh, std::uint32_t set) {
  if (is_finished(set)) return;
  const std::uint32_t search = searches_[searches_[set].last_in_queue].next_in_queue;
  searches_[set].last_in_queue = search;
  const Face f = searches_[search].found[searches_[search].next++];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge h = mesh::half_edge(f, i);
    const Face other = mesh::face(mesh.twin(h));
    if (PointAgent::can_cross(mesh, h) && ids_[number(other)] != kNone) note_found(search, other);
  }
}

/// Records that `search` has found the face. If another search has found it before, unites the two searches.
void Components::note_found(std::uint32_t search, Face f) {
  const std::uint32_t found_by = mark(f);
  if (found_by < search_mark_) {
    set_mark(f, search_mark_ + search);
    searches_[search].found.push_back(f);
  } else {
    unite_searches(search, found_by - search_mark_);
  }
}

/// Unites the sets of two searches.
void Components::unite_searches(std::uint32_t i, std::uint32_t j) {
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
void Components::add_piece(std::uint32_t set, Id component) {
  const auto begin = static_cast<std::uint32_t>(piece_faces_.size());
  for (std::uint32_t i = searches_[set].next_of_set;; i = searches_[i].next_of_set) {
    piece_faces_.insert(piece_faces_.end(), searches_[i].found.begin(), searches_[i].found.end());
    if (i == set) break;
  }
  const auto end = static_cast<std::uint32_t>(piece_faces_.size());
  old_parts_.push_back({component, searches_[set].group, end - begin, true, begin, end});
}

}  // namespace waywright::nav
