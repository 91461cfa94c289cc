#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/compiler.hpp"
#include "memory/array.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"
#include "memory/pages.hpp"
#include "mesh/index.hpp"

namespace waywright::mesh {

/// A number that the mesh stores for an edge. The rooms that include this room give it a meaning. The mesh only stores
/// and copies it. An edge whose label is not 0 is fixed: no flip removes it.
using Label = std::uint32_t;

/// A triangulated sphere: every half-edge has a twin, and every vertex has a closed loop of faces. To represent a
/// triangulated polygon, connect a ghost vertex to all vertices on the border of the polygon. The result is a sphere,
/// and the faces at the ghost vertex are ghost faces. The class stores only the topology, and no coordinates.
///
/// New vertices and faces use freed slots again. The slot that was freed last is used first. An index stays valid until
/// its vertex or face is freed. A flip rebuilds two faces, and afterwards other half-edges may represent the edges of
/// these faces.
///
/// An undo log (memory::Journal) records all edits since begin(). roll_back() takes these edits back. The log also
/// lists the faces and vertices that the edits touched.
///
/// Source: Chen 2009, section 3.1 (half-edges, vertex and face loops: algorithms 1 and 2).
class TriangleMesh {
 public:
  /// What an edit since begin() did to a face or vertex. A face or vertex that several edits touched is listed several
  /// times, in the order of the edits. A freed face may be listed as rebuilt before.
  enum class Touch : std::uint8_t {
    made,
    rebuilt,  ///< its vertices or neighbours have changed, or one of its edges became fixed or free
    freed,
    relabelled  ///< one of its fixed edges got another label, and stayed fixed
  };

  /// The record of a half-edge.
  struct HalfEdgeRecord {
    /// The twin. The highest bit says whether the edge is fixed. In the first half-edge of a free face, the member is
    /// the number of the next free face.
    std::uint32_t twin;
    Vertex origin;  ///< kNoVertex in a free face
  };

  TriangleMesh() = default;
  /// Takes over a mesh that other code has made. The half-edges 3 f, 3 f + 1 and 3 f + 2 are a face. Requires: no face
  /// is free, no edge is fixed, and each of the `vertex_count` vertices is the origin of a half-edge.
  TriangleMesh(memory::Array<HalfEdgeRecord> half_edges, std::size_t vertex_count);

  // Navigation. A function costs O(1), unless its comment states another cost.
  [[nodiscard]] HalfEdge twin(HalfEdge h) const { return HalfEdge{half_edges_[number(h)].twin & ~kFixed}; }
  [[nodiscard]] Vertex origin(HalfEdge h) const { return half_edges_[number(h)].origin; }
  [[nodiscard]] Vertex target(HalfEdge h) const { return origin(next(h)); }
  /// The vertex of the half-edge's face that is not on the half-edge.
  [[nodiscard]] Vertex apex(HalfEdge h) const { return origin(previous(h)); }
  /// A half-edge that starts at `v`.
  [[nodiscard]] HalfEdge outgoing(Vertex v) const { return HalfEdge{outgoing_[number(v)]}; }
  /// Prefetches the memory that outgoing(v) reads.
  void prefetch(Vertex v) const { base::prefetch(&outgoing_[number(v)]); }
  /// Prefetches the memory of the face of `h`.
  void prefetch(HalfEdge h) const { base::prefetch(&half_edges_[number(h)]); }
  /// Prefetches the label that the edge of `h` has, or may get.
  void prefetch_label(HalfEdge h) const { labels_.prefetch(number(h)); }
  /// The next half-edge that starts at the same vertex, counter-clockwise.
  [[nodiscard]] HalfEdge next_around(HalfEdge h) const { return twin(previous(h)); }
  /// The next half-edge that starts at the same vertex, clockwise.
  [[nodiscard]] HalfEdge previous_around(HalfEdge h) const { return next(twin(h)); }
  [[nodiscard]] bool is_fixed(HalfEdge h) const { return (half_edges_[number(h)].twin & kFixed) != 0; }
  [[nodiscard]] Label label(HalfEdge h) const { return is_fixed(h) ? labels_[number(h)] : 0; }
  /// The half-edge from `from` to `to`, or kNoHalfEdge. Cost: proportional to the number of edges of the vertex with
  /// fewer edges.
  [[nodiscard]] HalfEdge find(Vertex from, Vertex to) const;
  /// A vertex has *many* edges if it has more edges than this.
  static constexpr std::size_t kFewEdges = 16;
  /// Whether `v` has many edges. Cost: O(1).
  [[nodiscard]] bool has_many_edges(Vertex v) const;
  /// Whether `u` has many edges, and more than `v`. Cost: O(1), or proportional to the number of edges of the vertex
  /// with fewer edges.
  [[nodiscard]] bool has_many_and_more_edges(Vertex u, Vertex v) const;

  [[nodiscard]] std::size_t vertex_count() const { return outgoing_.size() - free_vertex_count_; }
  [[nodiscard]] std::size_t face_count() const { return half_edges_.size() / 3 - free_face_count_; }
  /// The number of slots of vertices, including free slots: the index of every vertex is below it. face_slots() returns
  /// the number of slots of faces.
  [[nodiscard]] std::uint32_t vertex_slots() const { return static_cast<std::uint32_t>(outgoing_.size()); }
  [[nodiscard]] std::uint32_t face_slots() const { return static_cast<std::uint32_t>(half_edges_.size() / 3); }
  [[nodiscard]] bool is_live(Vertex v) const { return (outgoing_[number(v)] & kFree) == 0; }
  [[nodiscard]] bool is_live(Face f) const { return origin(first(f)) != kNoVertex; }

  /// Calls visit(h) for every half-edge that starts at `v`, counter-clockwise. Cost: linear in their number.
  template <class Visit>
  void for_each_outgoing(Vertex v, Visit&& visit) const {
    const HalfEdge start = outgoing(v);
    HalfEdge h = start;
    do {
      visit(h);
      h = next_around(h);
    } while (h != start);
  }

  // Changes.

  [[nodiscard]] Vertex add_vertex();
  /// Removes a vertex. Requires: `v` is not a vertex of any face.
  void free_vertex(Vertex v);
  [[nodiscard]] Face add_face();
  /// Removes a face. Requires: no half-edge of another face has a half-edge of `f` as its twin.
  void free_face(Face f);
  /// Sets the vertices of `f`, but no twins and labels. Sets the outgoing half-edge of each vertex to one of `f`.
  void set_vertices(Face f, Vertex a, Vertex b, Vertex c);
  void set_outgoing(Vertex v, HalfEdge h) { outgoing_[number(v)] = number(h); }
  /// Makes `g` and `h` twins and sets the label of their edge.
  void link(HalfEdge g, HalfEdge h, Label label);
  /// Sets the label of the edge of `h`. If it is 0, the edge is no longer fixed.
  void set_label(HalfEdge h, Label label);

  /// Puts `v` into `f` and connects it to the three vertices of `f`. Returns the half-edges opposite to `v`,
  /// counter-clockwise around it; the first is first(f).
  std::array<HalfEdge, 3> split_face(Face f, Vertex v);
  /// Puts `v` on the edge of `h` and connects it to the apexes of `h` and its twin. Both halves of the edge keep its
  /// label. `h` is then the half-edge from its origin to `v`. Returns the half-edges opposite to `v`, counter-clockwise
  /// around it.
  std::array<HalfEdge, 4> split_edge(HalfEdge h, Vertex v);
  /// The result of flip(h). Let c be the apex of `h`, and d the apex of its twin, before the flip.
  struct Flipped {
    HalfEdge diagonal;  ///< the half-edge of the new edge from d to c
    HalfEdge opposite;  ///< the half-edge from d to the old target of `h`; its apex is c
  };
  /// Replaces the edge of `h` by the other diagonal of its quadrilateral. Afterwards `h` ends at d and has the apex c.
  /// Requires: the edge is not fixed, and the four vertices of the quadrilateral are distinct.
  Flipped flip(HalfEdge h);

  /// A triangle of a polygon, counter-clockwise. `from`, `apex` and `to` are the indices of its vertices in the list of
  /// the polygon's vertices.
  struct Triangle {
    std::uint32_t from, apex, to;
  };
  /// Fills a cavity with triangles. `border` lists consecutive half-edges on the cavity's border, with the cavity on
  /// their left. The cavity consists of the faces of these half-edges and, if close() follows, of the face of its
  /// argument `old`. The new triangles use the slots of the faces of `border`. One edge of the cavity is not in
  /// `border`: the base, from the end of the last half-edge to the start of the first. `triangles` has one entry fewer
  /// than `border`. Its first triangle lies on the base. Each triangle comes before the triangles that share the edge
  /// `from` - `apex` or the edge `apex` - `to` with it. Returns the half-edge of the base, which has no twin until
  /// link() or close() sets it. Overwrites `border`. Requires: no two half-edges of `border` belong to one face; the
  /// other half-edges of these faces lie inside the cavity.
  HalfEdge refill(std::span<HalfEdge> border, std::span<const Triangle> triangles);
  /// Closes a cavity after refill(), if the base of the cavity is the edge of an old half-edge `old`. `base`, the
  /// result of refill(), replaces `old`. Frees the face of `old`.
  void close(HalfEdge base, HalfEdge old);

  /// Allocates the memory for the label of every edge. Cost: linear.
  void make_room_for_labels();

  /// Empties the undo log.
  void begin();
  /// Undoes all edits since begin(), the last edit first. Allocates nothing. Afterwards the undo log is empty.
  void roll_back();
  /// Calls visit(face, touch) for each edit of a face since begin(), in order. The next function does the same for
  /// vertices: it calls visit(vertex, touch) for each new or removed vertex.
  template <class Visit>
  void for_each_touched_face(Visit&& visit) const {
    journal_.for_each([&](const Undo& edit) {
      switch (edit.kind) {
        case EditKind::add_face:
          visit(Face{edit.index}, Touch::made);
          break;
        case EditKind::free_face:
          visit(Face{edit.index}, Touch::freed);
          break;
        case EditKind::rebuild_face:
        case EditKind::split_face:
          visit(Face{edit.index}, Touch::rebuilt);
          break;
        case EditKind::split_edge:
        case EditKind::flip:
          visit(face(HalfEdge{edit.saved}), Touch::rebuilt);
          [[fallthrough]];
        case EditKind::set_label:
        case EditKind::set_label_of_twin:
          visit(face(HalfEdge{edit.index}), Touch::rebuilt);
          break;
        case EditKind::relabel:
        case EditKind::relabel_twin:
          visit(face(HalfEdge{edit.index}), Touch::relabelled);
          break;
        case EditKind::add_vertex:
        case EditKind::free_vertex:
        case EditKind::save_label:
          break;
      }
    });
  }
  template <class Visit>
  void for_each_touched_vertex(Visit&& visit) const {
    journal_.for_each([&](const Undo& edit) {
      if (edit.kind == EditKind::add_vertex) visit(Vertex{edit.index}, Touch::made);
      if (edit.kind == EditKind::free_vertex) visit(Vertex{edit.index}, Touch::freed);
    });
  }

  /// Returns a description of the first broken link, label, loop or free list, or nothing. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault() const;

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::faces, half_edges_);
    memory::count(use, &MemoryUse::vertices, outgoing_);
    labels_.count_memory(use, &MemoryUse::walls);
    memory::count_spare(use, saved_faces_);
    journal_.count_memory(use);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(half_edges_, outgoing_);
    labels_.shrink_to_fit();
    memory::release(saved_faces_);
    journal_.release();
  }

 private:
  friend class UnloggedMesh;

  [[nodiscard]] HalfEdge find_in_turn(Vertex from, Vertex to) const;

  static constexpr std::uint32_t kFixed = 0x80000000;
  static constexpr std::uint32_t kFree = 0x80000000;

  enum class EditKind : std::uint8_t {
    add_vertex,
    free_vertex,
    add_face,
    free_face,
    rebuild_face,
    split_face,
    split_edge,
    flip,
    set_label,
    set_label_of_twin,  ///< the entry of a set_label for the face of the twin; it saves no label
    relabel,            ///< set_label for an edge that was fixed and stays fixed
    relabel_twin,       ///< as set_label_of_twin, but for a relabel
    save_label,         ///< saves the label of a fixed edge of a face that the operation is about to rebuild or free
  };
  /// The record of an edit: an elementary change of the mesh. `index` is the number of the vertex, face or half-edge
  /// that has changed.
  struct Undo {
    EditKind kind;
    std::uint32_t index;
    /// For set_label, relabel and save_label: the old label. For rebuild_face: the index in `saved_faces_`. For
    /// split_edge and flip: the twin of `index`.
    std::uint32_t saved;
  };
  using SavedFace = std::array<HalfEdgeRecord, 3>;

  void log(EditKind kind, std::uint32_t index, std::uint32_t saved = 0) { journal_.add({kind, index, saved}); }
  void undo(const Undo& edit);
  void undo_split_face(Face f);
  void undo_split_edge(HalfEdge h);
  void undo_flip(HalfEdge h);
  void save(Face f);
  void restore(Face f, const SavedFace& saved);
  void drop(Face f);
  void join(HalfEdge h, HalfEdge old);
  [[nodiscard]] bool lacks_twin(HalfEdge h) const { return half_edges_[number(h)].twin == number(kNoHalfEdge); }
  void push_free_face(Face f);
  [[nodiscard]] Face pop_free_face();
  void push_free_vertex(Vertex v);
  [[nodiscard]] Vertex pop_free_vertex();
  void write_label(HalfEdge h, Label label);
  void make_room_for_label(HalfEdge g, HalfEdge h);
  Flipped flip_unlogged(HalfEdge h);
  void make_room_to_take_over(HalfEdge to, HalfEdge from);

  /// Moves the twin and label of `from` to `to`. `from` represents an edge before its face is rebuilt, and `to`
  /// represents this edge afterwards.
  void take_over(HalfEdge to, HalfEdge from);
  void set_origin(HalfEdge h, Vertex v) { half_edges_[number(h)].origin = v; }

  memory::Array<HalfEdgeRecord> half_edges_;
  memory::Pages<Label> labels_;            ///< by half-edge; has room for every half-edge of a fixed edge
  memory::Array<std::uint32_t> outgoing_;  ///< by vertex; if kFree is set: the next free vertex
  memory::FreeList free_faces_;            ///< linked by the twin of the first half-edge
  memory::FreeList free_vertices_;         ///< linked by `outgoing_`
  std::size_t free_face_count_ = 0;
  std::size_t free_vertex_count_ = 0;

  memory::Journal<Undo> journal_;
  std::vector<SavedFace> saved_faces_;
};

/// Changes a piece of a TriangleMesh without its undo log. Several threads can change one mesh at once, each with an
/// object of its own.
///
/// Requires: TriangleMesh::make_room_for_labels() has been called. Each thread has a set of vertices of its own, and
/// these sets are disjoint. A thread changes only faces whose three vertices are its own. If another face has a vertex
/// of the thread's own, the thread may read the vertices of this face, and the twins and labels of its edges that have
/// an end of the thread's own. (If the thread reads `twin`, `label` or `is_fixed` of an edge between two vertices of
/// other threads, this is a data race.) Then no thread reads data that another one writes: a thread writes the twin and
/// the label of an edge only if both ends of the edge are its own, and the vertices of a face only if all three are.
class UnloggedMesh {
 public:
  explicit UnloggedMesh(TriangleMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] HalfEdge twin(HalfEdge h) const { return mesh_.twin(h); }
  [[nodiscard]] Vertex origin(HalfEdge h) const { return mesh_.origin(h); }
  [[nodiscard]] Vertex target(HalfEdge h) const { return mesh_.target(h); }
  [[nodiscard]] Vertex apex(HalfEdge h) const { return mesh_.apex(h); }
  [[nodiscard]] HalfEdge outgoing(Vertex v) const { return mesh_.outgoing(v); }
  [[nodiscard]] HalfEdge next_around(HalfEdge h) const { return mesh_.next_around(h); }
  [[nodiscard]] bool is_fixed(HalfEdge h) const { return mesh_.is_fixed(h); }
  [[nodiscard]] Label label(HalfEdge h) const { return mesh_.label(h); }
  [[nodiscard]] HalfEdge find(Vertex from, Vertex to) const { return mesh_.find(from, to); }
  [[nodiscard]] bool has_many_and_more_edges(Vertex u, Vertex v) const { return mesh_.has_many_and_more_edges(u, v); }
  [[nodiscard]] bool is_live(Face f) const { return mesh_.is_live(f); }

  /// Keeps the face for add_face(). Until then, is_live() is false.
  void free_face(Face f) {
    free_faces_.push_back(f);
    mesh_.half_edges_[number(first(f))].origin = kNoVertex;
  }
  /// Returns the face that was freed last. Requires: add_face() has not yet returned all faces that were freed.
  [[nodiscard]] Face add_face() {
    const Face f = free_faces_.back();
    free_faces_.pop_back();
    return f;
  }
  void set_vertices(Face f, Vertex a, Vertex b, Vertex c) { mesh_.set_vertices(f, a, b, c); }
  void link(HalfEdge g, HalfEdge h, Label label) { mesh_.link(g, h, label); }
  void set_label(HalfEdge h, Label label) { mesh_.write_label(h, label); }
  TriangleMesh::Flipped flip(HalfEdge h) { return mesh_.flip_unlogged(h); }

 private:
  TriangleMesh& mesh_;
  std::vector<Face> free_faces_;
};

}  // namespace waywright::mesh
