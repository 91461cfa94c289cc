#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mesh/triangle_mesh.hpp"

namespace waywright::constraint {

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
