#include "clearance/bridge_lister.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "clearance/walls.hpp"
#include "constraint/boxes.hpp"

namespace waywright::clearance {

using mesh::Face;
using mesh::HalfEdge;
using mesh::Vertex;

namespace {

/// Sorts the ids from the index `first` on, and removes repeated ones. Returns how many are left.
std::uint32_t keep_one_of_each(std::vector<ItemId>& ids, std::size_t first) {
  const auto begin = ids.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, ids.end());
  ids.erase(std::unique(begin, ids.end()), ids.end());
  return static_cast<std::uint32_t>(ids.size() - first);
}

/// Returns a box that contains each position of a bridge whose rounded form has a position in the box. Coordinates
/// nearer to 0 than kSmallestCoordinate are out of range for exact predicates.
Box widened(const Box& box, const Box& domain) {
  const double slack = 0x1p-45 * exact::filter::largest_magnitude(domain);
  const auto down = [&](double x, double limit) {
    const double moved = x - slack;
    return std::max(std::abs(moved) < kSmallestCoordinate ? -kSmallestCoordinate : moved, limit);
  };
  const auto up = [&](double x, double limit) {
    const double moved = x + slack;
    return std::min(std::abs(moved) < kSmallestCoordinate ? kSmallestCoordinate : moved, limit);
  };
  return {{down(box.min.x, domain.min.x), down(box.min.y, domain.min.y)},
          {up(box.max.x, domain.max.x), up(box.max.y, domain.max.y)}};
}

}  // namespace

struct BridgeLister::Query {
  const Triangulation& triangulation;
  const Bridges& bridges;
  constraint::CoverFinder& cover_finder;
  constraint::BoxTest test;
};

// A bridge along an edge meets the box only if the faces of the edge do. A foot bridge that starts in another face
// enters the faces that meet the box through an edge `border`, at a position q. The disc of the bridge contains no
// vertex except its start. As in changed_region.cpp, the circle of each face that the bridge crosses before q contains
// q strictly inside, and also each later position of the bridge, for example one in the box. So a search beyond
// `border` that crosses free edges, and enters a face if its circle meets `border` and the box, finds the start of the
// bridge.
void BridgeLister::list(const Triangulation& triangulation, const Bridges& bridges,
                        constraint::CoverFinder& cover_finder, const Box& box, BridgeList& result) {
  result.bridges.clear();
  result.ids.clear();
  const Box near = widened(box, triangulation.domain());
  if (near.min.x > near.max.x || near.min.y > near.max.y) return;
  const Query query{triangulation, bridges, cover_finder, constraint::BoxTest(box)};
  const mesh::TriangleMesh& mesh = triangulation.topology();
  BridgeFinder finder(triangulation, scratch_);
  listed_.clear();
  collect_faces(query, near);
  for (const Face f : faces_) {
    offer_feet(query, f, f);
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      const HalfEdge h{i};
      if (mesh.is_fixed(h)) continue;
      if (bridges.is_bridge(h) && h < mesh.twin(h)) offer(query, {CellEdge::Kind::bridge, h, Bridges::kNone}, f);
      if (!has(mesh::face(mesh.twin(h)), kMeets)) search_beyond(query, finder, near, h);
    }
  }
  sort_listed();
  for (const Listed& bridge : listed_) {
    result.bridges.push_back(append_items(triangulation, bridges, bridge, result.ids));
  }
}

/// Collects the faces that meet the box.
void BridgeLister::collect_faces(const Query& query, const Box& near) {
  const Triangulation& triangulation = query.triangulation;
  marks_.grow_to(triangulation.topology().face_slots());
  stamp_.next(kMarks, marks_);
  faces_.clear();
  constraint::faces_at(triangulation, triangulation.triangulation().locate(near.min), to_visit_);
  const auto reach = [&](Face f) {
    if (has(f, kMeets)) return false;
    add(f, kMeets);
    faces_.push_back(f);
    return true;
  };
  const HalfEdge start = to_visit_.front();
  constraint::flood_box(triangulation, constraint::BoxTest(near), start, to_visit_, reach, [](HalfEdge, bool) {});
}

/// Offers the foot bridges that start beyond the edge `border` of a face of faces_ and may cross the edge.
void BridgeLister::search_beyond(const Query& query, BridgeFinder& finder, const Box& near, HalfEdge border) {
  const mesh::TriangleMesh& mesh = query.triangulation.topology();
  scratch_.begin();
  to_visit_.assign(1, mesh.twin(border));
  while (!to_visit_.empty()) {
    const HalfEdge entry = to_visit_.back();
    to_visit_.pop_back();
    const Face f = mesh::face(entry);
    if (!scratch_.visit(f) || !finder.may_touch(finder.circle_of(entry), near)) continue;
    if (!finder.may_circle_meet(entry, border)) continue;
    if (!has(f, kSearched)) offer_feet(query, f, mesh::face(border));
    add(f, kSearched);
    for (const HalfEdge exit : {mesh::next(entry), mesh::previous(entry)}) {
      const HalfEdge beyond = mesh.twin(exit);
      if (!mesh.is_fixed(exit) && !has(mesh::face(beyond), kMeets)) to_visit_.push_back(beyond);
    }
  }
}

/// Offers the foot bridges that start in the face. Free edges connect the face with `connected`, a face of faces_.
void BridgeLister::offer_feet(const Query& query, Face f, Face connected) {
  for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
    const std::uint32_t foot = query.bridges.foot_at(HalfEdge{i});
    if (foot != Bridges::kNone) offer(query, {CellEdge::Kind::foot_down, HalfEdge{i}, foot}, connected);
  }
}

/// Adds the bridge to the list if it meets the box and does not lie in the interior of a polygon.
void BridgeLister::offer(const Query& query, const CellEdge& gate, Face connected) {
  const exact::Gap gap = Cells(query.triangulation, query.bridges).canonical_gap(gate);
  const Point to = exact::end_of(gap);
  if (!query.test.meets(exact::explicit_position(gap.from), exact::explicit_position(to))) return;
  if (is_open(query, connected)) listed_.push_back({gate, gap, to});
}

/// Returns whether no polygon covers a face of faces_. No bridge crosses a wall, so the answer is the same for all
/// faces that free edges connect with this face: notes it for those in faces_.
bool BridgeLister::is_open(const Query& query, Face f) {
  if (has(f, kOpen) || has(f, kCovered)) return has(f, kOpen);
  const mesh::TriangleMesh& mesh = query.triangulation.topology();
  const Mark mark = query.cover_finder.is_covered(query.triangulation, mesh::first(f)) ? kCovered : kOpen;
  add(f, mark);
  connected_.assign(1, f);
  while (!connected_.empty()) {
    const Face at = connected_.back();
    connected_.pop_back();
    for (std::uint32_t i = 3 * number(at); i < 3 * number(at) + 3; ++i) {
      if (mesh.is_fixed(HalfEdge{i})) continue;
      const Face beyond = mesh::face(mesh.twin(HalfEdge{i}));
      if (!has(beyond, kMeets) || has(beyond, mark)) continue;
      add(beyond, mark);
      connected_.push_back(beyond);
    }
  }
  return mark == kOpen;
}

void BridgeLister::sort_listed() {
  // Two feet may have the same rounded position. Then the side on which the foot lies decides.
  const auto key = [](const Listed& bridge) {
    const exact::Gap& gap = bridge.gap;
    return std::tie(gap.from.x, gap.from.y, bridge.to.x, bridge.to.y, gap.a.x, gap.a.y, gap.b.x, gap.b.y);
  };
  std::sort(listed_.begin(), listed_.end(), [&](const Listed& p, const Listed& q) { return key(p) < key(q); });
}

/// Appends the ids of the items at both ends. Returns the bridge.
Bridge BridgeLister::append_items(const Triangulation& triangulation, const Bridges& bridges, const Listed& listed,
                                  std::vector<ItemId>& ids) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const HalfEdge h = listed.gate.h;
  const bool starts_at_origin = geometry.rounded(number(mesh.origin(h))) == listed.gap.from;
  const auto add = [&](std::uint32_t slot) { ids.push_back(triangulation.items().id(slot)); };
  Bridge bridge{listed.gap.from, listed.to, exact::largest_radius(listed.gap), listed.gap.has_foot(), 0, 0, 0};
  bridge.first_id = static_cast<std::uint32_t>(ids.size());
  for_each_item_at(triangulation, starts_at_origin ? mesh.origin(h) : mesh.target(h), add);
  bridge.from_count = keep_one_of_each(ids, bridge.first_id);
  if (bridge.has_foot) {
    for_each_item_on(triangulation, bridges.wall_of(listed.gate.foot), add);
  } else {
    for_each_item_at(triangulation, starts_at_origin ? mesh.target(h) : mesh.origin(h), add);
  }
  bridge.to_count = keep_one_of_each(ids, bridge.first_id + bridge.from_count);
  return bridge;
}

}  // namespace waywright::clearance
