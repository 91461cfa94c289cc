#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "waywright/memory_use.hpp"

#include "delaunay/tie_rule.hpp"
#include "memory/count.hpp"
#include "mesh/triangle_mesh.hpp"

namespace waywright::delaunay {

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
template <class Geometry>
class LargeCavity {
 public:
  using View = typename Geometry::View;
  using Triangle = mesh::TriangleMesh::Triangle;

  /// Fills `triangles` with the triangles of the cavity; each comes after the triangle on whose edge it lies, and the
  /// first one lies on the base. `positions` are the positions of the border's vertices, counter-clockwise. The base
  /// runs from the last of them to the first. Requires: three or more positions.
  void triangulate(const Geometry& geometry, std::span<const View> positions, std::vector<Triangle>& triangles) {
    shuffle(positions.size());
    start(positions.size());
    for (std::size_t i = order_.size() - 1; i-- > 0;) insert(geometry, positions, order_[i]);
    list(positions.size(), triangles);
  }

  void count_memory(MemoryUse& use) const {
    memory::count_spare(use, order_, before_, after_, origin_, twin_, outer_, free_, stack_);
  }
  void release() { memory::release(order_, before_, after_, origin_, twin_, outer_, free_, stack_); }

 private:
  using Index = std::uint32_t;
  static constexpr Index kBorder = 0xffffffff;

  /// An edge on the border of the area that the new vertex sees. The edge has this area on its left.
  struct Edge {
    Index from;
    Index to;
    Index beyond;  ///< its half-edge in the triangle beyond it, or kBorder
  };

  [[nodiscard]] static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// Puts all vertices except the two ends of the base into random order, always the same for the same number of
  /// vertices. Then notes the two neighbours of each vertex at the time of its insertion. The insertions take the
  /// vertices in the reverse of this order. So the neighbours are those in the polygon of the later vertices of the
  /// order and the two ends of the base.
  void shuffle(std::size_t count) {
    order_.resize(count - 2);
    before_.resize(count);
    after_.resize(count);
    for (Index i = 0; i < count; ++i) {
      before_[i] = i - 1;
      after_[i] = i + 1;
      if (i + 2 < count) order_[i] = i + 1;
    }
    std::uint64_t state = count;
    for (std::size_t i = order_.size(); i > 1; --i) {
      state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator
      std::swap(order_[i - 1], order_[static_cast<std::size_t>((state >> 32) * i >> 32)]);
    }
    for (const Index i : order_) {
      after_[before_[i]] = after_[i];
      before_[after_[i]] = before_[i];
    }
  }

  /// Makes the triangle of the last vertex of the order and the two ends of the base.
  void start(std::size_t count) {
    origin_.clear();
    twin_.clear();
    free_.clear();
    outer_.resize(count);
    const Index first = add_triangle(static_cast<Index>(count - 1), 0, order_.back());
    outer_[count - 1] = first;
    outer_[0] = next(first);
    outer_[order_.back()] = previous(first);
  }

  Index add_triangle(Index a, Index b, Index c) {
    Index first = static_cast<Index>(origin_.size());
    if (free_.empty()) {
      origin_.resize(first + 3);
      twin_.resize(first + 3);
    } else {
      first = free_.back();
      free_.pop_back();
    }
    for (const Index v : {a, b, c}) {
      origin_[first] = v;
      twin_[first++] = kBorder;
    }
    return first - 3;
  }

  void link(Index g, Index h) {
    twin_[g] = h;
    twin_[h] = g;
  }

  // The new vertex p lies between a and b. The function goes along the border of the area that p sees, from b to a, and
  // makes a triangle of p and each edge there.
  void insert(const Geometry& geometry, std::span<const View> positions, Index p) {
    const Index a = before_[p];
    const Index b = after_[p];
    Index incoming = kBorder;  // of the last new triangle: its half-edge that ends at p
    stack_.assign(1, {b, a, outer_[a]});
    while (!stack_.empty()) {
      const Edge edge = stack_.back();
      stack_.pop_back();
      const Index h = edge.beyond;
      if (h != kBorder && is_in_circle(geometry, positions, h, p)) {
        const Index c = origin_[previous(h)];
        stack_.push_back({c, edge.to, twin_[previous(h)]});
        stack_.push_back({edge.from, c, twin_[next(h)]});
        free_.push_back(h - h % 3);
        continue;
      }
      const Index made = add_triangle(edge.from, edge.to, p);
      if (h == kBorder) {
        outer_[edge.from] = made;
      } else {
        link(made, h);
      }
      if (incoming == kBorder) {
        outer_[p] = previous(made);
      } else {
        link(previous(made), incoming);
      }
      incoming = next(made);
    }
    outer_[a] = incoming;
  }

  /// Whether the circle of the triangle of `h` contains `p`. Seen from the removed vertex, every triangle is
  /// counter-clockwise. In the plane it can be clockwise, and then "contains" means the outside of the circle. The sign
  /// of the determinant is right for both. In a tie, one of the four lifted points is lowered: see tie_rule.hpp.
  [[nodiscard]] bool is_in_circle(const Geometry& geometry, std::span<const View> positions, Index h, Index p) const {
    const View& a = positions[origin_[h]];
    const View& b = positions[origin_[next(h)]];
    const View& c = positions[origin_[previous(h)]];
    const View& d = positions[p];
    const exact::Sign sign = geometry.in_circle(a, b, c, d);
    if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
    const bool comes_first = geometry.order(d, a) < 0 && geometry.order(d, b) < 0 && geometry.order(d, c) < 0;
    if (comes_first) return geometry.orientation(a, b, c) == exact::Sign::positive;
    return tied_circle_contains(geometry, a, b, c, d);
  }

  void list(std::size_t count, std::vector<Triangle>& triangles) {
    triangles.clear();
    free_.assign(1, outer_[count - 1]);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      // The half-edge `base` cuts off a piece of the border. It runs from the last vertex of this piece to the first.
      const Index base = free_[i];
      const Index apex = origin_[previous(base)];
      triangles.push_back({origin_[next(base)], apex, origin_[base]});
      for (const Index h : {next(base), previous(base)}) {
        if (twin_[h] != kBorder) free_.push_back(twin_[h]);
      }
    }
  }

  std::vector<Index> order_;
  std::vector<Index> before_;  ///< by vertex: the neighbour before it when it is inserted
  std::vector<Index> after_;
  std::vector<Index> origin_;  ///< by half-edge; each triangle has three half-edges in a row
  std::vector<Index> twin_;
  std::vector<Index> outer_;  ///< by vertex: the half-edge on the border that starts there
  std::vector<Index> free_;   ///< the first half-edges of unused triangles; later the bases of the listed triangles
  std::vector<Edge> stack_;
};

}  // namespace waywright::delaunay
