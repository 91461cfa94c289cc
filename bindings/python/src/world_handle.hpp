#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "calls.hpp"

namespace waywright::python {

/// The contexts of the queries of one world and of its snapshots. A thread borrows one for a query.
class ContextPool {
 public:
  ContextPool() = default;
  ~ContextPool() { delete spare_.load(); }
  ContextPool(const ContextPool&) = delete;
  ContextPool& operator=(const ContextPool&) = delete;

  /// A context that a thread has borrowed. It returns to the pool when the loan is destroyed.
  class Loan {
   public:
    explicit Loan(ContextPool& pool) : pool_(pool), context_(pool.take()) {}
    ~Loan() { pool_.give_back(std::move(context_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    [[nodiscard]] QueryContext& operator*() const { return *context_; }

   private:
    ContextPool& pool_;
    std::unique_ptr<QueryContext> context_;
  };

  /// Frees all contexts that no thread has borrowed.
  void clear();

 private:
  [[nodiscard]] std::unique_ptr<QueryContext> take();
  void give_back(std::unique_ptr<QueryContext> context);

  std::atomic<QueryContext*> spare_ = nullptr;  ///< one context, which needs no lock
  std::mutex mutex_;
  std::vector<std::unique_ptr<QueryContext>> others_;
};

/// A world that several threads of Python may use at once. Several queries may read it at once. A change waits until no
/// other thread uses the world. No thread waits for the world while it holds the GIL, so the two locks cannot block
/// each other. No thread waits for itself. If a progress function queries the world that its call reads, the query
/// works. If it changes this world, it gets a RuntimeError.
class WorldHandle {
 public:
  using BoundToPython = void;

  explicit WorldHandle(World world) : world_(std::move(world)) {}

  /// Calls a short function of the world with the GIL held. Returns its result.
  template <class Function>
  auto read(Function&& function) const {
    const SharedLock lock(*this, true);
    return function(world_);
  }
  /// Calls a function of the world without the GIL, so that other threads can run.
  template <class Function>
  auto read_long(Function&& function) const {
    const WithoutGil no_gil;
    const SharedLock lock(*this, false);
    return function(world_);
  }
  /// Calls a function that changes the world, alone and without the GIL.
  template <class Function>
  auto write(Function&& function) {
    const WithoutGil no_gil;
    const ExclusiveLock lock(*this);
    return function(world_);
  }
  /// Makes changes, asks a question of Python about the changed world, and takes the changes back. `self` is the object
  /// of Python that has this handle.
  py::object attempt(const std::vector<Change>& changes, const py::object& self, const py::function& question);

  /// Throws a RuntimeError if the calling thread is inside attempt().
  void refuse_in_attempt() const;

  [[nodiscard]] ContextPool& contexts() const { return *contexts_; }
  /// Returns the pool that this world shares with its snapshots, and with nobody else.
  [[nodiscard]] const std::shared_ptr<ContextPool>& pool() const { return contexts_; }

  bool keeps_history = false;  ///< whether mark() is permitted

 private:
  /// What the thread that has the world alone does.
  enum class Owner { changes, asks };

  class SharedLock {
   public:
    SharedLock(const WorldHandle& handle, bool has_gil);
    ~SharedLock() {
      if (!is_locked_) return;
      innermost_ = outer_;
      handle_.mutex_.unlock_shared();
    }
    SharedLock(const SharedLock&) = delete;
    SharedLock& operator=(const SharedLock&) = delete;

    /// Returns whether the calling thread has locked a world in this manner.
    [[nodiscard]] static bool is_held_for(const WorldHandle& handle);

   private:
    static thread_local const SharedLock* innermost_;  ///< of the calling thread

    const WorldHandle& handle_;
    const SharedLock* outer_ = innermost_;
    bool is_locked_ = false;
  };

  class ExclusiveLock {
   public:
    explicit ExclusiveLock(WorldHandle& handle);
    ~ExclusiveLock();
    ExclusiveLock(const ExclusiveLock&) = delete;
    ExclusiveLock& operator=(const ExclusiveLock&) = delete;

   private:
    WorldHandle& handle_;
  };

  [[nodiscard]] bool is_owner() const { return owner_.load() == std::this_thread::get_id(); }

  World world_;
  std::shared_ptr<ContextPool> contexts_ = std::make_shared<ContextPool>();
  mutable std::shared_mutex mutex_;
  std::atomic<std::thread::id> owner_{};  ///< the thread that has the world alone
  Owner owner_does_ = Owner::changes;
};

/// Returns the largest number of new vertices, or nothing if there is no limit.
[[nodiscard]] std::optional<std::size_t> limit_of(const World& world);
/// Returns the domain and the numbers of items and vertices of a world, for repr().
[[nodiscard]] std::string facts_of(const World& world);

using WorldPointer = std::shared_ptr<WorldHandle>;
using WorldClass = py::class_<WorldHandle, WorldPointer>;

}  // namespace waywright::python
