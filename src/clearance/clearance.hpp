#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"

#include "clearance/bridges.hpp"
#include "constraint/constrained_triangulation.hpp"

namespace waywright::clearance {

/// The bridges of a world's walls.
///
/// Bridges need a mesh in which each vertex is the end of a wall. A ring with one corner is *loose*: it has no side. A
/// point and a segment of length zero have a loose ring. Until an item with a loose ring appears, the bridges
/// belong to the triangulation of the world. Then the class makes a second triangulation, and the bridges belong to
/// that one. It contains the walls alone: each item that has sides, under its id, without its loose rings. The second
/// triangulation stays until shrink_to_fit() finds no loose ring.
class Clearance {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  /// Finds the bridges of a world. The object does not keep a reference to the triangulation, which the program may
  /// move. So pass the triangulation of the world to every function with a parameter `world`.
  explicit Clearance(const Triangulation& world, const SearchLimits& limits = {});
  /// Copies the bridges, and the second triangulation if there is one. Requires: no operation is under way.
  Clearance(const Clearance& other)
      : walls_(other.walls_ ? std::make_unique<Triangulation>(*other.walls_) : nullptr),
        bridges_(std::make_unique<Bridges>(*other.bridges_)) {}
  Clearance& operator=(const Clearance&) = delete;
  ~Clearance() = default;

  /// The triangulation to which bridges() belongs.
  [[nodiscard]] const Triangulation& triangulation_of_walls(const Triangulation& world) const {
    return walls_ ? *walls_ : world;
  }
  /// The second triangulation, or null if there is none.
  [[nodiscard]] const Triangulation* second_triangulation() const { return walls_.get(); }
  [[nodiscard]] const Bridges& bridges() const { return *bridges_; }
  /// A number above 0 that says which bridges these are: it changes whenever the bridges or their triangulation change,
  /// and no other object has ever had it. So a query can recognise the bridges about which it has learnt something.
  [[nodiscard]] std::uint64_t state() const { return state_; }

  /// What the last update() has changed in the second triangulation.
  struct ChangesOfWalls {
    const mesh::TouchedFaces& touched;
    std::span<const std::uint32_t> removed;   ///< polygons, by slot
    std::span<const std::uint32_t> inserted;  ///< polygons, by slot
  };
  /// Requires: the operation that called update() has not ended, and its update() has not made the second
  /// triangulation.
  [[nodiscard]] ChangesOfWalls changes_of_walls() const {
    return {touched_walls_, removed_polygons_, inserted_polygons_};
  }

  /// Makes an operation atomic. If the object is destroyed before commit(), for example because memory ran out, the
  /// destructor undoes update(). Requires: no other operation is under way.
  class UndoGuard {
   public:
    explicit UndoGuard(Clearance& clearance) : clearance_(clearance) { clearance_.begin(); }
    ~UndoGuard() {
      if (!is_committed_) clearance_.roll_back();
    }
    UndoGuard(const UndoGuard&) = delete;
    UndoGuard& operator=(const UndoGuard&) = delete;

    void commit() {
      clearance_.commit();
      is_committed_ = true;
    }

   private:
    Clearance& clearance_;
    bool is_committed_ = false;
  };

  /// Call it for each item that the operation has inserted or is about to remove. Cost: linear in the corners.
  void note_changed(const Triangulation& world, ItemId id);
  /// Updates the bridges, and the second triangulation if there is one, to the triangulation of the world. `touched`
  /// are the faces that the operation has touched. Requires: the operation of that triangulation and an UndoGuard are
  /// open, and the operation calls update() only once. Cost: depends on what changed. The first loose ring costs as
  /// much as a new world.
  void update(const Triangulation& world, const mesh::TouchedFaces& touched);

  /// Returns the first fault, or nothing: the bridges must equal rebuilt bridges, and the second triangulation must
  /// equal one that is built from the live items. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault(const Triangulation& world) const;

  void count_memory(MemoryUse& use) const;
  /// Frees spare memory, and the second triangulation if no item of the world has a loose ring. If memory runs out, the
  /// bridges stay as they were. Requires: no operation is under way. Cost: linear if there is a second triangulation.
  void shrink_to_fit(const Triangulation& world);

 private:
  void begin();
  void commit();
  void roll_back();

  [[nodiscard]] static std::uint64_t new_state();
  [[nodiscard]] bool is_any_changed_loose(const Triangulation& world) const;
  void make_walls(const Triangulation& world);
  void update_walls(const Triangulation& world);
  void insert_walls(const Triangulation& world);

  std::unique_ptr<Triangulation> walls_;  ///< the second triangulation, or null
  std::unique_ptr<Bridges> bridges_;
  std::uint64_t state_ = new_state();

  // The next members belong to the operation under way.
  std::vector<ItemId> changed_;
  ChangedWalls changed_walls_;
  std::optional<Triangulation::UndoGuard> walls_guard_;     ///< set if the operation changes the second triangulation
  mesh::TouchedFaces touched_walls_;                        ///< the touched faces of the second triangulation
  std::optional<mesh::TouchedFaces::Guard> touched_guard_;  ///< set if update() has collected `touched_walls_`
  std::vector<std::uint32_t> removed_polygons_;             ///< see ChangesOfWalls
  std::vector<std::uint32_t> inserted_polygons_;            ///< see ChangesOfWalls
  std::unique_ptr<Bridges> old_bridges_;  ///< the bridges of the world, if the operation made the second triangulation
  bool are_bridges_changed_ = false;

  // Scratch.
  constraint::Outline outline_;
  Shape shape_;
};

}  // namespace waywright::clearance
