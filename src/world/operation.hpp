#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "waywright/error.hpp"
#include "waywright/id.hpp"
#include "waywright/world.hpp"

#include "constraint/operation.hpp"
#include "threads/thread_team.hpp"
#include "world/layers.hpp"

namespace waywright {

/// An operation on a world: the only way in which its items change. It changes the layers, and records what it does for
/// the change log, the history, the snapshots and the searches in slices. If the object is destroyed before commit(),
/// for example because memory runs out, its destructor takes everything back.
class WAYWRIGHT_INTERNAL World::Operation {
 public:
  enum class Kind : std::uint8_t {
    change,   ///< the history records the changes
    rewind,   ///< the history does not record the changes, and no limit applies: the world had these items before
    attempt,  ///< the caller calls update() and not commit(), so the destructor takes the changes back
    follow,   ///< a replica repeats a change of its world; history and ChangeLog do not record it
  };

  /// Starts an operation. If no limit of the world applies to it, the mesh may have `most_vertices` vertices
  /// afterwards.
  explicit Operation(Impl& impl, Kind kind = Kind::change, std::size_t most_vertices = constraint::kMostVertices);
  ~Operation();
  Operation(const Operation&) = delete;
  Operation& operator=(const Operation&) = delete;

  // If an insertion exceeds a limit, the functions return the error. The operation must then be undone. The functions
  // for batches set the index of the error to the index of an item in the batch.
  [[nodiscard]] std::optional<Error> insert(const Shape& shape, ItemId id);
  template <class Batch>
  [[nodiscard]] std::optional<Error> insert_all(const Batch& batch, const threads::ThreadTeam& team = {});
  void remove(ItemId id);
  /// Replaces all items by the items of a batch: builds new layers. Requires: the operation has not changed the layers,
  /// and does not change them afterwards; note_removals() and note_insertions() have got the items that differ.
  /// `largest_id` is the largest id that the world has seen afterwards.
  template <class Batch>
  [[nodiscard]] std::optional<Error> replace_all(const Batch& batch, ItemId largest_id,
                                                 const threads::ThreadTeam& team = {});
  void note_removals(std::span<const ItemId> ids);
  template <class Batch>
  void note_insertions(const Batch& batch);
  void set_largest_id_seen(ItemId id);
  /// Updates the layers, so that all queries see the changes. Call it once, after all changes.
  void update();
  /// Calls update() and makes the changes final.
  void commit();

 private:
  [[nodiscard]] bool is_limited() const { return kind_ == Kind::change || kind_ == Kind::attempt; }
  [[nodiscard]] bool is_logged() const { return kind_ != Kind::follow; }
  void note_removal(std::uint32_t slot);
  template <class Rings>
  void note_insertion(ItemKind kind, const Rings& rings, ItemId id);
  void add_removal_to_history(std::uint32_t slot);
  void add_removal_to_change_log(std::uint32_t slot);

  Impl& impl_;
  Kind kind_;
  bool is_committed_ = false;
  constraint::VertexLimits limits_;
  std::unique_ptr<Layers> made_;  ///< the new layers of replace_all()
};

}  // namespace waywright
