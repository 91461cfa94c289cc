#pragma once

#include <algorithm>
#include <array>

#include "waywright/point.hpp"

#include "base/ieee.hpp"
#include "exact/exact_position.hpp"
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

}  // namespace waywright::constraint
