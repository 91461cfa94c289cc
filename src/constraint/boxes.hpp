#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "constraint/constrained_triangulation.hpp"
#include "exact/position.hpp"
#include "exact/predicates.hpp"

namespace waywright::constraint {

/// Tests whether points and segments meet a closed box. A segment misses the box if their extents do not overlap, or if
/// all four corners of the box lie strictly left, or all strictly right, of the segment's line.
class BoxTest {
 public:
  explicit BoxTest(const Box& box)
      : box_(box),
        corners_{exact::explicit_position(box.min), exact::ExactPosition{box.max.x, box.min.y},
                 exact::explicit_position(box.max), exact::ExactPosition{box.min.x, box.max.y}} {}

  [[nodiscard]] bool contains(const Point& p) const {
    return p.x >= box_.min.x && p.x <= box_.max.x && p.y >= box_.min.y && p.y <= box_.max.y;
  }

  /// Whether the segment from `p` to `q` meets the box. The answer is exact for explicit ends. Rounding to nearest is
  /// monotone, so if the rounded extents miss the box, the exact ones miss it, too. For constructed ends that are
  /// rounded onto the border of the box, the answer can be true although the segment misses the box.
  [[nodiscard]] bool meets(const exact::ExactPosition& p, const exact::ExactPosition& q) const {
    if (std::max(p.x, q.x) < box_.min.x || std::min(p.x, q.x) > box_.max.x) return false;
    if (std::max(p.y, q.y) < box_.min.y || std::min(p.y, q.y) > box_.max.y) return false;
    if (is_inside(p) || is_inside(q)) return true;  // the common case of a box around a vertex
    int left = 0;
    int right = 0;
    for (const exact::ExactPosition& corner : corners_) {
      const exact::Sign orientation = exact::orientation(p, q, corner);
      left += orientation == exact::Sign::positive ? 1 : 0;
      right += orientation == exact::Sign::negative ? 1 : 0;
    }
    return left < 4 && right < 4;
  }

 private:
  /// Returns true only if the exact position lies strictly inside the box: rounding to nearest is monotone.
  [[nodiscard]] bool is_inside(const exact::ExactPosition& p) const {
    return p.x > box_.min.x && p.x < box_.max.x && p.y > box_.min.y && p.y < box_.max.y;
  }

  Box box_;
  std::array<exact::ExactPosition, 4> corners_;
};

/// Visits the faces of the domain that meet a closed box, and sometimes a few faces that only constructed vertices,
/// rounded onto the border of the box, connect with it. Calls reach(f) for a face when it arrives there: `reach`
/// returns whether this is the first time. Calls visit(h, meets) for each half-edge of these faces: `meets` says
/// whether the edge meets the box. Requires: a position of the box lies in the face of `start`, which is a face of the
/// domain. Overwrites `faces`.
template <class Reach, class Visit>
void flood_box(const ConstrainedTriangulation& triangulation, const BoxTest& box, mesh::HalfEdge start,
               std::vector<mesh::HalfEdge>& faces, const Reach& reach, const Visit& visit) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const exact::Geometry& geometry = triangulation.triangulation().geometry();
  const auto arrive = [&](mesh::HalfEdge h) {
    if (!triangulation.triangulation().is_ghost_face(h) && reach(mesh::face(h))) faces.push_back(h);
  };
  faces.clear();
  arrive(start);
  while (!faces.empty()) {
    const mesh::HalfEdge face = faces.back();
    faces.pop_back();
    for (const mesh::HalfEdge h : {face, mesh::next(face), mesh::previous(face)}) {
      const bool meets = box.meets(geometry.exact(number(mesh.origin(h))), geometry.exact(number(mesh.target(h))));
      visit(h, meets);
      if (meets) arrive(mesh.twin(h));
    }
  }
}

}  // namespace waywright::constraint
