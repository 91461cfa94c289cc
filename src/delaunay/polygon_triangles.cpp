#include "delaunay/polygon_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/compiler.hpp"
#include "delaunay/legality.hpp"
#include "exact/doubles.hpp"
#include "exact/position.hpp"

namespace waywright::delaunay {

namespace {

[[nodiscard]] WAYWRIGHT_NO_INLINE bool is_left(const Geometry& geometry, const Geometry::View& a,
                                               const Geometry::View& b, const Geometry::View& c) {
  return geometry.orientation(a, b, c) == exact::Sign::positive;
}

}  // namespace

std::uint64_t changed_seed(std::uint64_t seed, const Point& position) {
  for (const double coordinate : {position.x, position.y}) {
    seed = (seed ^ base::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
    seed ^= seed >> 32;
  }
  return seed;
}

void InsertionOrder::reset(std::size_t count, std::uint64_t seed, std::span<const double> distances) {
  order_.resize(count - 2);
  before_.resize(count);
  after_.resize(count);
  for (Index i = 0; i < count; ++i) {
    before_[i] = i - 1;
    after_[i] = i + 1;
    if (i + 2 < count) order_[i] = i + 1;
  }
  std::uint64_t state = seed;
  for (std::size_t left = order_.size(); left > 0;) {
    state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator
    Index& chosen = order_[static_cast<std::size_t>((state >> 32) * left >> 32)];
    const Index v = chosen;
    // The loop ends: a vertex with the largest number of those that are left passes this test, and NaN passes it.
    if (!distances.empty() && distances[v] < std::min(distances[before_[v]], distances[after_[v]])) continue;
    after_[before_[v]] = after_[v];
    before_[after_[v]] = before_[v];
    std::swap(chosen, order_[--left]);
  }
}

void PolygonTriangles::start(std::size_t count, Index apex) {
  origin_.clear();
  twin_.clear();
  free_.clear();
  outer_.resize(count);
  const Index base = add(static_cast<Index>(count - 1), 0, apex);
  for (const Index h : {base, next(base), previous(base)}) join(h, kBorder);
}

PolygonTriangles::Index PolygonTriangles::add(Index a, Index b, Index c) {
  auto first = static_cast<Index>(origin_.size());
  if (free_.empty()) {
    origin_.resize(first + 3);
    twin_.resize(first + 3);
  } else {
    first = free_.back();
    free_.pop_back();
  }
  origin_[first] = a;
  origin_[first + 1] = b;
  origin_[first + 2] = c;
  return first;
}

void PolygonTriangles::list(std::vector<Triangle>& triangles) {
  triangles.clear();
  free_.assign(1, outer_.back());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    // The half-edge `base` cuts off a piece of the border. It runs from the last vertex of this piece to the first.
    const Index base = free_[i];
    triangles.push_back({target(base), apex(base), origin(base)});
    for (const Index h : {next(base), previous(base)}) {
      if (twin_[h] != kBorder) free_.push_back(twin_[h]);
    }
  }
}

void LargeCavity::triangulate(const Geometry& geometry, std::span<const View> positions, std::uint64_t seed,
                              std::vector<Triangle>& triangles) {
  const auto replaces = [&](Index h, Index p) { return is_in_circle(geometry, positions, h, p); };
  triangles_.triangulate(positions.size(), seed, {}, replaces, triangles);
}

bool LargeCavity::is_in_circle(const Geometry& geometry, std::span<const View> positions, Index h, Index p) const {
  const View& a = positions[triangles_.origin(h)];
  const View& b = positions[triangles_.target(h)];
  const View& c = positions[triangles_.apex(h)];
  const View& d = positions[p];
  const exact::Sign sign = geometry.in_circle(a, b, c, d);
  if (sign != exact::Sign::zero) return sign == exact::Sign::positive;
  const bool comes_first = geometry.order(d, a) < 0 && geometry.order(d, b) < 0 && geometry.order(d, c) < 0;
  if (comes_first) return geometry.orientation(a, b, c) == exact::Sign::positive;
  return tied_circle_contains(geometry, a, b, c, d);
}

bool SegmentCavity::triangulate(const Geometry& geometry, std::vector<Triangle>& triangles) {
  find_distances();
  std::uint64_t seed = 0;
  for (const Point& p : rounded_) seed = changed_seed(seed, p);
  triangles_.triangulate(
      positions_.size(), seed, distances_, [&](Index h, Index p) { return replaces(geometry, h, p); }, triangles);
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
    return is_left(geometry, positions_[triangle.from], positions_[triangle.apex], positions_[triangle.to]);
  });
}

void SegmentCavity::find_distances() {
  distances_.clear();
  for (const Point& p : rounded_)
    distances_.push_back(std::abs(exact::precise_cross(rounded_.back(), rounded_.front(), p)));
}

bool SegmentCavity::replaces(const Geometry& geometry, Index h, Index p) const {
  const View& a = positions_[triangles_.origin(h)];
  const View& b = positions_[triangles_.target(h)];
  return circle_contains(geometry, a, b, positions_[triangles_.apex(h)], positions_[p]) ||
         !is_left(geometry, b, a, positions_[p]);
}

}  // namespace waywright::delaunay
