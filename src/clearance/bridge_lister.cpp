#include "clearance/bridge_lister.hpp"

#include <algorithm>
#include <tuple>

#include "clearance/bridge_items.hpp"
#include "constraint/box_test.hpp"

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

}  // namespace

void BridgeLister::list(const Triangulation& triangulation, const Bridges& bridges, const Box& box,
                        BridgeList& result) {
  result.bridges.clear();
  result.ids.clear();
  listed_.clear();
  mark_faces(triangulation);
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Cells cells(triangulation, bridges);
  const constraint::BoxTest test(box);
  const auto offer = [&](const CellEdge& gate) {
    const exact::Gap gap = cells.canonical_gap(gate);
    const Point to = exact::end_of(gap);
    if (test.meets(exact::explicit_point(gap.from), exact::explicit_point(to))) listed_.push_back({gate, gap, to});
  };
  for (std::uint32_t i = 0; i < 3 * mesh.face_slots(); ++i) {
    const HalfEdge h{i};
    if (sides_[i / 3] != Side::open) continue;
    if (bridges.is_bridge(h) && h < mesh.twin(h)) offer({CellEdge::Kind::bridge, h, Bridges::kNone});
    if (bridges.foot_at(h) != Bridges::kNone) offer({CellEdge::Kind::foot_down, h, bridges.foot_at(h)});
  }
  // Two feet may have the same rounded position. Then the side on which the foot lies decides.
  const auto key = [](const Listed& bridge) {
    const exact::Gap& gap = bridge.gap;
    return std::tie(gap.from.x, gap.from.y, bridge.to.x, bridge.to.y, gap.a.x, gap.a.y, gap.b.x, gap.b.y);
  };
  std::sort(listed_.begin(), listed_.end(), [&](const Listed& p, const Listed& q) { return key(p) < key(q); });
  for (const Listed& bridge : listed_) {
    result.bridges.push_back(append_items(triangulation, bridges, bridge, result.ids));
  }
}

/// Finds out which faces a polygon covers. No bridge crosses a wall, so all faces that a bridge crosses are alike.
void BridgeLister::mark_faces(const Triangulation& triangulation) {
  const std::uint32_t count = triangulation.topology().face_slots();
  sides_.assign(count, Side::unknown);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Face f{i};
    if (sides_[i] == Side::unknown && triangulation.triangulation().is_in_domain(f)) mark_around(triangulation, f);
  }
}

/// Marks the face and all faces that free edges connect with it.
void BridgeLister::mark_around(const Triangulation& triangulation, Face first) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const Side side = cover_.is_covered(triangulation, HalfEdge{3 * number(first)}) ? Side::covered : Side::open;
  sides_[number(first)] = side;
  faces_.assign(1, first);
  while (!faces_.empty()) {
    const Face f = faces_.back();
    faces_.pop_back();
    for (std::uint32_t i = 3 * number(f); i < 3 * number(f) + 3; ++i) {
      if (mesh.is_fixed(HalfEdge{i})) continue;
      const Face beyond = mesh::face(mesh.twin(HalfEdge{i}));
      if (sides_[number(beyond)] != Side::unknown) continue;
      sides_[number(beyond)] = side;
      faces_.push_back(beyond);
    }
  }
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
    for_each_item_on(triangulation, bridges.foot(listed.gate.foot).wall, add);
  } else {
    for_each_item_at(triangulation, starts_at_origin ? mesh.target(h) : mesh.origin(h), add);
  }
  bridge.to_count = keep_one_of_each(ids, bridge.first_id + bridge.from_count);
  return bridge;
}

}  // namespace waywright::clearance
