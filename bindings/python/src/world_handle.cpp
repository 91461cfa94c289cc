#include "world_handle.hpp"

#include <optional>
#include <stdexcept>

namespace waywright::python {

std::unique_ptr<QueryContext> ContextPool::take() {
  if (QueryContext* const context = spare_.exchange(nullptr)) return std::unique_ptr<QueryContext>(context);
  {
    const std::lock_guard lock(mutex_);
    if (!others_.empty()) {
      std::unique_ptr<QueryContext> context = std::move(others_.back());
      others_.pop_back();
      return context;
    }
  }
  return std::make_unique<QueryContext>();
}

void ContextPool::give_back(std::unique_ptr<QueryContext> context) {
  QueryContext* none = nullptr;
  if (spare_.compare_exchange_strong(none, context.get())) {
    static_cast<void>(context.release());
    return;
  }
  const std::lock_guard lock(mutex_);
  others_.push_back(std::move(context));
}

void ContextPool::clear() {
  delete spare_.exchange(nullptr);
  const std::lock_guard lock(mutex_);
  others_.clear();
}

thread_local const WorldHandle::SharedLock* WorldHandle::SharedLock::innermost_ = nullptr;

bool WorldHandle::SharedLock::is_held_for(const WorldHandle& handle) {
  const SharedLock* lock = innermost_;
  while (lock != nullptr && &lock->handle_ != &handle) lock = lock->outer_;
  return lock != nullptr;
}

WorldHandle::SharedLock::SharedLock(const WorldHandle& handle, bool has_gil) : handle_(handle) {
  if (handle.is_owner()) {
    if (handle.owner_does_ == Owner::asks) return;
    throw std::runtime_error("a progress function must not use the world that the call changes");
  }
  if (is_held_for(handle)) return;
  if (!has_gil) {
    handle.mutex_.lock_shared();
  } else if (!handle.mutex_.try_lock_shared()) {
    const WithoutGil no_gil;
    handle.mutex_.lock_shared();
  }
  is_locked_ = true;
  innermost_ = this;
}

WorldHandle::ExclusiveLock::ExclusiveLock(WorldHandle& handle) : handle_(handle) {
  if (handle.is_owner()) {
    throw std::runtime_error("the question of attempt() and a progress function must not change the world");
  }
  if (SharedLock::is_held_for(handle)) {
    throw std::runtime_error("a progress function must not change the world that the call reads");
  }
  handle.mutex_.lock();
  handle.owner_does_ = Owner::changes;
  handle.owner_ = std::this_thread::get_id();
}

WorldHandle::ExclusiveLock::~ExclusiveLock() {
  handle_.owner_ = std::thread::id();
  handle_.mutex_.unlock();
}

void WorldHandle::refuse_in_attempt() const {
  if (is_owner()) throw std::runtime_error("the question of attempt() must not do this");
}

py::object WorldHandle::attempt(const std::vector<Change>& changes, const py::object& self,
                                const py::function& question) {
  py::object answer;
  write([&](World& world) {
    world
        .attempt(changes,
                 [&](const World&) {
                   const WithGil gil;
                   owner_does_ = Owner::asks;
                   answer = question(self);
                   owner_does_ = Owner::changes;
                 })
        .value();
  });
  return answer;
}

std::optional<std::size_t> limit_of(const World& world) {
  const std::size_t limit = world.new_vertex_limit();
  return limit == kNoVertexLimit ? std::nullopt : std::optional(limit);
}

std::string facts_of(const World& world) {
  const Box& box = world.domain();
  return to_string(box.min) + " to " + to_string(box.max) + ", " + std::to_string(world.item_count()) + " items, " +
         std::to_string(world.vertex_count()) + " vertices";
}

}  // namespace waywright::python
