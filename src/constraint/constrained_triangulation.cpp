#include "constraint/constrained_triangulation.hpp"

#include <algorithm>
#include <utility>

#include "memory/count.hpp"

namespace waywright::constraint {

void ConstrainedTriangulation::begin() {
  triangulation_.begin();
  begin_records();
}

void ConstrainedTriangulation::begin_records() {
  items_.begin();
  uses_.begin();
  corner_uses_.begin();
  new_walls_.begin();
}

// Each member has its own undo log and undoes its own changes without reading the other members.
void ConstrainedTriangulation::roll_back() {
  triangulation_.roll_back();
  items_.roll_back();
  uses_.roll_back();
  corner_uses_.roll_back();
}

void ConstrainedTriangulation::count_memory(MemoryUse& use) const {
  triangulation_.count_memory(use);
  items_.count_memory(use);
  uses_.count_memory(use, &MemoryUse::walls);
  corner_uses_.count_memory(use, &MemoryUse::vertices);
  memory::count_spare(use, late_corners_, order_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

void ConstrainedTriangulation::shrink_to_fit() {
  begin();  // empties all logs
  triangulation_.shrink_to_fit();
  items_.shrink_to_fit();
  uses_.shrink_to_fit();
  corner_uses_.shrink_to_fit();
  memory::release(late_corners_, order_, crossed_, touched_, outline_.corners, outline_.ring_ends);
}

void ConstrainedTriangulation::set_corner_uses(mesh::Vertex v, Uses uses) { corner_uses_.write(number(v), uses); }

/// Makes room for the list of every vertex. The list of a new vertex is empty.
void ConstrainedTriangulation::grow_corner_uses() { corner_uses_.grow_to(topology().vertex_slots(), UseLists::kNone); }

// Inserts the corners first and then the sides. A side needs its ends as vertices, and it is divided at every vertex
// that lies on it, for example at another corner of its own item.
void ConstrainedTriangulation::insert(const Shape& shape, ItemId id) {
  budget_.begin_insertion(topology().vertex_count() - 1);
  const std::uint32_t slot = items_.add_item(id, shape.kind, shape.fill);
  insert_corners(shape.rings, slot);
  if (has_too_many_vertices()) return;
  end_item(slot);
  items_.for_each_side(slot, [&](std::uint32_t side) { insert_side(side); });
}

ItemHash::Words ConstrainedTriangulation::hash_of(std::uint32_t slot, const Outline& outline) const {
  ItemHash hash(items_.id(slot), items_.kind(slot), items_.fill(slot), outline.ring_ends.size());
  std::uint32_t i = 0;
  for (const std::uint32_t end : outline.ring_ends) {
    hash.begin_ring(end - i);
    for (; i < end; ++i) hash.add(triangulation_.geometry().rounded(number(outline.corners[i])));
  }
  return hash.words();
}

/// Inserts the corners of all rings, in their order. If this turns out to be costly (CostWatch), inserts the remaining
/// corners in scattered order (append_scattered). Stops if has_too_many_vertices() becomes true.
void ConstrainedTriangulation::insert_corners(const Rings& rings, std::uint32_t slot) {
  outline_.clear();
  late_corners_.clear();
  CostWatch watch(kTestsPerVertex);
  for (const PointSpan& ring : rings) {
    for_each_corner(ring, items_.kind(slot) == ItemKind::polygon, [&](const Point& point) {
      if (has_too_many_vertices()) return;
      if (watch.is_costly()) [[unlikely]] {
        late_corners_.push_back({point, static_cast<std::uint32_t>(outline_.corners.size())});
        outline_.corners.push_back(mesh::kNoVertex);
        return;
      }
      const auto inserted = triangulation_.insert(point);
      watch.add(inserted.tested_edges);
      add_corner(insert_vertex(inserted), slot);
    });
    end_ring();
  }
  if (!late_corners_.empty()) [[unlikely]]
    insert_late_corners(slot);
}

void ConstrainedTriangulation::insert_late_corners(std::uint32_t slot) {
  order_.clear();
  append_scattered(0, static_cast<std::uint32_t>(late_corners_.size()), true, order_);
  for (const std::uint32_t i : order_) {
    const mesh::Vertex v = insert_vertex(triangulation_.insert(late_corners_[i].point));
    if (has_too_many_vertices()) return;
    outline_.corners[late_corners_[i].index] = v;
    set_corner_uses(v, uses_.add(corner_uses_[number(v)], slot));
  }
}

mesh::Vertex ConstrainedTriangulation::insert_vertex(const Triangulation::Inserted& inserted) {
  if (inserted.split != mesh::kNoHalfEdge) record_split(inserted.split);
  grow_corner_uses();
  budget_.add(inserted.is_new ? 1 : 0);
  return inserted.vertex;
}

void ConstrainedTriangulation::add_corner(mesh::Vertex v, std::uint32_t item) {
  outline_.corners.push_back(v);
  set_corner_uses(v, uses_.add(corner_uses_[number(v)], item));
}

void ConstrainedTriangulation::end_ring() {
  outline_.ring_ends.push_back(static_cast<std::uint32_t>(outline_.corners.size()));
}

void ConstrainedTriangulation::end_item(std::uint32_t item) {
  items_.set_outline(item, outline_);
  items_.add_hash(hash_of(item, outline_));
}

// Inserts a side piece by piece. A piece ends at the next vertex on the side, or at a new vertex on the first fixed
// edge that the side crosses. At a vertex with many edges, the search for the next piece would take long. So if many
// items have a corner at `side.from` (is_hub()), and if this vertex has many edges, and more edges than `side.to` has,
// the function begins at `side.to`. If a piece ends at a vertex with many edges, the function continues from the other
// end of the side, towards this vertex. It stops if has_too_many_vertices() becomes true.
void ConstrainedTriangulation::insert_side(std::uint32_t slot) {
  if (has_too_many_vertices()) return;
  Side side = items_.side(slot);
  if (is_hub(side.from) && topology().has_many_and_more_edges(side.from, side.to)) std::swap(side.from, side.to);
  mesh::Vertex u = side.from;
  mesh::Vertex end = side.to;
  Step step = leave_corner(u, side);
  for (;;) {
    if (step.fixed != mesh::kNoHalfEdge) {
      const mesh::Vertex x = cut(step.fixed, side);
      if (has_too_many_vertices()) return;
      const mesh::HalfEdge piece = add_piece(u, step_to_crossing(u, x), slot);
      step = leave_crossing(topology().twin(piece), side);
      u = x;
    } else {
      const std::optional<std::uint32_t> leading_side = side_beyond(step.along);
      const mesh::HalfEdge piece = add_piece(u, step, slot);
      u = step.vertex;
      if (u == end) return;
      if (end == side.to && topology().has_many_edges(u)) {
        std::swap(side.from, side.to);
        end = u;
        u = side.from;
        step = leave_corner(u, side);
      } else {
        step = leave_vertex(topology().twin(piece), side, leading_side);
      }
    }
  }
}

std::optional<std::uint32_t> ConstrainedTriangulation::side_beyond(mesh::HalfEdge along) const {
  if (along == mesh::kNoHalfEdge || !topology().is_fixed(along)) return std::nullopt;
  const std::uint32_t leading_side = uses_.any(topology().label(along));
  const Side& side = items_.side(leading_side);
  const mesh::Vertex v = topology().target(along);
  if (side.from == v || side.to == v) return std::nullopt;
  return leading_side;
}

// The insertion of x has rebuilt exactly the faces around x. They form a polygon that is star-shaped around x. So the
// segment from u to x first crosses edges that are listed in `crossed_` and have not changed, and then stays inside
// this polygon.
ConstrainedTriangulation::Step ConstrainedTriangulation::step_to_crossing(mesh::Vertex u, mesh::Vertex x) {
  const mesh::TriangleMesh& mesh = topology();
  const auto has_x = [&](mesh::HalfEdge h) { return mesh.origin(h) == x || mesh.target(h) == x || mesh.apex(h) == x; };
  if (crossed_.empty() || has_x(crossed_.front())) {
    return {x, mesh.twin(mesh.find(x, u)), mesh::kNoHalfEdge};
  }
  std::size_t count = 1;
  while (mesh.apex(mesh.twin(crossed_[count - 1])) != x) ++count;
  crossed_.resize(count);
  return {x, mesh::kNoHalfEdge, mesh::kNoHalfEdge};
}

/// Makes the piece from u to the end of the step a fixed edge that `side` uses. Returns its half-edge.
mesh::HalfEdge ConstrainedTriangulation::add_piece(mesh::Vertex u, const Step& step, std::uint32_t side) {
  if (step.along == mesh::kNoHalfEdge || !topology().is_fixed(step.along)) new_walls_.add(topology(), u, step.vertex);
  if (step.along == mesh::kNoHalfEdge) {
    crossed_count_ += crossed_.size();
    return triangulation_.force_edge(u, step.vertex, crossed_, UseLists::single(side));
  }
  triangulation_.fix(step.along, uses_.add(topology().label(step.along), side));
  return step.along;
}

//            q         Most sides are edges as soon as their corners are vertices. For any other side, the function
//          / |         goes counter-clockwise around u. It searches for an edge whose target lies on the side, ahead of
//        /   |         u, or for a face whose vertex p lies right of the side and whose vertex q lies left of it.
//      u - - | - ->
//        \   |
//          \ p
ConstrainedTriangulation::Step ConstrainedTriangulation::leave_corner(mesh::Vertex u, const Side& side) {
  using exact::Sign;
  const mesh::TriangleMesh& mesh = topology();
  const mesh::HalfEdge whole = mesh.find(u, side.to);
  if (whole != mesh::kNoHalfEdge) return {side.to, whole, mesh::kNoHalfEdge};
  const mesh::Vertex ghost = triangulation_.ghost();
  const auto side_of = [&](mesh::Vertex v) {
    return v == ghost ? Sign::zero : triangulation_.orientation(side.from, side.to, v);
  };
  const bool ascends = triangulation_.comes_before(side.from, side.to);
  mesh::HalfEdge h = mesh.outgoing(u);
  Sign p_side = side_of(mesh.target(h));
  for (;;) {
    const mesh::Vertex p = mesh.target(h);
    const mesh::Vertex q = mesh.apex(h);
    if (p_side == Sign::zero && p != ghost && triangulation_.comes_before(u, p) == ascends) {
      return {p, h, mesh::kNoHalfEdge};
    }
    const Sign q_side = side_of(q);
    if (p_side == Sign::negative && q_side == Sign::positive) return step_across(mesh::next(h), side);
    h = mesh.next_around(h);
    p_side = q_side;
  }
}

// The leading side is another side on which the last piece lies, and which continues beyond the vertex. Both sides lie
// on one line. So the next edge of the leading side is the next edge of this side.
ConstrainedTriangulation::Step ConstrainedTriangulation::leave_vertex(mesh::HalfEdge behind, const Side& side,
                                                                      std::optional<std::uint32_t> leading_side) {
  if (!leading_side) return leave_between(behind, behind, side);
  const mesh::TriangleMesh& mesh = topology();
  mesh::HalfEdge h = mesh.next_around(behind);
  while (!mesh.is_fixed(h) || !uses_.contains(mesh.label(h), *leading_side)) h = mesh.next_around(h);
  return {mesh.target(h), h, mesh::kNoHalfEdge};
}

// `behind` starts at a vertex at which cut() has just divided a fixed edge into two halves. Counter-clockwise from
// `behind`, the first fixed edge is the half on the right of the side. Clockwise, it is the half on the left. The side
// continues between them.
ConstrainedTriangulation::Step ConstrainedTriangulation::leave_crossing(mesh::HalfEdge behind, const Side& side) {
  const mesh::TriangleMesh& mesh = topology();
  mesh::HalfEdge right = mesh.next_around(behind);
  while (!mesh.is_fixed(right)) right = mesh.next_around(right);
  mesh::HalfEdge left = mesh.previous_around(behind);
  while (!mesh.is_fixed(left)) left = mesh.previous_around(left);
  return leave_between(right, left, side);
}

ConstrainedTriangulation::Step ConstrainedTriangulation::leave_between(mesh::HalfEdge right, mesh::HalfEdge left,
                                                                       const Side& side) {
  using exact::Sign;
  const mesh::TriangleMesh& mesh = topology();
  for (mesh::HalfEdge h = right;;) {
    const mesh::HalfEdge turned = mesh.next_around(h);
    const mesh::Vertex q = mesh.target(turned);
    if (turned == left) return step_across(mesh::next(h), side);
    if (q != triangulation_.ghost()) {
      const Sign q_side = triangulation_.orientation(side.from, side.to, q);
      if (q_side == Sign::zero) return {q, turned, mesh::kNoHalfEdge};
      if (q_side == Sign::positive) return step_across(mesh::next(h), side);
    }
    h = turned;
  }
}

ConstrainedTriangulation::Step ConstrainedTriangulation::step_across(mesh::HalfEdge exit, const Side& side) {
  using exact::Sign;
  const mesh::TriangleMesh& mesh = topology();
  crossed_.clear();
  mesh::HalfEdge h = exit;
  for (;;) {
    if (mesh.is_fixed(h)) return {{}, mesh::kNoHalfEdge, h};
    crossed_.push_back(h);
    const mesh::HalfEdge t = mesh.twin(h);
    const mesh::Vertex apex = mesh.apex(t);
    const Sign apex_side = apex == side.to ? Sign::zero : triangulation_.orientation(side.from, side.to, apex);
    if (apex_side == Sign::zero) return {apex, mesh::kNoHalfEdge, mesh::kNoHalfEdge};
    h = apex_side == Sign::positive ? mesh::next(t) : mesh::previous(t);
  }
}

mesh::Vertex ConstrainedTriangulation::cut(mesh::HalfEdge fixed, const Side& side) {
  const mesh::Vertex end = topology().origin(fixed);
  const Side& other = items_.side(uses_.any(topology().label(fixed)));
  const mesh::Vertex x = triangulation_.insert_crossing(fixed, side.from, side.to, other.from, other.to);
  grow_corner_uses();
  budget_.add(1);
  record_split(topology().find(x, end));
  return x;
}

// After an edge is split, the labels of both halves refer to the same list of sides. This function gives one half a
// list of its own. The two halves are the only fixed edges at the new vertex.
void ConstrainedTriangulation::record_split(mesh::HalfEdge half) {
  triangulation_.fix(half, uses_.copy(topology().label(half)));
  mesh::HalfEdge other_half = topology().next_around(half);
  while (!topology().is_fixed(other_half)) other_half = topology().next_around(other_half);
  new_walls_.split(topology().target(half), topology().target(other_half));
}

// First takes the item off its edges and corners, then flips the edges that have become free until they are Delaunay,
// and only then removes vertices: the removal of a vertex from a Delaunay triangulation leaves a Delaunay
// triangulation.
void ConstrainedTriangulation::remove(ItemId id) {
  const std::uint32_t slot = items_.slot(id);
  items_.outline(slot, outline_);
  // In a large world, a removal spends most of its time waiting for memory. The code prefetches data as soon as it
  // knows the address. Some of the faces that were made together with a corner probably still have it as a vertex.
  for (const mesh::Vertex v : outline_.corners) {
    triangulation_.prefetch(v);
    triangulation_.prefetch_faces_made_with(v);
    prefetch_corner_uses(v);
  }
  const ItemHash::Words hash = hash_of(slot, outline_);
  for (const mesh::Vertex v : outline_.corners) triangulation_.prefetch_star(v);
  items_.remove_item(slot, hash);
  touched_.clear();
  new_walls_.forget();
  items_.for_each_side(slot, [&](std::uint32_t side) { remove_side(side); });
  for (const mesh::Vertex v : outline_.corners) remove_corner_use(v, slot);
  triangulation_.legalise_unfixed();
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  remove_unneeded();
}

/// Removes the vertices in `touched_` that are not needed any more, in their order. If this turns out to be costly
/// (CostWatch), removes the remaining ones in scattered order (append_scattered).
void ConstrainedTriangulation::remove_unneeded() {
  CostWatch watch(kEdgesPerVertex);
  std::uint32_t i = 0;
  for (; i < touched_.size() && !watch.is_costly(); ++i) watch.add(remove_if_unneeded(touched_[i]));
  if (i == touched_.size()) return;
  order_.clear();
  append_scattered(i, static_cast<std::uint32_t>(touched_.size()), false, order_);
  for (const std::uint32_t late : order_) remove_if_unneeded(touched_[late]);
}

// Takes the side off its edges, beginning at both ends. edge_of_side() finds the next edge at one of the two ends:
// usually at the end with fewer edges. So the function is not slow if the side runs through a vertex with many edges:
// it takes the remaining edges from the other end.
void ConstrainedTriangulation::remove_side(std::uint32_t slot) {
  const mesh::TriangleMesh& mesh = topology();
  const Side& side = items_.side(slot);
  mesh::Vertex u = side.from;
  mesh::Vertex w = side.to;
  while (u != w) {
    const mesh::HalfEdge h = edge_of_side(u, w, slot);
    mesh::Vertex& end = mesh.origin(h) == u ? u : w;
    end = mesh.target(h);
    touched_.push_back(end);
    const Uses rest = uses_.remove(mesh.label(h), slot);
    if (rest == UseLists::kNone) {
      triangulation_.unfix_edge(h);
    } else {
      triangulation_.fix(h, rest);
    }
  }
}

void ConstrainedTriangulation::remove_corner_use(mesh::Vertex v, std::uint32_t item) {
  set_corner_uses(v, uses_.remove(corner_uses_[number(v)], item));
  touched_.push_back(v);
}

std::size_t ConstrainedTriangulation::remove_if_unneeded(mesh::Vertex v) {
  if (corner_uses_[number(v)] != UseLists::kNone) return 0;
  // No item has a corner at `v`, so each side at `v` continues straight through it. If `v` has two fixed edges, they
  // therefore lie on one line. If it has more, sides cross there, and `v` stays.
  const auto& star = triangulation_.star(v);
  if (star.fixed.size() > 2) return 0;
  if (star.fixed.size() == 2) uses_.release(topology().label(star.spokes[star.fixed[1]]));
  const std::size_t degree = star.spokes.size();
  triangulation_.remove_vertex(star);
  return degree;
}

// First looks at a few edges of `u`, then alternately at an edge of each of the two vertices.
mesh::HalfEdge ConstrainedTriangulation::edge_of_side(mesh::Vertex u, mesh::Vertex w, std::uint32_t side) const {
  const mesh::TriangleMesh& mesh = topology();
  const auto lies_on = [&](mesh::HalfEdge h) { return mesh.is_fixed(h) && uses_.contains(mesh.label(h), side); };
  mesh::HalfEdge g = mesh.outgoing(u);
  for (std::size_t i = 0; i < mesh::TriangleMesh::kFewEdges; ++i) {
    if (lies_on(g)) return g;
    g = mesh.next_around(g);
  }
  for (mesh::HalfEdge h = mesh.outgoing(w);; h = mesh.next_around(h)) {
    if (lies_on(g)) return g;
    if (lies_on(h)) return h;
    g = mesh.next_around(g);
  }
}

}  // namespace waywright::constraint
