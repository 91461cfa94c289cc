#include <algorithm>

#include "constraint/slot_sets.hpp"
#include "constraint/turns.hpp"
#include "nav/components.hpp"

// Which polygons cover a component. What a component keeps of a polygon is whether it covers it, not its winding
// number. Across an edge, cover follows from that and from the polygon's sides on the edge, unless the polygon is a
// nonzero one that turns around the known face and has sides there. Then the winding number is found on a way out of
// the domain.

namespace waywright::nav {

using constraint::Side;
using constraint::UseLists;
using constraint::Uses;
using mesh::Face;
using mesh::HalfEdge;

namespace {

/// Requires: the slots ascend.
bool contains(std::span<const std::uint32_t> slots, std::uint32_t slot) {
  return std::binary_search(slots.begin(), slots.end(), slot);
}

/// The vertex of the ring that comes first in (x, y) order, by its position.
std::size_t first_corner(const constraint::ExactTriangulation& triangulation, std::span<const mesh::Vertex> ring) {
  const auto before = [&](mesh::Vertex p, mesh::Vertex q) { return triangulation.triangulation().comes_before(p, q); };
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), before) - ring.begin());
}

/// Goes along the edges of one side of a polygon and calls visit(face) for each face that the polygon covers at an edge
/// on which its winding number changes. `h` starts at the side's first corner, `turns` is the winding number around its
/// face; both are then so for the side's last corner.
template <class Winding, class Visit>
void visit_inner_faces(const constraint::ExactTriangulation& triangulation, const Winding& winding, std::uint32_t slot,
                       HalfEdge& h, std::int32_t& turns, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Side side = triangulation.items().side(slot);
  HalfEdge came = mesh::kNoHalfEdge;
  while (mesh.origin(h) != side.to) {
    HalfEdge on = mesh::kNoHalfEdge;
    std::int32_t turns_on = 0;
    const HalfEdge start = h;
    std::int32_t change = winding.across(h);
    do {
      if (change != 0) {
        if (winding.covers(turns)) visit(mesh::face(h));
        if (winding.covers(turns - change)) visit(mesh::face(mesh.twin(h)));
      }
      if (h != came && triangulation.uses().contains(mesh.label(h), slot)) {
        on = h;
        turns_on = turns;
      }
      h = mesh.next_around(h);
      change = winding.across(h);
      turns += change;
    } while (h != start);
    came = mesh.twin(on);
    h = mesh::next(on);
    turns = turns_on;
  }
}

}  // namespace

/// What went covers nothing any more.
void Components::drop_removed(const Triangulation& triangulation, const Changes& changes) {
  for (const std::uint32_t polygon : changes.removed) {
    find_covered(triangulation.topology(), changes.made, polygon);
    for (const Label label : flooded_) set_cover(label, covers_.remove(records_[label].cover, polygon));
  }
}

/// Finds the components of old faces that the polygon covered. They are reached from the new faces: all along its sides
/// faces have changed.
void Components::find_covered(const mesh::TriangleMesh& mesh, std::span<const Face> made, std::uint32_t polygon) {
  const std::uint32_t flood = next_mark_++;
  stack_.clear();
  flooded_.clear();
  const auto visit_neighbours = [&](Face f) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const Face other = mesh::face(mesh.twin(HalfEdge{3 * number(f) + side}));
      const Label label = labels_[number(other)];
      if (label == kNone || mark(other) == flood) continue;
      if (!covers_.contains(records_[label].cover, polygon)) continue;
      set_mark(other, flood);
      stack_.push_back(other);
      if (flooded_.empty() || flooded_.back() != label) flooded_.push_back(label);
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

void Components::set_cover(Label component, Uses cover) {
  records_.write(component, {records_[component].size, cover});
}

/// A half-edge from a vertex, in a face of the box, with nothing but what comes before the vertex on its right, or what
/// is beyond the box.
HalfEdge Components::outer_half_edge(const Triangulation& triangulation, mesh::Vertex v) {
  constraint::faces_at(triangulation, {locate::Spot::vertex, triangulation.topology().outgoing(v)}, around_);
  return around_.front();
}

/// Gives components of their own to the groups that no old face is joined to.
void Components::cover_new_groups(const Triangulation& triangulation, const Changes& changes) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t i = 0; i < groups_.size(); ++i) {
    if (groups_[i].label != kNone || !cover_from_beyond(triangulation, changes, i)) continue;
    for (reached_.assign(1, i); !reached_.empty();) {
      const Group group = groups_[reached_.back()];
      reached_.pop_back();
      for (std::uint32_t k = group.begin; k < group.end; ++k) {
        for (std::uint32_t side = 0; side < 3; ++side) {
          const HalfEdge h{3 * number(faces_[k]) + side};
          const std::uint32_t other = mark(mesh::face(mesh.twin(h))) - group_mark_;
          if (other >= groups_.size() || groups_[other].label != kNone) continue;
          cover_group(triangulation, changes, other, h);
          reached_.push_back(other);
        }
      }
    }
  }
}

/// Finds the group a neighbour that has its cover. Returns whether there is one.
bool Components::cover_from_beyond(const Triangulation& triangulation, const Changes& changes, std::uint32_t group) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  for (std::uint32_t i = groups_[group].begin; i < groups_[group].end; ++i) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdge beyond = mesh.twin(HalfEdge{3 * number(faces_[i]) + side});
      if (labels_[number(beyond) / 3] == kNone && !triangulation.triangulation().is_ghost_face(beyond)) continue;
      cover_group(triangulation, changes, group, beyond);
      return true;
    }
  }
  return false;
}

/// `beyond` is a half-edge to the group in a neighbour that has its cover, or in a ghost face.
void Components::cover_group(const Triangulation& triangulation, const Changes& changes, std::uint32_t group,
                             HalfEdge beyond) {
  const Uses cover = cover_beyond(triangulation, beyond, changes.inserted);
  Group& added = groups_[group];
  added.label = add_record({added.end - added.begin, cover});
  for (std::uint32_t i = added.begin; i < added.end; ++i) write_label(faces_[i], added.label);
}

/// What covers the face beyond `h`, a half-edge of one whose cover is known or of a ghost face. What came lately is
/// left out; it covers nothing yet.
Uses Components::cover_beyond(const Triangulation& triangulation, HalfEdge h, std::span<const std::uint32_t> inserted) {
  const Label neighbour = of(mesh::face(h));
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

/// Adds a polygon to what it covers: the faces between its sides.
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
    const Label label = labels_[number(f)];
    if (flooded_.empty() || flooded_.back() != label) flooded_.push_back(label);
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
    // To the right of that half-edge nothing of the ring is left. With other rings the ring may lie within them.
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
  for (const Label label : flooded_) set_cover(label, covers_.add(records_[label].cover, polygon));
}

}  // namespace waywright::nav
