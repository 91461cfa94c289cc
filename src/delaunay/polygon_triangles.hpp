#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// Changes a seed for InsertionOrder by a position. Start with any number, and pass the position of each vertex.
[[nodiscard]] std::uint64_t changed_seed(std::uint64_t seed, const Point& position);

/// A random order in which an algorithm inserts the vertices of a polygon. The vertices are the numbers from 0 to
/// count - 1, counter-clockwise. The edge from the last vertex to the first is the *base*. The base is there from the
/// start, so its two ends are not part of the order.
///
/// To find the order, reset() removes the vertices from the polygon one after the other. The insertions take the
/// reverse of this order. So a vertex is inserted between the two vertices between which it was removed.
class InsertionOrder {
 public:
  using Index = std::uint32_t;

  /// Finds the order for `count` vertices. Equal arguments give equal orders. The seed should depend on the positions
  /// of the vertices (changed_seed()): then it is hard to choose positions for which the order is a bad one. If
  /// `distances` is not empty, it contains a number for each vertex, and the function removes no vertex whose number is
  /// smaller than the numbers of both neighbours. Requires: `count` is at least 3, and no number is smaller than the
  /// numbers of the two ends of the base.
  void reset(std::size_t count, std::uint64_t seed, std::span<const double> distances = {});

  /// The vertices in the order of their insertion.
  [[nodiscard]] std::span<const Index> vertices() const { return order_; }
  /// The vertices before and after `v` in the polygon at the time of its insertion.
  [[nodiscard]] Index before(Index v) const { return before_[v]; }
  [[nodiscard]] Index after(Index v) const { return after_[v]; }

  void count_memory(MemoryUse& use) const { memory::count_spare(use, order_, before_, after_); }
  void release() { memory::release(order_, before_, after_); }

 private:
  std::vector<Index> order_;
  std::vector<Index> before_;
  std::vector<Index> after_;
};

/// Triangulates a polygon: inserts its vertices in the random order of an InsertionOrder. A triangle has three
/// half-edges in a row, counter-clockwise. The vertices and the base are as in InsertionOrder.
class PolygonTriangles {
 public:
  using Index = std::uint32_t;
  using Triangle = mesh::TriangleMesh::Triangle;

  [[nodiscard]] Index origin(Index h) const { return origin_[h]; }
  [[nodiscard]] Index target(Index h) const { return origin_[next(h)]; }
  [[nodiscard]] Index apex(Index h) const { return origin_[previous(h)]; }

  /// Fills `triangles` with the triangles of a polygon of `count` vertices. The first one lies on the base, and each of
  /// the others comes after the triangle on whose edge it lies. `count`, `seed` and `distances` are the arguments of
  /// InsertionOrder::reset().
  ///
  /// A new vertex `p` lies between two neighbours in the polygon. The triangle on the edge between them is the first
  /// that `p` may replace. Let h be a half-edge between the area that `p` has replaced and the triangle of h. If
  /// replaces(h, p) is true, `p` replaces this triangle, too.
  template <class Replaces>
  void triangulate(std::size_t count, std::uint64_t seed, std::span<const double> distances, Replaces&& replaces,
                   std::vector<Triangle>& triangles) {
    order_.reset(count, seed, distances);
    start(count, order_.vertices().front());
    for (const Index p : order_.vertices().subspan(1)) insert(p, replaces);
    list(triangles);
  }

  void count_memory(MemoryUse& use) const {
    order_.count_memory(use);
    memory::count_spare(use, origin_, twin_, outer_, free_, stack_);
  }
  void release() {
    order_.release();
    memory::release(origin_, twin_, outer_, free_, stack_);
  }

 private:
  static constexpr Index kBorder = 0xffffffff;  ///< stands for the twin of a half-edge on the border of the polygon

  /// An edge of the area that the new vertex has replaced. The edge has this area on its left.
  struct Edge {
    Index from;
    Index to;
    Index beyond;  ///< its half-edge in the triangle beyond it, or kBorder
  };

  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// Starts with one triangle: the base and the vertex `apex`.
  void start(std::size_t count, Index apex);
  /// Makes the triangle of `a`, `b` and `c`. Returns its half-edge from `a` to `b`. Call join() for each half-edge.
  Index add(Index a, Index b, Index c);
  /// Makes `g` the twin of `h`. If `g` is kBorder, `h` lies on the border of the polygon.
  void join(Index h, Index g) {
    twin_[h] = g;
    (g == kBorder ? outer_[origin_[h]] : twin_[g]) = h;
  }
  template <class Replaces>
  void insert(Index p, Replaces&& replaces) {
    const Index a = order_.before(p);
    stack_.assign(1, {order_.after(p), a, outer_[a]});
    Index incoming = kBorder;  // of the last new triangle: its half-edge that ends at p
    while (!stack_.empty()) {
      const auto [from, to, h] = stack_.back();
      stack_.pop_back();
      if (h != kBorder && replaces(h, p)) {
        stack_.push_back({apex(h), to, twin_[previous(h)]});
        stack_.push_back({from, apex(h), twin_[next(h)]});
        free_.push_back(h - h % 3);
        continue;
      }
      const Index made = add(from, to, p);
      join(made, h);
      join(previous(made), incoming);
      incoming = next(made);
    }
    join(incoming, kBorder);
  }
  void list(std::vector<Triangle>& triangles);

  InsertionOrder order_;
  std::vector<Index> origin_;  ///< by half-edge
  std::vector<Index> twin_;    ///< by half-edge
  std::vector<Index> outer_;   ///< by vertex: the half-edge on the border that starts there
  std::vector<Index> free_;    ///< first half-edges of removed triangles; in list(): bases of listed triangles
  std::vector<Edge> stack_;
};

}  // namespace waywright::delaunay
