#pragma once

#include <optional>

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"

namespace waywright {

// Each function returns the error in a path query, or nothing.
[[nodiscard]] std::optional<Error> find_query_error(const Box& domain, bool keeps_abstraction, const PathQuery& query);
[[nodiscard]] std::optional<Error> find_radius_error(double radius);
[[nodiscard]] std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance);

}  // namespace waywright
