#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/memory_use.hpp"

#include "clearance/bridges.hpp"
#include "clearance/changed_walls.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "mesh/touched_faces.hpp"
#include "nav/abstraction.hpp"
#include "path/ground.hpp"

namespace waywright {

/// Says which optional data a world keeps for queries.
struct Kept {
  bool has_abstraction;
  bool has_bridges;
};

/// The mesh of some items, and what searches read besides it. All of it changes together in an operation:
///
///     layer.begin(limits);
///     layer.remove(id);      // any number of changes
///     layer.insert(shape, id);
///     layer.update();        // at most once: now the abstraction and the bridges fit the mesh
///     layer.commit();        // or roll_back(), which takes back everything since begin()
///
/// If memory runs out in one of these functions, the operation must be rolled back. commit() and roll_back() allocate
/// nothing.
class Layer {
 public:
  using Triangulation = constraint::ConstrainedTriangulation;

  Layer(Triangulation triangulation, const Kept& kept, const clearance::SearchLimits& limits = {});
  /// Requires: no operation is under way, here and in the next function.
  Layer(const Layer& other);
  Layer& operator=(Layer&& other) noexcept;
  ~Layer() = default;

  [[nodiscard]] const Triangulation& triangulation() const { return triangulation_; }
  /// The abstraction, or null.
  [[nodiscard]] const nav::Abstraction* abstraction() const { return abstraction_ ? &*abstraction_ : nullptr; }
  /// The bridges, or null.
  [[nodiscard]] const clearance::Bridges* bridges() const { return bridges_.get(); }

  void begin(const constraint::VertexLimits& limits);
  /// The next three functions change the mesh. After an insertion, ask whether the mesh has too many vertices
  /// (ConstrainedTriangulation::has_too_many_vertices()).
  void insert(const Shape& shape, ItemId id);
  template <class Batch>
  void insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  void remove(ItemId id);
  void update();
  void commit();
  void roll_back() noexcept;

  void set_largest_id_seen(ItemId id) { triangulation_.set_largest_id_seen(id); }
  void mark_used(ItemId last) { triangulation_.mark_used(last); }
  /// Gives the bridges away. Later operations keep none.
  [[nodiscard]] std::unique_ptr<clearance::Bridges> take_bridges() { return std::move(bridges_); }
  /// Requires: the bridges belong to the mesh.
  void set_bridges(std::unique_ptr<clearance::Bridges> bridges) { bridges_ = std::move(bridges); }

  [[nodiscard]] std::optional<std::string> find_fault() const;
  void count_memory(MemoryUse& use) const;
  void shrink_to_fit();

 private:
  void note_inserted(ItemId id);
  void note_box(std::uint32_t slot);

  Triangulation triangulation_;
  std::optional<nav::Abstraction> abstraction_;
  std::unique_ptr<clearance::Bridges> bridges_;

  // The operation under way.
  std::optional<Triangulation::UndoGuard> operation_;
  clearance::ChangedWalls changed_walls_;
  bool are_bridges_updated_ = false;
  mesh::TouchedFaces touched_;
};

/// The layers of a world, as one: `all`, the mesh of all items, and `walls`.
///
/// Bridges need a mesh in which each vertex is the end of a wall. A ring with one corner is *loose*: it has no side. A
/// point and a segment of length zero have a loose ring. Until an item with a loose ring appears, the bridges belong to
/// the mesh of all items. Then the class makes the layer `walls`, and the bridges belong to that one. It contains each
/// item that has sides, under its id, without its loose rings. It stays until shrink_to_fit() finds no loose ring.
///
/// The functions of an operation are those of Layer.
class Layers {
 public:
  using Triangulation = Layer::Triangulation;

  Layers(Triangulation triangulation, const Kept& kept, const clearance::SearchLimits& limits = {});
  /// Requires: no operation is under way, here and in the next function.
  Layers(const Layers& other);
  Layers& operator=(Layers&& other) noexcept;
  ~Layers() = default;

  [[nodiscard]] const Triangulation& triangulation() const { return all_.triangulation(); }
  [[nodiscard]] const nav::Abstraction* abstraction() const { return all_.abstraction(); }
  [[nodiscard]] Kept kept() const { return {all_.abstraction() != nullptr, keeps_bridges_}; }
  /// What searches see of the world.
  [[nodiscard]] path::Ground ground() const;

  void begin(const constraint::VertexLimits& limits);
  void insert(const Shape& shape, ItemId id) {
    all_.insert(shape, id);
    note_changed(id);
  }
  template <class Batch>
  void insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  void remove(ItemId id) {
    all_.remove(id);
    note_changed(id);
  }
  /// The first loose ring costs as much as a new world.
  void update();
  void commit();
  void roll_back() noexcept;

  void set_largest_id_seen(ItemId id) { all_.set_largest_id_seen(id); }
  void mark_used(ItemId last) { all_.mark_used(last); }

  /// Returns the first fault, or nothing: each layer must equal one that is built from the live items. Cost: linear.
  [[nodiscard]] std::optional<std::string> find_fault() const;
  void count_memory(MemoryUse& use) const;
  /// Frees spare memory, and the layer of the walls if no item has a loose ring. Requires: no operation is under way.
  /// Cost: linear if there are two layers.
  void shrink_to_fit();

 private:
  void note_changed(ItemId id) {
    if (keeps_bridges_) changed_.push_back(id);
  }
  [[nodiscard]] const Layer& layer_of_bridges() const { return walls_ ? *walls_ : all_; }
  [[nodiscard]] bool is_any_changed_loose() const;
  [[nodiscard]] std::unique_ptr<Layer> make_walls(const clearance::SearchLimits& limits) const;
  void update_walls();

  bool keeps_bridges_;
  Layer all_;
  std::unique_ptr<Layer> walls_;  ///< or null

  // The operation under way.
  std::vector<ItemId> changed_;
  bool is_walls_open_ = false;                       ///< whether the operation changes `walls_`
  std::unique_ptr<clearance::Bridges> old_bridges_;  ///< of `all_`, if the operation has made `walls_`

  // Scratch.
  constraint::Outline outline_;
  Shape shape_;
};

template <class Batch>
void Layer::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  triangulation_.insert_all(batch, team);
  if (triangulation_.has_too_many_vertices()) return;
  for (std::size_t i = 0; i < batch.size(); ++i) note_inserted(batch.id(i));
}

template <class Batch>
void Layers::insert_all(const Batch& batch, const threads::ThreadTeam& team) {
  all_.insert_all(batch, team);
  for (std::size_t i = 0; i < batch.size(); ++i) note_changed(batch.id(i));
}

/// Fills `shape` with the shape of a live item. Reuses the memory of `shape`.
void fill_shape(const constraint::ConstrainedTriangulation& triangulation, ItemId id, Shape& shape);

}  // namespace waywright
