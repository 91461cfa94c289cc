#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>

#include "convert.hpp"

// The global lock of Python (the GIL) in calls that take long.

namespace waywright::python {

/// Calls a function of Python that takes the GIL. While the interpreter shuts down, Python ends each thread that calls
/// such a function, by an exception that must not reach a destructor. So this thread sleeps until the process ends.
template <class Take>
auto take_gil(const Take& take) noexcept {
  try {
    return take();
  } catch (...) {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

/// Releases the GIL until it is destroyed.
class WithoutGil {
 public:
  WithoutGil() : state_(PyEval_SaveThread()) {}
  ~WithoutGil() {
    take_gil([this] { PyEval_RestoreThread(state_); });
  }
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

 private:
  PyThreadState* state_;
};

/// Holds the GIL until it is destroyed. Requires: the thread has released it by WithoutGil.
class WithGil {
 public:
  WithGil() : state_(take_gil([] { return PyGILState_Ensure(); })) {}
  ~WithGil() { PyGILState_Release(state_); }
  WithGil(const WithGil&) = delete;
  WithGil& operator=(const WithGil&) = delete;

 private:
  PyGILState_STATE state_;
};

/// Reports the progress of a long call to a function of Python, and notices signals such as Ctrl-C. The thread that
/// made the call calls it, without the GIL.
class Reporter {
 public:
  /// `progress` is None, a function of two numbers (what is done, and the total), or True for a bar of tqdm.
  /// Requires: the thread holds the GIL.
  explicit Reporter(const py::object& progress);

  /// Reports progress, at most 20 times in a second, and at the end. The unit has no meaning. At the end the call has
  /// already done its work. If the function then raises an exception, Python prints it. A KeyboardInterrupt reaches the
  /// program after the call.
  ///
  /// Exceptions: throws py::error_already_set if a signal handler or the function has raised an exception.
  void operator()(std::size_t done, std::size_t total);
  /// Returns a function for BulkOptions::progress. The reporter must exist as long as this function.
  [[nodiscard]] std::function<void(std::size_t, std::size_t)> function() {
    return [this](std::size_t done, std::size_t total) { (*this)(done, total); };
  }

 private:
  void report_end(std::size_t total);

  py::object progress_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace waywright::python
