#pragma once

#include <cstddef>
#include <optional>

#include "convert.hpp"

// What the functions that find paths share.

namespace waywright::python {

/// Returns the query of the arguments that all functions for paths have. `time` is in seconds.
/// Exceptions: py::value_error, if the time is no number or negative.
[[nodiscard]] PathQuery query_of(Point start, Point goal, const Agent& agent, PathAlgorithm algorithm,
                                 std::optional<double> end_tolerance, std::optional<std::size_t> budget_expansions,
                                 std::optional<double> budget_time);

/// Returns the type of the elements of an array of pieces: the fields kind (0: line, 1: arc), from, to, centre, radius,
/// start_angle and end_angle.
[[nodiscard]] py::dtype piece_type();

}  // namespace waywright::python
