#include "constraint/item_queries.hpp"

#include <algorithm>
#include <array>

#include "constraint/box_flood.hpp"
#include "constraint/box_test.hpp"
#include "constraint/segment_walk.hpp"
#include "constraint/slot_sets.hpp"
#include "exact/predicates.hpp"

namespace waywright::constraint {

namespace {

using Slots = std::vector<std::uint32_t>;

/// Fills `ids` with the ids of the items in `slots`, ascending. Sorts `slots` and removes duplicates.
void fill_ids(const ExactTriangulation& triangulation, Slots& slots, std::vector<ItemId>& ids) {
  keep_one_of_each(slots);
  ids.clear();
  for (const std::uint32_t slot : slots) {
    if (slot != ItemTable::kDomain) ids.push_back(triangulation.items().id(slot));
  }
  std::sort(ids.begin(), ids.end());
}

void append_items_of_edge(const ExactTriangulation& triangulation, mesh::HalfEdge h, Slots& slots) {
  triangulation.for_each_side(h, [&](const Side& side) { slots.push_back(side.item); });
}

void append_items_around(const ExactTriangulation& triangulation, mesh::Vertex v, Slots& slots) {
  triangulation.topology().for_each_outgoing(v,
                                             [&](mesh::HalfEdge h) { append_items_of_edge(triangulation, h, slots); });
}

/// The position where a segment meets a constrained edge, rounded to doubles. If the segment starts or ends on the
/// edge's line, the function returns this end of the segment, because the segment may run along the edge.
Point meeting_point(const ExactTriangulation& triangulation, mesh::HalfEdge h, const Point& from, const Point& to) {
  const auto& geometry = triangulation.triangulation().geometry();
  const Side& side = triangulation.items().side(triangulation.uses().any(triangulation.topology().label(h)));
  const Point& c = geometry.rounded(number(side.from));
  const Point& d = geometry.rounded(number(side.to));
  for (const Point& end : {from, to}) {
    const auto on =
        exact::orientation(exact::explicit_position(c), exact::explicit_position(d), exact::explicit_position(end));
    if (on == exact::Sign::zero) return end;
  }
  return exact::round_to_nearest({from, to, c, d}).nearest;
}

/// Lists the items that a segment walk meets, with their positions.
class CrossedItems : public SegmentVisitor {
 public:
  CrossedItems(const ExactTriangulation& triangulation, const Point& from, const Point& to, ItemQueryScratch& scratch,
               std::vector<CrossedItem>& found)
      : triangulation_(triangulation), from_(from), to_(to), scratch_(scratch), found_(found) {}

  bool at_vertex(mesh::Vertex v) {
    Slots& along = scratch_.along;
    along.clear();
    if (const mesh::HalfEdge run = edge_run_along(v); run != mesh::kNoHalfEdge) {
      append_items_of_edge(triangulation_, run, along);
    }
    std::sort(along.begin(), along.end());
    Slots& met = scratch_.slots;
    met.clear();
    append_items_around(triangulation_, v, met);
    std::erase_if(met, [&](std::uint32_t slot) { return std::binary_search(along.begin(), along.end(), slot); });
    report_items(triangulation_.triangulation().geometry().rounded(number(v)));
    last_vertex_ = v;
    last_edge_ = mesh::kNoHalfEdge;
    return true;
  }

  bool at_edge(mesh::HalfEdge h, bool /*ends_here*/) {
    last_vertex_ = mesh::kNoVertex;
    last_edge_ = h;
    if (!triangulation_.topology().is_fixed(h)) return true;
    scratch_.slots.clear();
    append_items_of_edge(triangulation_, h, scratch_.slots);
    report_items(meeting_point(triangulation_, h, from_, to_));
    return true;
  }

 private:
  void report_items(const Point& at) {
    fill_ids(triangulation_, scratch_.slots, scratch_.ids);
    for (const ItemId id : scratch_.ids) found_.push_back({id, at});
  }

  /// The edge along which the segment has reached `v`, or kNoHalfEdge if it has crossed a face.
  [[nodiscard]] mesh::HalfEdge edge_run_along(mesh::Vertex v) const {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    if (last_vertex_ != mesh::kNoVertex) return mesh.find(last_vertex_, v);
    const bool is_end =
        last_edge_ != mesh::kNoHalfEdge && (mesh.origin(last_edge_) == v || mesh.target(last_edge_) == v);
    return is_end ? last_edge_ : mesh::kNoHalfEdge;
  }

  const ExactTriangulation& triangulation_;
  Point from_;
  Point to_;
  mesh::Vertex last_vertex_ = mesh::kNoVertex;    ///< the last vertex or edge of the walk, if it was a vertex
  mesh::HalfEdge last_edge_ = mesh::kNoHalfEdge;  ///< the last vertex or edge of the walk, if it was an edge
  ItemQueryScratch& scratch_;
  std::vector<CrossedItem>& found_;
};

/// Ends a segment walk at the first constrained edge.
class FirstWall : public SegmentVisitor {
 public:
  FirstWall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit)
      : triangulation_(triangulation), from_(from), to_(to), hit_(hit) {}

  bool at_vertex(mesh::Vertex v) {
    triangulation_.topology().for_each_outgoing(v, [&](mesh::HalfEdge h) { append_items(h); });
    if (hit_.items.empty()) return true;
    hit_.at = triangulation_.triangulation().geometry().rounded(number(v));
    return false;
  }

  bool at_edge(mesh::HalfEdge h, bool /*ends_here*/) {
    if (!triangulation_.topology().is_fixed(h)) return true;
    append_items(h);
    hit_.at = meeting_point(triangulation_, h, from_, to_);
    return false;
  }

 private:
  void append_items(mesh::HalfEdge h) {
    triangulation_.for_each_side(h,
                                 [&](const Side& side) { hit_.items.push_back(triangulation_.items().id(side.item)); });
  }

  const ExactTriangulation& triangulation_;
  Point from_;
  Point to_;
  RayHit& hit_;
};

/// Appends the items whose sides or corners meet the box to `slots` of the scratch. Requires: a position of the box
/// lies in the face of `start`. The ends of sides are explicit, so the test of sides and corners is exact.
void append_items_in(const ExactTriangulation& triangulation, const Box& box, mesh::HalfEdge start,
                     ItemQueryScratch& scratch) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const BoxTest test(box);
  scratch.reached.clear();
  const auto reach = [&](mesh::Face f) { return scratch.reached.insert(number(f)); };
  flood_box(triangulation, test, start, scratch.faces, reach, [&](mesh::HalfEdge h, bool meets) {
    const mesh::Vertex v = mesh.origin(h);
    if (geometry.is_explicit(number(v)) && test.contains(geometry.rounded(number(v)))) {
      triangulation.uses().for_each(triangulation.corner_uses(v),
                                    [&](std::uint32_t item) { scratch.slots.push_back(item); });
    }
    if (!meets) return;
    triangulation.for_each_side(h, [&](const Side& side) {
      const bool is_met = test.meets(geometry.exact(number(side.from)), geometry.exact(number(side.to)));
      if (is_met) scratch.slots.push_back(side.item);
    });
  });
}

}  // namespace

void items_at(const ExactTriangulation& triangulation, CoverFinder& cover_finder, const Point& point,
              ItemQueryScratch& scratch, std::vector<ItemId>& result) {
  const auto& delaunay = triangulation.triangulation();
  const locate::Located location = delaunay.locate(point);
  Slots& slots = scratch.slots;
  slots = cover_finder.of_location(triangulation, location);
  if (location.kind == locate::LocatedKind::edge) append_items_of_edge(triangulation, location.h, slots);
  if (location.kind == locate::LocatedKind::vertex) {
    const mesh::Vertex v = triangulation.topology().origin(location.h);
    append_items_around(triangulation, v, slots);
    triangulation.uses().for_each(triangulation.corner_uses(v), [&](std::uint32_t item) { slots.push_back(item); });
  }
  fill_ids(triangulation, slots, result);
}

void items_crossed(const ExactTriangulation& triangulation, const Point& from, const Point& to,
                   ItemQueryScratch& scratch, std::vector<CrossedItem>& result) {
  result.clear();
  SegmentWalk(triangulation, from, to, triangulation.triangulation().locate(from))
      .run(CrossedItems(triangulation, from, to, scratch, result));
}

void first_wall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit) {
  hit.items.clear();
  SegmentWalk(triangulation, from, to, triangulation.triangulation().locate(from))
      .run(FirstWall(triangulation, from, to, hit));
  hit.hit = !hit.items.empty();
  if (!hit.hit) hit.at = {};
  hit.contact = hit.at;
  std::sort(hit.items.begin(), hit.items.end());
  hit.items.erase(std::unique(hit.items.begin(), hit.items.end()), hit.items.end());
}

// A polygon that covers the box, and has no side or corner in it, covers the box's first corner.
void items_in(const ExactTriangulation& triangulation, CoverFinder& cover_finder, const Box& box,
              ItemQueryScratch& scratch, std::vector<ItemId>& result) {
  const Box& domain = triangulation.domain();
  const Box clipped{{std::max(box.min.x, domain.min.x), std::max(box.min.y, domain.min.y)},
                    {std::min(box.max.x, domain.max.x), std::min(box.max.y, domain.max.y)}};
  const auto& delaunay = triangulation.triangulation();
  const locate::Located location = delaunay.locate(clipped.min);
  scratch.slots = cover_finder.of_location(triangulation, location);
  faces_at(triangulation, location, scratch.faces);
  append_items_in(triangulation, clipped, scratch.faces.front(), scratch);
  fill_ids(triangulation, scratch.slots, result);
}

}  // namespace waywright::constraint
