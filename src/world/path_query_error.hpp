#pragma once

#include <optional>

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"

#include "world/layers.hpp"

namespace waywright {

// Each function returns the error in a path query, or nothing.

[[nodiscard]] std::optional<Error> find_query_error(const Box& domain, const Kept& kept, const PathQuery& query);
/// Returns the error in an agent, or nothing. An agent may have any finite radius from 0 on.
[[nodiscard]] std::optional<Error> find_agent_error(const Agent& agent);
/// Returns the error in the agent of a path query, or nothing.
[[nodiscard]] std::optional<Error> find_agent_error(const Kept& kept, const Agent& agent);
[[nodiscard]] std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance);

}  // namespace waywright
