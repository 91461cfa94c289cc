#include "constraint/item_queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "base/ieee.hpp"
#include "constraint/boxes.hpp"
#include "constraint/distances.hpp"
#include "constraint/segment_walk.hpp"
#include "exact/gap.hpp"
#include "exact/predicates.hpp"

namespace waywright::constraint {

namespace {

using Slots = std::vector<std::uint32_t>;

/// Fills `ids` with the ids of the items in `slots`, ascending. Sorts `slots` and removes duplicates.
void fill_ids(const ConstrainedTriangulation& triangulation, Slots& slots, std::vector<ItemId>& ids) {
  keep_one_of_each(slots);
  ids.clear();
  for (const std::uint32_t slot : slots) {
    if (slot != ItemTable::kDomain) ids.push_back(triangulation.items().id(slot));
  }
  std::sort(ids.begin(), ids.end());
}

void append_items_of_edge(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h, Slots& slots) {
  triangulation.for_each_side(h, [&](const Side& side) { slots.push_back(side.item); });
}

void append_items_around(const ConstrainedTriangulation& triangulation, mesh::Vertex v, Slots& slots) {
  triangulation.topology().for_each_outgoing(v,
                                             [&](mesh::HalfEdge h) { append_items_of_edge(triangulation, h, slots); });
}

/// The position where a segment meets a constrained edge, rounded to doubles. If the segment starts or ends on the
/// edge's line, the function returns this end of the segment, because the segment may run along the edge.
Point meeting_point(const ConstrainedTriangulation& triangulation, mesh::HalfEdge h, const Point& from,
                    const Point& to) {
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
  CrossedItems(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to,
               ItemQueryScratch& scratch, std::vector<CrossedItem>& found)
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

  const ConstrainedTriangulation& triangulation_;
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
  FirstWall(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit)
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

  const ConstrainedTriangulation& triangulation_;
  Point from_;
  Point to_;
  RayHit& hit_;
};

/// Appends the items whose sides or corners meet the box to `slots` of the scratch. Requires: a position of the box
/// lies in the face of `start`. The ends of sides are explicit, so the test of sides and corners is exact.
void append_items_in(const ConstrainedTriangulation& triangulation, const Box& box, mesh::HalfEdge start,
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

void items_at(const ConstrainedTriangulation& triangulation, CoverFinder& cover_finder, const Point& point,
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

void items_crossed(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to,
                   ItemQueryScratch& scratch, std::vector<CrossedItem>& result) {
  result.clear();
  SegmentWalk(triangulation, from, to, triangulation.triangulation().locate(from))
      .run(CrossedItems(triangulation, from, to, scratch, result));
}

void first_wall(const ConstrainedTriangulation& triangulation, const Point& from, const Point& to, RayHit& hit) {
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
void items_in(const ConstrainedTriangulation& triangulation, CoverFinder& cover_finder, const Box& box,
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

using exact::Sign;
using exact::Sweep;
using exact::Touch;
using mesh::HalfEdge;

namespace {

/// Finds out in doubles which edges a moving disc may meet, and how early. It may name edges that the disc does not
/// meet, but it misses none.
///
/// In coordinates along and across the segment on which the centre moves, earliest() clips an edge to the strip that
/// the disc covers, and then moves the disc forward until it is near the edge. For each edge, let s be the sum of the
/// magnitudes of its four coordinates (along and across), of the length of the motion and of the radius. Each computed
/// number has an error below 2^-49 s, so earliest() makes the radius larger by 2^-46 s. If the mesh has crossings,
/// their coordinates are rounded, so earliest() also adds a bound of this rounding error, for every edge.
class Reach {
 public:
  Reach(const ConstrainedTriangulation& triangulation, const Sweep& sweep)
      : mesh_(triangulation.topology()),
        geometry_(triangulation.triangulation().geometry()),
        from_(sweep.from),
        radius_(std::min(sweep.radius, kLargestRadius)),
        rounding_(largest_rounding(triangulation)) {
    const Point d = sweep.to - sweep.from;
    length_ = std::sqrt(d.x * d.x + d.y * d.y);
    if (length_ > 0.0) direction_ = {d.x / length_, d.y / length_};
  }

  /// Returns a lower bound of the distance that the centre has moved when the disc first meets the edge. At this
  /// distance, a disc with a radius 1.07 times as large already meets the edge. Returns nothing if the disc does not
  /// meet the edge.
  [[nodiscard]] std::optional<double> earliest(HalfEdge h) const {
    const Point p = position(geometry_.rounded(number(mesh_.origin(h))));
    const Point q = position(geometry_.rounded(number(mesh_.target(h))));
    const double slack =
        0x1p-46 * (std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y) + length_ + radius_) + rounding_;
    const double limit = radius_ + slack;
    const double rise = q.y - p.y;
    double first = 0.0;
    double last = 1.0;
    if (rise != 0.0) {
      const double below = (-limit - p.y) / rise;
      const double above = (limit - p.y) / rise;
      first = std::max(first, std::min(below, above));
      last = std::min(last, std::max(below, above));
      if (first > last) return std::nullopt;
    } else if (std::abs(p.y) > limit) {
      return std::nullopt;
    }
    const double at_first = p.x + first * (q.x - p.x);
    const double at_last = p.x + last * (q.x - p.x);
    const double least = std::min(at_first, at_last) - slack;
    const double most = std::max(at_first, at_last) + slack;
    return move_to(p, q, std::max(0.0, least - limit), most, limit);
  }

  /// Returns an upper bound of the distance that the centre has moved when it is at `centre`. Requires:
  /// exact::centre_at() has returned `centre`.
  [[nodiscard]] double latest(const Point& centre) const {
    const Point moved = centre - from_;
    const double error = 0x1p-46 * length_ + 0x1p-49 * (std::abs(from_.x) + std::abs(from_.y));
    return std::sqrt(moved.x * moved.x + moved.y * moved.y) + error;
  }

 private:
  /// Moves the disc forward from `moved` until its distance from the segment from `p` to `q` is small. The disc can
  /// always move by its distance from the segment without touching it. If the centre has moved farther than `most`, the
  /// disc has passed everything of this segment that lies in the strip.
  [[nodiscard]] std::optional<double> move_to(const Point& p, const Point& q, double moved, double most,
                                              double limit) const {
    for (;;) {
      if (moved > length_) return std::nullopt;
      const double distance = std::sqrt(squared_distance_to_segment({moved, 0.0}, p, q));
      if (distance > limit && moved >= most) return std::nullopt;
      if (distance <= kNear * limit) return moved;
      moved += distance - limit;
    }
  }

  /// No distance in the range of coordinates is above 2^101.5. So all larger radii have the same answer.
  static constexpr double kLargestRadius = 0x1p103;
  /// In radii: move_to() stops if the edge is not farther from the centre than this.
  static constexpr double kNear = 1.0625;

  /// The coordinates of a point along and across the segment on which the centre moves.
  [[nodiscard]] Point position(const Point& point) const {
    const Point v = point - from_;
    return {v.x * direction_.x + v.y * direction_.y, direction_.x * v.y - direction_.y * v.x};
  }

  const mesh::TriangleMesh& mesh_;
  const exact::Geometry& geometry_;
  Point from_;
  Point direction_{1.0, 0.0};
  double length_ = 0.0;
  double radius_;
  double rounding_ = 0.0;
};

/// The position of the wall from `a` to `b` that is nearest to a point, up to a few ulps.
Point nearest_on_wall(const Point& point, const Point& a, const Point& b) {
  if (exact::dot(a, point, a, b) != Sign::positive) return a;
  if (exact::dot(b, point, a, b) != Sign::negative) return b;
  return exact::end_of({point, a, b});
}

auto key_of(const Touch& touch) { return std::tuple(touch.kind, touch.a.x, touch.a.y, touch.b.x, touch.b.y); }

/// The order for std::push_heap() and std::pop_heap(): they put the edge that the disc may meet earliest to the front.
constexpr auto is_later = [](const auto& p, const auto& q) { return p.earliest > q.earliest; };

bool is_before(const Point& p, const Point& q) { return std::tie(p.x, p.y) < std::tie(q.x, q.y); }

}  // namespace

void SweptDisc::find_first_wall(const ConstrainedTriangulation& triangulation, const Sweep& sweep, RayHit& hit) {
  find_first_sides(triangulation, sweep);
  hit.items.clear();
  hit.hit = !first_.empty();
  hit.at = hit.contact = {};
  if (!hit.hit) return;
  for (const TouchedSide& side : first_) hit.items.push_back(triangulation.items().id(side.item));
  std::sort(hit.items.begin(), hit.items.end());
  hit.items.erase(std::unique(hit.items.begin(), hit.items.end()), hit.items.end());
  // All sides in `first_` have the same exact position of the centre, but centre_at() may round it differently for
  // each. So the code takes the touch that is least by key_of(). This choice depends on the coordinates of the sides,
  // and not on the order in which the search finds them.
  const auto least = std::min_element(first_.begin(), first_.end(), [](const TouchedSide& p, const TouchedSide& q) {
    return key_of(p.touch) < key_of(q.touch);
  });
  hit.at = exact::centre_at(sweep, least->touch);
  hit.contact = contact(sweep, hit.at);
}

/// Visits faces in the order in which the disc may meet them, and collects in `first_` the sides that it touches first.
void SweptDisc::find_first_sides(const ConstrainedTriangulation& triangulation, const Sweep& sweep) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Reach reach(triangulation, sweep);
  visited_.grow_to(mesh.face_slots());
  stamp_.next(1, visited_);
  edges_.clear();
  first_.clear();
  // If the search has visited the face beyond an edge, it has seen the edge from there.
  const auto look = [&](HalfEdge h) {
    if (visited_[number(mesh::face(mesh.twin(h)))] == stamp_.value()) return;
    const std::optional<double> earliest = reach.earliest(h);
    if (!earliest) return;
    edges_.push_back({*earliest, h});
    std::push_heap(edges_.begin(), edges_.end(), is_later);
  };
  const HalfEdge start = triangulation.triangulation().locate(sweep.from).h;
  visited_[number(mesh::face(start))] = stamp_.value();
  for (const HalfEdge h : {start, mesh::next(start), mesh::previous(start)}) look(h);
  double latest = std::numeric_limits<double>::infinity();
  while (!edges_.empty() && edges_.front().earliest <= latest) {
    std::pop_heap(edges_.begin(), edges_.end(), is_later);
    const HalfEdge h = edges_.back().h;
    edges_.pop_back();
    if (add_sides(triangulation, sweep, h)) latest = reach.latest(exact::centre_at(sweep, first_.front().touch));
    const HalfEdge beyond = mesh.twin(h);
    if (triangulation.triangulation().is_ghost_face(beyond)) continue;
    if (std::exchange(visited_[number(mesh::face(beyond))], stamp_.value()) == stamp_.value()) continue;
    for (const HalfEdge other : {mesh::next(beyond), mesh::previous(beyond)}) look(other);
  }
}

/// For each side on an edge: adds the side to `first_`, unless the disc touches a side in `first_` earlier. If the disc
/// touches the new side earlier than the sides in `first_`, removes those. Returns whether the first touch has changed.
bool SweptDisc::add_sides(const ConstrainedTriangulation& triangulation, const Sweep& sweep, HalfEdge h) {
  if (!triangulation.topology().is_fixed(h)) return false;
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  bool has_changed = false;
  triangulation.for_each_side(h, [&](const Side& side) {
    const auto touch =
        exact::first_touch(sweep, geometry.rounded(number(side.from)), geometry.rounded(number(side.to)));
    if (!touch) return;
    const auto order =
        first_.empty() ? std::strong_ordering::less : exact::compare_touches(sweep, *touch, first_.front().touch);
    if (order > 0) return;
    if (order < 0) {
      first_.clear();
      has_changed = true;
    }
    first_.push_back({*touch, side.item});
  });
  return has_changed;
}

/// The position on the walls in `first_` that is nearest to the centre. If the first touch is not at the start, all
/// touched walls are equally near. Of equally near positions, the first in (x, y) order is the answer.
Point SweptDisc::contact(const Sweep& sweep, const Point& centre) const {
  const bool is_start = first_.front().touch.kind == Touch::Kind::start;
  const Touch* nearest = nullptr;
  Point result;
  for (const TouchedSide& side : first_) {
    const Touch& touch = side.touch;
    const auto order = is_start && nearest != nullptr
                           ? exact::compare_distances(sweep.from, touch.a, touch.b, nearest->a, nearest->b)
                           : std::strong_ordering::equal;
    if (order > 0) continue;
    const Point position = touch.kind == Touch::Kind::line ? exact::end_of({centre, touch.a, touch.b})
                                                           : nearest_on_wall(centre, touch.a, touch.b);
    if (nearest == nullptr || order < 0 || is_before(position, result)) {
      nearest = &touch;
      result = position;
    }
  }
  return result;
}

}  // namespace waywright::constraint
