#include "growth/inputs.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "waywright/query_context.hpp"

#include "growth/shapes.hpp"

namespace waywright::bench {

namespace {

constexpr std::size_t kRepetitions = 20;  ///< of the operation of an input with one operation

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Nested polygons: items in items.

World world_of_nested_polygons(std::size_t n) {
  World world = World::create(kGrowthDomain).value();
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = 900.0 * static_cast<double>(n - i) / static_cast<double>(n);
    static_cast<void>(world.insert(Shape::regular_polygon({0, 0}, radius, 100), ItemId{i + 1}).value());
  }
  return world;
}

void nested_polygons_outermost_first(std::size_t n, Meter& meter) {
  World world = world_of_nested_polygons(n);
  measure_removal(world, ids_up_to(n), meter);
}

void nested_polygons_in_random_order(std::size_t n, Meter& meter) {
  World world = world_of_nested_polygons(n);
  std::vector<ItemId> ids = ids_up_to(n);
  shuffle(ids);
  measure_removal(world, ids, meter);
}

std::vector<Shape> nested_squares(std::size_t n) {
  std::vector<Shape> squares;
  for (std::size_t i = 0; i < n; ++i) squares.push_back(square({0, 0}, 900.0 * static_cast<double>(n - i) / double(n)));
  return squares;
}

void squares_outermost_first(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, nested_squares(n), meter);
}

void squares_innermost_first(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Shape> squares = nested_squares(n);
  std::reverse(squares.begin(), squares.end());
  measure_insertion(world, squares, meter);
}

void squares_in_random_order(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Shape> squares = nested_squares(n);
  shuffle(squares);
  measure_insertion(world, squares, meter);
}

void squares_at_once(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Item> items;
  for (const Shape& shape : nested_squares(n)) items.push_back({ItemId{items.size() + 1}, shape});
  meter.start();
  static_cast<void>(world.insert_all(items).value());
  meter.stop();
}

// Long items beside each other.

void round_wall(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, {Shape::polygon({circle(900, n / 2), circle(800, n / 2)})}, meter);
}

void round_wall_of_two(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, {Shape::polygon(circle(900, n / 2)), Shape::polygon(circle(800, n / 2))}, meter);
}

void round_wall_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  const std::vector<Item> items = {{ItemId{1}, Shape::polygon(circle(900, n / 2))},
                                   {ItemId{2}, Shape::polygon(circle(800, n / 2))}};
  static_cast<void>(world.insert_all(items).value());
  measure_removal(world, {ItemId{2}, ItemId{1}}, meter);
}

std::vector<Point> row(std::size_t n, double y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i), i % 2 == 0 ? y : y + 0.25});
  return points;
}

void long_polylines(std::size_t n, Meter& meter) {
  const double length = static_cast<double>(n);
  World world = World::create({{-1, -length / 100}, {length, length / 100}}).value();
  const double y = length / 200;
  measure_insertion(world, {Shape::polyline(row(n / 2, -y)), Shape::polyline(row(n / 2, y))}, meter);
}

void long_polyline_removed(std::size_t n, Meter& meter) {
  const double length = static_cast<double>(n);
  World world = World::create({{-1, -length / 100}, {length, length / 100}}).value();
  const double y = length / 200;
  const std::vector<Item> items = {{ItemId{1}, Shape::polyline(row(n / 2, -y))},
                                   {ItemId{2}, Shape::polyline(row(n / 2, y))}};
  static_cast<void>(world.insert_all(items).value());
  measure_removal(world, {ItemId{2}}, meter);
}

// Many sides on one edge, many corners at one vertex.

std::vector<Point> forth_and_back(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({i % 2 == 0 ? -10.0 : 10.0, 0.0});
  return points;
}

void over_one_edge_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  static_cast<void>(world.insert(Shape::polyline(forth_and_back(n)), ItemId{1}).value());
  measure_removal(world, {ItemId{1}}, meter);
}

void identical_rings(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  Rings rings;
  const std::vector<Point> ring = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (std::size_t i = 0; i < n; ++i) rings.push_back(ring);
  measure_insertion(world, {Shape::polygon(std::move(rings))}, meter);
}

void identical_polygons(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, std::vector<Shape>(n, square({0, 0}, 4)), meter);
}

void identical_polygons_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  for (std::size_t i = 0; i < n; ++i) static_cast<void>(world.insert(square({0, 0}, 4), ItemId{i + 1}).value());
  measure_removal(world, ids_up_to(n), meter);
}

void at_one_position_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  static_cast<void>(world.insert_points(std::vector<Point>(n, {1, 2}), ItemId{1}).value());
  measure_removal(world, ids_up_to(n), meter);
}

// A vertex with many edges.

std::vector<Shape> fan(std::size_t n) {
  std::vector<Shape> shapes;
  for (const Point& end : circle(900, n)) shapes.push_back(Shape::segment({0, 0}, end));
  shuffle(shapes);
  return shapes;
}

void fan_inserted(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, fan(n), meter);
}

void fan_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  for (const Shape& shape : fan(n)) static_cast<void>(world.insert(shape).value());
  std::vector<ItemId> ids = ids_up_to(n);
  shuffle(ids);
  measure_removal(world, ids, meter);
}

std::vector<Shape> lines_through_one_crossing(std::size_t n) {
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i + 1);
    const double y = static_cast<double>(n - i);
    const double scale = 900.0 / static_cast<double>(2 * n);
    shapes.push_back(Shape::segment({-x * scale, -y * scale}, {x * scale, y * scale}));
  }
  shuffle(shapes);
  return shapes;
}

void one_crossing_inserted(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  measure_insertion(world, lines_through_one_crossing(n), meter);
}

void one_crossing_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  for (const Shape& shape : lines_through_one_crossing(n)) static_cast<void>(world.insert(shape).value());
  measure_removal(world, ids_up_to(n), meter);
}

void hub_removed(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Point> points = circle(900, n);
  Random random(2);
  for (Point& p : points) {
    const double factor = 1.0 + random.unit() / static_cast<double>(n) / static_cast<double>(n);
    p = {p.x * factor, p.y * factor};
  }
  static_cast<void>(world.insert_points(points).value());
  const ItemId hub = world.insert_point({0, 0}).value();
  measure_removal(world, {hub}, meter);
}

// The points of two branches of a parabola: a wall between the branches crosses an edge for each point.
void wall_between_curves(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Point> points;
  for (std::size_t i = 1; i <= n / 2; ++i) {
    const double x = 900.0 * static_cast<double>(i) / static_cast<double>(n);
    points.push_back({x, 1.0 + x * x / 1000.0});
    points.push_back({x, -1.0 - x * x / 1000.0});
  }
  static_cast<void>(world.insert_points(points).value());
  measure_insertion(world, {Shape::segment({-1, 0}, {910, 0})}, meter);
}

void path_round_a_polygon(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  static_cast<void>(world.insert(Shape::polygon(circle(500, n))).value());
  QueryContext context;
  Path path;
  meter.start();
  world.find_path({{-900, 1}, {900, 1}}, context, path).value();
  meter.stop();
}

// Segments from x = 0 to x = 1 that cross each other, with heights from -height to height.

std::vector<Shape> bundle(std::size_t n, double height) {
  Random random(6);
  const auto level = [&] { return height * (2.0 * random.unit() - 1.0); };
  std::vector<Shape> segments;
  for (std::size_t i = 0; i < n; ++i) {
    const double left = level();
    segments.push_back(Shape::segment({0, left}, {1, level()}));
  }
  return segments;
}

void bundle_inserted(std::size_t n, Meter& meter) {
  World world = World::create({{-2, -2}, {3, 3}}).value();
  measure_insertion(world, bundle(n, 1.0), meter);
}

void flat_bundle_inserted(std::size_t n, Meter& meter) {
  World world = World::create({{-1, -1}, {2, 2}}).value();
  measure_insertion(world, bundle(n, 0x1p-40), meter);
}

// Data on scales that differ much.

void small_in_large_domain(std::size_t n, Meter& meter) {
  World world = World::create({{-1e15, -1e15}, {1e15, 1e15}}).value();
  Random random(3);
  const auto point = [&] { return Point{random.unit() * 1000, random.unit() * 1000}; };
  QueryContext context;
  Location location;
  meter.start();
  for (std::size_t i = 0; i < n; ++i) {
    static_cast<void>(world.insert_point(point()).value());
    world.locate(point(), context, location).value();
  }
  meter.stop();
}

void small_in_large_domain_at_once(std::size_t n, Meter& meter) {
  World world = World::create({{-1e15, -1e15}, {1e15, 1e15}}).value();
  Random random(3);
  const auto point = [&] { return Point{random.unit() * 1000, random.unit() * 1000}; };
  std::vector<Point> points(n);
  for (Point& p : points) p = point();
  QueryContext context;
  Location location;
  meter.start();
  static_cast<void>(world.insert_points(points).value());
  for (std::size_t i = 0; i < n; ++i) world.locate(point(), context, location).value();
  meter.stop();
}

void one_at_a_time(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  Random random(5);
  meter.start();
  for (std::size_t i = 0; i < n; ++i) {
    const Change change = Change::insert(Shape::point({random.unit() * 900, random.unit() * 900}));
    static_cast<void>(world.apply({&change, 1}).value());
  }
  meter.stop();
}

void many_scales(std::size_t n, Meter& meter) {
  World world = World::create({{-0x1p99, -0x1p99}, {0x1p99, 0x1p99}}).value();
  Random random(4);
  const auto coordinate = [&] {
    const double size = std::ldexp(1.0 + random.unit(), static_cast<int>(random.below(181)) - 90);
    return random.below(2) == 0 ? size : -size;
  };
  std::vector<Shape> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = coordinate();
    points.push_back(Shape::point({x, coordinate()}));
  }
  measure_insertion(world, points, meter);
}

// One small operation in a large world.

void insert_boxes(World& world, std::size_t n) {
  const auto row_length = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  const double step = 1600.0 / static_cast<double>(row_length);
  std::vector<Item> items;
  for (std::size_t i = 0; i < row_length * row_length; ++i) {
    const double x = -800.0 + step * (static_cast<double>(i % row_length) + 0.5);
    const double y = -800.0 + step * (static_cast<double>(i / row_length) + 0.5);
    items.push_back({ItemId{i + 1}, square({x, y}, step / 4)});
  }
  static_cast<void>(world.insert_all(items).value());
}

void insert_and_remove(World& world, const Shape& shape, Meter& meter) {
  meter.start();
  for (std::size_t i = 0; i < kRepetitions; ++i) world.remove(world.insert(shape).value()).value();
  meter.stop();
}

void door(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  insert_boxes(world, n);
  const auto row_length = static_cast<double>(static_cast<std::size_t>(std::sqrt(static_cast<double>(n))));
  const double x = 1600.0 / row_length * static_cast<double>(static_cast<std::size_t>(row_length / 2)) - 800.0;
  const std::vector<Point> below = {{x, -1000}, {x, 0.01}};
  const std::vector<Point> above = {{x, 0.02}, {x, 1000}};
  static_cast<void>(world.insert(Shape::polyline(below)).value());
  static_cast<void>(world.insert(Shape::polyline(above)).value());
  insert_and_remove(world, Shape::segment({x, 0.01}, {x, 0.02}), meter);
}

void polygon_around_boxes(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  insert_boxes(world, n);
  insert_and_remove(world, square({0, 0}, 900), meter);
}

/// Each operation moves ten boxes at random positions.
void ten_moves_at_once(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  insert_boxes(world, n);
  const std::vector<Item> boxes = world.items();
  const double step = 1600.0 / std::floor(std::sqrt(static_cast<double>(n)));
  Random random(5);
  std::vector<std::vector<Change>> operations(kRepetitions);
  for (std::vector<Change>& changes : operations) {
    for (int i = 0; i < 10; ++i) {
      const Item& box = boxes[random.below(boxes.size())];
      const double shift = step / 8 * random.unit();
      changes.push_back(Change::replace(box.id, translated(box.shape, shift, shift)));
    }
  }
  meter.start();
  for (const std::vector<Change>& changes : operations) static_cast<void>(world.apply(changes).value());
  meter.stop();
}

/// Walls divide a hall with points into n + 1 rooms.
void rooms_at_once(std::size_t n, Meter& meter) {
  const double length = 3.0 * static_cast<double>(n + 1);
  World world = World::create({{0, 0}, {length, 3}}).value();
  std::vector<Point> points;
  for (double x = 1; x < length; ++x) {
    for (double y = 0; y <= 3; ++y) points.push_back({x, y});
  }
  static_cast<void>(world.insert_points(points).value());
  std::vector<Change> changes;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = i == 0 ? 1.5 : 3.0 * static_cast<double>(i) + 0.5;
    changes.push_back(Change::insert(Shape::segment({x, 0}, {x, 3})));
  }
  meter.start();
  static_cast<void>(world.apply(changes).value());
  meter.stop();
}

/// A room of n walls without a door. A disc in its middle looks for the nearest place from which it can move to a goal
/// outside the room. The disc is as small as the walls are short.
void fit_outside_a_room(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain, {.keep_bridges = true}).value();
  std::vector<Point> room = circle(100, n);
  room.push_back(room.front());
  static_cast<void>(world.insert(Shape::polyline(room)).value());
  const double radius = 1000.0 / static_cast<double>(n);
  meter.start();
  static_cast<void>(world.nearest_fit({.point = {0, 0}, .agent = {.radius = radius}, .goal = Point{500, 0}}).value());
  meter.stop();
}

/// The change blocks the last of the points. All others remain connected.
void would_disconnect_one(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({-900.0 + 1800.0 * static_cast<double>(i) / double(n), 0});
  points.push_back({950, 0});
  meter.start();
  static_cast<void>(world.would_disconnect(square({950, 0}, 10), points).value());
  meter.stop();
}

/// The points lie in a corner of the rectangle around the moving disc, but outside the disc.
void sweep_beside_points(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  Random random(7);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({-95.0 + 20.0 * random.unit(), -95.0 + 20.0 * random.unit()});
  static_cast<void>(world.insert_points(points).value());
  meter.start();
  for (std::size_t i = 0; i < kRepetitions; ++i) static_cast<void>(world.ray({0, 0}, {1, 0}, {.radius = 100}).value());
  meter.stop();
}

/// One operation inserts all squares, the largest first, between the boxes and the border of the domain.
void nested_squares_beside_boxes(std::size_t n, Meter& meter) {
  World world = World::create(kGrowthDomain).value();
  insert_boxes(world, n);
  std::vector<Change> changes;
  for (std::size_t i = 0; i < n; ++i) {
    const double half = 90.0 * static_cast<double>(n - i) / static_cast<double>(n);
    changes.push_back(Change::insert(square({900, 900}, half)));
  }
  meter.start();
  static_cast<void>(world.apply(changes).value());
  meter.stop();
}

constexpr Input kInputs[] = {
    {"nested_polygons_outermost_first", 200, false, "n nested polygons of 100 corners, removed outermost first",
     nested_polygons_outermost_first},
    {"nested_polygons_in_random_order", 200, false, "n nested polygons of 100 corners, removed in random order",
     nested_polygons_in_random_order},
    {"squares_outermost_first", 4000, false, "n nested squares, inserted outermost first", squares_outermost_first},
    {"squares_innermost_first", 4000, false, "n nested squares, inserted innermost first", squares_innermost_first},
    {"squares_in_random_order", 4000, false, "n nested squares, inserted in random order", squares_in_random_order},
    {"squares_at_once", 4000, false, "n nested squares, inserted with `insert_all`", squares_at_once},
    {"round_wall", 16000, false, "one polygon of two concentric rings, n corners, inserted", round_wall},
    {"round_wall_of_two", 16000, false, "two concentric polygons, n corners together, inserted", round_wall_of_two},
    {"round_wall_removed", 16000, false, "two concentric polygons, n corners together, removed", round_wall_removed},
    {"long_polylines", 20000, false, "two polylines beside each other in a thin domain, n corners, inserted",
     long_polylines},
    {"long_polyline_removed", 20000, false,
     "one of two polylines beside each other in a thin domain, n corners, removed", long_polyline_removed},
    {"over_one_edge_removed", 20000, false, "a polyline that goes n times over one edge, removed",
     over_one_edge_removed},
    {"identical_rings", 5000, false, "a polygon of n identical rings, inserted", identical_rings},
    {"identical_polygons", 3000, false, "n identical polygons, inserted", identical_polygons},
    {"identical_polygons_removed", 3000, false, "n identical polygons, removed", identical_polygons_removed},
    {"at_one_position_removed", 20000, false, "n points at one position, removed oldest first",
     at_one_position_removed},
    {"fan_inserted", 10000, false, "n segments that end at one vertex, inserted", fan_inserted},
    {"fan_removed", 10000, false, "n segments that end at one vertex, removed", fan_removed},
    {"one_crossing_inserted", 4000, false, "n segments through one crossing, inserted", one_crossing_inserted},
    {"one_crossing_removed", 1000, false, "n segments through one crossing, removed", one_crossing_removed},
    {"bundle_inserted", 400, false, "n segments that cross each other, inserted", bundle_inserted},
    {"flat_bundle_inserted", 400, false, "n segments that cross each other, nearly collinear, inserted",
     flat_bundle_inserted},
    {"hub_removed", 10000, false, "a vertex with n neighbours, removed", hub_removed},
    {"wall_between_curves", 10000, false, "a segment across n edges between two curves, inserted", wall_between_curves},
    {"rooms_at_once", 2000, false, "n segments across a hall, inserted by one operation", rooms_at_once},
    {"nested_squares_beside_boxes", 1000, false, "n nested squares beside n boxes, inserted by one operation",
     nested_squares_beside_boxes},
    {"fit_outside_a_room", 1000, false, "the nearest fit with a goal, from a room of n walls without a door",
     fit_outside_a_room},
    {"would_disconnect_one", 10000, false, "a question whether a building disconnects n points; it blocks one of them",
     would_disconnect_one},
    {"sweep_beside_points", 10000, true, "a disc that moves past n points, without a wall", sweep_beside_points},
    {"path_round_a_polygon", 10000, false, "the shortest path round a convex polygon of n corners",
     path_round_a_polygon},
    {"small_in_large_domain", 20000, false, "n points of a square 1,000 wide in a domain of ±1e15, each with a query",
     small_in_large_domain},
    {"small_in_large_domain_at_once", 20000, false,
     "n points of a square 1,000 wide in a domain of ±1e15, at once; n queries", small_in_large_domain_at_once},
    {"one_at_a_time", 20000, false, "n points, inserted with n calls of `apply`", one_at_a_time},
    {"many_scales", 10000, false, "n points with coordinates from 2^-90 to 2^90, inserted", many_scales},
    {"door", 10000, true, "a door between two halves with n boxes, shut and opened", door},
    {"polygon_around_boxes", 10000, true, "a polygon around n boxes, inserted and removed", polygon_around_boxes},
    {"ten_moves_at_once", 10000, true, "ten of n boxes at random positions, moved by one operation", ten_moves_at_once},
};

}  // namespace

void Meter::start() {
  if (end_ == End::at_start) std::_Exit(0);
  started_ = processor_seconds();
}

void Meter::stop() {
  if (end_ == End::at_stop) std::_Exit(0);
  seconds_ += processor_seconds() - started_;
}

std::span<const Input> growth_inputs() { return kInputs; }

}  // namespace waywright::bench
