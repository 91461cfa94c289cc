#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/job_system.hpp"
#include "waywright/path_search.hpp"
#include "waywright/scenario.hpp"
#include "waywright/script.hpp"
#include "waywright/world.hpp"

#include "support/case_count.hpp"
#include "support/random.hpp"
#include "support/random_changes.hpp"
#include "support/random_path_cases.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

/// For programs that round in another direction, flush subnormal numbers to zero or trap exceptions. Each answer must
/// be the same as in an ordinary program, and the program's own mode must be the same after a call as before it.
namespace waywright::test {
namespace {

enum class Mode : std::uint8_t { upward, downward, toward_zero, flush_to_zero, denormals_are_zero, traps };

std::string name_of(Mode mode) {
  switch (mode) {
    case Mode::upward:
      return "upward";
    case Mode::downward:
      return "downward";
    case Mode::toward_zero:
      return "toward_zero";
    case Mode::flush_to_zero:
      return "flush_to_zero";
    case Mode::denormals_are_zero:
      return "denormals_are_zero";
    case Mode::traps:
      return "traps";
  }
  return "";
}

#if defined(__SSE2__)
constexpr unsigned kOrdinary = 0x1f80;
constexpr unsigned kFlags = 0x3f;

unsigned control_of(Mode mode) {
  constexpr unsigned kRounding = 0x2000;
  switch (mode) {
    case Mode::upward:
      return kOrdinary | 2 * kRounding;
    case Mode::downward:
      return kOrdinary | 1 * kRounding;
    case Mode::toward_zero:
      return kOrdinary | 3 * kRounding;
    case Mode::flush_to_zero:
      return kOrdinary | 0x8000;
    case Mode::denormals_are_zero:
      return kOrdinary | 0x8040;  // and flushes to zero, as programs usually combine the two
    case Mode::traps:
      return 0;
  }
  return kOrdinary;
}

/// Calls the library in a mode. Everything around the call is computed in the ordinary mode.
template <class Call>
auto in_mode(Mode mode, const Call& call) {
  struct Restored {
    ~Restored() { _mm_setcsr(kOrdinary); }
  } const restored;
  _mm_setcsr(control_of(mode));
  auto result = call();
  EXPECT_EQ(_mm_getcsr() & ~kFlags, control_of(mode)) << "the call did not give the mode back";
  return result;
}
const std::vector<Mode> kModes = {Mode::upward,        Mode::downward,           Mode::toward_zero,
                                  Mode::flush_to_zero, Mode::denormals_are_zero, Mode::traps};
#else
int rounding_of(Mode mode) {
  switch (mode) {
    case Mode::upward:
      return FE_UPWARD;
    case Mode::downward:
      return FE_DOWNWARD;
    default:
      return FE_TOWARDZERO;
  }
}

template <class Call>
auto in_mode(Mode mode, const Call& call) {
  std::fesetround(rounding_of(mode));
  auto result = call();
  EXPECT_EQ(std::fegetround(), rounding_of(mode)) << "the call did not give the mode back";
  std::fesetround(FE_TONEAREST);
  return result;
}
const std::vector<Mode> kModes = {Mode::upward, Mode::downward, Mode::toward_zero};
#endif

class FloatEnvironment : public testing::TestWithParam<Mode> {
 protected:
  template <class Call>
  static auto in(const Call& call) {
    return in_mode(GetParam(), call);
  }
};

INSTANTIATE_TEST_SUITE_P(Modes, FloatEnvironment, testing::ValuesIn(kModes),
                         [](const auto& mode) { return name_of(mode.param); });

/// A job system whose thread computes in a mode of its own.
class JobsInMode final : public JobSystem {
 public:
  explicit JobsInMode(Mode mode) : mode_(mode) {}
  void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
    for (std::size_t i = 0; i < count; ++i) {
      in_mode(mode_, [&] {
        job(i);
        return true;
      });
    }
  }

 private:
  Mode mode_;
};

/// For calls in the ordinary mode.
constexpr auto kPlainly = [](const auto& call) { return call(); };

std::string bits_of(double value) { return std::to_string(std::bit_cast<std::uint64_t>(value)) + ' '; }
std::string bits_of(const Point& point) { return bits_of(point.x) + bits_of(point.y); }

std::string text_of(const Result<Path>& path) {
  if (!path) return std::string(to_string(path.error().code));
  std::string text(to_string(path->status));
  text += ' ' + bits_of(path->length) + bits_of(path->lower_bound) + std::to_string(path->expansions) + ':';
  for (const Point& point : path->points) text += bits_of(point);
  return text;
}

Point scaled(const Point& point, double scale) { return {point.x * scale, point.y * scale}; }

ChangeScript scaled(ChangeScript script, double scale) {
  script.domain = {scaled(script.domain.min, scale), scaled(script.domain.max, scale)};
  for (Step& step : script.steps) {
    for (Change& change : step.changes) {
      for (Point& point : change.shape.rings.points()) point = scaled(point, scale);
    }
  }
  return script;
}

/// Returns the results of a script's changes, step by step, and of queries in between. Makes each call through `call`.
template <class Call>
std::string life_of(const ChangeScript& script, std::uint64_t seed, const Call& call) {
  Result<World> world = call([&] { return World::create(script.domain); });
  if (!world) return std::string(to_string(world.error().code));
  Random random(seed);
  const auto somewhere = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random.below(33)) / 32.0);
  };
  const auto random_point = [&]() -> Point {
    return {somewhere(script.domain.min.x, script.domain.max.x), somewhere(script.domain.min.y, script.domain.max.y)};
  };
  std::string text;
  for (const Step& step : script.steps) {
    const auto done = call([&] { return perform(*world, step); });
    text += done ? "done" : to_string(done.error().code);
    text += ' ' + to_string(world->items_hash()) + '\n';
    const Point from = random_point();
    const Point to = random_point();
    for (const PathAlgorithm algorithm : {PathAlgorithm::optimal, PathAlgorithm::ta, PathAlgorithm::tra}) {
      text += text_of(call([&] { return world->find_path({.start = from, .goal = to, .algorithm = algorithm}); }));
    }
    const auto hit = call([&] { return world->ray(from, to); });
    text += hit ? std::to_string(hit->hit) + bits_of(hit->at) : std::string(to_string(hit.error().code));
    const auto location = call([&] { return world->locate(to); });
    if (location) text += bits_of(location->vertices[0]) + std::string(to_string(location->kind));
    const auto crossed = call([&] { return world->items_crossed(from, to); });
    if (crossed) {
      for (const CrossedItem& item : *crossed) text += bits_of(item.at);
    }
  }
  const Validation validation = call([&] { return world->validate(); });
  return text + validation.fault + call([&] { return world->dump(); });
}

const std::uint64_t kScriptsOfFlavour = case_count<std::uint64_t>(40);

TEST_P(FloatEnvironment, ChangesNoWorld) {
  for (const Flavour flavour : kFlavours) {
    for (std::uint64_t seed = 0; seed < kScriptsOfFlavour; ++seed) {
      const ChangeScript script = random_changes(flavour, seed, 16, 12);
      ASSERT_EQ(life_of(script, seed, [](const auto& call) { return in(call); }), life_of(script, seed, kPlainly))
          << to_string(flavour) << ' ' << seed;
    }
  }
}

// Coordinates are 0 or little more than 2^-100. Many others are too small, and the world refuses them.
TEST_P(FloatEnvironment, ChangesNoTinyWorld) {
  for (const double scale : {0x1p-94, 0x1p-99}) {
    for (const Flavour flavour : {Flavour::lattice, Flavour::mantissas}) {
      for (std::uint64_t seed = 0; seed < kScriptsOfFlavour; ++seed) {
        const ChangeScript script = scaled(random_changes(flavour, seed, 16, 12), scale);
        ASSERT_EQ(life_of(script, seed, [](const auto& call) { return in(call); }), life_of(script, seed, kPlainly))
            << to_string(flavour) << ' ' << seed << ' ' << scale;
      }
    }
  }
}

TEST_P(FloatEnvironment, SubnormalCoordinatesAreRefused) {
  constexpr double kSubnormal = 0x1p-1050;
  World world = World::create({{-1, -1}, {1, 1}}).value();
  const auto inserted = in([&] { return world.insert_point({kSubnormal, 0.5}); });
  ASSERT_FALSE(inserted.ok());
  EXPECT_EQ(inserted.error().code, ErrorCode::coordinate_range);
  EXPECT_EQ(in([&] { return World::create({{kSubnormal, 0}, {1, 1}}); }).error().code, ErrorCode::coordinate_range);
  EXPECT_EQ(in([&] { return world.locate({0.5, kSubnormal}); }).error().code, ErrorCode::coordinate_range);
  EXPECT_EQ(in([&] {
              return world.find_path({.start = {kSubnormal, 0}, .goal = {1, 1}});
            })
                .error()
                .code,
            ErrorCode::coordinate_range);
}

TEST_P(FloatEnvironment, ChangesNoPath) {
  for (const Obstacles obstacles : kObstacles) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const PathCase example = random_path_case(obstacles, seed, 6);
      World world = World::create(example.scene.domain).value();
      in([&] { return world.insert_all(example.scene.items, {.threads = 2, .progress = {}}); }).value();
      std::vector<PathQuery> queries;
      for (const Ends& ends : example.queries) queries.push_back({.start = ends.start, .goal = ends.goal});
      const std::vector<Path> paths = in([&] { return world.find_paths(queries, 2); }).value();
      JobsInMode jobs(GetParam());
      const std::vector<Path> by_jobs = world.find_paths(queries, 2, &jobs).value();
      std::vector<Point> goals;
      for (const PathQuery& query : queries) goals.push_back(query.goal);
      const ManyGoalsQuery many{.start = queries[0].start, .goals = goals, .wants_points = true};
      const std::vector<Path> from_one = in([&] { return world.find_paths_from(many); }).value();
      const std::vector<Path> plainly = world.find_paths_from(many).value();
      for (std::size_t i = 0; i < queries.size(); ++i) {
        ASSERT_EQ(text_of(paths[i]), text_of(world.find_path(queries[i])));
        ASSERT_EQ(text_of(by_jobs[i]), text_of(paths[i]));
        ASSERT_EQ(text_of(from_one[i]), text_of(plainly[i]));
        PathSearch search;
        search.record_windows(true);
        in([&] { return search.begin(world, queries[i]); }).value();
        while (!in([&] { return search.step(8); }).value()) {
        }
        ASSERT_EQ(text_of(search.path()), text_of(paths[i]));
        const std::vector<SearchWindow> windows(search.windows().begin(), search.windows().end());
        search.begin(world, queries[i]).value();
        while (!search.step(8).value()) {
        }
        ASSERT_TRUE(std::equal(windows.begin(), windows.end(), search.windows().begin(), search.windows().end()));
      }
    }
  }
}

std::string bits_of(const PathPosition& position) {
  return bits_of(position.at) + bits_of(position.heading) + bits_of(position.distance) +
         std::to_string(position.segment);
}

TEST_P(FloatEnvironment, ChangesNoWalkAlongAPath) {
  for (const Obstacles obstacles : kObstacles) {
    const PathCase example = random_path_case(obstacles, 3, 6);
    World world = World::create(example.scene.domain).value();
    world.insert_all(example.scene.items).value();
    const std::uint64_t version = world.version();
    world.insert_point(example.queries[0].start).value();
    for (const Ends& ends : example.queries) {
      const Path path = world.find_path({.start = ends.start, .goal = ends.goal}).value();
      EXPECT_EQ(in([&] { return world.is_clear(path.points); }).value(), world.is_clear(path.points).value());
      EXPECT_EQ(in([&] { return world.is_affected(path.points, version); }), world.is_affected(path.points, version));
      if (path.status != PathStatus::found) continue;
      for (std::size_t i = 0; i <= 16; ++i) {
        const double distance = path.length * (static_cast<double>(i) / 16.0);
        const PathPosition plainly = path.at(distance);
        ASSERT_EQ(bits_of(in([&] { return path.at(distance); })), bits_of(plainly));
        const Point beside{plainly.at.x + 0.1, plainly.at.y - 0.3};
        ASSERT_EQ(bits_of(in([&] { return path.nearest(beside); })), bits_of(path.nearest(beside)));
      }
    }
  }
}

TEST_P(FloatEnvironment, ChangesNoBridge) {
  for (const Obstacles obstacles : kObstacles) {
    const PathCase example = random_path_case(obstacles, 4, 6);
    World world = World::create(example.scene.domain, {.keep_bridges = true}).value();
    in([&] { return world.insert_all(example.scene.items); }).value();
    const BridgeList plainly = world.bridges(world.domain()).value();
    EXPECT_FALSE(plainly.bridges.empty());
    EXPECT_EQ(in([&] { return world.bridges(world.domain()); }).value(), plainly);
  }
}

TEST_P(FloatEnvironment, ChangesNoWalkOfADisc) {
  World world = World::create({{0, 0}, {100, 100}}, {.keep_bridges = true}).value();
  world.insert_segment({50.3, 0}, {51.7, 60.1}).value();
  world.insert_segment({70.3, 100}, {71.7, 40.7}).value();
  const std::uint64_t version = world.version();
  const Path path = world.find_path({.start = {20.1, 50.3}, .goal = {90, 50}, .agent = {.radius = 5.3}}).value();
  ASSERT_GE(path.pieces.size(), 5U);
  for (std::size_t i = 0; i <= 64; ++i) {
    const double distance = path.length * (static_cast<double>(i) / 64.0);
    const PathPosition plainly = path.at(distance);
    ASSERT_EQ(bits_of(in([&] { return path.at(distance); })), bits_of(plainly));
    const Point beside{plainly.at.x + 0.1, plainly.at.y - 0.3};
    ASSERT_EQ(bits_of(in([&] { return path.nearest(beside); })), bits_of(path.nearest(beside)));
  }
  EXPECT_EQ(in([&] { return path.polyline(0.1); }).value(), path.polyline(0.1).value());
  world.insert_segment({30, 30}, {40, 40}).value();
  EXPECT_EQ(in([&] { return world.is_affected(path, version); }), world.is_affected(path, version));
}

TEST_P(FloatEnvironment, ChangesNoPointsText) {
  EXPECT_EQ(in([] { return to_string(Point{-0.0, 0x1p-1050}); }), to_string(Point{-0.0, 0x1p-1050}));
}

TEST_P(FloatEnvironment, ChangesNoScenario) {
  constexpr const char* kScenario =
      "version 1\n0 a.map 8 8 1 2 3 4 0.1234567\n0 a.map 8 8 1 2 3 4 9007199254740993e-5\n";
  const auto queries = in([&] { return parse_movingai_scenario(kScenario, "text"); });
  const auto plainly = parse_movingai_scenario(kScenario, "text");
  ASSERT_TRUE(queries.ok() && plainly.ok());
  ASSERT_EQ(queries->size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(bits_of((*queries)[i].length), bits_of((*plainly)[i].length));
}

TEST_P(FloatEnvironment, ChangesNoShape) {
  const Shape shape{ItemKind::polygon, {{{0.1, 0.2}, {3.3, 0.1}, {2.7, 1.9}, {-0.0, 1.3}}}};
  EXPECT_EQ(in([&] { return translated(shape, 0.1, -0.3); }), translated(shape, 0.1, -0.3));
  EXPECT_EQ(bits_of(in([&] { return centroid(shape); })), bits_of(centroid(shape)));
  // A shape whose area is a subnormal number, and a point that moves to a subnormal coordinate.
  const Shape tiny{ItemKind::polygon, {{{0, 0}, {0x1p-530, 0}, {0x1p-530, 0x1p-529}, {0, 0x1p-530}}}};
  EXPECT_EQ(bits_of(in([&] { return centroid(tiny); })), bits_of(centroid(tiny)));
  const Shape smallest{ItemKind::point, {{{0x1.8p-1022, 0}}}};
  EXPECT_EQ(bits_of(in([&] { return translated(smallest, -0x1p-1022, 0); }).rings[0][0]), bits_of(Point{0x1p-1023, 0}));
}

TEST_P(FloatEnvironment, ChangesNoText) {
  constexpr const char* kScript =
      "waywright 1\ndomain -7.3e-5 -1e22 123456.7 1\npoint 1 0.1 0.3\npoint 2 -0.0 1e-23\n"
      "segment 3 0.7 0.123456789012345678 9007199254740993e3 -1e21\npoint 4 1e-310 0\n";
  const Script script = in([&] { return parse_script(kScript, "text"); }).value();
  const Script plainly = parse_script(kScript, "text").value();
  for (std::size_t i = 0; i < script.lines.size(); ++i) {
    for (std::size_t k = 0; k < script.lines[i].item.shape.rings[0].size(); ++k) {
      EXPECT_EQ(bits_of(script.lines[i].item.shape.rings[0][k]), bits_of(plainly.lines[i].item.shape.rings[0][k]));
    }
  }
  const Scene scene = in([&] { return scene_of(script); });
  EXPECT_EQ(scene.items.size(), 2U);  // without 3, which leaves the domain, and 4, which is subnormal
  EXPECT_EQ(in([&] { return to_script(scene); }), to_script(scene_of(plainly)));
}

}  // namespace
}  // namespace waywright::test
