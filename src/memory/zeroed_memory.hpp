#pragma once

#include <cstddef>

namespace waywright::memory {

/// Returns memory for `count` values of `size` bytes each, as std::calloc does: all bits are zero, and null if there is
/// not enough memory.
///
/// The three functions of this header have a source file of their own. So a program that links the static library can
/// replace all of them, as it can replace `operator new`. The library for C programs (`bindings/c`) does this for its
/// allocator hooks.
[[nodiscard]] void* allocate_zeroed(std::size_t count, std::size_t size) noexcept;
/// Frees memory that allocate_zeroed() has returned, or does nothing for null.
void free_zeroed(void* memory) noexcept;

/// Returns whether the library may map pages (Arena), which take memory directly from the operating system.
[[nodiscard]] bool may_map_pages() noexcept;

}  // namespace waywright::memory
