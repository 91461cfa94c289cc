#include "constraint/item_queries.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "constraint/box_test.hpp"
#include "constraint/segment_walk.hpp"
#include "constraint/slot_sets.hpp"
#include "exact/predicates.hpp"

namespace waywright::constraint {

namespace {

using Slots = std::vector<std::uint32_t>;

std::vector<ItemId> ids_of(const ExactTriangulation& triangulation, Slots slots) {
  keep_one_of_each(slots);
  std::vector<ItemId> ids;
  for (const std::uint32_t slot : slots) {
    if (slot != ItemTable::kDomain) ids.push_back(triangulation.items().id(slot));
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

void append_items_of_edge(const ExactTriangulation& triangulation, mesh::HalfEdge h, Slots& slots) {
  triangulation.for_each_side(h, [&](const Side& side) { slots.push_back(side.item); });
}

void append_items_around(const ExactTriangulation& triangulation, mesh::Vertex v, Slots& slots) {
  triangulation.topology().for_each_outgoing(v,
                                             [&](mesh::HalfEdge h) { append_items_of_edge(triangulation, h, slots); });
}

/// Where a segment meets a wall's edge, as nearest doubles: a segment that starts on it, or ends on it, meets it there
/// and may run along it.
Point meeting_place(const ExactTriangulation& triangulation, mesh::HalfEdge h, const Point& from, const Point& to) {
  const auto& geometry = triangulation.triangulation().geometry();
  const Side& side = triangulation.items().side(triangulation.uses().any(triangulation.topology().label(h)));
  const Point& c = geometry.nearest(number(side.from));
  const Point& d = geometry.nearest(number(side.to));
  for (const Point& end : {from, to}) {
    const auto on = exact::orientation(exact::explicit_point(c), exact::explicit_point(d), exact::explicit_point(end));
    if (on == exact::Sign::zero) return end;
  }
  return exact::round_to_nearest({from, to, c, d}).nearest;
}

/// Turns what a segment walk meets into items and places.
class CrossedItems : public SegmentVisitor {
 public:
  CrossedItems(const ExactTriangulation& triangulation, const Point& from, const Point& to)
      : triangulation_(triangulation), from_(from), to_(to) {}

  bool at_vertex(mesh::Vertex v) {
    Slots along;
    if (const mesh::HalfEdge run = edge_run_along(v); run != mesh::kNoHalfEdge) {
      append_items_of_edge(triangulation_, run, along);
    }
    std::sort(along.begin(), along.end());
    Slots met;
    append_items_around(triangulation_, v, met);
    std::erase_if(met, [&](std::uint32_t slot) { return std::binary_search(along.begin(), along.end(), slot); });
    tell(met, triangulation_.triangulation().geometry().nearest(number(v)));
    last_vertex_ = v;
    last_edge_ = mesh::kNoHalfEdge;
    return true;
  }

  bool at_edge(mesh::HalfEdge h, bool /*ends_here*/) {
    last_vertex_ = mesh::kNoVertex;
    last_edge_ = h;
    if (!triangulation_.topology().is_fixed(h)) return true;
    Slots met;
    append_items_of_edge(triangulation_, h, met);
    tell(met, meeting_place(triangulation_, h, from_, to_));
    return true;
  }

  [[nodiscard]] std::vector<std::pair<ItemId, Point>>& found() { return found_; }

 private:
  void tell(const Slots& met, const Point& at) {
    for (const ItemId id : ids_of(triangulation_, met)) found_.emplace_back(id, at);
  }

  /// The edge by which the segment has come to `v`, if it came along one.
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
  mesh::Vertex last_vertex_ = mesh::kNoVertex;    ///< where the segment was last, if that was at a vertex
  mesh::HalfEdge last_edge_ = mesh::kNoHalfEdge;  ///< where it was last, if that was on an edge
  std::vector<std::pair<ItemId, Point>> found_;
};

/// Stops a segment walk at the first wall.
class FirstWall : public SegmentVisitor {
 public:
  FirstWall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit)
      : triangulation_(triangulation), from_(from), to_(to), hit_(hit) {}

  bool at_vertex(mesh::Vertex v) {
    triangulation_.topology().for_each_outgoing(v, [&](mesh::HalfEdge h) { append_items(h); });
    if (hit_.items.empty()) return true;
    hit_.at = triangulation_.triangulation().geometry().nearest(number(v));
    return false;
  }

  bool at_edge(mesh::HalfEdge h, bool /*ends_here*/) {
    if (!triangulation_.topology().is_fixed(h)) return true;
    append_items(h);
    hit_.at = meeting_place(triangulation_, h, from_, to_);
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

/// Floods the faces that meet a box, and collects the items whose sides and corners do.
class BoxFlood {
 public:
  BoxFlood(const ExactTriangulation& triangulation, const Box& box) : triangulation_(triangulation), test_(box) {}

  Slots run(mesh::HalfEdge start) {
    reach(start);
    while (!faces_.empty()) {
      const mesh::HalfEdge face = faces_.back();
      faces_.pop_back();
      for (const mesh::HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) visit(h);
    }
    return found_;
  }

 private:
  void reach(mesh::HalfEdge h) {
    if (triangulation_.triangulation().is_ghost_face(h)) return;
    if (reached_.insert(number(mesh::face(h))).second) faces_.push_back(h);
  }

  // Sides and corners are explicit, so about them the test is exact; that it may go too far over an edge does no harm.
  void visit(mesh::HalfEdge h) {
    const mesh::TriangleMesh& mesh = triangulation_.topology();
    const exact::Geometry& geometry = triangulation_.triangulation().geometry();
    const mesh::Vertex v = mesh.origin(h);
    if (geometry.is_explicit(number(v)) && test_.holds(geometry.nearest(number(v)))) {
      triangulation_.uses().for_each(triangulation_.corner_uses(v),
                                     [&](std::uint32_t item) { found_.push_back(item); });
    }
    if (!test_.meets(geometry.exact(number(v)), geometry.exact(number(mesh.target(h))))) return;
    triangulation_.for_each_side(h, [&](const Side& side) {
      if (test_.meets(geometry.exact(number(side.from)), geometry.exact(number(side.to)))) found_.push_back(side.item);
    });
    reach(mesh.twin(h));
  }

  const ExactTriangulation& triangulation_;
  BoxTest test_;
  std::unordered_set<std::uint32_t> reached_;
  std::vector<mesh::HalfEdge> faces_;
  Slots found_;
};

}  // namespace

std::vector<ItemId> items_at(const ExactTriangulation& triangulation, Cover& cover, const Point& point) {
  const auto& delaunay = triangulation.triangulation();
  const locate::Located place = delaunay.locate(point);
  Slots slots = cover.of_place(triangulation, place);
  if (place.spot == locate::Spot::edge) append_items_of_edge(triangulation, place.h, slots);
  if (place.spot == locate::Spot::vertex) {
    const mesh::Vertex v = triangulation.topology().origin(place.h);
    append_items_around(triangulation, v, slots);
    triangulation.uses().for_each(triangulation.corner_uses(v), [&](std::uint32_t item) { slots.push_back(item); });
  }
  return ids_of(triangulation, std::move(slots));
}

std::vector<std::pair<ItemId, Point>> items_crossed(const ExactTriangulation& triangulation, const Point& from,
                                                    const Point& to) {
  const auto& delaunay = triangulation.triangulation();
  CrossedItems crossed(triangulation, from, to);
  SegmentWalk(triangulation, from, to, delaunay.locate(from)).run(crossed);
  return std::move(crossed.found());
}

void first_wall(const ExactTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit) {
  hit.items.clear();
  SegmentWalk(triangulation, from, to, triangulation.triangulation().locate(from))
      .run(FirstWall(triangulation, from, to, hit));
  hit.hit = !hit.items.empty();
  if (!hit.hit) hit.at = {};
  std::sort(hit.items.begin(), hit.items.end());
  hit.items.erase(std::unique(hit.items.begin(), hit.items.end()), hit.items.end());
}

// What covers the whole box without a side or corner in it covers its first corner.
std::vector<ItemId> items_in(const ExactTriangulation& triangulation, Cover& cover, const Box& box) {
  const Box& domain = triangulation.domain();
  const Box clipped{{std::max(box.min.x, domain.min.x), std::max(box.min.y, domain.min.y)},
                    {std::min(box.max.x, domain.max.x), std::min(box.max.y, domain.max.y)}};
  const auto& delaunay = triangulation.triangulation();
  const locate::Located place = delaunay.locate(clipped.min);
  Slots slots = cover.of_place(triangulation, place);
  std::vector<mesh::HalfEdge> faces;
  faces_at(triangulation, place, faces);
  const Slots met = BoxFlood(triangulation, clipped).run(faces.front());
  slots.insert(slots.end(), met.begin(), met.end());
  return ids_of(triangulation, std::move(slots));
}

}  // namespace waywright::constraint
