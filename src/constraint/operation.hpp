#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "constraint/item_hash.hpp"
#include "mesh/index.hpp"
#include "mesh/triangle_mesh.hpp"

// What a ConstrainedTriangulation counts and notes during an operation: its vertices, its costs and its walls.

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

// The order in which an operation inserts or removes many vertices. Along a ring, each vertex is near the previous one,
// which saves time. But if the ring runs beside another wall, the insertion of the next vertex can replace half of the
// edges of the previous vertex, and then the time is quadratic. In random order, the expected number of edges of the
// next vertex is at most the mean of all vertices. The same is true of the sides of a batch and of the edges that they
// cross.

/// Adds up the costs of the vertices or sides that an operation has handled so far. A cost is a number of edges.
class CostWatch {
 public:
  /// `most` is the largest mean cost that the operation accepts: a few times the usual cost.
  explicit CostWatch(std::size_t most) : most_(most) {}

  void add(std::size_t cost) {
    cost_ += cost;
    allowed_ += most_;
  }
  /// Whether the mean cost is high: the operation then handles the rest in scattered order.
  [[nodiscard]] bool is_costly() const { return cost_ > allowed_; }

 private:
  std::size_t most_;
  std::size_t cost_ = 0;
  std::size_t allowed_ = 512;
};

/// Appends the numbers from `begin` to `end` - 1 in scattered order. The order depends only on the arguments. It
/// consists of groups: the first group has about half of the numbers, the second a quarter, and so on. If
/// `largest_last` is true, the groups come in the reverse order. A hash of a number decides to which group it belongs,
/// so each group is as good as a random sample. The numbers of a group ascend, so consecutive numbers of a group are
/// near each other. Source: Amenta, Choi and Rote, *Incremental constructions con BRIO*, SoCG 2003. Cost: linear.
inline void append_scattered(std::uint32_t begin, std::uint32_t end, bool largest_last,
                             std::vector<std::uint32_t>& order) {
  constexpr std::size_t kParts = 24;
  const auto part_of = [&](std::uint32_t i) {
    const std::size_t part = std::min<std::size_t>(static_cast<std::size_t>(std::countr_zero(mix(i))), kParts - 1);
    return largest_last ? kParts - 1 - part : part;
  };
  std::array<std::size_t, kParts + 1> begins{};
  for (std::uint32_t i = begin; i < end; ++i) ++begins[part_of(i) + 1];
  begins[0] = order.size();
  for (std::size_t part = 0; part < kParts; ++part) begins[part + 1] += begins[part];
  order.resize(order.size() + (end - begin));
  for (std::uint32_t i = begin; i < end; ++i) order[begins[part_of(i)]++] = i;
}

/// Says whether the fixed edges that an operation makes may divide a region into two. The new edges form connected
/// sets. They divide nothing if each of these sets is a tree that shares at most one vertex with older fixed edges: a
/// connected region stays connected if such a tree is cut out of it. If a new vertex splits a new edge, the halves of
/// the edge are new, too. The vertex is there because another side of the operation crosses the edge, and this side and
/// the edge usually enclose an area together. So the class makes no further test: the answer is true.
///
/// The answer may be true for edges that divide nothing, for example for many edges. It is never false for edges that
/// divide a region.
class NewWalls {
 public:
  /// Starts an operation.
  void begin() {
    forget();
    may_divide_ = false;
  }
  /// Makes the edges that the operation has made so far count as older edges. Call it before the operation removes a
  /// vertex.
  void forget() { count_ = 0; }
  /// Call it before the operation makes u - w a fixed edge. Requires: u - w is no fixed edge yet. Cost: O(1).
  void add(const mesh::TriangleMesh& mesh, mesh::Vertex u, mesh::Vertex w) {
    if (may_divide_) return;
    const std::size_t i = find_or_add(mesh, u);
    const std::size_t k = find_or_add(mesh, w);
    if (i == kMostVertices || k == kMostVertices) {
      may_divide_ = true;
    } else {
      connect(ends_[i].set, ends_[k].set);
    }
  }
  /// Call it when a new vertex has split the fixed edge u - w. Cost: O(1).
  void split(mesh::Vertex u, mesh::Vertex w) {
    if (may_divide_) return;
    const std::size_t i = find(u);
    const std::size_t k = find(w);
    may_divide_ = i < count_ && k < count_ && ends_[i].set == ends_[k].set;
  }
  [[nodiscard]] bool may_divide() const { return may_divide_; }

 private:
  static constexpr std::size_t kMostVertices = 32;

  struct End {
    mesh::Vertex vertex;
    std::uint32_t set;  ///< the connected set of new edges at `vertex`, as the index in `ends_` of one of its vertices
    bool is_attached;   ///< whether an older fixed edge may meet the set; valid only in the entry with the index `set`
  };

  /// The index of `v` in `ends_`, or `count_` if it is not there.
  [[nodiscard]] std::size_t find(mesh::Vertex v) const {
    std::size_t i = 0;
    while (i < count_ && ends_[i].vertex != v) ++i;
    return i;
  }

  /// The index of `v` in `ends_`, or kMostVertices if there are too many vertices.
  std::size_t find_or_add(const mesh::TriangleMesh& mesh, mesh::Vertex v) {
    if (const std::size_t i = find(v); i < count_ || count_ == kMostVertices) return i;
    ends_[count_] = {v, static_cast<std::uint32_t>(count_), may_have_fixed_edge(mesh, v)};
    return count_++;
  }

  /// Whether a fixed edge starts at `v`, or `v` has many edges.
  [[nodiscard]] static bool may_have_fixed_edge(const mesh::TriangleMesh& mesh, mesh::Vertex v) {
    const mesh::HalfEdge start = mesh.outgoing(v);
    mesh::HalfEdge h = start;
    for (std::size_t i = 0; i < mesh::TriangleMesh::kFewEdges; ++i) {
      if (mesh.is_fixed(h)) return true;
      h = mesh.next_around(h);
      if (h == start) return false;
    }
    return true;
  }

  void connect(std::uint32_t a, std::uint32_t b) {
    if (a == b || (ends_[a].is_attached && ends_[b].is_attached)) {
      may_divide_ = true;
      return;
    }
    ends_[a].is_attached = ends_[a].is_attached || ends_[b].is_attached;
    for (std::size_t i = 0; i < count_; ++i) {
      if (ends_[i].set == b) ends_[i].set = a;
    }
  }

  std::array<End, kMostVertices> ends_{};
  std::size_t count_ = 0;
  bool may_divide_ = false;
};

}  // namespace waywright::constraint
