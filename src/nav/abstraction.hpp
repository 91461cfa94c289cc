#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "waywright/memory_use.hpp"

#include "base/compiler.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "constraint/cover_finder.hpp"
#include "mesh/touched_faces.hpp"
#include "nav/component_update.hpp"
#include "nav/components.hpp"
#include "nav/two_core.hpp"

namespace waywright::nav {

/// The data about the faces of a world that the searches read: which faces are connected, which polygons cover them,
/// and which faces lie in dead ends. update() changes only the entries that an operation concerns, and rebuilds
/// everything only if most of the mesh has changed. The result always equals a rebuilt abstraction, apart from the ids
/// of the components and the choice of roots.
///
/// Source: Demyen and Buro, *Efficient triangulation-based pathfinding*, AAAI 2006. Difference: they rebuild the
/// abstraction after each change, in time linear in the size of the mesh.
class Abstraction {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// The abstraction of a triangulation. Pass the same triangulation to every update(). The triangulation may have been
  /// moved to another object in between: then pass this object.
  explicit Abstraction(const Triangulation& triangulation);
  /// Copies the components and the core. The copy has other connections(). Requires: no operation is under way.
  Abstraction(const Abstraction& other)
      : components_(other.components_), update_(other.update_), core_(other.core_), was_rebuilt_(other.was_rebuilt_) {}
  Abstraction(Abstraction&&) = default;
  Abstraction& operator=(const Abstraction&) = delete;
  Abstraction& operator=(Abstraction&&) = default;
  ~Abstraction() = default;

  [[nodiscard]] const Components& components() const { return components_; }
  [[nodiscard]] const TwoCore& core() const { return core_; }

  /// Prefetches what an update reads and writes of a face, except what it reads of the core.
  WAYWRIGHT_ALWAYS_INLINE void prefetch_component_of(mesh::Face f) const {
    components_.prefetch(f);
    update_.prefetch(f);
  }

  /// A number above 0 that no other object has ever had. It changes whenever an operation may have connected two
  /// components that no polygon covered. So as long as it stays the same, uncovered faces that are not connected stay
  /// unconnected. If an operation only builds or removes an item inside one component, the number stays the same.
  [[nodiscard]] std::uint64_t connections() const { return connections_; }

  /// Starts an operation. Call note_inserted() and note_removed() for every polygon that the operation inserts or
  /// removes. The argument of both functions is the slot of the polygon.
  void begin();
  void note_inserted(std::uint32_t polygon) { inserted_.push_back(polygon); }
  void note_removed(std::uint32_t polygon) { removed_.push_back(polygon); }
  /// Updates the abstraction to the triangulation. `touched` are the faces that the operation has touched. Requires:
  /// the operation of the triangulation has not ended. If memory runs out, nothing changes. Call it at most once in an
  /// operation. Cost: depends on what changed, not on the size of the world.
  void update(const Triangulation& triangulation, const mesh::TouchedFaces& touched);
  /// Ends the operation. Allocates nothing.
  void commit();
  /// Undoes update() and ends the operation. If update() was not called, nothing changes. Allocates nothing. Requires:
  /// commit() was not called.
  void roll_back();

  /// Calls visit(face) for each face whose entry the last update() has changed. Returns false, and does not call
  /// visit(), if that update was a rebuild.
  template <class Visit>
  [[nodiscard]] bool for_each_changed_face(Visit&& visit) const {
    if (was_rebuilt_) return false;
    components_.for_each_changed_face(visit);
    core_.for_each_written_face(visit);
    return true;
  }

  /// Returns the first difference from a rebuilt abstraction, or nothing if there is none. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault(const Triangulation& triangulation) const;

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory. Requires: no update is in progress.
  void shrink_to_fit();

 private:
  class Guard;

  [[nodiscard]] static std::uint64_t new_connections();
  void rebuild(const Triangulation& triangulation);
  void collect_new_faces(const Triangulation& triangulation, const mesh::TouchedFaces& touched);
  void remove_common_polygons();
  [[nodiscard]] bool is_in_open_space(const mesh::TriangleMesh& mesh, const mesh::TouchedFaces& touched) const;

  Components components_;
  ComponentUpdate update_;
  TwoCore core_;

  /// What a rebuild has replaced.
  struct Replaced {
    Components components;
    ComponentUpdate update;
    TwoCore core;
  };

  std::uint64_t connections_ = new_connections();
  bool is_updated_ = false;           ///< whether update() has changed something since begin()
  bool was_rebuilt_ = false;          ///< whether the last update was a rebuild
  std::unique_ptr<Replaced> before_;  ///< set if the operation under way has rebuilt the abstraction

  std::vector<std::uint32_t> inserted_;  ///< polygons, by slot
  std::vector<std::uint32_t> removed_;

  // Scratch.
  std::vector<mesh::Face> new_faces_;  ///< the touched faces that now lie in the domain
  std::vector<std::uint32_t> common_;
};

/// Finds the polygons that cover a position. If the world keeps an abstraction, it reads them from the components.
/// Cost, with an abstraction: O(1) plus the size of the answer.
class ComponentCoverFinder final : public constraint::CoverFinder {
 public:
  /// Sets the abstraction from which this object reads; null for none. Requires: the abstraction exists as long as this
  /// object uses it.
  void use(const Abstraction* abstraction) {
    components_ = abstraction != nullptr ? &abstraction->components() : nullptr;
  }

  const std::vector<std::uint32_t>& of_face(const constraint::ConstrainedTriangulation& triangulation,
                                            mesh::HalfEdge h) override {
    if (components_ == nullptr) return CoverFinder::of_face(triangulation, h);
    polygons_.clear();
    components_->for_each_cover(mesh::face(h), [&](std::uint32_t polygon) { polygons_.push_back(polygon); });
    return polygons_;
  }

  bool is_covered(const constraint::ConstrainedTriangulation& triangulation, mesh::HalfEdge h) override {
    return components_ == nullptr ? CoverFinder::is_covered(triangulation, h) : components_->is_covered(mesh::face(h));
  }

 private:
  const Components* components_ = nullptr;
  std::vector<std::uint32_t> polygons_;
};

}  // namespace waywright::nav
