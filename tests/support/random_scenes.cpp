#include "support/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "waywright/id.hpp"
#include "waywright/item.hpp"

namespace waywright::test {
namespace {

constexpr double kLargest = 0x1p100;
constexpr double kSmallest = 0x1p-100;

/// The coordinates of a flavour on a grid: whole multiples of `unit` from `low` to `high`.
struct GridRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
  double unit = 1.0;
};

GridRange grid_range(Flavour flavour) {
  switch (flavour) {
    case Flavour::lattice:
      return {0, 8, 1.0};
    case Flavour::small:
      return {-8000, 8000, 1.0};
    case Flavour::large:
      return {-(std::int64_t{1} << 40), std::int64_t{1} << 40, 1.0};
    case Flavour::mantissas:
      return {-(std::int64_t{1} << 53), std::int64_t{1} << 53, 0x1p-53};
    case Flavour::mixed:
      break;
  }
  return {};
}

/// Returns the nearest coordinate that a world accepts.
double nearest_in_range(double value) {
  if (std::fabs(value) < kSmallest) return 0.0;
  return std::clamp(value, -kLargest, kLargest);
}

class SceneMaker {
 public:
  SceneMaker(Flavour flavour, std::uint64_t seed)
      : flavour_(flavour), random_(seed * kFlavours.size() + static_cast<std::uint64_t>(flavour)) {
    if (flavour == Flavour::mixed) {
      // Some scenes have one size, so that near-misses are frequent; some have many sizes.
      spread_ = std::array<std::int64_t, 4>{0, 3, 30, 99}[random_.below(4)];
      middle_ = random_.between(-99 + spread_, 99 - spread_);
      const double size = std::ldexp(1.0, static_cast<int>(middle_ + spread_) + 1);
      limits_ = {{-size, -size}, {size, size}};
    } else {
      const GridRange range = grid_range(flavour);
      const double low = static_cast<double>(range.low) * range.unit;
      const double high = static_cast<double>(range.high) * range.unit;
      limits_ = {{low, low}, {high, high}};
    }
  }

  Scene make(std::size_t item_count) {
    const bool sparse_ids = random_.chance(20);
    std::set<std::uint64_t> used;
    for (std::size_t i = 0; i < item_count; ++i) {
      std::uint64_t id = i + 1;
      if (sparse_ids) {
        do {
          id = random_.chance(5) ? ItemId::kLargest : (random_.next() >> random_.between(1, 60)) + 1;
        } while (id > ItemId::kLargest || used.contains(id));
      }
      used.insert(id);
      add({id}, shape());
    }
    scene_.domain = domain();
    return std::move(scene_);
  }

  double coordinate() {
    if (flavour_ != Flavour::mixed) {
      const GridRange range = grid_range(flavour_);
      if (flavour_ == Flavour::mantissas && random_.chance(15)) return fine_coordinate(random_.between(-30, 0));
      return static_cast<double>(random_.between(range.low, range.high)) * range.unit;
    }
    if (random_.chance(4)) return 0.0;
    return nearest_in_range(fine_coordinate(random_.between(middle_ - spread_, middle_ + spread_)));
  }

 private:
  using Ring = std::vector<Point>;

  /// Returns 53 random bits below 2^exponent, with a random sign.
  double fine_coordinate(std::int64_t exponent) {
    const auto bits = static_cast<double>((random_.next() >> 11) | 1);
    const double size = std::ldexp(bits, static_cast<int>(exponent) - 53);
    return random_.chance(50) ? size : -size;
  }

  Point inside(Point p) const {
    return {nearest_in_range(std::clamp(p.x, limits_.min.x, limits_.max.x)),
            nearest_in_range(std::clamp(p.y, limits_.min.y, limits_.max.y))};
  }

  Point fresh_point() {
    if (!corners_.empty() && random_.chance(20)) return corners_[random_.below(corners_.size())];
    Point p{coordinate(), coordinate()};
    if (random_.chance(4)) (random_.chance(50) ? p.x : p.y) = random_.chance(50) ? limits_.min.x : limits_.max.x;
    return p;
  }

  double step(double from, int shift) {
    if (flavour_ == Flavour::mixed) {
      const double size = std::ldexp(limits_.max.x, -shift);
      return from + size * std::ldexp(static_cast<double>(random_.between(-1024, 1024)), -10);
    }
    const GridRange range = grid_range(flavour_);
    const std::int64_t reach = std::max<std::int64_t>((range.high - range.low) >> shift, 1);
    return from + static_cast<double>(random_.between(-reach, reach)) * range.unit;
  }

  /// Returns a point that is usually near `from`, otherwise the scene would consist mostly of crossings. A fifth of the
  /// steps go along an axis.
  Point next_point(Point from) {
    if (random_.chance(6)) return fresh_point();
    const int shift = random_.chance(20) ? 1 : static_cast<int>(random_.between(2, 5));
    Point p = inside({step(from.x, shift), step(from.y, shift)});
    if (random_.chance(10)) p.x = from.x;
    if (random_.chance(10)) p.y = from.y;
    return p;
  }

  Ring random_chain(std::size_t count) {
    Ring ring{fresh_point()};
    while (ring.size() < count) {
      ring.push_back(random_.chance(5) ? ring[random_.below(ring.size())] : next_point(ring.back()));
    }
    return ring;
  }

  Ring rectangle() {
    const Point a = fresh_point();
    const Point b = next_point(a);
    Ring ring{a, {b.x, a.y}, b, {a.x, b.y}};
    if (random_.chance(30)) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  Shape shape() {
    const std::size_t dice = random_.below(100);
    if (dice < 12) return {ItemKind::point, {{fresh_point()}}};
    if (dice < 32) return {ItemKind::segment, {random_chain(2)}};
    if (dice < 42) return {ItemKind::polyline, {random_chain(1 + random_.below(6))}};
    if (dice < 60) return polygon();
    if (dice < 64) return degenerate();
    if (dice < 69) return on_boundary();
    if (dice < 74) return through_hub();
    if (sides_.empty()) return {ItemKind::segment, {random_chain(2)}};
    if (dice < 80) return duplicate();
    if (dice < 88) return overlap();
    if (dice < 95) return touching();
    return near_miss();
  }

  Shape polygon() {
    Shape result{ItemKind::polygon, {random_.chance(30) ? rectangle() : random_chain(3 + random_.below(5))}};
    while (random_.chance(25)) {
      if (random_.chance(50)) {
        result.rings.push_back(random_.chance(50) ? rectangle() : random_chain(3 + random_.below(3)));
      } else {
        result.rings.push_back(shrunk(result.rings.front()));
      }
    }
    return result;
  }

  /// Returns the ring, scaled towards one of its corners as exactly as coordinates allow: a hole that touches the ring
  /// there, up to rounding.
  Ring shrunk(Ring ring) {
    const Point centre = ring[random_.below(ring.size())];
    const double unit = grid_range(flavour_).unit;
    const auto half = [&](double value, double middle) {
      const double offset = (value - middle) / 2.0;
      return flavour_ == Flavour::mixed ? middle + offset : middle + std::trunc(offset / unit) * unit;
    };
    for (Point& p : ring) p = inside({half(p.x, centre.x), half(p.y, centre.y)});
    return ring;
  }

  Shape degenerate() {
    const Point p = fresh_point();
    switch (random_.below(6)) {
      case 0:
        return {ItemKind::segment, {{p, p}}};
      case 1:
        return {ItemKind::polyline, {{p, p, p}}};
      case 2:
        return {ItemKind::polygon, {{p}}};
      case 3:
        return {ItemKind::polygon, {{p, next_point(p)}, {p, p}}};
      case 4: {
        const Point q = next_point(p);
        return {ItemKind::polyline, {{p, q, q, p, next_point(p), q}}};
      }
      default: {
        Ring ring = random_chain(3);
        ring.insert(ring.end(), ring.begin(), ring.end());  // twice around: no inside
        return {ItemKind::polygon, {ring}};
      }
    }
  }

  Shape on_boundary() {
    const auto at_side = [&](Point p, std::size_t side) {
      if (side == 0) p.x = limits_.min.x;
      if (side == 1) p.x = limits_.max.x;
      if (side == 2) p.y = limits_.min.y;
      if (side == 3) p.y = limits_.max.y;
      return p;
    };
    const std::size_t side = random_.below(4);
    const Point a = at_side(fresh_point(), side);
    const Point b = at_side(next_point(a), side);
    if (random_.chance(50)) return {ItemKind::segment, {{a, b}}};
    return {ItemKind::polygon, {{a, b, next_point(b)}}};
  }

  /// Returns a segment through a shared point.
  Shape through_hub() {
    if (hubs_.empty() || random_.chance(30)) hubs_.push_back(fresh_point());
    const Point hub = hubs_[random_.below(hubs_.size())];
    const Point a = next_point(hub);
    return {ItemKind::segment, {{a, inside({hub.x + (hub.x - a.x), hub.y + (hub.y - a.y)})}}};
  }

  Shape duplicate() {
    Shape copy = scene_.items[random_.below(scene_.items.size())].shape;
    if (random_.chance(40)) std::reverse(copy.rings.front().begin(), copy.rings.front().end());
    if (copy.kind == ItemKind::polygon && random_.chance(30)) return {ItemKind::polyline, {copy.rings.front()}};
    return copy;
  }

  /// Returns a point on a side. It is exact if the side has grid points between its ends or an exact midpoint.
  Point point_on(const std::pair<Point, Point>& side) {
    const auto& [a, b] = side;
    const double unit = grid_range(flavour_).unit;
    const double dx = (b.x - a.x) / unit;
    const double dy = (b.y - a.y) / unit;
    const bool on_grid = flavour_ != Flavour::mixed && std::trunc(dx) == dx && std::trunc(dy) == dy;
    if (!on_grid) return inside({a.x + (b.x - a.x) / 2.0, a.y + (b.y - a.y) / 2.0});
    const std::int64_t steps = std::gcd(static_cast<std::int64_t>(dx), static_cast<std::int64_t>(dy));
    if (steps < 2) return inside({a.x + std::trunc(dx / 2.0) * unit, a.y + std::trunc(dy / 2.0) * unit});
    const auto at = static_cast<double>(random_.between(1, std::min<std::int64_t>(steps - 1, 8)));
    const auto whole = static_cast<double>(steps);
    return inside({a.x + dx / whole * at * unit, a.y + dy / whole * at * unit});
  }

  const std::pair<Point, Point>& earlier_side() { return sides_[random_.below(sides_.size())]; }

  Shape overlap() {
    const auto side = earlier_side();
    const auto& [a, b] = side;
    if (random_.chance(25)) {  // a line through the origin that contains all powers of two
      const Point far = inside({a.x * 4.0, a.y * 4.0});
      if (random_.chance(50)) return {ItemKind::polyline, {{{a.x, a.y}, far}}};
      return {ItemKind::polyline, {{inside({0.0, 0.0}), inside({a.x * 2.0, a.y * 2.0})}}};
    }
    const Point beyond = inside({b.x + (b.x - a.x), b.y + (b.y - a.y)});
    switch (random_.below(4)) {
      case 0:
        return {ItemKind::segment, {{a, point_on(side)}}};
      case 1:
        return {ItemKind::segment, {{point_on(side), beyond}}};
      case 2:
        return {ItemKind::polygon, {{a, beyond, next_point(b)}}};
      default:
        return {ItemKind::segment, {{point_on(side), point_on(side)}}};
    }
  }

  Shape touching() {
    const Point on = point_on(earlier_side());
    if (random_.chance(20)) return {ItemKind::point, {{on}}};
    if (random_.chance(40)) return {ItemKind::polygon, {{on, next_point(on), next_point(on)}}};
    return {ItemKind::segment, {{on, next_point(on)}}};
  }

  /// Returns `value` moved by the smallest possible step, or by about 2^-50 of its size.
  double nudged(double value) {
    if (flavour_ == Flavour::mixed) {
      const double offset = std::ldexp(static_cast<double>(random_.between(-4, 4)), -52) * std::fabs(value);
      return value + offset;
    }
    return value + static_cast<double>(random_.between(-1, 1)) * grid_range(flavour_).unit;
  }

  Point nudged(Point p) { return inside({nudged(p.x), nudged(p.y)}); }

  Shape near_miss() {
    const auto side = earlier_side();
    switch (random_.below(4)) {
      case 0:
        return {ItemKind::segment, {{nudged(side.first), nudged(side.second)}}};
      case 1:
        return {ItemKind::point, {{nudged(side.first)}}};
      case 2:
        return {ItemKind::polyline, {{nudged(point_on(side)), next_point(side.first)}}};
      default:
        return {ItemKind::polyline, {{side.first, nudged(point_on(side)), side.second}}};
    }
  }

  void add(ItemId id, Shape shape) {
    for (MutablePointSpan& ring : shape.rings) {
      for (Point& p : ring) p = inside(p);
      corners_.insert(corners_.end(), ring.begin(), ring.end());
      for (std::size_t i = 1; i < ring.size(); ++i) sides_.emplace_back(ring[i - 1], ring[i]);
    }
    scene_.items.push_back({id, std::move(shape)});
  }

  /// Returns the domain. In some scenes it is tight, so that the outermost points lie on its boundary; in others it is
  /// wider than all items.
  Box domain() {
    const std::size_t dice = random_.below(10);
    Box tight{limits_.max, limits_.min};
    for (const Point& p : corners_) {
      tight.min = {std::min(tight.min.x, p.x), std::min(tight.min.y, p.y)};
      tight.max = {std::max(tight.max.x, p.x), std::max(tight.max.y, p.y)};
    }
    if (dice < 3 && tight.min.x < tight.max.x && tight.min.y < tight.max.y) return tight;
    if (dice < 6 && limits_.max.x < kLargest / 4.0) {
      const double more = (limits_.max.x - limits_.min.x) / 4.0;
      return {{limits_.min.x - more, limits_.min.y - 2.0 * more}, {limits_.max.x + 3.0 * more, limits_.max.y + more}};
    }
    return limits_;
  }

  Flavour flavour_;
  Random random_;
  std::int64_t spread_ = 0;
  std::int64_t middle_ = 0;
  Box limits_;
  Scene scene_;
  std::vector<Point> corners_;
  std::vector<Point> hubs_;
  std::vector<std::pair<Point, Point>> sides_;
};

}  // namespace

std::string_view to_string(Flavour flavour) {
  switch (flavour) {
    case Flavour::lattice:
      return "lattice";
    case Flavour::small:
      return "small";
    case Flavour::large:
      return "large";
    case Flavour::mantissas:
      return "mantissas";
    case Flavour::mixed:
      return "mixed";
  }
  return {};
}

std::optional<Flavour> flavour_of(std::string_view name) {
  const auto found =
      std::find_if(kFlavours.begin(), kFlavours.end(), [&](Flavour flavour) { return to_string(flavour) == name; });
  return found == kFlavours.end() ? std::nullopt : std::optional(*found);
}

Scene random_scene(Flavour flavour, std::uint64_t seed, std::size_t item_count) {
  Scene scene = SceneMaker(flavour, seed).make(item_count);
  give_fill_rules(scene, seed);
  return scene;
}

// Uses its own random numbers, so that the points of a scene do not depend on the fill rules.
void give_fill_rules(Scene& scene, std::uint64_t seed) {
  Random random(seed ^ 0x66696c6c2072756cU);
  const std::vector<Item> items = scene.items;
  for (Item& item : scene.items) {
    if (item.shape.kind != ItemKind::polygon || random.chance(50)) continue;
    item.shape.fill = FillRule::nonzero;
    if (random.chance(30)) continue;
    const Shape& other = items[random.below(items.size())].shape;
    const bool takes_other = other.kind == ItemKind::polygon && random.chance(40);
    const Shape& source = takes_other ? other : item.shape;
    std::vector<Point> ring = source.rings[random.below(source.rings.size())];
    const std::size_t dice = random.below(4);
    if (dice == 0) std::reverse(ring.begin(), ring.end());
    if (dice == 1) ring.insert(ring.end(), ring.begin(), ring.end());
    for (std::size_t i = ring.size(); dice == 2 && i > 1; --i) std::swap(ring[i - 1], ring[random.below(i)]);
    item.shape.rings.push_back(ring);
  }
}

Point random_point(Flavour flavour, const Box& domain, Random& random) {
  SceneMaker maker(flavour, random.next());
  // Uses the flavour's own coordinate if it is inside, else any coordinate in the range.
  const auto within = [&](double low, double high) {
    const double own = maker.coordinate();
    if (own >= low && own <= high && !random.chance(20)) return own;
    const double share = std::ldexp(static_cast<double>(random.next() >> 11), -53);
    return std::clamp(nearest_in_range(low + (high - low) * share), low, high);
  };
  return {within(domain.min.x, domain.max.x), within(domain.min.y, domain.max.y)};
}

}  // namespace waywright::test
