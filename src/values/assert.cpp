#include "waywright/assert.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace waywright {

namespace {

void print_failure(const AssertionFailure& failure) {
  std::fprintf(stderr, "waywright: %s\n  %s:%d: '%s' is false\n", failure.message, failure.file, failure.line,
               failure.condition);
}

std::atomic<AssertionHandler> current_handler = print_failure;

}  // namespace

AssertionHandler set_assertion_handler(AssertionHandler handler) noexcept {
  return current_handler.exchange(handler != nullptr ? handler : print_failure);
}

void detail::fail_assertion(const AssertionFailure& failure) {
  current_handler.load()(failure);
  std::abort();
}

}  // namespace waywright
