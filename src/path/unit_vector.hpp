#pragma once

#include <cmath>

#include "waywright/point.hpp"

#include "base/ieee.hpp"

namespace waywright::path {

/// Returns the vector of length 1 at the angle `angle` + `rest`, in radians: (cosine, sine). `rest` is a correction, at
/// most 2^-40. Each coordinate has an error below 2^-51 if `angle` is at most 2^19. Uses only operations that IEEE 754
/// rounds correctly, as path/tangent.hpp does.
///
/// Subtracts the nearest multiple of pi / 2 in two steps, then sums the two power series. The first subtraction is
/// exact: kFirst has 33 bits, so its product with a whole number up to 2^20 is a double, and it is near to `angle`.
[[nodiscard]] inline Point unit_vector(double angle, double rest = 0.0) {
  constexpr double kFirst = 0x1.921fb544p+0;  // kFirst + kSecond is pi / 2, with an error below 2^-87
  constexpr double kSecond = 0x1.0b4611a626331p-34;
  constexpr double kInverse = 0x1.45f306dc9c883p-1;  // 2 / pi
  const double quarters = std::floor(angle * kInverse + 0.5);
  const double small = (angle - quarters * kFirst) + (rest - quarters * kSecond);
  const double square = small * small;
  double sine = 1.0;
  for (int n = 16; n >= 2; n -= 2) sine = 1.0 - square / (n * (n + 1)) * sine;
  sine *= small;
  double cosine = 1.0;
  for (int n = 16; n >= 2; n -= 2) cosine = 1.0 - square / (n * (n - 1)) * cosine;
  const double quadrant = quarters - 4.0 * std::floor(quarters / 4.0);
  if (quadrant == 1.0) return {-sine, cosine};
  if (quadrant == 2.0) return {-cosine, -sine};
  if (quadrant == 3.0) return {sine, -cosine};
  return {cosine, sine};
}

}  // namespace waywright::path
