#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/memory_use.hpp"

#include "constraint/exact_triangulation.hpp"
#include "nav/components.hpp"
#include "nav/two_core.hpp"

namespace waywright::nav {

/// What the searches know about a world's faces before they start: which are joined at all, which polygons cover them,
/// which lie in dead ends. Kept up from operation to operation, rebuilt only where most of the mesh has changed; equal
/// to a rebuild at any time.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Departure: theirs is rebuilt after
/// each change, in time linear in the mesh.
class Abstraction {
 public:
  using Triangulation = constraint::ExactTriangulation;

  /// Of a triangulation; it is told of the same one, wherever that is moved, from then on.
  explicit Abstraction(const Triangulation& triangulation);

  [[nodiscard]] const Components& components() const { return components_; }
  [[nodiscard]] const TwoCore& core() const { return core_; }

  /// Starts an operation. To be told of every polygon that comes or goes, by slot.
  void begin();
  void note_inserted(std::uint32_t polygon) { inserted_.push_back(polygon); }
  void note_removed(std::uint32_t polygon) { removed_.push_back(polygon); }
  /// Brings everything up to the triangulation, whose operation must still be open: either everything or, if memory
  /// runs out, nothing. Cost: what changed, however large the world.
  void update(const Triangulation& triangulation);

  /// Calls visit(face) for each face of which the last update() has changed what is known. Returns false, and calls
  /// nothing, if that update was a rebuild.
  template <class Visit>
  [[nodiscard]] bool for_each_changed_face(Visit&& visit) const {
    if (was_rebuilt_) return false;
    components_.for_each_relabelled_face(visit);
    core_.for_each_written_face(visit);
    return true;
  }

  /// The first difference from a rebuild, or nothing. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault(const Triangulation& triangulation) const;

  void count_memory(MemoryUse& use) const;
  /// Gives back spare memory. Requires: no update is under way.
  void shrink_to_fit();

 private:
  class Guard;

  void rebuild(const Triangulation& triangulation);
  void collect_touched(const mesh::TriangleMesh& mesh);
  void collect_made(const Triangulation& triangulation);
  void drop_replaced();
  [[nodiscard]] bool is_in_the_open(const mesh::TriangleMesh& mesh) const;

  Components components_;
  TwoCore core_;

  bool was_rebuilt_ = false;  ///< by the last update

  std::vector<std::uint32_t> inserted_;  ///< polygons, by slot
  std::vector<std::uint32_t> removed_;

  // Scratch, kept for its memory.
  std::vector<bool> is_touched_;  ///< by face
  std::vector<mesh::Face> gone_;
  std::vector<mesh::Face> made_;
  std::vector<std::uint32_t> common_;
};

}  // namespace waywright::nav
