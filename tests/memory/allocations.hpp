#pragma once

#include <cstddef>

/// Every allocation of a program that links allocations.cpp is counted there, and any one can be made to fail.
namespace waywright::test {

/// Allocations so far.
[[nodiscard]] std::size_t allocation_count();
/// Allocations that have not been given back.
[[nodiscard]] std::ptrdiff_t live_allocations();
/// Bytes that have not been given back, as the allocator rounds them.
[[nodiscard]] std::ptrdiff_t live_bytes();
/// Makes the n-th allocation of the program fail, counted from 1; 0 for none.
void fail_allocation(std::size_t n);

}  // namespace waywright::test
