// A program in C++ that replaces `operator new` and throws exceptions, like many programs that load the C library. The
// library must not use the operator of the program, and exceptions inside the library must not mix with those outside.
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <waywright.h>

namespace {

bool is_counting = false;
int allocations = 0;

void* allocate(std::size_t size) {
  if (is_counting) ++allocations;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// A call that the library refuses by an exception of its own.
bool refuses(ww_world* world) { return ww_world_insert_polyline(world, nullptr, 3, 0, nullptr) == WW_INVALID_ARGUMENT; }

bool throws_and_catches(ww_world* world) {
  try {
    if (refuses(world)) throw std::runtime_error("from the program");
  } catch (const std::runtime_error&) {
    return refuses(world);  // while the program handles its own exception
  }
  return false;
}

bool uses_library() {
  ww_world* world = nullptr;
  ww_text* text = nullptr;
  bool is_right = ww_world_create({{0, 0}, {10, 10}}, nullptr, &world) == WW_OK && ww_text_create(&text) == WW_OK;
  is_right = is_right && ww_world_insert_segment(world, {1, 1}, {9, 8}, 0, nullptr) == WW_OK;
  is_right = is_right && ww_world_dump(world, text) == WW_OK && refuses(world);
  ww_text_destroy(text);
  ww_world_destroy(world);
  return is_right;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

int main() {
  ww_allocator allocator{sizeof(ww_allocator), nullptr, nullptr, nullptr};
  allocator.allocate = [](std::size_t size, std::size_t, void*) { return std::malloc(size); };
  allocator.deallocate = [](void* memory, std::size_t, void*) { std::free(memory); };
  const bool has_hooks = ww_set_allocator(&allocator) == WW_OK;
  is_counting = has_hooks;  // without hooks, the library shares the operator of the program
  const bool is_right = uses_library();
  is_counting = false;
  if (!is_right) std::puts("a call went wrong");
  if (allocations != 0) std::printf("the library called operator new of the program %d times\n", allocations);
  ww_world* world = nullptr;
  const bool mixes = ww_world_create({{0, 0}, {1, 1}}, nullptr, &world) != WW_OK || !throws_and_catches(world);
  if (mixes) std::puts("exceptions of the program and of the library do not work together");
  ww_world_destroy(world);
  return is_right && allocations == 0 && !mixes ? 0 : 1;
}
