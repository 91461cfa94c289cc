#include "memory/arena.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <new>
#include <utility>

#include "memory/scratch.hpp"

namespace waywright::memory {

namespace {

thread_local Arena* arena_of_thread = nullptr;

}  // namespace

void* try_allocate(std::size_t bytes) noexcept {
#if defined(__cpp_exceptions)
  try {
    return ::operator new(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
#else
  return ::operator new(bytes);
#endif
}

std::unique_ptr<Arena> Arena::make(std::size_t size) {
  if (!base::kHasPageFiles || !may_map_pages()) return nullptr;
  std::unique_ptr<Arena> arena(new Arena(size, nullptr));
  arena->file_ = base::PageFile::make(size);
  if (arena->file_) arena->start_ = arena->file_->map();
  return arena->start_ == nullptr ? nullptr : std::move(arena);
}

std::unique_ptr<Arena> Arena::share() const {
  assert(file_);
  std::unique_ptr<Arena> arena(new Arena(size_, this));
  arena->start_ = file_->map_copy();
  return arena->start_ == nullptr ? nullptr : std::move(arena);
}

// The values have implicit lifetimes (they are trivially copyable), so the copied bytes are objects.
void* Arena::copy(const void* original, std::size_t size, std::size_t capacity) noexcept {
  if (base_ != nullptr) {
    if (!base_->contains(original)) return nullptr;
    return start_ + (static_cast<const std::byte*>(original) - base_->start_);
  }
  if (capacity > size_ - used_ || !file_->reserve(used_, size)) return nullptr;
  std::byte* const place = start_ + used_;
  if (size != 0) std::memcpy(place, original, size);
  used_ = std::min((used_ + capacity + kAlignment - 1) / kAlignment * kAlignment, size_);
  return place;
}

ArenaScope::ArenaScope(Arena& arena) : outer_(std::exchange(arena_of_thread, &arena)) {}
ArenaScope::~ArenaScope() { arena_of_thread = outer_; }
Arena* ArenaScope::arena() { return arena_of_thread; }

}  // namespace waywright::memory
