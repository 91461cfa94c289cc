#pragma once

#include "exact/sign.hpp"

namespace waywright::delaunay {

/// Whether the circle through `a`, `b`, `c` (counter-clockwise) holds `d`, another place on it, ties broken.
///
/// Lowering the first of the four by an infinitesimal decides: if that is d itself, the circle holds it; if it is one
/// of the others, swapping it with d in the determinant turns it into that case, with the sign of the orientation of d
/// and the two that remain.
template <class Geometry, class View = typename Geometry::View>
[[nodiscard]] bool tied_circle_holds(const Geometry& geometry, const View& a, const View& b, const View& c,
                                     const View& d) {
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

/// The same of any other place `d`.
template <class Geometry, class View = typename Geometry::View>
[[nodiscard]] bool circle_holds(const Geometry& geometry, const View& a, const View& b, const View& c, const View& d) {
  const exact::Sign sign = geometry.in_circle(a, b, c, d);
  if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
  return tied_circle_holds(geometry, a, b, c, d);
}

}  // namespace waywright::delaunay
