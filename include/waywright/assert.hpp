#pragma once

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup errors
/// @{

/// A broken precondition: a bug in the program that calls the library. The strings are valid while the handler runs.
struct AssertionFailure {
  const char* message = "";    ///< what the caller did wrong
  const char* condition = "";  ///< the expression that should have been true
  const char* file = "";       ///< the name of the source file of the check, without its folders
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
/// Returns the part of `path` after its last separator of folders.
[[nodiscard]] constexpr const char* file_name(const char* path) {
  const char* name = path;
  for (const char* at = path; *at != '\0'; ++at) {
    if (*at == '/' || *at == '\\') name = at + 1;
  }
  return name;
}

/// Calls the handler, then aborts.
[[noreturn]] WAYWRIGHT_API void fail_assertion(const AssertionFailure& failure);
}  // namespace detail

}  // namespace waywright

/// The name of the source file without its folders: where a program was built is not the business of its users. Most
/// compilers store only this name in the program, others store the whole path.
/// @ingroup errors
#if defined(__FILE_NAME__)
#define WAYWRIGHT_FILE_NAME __FILE_NAME__
#else
#define WAYWRIGHT_FILE_NAME ::waywright::detail::file_name(__FILE__)
#endif

/// Calls the assertion handler and aborts if `condition` is false. The macro is an expression of type void.
/// @ingroup errors
#define WAYWRIGHT_ASSERT(condition, message) \
  ((condition) ? static_cast<void>(0)        \
               : ::waywright::detail::fail_assertion({(message), #condition, WAYWRIGHT_FILE_NAME, __LINE__}))
