#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "constraint/exact_triangulation.hpp"
#include "memory/count.hpp"
#include "memory/journaled_array.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// The faces as a graph whose edges are the mesh's free edges, reduced: its 2-core, what is left when faces with one
/// way on are taken away again and again, and the trees that hang off it. A face outside the core knows which way leads
/// towards the core; in a component that is all tree, towards one of its faces, the root, which is as good as any
/// other.
///
/// Kept up from one mesh to the next, at the cost of the faces that changed and those whose answer does. One byte a
/// face.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (the abstraction; degree 1 is a
/// tree, 2 a corridor, 3 a junction). Departure: theirs is rebuilt.
class TwoCore {
 public:
  /// That of a triangulation's faces in the box. Cost: linear, and no memory besides what stays but for the longest
  /// dead end.
  explicit TwoCore(const constraint::ExactTriangulation& triangulation);

  /// Whether the face lies on a ring of ways, or between two.
  [[nodiscard]] bool is_core(mesh::Face f) const { return (states_[number(f)] & kCore) != 0; }
  /// Whether the way over `h` joins two faces of the core.
  [[nodiscard]] bool is_way(mesh::HalfEdge h) const { return is_way(mesh::face(h), h); }
  /// The same, of a side of `f`.
  [[nodiscard]] bool is_way(mesh::Face f, mesh::HalfEdge h) const {
    return (states_[number(f)] >> (number(h) - 3 * number(f)) & 1U) != 0;
  }
  /// The face's ways in the core, a bit for each of its half-edges from the first.
  [[nodiscard]] unsigned ways(mesh::Face f) const { return states_[number(f)] & unsigned{kWays}; }
  /// The face's number of ways in the core: 0 outside of it, 2 in a corridor, 3 at a junction.
  [[nodiscard]] unsigned degree(mesh::Face f) const { return static_cast<unsigned>(std::popcount(ways(f))); }
  /// Of a face outside the core, its half-edge towards it, or kNoHalfEdge for the root of a component without a core.
  [[nodiscard]] mesh::HalfEdge towards_core(mesh::Face f) const {
    const std::uint32_t side = states_[number(f)] >> kSideShift & 3U;
    return side == kNoSide ? mesh::kNoHalfEdge : mesh::HalfEdge{3 * number(f) + side};
  }

  /// Whether, outside the core, `h` leads from its face towards it.
  [[nodiscard]] bool leads_up(mesh::HalfEdge h) const {
    const State state = states_[number(h) / 3];
    return (state & kCore) == 0 && (state >> kSideShift & 3U) == number(h) % 3;
  }

  /// Brings everything up to the mesh. `gone` are the faces, by slot, that changed since the last time, and `made`
  /// those of them that are now in the graph, each once. Allocates before it changes anything that roll_back() doesn't
  /// know.
  void update(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> gone, std::span<const mesh::Face> made);

  /// Whether the face was none of the graph's at the last time.
  [[nodiscard]] bool is_absent(mesh::Face f) const {
    return number(f) >= states_.size() || states_[number(f)] == kAbsent;
  }
  /// update() where all of `gone` that were in the graph had three ways in the core, and all of `made` have three ways.
  void refill(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> gone, std::span<const mesh::Face> made);

  /// Where another core of the same graph differs, or nothing. The roots of trees without a core may be others, but
  /// each has to have one.
  [[nodiscard]] std::optional<std::string> find_difference(const mesh::TriangleMesh& mesh, const TwoCore& other,
                                                           std::span<const mesh::Face> faces) const;

  /// Calls visit(face) for each face that update() or refill() has written since begin().
  template <class Visit>
  void for_each_written_face(Visit&& visit) const {
    states_.for_each_written([&](std::uint32_t f) { visit(mesh::Face{f}); });
  }

  /// Starts the log anew.
  void begin() { states_.begin(); }
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back() { states_.roll_back(); }

  void count_memory(MemoryUse& use) const {
    states_.count_memory(use, &MemoryUse::abstraction);
    memory::count_spare(use, loose_);
  }
  /// Gives back spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    states_.shrink_to_fit();
    memory::release(loose_);
  }

 private:
  // A face's state: a bit for each half-edge that is a way in the core; the side towards the core; whether it is core.
  using State = std::uint8_t;
  static constexpr State kWays = 7;
  static constexpr State kSideShift = 3;
  static constexpr State kNoSide = 3;
  static constexpr State kRoot = kNoSide << kSideShift;
  static constexpr State kCore = 1 << 5;
  static constexpr State kAbsent = kRoot | 1 << 6;  ///< not in the graph
  static constexpr State kNew = 1 << 7;             ///< while an update lasts

  [[nodiscard]] static State way(mesh::HalfEdge h) { return static_cast<State>(1U << number(h) % 3); }
  [[nodiscard]] static State leaf(mesh::HalfEdge h) { return static_cast<State>(number(h) % 3 << kSideShift); }
  [[nodiscard]] std::vector<mesh::Face> tops(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> faces) const;
  void write(mesh::Face f, State state);
  void add_way(mesh::HalfEdge h);
  /// What the new faces' neighbours among the old ones are, and what was there before.
  struct Surroundings {
    std::size_t trees = 0;  ///< tree faces that don't hang on a new face
    bool has_core = false;
    bool had_top = false;  ///< a root or a face of the core went
  };
  void join(const mesh::TriangleMesh& mesh, mesh::Face f, Surroundings& around);
  void climb_trees(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> made);
  void climb(const mesh::TriangleMesh& mesh, mesh::HalfEdge back);
  void peel(const mesh::TriangleMesh& mesh);
  void peel_from(const mesh::TriangleMesh& mesh, mesh::Face f);

  memory::JournaledArray<State> states_;  ///< by face

  // Scratch, kept for its memory.
  std::vector<mesh::Face> loose_;  ///< faces of the core that may have fewer than two ways
};

}  // namespace waywright::nav
