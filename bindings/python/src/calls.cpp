#include "calls.hpp"

namespace waywright::python {

namespace {

constexpr std::chrono::milliseconds kPause{50};

}  // namespace

Reporter::Reporter(const py::object& progress) : progress_(progress), last_(std::chrono::steady_clock::now()) {
  if (progress.ptr() == Py_False) progress_ = py::none();
  if (progress.ptr() == Py_True) progress_ = py::module_::import("waywright._progress").attr("bar")();
  if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0) {
    throw py::type_error("progress must be a function of two numbers (what is done, and the total), True or None");
  }
}

void Reporter::operator()(std::size_t done, std::size_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kPause && done != total) return;
  last_ = now;
  const WithGil gil;
  if (done == total) return report_end(total);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!progress_.is_none()) progress_(done, total);
}

void Reporter::report_end(std::size_t total) {
  if (progress_.is_none()) return;
  try {
    progress_(total, total);
  } catch (py::error_already_set& error) {
    if (error.matches(PyExc_KeyboardInterrupt)) return PyErr_SetInterrupt();
    error.discard_as_unraisable("a progress function");
  }
}

}  // namespace waywright::python
