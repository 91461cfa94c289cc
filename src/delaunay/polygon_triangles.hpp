#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"

#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

/// A random order in which an algorithm inserts the vertices of a polygon. The vertices are the numbers from 0 to
/// count - 1, counter-clockwise. The edge from the last vertex to the first is the *base*. The base is there from the
/// start, so its two ends are not part of the order.
///
/// To find the order, reset() removes the vertices from the polygon one after the other. The insertions take the
/// reverse of this order. So a vertex is inserted between the two vertices between which it was removed.
class InsertionOrder {
 public:
  using Index = std::uint32_t;

  /// Finds the order for `count` vertices. Equal arguments give equal orders. If `distances` is not empty, it contains
  /// a number for each vertex, and the function removes no vertex whose number is smaller than the numbers of both
  /// neighbours. Requires: `count` is at least 3, and no number is smaller than the numbers of the two ends of the
  /// base.
  void reset(std::size_t count, std::span<const double> distances = {});

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

/// The triangles of a polygon while an algorithm inserts the vertices of the polygon one after the other. A triangle
/// has three half-edges in a row, counter-clockwise. The vertices and the base are as in InsertionOrder.
class PolygonTriangles {
 public:
  using Index = std::uint32_t;
  using Triangle = mesh::TriangleMesh::Triangle;
  static constexpr Index kBorder = 0xffffffff;  ///< stands for the twin of a half-edge on the border of the polygon

  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] Index origin(Index h) const { return origin_[h]; }
  [[nodiscard]] Index target(Index h) const { return origin_[next(h)]; }
  [[nodiscard]] Index apex(Index h) const { return origin_[previous(h)]; }
  /// The twin, or kBorder.
  [[nodiscard]] Index twin(Index h) const { return twin_[h]; }

  /// Starts with one triangle: the base and the vertex `apex`. The polygon will have `count` vertices.
  void start(std::size_t count, Index apex);
  /// Makes the triangle of `a`, `b` and `c`. Returns its half-edge from `a` to `b`. Call join() for each half-edge.
  Index add(Index a, Index b, Index c);
  /// Removes the triangle of `h`.
  void remove(Index h) { free_.push_back(h - h % 3); }
  /// Makes `g` the twin of `h`. If `g` is kBorder, `h` lies on the border of the polygon.
  void join(Index h, Index g) {
    twin_[h] = g;
    (g == kBorder ? outer_[origin_[h]] : twin_[g]) = h;
  }

  /// Inserts the vertex `p` between `a` and `b`, which are neighbours in the polygon. The triangle on the edge between
  /// them is the first that `p` may replace. Let h be a half-edge between the area that `p` has replaced and the
  /// triangle of h. If replaces(h) is true, `p` replaces this triangle, too.
  template <class Replaces>
  void insert(Index p, Index a, Index b, Replaces&& replaces) {
    stack_.assign(1, {b, a, outer_[a]});
    Index incoming = kBorder;  // of the last new triangle: its half-edge that ends at p
    while (!stack_.empty()) {
      const auto [from, to, h] = stack_.back();
      stack_.pop_back();
      if (h != kBorder && replaces(h)) {
        stack_.push_back({apex(h), to, twin_[previous(h)]});
        stack_.push_back({from, apex(h), twin_[next(h)]});
        remove(h);
        continue;
      }
      const Index made = add(from, to, p);
      join(made, h);
      join(previous(made), incoming);
      incoming = next(made);
    }
    join(incoming, kBorder);
  }

  /// Fills `triangles` with the triangles. The first one lies on the base, and each of the others comes after the
  /// triangle on whose edge it lies.
  void list(std::vector<Triangle>& triangles);

  void count_memory(MemoryUse& use) const { memory::count_spare(use, origin_, twin_, outer_, free_, stack_); }
  void release() { memory::release(origin_, twin_, outer_, free_, stack_); }

 private:
  /// An edge of the area that the new vertex has replaced. The edge has this area on its left.
  struct Edge {
    Index from;
    Index to;
    Index beyond;  ///< its half-edge in the triangle beyond it, or kBorder
  };

  std::vector<Index> origin_;  ///< by half-edge
  std::vector<Index> twin_;
  std::vector<Index> outer_;  ///< by vertex: the half-edge on the border that starts there
  std::vector<Index>
      free_;  ///< the first half-edges of removed triangles; in list(): the bases of the listed triangles
  std::vector<Edge> stack_;
};

}  // namespace waywright::delaunay
