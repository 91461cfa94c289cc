#include "exact/small_integers.hpp"

#include <cmath>
#include <cstdint>

namespace waywright::exact::small_integers {

namespace {

constexpr double kLargestCoordinate = 0x1p52;  // below this, the difference of two integers is computed exactly
constexpr double kLargestDifference = 0x1p29;

struct Offset {
  std::int64_t x, y;
};

bool is_integer_point(const ExactPoint& p) {
  return p.is_explicit() && std::abs(p.x) < kLargestCoordinate && std::abs(p.y) < kLargestCoordinate &&
         p.x == static_cast<double>(static_cast<std::int64_t>(p.x)) &&
         p.y == static_cast<double>(static_cast<std::int64_t>(p.y));
}

/// From `origin`, an integer point, to `p`, where that is one and near.
std::optional<Offset> offset(const ExactPoint& p, const ExactPoint& origin) {
  const double dx = p.x - origin.x;
  const double dy = p.y - origin.y;
  if (!(std::abs(dx) <= kLargestDifference && std::abs(dy) <= kLargestDifference)) return std::nullopt;
  if (!is_integer_point(p)) return std::nullopt;
  return Offset{static_cast<std::int64_t>(dx), static_cast<std::int64_t>(dy)};
}

std::int64_t cross(const Offset& p, const Offset& q) { return p.x * q.y - p.y * q.x; }

}  // namespace

std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  if (!is_integer_point(c)) return std::nullopt;
  const auto p = offset(a, c);
  const auto q = offset(b, c);
  if (!p || !q) return std::nullopt;
  return sign_of(cross(*p, *q));
}

#if defined(__SIZEOF_INT128__)

namespace {

using Wide = __int128;

std::int64_t lift(const Offset& p) { return p.x * p.x + p.y * p.y; }

}  // namespace

std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  if (!is_integer_point(d)) return std::nullopt;
  const auto p = offset(a, d);
  const auto q = offset(b, d);
  const auto r = offset(c, d);
  if (!p || !q || !r) return std::nullopt;
  const Wide determinant =
      Wide{lift(*p)} * cross(*q, *r) + Wide{lift(*q)} * cross(*r, *p) + Wide{lift(*r)} * cross(*p, *q);
  return sign_of(determinant);
}

#else

std::optional<Sign> in_circle(const ExactPoint& /*a*/, const ExactPoint& /*b*/, const ExactPoint& /*c*/,
                              const ExactPoint& /*d*/) {
  return std::nullopt;
}

#endif

}  // namespace waywright::exact::small_integers
