#include "workloads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "random.hpp"

namespace waywright::bench {
namespace {

constexpr Box kThesisDomain = {{-10000.0, -10000.0}, {10000.0, 10000.0}};
constexpr std::int64_t kThesisReach = 8000;
constexpr std::uint64_t kPointSeed = 53;
constexpr std::uint64_t kTargetSeed = 54;
constexpr std::int64_t kLargeWidth = std::int64_t{1} << 20;

Item make_item(std::size_t id, ItemKind kind, std::vector<Point> ring) {
  Item item;
  item.id = ItemId{id};
  item.shape.kind = kind;
  item.shape.rings.push_back(std::move(ring));
  return item;
}

void insert_all(Workload& workload, const std::vector<Point>& points) {
  workload.updates.reserve(points.size());
  for (const Point& point : points) {
    workload.updates.push_back({{}, make_item(workload.updates.size() + 1, ItemKind::point, {point})});
  }
}

void shuffle(std::vector<std::size_t>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
}

/// Returns the rank of a grid point along the Hilbert curve of order 16.
/// Source: Hilbert, *Über die stetige Abbildung einer Linie auf ein Flächenstück*, 1891. Computed by quadrant; each
/// step rotates the rest.
std::uint64_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint64_t index = 0;
  for (std::uint32_t bit = 1U << 15; bit > 0; bit >>= 1) {
    const bool right = (x & bit) != 0;
    const bool upper = (y & bit) != 0;
    index = index * 4 + (right ? (upper ? 2U : 3U) : (upper ? 1U : 0U));
    if (upper) continue;
    if (right) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return index;
}

void sort_along_hilbert_curve(std::vector<Point>& points, const Box& box) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(points.size());
  const auto to_grid = [](double value, double low, double high) {
    return static_cast<std::uint32_t>((value - low) / (high - low) * 65535.0);
  };
  for (const Point& p : points) {
    const std::uint32_t x = to_grid(p.x, box.min.x, box.max.x);
    const std::uint32_t y = to_grid(p.y, box.min.y, box.max.y);
    order.emplace_back(hilbert_index(x, y), order.size());
  }
  std::sort(order.begin(), order.end());
  std::vector<Point> sorted;
  sorted.reserve(points.size());
  for (const auto& [index, position] : order) sorted.push_back(points[position]);
  points = std::move(sorted);
}

std::vector<Point> unit_square_points(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Point> points(count);
  for (Point& point : points) point = {random.unit(), random.unit()};
  return points;
}

std::vector<Point> square_ring(Point centre, double reach) {
  return {{centre.x - reach, centre.y - reach},
          {centre.x + reach, centre.y - reach},
          {centre.x + reach, centre.y + reach},
          {centre.x - reach, centre.y + reach}};
}

Box bounding_box(const Item& item) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box = {{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const PointSpan& ring : item.shape.rings) {
    for (const Point& p : ring) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
  }
  return box;
}

bool touch(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

bool touches_any(const Box& box, const std::vector<Box>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Box& other) { return touch(box, other); });
}

/// Returns a polygon around a random centre. It has a corner in each quadrant, so it is simple and contains its centre.
Item rts_polygon(Random& random, std::size_t id, std::int64_t largest_reach) {
  constexpr std::array<Point, 4> kQuadrants = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  const Point centre = {random.between(largest_reach, kLargeWidth - largest_reach),
                        random.between(largest_reach, kLargeWidth - largest_reach)};
  const std::int64_t spread = largest_reach * 3 / 4;
  const std::int64_t reach =
      largest_reach - spread + static_cast<std::int64_t>(random.below(static_cast<std::size_t>(spread)));
  std::array<std::vector<Point>, 4> offsets;
  const std::size_t corner_count = 4 + random.below(5);
  for (std::size_t i = 0; i < corner_count; ++i) {
    const std::size_t quadrant = i < 4 ? i : random.below(4);
    const Point size = {random.between(1, reach), random.between(1, reach)};
    offsets[quadrant].push_back({kQuadrants[quadrant].x * size.x, kQuadrants[quadrant].y * size.y});
  }
  std::vector<Point> ring;
  for (std::vector<Point>& quadrant : offsets) {
    // The coordinates are whole numbers below 2^13, so the products and the order by angle are exact.
    std::sort(quadrant.begin(), quadrant.end(), [](Point a, Point b) {
      const double turn = a.x * b.y - a.y * b.x;
      return turn > 0 || (turn == 0 && std::abs(a.x) < std::abs(b.x));
    });
    for (const Point& offset : quadrant) ring.push_back({centre.x + offset.x, centre.y + offset.y});
  }
  return make_item(id, ItemKind::polygon, std::move(ring));
}

}  // namespace

Workload thesis_points(std::size_t count) {
  Random random(3);
  std::vector<Point> points(count);
  for (Point& point : points) {
    point.x = random.between(-kThesisReach, kThesisReach);
    point.y = random.between(-kThesisReach, kThesisReach);
  }
  Workload workload{kThesisDomain, {}, {}};
  insert_all(workload, points);
  return workload;
}

Workload uniform_points(std::size_t count) {
  Workload workload{{{0.0, 0.0}, {1.0, 1.0}}, {}, {}};
  insert_all(workload, unit_square_points(kPointSeed, count));
  return workload;
}

Workload sorted_points(std::size_t count) {
  Workload workload{{{0.0, 0.0}, {1.0, 1.0}}, {}, {}};
  std::vector<Point> points = unit_square_points(kPointSeed, count);
  sort_along_hilbert_curve(points, workload.domain);
  insert_all(workload, points);
  return workload;
}

Workload lattice_points(std::size_t row_length) {
  const double end = static_cast<double>(row_length);
  Workload workload{{{0.0, 0.0}, {end + 1.0, end + 1.0}}, {}, {}};
  std::vector<Point> points;
  points.reserve(row_length * row_length);
  for (std::size_t row = 1; row <= row_length; ++row) {
    for (std::size_t i = 1; i <= row_length; ++i) {
      const std::size_t column = row % 2 == 0 ? row_length + 1 - i : i;
      points.push_back({static_cast<double>(column), static_cast<double>(row)});
    }
  }
  insert_all(workload, points);
  return workload;
}

Workload point_removal(std::size_t count) {
  Random random(200);
  const double width = static_cast<double>(kLargeWidth);
  Workload workload{{{0.0, 0.0}, {width, width}}, {}, {}};
  // The points are distinct, so that the removal of an item also removes its vertex.
  std::set<std::pair<double, double>> taken;
  while (taken.size() < count) taken.emplace(random.between(1, kLargeWidth - 1), random.between(1, kLargeWidth - 1));
  std::vector<Point> points;
  points.reserve(count);
  for (const auto& [x, y] : taken) points.push_back({x, y});
  sort_along_hilbert_curve(points, workload.domain);
  std::vector<std::size_t> ids;
  for (const Point& point : points) {
    ids.push_back(ids.size() + 1);
    workload.before.push_back(make_item(ids.back(), ItemKind::point, {point}));
  }
  shuffle(ids, random);
  ids.resize(count / 2);
  for (const std::size_t id : ids) workload.updates.push_back({ItemId{id}, {}});
  return workload;
}

Workload short_segments(std::size_t count) {
  constexpr std::int64_t kLength = 200;
  Random random(51);
  Workload workload{kThesisDomain, {}, {}};
  for (std::size_t id = 1; id <= count; ++id) {
    const bool is_level = random.below(2) == 0;
    const double along = random.between(-kThesisReach, kThesisReach - kLength);
    const double across = random.between(-kThesisReach, kThesisReach);
    const Point a = is_level ? Point{along, across} : Point{across, along};
    const Point b = is_level ? Point{along + kLength, across} : Point{across, along + kLength};
    workload.updates.push_back({{}, make_item(id, ItemKind::segment, {a, b})});
  }
  return workload;
}

Workload long_segments(std::size_t count) {
  constexpr double kEnd = kThesisReach;
  Random random(52);
  Workload workload{kThesisDomain, {}, {}};
  for (std::size_t id = 1; id <= count; ++id) {
    const bool is_level = random.below(2) == 0;
    const double across = random.between(-kThesisReach, kThesisReach);
    const Point a = is_level ? Point{-kEnd, across} : Point{across, -kEnd};
    const Point b = is_level ? Point{kEnd, across} : Point{across, kEnd};
    workload.updates.push_back({{}, make_item(id, ItemKind::segment, {a, b})});
  }
  return workload;
}

Workload random_segments(std::size_t count) {
  Random random(53);
  Workload workload{kThesisDomain, {}, {}};
  for (std::size_t id = 1; id <= count; ++id) {
    const Point a = {random.between(-kThesisReach, kThesisReach), random.between(-kThesisReach, kThesisReach)};
    const Point b = {random.between(-kThesisReach, kThesisReach), random.between(-kThesisReach, kThesisReach)};
    workload.updates.push_back({{}, make_item(id, ItemKind::segment, {a, b})});
  }
  return workload;
}

Workload moving_square(Rotation rotation, std::size_t steps) {
  constexpr std::size_t kNestedCount = 9;
  constexpr double kSpacing = 10000.0;
  constexpr double kReach = 500.0;
  Workload workload{{{-100000.0, -100000.0}, {100000.0, 100000.0}}, {}, {}};
  for (std::size_t i = 1; i <= kNestedCount; ++i) {
    const double reach = kSpacing * static_cast<double>(i);
    workload.before.push_back(make_item(i, ItemKind::polygon, square_ring({0.0, 0.0}, reach)));
  }
  // From the centre to the first corner. The others follow by right angles.
  Point arm = {kReach, kReach};
  if (rotation == Rotation::by_45) arm = {0.0, 1.4 * kReach};
  if (rotation == Rotation::by_30) arm = {kReach * 0.5 * (std::sqrt(3.0) - 1.0), kReach * 0.5 * (std::sqrt(3.0) + 1.0)};
  const std::size_t id = kNestedCount + 1;
  const auto square_at = [&](std::size_t step) {
    const double at = 5000.0 + 10.0 * static_cast<double>(step);
    return make_item(
        id, ItemKind::polygon,
        {{at + arm.x, at + arm.y}, {at - arm.y, at + arm.x}, {at - arm.x, at - arm.y}, {at + arm.y, at - arm.x}});
  };
  workload.before.push_back(square_at(0));
  for (std::size_t step = 1; step <= steps; ++step) workload.updates.push_back({ItemId{id}, square_at(step)});
  return workload;
}

Workload rts(Crowd crowd, std::size_t steps) {
  constexpr std::size_t kCount = 2000;
  const bool is_disjoint = crowd == Crowd::disjoint;
  const std::int64_t reach = crowd == Crowd::sparse ? 2000 : 8000;
  Random random(is_disjoint ? 62 : 61);
  const double width = static_cast<double>(kLargeWidth);
  Workload workload{{{0.0, 0.0}, {width, width}}, {}, {}};
  std::vector<Box> boxes;
  std::vector<std::size_t> ids;
  std::size_t next_id = 1;
  const auto next_polygon = [&] {
    Item item = rts_polygon(random, next_id, reach);
    while (is_disjoint && touches_any(bounding_box(item), boxes)) item = rts_polygon(random, next_id, reach);
    ++next_id;
    boxes.push_back(bounding_box(item));
    ids.push_back(item.id.value);
    return item;
  };
  while (ids.size() < kCount) workload.before.push_back(next_polygon());
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t removed_index = random.below(kCount);
    const ItemId removed{ids[removed_index]};
    std::swap(boxes[removed_index], boxes.back());
    std::swap(ids[removed_index], ids.back());
    boxes.pop_back();
    ids.pop_back();
    workload.updates.push_back({removed, next_polygon()});
  }
  return workload;
}

Workload long_wall(std::size_t count) {
  constexpr std::int64_t kDepth = 128;
  constexpr std::int64_t kSpacing = 16;
  Random random(71);
  const std::int64_t length = static_cast<std::int64_t>(count) * kSpacing;
  const double end = static_cast<double>(length);
  Workload workload{{{-1.0, -2.0 * kDepth}, {end + 1.0, 2.0 * kDepth}}, {}, {}};
  for (std::size_t i = 1; i <= count; ++i) {
    const double depth = random.between(1, kDepth);
    const Point point = {random.between(1, length - 1), i % 2 == 0 ? depth : -depth};
    workload.before.push_back(make_item(i, ItemKind::point, {point}));
  }
  workload.updates.push_back({{}, make_item(count + 1, ItemKind::segment, {{0.0, 0.0}, {end, 0.0}})});
  return workload;
}

Workload random_squares(std::size_t count) {
  constexpr std::int64_t kWidth = std::int64_t{1} << 14;
  constexpr std::int64_t kLargestReach = 80;
  Random random(7);
  Workload workload{{{0.0, 0.0}, {static_cast<double>(kWidth), static_cast<double>(kWidth)}}, {}, {}};
  std::vector<Box> boxes;
  while (boxes.size() < count) {
    const double reach = random.between(kLargestReach / 4, kLargestReach);
    const Point centre = {random.between(2 * kLargestReach, kWidth - 2 * kLargestReach),
                          random.between(2 * kLargestReach, kWidth - 2 * kLargestReach)};
    Item item = make_item(boxes.size() + 1, ItemKind::polygon, square_ring(centre, reach));
    const Box box = bounding_box(item);
    if (touches_any(box, boxes)) continue;
    boxes.push_back(box);
    workload.before.push_back(std::move(item));
  }
  return workload;
}

PointsToLocate random_points_to_locate(std::size_t count) {
  return {unit_square_points(kPointSeed, count), unit_square_points(kTargetSeed, count)};
}

PointsToLocate sorted_points_to_locate(std::size_t count) {
  PointsToLocate workload = random_points_to_locate(count);
  sort_along_hilbert_curve(workload.targets, {{0.0, 0.0}, {1.0, 1.0}});
  return workload;
}

PointsToLocate uneven_points_to_locate(std::size_t count) {
  PointsToLocate workload = random_points_to_locate(count);
  for (std::vector<Point>* const points : {&workload.points, &workload.targets}) {
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (i % 10 != 0) (*points)[i] = {0.4 + (*points)[i].x / 10.0, 0.7 + (*points)[i].y / 10.0};
    }
  }
  return workload;
}

Workload disjoint_segments(std::size_t count) {
  Random random(61);
  std::size_t row_length = 1;
  while (row_length * row_length < count) ++row_length;
  std::vector<std::size_t> squares(row_length * row_length);
  std::iota(squares.begin(), squares.end(), std::size_t{0});
  for (std::size_t i = squares.size(); i > 1; --i) std::swap(squares[i - 1], squares[random.below(i)]);
  const auto extent = static_cast<double>(row_length);
  Workload workload{{{0.0, 0.0}, {extent, extent}}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<double>(squares[i] % row_length);
    const auto row = static_cast<double>(squares[i] / row_length);
    const auto within = [&](double first) { return first + 0.02 + 0.96 * random.unit(); };
    const Point from{within(column), within(row)};
    const Point to{within(column), within(row)};
    workload.updates.push_back({{}, make_item(i + 1, ItemKind::segment, {from, to})});
  }
  return workload;
}

std::vector<Point> free_points(const Workload& workload, std::size_t count) {
  Random random(8);
  std::vector<Box> boxes;
  for (const Item& item : workload.before) boxes.push_back(bounding_box(item));
  const Box& domain = workload.domain;
  std::vector<Point> points;
  while (points.size() < count) {
    const Point point = {
        random.between(static_cast<std::int64_t>(domain.min.x), static_cast<std::int64_t>(domain.max.x)),
        random.between(static_cast<std::int64_t>(domain.min.y), static_cast<std::int64_t>(domain.max.y))};
    if (!touches_any({point, point}, boxes)) points.push_back(point);
  }
  return points;
}

}  // namespace waywright::bench
