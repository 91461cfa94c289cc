#include "nav/components.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "constraint/cover_finder.hpp"
#include "constraint/slot_sets.hpp"
#include "memory/count.hpp"
#include "nav/point_agent.hpp"

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

namespace {

/// The nonzero winding numbers of polygons, in ascending order of their slots.
using WindingNumbers = std::vector<std::pair<std::uint32_t, std::int32_t>>;

/// Returns the winding numbers in the face beyond `h`. `here` contains the winding numbers in the face of `h`.
WindingNumbers numbers_beyond(const constraint::ConstrainedTriangulation& triangulation, const WindingNumbers& here,
                              HalfEdge h) {
  WindingNumbers numbers = here;
  triangulation.for_each_side(h, [&](const constraint::Side& side) {
    if (!triangulation.items().is_polygon(side.item)) return;
    numbers.emplace_back(side.item, constraint::runs_along(triangulation, side, h) ? -1 : 1);
  });
  std::sort(numbers.begin(), numbers.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < numbers.size();) {
    const std::uint32_t polygon = numbers[i].first;
    std::int32_t sum = 0;
    for (; i < numbers.size() && numbers[i].first == polygon; ++i) sum += numbers[i].second;
    if (sum != 0) numbers[kept++] = {polygon, sum};
  }
  numbers.resize(kept);
  return numbers;
}

/// Lists the polygons that cover a face but not its neighbour, and those that cover the neighbour but not the face.
/// `here` and `beyond` contain the winding numbers in the face and in its neighbour.
void compare_covers(const constraint::ItemTable& items, const WindingNumbers& here, const WindingNumbers& beyond,
                    std::vector<std::uint32_t>& removed, std::vector<std::uint32_t>& added) {
  removed.clear();
  added.clear();
  auto to = beyond.begin();
  const auto add = [&](const WindingNumbers::value_type& entry, std::vector<std::uint32_t>& list) {
    if (items.covers(entry.first, entry.second)) list.push_back(entry.first);
  };
  for (const auto& from : here) {
    for (; to != beyond.end() && to->first < from.first; ++to) add(*to, added);
    const bool was_covered = items.covers(from.first, from.second);
    const bool is_in_both = to != beyond.end() && to->first == from.first;
    const bool is_covered = is_in_both && items.covers(to->first, to->second);
    if (was_covered != is_covered) (was_covered ? removed : added).push_back(from.first);
    if (is_in_both) ++to;
  }
  for (; to != beyond.end(); ++to) add(*to, added);
}

/// Returns the components as trees: for each face in the domain, another face of its component, or itself for a root.
/// Source: Galler and Fischer, *An improved equivalence algorithm*, CACM 1964.
memory::Array<Components::Id> join_faces(const Components::Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  memory::Array<Components::Id> trees;
  trees.reserve(memory::with_spare(mesh.face_slots()));
  trees.resize(mesh.face_slots(), Components::kNone);
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!triangulation.triangulation().is_in_domain(Face{f})) continue;
    trees[f] = f;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge h{3 * f + k};
      const Face other = mesh::face(mesh.twin(h));
      if (number(other) < f && PointAgent::can_cross(mesh, h)) unite(trees, f, number(other));
    }
  }
  return trees;
}

/// A half-edge on a wall between two components. Its face is in `component`, or is a ghost face: then `component` is
/// kNone.
struct SeparatingWall {
  Components::Id component;
  mesh::HalfEdge h;
};

std::vector<SeparatingWall> find_separating_walls(const Components& components, const mesh::TriangleMesh& mesh) {
  std::vector<SeparatingWall> walls;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (!mesh.is_live(mesh::face(h)) || PointAgent::can_cross(mesh, h)) continue;
    const Components::Id beyond = components.component_of(mesh::face(mesh.twin(h)));
    if (beyond != Components::kNone && beyond != components.component_of(mesh::face(h)))
      walls.push_back({components.component_of(mesh::face(h)), h});
  }
  std::sort(walls.begin(), walls.end(),
            [](const SeparatingWall& a, const SeparatingWall& b) { return a.component < b.component; });
  return walls;
}

}  // namespace

// Builds the components from scratch: first trees of connected faces, then a component of each tree.
Components::Components(const Triangulation& triangulation) {
  memory::Array<Id> ids = join_faces(triangulation);
  number_components(ids);
  ids_ = memory::JournaledArray<Id>(std::move(ids));
  if (triangulation.items().has_polygons()) cover_components(triangulation);
  begin();
}

/// Makes a component of each tree in `ids`, and replaces each entry by the id of its face's component.
void Components::number_components(memory::Array<Id>& ids) {
  for (std::uint32_t f = 0; f < ids.size(); ++f) {
    if (ids[f] == kNone) continue;
    const bool is_first = ids[f] == f;
    ids[f] = is_first ? add(0, CoverTree::kEmpty) : ids[ids[f]];
    ++records_.unrecorded(ids[f]).size;
  }
}

/// Computes the covers, component by component, from outside the domain inwards. If the world has nonzero polygons,
/// `known` keeps the winding numbers of each component until the loop has handled the neighbours of that component.
void Components::cover_components(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const bool has_nonzero = triangulation.items().has_nonzero_polygons();
  const std::vector<SeparatingWall> walls = find_separating_walls(*this, mesh);
  std::vector<bool> is_known(records_.size());
  std::vector<std::pair<Id, WindingNumbers>> known(1, {kNone, {}});
  const auto comes_before = [](const SeparatingWall& wall, Id component) { return wall.component < component; };
  for (std::size_t i = 0; i < known.size(); ++i) {
    const auto [component, here] = std::move(known[i]);
    auto wall = std::lower_bound(walls.begin(), walls.end(), component, comes_before);
    for (; wall != walls.end() && wall->component == component; ++wall) {
      const Id beyond = component_of(mesh::face(mesh.twin(wall->h)));
      if (is_known[beyond]) continue;
      is_known[beyond] = true;
      known.emplace_back(beyond, has_nonzero ? numbers_beyond(triangulation, here, wall->h) : WindingNumbers());
      if (!has_nonzero) {
        set_cover(beyond, cover_beyond(triangulation, wall->h, {}));
      } else {
        compare_covers(triangulation.items(), here, known.back().second, removed_, added_);
        const Set cover = component == kNone ? CoverTree::kEmpty : records_[component].cover;
        set_cover(beyond, covers_.change(cover, removed_, added_));
      }
      begin();  // empties the logs: there is no earlier state to go back to
    }
  }
}

Components::Id Components::add(std::uint32_t size, Set cover) {
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

void Components::remove(Id component) {
  const Set cover = records_[component].cover;
  unlink_cover(component);
  covers_.free_unused(cover);
  records_.write(component, {free_records_.first()});
  (void)free_records_.push(component);
  ++free_count_;
}

void Components::remove_from_covers(std::span<const std::uint32_t> polygons) {
  for (const std::uint32_t polygon : polygons) {
    while (covers_.is_used(polygon)) {
      const Set node = covers_.first_node(polygon);
      const Id component = covers_.first_component(node);
      if (component == kNone) {
        covers_.remove(node);
      } else {
        set_cover(component, covers_.parent(node));
      }
    }
  }
}

void Components::set_cover(Id component, Set cover) {
  const Set old = records_[component].cover;
  if (old == cover) return;
  unlink_cover(component);
  link_cover(component, cover);
  covers_.free_unused(old);
}

/// Sets the cover of a component without a cover.
void Components::link_cover(Id component, Set cover) {
  if (cover == CoverTree::kEmpty) return;
  const Id next = covers_.first_component(cover);
  if (next != kNone) {
    Record record = records_[next];
    record.previous = component;
    records_.write(next, record);
  }
  records_.write(component, {records_[component].size, cover, next, kNone});
  covers_.set_first_component(cover, component);
}

/// Makes the cover of a component empty. The old cover may then be unused.
void Components::unlink_cover(Id component) {
  const Record old = records_[component];
  if (old.cover == CoverTree::kEmpty) return;
  if (old.previous == kNone) {
    covers_.set_first_component(old.cover, old.next);
  } else {
    Record record = records_[old.previous];
    record.next = old.next;
    records_.write(old.previous, record);
  }
  if (old.next != kNone) {
    Record record = records_[old.next];
    record.previous = old.previous;
    records_.write(old.next, record);
  }
  records_.write(component, {old.size});
}

// A component stores only which polygons cover
// it, not their winding numbers. Two facts decide whether a polygon covers the face beyond an edge: whether it covers
// the face in front of the edge, and which of its sides lie on the edge. The exception is a nonzero polygon that covers
// the face in front and whose winding number changes across the edge. For such a polygon, winding_number() computes the
// winding number along a chain of faces that leads out of the domain.
Components::Set Components::cover_beyond(const Triangulation& triangulation, HalfEdge h,
                                         std::span<const std::uint32_t> inserted) {
  const Id neighbour = component_of(mesh::face(h));
  const Set cover = neighbour == kNone ? CoverTree::kEmpty : records_[neighbour].cover;
  polygons_.clear();
  triangulation.for_each_side(h, [&](const constraint::Side& side) {
    if (triangulation.items().is_polygon(side.item) &&
        !std::binary_search(inserted.begin(), inserted.end(), side.item)) {
      polygons_.push_back(side.item);
    }
  });
  removed_.clear();
  added_.clear();
  std::sort(polygons_.begin(), polygons_.end());
  covers_.find_contained(cover, polygons_, contained_);
  constraint::keep_each_if(polygons_, [&](std::uint32_t polygon, std::size_t count) {
    const bool is_here = std::binary_search(contained_.begin(), contained_.end(), polygon);
    bool is_beyond = is_here;
    if (triangulation.items().fill(polygon) == FillRule::even_odd) {
      is_beyond = is_here != (count % 2 == 1);
    } else if (constraint::Winding<FillRule::nonzero>(triangulation, polygon).changes_across(h)) {
      is_beyond = !is_here || constraint::winding_number(triangulation, triangulation.topology().twin(h), polygon) != 0;
    }
    if (is_here != is_beyond) (is_here ? removed_ : added_).push_back(polygon);
    return false;
  });
  return covers_.change(cover, removed_, added_);
}

std::optional<std::string> Components::find_difference(const Components& other, std::span<const Face> faces) const {
  if (count() != other.count()) return "the abstraction has another number of components";
  std::unordered_map<Id, Id> names;
  std::vector<std::uint32_t> cover;
  std::vector<std::uint32_t> other_cover;
  for (const Face f : faces) {
    const auto [name, is_new] = names.emplace(component_of(f), other.component_of(f));
    const std::string where = "face " + std::to_string(number(f));
    if (name->second != other.component_of(f)) return where + " is in another component";
    if (!is_new) continue;
    if (size(component_of(f)) != other.size(other.component_of(f)))
      return "the component of " + where + " has another size";
    cover.clear();
    other_cover.clear();
    for_each_cover(f, [&](std::uint32_t item) { cover.push_back(item); });
    other.for_each_cover(f, [&](std::uint32_t item) { other_cover.push_back(item); });
    std::sort(cover.begin(), cover.end());
    std::sort(other_cover.begin(), other_cover.end());
    if (cover != other_cover) return "the component of " + where + " is covered by other polygons";
  }
  // There are as many names as components, so no two components share a name.
  if (names.size() != count()) return "the abstraction misses a component";
  return std::nullopt;
}

void Components::begin() {
  covers_.begin();
  ids_.begin();
  records_.begin();
  free_records_.begin();
  free_count_before_ = free_count_;
}

void Components::roll_back() {
  covers_.roll_back();
  ids_.roll_back();
  records_.roll_back();
  free_records_.roll_back();
  free_count_ = free_count_before_;
}

void Components::count_memory(MemoryUse& use) const {
  ids_.count_memory(use, &MemoryUse::abstraction);
  records_.count_memory(use, &MemoryUse::abstraction);
  covers_.count_memory(use, &MemoryUse::abstraction);
  memory::count_spare(use, polygons_, contained_, removed_, added_);
}

void Components::shrink_to_fit() {
  ids_.shrink_to_fit();
  records_.shrink_to_fit();
  covers_.shrink_to_fit();
  memory::release(polygons_, contained_, removed_, added_);
}

}  // namespace waywright::nav
