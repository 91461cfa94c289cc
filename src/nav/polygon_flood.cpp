#include "nav/polygon_flood.hpp"

#include <algorithm>
#include <utility>

#include "constraint/slot_sets.hpp"
#include "memory/count.hpp"

// The flood starts at the faces along the boundary of the polygon. A polygon is *enclosed* if it lies inside the
// inserted polygon, does not touch its boundary, and both have one ring. The code does not flood polygons that are
// enclosed: in the tree of covers (CoverTree), a node represents the set of its parent and one more polygon, which it
// *adds*. The code gives a new parent to the nodes that add an enclosed polygon to the set of their parent. The new
// parent adds the inserted polygon. So the cost of a polygon around other polygons depends only on the faces that no
// enclosed polygon covers, however many polygons are enclosed.

namespace waywright::nav {

using constraint::Side;
using mesh::Face;
using mesh::HalfEdge;

namespace {

/// The index of the ring's corner whose exact position comes first in (x, y) order.
std::size_t first_corner(const constraint::ConstrainedTriangulation& triangulation,
                         std::span<const mesh::Vertex> ring) {
  const auto before = [&](mesh::Vertex p, mesh::Vertex q) { return triangulation.triangulation().comes_before(p, q); };
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), before) - ring.begin());
}

/// Follows one side of a polygon, edge by edge. At each vertex on the side except the last, calls visit(face) for the
/// two faces of each edge around the vertex, if the winding number changes across that edge and the polygon covers the
/// face. On entry `h` is a half-edge that starts at the side's first corner, and `here` is the winding number in the
/// face of `h`. On return, `h` starts at the side's last corner, and `here` is the winding number in the face of the
/// new `h`.
template <class Winding, class Visit>
void visit_inner_faces(const constraint::ConstrainedTriangulation& triangulation, const Winding& winding,
                       std::uint32_t slot, HalfEdge& h, std::int32_t& here, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Side side = triangulation.items().side(slot);
  HalfEdge edge_back = mesh::kNoHalfEdge;
  while (mesh.origin(h) != side.to) {
    HalfEdge edge_ahead = mesh::kNoHalfEdge;
    std::int32_t ahead = 0;
    const HalfEdge start = h;
    std::int32_t change = winding.across(h);
    do {
      if (change != 0) {
        if (winding.covers(here)) visit(mesh::face(h));
        if (winding.covers(here - change)) visit(mesh::face(mesh.twin(h)));
      }
      if (h != edge_back && triangulation.uses().contains(mesh.label(h), slot)) {
        edge_ahead = h;
        ahead = here;
      }
      h = mesh.next_around(h);
      change = winding.across(h);
      here += change;
    } while (h != start);
    edge_back = mesh.twin(edge_ahead);
    h = mesh::next(edge_ahead);
    here = ahead;
  }
}

/// Calls visit(h) for each edge on which a side lies, with a half-edge in the direction of the side.
template <class Visit>
void follow_side(const constraint::ConstrainedTriangulation& triangulation, std::uint32_t slot, Visit&& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Side side = triangulation.items().side(slot);
  HalfEdge back = mesh::kNoHalfEdge;
  for (mesh::Vertex v = side.from; v != side.to; v = mesh.origin(back)) {
    HalfEdge h = mesh.outgoing(v);
    while (h == back || !triangulation.uses().contains(mesh.label(h), slot)) h = mesh.next_around(h);
    visit(h);
    back = mesh.twin(h);
  }
}

/// The winding numbers of a polygon. If many sides lie on an edge, the class does not look for the polygon's sides
/// among them: it collects all edges of the polygon once, in `edges`.
template <class Winding>
class WindingOfSides {
 public:
  /// An edge, as the lower of its two half-edges, and the change of the winding number across this half-edge.
  using Edge = std::pair<HalfEdge, std::int32_t>;

  WindingOfSides(const constraint::ConstrainedTriangulation& triangulation, const Winding& winding,
                 std::vector<Edge>& edges)
      : triangulation_(triangulation), winding_(winding), edges_(edges) {
    edges_.clear();
  }

  [[nodiscard]] static bool covers(std::int32_t winding_number) { return Winding::covers(winding_number); }
  [[nodiscard]] bool changes_across(HalfEdge h) const { return covers(across(h)); }
  [[nodiscard]] std::int32_t across(HalfEdge h) const {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    if (!triangulation_.uses().has_many(mesh.label(h))) return winding_.across(h);
    if (edges_.empty()) collect();
    const HalfEdge lower = std::min(h, mesh.twin(h));
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), lower,
                                     [](const Edge& edge, HalfEdge half) { return edge.first < half; });
    if (at == edges_.end() || at->first != lower) return 0;
    return lower == h ? at->second : -at->second;
  }

 private:
  void collect() const {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    triangulation_.items().for_each_side(winding_.polygon(), [&](std::uint32_t slot) {
      follow_side(triangulation_, slot, [&](HalfEdge h) {
        const HalfEdge t = mesh.twin(h);
        edges_.push_back({std::min(h, t), h < t ? 1 : -1});
      });
    });
    std::sort(edges_.begin(), edges_.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges_.size();) {
      Edge edge{edges_[i].first, 0};
      for (; i < edges_.size() && edges_[i].first == edge.first; ++i) edge.second += edges_[i].second;
      edges_[kept++] = edge;
    }
    edges_.resize(kept);
  }

  const constraint::ConstrainedTriangulation& triangulation_;
  const Winding& winding_;
  std::vector<Edge>& edges_;
};

}  // namespace

/// Adds the inserted polygons to the covers. If a polygon encloses another one, its first corner comes first in (x, y)
/// order. So the function begins with the polygon whose first corner comes last: then the covers contain all enclosed
/// polygons before it handles the polygon around them.
void PolygonFlood::cover_with_all(Components& components, FaceMarks& marks,
                                  const constraint::ConstrainedTriangulation& triangulation,
                                  std::span<const std::uint32_t> inserted) {
  components_ = &components;
  marks_ = &marks;
  triangulation_ = &triangulation;
  inserted_ = inserted;
  are_in_covers_.clear();
  to_cover_.clear();
  for (const std::uint32_t polygon : inserted) {
    triangulation_->items().outline(polygon, outline_);
    to_cover_.push_back({outline_.corners[first_corner(*triangulation_, outline_.corners)], polygon});
  }
  std::sort(to_cover_.begin(), to_cover_.end(), [&](const ToCover& p, const ToCover& q) {
    return p.first_corner != q.first_corner
               ? triangulation_->triangulation().comes_before(q.first_corner, p.first_corner)
               : p.polygon < q.polygon;
  });
  for (const ToCover& next : to_cover_) {
    cover_with(next);
    are_in_covers_.insert(next.polygon);
  }
}

/// Adds a polygon to the cover of each component that lies inside it, by its fill rule. Of the inserted polygons, the
/// covers already contain those in `are_in_covers_`.
void PolygonFlood::cover_with(const ToCover& next) {
  covering_ = next.polygon;
  flood_ = marks_->next();
  stack_.clear();
  flooded_.clear();
  enclosed_.clear();
  touching_.clear();
  tested_.clear();
  is_enclosed_.clear();
  knows_touching_ = false;
  constraint::with_winding(*triangulation_, next.polygon, [&](const auto& winding_of_all) {
    const WindingOfSides winding(*triangulation_, winding_of_all, edges_);
    visit_boundary(winding, next.first_corner);
    cover_at_boundary_ = flooded_.empty() ? CoverTree::kEmpty : components_->cover(flooded_.front());
    flood(winding);
    for (std::size_t i = 0; i < enclosed_.size(); ++i) {
      visit_around(enclosed_[i]);
      flood(winding);
    }
  });
  add_to_covers();
}

void PolygonFlood::visit(Face f) {
  if (marks_->get(f) == flood_) return;
  marks_->set(f, flood_);
  stack_.push_back(f);
  const Components::Id id = components_->component_of(f);
  if (flooded_.empty() || flooded_.back() != id) flooded_.push_back(id);
}

/// Visits the faces inside the polygon along its sides. `first_of_all` is the first corner of the polygon in (x, y)
/// order.
template <class Winding>
void PolygonFlood::visit_boundary(const Winding& winding, mesh::Vertex first_of_all) {
  triangulation_->items().outline(covering_, outline_);
  sides_.clear();
  triangulation_->items().for_each_side(covering_, [&](std::uint32_t slot) { sides_.push_back(slot); });
  may_enclose_ = outline_.ring_ends.size() == 1;
  std::size_t ring_begin = 0;
  std::size_t sides_begin = 0;
  std::span<const mesh::Vertex> last_ring;
  for (const std::uint32_t ring_end : outline_.ring_ends) {
    const std::size_t count = ring_end - ring_begin;
    const std::span<const mesh::Vertex> ring(outline_.corners.data() + ring_begin, count);
    if (std::equal(ring.begin(), ring.end(), last_ring.begin(), last_ring.end())) {
      ring_begin = ring_end;
      sides_begin += count > 1 ? count : 0;
      continue;  // there are the same faces along both rings
    }
    last_ring = ring;
    const std::size_t first = first_corner(*triangulation_, ring);
    HalfEdge h = outer_half_edge(outline_.corners[ring_begin + first]);
    // The origin of `h` is the ring's first corner in (x, y) order. By outer_half_edge(), the positions directly on the
    // right of `h` come before this corner or lie outside the domain. So the face on the right of `h` lies outside this
    // ring. If the polygon has only this ring, the winding number in that face is 0. If it has several rings, this ring
    // may lie inside another one.
    std::int32_t here =
        may_enclose_ ? winding.across(h) : constraint::winding_number(*triangulation_, h, covering_, first_of_all);
    for (std::size_t i = 0; count > 1 && i < count; ++i) {
      visit_inner_faces(*triangulation_, winding, sides_[sides_begin + (first + i) % count], h, here,
                        [&](Face f) { visit(f); });
    }
    ring_begin = ring_end;
    sides_begin += count > 1 ? count : 0;
  }
}

template <class Winding>
void PolygonFlood::flood(const Winding& winding) {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  while (!stack_.empty()) {
    const Face f = stack_.back();
    stack_.pop_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge h = mesh::half_edge(f, k);
      if (!mesh.is_fixed(h) || (!winding.changes_across(h) && !is_on_enclosed(h))) {
        visit(mesh::face(mesh.twin(h)));
      }
    }
  }
}

/// Whether a side of an enclosed polygon lies on the edge.
bool PolygonFlood::is_on_enclosed(HalfEdge h) {
  if (!may_enclose_) return false;
  bool is_found = false;
  triangulation_->for_each_side(h, [&](const Side& side) {
    if (!triangulation_->items().is_polygon(side.item) || side.item == covering_) return;
    is_found = is_enclosed(side.item) || is_found;
  });
  return is_found;
}

/// Whether a polygon is enclosed. Requires: it has a side inside the polygon `covering_`. If both polygons have one
/// ring, the boundary of each is one connected curve. So if the boundaries do not touch, all of `polygon` lies inside
/// `covering_`.
bool PolygonFlood::is_enclosed(std::uint32_t polygon) {
  if (!tested_.insert(polygon)) return is_enclosed_.contains(polygon);
  if (!knows_touching_) collect_touching();
  const bool is_in_covers =
      are_in_covers_.contains(polygon) || !std::binary_search(inserted_.begin(), inserted_.end(), polygon);
  if (!may_enclose_ || !is_in_covers || touching_.contains(polygon) || !triangulation_->items().has_one_ring(polygon)) {
    return false;
  }
  is_enclosed_.insert(polygon);
  enclosed_.push_back(polygon);
  return true;
}

/// Collects the polygons with a side or corner on the boundary of the polygon. If very many sides lie there, the search
/// for enclosed polygons would cost more than it saves. Then the function gives up this search.
void PolygonFlood::collect_touching() {
  const mesh::TriangleMesh& mesh = triangulation_->topology();
  knows_touching_ = true;
  std::size_t budget = 256 + 64 * sides_.size();
  const auto add = [&](std::uint32_t item) {
    if (triangulation_->items().is_polygon(item) && budget > 0) touching_.insert(item);
    budget -= budget > 0 ? 1 : 0;
  };
  for (const std::uint32_t slot : sides_) {
    if (budget == 0) break;
    follow_side(*triangulation_, slot, [&](HalfEdge along) {
      if (budget == 0) return;
      triangulation_->uses().for_each(triangulation_->corner_uses(mesh.origin(along)), add);
      mesh.for_each_outgoing(mesh.origin(along), [&](HalfEdge h) {
        triangulation_->for_each_side(h, [&](const Side& side) { add(side.item); });
      });
    });
  }
  if (budget == 0) may_enclose_ = false;
}

/// Visits the faces along the sides of an enclosed polygon, if no enclosed polygon covers them. Enclosed polygons can
/// separate such a face from all faces that the flood has reached. Only this function finds it.
void PolygonFlood::visit_around(std::uint32_t enclosed) {
  Components::Id last = Components::kNone;
  const auto visit_if_not_enclosed = [&](Face f) {
    if (components_->component_of(f) == Components::kNone || components_->component_of(f) == last) return;
    if (is_covered_by_enclosed(components_->cover(components_->component_of(f)))) {
      last = components_->component_of(f);
    } else {
      visit(f);
    }
  };
  triangulation_->items().for_each_side(enclosed, [&](std::uint32_t slot) {
    follow_side(*triangulation_, slot, [&](HalfEdge h) {
      visit_if_not_enclosed(mesh::face(h));
      visit_if_not_enclosed(mesh::face(triangulation_->topology().twin(h)));
    });
  });
}

// No enclosed polygon covers a face at the boundary of the polygon `covering_`, so the search ends at the cover of such
// a face. Hence the cost does not depend on the number of polygons that cover `covering_`.
bool PolygonFlood::is_covered_by_enclosed(Set cover) const {
  return std::as_const(*components_).covers().has_any(cover, cover_at_boundary_, [&](std::uint32_t p) {
    return is_enclosed_.contains(p);
  });
}

/// Changes two kinds of references: the cover of each flooded component that no enclosed polygon covers, and the parent
/// of each node that adds an enclosed polygon, if the set of the parent contains no enclosed polygon. For each set that
/// is such a cover or the set of such a parent, the function makes one new node, which adds the inserted polygon to
/// this set. The references then refer to the new node. So all descendants of a moved node get the inserted polygon,
/// too.
void PolygonFlood::add_to_covers() {
  constraint::keep_one_of_each(flooded_);
  covered_.clear();
  for (const Components::Id id : flooded_) {
    const Set cover = components_->cover(id);
    if (enclosed_.empty() || !is_covered_by_enclosed(cover)) covered_.push_back({cover, id, false});
  }
  for (const std::uint32_t polygon : enclosed_) {
    components_->covers().for_each_node(polygon, [&](Set node) {
      const Set parent = components_->covers().parent(node);
      if (!is_covered_by_enclosed(parent)) covered_.push_back({parent, node, true});
    });
  }
  std::sort(covered_.begin(), covered_.end(),
            [](const Covered& p, const Covered& q) { return p.set != q.set ? p.set < q.set : p.index < q.index; });
  Set added = CoverTree::kEmpty;
  for (std::size_t i = 0; i < covered_.size(); ++i) {
    const auto [set, index, is_node] = covered_[i];
    if (i == 0 || set != covered_[i - 1].set) added = components_->covers().add(set, covering_);
    if (is_node) {
      components_->covers().move(index, added);
    } else {
      components_->set_cover(index, added);
    }
  }
}

/// Returns a half-edge that starts at `v`, in a face in the domain. The positions directly to the right of this
/// half-edge come before `v` in (x, y) order, or lie outside the domain.
HalfEdge PolygonFlood::outer_half_edge(mesh::Vertex v) {
  constraint::faces_at(*triangulation_, {locate::LocatedKind::vertex, triangulation_->topology().outgoing(v)}, around_);
  return around_.front();
}

void PolygonFlood::count_memory(MemoryUse& use) const {
  memory::count_spare(use, stack_, flooded_, around_, sides_, to_cover_, enclosed_, covered_, edges_, outline_.corners,
                      outline_.ring_ends);
  for (const constraint::SlotSet* const set : {&are_in_covers_, &touching_, &tested_, &is_enclosed_})
    set->count_spare(use);
}

void PolygonFlood::release() {
  memory::release(stack_, flooded_, around_, sides_, to_cover_, enclosed_, covered_, edges_, outline_.corners,
                  outline_.ring_ends);
  for (constraint::SlotSet* const set : {&are_in_covers_, &touching_, &tested_, &is_enclosed_}) set->release();
}

}  // namespace waywright::nav
