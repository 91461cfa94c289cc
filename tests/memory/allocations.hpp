#pragma once

#include <cstddef>
#include <new>

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

/// Runs `run` while the n-th allocation from now on fails; with 0, none fails. Returns whether `run` finished.
template <class Run>
bool gets_through(std::size_t n, Run&& run) {
  bool is_done = true;
  fail_allocation(n == 0 ? 0 : allocation_count() + n);
  try {
    run();
  } catch (const std::bad_alloc&) {
    is_done = false;
  }
  fail_allocation(0);
  return is_done;
}

}  // namespace waywright::test
