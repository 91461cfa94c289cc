#include <exception>
#include <string>

#include "bind.hpp"

// Errors of the library become exceptions of waywright._errors.

namespace waywright::python {

namespace {

void raise_in_python(const Error& error) {
  const std::string text = error.message();
  // The message can contain the name of a file, whose bytes need not be UTF-8.
  const auto message = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
  if (!message) throw py::error_already_set();
  const py::object exception =
      py::module_::import("waywright._errors")
          .attr("exception_of")(std::string(to_string(error.code)), message, error.index, error.item);
  PyErr_SetObject(py::type::handle_of(exception).ptr(), exception.ptr());
}

void translate(std::exception_ptr exception) {
  try {
    if (exception) std::rethrow_exception(exception);
  } catch (const BadResult& bad) {
    try {
      raise_in_python(bad.error());
    } catch (py::error_already_set& failure) {
      failure.restore();
    }
  } catch (const py::cast_error& bad) {
    PyErr_SetString(PyExc_TypeError, bad.what());
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  py::register_exception_translator(&translate);
  module.def(
      "predicate_counts",
      [] {
        const PredicateCounts counts = predicate_counts();
        const auto stages = [](const StageCounts& count) {
          py::dict result;
          result["doubles"] = count.doubles;
          result["lattice"] = count.lattice;
          result["integers"] = count.integers;
          return result;
        };
        py::dict result;
        result["orientation"] = stages(counts.orientation);
        result["in_circle"] = stages(counts.in_circle);
        result["order"] = stages(counts.order);
        result["crossing"] = stages(counts.crossing);
        return result;
      },
      "Returns how many calls of each predicate each stage of the exact arithmetic has decided, for the calling "
      "thread.");
  module.def(
      "is_in_range", [](const Point& point) { return is_in_range(point); }, py::arg("point"),
      R"(Returns whether a world accepts both coordinates of a point.

>>> waywright.is_in_range((1e-3, 1e6)), waywright.is_in_range((1e300, 0))
(True, False)
)");
}

}  // namespace waywright::python
