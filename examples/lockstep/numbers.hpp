#pragma once

// Numbers and shapes that are the same on every machine: they need only integers and + - * /.

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/item.hpp"
#include "waywright/point.hpp"

/// Returns a number that looks random: the next one of SplitMix64 after the state `z`.
/// Source: Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014.
inline std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// At least 0 and below 1, a multiple of 2^-20: such numbers are exact in `double`.
inline double share_of(std::uint64_t number) { return static_cast<double>(mixed(number) >> 44) / 1048576.0; }

/// Rounds `value` towards 0 to a multiple of 1/256. Sums of such numbers are exact as long as they are small. So a
/// building has the same coordinates whether it is built at a point or moved there.
inline double rounded(double value) { return static_cast<double>(static_cast<std::int64_t>(256 * value)) / 256; }

/// A turned rectangle. The rotation comes from a rational point on the unit circle, so it needs neither sin nor cos.
inline waywright::Shape building_at(const waywright::Point& centre, std::uint64_t number) {
  const double t = share_of(number);
  const double cosine = (1 - t * t) / (1 + t * t);
  const double sine = 2 * t / (1 + t * t);
  const double width = 4 + 8 * share_of(number + 1);
  const double height = 4 + 8 * share_of(number + 2);
  std::vector<waywright::Point> ring;
  const std::array<waywright::Point, 4> corners = {
      {{-width, -height}, {width, -height}, {width, height}, {-width, height}}};
  for (const waywright::Point& corner : corners) {
    const waywright::Point turned{corner.x * cosine - corner.y * sine, corner.x * sine + corner.y * cosine};
    ring.push_back({centre.x + rounded(turned.x), centre.y + rounded(turned.y)});
  }
  return waywright::Shape::polygon(ring);
}
