#pragma once

#include <cstddef>

/// A program that links allocations.cpp counts each of its allocations and can make any one of them fail.
namespace waywright::test {

/// Returns the number of allocations since the program started.
[[nodiscard]] std::size_t allocation_count();
/// Returns the number of allocations that have not been freed.
[[nodiscard]] std::ptrdiff_t live_allocations();
/// Returns the number of bytes that have not been freed, rounded up as the allocator does.
[[nodiscard]] std::ptrdiff_t live_bytes();
/// Makes the n-th allocation of the program fail, counted from 1. With 0, none fails.
void fail_allocation(std::size_t n);

}  // namespace waywright::test
