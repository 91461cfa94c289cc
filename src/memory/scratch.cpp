#include "memory/scratch.hpp"

#include <cstdlib>

namespace waywright::memory {

void* allocate_zeroed(std::size_t count, std::size_t size) noexcept { return std::calloc(count, size); }
void free_zeroed(void* memory) noexcept { std::free(memory); }
bool may_map_pages() noexcept { return true; }

}  // namespace waywright::memory
