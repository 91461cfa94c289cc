#pragma once

#include "waywright/export.hpp"

namespace waywright {

/// A broken precondition: a bug in the program that calls the library. The strings live as long as the handler runs.
struct AssertionFailure {
  const char* message = "";    ///< what the caller did wrong
  const char* condition = "";  ///< the expression that should have been true
  const char* file = "";       ///< where the library checked it
  int line = 0;
};

/// Called when a precondition is broken, on the thread that broke it. It may log the failure, show it or stop in a
/// debugger. The process is aborted when the handler returns. It must not throw.
using AssertionHandler = void (*)(const AssertionFailure& failure);

/// Sets the handler of the whole process and returns the one before; null stands for the default handler, which prints
/// the failure to stderr. This is the only hook into the library that a log needs: the library itself prints nothing
/// else and writes no log. Bad data is no broken precondition: it gives a Result with an Error.
///
/// Preconditions are checked in release builds too, wherever that costs nothing that can be measured: the value of a
/// refused Result, the use of an object that has been moved from, a number of threads or contexts that is 0, the
/// centroid of no points. Each function names what it requires.
///
/// Threads: may be called at any time.
WAYWRIGHT_API AssertionHandler set_assertion_handler(AssertionHandler handler) noexcept;

namespace detail {
/// Calls the handler, then aborts.
[[noreturn]] WAYWRIGHT_API void fail_assertion(const AssertionFailure& failure);
}  // namespace detail

}  // namespace waywright

/// Calls the assertion handler and aborts if `condition` is false. An expression of type void.
#define WAYWRIGHT_ASSERT(condition, message) \
  ((condition) ? static_cast<void>(0)        \
               : ::waywright::detail::fail_assertion({(message), #condition, __FILE__, __LINE__}))
