#pragma once

#include <memory>
#include <utility>
#include <variant>

#include "world_handle.hpp"

namespace waywright::python {

/// A snapshot of a world that several threads of Python may use at once. Its members do the same as the members of
/// WorldHandle with the same names, but no query waits. Requires of all members: the thread holds the GIL.
class SnapshotHandle {
 public:
  using BoundToPython = void;

  /// `contexts` is the pool of the world.
  SnapshotHandle(WorldSnapshot snapshot, std::shared_ptr<ContextPool> contexts)
      : snapshot_(std::move(snapshot)), contexts_(std::move(contexts)) {}

  /// Exceptions: py::value_error, if the snapshot has been released.
  template <class Function>
  auto read(Function&& function) const {
    const WorldSnapshot snapshot = held();
    return function(*snapshot);
  }
  /// Exceptions: py::value_error, if the snapshot has been released. If another thread releases the snapshot during the
  /// call, the call continues, and the library frees the snapshot after the call.
  template <class Function>
  auto read_long(Function&& function) const {
    WorldSnapshot snapshot = held();
    const WithoutGil no_gil;
    const WorldSnapshot used = std::move(snapshot);
    return function(*used);
  }
  void refuse_in_attempt() const {}

  [[nodiscard]] ContextPool& contexts() const { return *contexts_; }
  [[nodiscard]] const std::shared_ptr<ContextPool>& pool() const { return contexts_; }

  /// Returns another handle of the same immutable world.
  /// Exceptions: py::value_error, if the snapshot has been released.
  [[nodiscard]] SnapshotHandle copy() const { return {held(), contexts_}; }
  [[nodiscard]] bool is_held() const { return static_cast<bool>(snapshot_); }
  void release();

 private:
  /// Returns the snapshot. The copy stays valid if another thread releases this handle during a query.
  [[nodiscard]] WorldSnapshot held() const;

  WorldSnapshot snapshot_;
  std::shared_ptr<ContextPool> contexts_;
};

using SnapshotPointer = std::shared_ptr<SnapshotHandle>;
using SnapshotClass = py::class_<SnapshotHandle, SnapshotPointer>;
using WorldOrSnapshot = std::variant<WorldPointer, SnapshotPointer>;

}  // namespace waywright::python
