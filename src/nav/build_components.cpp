#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "constraint/cover_finder.hpp"
#include "memory/count.hpp"
#include "nav/components.hpp"
#include "nav/point_agent.hpp"

// Builds the components of a mesh from scratch: first trees of connected faces, then a component of each tree.

namespace waywright::nav {

using mesh::Face;
using mesh::HalfEdge;

namespace {

/// The nonzero winding numbers of polygons, in ascending order of their slots.
using WindingNumbers = std::vector<std::pair<std::uint32_t, std::int32_t>>;

/// Returns the winding numbers in the face beyond `h`. `here` contains the winding numbers in the face of `h`.
WindingNumbers numbers_beyond(const constraint::ExactTriangulation& triangulation, const WindingNumbers& here,
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

}  // namespace

Components::Components(const Triangulation& triangulation) {
  memory::Array<Id> ids = join_faces(triangulation);
  number_components(ids);
  ids_ = memory::JournaledArray<Id>(std::move(ids));
  if (triangulation.items().has_polygons()) cover_components(triangulation);
  begin();
}

/// Returns the components as trees: for each face in the domain, another face of its component, or itself for a root.
/// Source: Galler and Fischer, *An improved equivalence algorithm*, CACM 1964.
memory::Array<Components::Id> Components::join_faces(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  memory::Array<Id> trees;
  trees.reserve(memory::with_spare(mesh.face_slots()));
  trees.resize(mesh.face_slots(), kNone);
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

/// Makes a component of each tree in `ids`, and replaces each entry by the id of its face's component.
void Components::number_components(memory::Array<Id>& ids) {
  for (std::uint32_t f = 0; f < ids.size(); ++f) {
    if (ids[f] == kNone) continue;
    const bool is_first = ids[f] == f;
    ids[f] = is_first ? add_record(0, CoverTree::kEmpty) : ids[ids[f]];
    ++records_.unrecorded(ids[f]).size;
  }
}

/// Computes the covers, component by component, from outside the domain inwards. If the world has nonzero polygons,
/// `known` keeps the winding numbers of each component until the loop has handled the neighbours of that component.
void Components::cover_components(const Triangulation& triangulation) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const bool has_nonzero = triangulation.items().has_nonzero_polygons();
  const std::vector<SeparatingWall> walls = find_separating_walls(mesh);
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

std::vector<Components::SeparatingWall> Components::find_separating_walls(const mesh::TriangleMesh& mesh) const {
  std::vector<SeparatingWall> walls;
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (!mesh.is_live(mesh::face(h)) || PointAgent::can_cross(mesh, h)) continue;
    const Id beyond = component_of(mesh::face(mesh.twin(h)));
    if (beyond != kNone && beyond != component_of(mesh::face(h))) walls.push_back({component_of(mesh::face(h)), h});
  }
  std::sort(walls.begin(), walls.end(),
            [](const SeparatingWall& a, const SeparatingWall& b) { return a.component < b.component; });
  return walls;
}

}  // namespace waywright::nav
