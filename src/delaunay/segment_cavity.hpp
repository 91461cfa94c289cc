#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/memory_use.hpp"
#include "waywright/point.hpp"

#include "base/compiler.hpp"
#include "delaunay/polygon_triangles.hpp"
#include "delaunay/tie_rule.hpp"
#include "exact/sign.hpp"
#include "exact/twofold.hpp"
#include "memory/count.hpp"

namespace waywright::delaunay {

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
template <class Geometry>
class SegmentCavity {
 public:
  using View = typename Geometry::View;
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
  [[nodiscard]] WAYWRIGHT_NO_INLINE bool triangulate(const Geometry& geometry, std::vector<Triangle>& triangles) {
    find_distances();
    std::uint64_t seed = 0;
    for (const Point& p : rounded_) seed = changed_seed(seed, p);
    triangles_.triangulate(
        positions_.size(), seed, distances_, [&](Index h, Index p) { return replaces(geometry, h, p); }, triangles);
    return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
      return is_left(geometry, positions_[triangle.from], positions_[triangle.apex], positions_[triangle.to]);
    });
  }

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

  [[nodiscard]] WAYWRIGHT_NO_INLINE static bool is_left(const Geometry& geometry, const View& a, const View& b,
                                                        const View& c) {
    return geometry.orientation(a, b, c) == exact::Sign::positive;
  }

  /// Computes the distance of each vertex from the line of the segment, times a constant. A vertex may be so near to
  /// this line that a product of doubles has a larger rounding error than its distance. So the function uses products
  /// of Twofold numbers.
  WAYWRIGHT_NO_INLINE void find_distances() {
    distances_.clear();
    for (const Point& p : rounded_)
      distances_.push_back(std::abs(exact::precise_cross(rounded_.back(), rounded_.front(), p)));
  }

  /// Whether the new vertex `p` replaces the triangle of `h`. If a dangling edge starts at a corner of the triangle,
  /// `p` may have the same position as this corner. The in-circle test then has no meaning, but is_left() is false, so
  /// `p` replaces the triangle: if the corner is an end of `h`, the three positions are collinear; if it is the apex,
  /// it lies left of `h`, so b, a and `p` are clockwise.
  [[nodiscard]] bool replaces(const Geometry& geometry, Index h, Index p) const {
    const View& a = positions_[triangles_.origin(h)];
    const View& b = positions_[triangles_.target(h)];
    return circle_contains(geometry, a, b, positions_[triangles_.apex(h)], positions_[p]) ||
           !is_left(geometry, b, a, positions_[p]);
  }

  std::vector<View> positions_;
  std::vector<Point> rounded_;
  PolygonTriangles triangles_;
  std::vector<double> distances_;  ///< by vertex: see find_distances()
};

}  // namespace waywright::delaunay
