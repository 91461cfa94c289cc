#pragma once

#include <cstddef>
#include <optional>

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/point.hpp"

#include "constraint/operation.hpp"
#include "exact/position.hpp"
#include "world/layers.hpp"

namespace waywright {

/// Returns the error in the coordinates of `point`, or nothing. Messages call the point `name`.
[[nodiscard]] std::optional<Error> find_range_error(const Point& point, std::size_t index,
                                                    const detail::PointName& name);

/// Returns whether a query or a change may use `point` in a world over `domain`.
[[nodiscard]] inline bool is_point_of(const Box& domain, const Point& point) {
  return is_in_range(point) && point.x >= domain.min.x && point.x <= domain.max.x && point.y >= domain.min.y &&
         point.y <= domain.max.y;
}

/// Returns the error in `point`. Its index in a list is `index`, and messages call it `name`. Requires: is_point_of()
/// is false.
[[nodiscard]] Error point_error(const Box& domain, const Point& point, std::size_t index,
                                const detail::PointName& name);

/// Returns the error in `point`, or nothing.
[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index,
                                                           const detail::PointName& name) {
  if (is_point_of(domain, point)) return std::nullopt;
  return point_error(domain, point, index, name);
}

[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index) {
  return find_point_error(domain, point, index, {"point", index});
}

/// Returns the error in the box of a query, or nothing. The box may reach beyond the domain.
[[nodiscard]] std::optional<Error> find_box_error(const Box& box);

// Each function returns the error in a path query, or nothing.

[[nodiscard]] std::optional<Error> find_query_error(const Box& domain, const Kept& kept, const PathQuery& query);
/// Returns the error in an agent, or nothing. An agent may have any finite radius from 0 on.
[[nodiscard]] std::optional<Error> find_agent_error(const Agent& agent);
/// Returns the error in the agent of a path query, or nothing.
[[nodiscard]] std::optional<Error> find_agent_error(const Kept& kept, const Agent& agent);
[[nodiscard]] std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance);

/// The error of an operation that has made too many vertices. `id` is the item at which the operation exceeded its
/// limit.
[[nodiscard]] inline Error limit_error(const constraint::VertexBudget& budget, ItemId id) {
  const bool is_own_limit = budget.is_operation_limit_exceeded();
  const constraint::VertexLimits& limits = budget.limits();
  Error error{is_own_limit ? ErrorCode::too_many_vertices : ErrorCode::too_large, {}, id, 0};
  error.words.limit = is_own_limit ? limits.of_operation : limits.of_triangulation;
  return error;
}

/// The error of the insertion of a batch that has made too many vertices. Its index is the index of the item in the
/// batch.
template <class Triangulation, class Batch>
[[nodiscard]] Error limit_error(const Triangulation& triangulation, const Batch& batch) {
  const std::size_t index = triangulation.refused_index();
  Error error = limit_error(triangulation.budget(), batch.id(index));
  error.index = index;
  return error;
}

}  // namespace waywright
