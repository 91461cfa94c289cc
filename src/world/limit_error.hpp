#pragma once

#include <cstddef>

#include "waywright/error.hpp"

#include "constraint/operation.hpp"

namespace waywright {

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
