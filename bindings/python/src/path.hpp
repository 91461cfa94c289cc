#pragma once

#include <cstddef>
#include <optional>

#include "convert.hpp"

// What the functions that find paths share.

namespace waywright::python {

/// Sets a budget from two arguments of Python. `time` is in seconds. With a time alone, the triangles have no limit.
/// Exceptions: py::value_error, if the time is no number or negative.
void set_budget(PathBudget& budget, std::optional<std::size_t> expansions, std::optional<double> time);

/// Returns the type of the elements of an array of pieces: the fields kind (0: line, 1: arc), from, to, centre, radius,
/// start_angle and end_angle.
[[nodiscard]] py::dtype piece_type();

}  // namespace waywright::python
