#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "memory/count.hpp"
#include "memory/journal.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::nav {

/// The two-core of the graph whose nodes are the faces and whose edges are the passages between them. To find it,
/// remove all faces with at most one passage, and repeat this until no such face is left. The remaining faces are the
/// two-core. The other faces (*tree faces*) form trees that hang on the core. For each tree face, the class stores the
/// passage that leads towards the core. In a component without a core, it stores the passage that leads towards one
/// face, the root. Every face of such a component could be its root.
///
/// The functions is_core_passage(), core_passages() and core_degree() count only passages from one face of the core to
/// another.
///
/// update() updates the core after a change of the mesh. Its cost depends on the number of faces that have changed and
/// of faces whose state changes. Memory: one byte per face.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006 (the abstraction). In the paper, a
/// face of a tree has the degree 1, a face of a corridor has the degree 2, and a junction has the degree 3. Difference:
/// the authors rebuild the abstraction after each change.
class TwoCore {
 public:
  /// Finds the two-core of the faces in the domain. Cost: linear. The scratch memory is only the undo log of one chain
  /// of faces that leave the core one after the other.
  explicit TwoCore(const constraint::ConstrainedTriangulation& triangulation);

  /// Prefetches the memory with the state of a face.
  WAYWRIGHT_ALWAYS_INLINE void prefetch(mesh::Face f) const { base::prefetch_to_write(&states_[number(f)]); }
  /// Returns whether the face is in the core: it lies on a cycle of the graph, or on a connection between two cycles.
  [[nodiscard]] bool is_core(mesh::Face f) const { return (states_[number(f)] & kCore) != 0; }
  /// Returns whether `h` is a passage from one face of the core to another.
  [[nodiscard]] bool is_core_passage(mesh::HalfEdge h) const { return is_core_passage(mesh::face(h), h); }
  /// Returns whether `h`, a half-edge of `f`, is a passage from one face of the core to another. Saves the division
  /// that finds the face.
  [[nodiscard]] bool is_core_passage(mesh::Face f, mesh::HalfEdge h) const {
    return (states_[number(f)] >> mesh::index_in(f, h) & 1U) != 0;
  }
  /// The face's passages to other faces of the core: bit i stands for the face's half-edge number i.
  [[nodiscard]] unsigned core_passages(mesh::Face f) const { return states_[number(f)] & unsigned{kPassages}; }
  /// The number of these passages: 0 outside the core, 2 in a corridor, 3 at a junction.
  [[nodiscard]] unsigned core_degree(mesh::Face f) const {
    return static_cast<unsigned>(std::popcount(core_passages(f)));
  }
  /// Returns the half-edge by which a tree face leads towards the core, or kNoHalfEdge for the root of a component
  /// without a core. Requires: `f` is not in the core.
  [[nodiscard]] mesh::HalfEdge towards_core(mesh::Face f) const {
    const std::uint32_t i = states_[number(f)] >> kPassageShift & 3U;
    return i == kNoPassage ? mesh::kNoHalfEdge : mesh::half_edge(f, i);
  }

  /// Returns core_passages(f) for a face of the core, and the passage towards the core for a tree face: one bit for
  /// each half-edge of the face.
  [[nodiscard]] unsigned passages_towards_core(mesh::Face f) const {
    if (is_core(f)) return core_passages(f);
    const mesh::HalfEdge up = towards_core(f);
    return up == mesh::kNoHalfEdge ? 0 : 1U << mesh::index_in(f, up);
  }

  /// Returns whether the face of `h` is a tree face, and `h` leads from there towards the core.
  [[nodiscard]] bool leads_up(mesh::HalfEdge h) const {
    const State state = states_[number(h) / 3];
    return (state & kCore) == 0 && (state >> kPassageShift & 3U) == number(h) % 3;
  }

  /// Updates the core to the mesh. `changed` lists the faces that have changed since the last update.
  /// `new_faces` lists those faces of `changed` that are in the graph now. Each list contains a face once.
  /// component_of(f) returns the connected component of the graph before the change that contained the face. If memory
  /// runs out, roll_back() restores the old core.
  template <class ComponentOf>
  void update(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> changed,
              std::span<const mesh::Face> new_faces, ComponentOf&& component_of) {
    topless_.clear();
    for (const mesh::Face f : changed) {
      if (is_absent(f) || !(is_core(f) || states_[number(f)] == kRoot)) continue;
      const std::uint32_t component = component_of(f);
      if (topless_.empty() || topless_.back() != component) topless_.push_back(component);
    }
    const auto is_topless = [&](mesh::Face f) {
      return std::find(topless_.begin(), topless_.end(), component_of(f)) != topless_.end();
    };
    const Surroundings around = join_all(mesh, changed, new_faces);
    finish_update(mesh, new_faces, around, around.trees == 1 && !around.has_core && !is_topless(around.tree));
  }

  /// Returns whether the face was not in the graph after the last update.
  [[nodiscard]] bool is_absent(mesh::Face f) const {
    return number(f) >= states_.size() || states_[number(f)] == kAbsent;
  }
  /// Does the same as update(). Requires: all faces of `changed` that were in the graph had three passages to faces of
  /// the core, and all faces of `new_faces` have three passages.
  void update_in_open_space(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> changed,
                            std::span<const mesh::Face> new_faces);

  /// Returns the first difference from `other`, another core of the same graph, or nothing if there is none. The two
  /// may differ in the roots of trees without a core, but each such tree must have a root.
  [[nodiscard]] std::optional<std::string> find_difference(const mesh::TriangleMesh& mesh, const TwoCore& other,
                                                           std::span<const mesh::Face> faces) const;

  /// Calls visit(face) for each face whose state update() or update_in_open_space() has written since begin().
  template <class Visit>
  void for_each_written_face(Visit&& visit) const {
    states_.for_each_written([&](std::uint32_t f) { visit(mesh::Face{f}); });
  }

  /// Clears the undo log.
  void begin() { states_.begin(); }
  /// Takes back everything since begin(). Allocates nothing.
  void roll_back() { states_.roll_back(); }

  void count_memory(MemoryUse& use) const {
    states_.count_memory(use, &MemoryUse::abstraction);
    memory::count_spare(use, to_peel_, topless_);
  }
  /// Frees spare memory. Requires: nothing has changed since begin().
  void shrink_to_fit() {
    states_.shrink_to_fit();
    memory::release(to_peel_, topless_);
  }

 private:
  // The state of a face: a bit for each half-edge that is a passage in the core; the number (0 to 2) of the half-edge
  // that leads towards the core; and whether the face is in the core.
  using State = std::uint8_t;
  static constexpr State kPassages = 7;
  static constexpr State kPassageShift = 3;
  static constexpr State kNoPassage = 3;
  static constexpr State kRoot = kNoPassage << kPassageShift;
  static constexpr State kCore = 1 << 5;
  static constexpr State kAbsent = kRoot | 1 << 6;  ///< not in the graph
  static constexpr State kNew = 1 << 7;             ///< set only during an update

  [[nodiscard]] static State passage_bit(mesh::HalfEdge h) { return static_cast<State>(1U << number(h) % 3); }
  [[nodiscard]] static State tree_state(mesh::HalfEdge h) { return static_cast<State>(number(h) % 3 << kPassageShift); }
  [[nodiscard]] std::vector<mesh::Face> tops(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> faces) const;
  void write(mesh::Face f, State state);
  void add_passage(mesh::HalfEdge h);
  /// Facts about the old faces that are adjacent to the new faces.
  struct Surroundings {
    std::size_t trees = 0;  ///< the number of passages from new faces to tree faces that do not hang on them
    mesh::Face tree{0};     ///< the tree face at the last of these passages
    bool has_core = false;  ///< whether a face of the old core has got a passage to a new face
  };
  [[nodiscard]] Surroundings join_all(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> changed,
                                      std::span<const mesh::Face> new_faces);
  void finish_update(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> new_faces, const Surroundings& around,
                     bool hangs_on_one);
  void join(const mesh::TriangleMesh& mesh, mesh::Face f, Surroundings& around);
  void climb_trees(const mesh::TriangleMesh& mesh, std::span<const mesh::Face> new_faces);
  void climb(const mesh::TriangleMesh& mesh, mesh::HalfEdge back);
  void peel(const mesh::TriangleMesh& mesh);
  void peel_from(const mesh::TriangleMesh& mesh, mesh::Face f);

  memory::JournaledArray<State> states_;  ///< by face

  // Scratch.
  std::vector<mesh::Face> to_peel_;     ///< faces of the core that may have fewer than two passages
  std::vector<std::uint32_t> topless_;  ///< the old components that have lost their root or a face of the core
};

}  // namespace waywright::nav
