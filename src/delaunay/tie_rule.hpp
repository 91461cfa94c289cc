#pragma once

#include "base/compiler.hpp"
#include "exact/sign.hpp"

namespace waywright::delaunay {

/// Whether the circle through `a`, `b` and `c` (counter-clockwise) contains `d`, another position on the circle. This
/// function breaks the tie.
///
/// The first of the four lifted points is lowered by an infinitesimal. If the first is d, the circle contains d. If it
/// is one of the others, a swap of this point and d in the determinant leads to the same case. The orientation of d and
/// the two remaining points gives the sign: the circle contains d if it is negative.
/// Not inlined: ties are rare.
template <class Geometry, class View = typename Geometry::View>
[[nodiscard]] WAYWRIGHT_NO_INLINE bool tied_circle_contains(const Geometry& geometry, const View& a, const View& b,
                                                            const View& c, const View& d) {
  const View* first = &d;
  for (const View* const v : {&a, &b, &c}) {
    if (geometry.order(*v, *first) < 0) first = v;
  }
  if (first == &d) return true;
  const exact::Sign rest = first == &a   ? geometry.orientation(d, b, c)
                           : first == &b ? geometry.orientation(a, d, c)
                                         : geometry.orientation(a, b, d);
  return rest == exact::Sign::negative;
}

/// Whether the circle through `a`, `b` and `c` (counter-clockwise) contains `d`; breaks ties. Requires: `d` differs
/// from the other three.
template <class Geometry, class View = typename Geometry::View>
[[nodiscard]] bool circle_contains(const Geometry& geometry, const View& a, const View& b, const View& c,
                                   const View& d) {
  const exact::Sign sign = geometry.in_circle(a, b, c, d);
  if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
  return tied_circle_contains(geometry, a, b, c, d);
}

}  // namespace waywright::delaunay
