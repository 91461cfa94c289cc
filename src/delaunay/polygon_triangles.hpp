#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "delaunay/geometry.hpp"
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

/// Triangulates the cavity that the removal of a vertex with many neighbours leaves. The border of the cavity, seen
/// from the lifted vertex, is a convex polygon. The new faces are the facets of the convex hull of the lifted border
/// that face the vertex. So in-circle tests and the order along the border decide everything, as in a triangulation of
/// a convex polygon.
///
/// The class inserts the vertices of the border in random order. Each insertion removes the triangles whose circle
/// contains the new vertex. The first of them is known: it lies on the edge between the two neighbours of the new
/// vertex in the polygon. Cost: expected linear in the number of border vertices.
///
/// Source: Chew, *Building Voronoi diagrams for convex polygons in linear expected time*, Dartmouth 1990.
class LargeCavity {
 public:
  using View = Geometry::View;
  using Triangle = mesh::TriangleMesh::Triangle;

  /// Fills `triangles` with the triangles of the cavity; each comes after the triangle on whose edge it lies, and the
  /// first one lies on the base. `positions` are the positions of the border's vertices, counter-clockwise. The base
  /// runs from the last of them to the first. `seed` decides in which order the function inserts the vertices
  /// (InsertionOrder::reset()). Requires: three or more positions.
  void triangulate(const Geometry& geometry, std::span<const View> positions, std::uint64_t seed,
                   std::vector<Triangle>& triangles);

  void count_memory(MemoryUse& use) const { triangles_.count_memory(use); }
  void release() { triangles_.release(); }

 private:
  using Index = PolygonTriangles::Index;

  /// Whether the circle of the triangle of `h` contains `p`. Seen from the removed vertex, every triangle is
  /// counter-clockwise. In the plane it can be clockwise, and then "contains" means the outside of the circle. The sign
  /// of the determinant is right for both. In a tie, one of the four lifted points is lowered: see
  /// tied_circle_contains().
  [[nodiscard]] bool is_in_circle(const Geometry& geometry, std::span<const View> positions, Index h, Index p) const;

  PolygonTriangles triangles_;
};

/// Triangulates one of the two polygons that a new segment leaves if it crosses many edges of a constrained Delaunay
/// triangulation. The segment is the base of the polygon. The polygon need not be convex, and it may be only weakly
/// simple: a vertex at which an edge dangles into the polygon occurs several times on its border.
///
/// The class inserts the vertices in random order, like LargeCavity. There are two differences:
/// - InsertionOrder removes one vertex after the other from the polygon, and each of the two classes inserts the
///   vertices in the reverse order. For LargeCavity, InsertionOrder may remove every vertex next. For this class, it
///   removes no vertex while both of its neighbours are farther from the segment than the vertex. So the polygon that
///   is left is weakly simple, too.
/// - Consider a triangle behind an edge of the area that the new vertex has replaced so far. The new vertex also
///   replaces this triangle if the vertex and the edge would form a triangle that is not counter-clockwise.
///
/// Source: Shewchuk and Brown, *Fast segment insertion and incremental construction of constrained Delaunay
/// triangulations*, 2015: the expected time is linear in the number of edges that the segment crosses. If the new
/// vertex does not see all vertices to which the method connects it, some new triangles are clockwise. The algorithm of
/// Shewchuk and Brown triangulates these parts again. In our tests, no large polygon needs this step. This class leaves
/// it out: if a polygon needs it, triangulate() returns false.
class SegmentCavity {
 public:
  using View = Geometry::View;
  using Triangle = mesh::TriangleMesh::Triangle;

  /// Removes all positions.
  void clear() {
    positions_.clear();
    rounded_.clear();
  }
  /// Adds the position of the next vertex on the border, counter-clockwise. The base runs from the last vertex to the
  /// first. `rounded` is the same position, rounded to doubles.
  void add(const View& position, const Point& rounded) {
    positions_.push_back(position);
    rounded_.push_back(rounded);
  }

  /// Triangulates the polygon. Fills `triangles` in the order of LargeCavity::triangulate(). Returns whether all
  /// triangles are counter-clockwise, so that they do not overlap. If it returns false, `triangles` has no meaning. The
  /// function does not prove that the triangles are Delaunay. Requires: three or more positions.
  [[nodiscard]] bool triangulate(const Geometry& geometry, std::vector<Triangle>& triangles);

  void count_memory(MemoryUse& use) const {
    triangles_.count_memory(use);
    memory::count_spare(use, positions_, rounded_, distances_);
  }
  void release() {
    triangles_.release();
    memory::release(positions_, rounded_, distances_);
  }

 private:
  using Index = PolygonTriangles::Index;

  /// Computes the distance of each vertex from the line of the segment, times a constant. A vertex may be so near to
  /// this line that a product of doubles has a larger rounding error than its distance. So the function uses products
  /// of Twofold numbers.
  void find_distances();

  /// Whether the new vertex `p` replaces the triangle of `h`. If a dangling edge starts at a corner of the triangle,
  /// `p` may have the same position as this corner. The in-circle test then has no meaning, but is_left() is false, so
  /// `p` replaces the triangle: if the corner is an end of `h`, the three positions are collinear; if it is the apex,
  /// it lies left of `h`, so b, a and `p` are clockwise.
  [[nodiscard]] bool replaces(const Geometry& geometry, Index h, Index p) const;

  std::vector<View> positions_;
  std::vector<Point> rounded_;
  PolygonTriangles triangles_;
  std::vector<double> distances_;  ///< by vertex: see find_distances()
};

}  // namespace waywright::delaunay
