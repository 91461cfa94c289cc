#include "crowds/game.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace waywright::bench {

namespace {

constexpr std::size_t kUnits = 1000;
constexpr std::size_t kBuildings = 100;
constexpr std::size_t kChanged = 10;  ///< buildings that disappear and appear in a tick
constexpr double kSmallest = 3.0;     ///< the smallest radius of the circle around a building
constexpr double kLargest = 6.0;      ///< the largest radius of the circle around a building
constexpr std::size_t kChecked = 40;  ///< of this many units, count_wrong_answers() tests one
/// A position on the path of a disc is rounded, so the disc fits there with a radius that is this much smaller.
constexpr double kShrink = 1.0 - 0x1p-30;

constexpr std::array<std::pair<std::string_view, CrowdMode>, 4> kModes = {{{"tra", CrowdMode::tra},
                                                                           {"two_threads", CrowdMode::two_threads},
                                                                           {"affected", CrowdMode::affected},
                                                                           {"optimal", CrowdMode::optimal}}};

World world_of(const Scene& scene) {
  World world = World::create(scene.domain, {.keep_bridges = true}).value();
  static_cast<void>(world.insert_all(scene.items).value());
  return world;
}

/// Returns the seconds that a call takes.
template <class Call>
double seconds_of(Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::optional<CrowdMode> crowd_mode(std::string_view name) {
  for (const auto& [known, mode] : kModes) {
    if (known == name) return mode;
  }
  return std::nullopt;
}

Game::Game(const Scene& scene, std::span<const double> radii, CrowdMode mode)
    : world_(world_of(scene)), radii_(radii.begin(), radii.end()), mode_(mode), paths_(kUnits), contexts_(2) {
  for (const Item& item : scene.items) next_building_ = std::max(next_building_, item.id.value + 1);
  std::vector<Change> changes;
  for (std::size_t i = 0; i < kBuildings; ++i) add_building(changes);
  static_cast<void>(world_.apply(changes).value());
  const auto algorithm = mode == CrowdMode::optimal ? PathAlgorithm::optimal : PathAlgorithm::tra;
  for (std::size_t i = 0; i < kUnits; ++i) {
    const double radius = radii_[i * radii_.size() / kUnits];
    const Point start = fitting_position(radius);
    queries_.push_back(
        {.start = start, .goal = fitting_position(radius), .agent = {.radius = radius}, .algorithm = algorithm});
  }
  world_.find_paths(queries_, contexts_, paths_).value();
}

Tick Game::play() {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < kChanged; ++i) {
    changes.push_back(Change::remove(buildings_.front()));
    buildings_.pop_front();
  }
  for (std::size_t i = 0; i < kChanged; ++i) add_building(changes);
  Tick tick;
  const std::uint64_t before = world_.version();
  tick.update_seconds = seconds_of([&] { static_cast<void>(world_.apply(changes).value()); });
  if (mode_ == CrowdMode::two_threads) {
    tick.searches.push_back(kUnits);
    tick.path_seconds.push_back(seconds_of([&] { world_.find_paths(queries_, contexts_, paths_).value(); }));
  } else {
    ask_in_turn(before, tick);
  }
  for (const Path& path : paths_) ++tick.statuses[static_cast<std::size_t>(path.status)];
  ++ticks_;
  return tick;
}

void Game::ask_in_turn(std::uint64_t since, Tick& tick) {
  std::size_t unit = 0;
  for (const double radius : radii_) {
    std::size_t searches = 0;
    tick.path_seconds.push_back(seconds_of([&] {
      for (; unit < kUnits && queries_[unit].agent.radius == radius; ++unit) {
        if (mode_ == CrowdMode::affected && !must_ask(paths_[unit], since)) continue;
        world_.find_path(queries_[unit], contexts_.front(), paths_[unit]).value();
        ++searches;
      }
    }));
    tick.searches.push_back(searches);
  }
}

bool Game::must_ask(const Path& path, std::uint64_t since) const {
  return path.status != PathStatus::found || world_.is_affected(path, since);
}

void Game::add_building(std::vector<Change>& changes) {
  const double radius = kSmallest + (kLargest - kSmallest) * random_.unit();
  Point centre = fitting_position(radius);
  while (meets_unit(centre, radius)) centre = fitting_position(radius);
  const ItemId id{next_building_++};
  changes.push_back(Change::insert(Shape::regular_polygon(centre, radius, 4 + random_.below(5)), id));
  buildings_.push_back(id);
}

bool Game::meets_unit(const Point& centre, double radius) const {
  return std::any_of(queries_.begin(), queries_.end(), [&](const PathQuery& unit) {
    const Point offset = {unit.start.x - centre.x, unit.start.y - centre.y};
    const double reach = radius + unit.agent.radius;
    return offset.x * offset.x + offset.y * offset.y < reach * reach;
  });
}

Point Game::fitting_position(double radius) {
  const Box& box = world_.domain();
  for (;;) {
    const double x = box.min.x + (box.max.x - box.min.x) * random_.unit();
    const Point centre = {x, box.min.y + (box.max.y - box.min.y) * random_.unit()};
    if (fits(centre, radius)) return centre;
  }
}

bool Game::fits(const Point& centre, double radius) {
  world_.fit_disc(centre, {.radius = radius}, contexts_.front(), fit_).value();
  return fit_.fits;
}

std::size_t Game::count_wrong_answers() {
  std::size_t count = 0;
  for (std::size_t unit = ticks_ % kChecked; unit < kUnits; unit += kChecked) count += is_right(unit) ? 0U : 1U;
  return count;
}

bool Game::is_right(std::size_t unit) {
  const PathQuery& query = queries_[unit];
  const Path& path = paths_[unit];
  switch (path.status) {
    case PathStatus::start_blocked:
      return !fits(query.start, query.agent.radius);
    case PathStatus::goal_blocked:
      return !fits(query.goal, query.agent.radius);
    case PathStatus::no_path:
      world_.widest_path(query.start, query.goal, {}, contexts_.front(), widest_).value();
      return !widest_.is_connected || widest_.radius < query.agent.radius;
    case PathStatus::found:
      break;
  }
  if (path.pieces.front().from != query.start || path.pieces.back().to != query.goal) return false;
  constexpr std::size_t kPositions = 64;
  for (std::size_t i = 0; i <= kPositions; ++i) {
    const double distance = path.length * static_cast<double>(i) / static_cast<double>(kPositions);
    if (!fits(path.at(distance).at, query.agent.radius * kShrink)) return false;
  }
  return true;
}

}  // namespace waywright::bench
