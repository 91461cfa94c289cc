#include "mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>
#include <vector>

#include "memory/count.hpp"

namespace waywright::mesh {

namespace {

/// Returns the new capacity of a vector: the old one if it suffices, otherwise at least `needed` and at least 1.5 times
/// the old one. So each insertion takes amortised O(1) time.
std::size_t grown_capacity(std::size_t capacity, std::size_t needed) {
  return needed <= capacity ? capacity : std::max(needed, capacity + capacity / 2);
}

}  // namespace

TriangleMesh::TriangleMesh(memory::Array<HalfEdgeRecord> half_edges, std::size_t vertex_count)
    : half_edges_(std::move(half_edges)) {
  outgoing_.reserve(memory::with_spare(vertex_count));
  outgoing_.resize(vertex_count);
  labels_.grow_to(half_edges_.size());
  for (std::uint32_t h = 0; h < half_edges_.size(); ++h) outgoing_[number(half_edges_[h].origin)] = h;
}

HalfEdge TriangleMesh::find(Vertex from, Vertex to) const {
  const HalfEdge start = outgoing(from);
  HalfEdge h = start;
  std::size_t steps = 0;
  do {
    if (target(h) == to) return h;
    h = next_around(h);
    if (++steps == kFewEdges) return find_in_turn(from, to);
  } while (h != start);
  return kNoHalfEdge;
}

/// Follows the edges around both vertices and alternates: one step at the first vertex, one step at the second.
HalfEdge TriangleMesh::find_in_turn(Vertex from, Vertex to) const {
  const HalfEdge starts[2] = {outgoing(from), outgoing(to)};
  HalfEdge g = starts[0];
  HalfEdge h = starts[1];
  do {
    if (target(g) == to) return g;
    if (target(h) == from) return twin(h);
    g = next_around(g);
    h = next_around(h);
  } while (g != starts[0] && h != starts[1]);
  return kNoHalfEdge;
}

bool TriangleMesh::has_many_edges(Vertex v) const {
  const HalfEdge start = outgoing(v);
  HalfEdge h = start;
  for (std::size_t steps = 0; steps < kFewEdges; ++steps) {
    h = next_around(h);
    if (h == start) return false;
  }
  return true;
}

bool TriangleMesh::has_many_and_more_edges(Vertex u, Vertex v) const {
  if (!has_many_edges(u)) return false;
  HalfEdge g = outgoing(u);
  HalfEdge h = outgoing(v);
  do {
    g = next_around(g);
    h = next_around(h);
  } while (g != outgoing(u) && h != outgoing(v));
  return g != outgoing(u);
}

// Each of the following functions first allocates memory, then logs the change, then makes the change. So if memory
// runs out, the undo log lists exactly the changes that were made.
Vertex TriangleMesh::add_vertex() {
  const bool is_new = free_vertices_.is_empty();
  if (is_new) outgoing_.reserve(grown_capacity(outgoing_.capacity(), outgoing_.size() + 1));
  log(EditKind::add_vertex, is_new ? vertex_slots() : free_vertices_.first());
  if (!is_new) return pop_free_vertex();
  outgoing_.push_back(number(kNoHalfEdge));
  return Vertex{vertex_slots() - 1};
}

void TriangleMesh::free_vertex(Vertex v) {
  log(EditKind::free_vertex, number(v));
  push_free_vertex(v);
}

Face TriangleMesh::add_face() {
  const bool is_new = free_faces_.is_empty();
  const Face f{is_new ? face_slots() : free_faces_.first()};
  if (is_new) {
    half_edges_.reserve(grown_capacity(half_edges_.capacity(), half_edges_.size() + 3));
    labels_.grow_to(half_edges_.size() + 3);
  }
  log(EditKind::add_face, number(f));
  if (!is_new) return pop_free_face();
  half_edges_.resize(half_edges_.size() + 3, HalfEdgeRecord{number(kNoHalfEdge), kNoVertex});
  return f;
}

void TriangleMesh::free_face(Face f) {
  save(f);
  drop(f);
}

/// Logs the half-edges and labels of a face that is about to change.
void TriangleMesh::save(Face f) {
  const HalfEdge a = first(f);
  const auto half_edges = half_edges_.begin() + static_cast<std::ptrdiff_t>(number(a));
  if (((half_edges[0].twin | half_edges[1].twin | half_edges[2].twin) & kFixed) != 0) [[unlikely]] {
    for (const HalfEdge h : {a, next(a), previous(a)}) {
      if (is_fixed(h)) log(EditKind::save_label, number(h), labels_[number(h)]);
    }
  }
  saved_faces_.push_back({half_edges[0], half_edges[1], half_edges[2]});
  log(EditKind::rebuild_face, number(f), static_cast<std::uint32_t>(saved_faces_.size() - 1));
}

/// Frees a face. Requires: save() has logged it.
void TriangleMesh::drop(Face f) {
  log(EditKind::free_face, number(f));
  push_free_face(f);
}

void TriangleMesh::set_vertices(Face f, Vertex a, Vertex b, Vertex c) {
  HalfEdge h = first(f);
  for (const Vertex v : {a, b, c}) {
    set_origin(h, v);
    set_outgoing(v, h);
    h = next(h);
  }
}

void TriangleMesh::link(HalfEdge g, HalfEdge h, Label label) {
  if (label != 0) make_room_for_label(g, h);
  half_edges_[number(g)].twin = number(h);
  half_edges_[number(h)].twin = number(g);
  if (label != 0) write_label(g, label);
}

void TriangleMesh::set_label(HalfEdge h, Label new_label) {
  if (new_label != 0) make_room_for_label(h, twin(h));
  const bool stays_fixed = new_label != 0 && is_fixed(h);
  log(stays_fixed ? EditKind::relabel_twin : EditKind::set_label_of_twin, number(twin(h)));
  log(stays_fixed ? EditKind::relabel : EditKind::set_label, number(h), label(h));
  write_label(h, new_label);
}

void TriangleMesh::make_room_for_labels() {
  for (std::size_t h = 0; h < half_edges_.size(); ++h) labels_.make_room(h);
}

void TriangleMesh::make_room_for_label(HalfEdge g, HalfEdge h) {
  labels_.make_room(number(g));
  labels_.make_room(number(h));
}

void TriangleMesh::write_label(HalfEdge h, Label label) {
  for (const HalfEdge half : {h, twin(h)}) {
    std::uint32_t& twin = half_edges_[number(half)].twin;
    twin = label == 0 ? twin & ~kFixed : twin | kFixed;
    if (label != 0) labels_[number(half)] = label;
  }
}

/// Allocates the memory that take_over(to, from) needs.
void TriangleMesh::make_room_to_take_over(HalfEdge to, HalfEdge from) {
  if (is_fixed(from)) [[unlikely]]
    labels_.make_room(number(to));
}

void TriangleMesh::take_over(HalfEdge to, HalfEdge from) {
  const std::uint32_t twin_and_flag = half_edges_[number(from)].twin;
  half_edges_[number(to)].twin = twin_and_flag;
  half_edges_[twin_and_flag & ~kFixed].twin = number(to) | (twin_and_flag & kFixed);
  if ((twin_and_flag & kFixed) != 0) [[unlikely]]
    labels_[number(to)] = labels_[number(from)];
}

//        c                      c
//       / \                    /|\          Face f = (a, b, c) becomes (a, b, v). The faces (b, c, v) and (c, a, v) are
//      /   \                  / | \.        new.
//     /     \       ->       /  v  \.
//    /   f   \              / .' '. \.
//   a ------- b            a ------- b
std::array<HalfEdge, 3> TriangleMesh::split_face(Face f, Vertex v) {
  const Face g = add_face();
  const Face k = add_face();
  const HalfEdge ab = first(f);
  make_room_to_take_over(first(g), next(ab));
  make_room_to_take_over(first(k), previous(ab));
  log(EditKind::split_face, number(f));
  const Vertex a = origin(ab);
  const Vertex b = target(ab);
  const Vertex c = apex(ab);
  take_over(first(g), next(ab));
  take_over(first(k), previous(ab));
  set_vertices(f, a, b, v);
  set_vertices(g, b, c, v);
  set_vertices(k, c, a, v);
  link(next(first(f)), previous(first(g)), 0);
  link(next(first(g)), previous(first(k)), 0);
  link(next(first(k)), previous(first(f)), 0);
  return {first(f), first(g), first(k)};
}

//          c                       c
//        /   \                   / | \         h = a -> b becomes a -> v. The faces (v, b, c) and (v, a, d) are new.
//      /       \               /   |   \.
//    a --- h --> b    ->     a --- v --- b
//      \       /               \   |   /
//        \   /                   \ | /
//          d                       d
std::array<HalfEdge, 4> TriangleMesh::split_edge(HalfEdge h, Vertex v) {
  const Face f = add_face();
  const Face g = add_face();
  const HalfEdge t = twin(h);
  const HalfEdge vb = first(f);
  const HalfEdge va = first(g);
  if (is_fixed(h)) make_room_for_label(va, vb);
  make_room_to_take_over(next(vb), next(h));
  make_room_to_take_over(next(va), next(t));
  log(EditKind::split_edge, number(h), number(t));
  const Vertex a = origin(h);
  const Vertex b = origin(t);
  const Vertex c = apex(h);
  const Vertex d = apex(t);
  const Label edge_label = label(h);
  take_over(next(vb), next(h));
  take_over(next(va), next(t));
  set_vertices(f, v, b, c);
  set_vertices(g, v, a, d);
  set_origin(next(h), v);
  set_origin(next(t), v);
  set_outgoing(a, h);
  set_outgoing(b, t);
  link(next(h), previous(vb), 0);
  link(next(t), previous(va), 0);
  link(h, va, edge_label);
  link(t, vb, edge_label);
  return {next(va), previous(t), next(vb), previous(h)};
}

//          c                       c
//        /   \                   / | \         f = (a, b, c) becomes (a, d, c): h is now a -> d, followed by d -> c and
//      /   f   \               /   |   \       c -> a. g = (b, a, d) becomes (b, c, d): t is now b -> c, followed by
//    a --- h --> b    ->     a   f | g   b     c -> d and d -> b. The half-edges c -> a and d -> b stay as they are.
//      \   g   /               \   |   /
//        \   /                   \ | /
//          d                       d
TriangleMesh::Flipped TriangleMesh::flip(HalfEdge h) {
  assert(!is_fixed(h));
  const HalfEdge t = twin(h);
  make_room_to_take_over(h, next(t));
  make_room_to_take_over(t, next(h));
  log(EditKind::flip, number(h), number(t));
  return flip_unlogged(h);
}

/// Flips an edge without a record in the undo log. Requires: there is room for the labels.
TriangleMesh::Flipped TriangleMesh::flip_unlogged(HalfEdge h) {
  const HalfEdge t = twin(h);
  const Vertex a = origin(h);
  const Vertex b = origin(t);
  const Vertex c = apex(h);
  const Vertex d = apex(t);
  const HalfEdge diagonal = next(h);
  take_over(h, next(t));
  take_over(t, diagonal);
  set_origin(diagonal, d);
  set_origin(next(t), c);
  set_outgoing(a, h);
  set_outgoing(b, t);
  link(diagonal, next(t), 0);
  return {diagonal, previous(t)};
}

//            apex            Each of `one` and `other` is a half-edge on the cavity's border, or the base of a new
//           /    \           triangle. If only one of the two lies on the border, the new triangle uses its face,
//      one /      \ other    which nothing else needs. Then this half-edge and its twin do not change. If both lie
//         /        \         on the border, `other` moves to the face of `one`, and its old face is freed. If both
//    from -------- to        are bases, the new triangle takes a freed face. A new base has no twin yet. It
//           base             replaces `one` in `border`.
HalfEdge TriangleMesh::refill(std::span<HalfEdge> border, std::span<const Triangle> triangles) {
  for (const HalfEdge h : border) save(face(h));
  HalfEdge base = kNoHalfEdge;
  for (auto triangle = triangles.rbegin(); triangle != triangles.rend(); ++triangle) {
    const HalfEdge one = border[triangle->from];
    const HalfEdge other = border[triangle->apex];
    const Vertex from = lacks_twin(one) ? target(one) : origin(one);
    const Vertex apex = lacks_twin(one) ? origin(one) : target(one);
    const Vertex to = lacks_twin(other) ? origin(other) : target(other);
    const HalfEdge h = !lacks_twin(one) ? one : !lacks_twin(other) ? previous(other) : first(add_face());
    set_origin(h, from);
    set_origin(next(h), apex);
    set_origin(previous(h), to);
    join(h, one);
    join(next(h), other);
    base = previous(h);
    half_edges_[number(base)].twin = number(kNoHalfEdge);
    border[triangle->from] = base;
  }
  return base;
}

void TriangleMesh::close(HalfEdge base, HalfEdge old) {
  save(face(old));
  join(base, old);
}

/// If `old` has no twin, makes `h` its twin. Otherwise `h` replaces `old`. If the two are different half-edges, the
/// function then frees the face of `old`.
void TriangleMesh::join(HalfEdge h, HalfEdge old) {
  if (lacks_twin(old)) {
    link(h, old, 0);
    return;
  }
  set_outgoing(origin(h), h);
  if (h == old) return;
  make_room_to_take_over(h, old);
  take_over(h, old);
  drop(face(old));
}

}  // namespace waywright::mesh

// Undoes edits. The code undoes each edit in exactly the mesh that the edit produced, so every index in its record has
// the same meaning as when the record was made. Nothing here allocates.

namespace waywright::mesh {

void TriangleMesh::begin() {
  journal_.begin();
  saved_faces_.clear();
}

void TriangleMesh::roll_back() {
  journal_.roll_back([&](const Undo& edit) { undo(edit); });
  begin();
}

void TriangleMesh::undo(const Undo& edit) {
  switch (edit.kind) {
    case EditKind::add_vertex:
      push_free_vertex(Vertex{edit.index});
      break;
    case EditKind::free_vertex:
      (void)pop_free_vertex();
      break;
    case EditKind::add_face:
      push_free_face(Face{edit.index});
      break;
    case EditKind::free_face:
      (void)pop_free_face();
      break;
    case EditKind::rebuild_face:
      restore(Face{edit.index}, saved_faces_[edit.saved]);
      break;
    case EditKind::split_face:
      undo_split_face(Face{edit.index});
      break;
    case EditKind::split_edge:
      undo_split_edge(HalfEdge{edit.index});
      break;
    case EditKind::flip:
      undo_flip(HalfEdge{edit.index});
      break;
    case EditKind::set_label:
    case EditKind::relabel:
      write_label(HalfEdge{edit.index}, edit.saved);
      break;
    case EditKind::set_label_of_twin:
    case EditKind::relabel_twin:
      break;
    case EditKind::save_label:
      labels_[edit.index] = edit.saved;
      break;
  }
}

// Turns f = (a, b, v) back into (a, b, c): see split_face. Other records undo the two other faces.
void TriangleMesh::undo_split_face(Face f) {
  const HalfEdge ab = first(f);
  const HalfEdge bc = first(face(twin(next(ab))));
  const HalfEdge ca = first(face(twin(previous(ab))));
  const Vertex c = target(bc);
  set_origin(previous(ab), c);
  take_over(next(ab), bc);
  take_over(previous(ab), ca);
  set_outgoing(origin(ab), ab);
  set_outgoing(target(ab), next(ab));
  set_outgoing(c, previous(ab));
}

// Turns h = a -> v back into a -> b: see split_edge.
void TriangleMesh::undo_split_edge(HalfEdge h) {
  const HalfEdge va = twin(h);
  const HalfEdge vb = next(twin(next(h)));
  const HalfEdge t = twin(vb);
  const Label edge_label = label(h);
  set_origin(next(h), origin(t));
  set_origin(next(t), origin(h));
  take_over(next(h), next(vb));
  take_over(next(t), next(va));
  link(h, t, edge_label);
  for (const HalfEdge edge : {h, t, previous(h), previous(t)}) set_outgoing(origin(edge), edge);
}

// Turns h = a -> d, which d -> c follows, back into a -> b: see flip.
void TriangleMesh::undo_flip(HalfEdge h) {
  const HalfEdge t = previous(twin(next(h)));
  take_over(next(h), t);
  take_over(next(t), h);
  set_origin(next(h), origin(t));
  set_origin(next(t), origin(h));
  link(h, t, 0);
  for (const HalfEdge edge : {h, t, previous(h), previous(t)}) set_outgoing(origin(edge), edge);
}

// Also sets the twins of the neighbours that are live. A neighbour that is restored later sets its twins itself. A
// neighbour that is still free must not be written to: its slot holds a link of the free list.
void TriangleMesh::restore(Face f, const SavedFace& saved) {
  HalfEdge h = first(f);
  for (const HalfEdgeRecord& record : saved) {
    half_edges_[number(h)] = record;
    set_outgoing(record.origin, h);
    const HalfEdge t = twin(h);
    if (is_live(face(t))) half_edges_[number(t)].twin = number(h) | (record.twin & kFixed);
    h = next(h);
  }
}

void TriangleMesh::push_free_face(Face f) {
  for (std::uint32_t i = 0; i < 3; ++i) half_edges_[number(first(f)) + i] = {number(kNoHalfEdge), kNoVertex};
  half_edges_[number(first(f))].twin = free_faces_.push(number(f));
  ++free_face_count_;
}

Face TriangleMesh::pop_free_face() {
  const Face f{free_faces_.pop(half_edges_[number(first(Face{free_faces_.first()}))].twin)};
  --free_face_count_;
  return f;
}

void TriangleMesh::push_free_vertex(Vertex v) {
  outgoing_[number(v)] = kFree | free_vertices_.push(number(v));
  ++free_vertex_count_;
}

Vertex TriangleMesh::pop_free_vertex() {
  const Vertex v{free_vertices_.pop(outgoing_[free_vertices_.first()] & ~kFree)};
  outgoing_[number(v)] = number(kNoHalfEdge);
  --free_vertex_count_;
  return v;
}

namespace {

std::string named(const char* what, std::uint32_t index) { return std::string(what) + ' ' + std::to_string(index); }

std::optional<std::string> find_fault_at(const TriangleMesh& mesh, HalfEdge h) {
  const HalfEdge t = mesh.twin(h);
  if (number(t) >= mesh.face_slots() * 3 || !mesh.is_live(face(t))) {
    return named("half-edge", number(h)) + " has no living twin";
  }
  if (t == h || mesh.twin(t) != h) return named("half-edge", number(h)) + " is not its twin's twin";
  if (mesh.origin(h) != mesh.target(t) || mesh.target(h) != mesh.origin(t)) {
    return named("half-edge", number(h)) + " and its twin join different vertices";
  }
  if (mesh.label(h) != mesh.label(t)) return named("half-edge", number(h)) + " and its twin carry different labels";
  const Vertex v = mesh.origin(h);
  if (number(v) >= mesh.vertex_slots() || !mesh.is_live(v)) {
    return named("half-edge", number(h)) + " starts at a dead vertex";
  }
  if (v == mesh.target(h)) return named("half-edge", number(h)) + " is a loop";
  return std::nullopt;
}

}  // namespace

// A closed surface in one piece is a sphere if V - E + F = 2. The loop around each vertex must contain all half-edges
// that start there; otherwise the faces at this vertex form more than one loop.
std::optional<std::string> TriangleMesh::find_fault() const {
  std::vector<std::uint32_t> degree(vertex_slots(), 0);
  std::size_t faces = 0;
  for (std::uint32_t i = 0; i < face_slots(); ++i) {
    const Face f{i};
    if (!is_live(f)) continue;
    ++faces;
    HalfEdge h = first(f);
    for (int corner = 0; corner < 3; ++corner, h = next(h)) {
      if (auto fault = find_fault_at(*this, h)) return fault;
      ++degree[number(origin(h))];
    }
  }
  if (faces != face_count()) return "the count of faces is wrong";
  std::size_t vertices = 0;
  for (std::uint32_t i = 0; i < vertex_slots(); ++i) {
    const Vertex v{i};
    if (!is_live(v)) continue;
    ++vertices;
    const HalfEdge start = outgoing(v);
    if (number(start) >= half_edges_.size() || origin(start) != v) return named("vertex", i) + " has no half-edge";
    std::uint32_t loop = 0;
    HalfEdge h = start;
    do {
      if (origin(h) != v || ++loop > degree[i]) return named("vertex", i) + " has a broken loop";
      h = next_around(h);
    } while (h != start);
    if (loop != degree[i]) return named("vertex", i) + " has more than one loop";
  }
  if (vertices != vertex_count()) return "the count of vertices is wrong";
  if (2 * vertices != faces + 4) return "the surface is no sphere: 2 V != F + 4";
  return std::nullopt;
}

}  // namespace waywright::mesh
