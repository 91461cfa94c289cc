#include <algorithm>

#include "constraint/slot_sets.hpp"
#include "constraint/turns.hpp"
#include "nav/components.hpp"

// Computes which polygons cover a component. A component stores only which polygons cover it, not their winding
// numbers. Two facts decide whether a polygon covers the face beyond an edge: whether it covers the face in front of
// the edge, and which of its sides lie on the edge. The exception is a nonzero polygon that covers the face in front
// and whose winding number changes across the edge. For such a polygon, turns_around() computes the winding number
// along a chain of faces that leads out of the domain.

namespace waywright::nav {

using constraint::Side;
using constraint::UseLists;
using constraint::Uses;
using mesh::Face;
using mesh::HalfEdge;

namespace {

/// Returns whether `slots` contains `slot`. Requires: `slots` ascend.
bool contains(std::span<const std::uint32_t> slots, std::uint32_t slot) {
  return std::binary_search(slots.begin(), slots.end(), slot);
}

/// The index of the ring's corner whose exact position comes first in (x, y) order.
std::size_t first_corner(const constraint::ExactTriangulation& triangulation, std::span<const mesh::Vertex> ring) {
  const auto before = [&](mesh::Vertex p, mesh::Vertex q) { return triangulation.triangulation().comes_before(p, q); };
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), before) - ring.begin());
}

/// Follows one side of a polygon, edge by edge. At each vertex on the side except the last, calls visit(face) for the
/// two faces of each edge around the vertex, if the winding number changes across that edge and the polygon covers the
/// face. On entry `h` is a half-edge that starts at the side's first corner, and `turns` is the winding number in the
/// face of `h`. On return both describe the side's last corner in the same way.
template <class Winding, class Visit>
void visit_inner_faces(const constraint::ExactTriangulation& triangulation, const Winding& winding, std::uint32_t slot,
                       HalfEdge& h, std::int32_t& turns, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Side side = triangulation.items().side(slot);
  HalfEdge edge_back = mesh::kNoHalfEdge;
  while (mesh.origin(h) != side.to) {
    HalfEdge edge_ahead = mesh::kNoHalfEdge;
    std::int32_t turns_ahead = 0;
    const HalfEdge start = h;
    std::int32_t change = winding.across(h);
    do {
      if (change != 0) {
        if (winding.covers(turns)) visit(mesh::face(h));
        if (winding.covers(turns - change)) visit(mesh::face(mesh.twin(h)));
      }
      if (h != edge_back && triangulation.uses().contains(mesh.label(h), slot)) {
        edge_ahead = h;
        turns_ahead = turns;
      }
      h = mesh.next_around(h);
      change = winding.across(h);
      turns += change;
    } while (h != start);
    edge_back = mesh.twin(edge_ahead);
    h = mesh::next(edge_ahead);
    turns = turns_ahead;
  }
}

}  // namespace

/// Removes the removed polygons from all covers.
void Components::remove_from_covers(const Triangulation& triangulation, const Changes& changes) {
  for (const std::uint32_t polygon : changes.removed) {
    find_covered(triangulation.topology(), changes.made, polygon);
    for (const Id id : flooded_) set_cover(id, covers_.remove(records_[id].cover, polygon));
  }
}

/// Collects in `flooded_` the components of old faces that the polygon covered. The flood starts at the new faces. It
/// reaches every covered face, because the faces along all sides of the polygon have changed.
void Components::find_covered(const mesh::TriangleMesh& mesh, std::span<const Face> made, std::uint32_t polygon) {
  const std::uint32_t flood = next_mark_++;
  stack_.clear();
  flooded_.clear();
  const auto visit_neighbours = [&](Face f) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const Face other = mesh::face(mesh.twin(HalfEdge{3 * number(f) + side}));
      const Id id = ids_[number(other)];
      if (id == kNone || mark(other) == flood) continue;
      if (!covers_.contains(records_[id].cover, polygon)) continue;
      set_mark(other, flood);
      stack_.push_back(other);
      if (flooded_.empty() || flooded_.back() != id) flooded_.push_back(id);
    }
  };
  for (const Face f : made) visit_neighbours(f);
  while (!stack_.empty()) {
    const Face f = stack_.back();
    stack_.pop_back();
    visit_neighbours(f);
  }
  constraint::keep_one_of_each(flooded_);
}

void Components::set_cover(Id component, Uses cover) { records_.write(component, {records_[component].size, cover}); }

/// Returns a half-edge that starts at `v`, in a face in the domain. To the right of this half-edge lie only positions
/// that come before `v` in (x, y) order, or that lie outside the domain.
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
        for (std::uint32_t side = 0; side < 3; ++side) {
          const HalfEdge h{3 * number(faces_[k]) + side};
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
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdge beyond = mesh.twin(HalfEdge{3 * number(faces_[i]) + side});
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
  const Uses cover = cover_beyond(triangulation, beyond, changes.inserted);
  Group& added = groups_[group];
  added.id = add_record({added.end - added.begin, cover});
  for (std::uint32_t i = added.begin; i < added.end; ++i) set_id(faces_[i], added.id);
}

/// Returns the polygons that cover the face beyond `h`. Leaves out the polygons in `inserted`: no cover contains them
/// yet. Requires: the cover of the face of `h` is known, or it is a ghost face.
Uses Components::cover_beyond(const Triangulation& triangulation, HalfEdge h, std::span<const std::uint32_t> inserted) {
  const Id neighbour = component_of(mesh::face(h));
  polygons_.clear();
  if (neighbour != kNone) {
    covers_.for_each(records_[neighbour].cover, [&](std::uint32_t polygon) { polygons_.push_back(polygon); });
  }
  triangulation.for_each_side(h, [&](const Side& side) {
    if (triangulation.items().is_polygon(side.item) && !contains(inserted, side.item)) {
      polygons_.push_back(side.item);
    }
  });
  if (!triangulation.items().has_nonzero_polygons()) {
    constraint::keep_odd(polygons_);
  } else {
    constraint::keep_each_if(polygons_, [&](std::uint32_t polygon, std::size_t count) {
      if (triangulation.items().fill(polygon) == FillRule::even_odd) return count % 2 == 1;
      const bool is_here = neighbour != kNone && covers_.contains(records_[neighbour].cover, polygon);
      if (!constraint::Winding<FillRule::nonzero>(triangulation, polygon).changes_across(h)) return is_here;
      return !is_here || turns_around(triangulation, triangulation.topology().twin(h), polygon) != 0;
    });
  }
  Uses cover = UseLists::kNone;
  for (const std::uint32_t polygon : polygons_) cover = covers_.add(cover, polygon);
  return cover;
}

/// Adds the polygon to the cover of each component that lies inside it, by its fill rule.
void Components::cover_with(const Triangulation& triangulation, std::uint32_t polygon) {
  constraint::with_winding(triangulation, polygon, [&](const auto& winding) { cover_with(triangulation, winding); });
}

template <class Winding>
void Components::cover_with(const Triangulation& triangulation, const Winding& winding) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const std::uint32_t flood = next_mark_++;
  stack_.clear();
  flooded_.clear();
  const auto visit = [&](Face f) {
    if (mark(f) == flood) return;
    set_mark(f, flood);
    stack_.push_back(f);
    const Id id = ids_[number(f)];
    if (flooded_.empty() || flooded_.back() != id) flooded_.push_back(id);
  };
  const std::uint32_t polygon = winding.polygon();
  triangulation.items().outline(polygon, outline_);
  sides_.clear();
  triangulation.items().for_each_side(polygon, [&](std::uint32_t slot) { sides_.push_back(slot); });
  std::size_t ring_begin = 0;
  std::size_t sides_begin = 0;
  for (const std::uint32_t ring_end : outline_.ring_ends) {
    const std::size_t count = ring_end - ring_begin;
    const std::size_t first = first_corner(triangulation, {outline_.corners.data() + ring_begin, count});
    HalfEdge h = outer_half_edge(triangulation, outline_.corners[ring_begin + first]);
    // To the right of `h` there is no face between sides of this ring: its first corner is the origin of `h`. So with a
    // single ring the winding number there is 0. With several rings, this ring may lie inside another one.
    std::int32_t turns = outline_.ring_ends.size() == 1 ? winding.across(h) : turns_around(triangulation, h, polygon);
    for (std::size_t i = 0; count > 1 && i < count; ++i) {
      visit_inner_faces(triangulation, winding, sides_[sides_begin + (first + i) % count], h, turns, visit);
    }
    ring_begin = ring_end;
    sides_begin += count > 1 ? count : 0;
  }
  while (!stack_.empty()) {
    const Face f = stack_.back();
    stack_.pop_back();
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdge h{3 * number(f) + side};
      if (!winding.changes_across(h)) visit(mesh::face(mesh.twin(h)));
    }
  }
  constraint::keep_one_of_each(flooded_);
  for (const Id id : flooded_) set_cover(id, covers_.add(records_[id].cover, polygon));
}

}  // namespace waywright::nav
