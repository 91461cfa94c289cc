#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/compiler.hpp"
#include "memory/count.hpp"
#include "memory/free_list.hpp"
#include "memory/journal.hpp"
#include "memory/pages.hpp"
#include "mesh/index.hpp"

namespace waywright::mesh {

/// What an edge carries for the layers above; the mesh only copies it. An edge with a label other than 0 is fixed: it
/// is never flipped.
using Label = std::uint32_t;

/// A triangulated sphere: every half-edge has a twin, every vertex a closed loop of faces. A triangulated polygon
/// becomes one by a ghost vertex, joined to every vertex of its border; the faces there are ghosts too. Pure topology:
/// nothing here sees a coordinate.
///
/// Freed slots are reused, the last freed first. Indices stay valid until their vertex or face is freed; which
/// half-edge stands for an edge changes when a flip next to it rebuilds its face.
///
/// Changes are logged as they are made: since begin(), they can all be taken back, and which faces and vertices they
/// touched can be asked for.
///
/// Source: Chen 2009, section 3.1 (half-edges, vertex and face loops: algorithms 1 and 2).
class TriangleMesh {
 public:
  /// What the changes since begin() did to a face or vertex. One that was touched more than once is told more than
  /// once, in order.
  enum class Touch : std::uint8_t { made, rebuilt, freed };

  /// A half-edge as it is stored.
  struct Corner {
    std::uint32_t twin;  ///< the highest bit says that the edge is fixed; of a free face's first, the next free face
    Vertex origin;       ///< kNoVertex in a free face
  };

  TriangleMesh() = default;
  /// A mesh as it was made elsewhere: three half-edges a face, none of them free or fixed, and `vertex_count` vertices,
  /// each the origin of some.
  TriangleMesh(std::vector<Corner> corners, std::size_t vertex_count);

  // Walking about. Each is O(1).
  [[nodiscard]] HalfEdge twin(HalfEdge h) const { return HalfEdge{corners_[number(h)].twin & ~kFixed}; }
  [[nodiscard]] Vertex origin(HalfEdge h) const { return corners_[number(h)].origin; }
  [[nodiscard]] Vertex target(HalfEdge h) const { return origin(next(h)); }
  /// The corner of the half-edge's face that isn't on the half-edge.
  [[nodiscard]] Vertex apex(HalfEdge h) const { return origin(previous(h)); }
  /// Some half-edge that starts at `v`.
  [[nodiscard]] HalfEdge outgoing(Vertex v) const { return HalfEdge{outgoing_[number(v)]}; }
  /// Has the memory fetched that outgoing(v) reads.
  void prefetch(Vertex v) const { base::prefetch(&outgoing_[number(v)]); }
  /// Has the memory of the face of `h` fetched.
  void prefetch(HalfEdge h) const { base::prefetch(&corners_[number(h)]); }
  /// The next half-edge that starts at the same vertex, counter-clockwise.
  [[nodiscard]] HalfEdge next_around(HalfEdge h) const { return twin(previous(h)); }
  /// The next half-edge that starts at the same vertex, clockwise.
  [[nodiscard]] HalfEdge previous_around(HalfEdge h) const { return next(twin(h)); }
  [[nodiscard]] bool is_fixed(HalfEdge h) const { return (corners_[number(h)].twin & kFixed) != 0; }
  [[nodiscard]] Label label(HalfEdge h) const { return is_fixed(h) ? labels_[number(h)] : 0; }
  /// The half-edge from `from` to `to`, or kNoHalfEdge. Cost: the degree of `from`.
  [[nodiscard]] HalfEdge find(Vertex from, Vertex to) const;

  [[nodiscard]] std::size_t vertex_count() const { return outgoing_.size() - free_vertex_count_; }
  [[nodiscard]] std::size_t face_count() const { return corners_.size() / 3 - free_face_count_; }
  /// Slots, the free ones included: one more than the largest index there may be.
  [[nodiscard]] std::uint32_t vertex_slots() const { return static_cast<std::uint32_t>(outgoing_.size()); }
  [[nodiscard]] std::uint32_t face_slots() const { return static_cast<std::uint32_t>(corners_.size() / 3); }
  [[nodiscard]] bool is_alive(Vertex v) const { return (outgoing_[number(v)] & kFree) == 0; }
  [[nodiscard]] bool is_alive(Face f) const { return origin(first(f)) != kNoVertex; }

  /// Calls visit(h) for every half-edge that starts at `v`, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(Vertex v, Visit&& visit) const {
    const HalfEdge start = outgoing(v);
    HalfEdge h = start;
    do {
      visit(h);
      h = next_around(h);
    } while (h != start);
  }

  // Changing.

  [[nodiscard]] Vertex add_vertex();
  /// Requires: no face has `v` as a corner.
  void free_vertex(Vertex v);
  [[nodiscard]] Face add_face();
  /// Requires: no half-edge of another face names one of `f` as its twin.
  void free_face(Face f);
  /// Gives `f` its corners, without twins and labels; each corner's outgoing half-edge is one of `f`.
  void set_corners(Face f, Vertex a, Vertex b, Vertex c);
  void set_outgoing(Vertex v, HalfEdge h) { outgoing_[number(v)] = number(h); }
  /// Makes twins of `g` and `h`, with that label on their edge.
  void link(HalfEdge g, HalfEdge h, Label label);
  /// Labels the edge of `h`; 0 frees it.
  void set_label(HalfEdge h, Label label);

  /// Puts `v` into `f`, joined to its three corners. Returns the half-edges opposite to `v`, counter-clockwise around
  /// it; the first is first(f).
  std::array<HalfEdge, 3> split_face(Face f, Vertex v);
  /// Puts `v` on the edge of `h`, joined to the apex on each side. Both halves carry the edge's label. `h` is then the
  /// half from its origin to `v`. Returns the half-edges opposite to `v`, counter-clockwise around it.
  std::array<HalfEdge, 4> split_edge(HalfEdge h, Vertex v);
  /// Turns the edge of `h` in its quadrilateral, whose apexes are c on the side of `h` and d on the other. Returns the
  /// half of the new edge that runs from d to c. Afterwards `h` and the half-edge that followed the new one's twin,
  /// returned as `opposite`, are the two sides of the quadrilateral that d's corners face: both have c as their apex.
  /// Requires: the edge isn't fixed, and the quadrilateral's four corners are distinct.
  struct Flipped {
    HalfEdge diagonal;
    HalfEdge opposite;
  };
  Flipped flip(HalfEdge h);

  /// A triangle of a polygon, by the positions of its corners, counter-clockwise, among the polygon's.
  struct Triangle {
    std::uint32_t from, apex, to;
  };
  /// Refills a hole with the faces that it was made of: those of `sides`, which run in a row along its border, the hole
  /// on their left. `triangles` are one fewer than `sides`: the first stands on the hole's base, from the end of the
  /// last side back to the start of the first, and each comes before those on its edges from - apex and apex - to.
  /// Returns the base's half-edge; it has no twin until link() or close() gives it one. Uses up `sides`.
  /// Requires: no two of `sides` are of one face; the faces' other half-edges lie inside the hole.
  HalfEdge refill(std::span<HalfEdge> sides, std::span<const Triangle> triangles);
  /// Closes a hole whose base is a side of it as well: `base`, from refill(), takes the place of `side`, whose face
  /// goes.
  void close(HalfEdge base, HalfEdge side);

  /// Starts the log anew.
  void begin();
  /// Takes back everything since begin(), the last change first. Allocates nothing. Afterwards the log is empty.
  void roll_back();
  /// Calls visit(face, touch), or visit(vertex, touch), for each change since begin().
  template <class Visit>
  void for_each_touched_face(Visit&& visit) const {
    journal_.for_each([&](const Undo& change) {
      switch (change.kind) {
        case ChangeKind::add_face:
          visit(Face{change.index}, Touch::made);
          break;
        case ChangeKind::free_face:
          visit(Face{change.index}, Touch::freed);
          break;
        case ChangeKind::rebuild_face:
        case ChangeKind::split_face:
          visit(Face{change.index}, Touch::rebuilt);
          break;
        case ChangeKind::split_edge:
        case ChangeKind::flip:
          visit(face(HalfEdge{change.saved}), Touch::rebuilt);
          [[fallthrough]];
        case ChangeKind::set_label:
        case ChangeKind::set_label_of_twin:
          visit(face(HalfEdge{change.index}), Touch::rebuilt);
          break;
        case ChangeKind::add_vertex:
        case ChangeKind::free_vertex:
        case ChangeKind::rebuild_label:
          break;
      }
    });
  }
  template <class Visit>
  void for_each_touched_vertex(Visit&& visit) const {
    journal_.for_each([&](const Undo& change) {
      if (change.kind == ChangeKind::add_vertex) visit(Vertex{change.index}, Touch::made);
      if (change.kind == ChangeKind::free_vertex) visit(Vertex{change.index}, Touch::freed);
    });
  }

  /// The first broken link, label, loop or free list found, or nothing. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault() const;

  void count_memory(MemoryUse& use) const {
    memory::count(use, &MemoryUse::faces, corners_);
    memory::count(use, &MemoryUse::vertices, outgoing_);
    labels_.count_memory(use, &MemoryUse::walls);
    memory::count_spare(use, saved_faces_);
    journal_.count_memory(use);
  }
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    memory::shrink(corners_, outgoing_);
    labels_.shrink_to_fit();
    memory::release(saved_faces_);
    journal_.release();
  }

 private:
  static constexpr std::uint32_t kFixed = 0x80000000;
  static constexpr std::uint32_t kFree = 0x80000000;

  enum class ChangeKind : std::uint8_t {
    add_vertex,
    free_vertex,
    add_face,
    free_face,
    rebuild_face,
    split_face,
    split_edge,
    flip,
    set_label,
    set_label_of_twin,
    rebuild_label,
  };
  /// How a change is taken back: `index` is its vertex, face or half-edge.
  struct Undo {
    ChangeKind kind;
    std::uint32_t index;
    /// Of set_label and rebuild_label, the label before; of rebuild_face, the position in `saved_faces_`; of split_edge
    /// and flip, the twin.
    std::uint32_t saved;
  };
  using SavedFace = std::array<Corner, 3>;

  void log(ChangeKind kind, std::uint32_t index, std::uint32_t saved = 0) { journal_.add({kind, index, saved}); }
  void undo(const Undo& change);
  void undo_split_face(Face f);
  void undo_split_edge(HalfEdge h);
  void undo_flip(HalfEdge h);
  void save(Face f);
  void restore(Face f, const SavedFace& saved);
  void drop(Face f);
  void join(HalfEdge h, HalfEdge side);
  [[nodiscard]] bool is_open(HalfEdge h) const { return corners_[number(h)].twin == number(kNoHalfEdge); }
  void push_free_face(Face f);
  [[nodiscard]] Face pop_free_face();
  void push_free_vertex(Vertex v);
  [[nodiscard]] Vertex pop_free_vertex();
  void write_label(HalfEdge h, Label label);
  void make_room_for_label(HalfEdge g, HalfEdge h);
  void make_room_to_take_over(HalfEdge to, HalfEdge from);

  /// Gives `to` the twin and label that `from` has; both name the same edge, before and after its face is rebuilt.
  void take_over(HalfEdge to, HalfEdge from);
  void set_origin(HalfEdge h, Vertex v) { corners_[number(h)].origin = v; }

  std::vector<Corner> corners_;
  memory::Pages<Label> labels_;          ///< by half-edge; has room wherever the edge is fixed
  std::vector<std::uint32_t> outgoing_;  ///< by vertex; with kFree set, the next free vertex
  memory::FreeList free_faces_;          ///< linked by the twin of the first corner
  memory::FreeList free_vertices_;       ///< linked by `outgoing_`
  std::size_t free_face_count_ = 0;
  std::size_t free_vertex_count_ = 0;

  memory::Journal<Undo> journal_;
  std::vector<SavedFace> saved_faces_;
};

}  // namespace waywright::mesh
