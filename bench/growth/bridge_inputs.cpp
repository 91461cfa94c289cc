#include <cmath>
#include <cstdint>

#include "growth/inputs.hpp"
#include "growth/shapes.hpp"

// Worlds with bridges in which many corners face one long wall: every circle through the corners and an end of that
// wall is large, and the mesh has a vertex with many edges.

namespace waywright::bench {

namespace {

constexpr std::size_t kRepetitions = 20;  ///< of the operation of an input with one operation
constexpr std::size_t kBatch = 10;        ///< changes of one operation

struct Scene {
  Box domain;
  std::vector<Shape> fixed;   ///< the world contains them from the start
  std::vector<Shape> shapes;  ///< n items
};

Shape house(double x, double y) { return Shape::rectangle({{x, y}, {x + 10, y + 8}}); }

/// n houses in a row beside free space.
Scene street(std::size_t n) {
  Scene scene{{{-50, -50}, {12.0 * static_cast<double>(n) + 50, 80}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) scene.shapes.push_back(house(12.0 * static_cast<double>(i), 0));
  return scene;
}

/// The same, nearly on one line.
Scene uneven_street(std::size_t n) {
  Scene scene = street(n);
  Random random(8);
  for (Shape& shape : scene.shapes) shape = translated(shape, 0, 1e-9 * random.unit());
  return scene;
}

/// The same, with front gardens of different sizes.
Scene loose_street(std::size_t n) {
  Scene scene = street(n);
  Random random(8);
  for (Shape& shape : scene.shapes) shape = translated(shape, 0, 6 * random.unit());
  return scene;
}

/// n houses in a row beside a long slanted wall.
Scene street_beside_a_wall(std::size_t n) {
  const double length = 12.0 * static_cast<double>(n);
  Scene scene{{{-50, -50}, {length + 50, 80 + length / 10}}, {}, {}};
  scene.fixed.push_back(Shape::segment({-40, -40}, {length + 40, -40 + length / 10}));
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 12.0 * static_cast<double>(i);
    scene.shapes.push_back(house(x, x / 10));
  }
  return scene;
}

/// A grid of n boxes in a domain with a margin.
Scene grid(std::size_t n) {
  const auto row_length = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  const double width = 12.0 * static_cast<double>(row_length);
  Scene scene{{{-100, -100}, {width + 100, width + 100}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    scene.shapes.push_back(
        house(12.0 * static_cast<double>(i % row_length), 12.0 * static_cast<double>(i / row_length)));
  }
  return scene;
}

/// n parallel walls that stand on one line and end on another.
Scene comb(std::size_t n) {
  Scene scene{{{-50, 0}, {2.0 * static_cast<double>(n) + 50, 100}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 2.0 * static_cast<double>(i);
    scene.shapes.push_back(Shape::segment({x, 10}, {x, 50}));
  }
  return scene;
}

/// n pieces of contour lines: waves beside each other.
Scene contours(std::size_t n) {
  const auto row_length = static_cast<std::size_t>(8 * std::sqrt(static_cast<double>(n)));
  const double length = 4.0 * static_cast<double>(row_length);
  Scene scene{{{-100, -100}, {length + 100, 100 + 20.0 * static_cast<double>(n / row_length + 1)}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 4.0 * static_cast<double>(i % row_length);
    const double y = 20.0 * static_cast<double>(i / row_length);
    const auto wave = [&](double at) { return Point{at, y + 15 * std::sin(at / 100 + y / 40)}; };
    scene.shapes.push_back(Shape::segment(wave(x), wave(x + 4)));
  }
  return scene;
}

/// n houses that touch the border of the domain.
Scene border(std::size_t n) {
  Scene scene{{{-50, 0}, {12.0 * static_cast<double>(n) + 50, 80}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) scene.shapes.push_back(house(12.0 * static_cast<double>(i), 0));
  return scene;
}

/// A room of n walls on an ellipse.
Scene room(std::size_t n) {
  Scene scene{{{-1100, -1100}, {1100, 1100}}, {}, {}};
  const std::vector<Point> corners = circle(1000, n);
  const auto flat = [](const Point& p) { return Point{p.x, p.y / 2}; };
  for (std::size_t i = 0; i < n; ++i) {
    scene.shapes.push_back(Shape::segment(flat(corners[i]), flat(corners[(i + 1) % n])));
  }
  return scene;
}

World world_of(const Scene& scene, bool keeps_bridges = true) {
  World world = World::create(scene.domain, {.keep_bridges = keeps_bridges}).value();
  for (const Shape& shape : scene.fixed) static_cast<void>(world.insert(shape, ItemId{1'000'000'000}).value());
  return world;
}

World full_world_of(const Scene& scene, bool keeps_bridges = true) {
  World world = world_of(scene, keeps_bridges);
  std::vector<Item> items;
  for (const Shape& shape : scene.shapes) items.push_back({ItemId{items.size() + 1}, shape});
  static_cast<void>(world.insert_all(items).value());
  return world;
}

using MakeScene = Scene (*)(std::size_t);

template <MakeScene make>
void inserted(std::size_t n, Meter& meter) {
  const Scene scene = make(n);
  World world = world_of(scene);
  measure_insertion(world, scene.shapes, meter);
}

template <MakeScene make>
void shuffled(std::size_t n, Meter& meter) {
  Scene scene = make(n);
  shuffle(scene.shapes);
  World world = world_of(scene);
  measure_insertion(world, scene.shapes, meter);
}

template <MakeScene make>
void removed(std::size_t n, Meter& meter) {
  World world = full_world_of(make(n));
  std::vector<ItemId> ids = ids_up_to(n);
  shuffle(ids);
  measure_removal(world, ids, meter);
}

template <MakeScene make>
void at_once(std::size_t n, Meter& meter) {
  const Scene scene = make(n);
  World world = world_of(scene);
  std::vector<Item> items;
  for (const Shape& shape : scene.shapes) items.push_back({ItemId{items.size() + 1}, shape});
  meter.start();
  static_cast<void>(world.insert_all(items).value());
  meter.stop();
}

template <MakeScene make>
void in_batches(std::size_t n, Meter& meter) {
  Scene scene = make(n);
  shuffle(scene.shapes);
  World world = world_of(scene);
  std::vector<Change> changes;
  meter.start();
  for (const Shape& shape : scene.shapes) {
    changes.push_back(Change::insert(shape));
    if (changes.size() < kBatch) continue;
    static_cast<void>(world.apply(changes).value());
    changes.clear();
  }
  meter.stop();
}

/// Each operation moves one item a little.
template <MakeScene make, bool keeps_bridges = true>
void moved(std::size_t n, Meter& meter) {
  const Scene scene = make(n);
  World world = full_world_of(scene, keeps_bridges);
  Random random(9);
  std::vector<Item> moves;
  for (std::size_t i = 0; i < 5 * kRepetitions; ++i) {
    const std::size_t k = random.below(n);
    moves.push_back({ItemId{k + 1}, translated(scene.shapes[k], random.unit(), 0)});
  }
  meter.start();
  for (const Item& move : moves) world.replace(move.id, move.shape).value();
  meter.stop();
}

/// Each operation removes an item or inserts it again.
template <MakeScene make, bool keeps_bridges = true>
void toggled(std::size_t n, Meter& meter) {
  const Scene scene = make(n);
  World world = full_world_of(scene, keeps_bridges);
  Random random(10);
  std::vector<std::size_t> items(5 * kRepetitions);
  for (std::size_t& i : items) i = random.below(n);
  meter.start();
  for (const std::size_t i : items) {
    world.remove(ItemId{i + 1}).value();
    static_cast<void>(world.insert(scene.shapes[i], ItemId{i + 1}).value());
  }
  meter.stop();
}

/// Rewinds eight ticks, in each of which ten items moved.
template <MakeScene make>
void rewound(std::size_t n, Meter& meter) {
  const Scene scene = make(n);
  World world = full_world_of(scene);
  Random random(11);
  world.keep_history(8);
  const std::uint64_t first = world.mark();
  for (std::size_t tick = 0; tick < 8; ++tick) {
    if (tick > 0) static_cast<void>(world.mark());
    for (std::size_t i = 0; i < kBatch; ++i) {
      const std::size_t k = random.below(n);
      world.replace(ItemId{k + 1}, translated(scene.shapes[k], random.unit(), 0)).value();
    }
  }
  meter.start();
  world.rewind(first).value();
  meter.stop();
}

/// A street of n houses beside a wall of 12.5 n units.
Scene wide_street(std::size_t n) {
  Scene scene{{{-50, -50}, {12.5 * static_cast<double>(n) + 50, 80}}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) scene.shapes.push_back(house(12.5 * static_cast<double>(i), 0));
  return scene;
}

/// Inserts a house in the middle of a room, and removes it.
template <bool keeps_bridges>
void house_in_a_room(std::size_t n, Meter& meter) {
  World world = full_world_of(room(n), keeps_bridges);
  meter.start();
  for (std::size_t i = 0; i < kRepetitions; ++i) world.remove(world.insert(house(0, 0)).value()).value();
  meter.stop();
}

#define WAYWRIGHT_BRIDGE_INPUTS(scene, size, what)                                                    \
  {#scene "_inserted", size, false, what ", inserted from one end to the other", inserted<scene>},    \
      {#scene "_shuffled", size, false, what ", inserted in random order", shuffled<scene>},          \
      {#scene "_removed", size, false, what ", removed in random order", removed<scene>},             \
      {#scene "_at_once", size, false, what ", inserted with `insert_all`", at_once<scene>},          \
      {#scene "_in_batches", size, false, what ", ten inserted by one operation", in_batches<scene>}, \
      {#scene "_moved", size, true, what ", one moved", moved<scene>},                                \
      {#scene "_toggled", size, true, what ", one removed and inserted again", toggled<scene>}, {     \
#scene "_rewound", size, true, what ", 80 moves rewound", rewound < scene>                        \
  }

constexpr Input kInputs[] = {
    WAYWRIGHT_BRIDGE_INPUTS(street, 1000, "bridges: n houses in a row"),
    WAYWRIGHT_BRIDGE_INPUTS(uneven_street, 1000, "bridges: n houses nearly in a row"),
    WAYWRIGHT_BRIDGE_INPUTS(loose_street, 1000, "bridges: n houses beside a street"),
    WAYWRIGHT_BRIDGE_INPUTS(street_beside_a_wall, 1000, "bridges: n houses beside a slanted wall"),
    WAYWRIGHT_BRIDGE_INPUTS(grid, 1024, "bridges: a grid of n houses with a margin"),
    WAYWRIGHT_BRIDGE_INPUTS(comb, 1000, "bridges: n parallel walls that end on one line"),
    WAYWRIGHT_BRIDGE_INPUTS(contours, 2000, "bridges: n pieces of contour lines"),
    WAYWRIGHT_BRIDGE_INPUTS(border, 1000, "bridges: n houses on the border of the domain"),
    {"room_at_once", 2000, false, "bridges: a room of n walls on an ellipse, inserted with `insert_all`",
     at_once<room>},
    {"house_in_a_room", 2000, true,
     "bridges: a room of n walls on an ellipse, a house in its middle inserted and removed", house_in_a_room<true>},
    {"house_in_a_room_without_bridges", 2000, true, "the same without bridges", house_in_a_room<false>},
    {"wide_street_toggled", 4000, true, "bridges: n houses in a row, one removed and inserted again",
     toggled<wide_street>},
    {"wide_street_toggled_without_bridges", 4000, true, "the same without bridges", toggled<wide_street, false>},
    {"wide_street_moved", 4000, true, "bridges: n houses in a row, one moved", moved<wide_street>},
    {"wide_street_moved_without_bridges", 4000, true, "the same without bridges", moved<wide_street, false>},
};

}  // namespace

std::span<const Input> bridge_inputs() { return kInputs; }

}  // namespace waywright::bench
