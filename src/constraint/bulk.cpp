#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "constraint/batch.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"

// Inserts many items at once. First it inserts the corners along a curve, so that each is near the previous corner, and
// its neighbours are near it in memory. Then it inserts the sides, whose ends are known, in the order of their items'
// first corners.
//
// In an empty world, all threads insert sides, unless there are few items with sides among many points. The vertices
// are numbered along the curve, so a range of numbers is a region of the domain. Each region is a task of one thread,
// which inserts the sides for which all vertices of the crossed faces belong to the region (delaunay::LocalEdges). Then
// one thread inserts the other sides. The regions do not depend on the number of threads, so neither does the mesh,
// including the numbers of its faces.

namespace waywright::constraint {

namespace {

/// Makes one list of `others` and the corners of all items of a batch, in this order. Returns the list sorted along the
/// curve of the domain.
template <class Batch>
locate::SortedPoints sort_corners(const Box& domain, const Batch& batch, std::span<const Point> others,
                                  const threads::ThreadTeam& team) {
  std::size_t count = others.size();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    for (const auto& ring : batch.rings(i)) count += ring.size();
  }
  std::vector<Point> corners;
  corners.reserve(count);
  corners.assign(others.begin(), others.end());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    for (const auto& ring : batch.rings(i)) {
      for_each_corner(ring, batch.kind(i) == ItemKind::polygon, [&](const Point& point) { corners.push_back(point); });
    }
  }
  return locate::sort_along_curve(domain, corners, team);
}

/// The index of the first item of a batch that has a corner whose rank satisfies `is_wanted`, or the size of the batch.
/// `ranks` are the ranks of the corners of the items, one after the other.
template <class Batch, class IsWanted>
std::size_t find_item(const Batch& batch, std::span<const std::uint32_t> ranks, IsWanted&& is_wanted) {
  std::size_t corner = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    for (const auto& ring : batch.rings(i)) {
      const std::span<const std::uint32_t> of_ring =
          ranks.subspan(corner, count_corners(ring, batch.kind(i) == ItemKind::polygon));
      if (std::any_of(of_ring.begin(), of_ring.end(), is_wanted)) return i;
      corner += of_ring.size();
    }
  }
  return batch.size();
}

/// The sum of the hashes of a batch's items. The function hashes the corners as the caller gave them, so it needs no
/// mesh.
template <class Batch>
ItemHash::Words hash_of_batch(const Batch& batch) {
  ItemHash::Words sum{};
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const bool is_closed = batch.kind(i) == ItemKind::polygon;
    const auto& rings = batch.rings(i);
    ItemHash hash(batch.id(i), batch.kind(i), batch.fill(i), rings.size());
    for (const auto& ring : rings) {
      hash.begin_ring(count_corners(ring, is_closed));
      for_each_corner(ring, is_closed, [&](const Point& point) { hash.add(point); });
    }
    ItemHash::add_to(sum, hash.words());
  }
  return sum;
}

}  // namespace

// The vertices of the corners are known when the points are sorted, so one job makes the records and another one hashes
// the items while other threads make the triangulation. No caller can see this object before it is complete, so there
// is nothing to undo, and the code empties the undo logs from time to time.
template <class Batch>
ConstrainedTriangulation::ConstrainedTriangulation(const Box& domain, const Batch& batch,
                                                   const threads::ThreadTeam& team, const VertexLimits& limits)
    : domain_(domain), triangulation_(domain, kSidesOfDomain), budget_(limits) {
  locate::SortedPoints sorted = sort_corners(domain, batch, Triangulation::corners_of(domain), team);
  const std::span<const std::uint32_t> ranks(sorted.ranks);
  const std::size_t corner_count = sorted.points.size() - 4;  // without the corners of the domain
  budget_.begin_insertion(4);
  budget_.add(corner_count);
  if (has_too_many_vertices()) {
    refused_index_ = find_item(batch, ranks.subspan(4), [&](std::uint32_t rank) {
      return rank >= budget_.allowed() && std::find(ranks.begin(), ranks.begin() + 4, rank) == ranks.begin() + 4;
    });
    return;
  }
  corner_uses_.reserve(memory::with_spare(sorted.points.size() + 1));
  corner_uses_.grow_to(sorted.points.size() + 1, UseLists::kNone);
  std::vector<RankedItem> with_sides;
  ItemHash::Words hash{};
  const std::array<threads::Job, 2> jobs = {
      [&] {
        add_domain(ranks.first(4));
        with_sides = add_records(batch, ranks.subspan(4), Triangulation::vertex_of_rank, [&](std::size_t items) {
          if (items % kItemsBetweenReports == 0) begin_records();
        });
      },
      [&] { hash = hash_of_batch(batch); }};
  triangulation_ = Triangulation(domain, kSidesOfDomain, std::move(sorted), team, jobs);
  items_.outline(ItemTable::kDomain, outline_);
  items_.add_hash(hash_of(ItemTable::kDomain, outline_));
  items_.add_hash(hash);
  insert_sides_by_region(batch, with_sides, ranks.size(), team);
  begin();
}

void ConstrainedTriangulation::add_domain(std::span<const std::uint32_t> ranks) {
  for (const std::uint32_t rank : ranks) add_corner(Triangulation::vertex_of_rank(rank), ItemTable::kDomain);
  end_ring();
  items_.set_outline(ItemTable::kDomain, outline_);
}

template <class Batch>
void ConstrainedTriangulation::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  const locate::SortedPoints sorted = sort_corners(domain_, batch, {}, team);
  std::vector<mesh::Vertex> vertices;
  budget_.begin_insertion(topology().vertex_count() - 1);
  if (const auto stopped = insert_sorted(sorted.points, team, vertices)) {
    refused_index_ = find_item(batch, sorted.ranks, [&](std::uint32_t rank) { return rank == *stopped; });
    return;
  }
  const auto vertex_of = [&](std::uint32_t rank) { return vertices[rank]; };
  items_.add_hash(hash_of_batch(batch));
  const std::vector<RankedItem> items = add_records(batch, sorted.ranks, vertex_of, [](std::size_t) {});
  std::vector<SideOfBatch> sides;
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    items_.for_each_side(items[i].slot, [&](std::uint32_t side) { sides.push_back({i, side}); });
  }
  insert_sides(batch, items, sides,
               [&](std::size_t done) { team.report(sorted.ranks.size() + items.size() * done / sides.size()); });
}

/// Makes a vertex at each point, first in their order. If this is costly, it inserts the others in scattered order.
std::optional<std::uint32_t> ConstrainedTriangulation::insert_sorted(std::span<const Point> points,
                                                                     const threads::ThreadTeam& team,
                                                                     std::vector<mesh::Vertex>& vertices) {
  vertices.reserve(points.size());
  CostWatch watch(kTestsPerVertex);
  while (vertices.size() < points.size() && !watch.is_costly()) {
    const auto inserted = triangulation_.insert(points[vertices.size()]);
    watch.add(inserted.tested_edges);
    vertices.push_back(insert_vertex(inserted));
    if (has_too_many_vertices()) return static_cast<std::uint32_t>(vertices.size() - 1);
    if (vertices.size() % kItemsBetweenReports == 0) team.report(vertices.size());
  }
  if (vertices.size() == points.size()) return std::nullopt;
  std::size_t done = vertices.size();
  order_.clear();
  append_scattered(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(points.size()), true, order_);
  vertices.resize(points.size());
  for (const std::uint32_t i : order_) {
    vertices[i] = insert_vertex(triangulation_.insert(points[i]));
    if (has_too_many_vertices()) return i;
    if (++done % kItemsBetweenReports == 0) team.report(done);
  }
  return std::nullopt;
}

template <class Batch, class VertexOf, class AfterRecord>
auto ConstrainedTriangulation::add_records(const Batch& batch, std::span<const std::uint32_t> ranks,
                                           VertexOf&& vertex_of, AfterRecord&& after_record)
    -> std::vector<RankedItem> {
  std::vector<RankedItem> with_sides;
  std::size_t corner = 0;
  items_.reserve(batch.size(), [&](std::size_t i) { return batch.id(i); });
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (i + kIdsAhead < batch.size()) items_.prefetch(batch.id(i + kIdsAhead));
    const ItemKind kind = batch.kind(i);
    const std::uint32_t slot = items_.add_item(batch.id(i), kind, batch.fill(i));
    const std::uint32_t first_rank = ranks[corner];
    outline_.clear();
    for (const auto& ring : batch.rings(i)) {
      for_each_corner(ring, kind == ItemKind::polygon, [&](const Point&) {
        const std::size_t ahead = corner + kCornersAhead;
        if (ahead < ranks.size()) prefetch_corner_uses(vertex_of(ranks[ahead]));
        add_corner(vertex_of(ranks[corner++]), slot);
      });
      end_ring();
    }
    items_.set_outline(slot, outline_);
    if (kind != ItemKind::point) with_sides.push_back({first_rank, slot});
    after_record(i + 1);
  }
  std::sort(with_sides.begin(), with_sides.end());
  return with_sides;
}

/// Returns whether the number of vertices is now above a limit. If so, sets `refused_index_` to the index of the item.
template <class Batch>
bool ConstrainedTriangulation::is_refused_at(const Batch& batch, std::uint32_t slot) {
  if (!has_too_many_vertices()) return false;
  refused_index_ = 0;
  while (batch.id(refused_index_) != items_.id(slot)) ++refused_index_;
  return true;
}

template <class Batch>
void ConstrainedTriangulation::insert_sides_by_region(const Batch& batch, std::span<const RankedItem> items,
                                                      std::size_t corners, const threads::ThreadTeam& team) {
  const std::vector<SideOfBatch> late = insert_local_sides(items, corners, team);
  std::size_t complete = items.size();
  for (std::size_t i = 0; i < late.size(); ++i) complete -= i == 0 || late[i].item != late[i - 1].item ? 1 : 0;
  insert_sides(batch, items, late, [&](std::size_t done) {
    begin();
    team.report(corners + complete + (items.size() - complete) * done / late.size());
  });
}

/// Inserts sides, first in their order. If this is costly, inserts the others in scattered order. For each side, the
/// expected number of edges that it crosses is then small. Calls after_side(the number of inserted sides) from time to
/// time. If an insertion exceeds a limit, stops and sets `refused_index_`. Source: Shewchuk and Brown, *Fast segment
/// insertion and incremental construction of constrained Delaunay triangulations*, 2015 (the random order).
template <class Batch, class AfterSide>
void ConstrainedTriangulation::insert_sides(const Batch& batch, std::span<const RankedItem> items,
                                            std::span<const SideOfBatch> sides, AfterSide&& after_side) {
  CostWatch watch(kEdgesPerSide);
  std::size_t done = 0;
  const auto insert = [&](const SideOfBatch& side) {
    const std::size_t crossed_before = crossed_count_;
    insert_side(side.side);
    watch.add(crossed_count_ - crossed_before);
    if (is_refused_at(batch, items[side.item].slot)) return false;
    if (++done % kItemsBetweenReports == 0) after_side(done);
    return true;
  };
  while (done < sides.size() && !watch.is_costly()) {
    if (!insert(sides[done])) return;
  }
  order_.clear();
  append_scattered(static_cast<std::uint32_t>(done), static_cast<std::uint32_t>(sides.size()), true, order_);
  for (const std::uint32_t i : order_) {
    if (!insert(sides[i])) return;
  }
}

/// Inserts each side that LocalEdges can insert within one region. Returns the other sides, in the order of the items.
auto ConstrainedTriangulation::insert_local_sides(std::span<const RankedItem> items, std::size_t corners,
                                                  const threads::ThreadTeam& team) -> std::vector<SideOfBatch> {
  const std::size_t ranks = topology().vertex_count() - 1;  // without the ghost
  const std::size_t size = std::clamp(ranks / kUsualRegions, kSmallestRegion, kLargestRegion);
  // Several regions need memory for the labels of all edges. So if there are few items among many points, the code
  // makes one region, and one thread inserts all sides.
  const std::size_t regions = items.size() < ranks / kPointsPerItem ? 1 : std::max<std::size_t>(ranks / size, 1);
  if (regions > 1) triangulation_.make_room_for_labels();
  std::vector<std::vector<SideOfBatch>> late(regions);
  std::atomic<std::size_t> done{0};
  team.for_each_index(regions, [&](std::size_t /*thread*/, std::size_t i) {
    const std::size_t end = i + 1 == regions ? ranks : (i + 1) * size;
    done += insert_local_sides(items, i * size, end, regions == 1, late[i]);
    team.report(corners + done);
  });
  for (std::size_t i = 1; i < regions; ++i) {
    late[0].insert(late[0].end(), late[i].begin(), late[i].end());
    late[i] = std::vector<SideOfBatch>();  // assigning {} would keep the memory
  }
  return std::move(late[0]);
}

/// The ranks [begin, end) are a region. For the items whose first corner lies in this region, inserts each side that
/// LocalEdges can insert within the region. If `defers_all` is true, it inserts none. Appends the other sides of these
/// items to `late`. Returns the number of items of which it has inserted all sides.
std::size_t ConstrainedTriangulation::insert_local_sides(std::span<const RankedItem> items, std::size_t begin,
                                                         std::size_t end, bool defers_all,
                                                         std::vector<SideOfBatch>& late) {
  const auto at = [&](std::size_t rank) {
    const auto found = std::lower_bound(items.begin(), items.end(), rank,
                                        [](const RankedItem& item, std::size_t r) { return item.rank < r; });
    return static_cast<std::uint32_t>(found - items.begin());
  };
  const auto vertex = [](std::size_t rank) { return Triangulation::vertex_of_rank(static_cast<std::uint32_t>(rank)); };
  auto edges = triangulation_.local_edges(vertex(begin), vertex(end));
  std::size_t completed = 0;
  for (std::uint32_t i = at(begin); i < at(end); ++i) {
    const std::size_t late_before = late.size();
    items_.for_each_side(items[i].slot, [&](std::uint32_t slot) {
      const Side& side = items_.side(slot);
      if (defers_all || !edges.force_edge(side.from, side.to, UseLists::single(slot))) late.push_back({i, slot});
    });
    completed += late.size() == late_before ? 1 : 0;
  }
  return completed;
}

template ConstrainedTriangulation::ConstrainedTriangulation(const Box&, const PointBatch&, const threads::ThreadTeam&,
                                                            const VertexLimits&);
template ConstrainedTriangulation::ConstrainedTriangulation(const Box&, const ShapeBatch&, const threads::ThreadTeam&,
                                                            const VertexLimits&);
template void ConstrainedTriangulation::insert_all(const PointBatch&, const threads::ThreadTeam&);
template void ConstrainedTriangulation::insert_all(const ShapeBatch&, const threads::ThreadTeam&);

}  // namespace waywright::constraint
