#include "memory/array.hpp"

#include <new>

namespace waywright::memory {

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

}  // namespace waywright::memory
