#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "internal.hpp"

namespace waywright::c {
void clear_last_error() noexcept;
}

using namespace waywright::c;

#if defined(WAYWRIGHT_C_HOOKS)

// The C library contains the C++ standard library, and exports only its own functions. So the operators below replace
// `operator new` in this library and nowhere else.

namespace {

void* allocate_by_default(std::size_t size, std::size_t alignment, void* /*user_data*/) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size);
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void free_by_default(void* memory, std::size_t /*alignment*/, void* /*user_data*/) { std::free(memory); }

constexpr ww_allocator kDefault{sizeof(ww_allocator), allocate_by_default, free_by_default, nullptr};
constexpr std::size_t kAlignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

constinit ww_allocator allocator = kDefault;
constinit std::atomic<std::size_t> live_blocks = 0;

void* take(std::size_t size, std::size_t alignment) noexcept {
  void* const memory = allocator.allocate(size == 0 ? 1 : size, alignment, allocator.user_data);
  if (memory != nullptr) live_blocks.fetch_add(1, std::memory_order_relaxed);
  return memory;
}

void* take_or_throw(std::size_t size, std::size_t alignment) {
  void* const memory = take(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void give_back(void* memory, std::size_t alignment) noexcept {
  if (memory == nullptr) return;
  allocator.deallocate(memory, alignment, allocator.user_data);
  live_blocks.fetch_sub(1, std::memory_order_relaxed);
}

std::size_t number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t size) { return take_or_throw(size, kAlignment); }
void* operator new[](std::size_t size) { return take_or_throw(size, kAlignment); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size, kAlignment); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return take(size, kAlignment); }
void* operator new(std::size_t size, std::align_val_t alignment) { return take_or_throw(size, number(alignment)); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return take_or_throw(size, number(alignment)); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return take(size, number(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return take(size, number(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory, kAlignment); }
void operator delete[](void* memory) noexcept { give_back(memory, kAlignment); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory, kAlignment); }
void operator delete[](void* memory, std::size_t) noexcept { give_back(memory, kAlignment); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { give_back(memory, kAlignment); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { give_back(memory, kAlignment); }
void operator delete(void* memory, std::align_val_t alignment) noexcept { give_back(memory, number(alignment)); }
void operator delete[](void* memory, std::align_val_t alignment) noexcept { give_back(memory, number(alignment)); }
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  give_back(memory, number(alignment));
}
void operator delete[](void* memory, std::size_t, std::align_val_t alignment) noexcept {
  give_back(memory, number(alignment));
}
void operator delete(void* memory, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  give_back(memory, number(alignment));
}
void operator delete[](void* memory, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  give_back(memory, number(alignment));
}

// Besides `operator new`, the library takes memory from these three functions, or after the third has allowed it. The
// static library defines them in src/memory/scratch.cpp. The linker takes the definitions here instead of those,
// because it finds them first.
namespace waywright::memory {

void* allocate_zeroed(std::size_t count, std::size_t size) noexcept {
  if (allocator.allocate == allocate_by_default) {
    void* const memory = std::calloc(count, size);
    if (memory != nullptr) live_blocks.fetch_add(1, std::memory_order_relaxed);
    return memory;
  }
  if (size != 0 && count > std::numeric_limits<std::size_t>::max() / size) return nullptr;
  void* const memory = take(count * size, kAlignment);
  if (memory != nullptr) std::memset(memory, 0, count * size);
  return memory;
}

void free_zeroed(void* memory) noexcept { give_back(memory, kAlignment); }

bool may_map_pages() noexcept { return allocator.allocate == allocate_by_default; }

}  // namespace waywright::memory

ww_status ww_set_allocator(const ww_allocator* given) {
  clear_last_error();
  return guarded([&] {
    const ww_allocator wanted = given != nullptr ? read_struct(given, kDefault) : kDefault;
    require(wanted.allocate != nullptr && wanted.deallocate != nullptr, "an allocator needs both functions");
    require(live_blocks.load() == 0, "the library holds memory already: set the allocator before you make objects");
    allocator = wanted;
    return WW_OK;
  });
}

#else

ww_status ww_set_allocator(const ww_allocator* given) {
  clear_last_error();
  if (given == nullptr) return WW_OK;
  return fail(WW_NOT_SUPPORTED, "this build of the library has no allocator hooks");
}

#endif
