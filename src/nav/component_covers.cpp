#include <algorithm>

#include "constraint/cover_finder.hpp"
#include "constraint/slot_sets.hpp"
#include "nav/components.hpp"

// Computes which polygons cover a component, apart from inserted polygons. A component stores only which polygons cover
// it, not their winding numbers. Two facts decide whether a polygon covers the face beyond an edge: whether it covers
// the face in front of the edge, and which of its sides lie on the edge. The exception is a nonzero polygon that covers
// the face in front and whose winding number changes across the edge. For such a polygon, winding_number() computes the
// winding number along a chain of faces that leads out of the domain.

namespace waywright::nav {

using constraint::Side;
using mesh::Face;
using mesh::HalfEdge;

namespace {

/// Returns whether `slots` contains `slot`. Requires: `slots` ascend.
bool contains(std::span<const std::uint32_t> slots, std::uint32_t slot) {
  return std::binary_search(slots.begin(), slots.end(), slot);
}

}  // namespace

/// Removes the polygons in `changes.removed` from all covers.
void Components::remove_from_covers(const Changes& changes) {
  for (const std::uint32_t polygon : changes.removed) {
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

/// Returns a half-edge that starts at `v`, in a face in the domain. The positions directly to the right of this
/// half-edge come before `v` in (x, y) order, or lie outside the domain.
HalfEdge Components::outer_half_edge(const Triangulation& triangulation, mesh::Vertex v) {
  constraint::faces_at(triangulation, {locate::LocatedKind::vertex, triangulation.topology().outgoing(v)}, around_);
  return around_.front();
}

/// Makes a new component of each group that is not connected to an old face.
void Components::cover_new_groups(const Triangulation& triangulation, const Changes& changes) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    if (groups_[i].id != kNone || !cover_from_beyond(triangulation, changes, i)) continue;
    for (reached_.assign(1, i); !reached_.empty();) {
      const Group group = groups_[reached_.back()];
      reached_.pop_back();
      for (std::uint32_t k = group.begin; k < group.end; ++k) {
        for (std::uint32_t j = 0; j < 3; ++j) {
          const HalfEdge h = mesh::half_edge(faces_[k], j);
          const std::uint32_t other = mark(mesh::face(mesh.twin(h))) - group_mark_;
          if (other >= groups_.size() || groups_[other].id != kNone) continue;
          cover_group(triangulation, changes, other, h);
          reached_.push_back(other);
        }
      }
    }
  }
}

/// Looks for a neighbour of the group that has a known cover or is a ghost face, and computes the group's cover from
/// it. Returns whether there is such a neighbour.
bool Components::cover_from_beyond(const Triangulation& triangulation, const Changes& changes, std::uint32_t group) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t i = groups_[group].begin; i < groups_[group].end; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge beyond = mesh.twin(mesh::half_edge(faces_[i], k));
      if (ids_[number(beyond) / 3] == kNone && !triangulation.triangulation().is_ghost_face(beyond)) continue;
      cover_group(triangulation, changes, group, beyond);
      return true;
    }
  }
  return false;
}

/// Makes a component of the group and computes its cover. `beyond` is a half-edge on the group's border, in the face
/// outside the group. Requires: the cover of that face is known, or it is a ghost face.
void Components::cover_group(const Triangulation& triangulation, const Changes& changes, std::uint32_t group,
                             HalfEdge beyond) {
  const Set cover = cover_beyond(triangulation, beyond, changes.inserted);
  Group& added = groups_[group];
  added.id = add_record(added.end - added.begin, cover);
  for (std::uint32_t i = added.begin; i < added.end; ++i) set_id(faces_[i], added.id);
}

/// Returns the polygons that cover the face beyond `h`. Leaves out the polygons in `inserted`: no cover contains them
/// yet. Requires: the cover of the face of `h` is known, or it is a ghost face.
Components::Set Components::cover_beyond(const Triangulation& triangulation, HalfEdge h,
                                         std::span<const std::uint32_t> inserted) {
  const Id neighbour = component_of(mesh::face(h));
  const Set cover = neighbour == kNone ? CoverTree::kEmpty : records_[neighbour].cover;
  polygons_.clear();
  triangulation.for_each_side(h, [&](const Side& side) {
    if (triangulation.items().is_polygon(side.item) && !contains(inserted, side.item)) {
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
      is_beyond = !is_here || winding_number(triangulation, triangulation.topology().twin(h), polygon) != 0;
    }
    if (is_here != is_beyond) (is_here ? removed_ : added_).push_back(polygon);
    return false;
  });
  return covers_.change(cover, removed_, added_);
}

}  // namespace waywright::nav
