#include "support/disc_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "support/case_count.hpp"

namespace waywright::test::disc {
namespace {

using Chain = std::vector<Point>;

void add_chain(Walls& walls, const Chain& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i) walls.segments.emplace_back(chain[i - 1], chain[i]);
}

// Trap scenes

/// A trap before its coordinates are changed. If there is a gap, the radii are half of its length after the change, the
/// doubles next to it, and one of `radii`.
struct Trap {
  std::string name;
  Box domain;
  std::vector<Chain> chains;
  std::vector<std::pair<Point, Point>> queries;
  std::array<double, 4> radii{};
  std::optional<std::pair<Point, Point>> gap;
};

/// Two walls across an alley, whose ends are near the wall at the alley's lower side.
Trap two_bottlenecks(bool is_closed, bool is_acute) {
  const double end = is_closed ? 10 : 12;
  const auto hanging = [&](double x, double y) {
    return is_acute ? Chain{{x - 0.5, 5}, {x, y}, {x + 0.5, 5}} : Chain{{x, y}, {x, 5}};
  };
  return {std::string("bottlenecks") + (is_closed ? " in a closed alley" : "") + (is_acute ? " of acute angles" : ""),
          {{-end, -5}, {end, 5}},
          {{{-10, 0}, {10, 0}}, hanging(0, 0.12), hanging(9, 0.1)},
          {{{-5, 2}, {4, 2}}, {{-5, 2}, {9.75, 0.5}}, {{4, 2}, {9.75, 0.5}}, {{4, 0.2}, {-5, -2}}},
          {0.045, 0.05, 0.055, 0.06},
          {}};
}

/// Many ends near one long wall, each a little nearer than the one before.
Trap narrowing_alley(Random& random) {
  Trap trap{"narrowing alley", {{0, 0}, {100, 10}}, {}, {}, {0.5, 0.75, 0.875, 1.0}, {}};
  for (int i = 0; i < 8; ++i) {
    const double x = 10.0 * i + 10 + static_cast<double>(random.below(5));
    trap.chains.push_back({{x, 2.125 - 0.125 * i}, {x, 10}});
    trap.queries.push_back({{4, 5}, {x + 3, 5}});
  }
  trap.chains.push_back({{0, 0.0}, {100, 0.0}});
  return trap;
}

/// A gap between two ends, and a wall behind it at a distance.
Trap wall_behind(double distance, bool has_end) {
  const double far = 10 + distance;
  Trap trap{"wall behind a gap",
            {{0, 0}, {20, 20}},
            {{{10, 0}, {10, 9}}, {{10, 11}, {10, 20}}},
            {{{5, 10}, {10 + distance / 2, 3}}, {{5, 10}, {18, 10}}, {{10 + distance / 2, 17}, {10 + distance / 2, 3}}},
            {0.5, 0.9, 0.95, 1.0},
            {}};
  trap.chains.push_back(has_end ? Chain{{far, 10}, {far, 20}} : Chain{{far, 0}, {far, 20}});
  return trap;
}

/// A gap in the wall from the bottom to the top, between p and q.
Trap gap_of_ends(const std::string& name, Point p, Point q) {
  return {name,
          {{0, 0}, {20, 20}},
          {{{p.x, 0}, p}, {q, {q.x, 20}}},
          {{{3, 10}, {17, 10}}, {{3, 3}, {17, 3}}, {{17, 17}, {3, 3}}},
          {0.5, 0.5, 0.5, 0.5},
          {{p, q}}};
}

/// A gap between an end and a wall in another direction. The foot is (8, 6) from (4, 3), the end is 5 away from it.
Trap gap_of_foot() {
  return {"gap between an end and a slanted wall",
          {{0, 0}, {30, 30}},
          {{{0, 0}, {24, 18}}, {{5, 10}, {0, 10}}, {{24, 18}, {30, 18}}},
          {{{3, 7}, {15, 20}}, {{3, 7}, {4, 25}}, {{28, 10}, {2, 6}}},
          {1, 1, 1, 1},
          {{{5, 10}, {8, 6}}}};
}

/// A dead end with a door, which the gap between (-2.4, 0.3) and the right wall of the dead end divides. A disc that is
/// too large for this gap leaves the dead end on one side of the gap, goes around the segment above the door, and
/// returns to the dead end on the other side.
Trap divided_door() {
  return {"dead end with a divided door",
          {{-30, -30}, {30, 30}},
          {{{-5, 0}, {-20, -20}, {0, 0}}, {{-2.4, 0.3}, {-2.4, 6}}},
          {{{-4, -1.5}, {-1.42, -0.003}}, {{-1.42, -0.003}, {-4, -1.5}}, {{-4, -1.5}, {20, 20}}, {{9, 2}, {-4, -1.5}}},
          {0.5, 0.9, 0.97, 1.0},
          {}};
}

/// Rings around a centre, each with a door. The left corners of all doors lie on one line, and so do the right ones.
Trap doors_on_a_line() {
  Trap trap{"doors on a line",
            {{-20, -20}, {20, 20}},
            {},
            {{{1, 1}, {-18, 18}}, {{0, 0}, {19, -5}}, {{-2.5, 3}, {-4, -18}}, {{18, 18}, {0.5, -10}}},
            {0.25, 0.5, 0.9, 1.0},
            {}};
  for (int i = 1; i <= 4; ++i) {
    const double half = 4.0 * i;
    const double door = i;
    trap.chains.push_back({{-door, -half}, {-half, -half}, {-half, half}, {half, half}, {half, -half}, {door, -half}});
  }
  return trap;
}

Trap comb(Random& random) {
  Trap trap{"comb", {{0, 0}, {40, 20}}, {}, {{{1.5, 10}, {38.5, 10}}, {{1.5, 3}, {22, 10}}}, {0.75, 1, 1.25, 1.5}, {}};
  for (int i = 1; i < 9; ++i) {
    const double x = 4.0 * i;
    const double gap = 2.0 + 0.25 * static_cast<double>(random.below(4));
    trap.chains.push_back(i % 2 == 0 ? Chain{{x, gap}, {x, 20}} : Chain{{x, 0}, {x, 20 - gap}});
  }
  trap.queries.push_back({{6, 10}, {30, 10}});
  return trap;
}

/// A square spiral whose alley has the width 2.
Trap spiral() {
  const Chain chain{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 2}, {18, 2}, {18, 18}, {2, 18},
                    {2, 4}, {16, 4}, {16, 16}, {4, 16}, {4, 6}, {14, 6}, {14, 14}, {6, 14}};
  return {"spiral",
          {{-4, -4}, {24, 24}},
          {chain},
          {{{-2, 5}, {10, 10}}, {{1, 1}, {9, 11}}, {{22, 22}, {1, 10}}},
          {0.5, 0.999, 1, 1.001},
          {}};
}

/// A row of short walls, between which a disc fits exactly, in front of a wall with a door.
Trap fence(Random& random) {
  Trap trap{"fence", {{0, 0}, {24, 16}}, {}, {{{2, 2}, {2, 14}}, {{12, 1.5}, {22, 14}}}, {0.5, 0.5, 0.5, 0.5}, {}};
  for (int i = 0; i < 8; ++i) trap.chains.push_back({{3.0 * i + 1, 6}, {3.0 * i + 2, 6}});
  const double door = 3.0 * static_cast<double>(random.between(1, 6));
  trap.chains.push_back({{0, 8}, {door - 1, 8}});
  trap.chains.push_back({{door + 1, 8}, {24, 8}});
  trap.gap = {{2, 6}, {4, 6}};
  return trap;
}

/// Ends whose circles touch: a path turns around one and then, without a straight piece, around the other.
Trap touching_arcs() {
  return {"touching arcs",
          {{0, 0}, {20, 20}},
          {{{6, 0}, {6, 10}}, {{10, 20}, {10, 10}}, {{14, 0}, {14, 10}}},
          {{{3, 3}, {17, 3}}, {{8, 2}, {12, 17}}, {{3, 17}, {17, 17}}},
          {1, 1, 1, 1},
          {{{6, 10}, {10, 10}}}};
}

/// A start between two walls that meet at an acute angle: (2 t, t) is t away from both.
Trap acute_angle() {
  return {"start in an acute angle",
          {{-5, -5}, {25, 25}},
          {{{10, 0}, {0, 0}, {6, 8}}, {{0, 0}, {-3, -4}}},
          {{{2, 1}, {20, 10}}, {{4, 2}, {2, 1}}, {{3, 1.5}, {-3, 5}}},
          {0.5, 1, 1.0000000000000002, 1.5},
          {}};
}

/// A room of the size of a disc, whose door is its whole right side or a part of it.
Trap full_room(double door) {
  return {"room of the size of a disc",
          {{-6, -6}, {12, 12}},
          {{{2, 0}, {0, 0}, {0, 2}, {2, 2}}, {{2, 2}, {2, door}}},
          {{{1, 1}, {8, 1}}, {{1, 1}, {1, 1}}, {{1.25, 1}, {-3, 1}}},
          {0.5, 0.99, 1, 1.0000000000000002},
          {}};
}

/// Four ends of a rectangle of 6 x 8: its two diagonals are bridges, which cross.
Trap rectangle_of_ends(bool has_side) {
  Trap trap{"rectangle of four ends",
            {{-10, 0}, {30, 20}},
            {{{7, 0}, {7, 6}}, {{13, 0}, {13, 6}}, {{7, 20}, {7, 14}}, {{13, 20}, {13, 14}}},
            {{{1, 10}, {19, 10}}, {{10, 3}, {1, 10}}, {{10, 10}, {10, 17}}, {{10, 10}, {10, 10}}},
            {3, 4, 5, 5.0000000000000009},
            {}};
  if (has_side) trap.chains.push_back({{7, 6}, {7, 14}});
  return trap;
}

/// Walls that cross and stick out: the crossings are not ends of bridges.
Trap crossing_walls() {
  return {"crossing walls",
          {{0, 0}, {20, 20}},
          {{{5, 2}, {5, 18}},
           {{2, 6}, {18, 6}},
           {{15, 2}, {15, 18}},
           {{3, 14}, {14, 14}},
           {{3, 14}, {10, 14}},
           {{9, 9}, {9, 9}}},
          {{{10, 10}, {17, 10}}, {{10, 10}, {10, 17}}, {{3.5, 10}, {10, 3}}},
          {0.25, 0.5, 0.5000000000000001, 1.5},
          {}};
}

/// An alley of the width 2 that turns, and one that is not parallel to an axis.
Trap turning_alley(double lean) {
  return {"turning alley",
          {{0, 0}, {24, 24}},
          {{{2, 2}, {20, 2 + lean}, {20 - lean, 20}}, {{2, 4}, {18, 4 + lean}, {18 - lean, 20}}},
          {{{2, 3}, {19 - lean, 20}}, {{3, 3.0625}, {10, 12}}, {{1, 20}, {22, 3}}},
          {0.5, 0.99, 1, 1.0000000000000002},
          {}};
}

enum class Coordinates : std::uint8_t { whole, decimal, huge, tiny, far };

NamedScene with_coordinates(const Trap& trap, Coordinates coordinates, Point shift, bool is_swapped) {
  static constexpr std::array kNames{"whole", "decimal", "huge", "tiny", "far"};
  static constexpr std::array kFactors{1.0, 0.1, 1e12, 1e-9, 1.0};
  const auto index = static_cast<std::size_t>(coordinates);
  const double factor = kFactors.at(index);
  const double offset = coordinates == Coordinates::far ? 1e12 : 0.0;
  const auto change = [&](Point p) {
    const Point q{(p.x + shift.x) * factor + offset, (p.y + shift.y) * factor - offset};
    return is_swapped ? Point{q.y, q.x} : q;
  };
  NamedScene scene;
  scene.name = trap.name + ", " + kNames.at(index) + " coordinates";
  scene.domain = {change(trap.domain.min), change(trap.domain.max)};
  for (const Chain& chain : trap.chains) {
    Chain changed;
    for (const Point p : chain) changed.push_back(change(p));
    add_chain(scene.walls, changed);
  }
  for (const auto& [start, goal] : trap.queries) scene.queries.emplace_back(change(start), change(goal));
  for (std::size_t i = 0; i < 4; ++i) scene.radii.at(i) = trap.radii.at(i) * factor;
  if (trap.gap) {
    const Point p = change(trap.gap->first);
    const Point q = change(trap.gap->second);
    const double half = std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y)) / 2;
    const double infinity = std::numeric_limits<double>::infinity();
    scene.radii = {scene.radii[0], std::nextafter(half, 0.0), half, std::nextafter(half, infinity)};
  }
  return scene;
}

// Random scenes

class SceneMaker {
 public:
  SceneMaker(Random& random, SceneKind kind)
      : random_(random), kind_(kind), size_(std::array<double, 3>{12, 24, 48}[random.below(3)]) {}

  NamedScene make() {
    NamedScene scene;
    scene.name = to_string(kind_);
    scene.domain = {{0, 0}, {size_, size_}};
    const std::size_t count = 1 + random_.below(kind_ == SceneKind::tiles ? 60 : 30);
    while (scene.walls.segments.size() < count) add_item(kind_, scene.walls);
    scene.walls.segments.resize(count);
    const double spread = std::array<double, 3>{0.05, 0.1, 0.2}[random_.below(3)];
    for (double& r : scene.radii) r = size_ * (0.004 + spread * fraction() * fraction());
    const bool is_on_grid = kind_ == SceneKind::boxes || kind_ == SceneKind::lattice;
    if (is_on_grid && random_.chance(50))
      scene.radii[random_.below(4)] = 0.5 * static_cast<double>(random_.between(1, 4));
    if (kind_ == SceneKind::tiles) scene.radii = {0.25, 0.5, 1.0, 1.5};
    std::sort(scene.radii.begin(), scene.radii.end());
    const Walls walls = walls_of(scene);
    while (scene.queries.size() < 4) {
      const double r = scene.radii[random_.below(4)];
      scene.queries.emplace_back(free_point(walls, r), free_point(walls, r));
    }
    if (kind_ == SceneKind::touching) {
      scene.radii = {0.5, 1.0, 1.5, 2.0};
      for (auto& [start, goal] : scene.queries) {
        start = beside_end(walls, scene.radii[random_.below(4)]);
        goal = beside_end(walls, scene.radii[random_.below(4)]);
      }
    }
    if (kind_ == SceneKind::tiles) {
      for (auto& [start, goal] : scene.queries) {
        start = centre_of_tile(start);
        goal = centre_of_tile(goal);
      }
    }
    return scene;
  }

 private:
  double fraction() { return static_cast<double>(random_.between(0, std::int64_t{1} << 40)) * 0x1p-40; }
  double between(double low, double high) { return low + (high - low) * fraction(); }
  double whole(double low, double high) {
    return static_cast<double>(random_.between(static_cast<std::int64_t>(low), static_cast<std::int64_t>(high)));
  }
  Point anywhere() { return {between(0, size_), between(0, size_)}; }
  [[nodiscard]] Point inside(Point p) const { return {std::clamp(p.x, 0.0, size_), std::clamp(p.y, 0.0, size_)}; }
  Point near(Point p, double reach) { return inside({p.x + between(-reach, reach), p.y + between(-reach, reach)}); }

  /// Returns a point that is often free for r.
  Point free_point(const Walls& walls, double r) {
    Point p = anywhere();
    for (int i = 0; i < 30 && !fits(walls, p, r); ++i) p = anywhere();
    return p;
  }

  /// Returns a point at exactly the distance r from the end of a wall. It is often free for r.
  Point beside_end(const Walls& walls, double r) {
    Point p;
    for (int i = 0; i < 30; ++i) {
      const auto& wall = walls.segments[random_.below(walls.segments.size())];
      const Point end = random_.chance(50) ? wall.first : wall.second;
      const double offset = random_.chance(50) ? r : -r;
      p = inside(random_.chance(50) ? Point{end.x + offset, end.y} : Point{end.x, end.y + offset});
      if (fits(walls, p, r)) break;
    }
    return p;
  }

  [[nodiscard]] Point centre_of_tile(Point p) const {
    return {std::min(std::floor(p.x), size_ - 1) + 0.5, std::min(std::floor(p.y), size_ - 1) + 0.5};
  }

  void add_item(SceneKind kind, Walls& walls) {
    switch (kind) {
      case SceneKind::boxes:
        return add_box(walls);
      case SceneKind::rotated_boxes:
        return add_rotated_box(walls);
      case SceneKind::segments: {
        const Point p = anywhere();
        return add_chain(walls, {p, near(p, size_ * between(0.05, 0.6))});
      }
      case SceneKind::polylines:
        return add_polyline(walls);
      case SceneKind::lattice:
        return add_on_lattice(walls);
      case SceneKind::touching:
        return add_item(random_.chance(70) ? SceneKind::lattice : SceneKind::segments, walls);
      case SceneKind::alleys:
        return add_to_alley(walls);
      case SceneKind::tiles:
        return add_tiles(walls);
      case SceneKind::mixture:
        return add_item(kSceneKinds[random_.below(kSceneKinds.size() - 1)], walls);
    }
  }

  void add_box(Walls& walls) {
    const double x = whole(0, size_ - 1);
    const double y = whole(0, size_ - 1);
    const double far_x = std::min(size_, x + whole(1, size_ / 3));
    const double far_y = std::min(size_, y + whole(1, size_ / 3));
    add_chain(walls, {{x, y}, {far_x, y}, {far_x, far_y}, {x, far_y}, {x, y}});
  }

  /// Adds the border of a few connected tiles: steps of length 1.
  void add_tiles(Walls& walls) {
    const double last = std::min(size_, 16.0) - 1;
    std::set<std::pair<double, double>> tiles;
    double x = whole(0, last);
    double y = whole(0, last);
    for (std::uint64_t i = 1 + random_.below(8); i > 0; --i) {
      tiles.emplace(x, y);
      double& moved = random_.chance(50) ? x : y;
      moved = std::clamp(moved + (random_.chance(50) ? 1 : -1), 0.0, last);
    }
    for (const auto& [left, low] : tiles) {
      if (!tiles.contains({left - 1, low})) add_chain(walls, {{left, low}, {left, low + 1}});
      if (!tiles.contains({left + 1, low})) add_chain(walls, {{left + 1, low}, {left + 1, low + 1}});
      if (!tiles.contains({left, low - 1})) add_chain(walls, {{left, low}, {left + 1, low}});
      if (!tiles.contains({left, low + 1})) add_chain(walls, {{left, low + 1}, {left + 1, low + 1}});
    }
  }

  void add_rotated_box(Walls& walls) {
    const Point a = anywhere();
    const Point u{between(-0.2, 0.2) * size_, between(-0.2, 0.2) * size_};
    const double ratio = between(0.1, 1);
    const Point v{-u.y * ratio, u.x * ratio};
    const Point c = a + u + v;
    if (inside(a + u) == a + u && inside(c) == c && inside(a + v) == a + v) {
      add_chain(walls, {a, a + u, c, a + v, a});
    }
  }

  void add_polyline(Walls& walls) {
    const double reach = size_ * between(0.05, 0.4);
    Chain chain{anywhere()};
    const std::size_t count = 3 + random_.below(7);
    while (chain.size() < count) chain.push_back(near(chain.back(), reach));
    if (random_.chance(15)) chain.push_back(chain.front());
    add_chain(walls, chain);
  }

  void add_on_lattice(Walls& walls) {
    const double step = size_ / 12;
    const Point p{step * whole(0, 12), step * whole(0, 12)};
    const Point q = inside({p.x + step * whole(-4, 4), p.y + step * whole(-4, 4)});
    const std::size_t kind = random_.below(3);
    add_chain(walls, {p, kind == 0 ? q : kind == 1 ? Point{q.x, p.y} : Point{p.x, q.y}});
  }

  void add_to_alley(Walls& walls) {
    const double y = between(0, size_);
    const double tilt = size_ * between(-0.03, 0.03);
    if (random_.chance(40)) {
      return add_chain(walls, {inside({between(0, 0.2) * size_, y}), inside({between(0.7, 1) * size_, y + tilt})});
    }
    const double x = between(0, size_);
    add_chain(walls, {inside({x, y}), inside({x + tilt, y + size_ * between(-0.3, 0.3)})});
  }

  Random& random_;
  SceneKind kind_;
  double size_;
};

}  // namespace

double largest_coordinate(const Box& box) {
  return std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
}

Walls walls_of(const NamedScene& scene) {
  Walls walls = scene.walls;
  const auto [min, max] = scene.domain;
  add_chain(walls, {min, {max.x, min.y}, max, {min.x, max.y}, min});
  return walls;
}

std::vector<NamedScene> trap_scenes(std::uint64_t seed) {
  Random random(seed);
  std::vector<Trap> traps{two_bottlenecks(false, false), two_bottlenecks(true, false), two_bottlenecks(false, true),
                          two_bottlenecks(true, true),   narrowing_alley(random),      wall_behind(1.875, false),
                          wall_behind(2, false),         wall_behind(2.125, false),    wall_behind(1.75, true),
                          wall_behind(2, true)};
  traps.push_back(gap_of_ends("gap of two ends", {10, 9}, {10, 11}));
  traps.push_back(gap_of_ends("slanted gap of two ends", {8, 8}, {11, 12}));
  traps.push_back(gap_of_ends("gap of an odd length", {9, 9}, {10, 12}));
  traps.push_back(gap_of_foot());
  traps.push_back(comb(random));
  traps.push_back(spiral());
  traps.push_back(fence(random));
  traps.push_back(touching_arcs());
  traps.push_back(acute_angle());
  for (const double door : {2.0, 1.5, 0.25, 0.0}) traps.push_back(full_room(door));
  traps.push_back(rectangle_of_ends(false));
  traps.push_back(rectangle_of_ends(true));
  traps.push_back(crossing_walls());
  traps.push_back(turning_alley(0));
  traps.push_back(turning_alley(0.5));
  traps.push_back(divided_door());
  traps.push_back(doors_on_a_line());
  std::vector<NamedScene> scenes;
  for (const Trap& trap : traps) {
    for (const Coordinates coordinates :
         {Coordinates::whole, Coordinates::decimal, Coordinates::huge, Coordinates::tiny, Coordinates::far}) {
      const Point shift{static_cast<double>(random.between(-20, 20)), static_cast<double>(random.between(-20, 20))};
      scenes.push_back(
          with_coordinates(trap, coordinates, seed == 0 ? Point{} : shift, seed != 0 && random.chance(50)));
    }
  }
  return scenes;
}

std::vector<NamedScene> checked_trap_scenes(std::uint64_t seed) {
  std::vector<NamedScene> scenes = trap_scenes(seed);
  if (!is_quick()) return scenes;
  std::vector<NamedScene> some;
  for (std::size_t i = seed % 11; i < scenes.size(); i += 11) some.push_back(std::move(scenes[i]));
  return some;
}

std::string_view to_string(SceneKind kind) {
  switch (kind) {
    case SceneKind::boxes:
      return "boxes";
    case SceneKind::rotated_boxes:
      return "rotated_boxes";
    case SceneKind::segments:
      return "segments";
    case SceneKind::polylines:
      return "polylines";
    case SceneKind::lattice:
      return "lattice";
    case SceneKind::alleys:
      return "alleys";
    case SceneKind::tiles:
      return "tiles";
    case SceneKind::touching:
      return "touching";
    case SceneKind::mixture:
      return "mixture";
  }
  return "";
}

NamedScene random_scene(Random& random, SceneKind kind) { return SceneMaker(random, kind).make(); }

}  // namespace waywright::test::disc
