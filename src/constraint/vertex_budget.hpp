#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "mesh/index.hpp"

namespace waywright::constraint {

/// The largest number of vertices of a triangulation, without the ghost vertex. The mesh has 31 bits for the number of
/// a half-edge, and n vertices make 6 n - 6 half-edges. So the last 47 million numbers stay unused.
inline constexpr std::size_t kMostVertices = 350'000'000;
static_assert(6 * kMostVertices < mesh::number(mesh::kNoHalfEdge));

struct VertexLimits {
  /// The largest number of vertices that an operation may make.
  std::size_t of_operation = std::numeric_limits<std::size_t>::max();
  /// The largest number of vertices that the triangulation may have after an operation, without the ghost vertex.
  std::size_t of_triangulation = kMostVertices;
};

/// Counts the vertices that an operation makes, and says when it has made too many. A vertex that the operation itself
/// removes later also counts.
class VertexBudget {
 public:
  explicit VertexBudget(const VertexLimits& limits = {}) : limits_(limits) {}

  /// Call it before the operation inserts an item or a batch. `vertex_count` is the number of vertices of the
  /// triangulation, without the ghost vertex.
  void begin_insertion(std::size_t vertex_count) {
    const std::size_t spare = limits_.of_triangulation - std::min(limits_.of_triangulation, vertex_count);
    allowed_ = std::min(limits_.of_operation, made_ + spare);
  }
  void add(std::size_t count) { made_ += count; }
  /// Whether the operation has made too many vertices. It must then be undone.
  [[nodiscard]] bool is_exceeded() const { return made_ > allowed_; }
  /// Whether the operation has made more vertices than its own limit allows.
  [[nodiscard]] bool is_operation_limit_exceeded() const { return made_ > limits_.of_operation; }
  /// The number of vertices that the operation may make until the end of this insertion.
  [[nodiscard]] std::size_t allowed() const { return allowed_; }
  [[nodiscard]] const VertexLimits& limits() const { return limits_; }

 private:
  VertexLimits limits_;
  std::size_t made_ = 0;
  std::size_t allowed_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace waywright::constraint
