#include "memory/allocations.hpp"

#include <cstdlib>
#include <malloc.h>
#include <new>

namespace {

std::size_t allocations = 0;
std::size_t failing_allocation = 0;
std::ptrdiff_t live = 0;
std::ptrdiff_t bytes = 0;

void* allocate(std::size_t size) {
  if (++allocations == failing_allocation) throw std::bad_alloc();
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  ++live;
  bytes += static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  return memory;
}

void release(void* memory) {
  if (memory == nullptr) return;
  --live;
  bytes -= static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

namespace waywright::test {

std::size_t allocation_count() { return allocations; }
std::ptrdiff_t live_allocations() { return live; }
std::ptrdiff_t live_bytes() { return bytes; }
void fail_allocation(std::size_t n) { failing_allocation = n; }

}  // namespace waywright::test
