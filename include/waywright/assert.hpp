#pragma once

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup errors
/// @{

/// A broken precondition: a bug in the program that calls the library. The strings are valid while the handler runs.
struct AssertionFailure {
  const char* message = "";    ///< what the caller did wrong
  const char* condition = "";  ///< the expression that should have been true
  const char* file = "";       ///< the source file of the check
  int line = 0;                ///< the line of the check in `file`
};

/// A function that the library calls when a precondition is broken, on the thread that broke it. The handler may log
/// the failure, show it or stop in a debugger. When the handler returns, the library aborts the process.
/// Exceptions: your handler must not throw.
using AssertionHandler = void (*)(const AssertionFailure& failure);

/// Sets the assertion handler of the whole process and returns the previous one, which is never null. As an argument,
/// null stands for the default handler, which prints the failure to stderr.
///
/// @code{.cpp}
/// set_assertion_handler([](const AssertionFailure& failure) {
///   std::fprintf(stderr, "bug: %s (%s:%d)\n", failure.message, failure.file, failure.line);
/// });
/// @endcode
///
/// The library prints no other message, and writes none to a file. So this handler is all that a program needs to write
/// messages of the library to its own log. Bad data is not a broken precondition: for bad data, a function returns a
/// Result with an Error.
///
/// The library also checks preconditions in release builds, but only those whose check costs no more than a comparison.
/// Here are examples of broken preconditions: a program takes the value of a Result with an error; it uses an object
/// that has been moved from; it asks for 0 threads or 0 contexts; it asks for the centroid of a shape without points.
/// The documentation of each function names its preconditions ("Requires").
/// Threads: any thread may call this function at any time.
WAYWRIGHT_API AssertionHandler set_assertion_handler(AssertionHandler handler) noexcept;

/// @}

namespace detail {
/// Calls the handler, then aborts.
[[noreturn]] WAYWRIGHT_API void fail_assertion(const AssertionFailure& failure);
}  // namespace detail

}  // namespace waywright

/// Calls the assertion handler and aborts if `condition` is false. The macro is an expression of type void.
/// @ingroup errors
#define WAYWRIGHT_ASSERT(condition, message) \
  ((condition) ? static_cast<void>(0)        \
               : ::waywright::detail::fail_assertion({(message), #condition, __FILE__, __LINE__}))
