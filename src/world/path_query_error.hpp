#pragma once

#include <optional>

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"

namespace waywright {

// Each function returns the error in a path query, or nothing.

/// Says which optional data a world keeps for path queries.
struct Kept {
  bool has_abstraction;
  bool has_bridges;
};

[[nodiscard]] std::optional<Error> find_query_error(const Box& domain, const Kept& kept, const PathQuery& query);
/// Returns the error in the radius of a disc, or nothing. A disc may have any finite radius from 0 on.
[[nodiscard]] std::optional<Error> find_disc_radius_error(double radius);
/// Returns the error in the radius of a path query, or nothing.
[[nodiscard]] std::optional<Error> find_radius_error(const Kept& kept, double radius);
[[nodiscard]] std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance);

}  // namespace waywright
