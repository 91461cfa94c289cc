#include "counting_allocator.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"

size_t live_blocks = 0;
size_t allocations = 0;
size_t failures = 0;
size_t failing_allocation = 0;
int fails_from_then_on = 0;

/* The bytes in front of a block, in which the allocator stores the alignment of the block. */
enum { kHeader = 64 };

/* The library calls the allocator from several threads at once. Returns the new value. */
static size_t increase(size_t* counter) { return __atomic_add_fetch(counter, 1, __ATOMIC_RELAXED); }

static void* allocate(size_t size, size_t alignment, void* user_data) {
  unsigned char* block = NULL;
  const size_t allocation = increase(&allocations);
  CHECK(user_data == &live_blocks && size > 0 && alignment > 0 && alignment <= kHeader);
  if (failing_allocation != 0 &&
      (allocation == failing_allocation || (fails_from_then_on && allocation > failing_allocation))) {
    increase(&failures);
    return NULL;
  }
  block = malloc(size + kHeader);
  if (block == NULL) return NULL;
  memcpy(block, &alignment, sizeof alignment);
  memset(block + kHeader, 0xA5, size); /* the library must not rely on zeros */
  increase(&live_blocks);
  return block + kHeader;
}

static void deallocate(void* memory, size_t alignment, void* user_data) {
  unsigned char* const block = (unsigned char*)memory - kHeader;
  size_t allocated_for = 0;
  memcpy(&allocated_for, block, sizeof allocated_for);
  CHECK(user_data == &live_blocks && alignment == allocated_for);
  __atomic_sub_fetch(&live_blocks, 1, __ATOMIC_RELAXED);
  free(block);
}

ww_allocator counting_allocator(void) {
  ww_allocator allocator;
  memset(&allocator, 0, sizeof allocator);
  allocator.struct_size = sizeof allocator;
  allocator.allocate = allocate;
  allocator.deallocate = deallocate;
  allocator.user_data = &live_blocks;
  return allocator;
}
