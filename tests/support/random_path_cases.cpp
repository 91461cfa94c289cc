#include "support/random_path_cases.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "waywright/id.hpp"
#include "waywright/item.hpp"

#include "support/random.hpp"

namespace waywright::test {
namespace {

using Ring = std::vector<Point>;

class PathSceneMaker {
 public:
  PathSceneMaker(Obstacles obstacles, Random& random) : obstacles_(obstacles), random_(random) {
    // Small enough that some items touch, and large enough that some do not.
    size_ = std::array<std::int64_t, 3>{16, 40, 1000}[random_.below(3)];
    tile_ = std::max<std::int64_t>(size_ / random_.between(8, 16), 1);
    reach_ = std::max<std::int64_t>(size_ / random_.between(3, 10), 2);
  }

  Scene make() {
    Scene scene;
    scene.domain = {{0.0, 0.0}, point(size_, size_)};
    const std::size_t count = 10 + random_.below(51);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_round = obstacles_ == Obstacles::rounds && (i == 0 || random_.chance(8));
      scene.items.push_back({ItemId{i + 1}, is_round ? round_polygon() : shape(obstacles_)});
    }
    return scene;
  }

 private:
  static Point point(std::int64_t x, std::int64_t y) { return {static_cast<double>(x), static_cast<double>(y)}; }

  [[nodiscard]] std::int64_t inside(std::int64_t value) const { return std::clamp<std::int64_t>(value, 0, size_); }

  Shape shape(Obstacles obstacles) {
    switch (obstacles) {
      case Obstacles::boxes:
        return {ItemKind::polygon, {random_.chance(60) ? upright_box() : random_chain(random_.chance(50) ? 3 : 4)}};
      case Obstacles::walls:
        return {ItemKind::segment, {random_chain(2)}};
      case Obstacles::polylines:
        return polyline();
      case Obstacles::tiles:
        return {ItemKind::polygon, {random_.chance(15) ? pinched_tiles() : run_of_tiles()}};
      case Obstacles::mixture:
      case Obstacles::rounds:
        break;
    }
    return shape(kObstacles[random_.below(4)]);
  }

  /// Returns a position within reach of (x, y), a third of the time along an axis.
  std::pair<std::int64_t, std::int64_t> step(std::int64_t x, std::int64_t y) {
    const std::size_t direction = random_.below(6);
    if (direction != 0) x = inside(x + random_.between(-reach_, reach_));
    if (direction != 1) y = inside(y + random_.between(-reach_, reach_));
    return {x, y};
  }

  Ring random_chain(std::size_t count) {
    std::int64_t x = random_.between(0, size_);
    std::int64_t y = random_.between(0, size_);
    Ring ring{point(x, y)};
    while (ring.size() < count) {
      std::tie(x, y) = step(x, y);
      ring.push_back(point(x, y));
    }
    return ring;
  }

  /// Returns a convex polygon with up to 32 corners. Its edges come in opposite pairs and have different directions.
  Shape round_polygon() {
    const std::int64_t largest = random_.between(size_ / 4, size_ / 2);
    const std::int64_t unit = std::max<std::int64_t>(largest / 18, 1);
    Ring edges;
    std::int64_t left = 0;
    std::int64_t right = 0;
    std::int64_t height = 0;
    for (std::int64_t length = 1; length <= 3; ++length) {
      for (std::int64_t y = 0; y <= length; ++y) {
        for (std::int64_t x = -length; x <= length; ++x) {
          const bool is_upper = y > 0 || x > 0;
          if (!is_upper || std::max(std::abs(x), y) != length || std::gcd(x, y) != 1) continue;
          const bool fits = left + right + std::abs(x) * unit <= largest && height + y * unit <= largest;
          if (!fits || random_.chance(20)) continue;
          edges.push_back(point(x * unit, y * unit));
          (x < 0 ? left : right) += std::abs(x) * unit;
          height += y * unit;
        }
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Point& p, const Point& q) { return cross(p, q) > 0.0; });
    const std::size_t half = edges.size();
    for (std::size_t i = 0; i < half; ++i) edges.push_back(-edges[i]);
    const std::int64_t x = random_.between(left, size_ - right);
    Ring ring{point(x, random_.between(0, size_ - height))};
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) ring.push_back(ring.back() + edges[i]);
    return {ItemKind::polygon, {std::move(ring)}};
  }

  Ring upright_box() {
    const std::int64_t x = random_.between(0, size_);
    const std::int64_t y = random_.between(0, size_);
    const auto [far_x, far_y] = step(x, y);
    return {point(x, y), point(far_x, y), point(far_x, far_y), point(x, far_y)};
  }

  Shape polyline() {
    Ring ring = random_chain(3 + random_.below(6));
    if (random_.chance(15)) ring.push_back(ring.front());
    return {ItemKind::polyline, {std::move(ring)}};
  }

  Ring run_of_tiles() {
    const std::int64_t x = random_.between(0, size_ / tile_ - 1) * tile_;
    const std::int64_t y = random_.between(0, size_ / tile_ - 1) * tile_;
    const std::int64_t length = random_.between(1, 4) * tile_;
    const bool across = random_.chance(50);
    const std::int64_t far_x = inside(across ? x + length : x + tile_);
    const std::int64_t far_y = inside(across ? y + tile_ : y + length);
    return {point(x, y), point(far_x, y), point(far_x, far_y), point(x, far_y)};
  }

  /// Returns two tiles that touch diagonally as one ring, which visits their common corner twice. Half of the time the
  /// ring crosses itself there.
  Ring pinched_tiles() {
    const std::int64_t x = random_.between(1, size_ / tile_ - 1) * tile_;
    const std::int64_t y = random_.between(1, size_ / tile_ - 1) * tile_;
    const Point middle = point(x, y);
    const Ring low{middle, point(x - tile_, y), point(x - tile_, y - tile_), point(x, y - tile_)};
    Ring ring{middle, point(x + tile_, y), point(x + tile_, y + tile_), point(x, y + tile_)};
    if (random_.chance(50)) std::reverse(ring.begin() + 1, ring.end());
    ring.insert(ring.end(), low.begin(), low.end());
    return ring;
  }

  Obstacles obstacles_;
  Random& random_;
  std::int64_t size_ = 0;
  std::int64_t tile_ = 0;
  std::int64_t reach_ = 0;
};

template <class RandomPoint>
std::vector<Ends> random_queries(const Scene& scene, std::size_t count, Random& random, RandomPoint&& random_point) {
  const auto end = [&]() -> Point {
    if (scene.items.empty() || random.chance(67)) return random_point();
    const auto& rings = scene.items[random.below(scene.items.size())].shape.rings;
    const auto& ring = rings[random.below(rings.size())];
    return ring[random.below(ring.size())];
  };
  std::vector<Ends> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const Point start = end();
    queries.push_back({start, end()});
  }
  return queries;
}

}  // namespace

std::string_view to_string(Obstacles obstacles) {
  switch (obstacles) {
    case Obstacles::boxes:
      return "boxes";
    case Obstacles::walls:
      return "walls";
    case Obstacles::polylines:
      return "polylines";
    case Obstacles::tiles:
      return "tiles";
    case Obstacles::mixture:
      return "mixture";
    case Obstacles::rounds:
      return "rounds";
  }
  return {};
}

std::optional<Obstacles> obstacles_of(std::string_view name) {
  const auto* const found = std::find_if(kObstacles.begin(), kObstacles.end(),
                                         [&](Obstacles obstacles) { return to_string(obstacles) == name; });
  if (found == kObstacles.end()) return std::nullopt;
  return *found;
}

PathCase random_path_case(Obstacles obstacles, std::uint64_t seed, std::size_t query_count) {
  constexpr std::uint64_t kKinds = 5;  // before there were round polygons: the scenes of the other kinds stay the same
  Random random(seed * kKinds + static_cast<std::uint64_t>(obstacles));
  PathCase result{PathSceneMaker(obstacles, random).make(), {}};
  const auto size = static_cast<std::int64_t>(result.scene.domain.max.x);
  // Sometimes multiples of a half: in the middle of tiles, and not on lattice points.
  const auto coordinate = [&] { return static_cast<double>(random.between(0, 2 * size)) / 2.0; };
  result.queries = random_queries(result.scene, query_count, random, [&] {
    const double x = coordinate();
    return Point{x, coordinate()};
  });
  give_fill_rules(result.scene, seed);
  return result;
}

PathCase random_path_case(Flavour flavour, std::uint64_t seed, std::size_t item_count, std::size_t query_count) {
  Random random(seed);
  PathCase result{random_scene(flavour, seed, item_count), {}};
  result.queries = random_queries(result.scene, query_count, random,
                                  [&] { return random_point(flavour, result.scene.domain, random); });
  return result;
}

}  // namespace waywright::test
