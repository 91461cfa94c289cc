#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

#include "exact/stage_agreement.hpp"
#include "support/bridges_check.hpp"
#include "support/changes_check.hpp"
#include "support/history_check.hpp"
#include "support/path_positions_check.hpp"
#include "support/path_scene_check.hpp"
#include "support/random_changes.hpp"
#include "support/random_path_cases.hpp"
#include "support/random_scenes.hpp"
#include "support/rollback_check.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

struct Settings {
  std::uint64_t scripts = 1000;  ///< in total, divided evenly among the flavours
  std::size_t operations = 60;   ///< items of a scene
  std::uint64_t seed = 1;
  std::string flavour;           ///< the only flavour or kind of obstacles; all of them when empty
  std::uint64_t paths = 0;       ///< scenes to find paths in, in total; when above 0, instead of scenes
  std::uint64_t positions = 0;   ///< positions on paths to search from again, in total; when above 0, instead of scenes
  std::uint64_t predicates = 0;  ///< calls of each predicate, in total; when above 0, instead of scenes
  std::uint64_t changes = 0;     ///< steps of worlds that change, in total; when above 0, instead of scenes
  std::uint64_t bridges = 0;     ///< changes of worlds with bridges, in total; when above 0, instead of scenes
  std::uint64_t rollbacks =
      0;                      ///< rollbacks of worlds with predicted changes, in total; when above 0, instead of scenes
  std::uint64_t history = 0;  ///< steps of worlds with a history and snapshots; when above 0, instead of scenes
};

struct Totals {
  std::uint64_t scripts = 0;
  std::size_t operations = 0;
  std::size_t vertices = 0;
  std::size_t faults = 0;
};

/// A progress line that is overwritten again and again. Prints nothing if the output is not a terminal.
class Progress {
 public:
  explicit Progress(std::uint64_t all) : all_(all), shown_(isatty(STDERR_FILENO) == 1) {}

  void show(std::string_view flavour, std::uint64_t seed, std::uint64_t done = 1) {
    done_ += done;
    if (!shown_) return;
    std::cerr << '\r' << done_ << " of " << all_ << ", " << flavour << ' ' << seed << "    " << std::flush;
  }

  void end() const {
    if (shown_) std::cerr << '\n';
  }

 private:
  std::uint64_t all_;
  std::uint64_t done_ = 0;
  bool shown_;
};

void run_check(Flavour flavour, std::uint64_t seed, const Settings& settings, Totals& totals) {
  const Scene scene = random_scene(flavour, seed, settings.operations);
  const SceneReport report = check_scene(scene, flavour, seed);
  totals.operations += report.operations;
  totals.vertices += report.vertices;
  if (!report.fault) return;
  ++totals.faults;
  const std::string name = "world-" + std::string(to_string(flavour)) + "-" + std::to_string(seed);
  std::cout << report_failure(scene, name, [&](const Scene& less) { return check_scene(less, flavour, seed); })
            << std::endl;
}

/// Seeds start at settings.seed. Two runs whose seeds are far enough apart share no scene.
Totals run_flavour(Flavour flavour, std::uint64_t scripts, const Settings& settings, Progress& progress) {
  Totals totals;
  for (std::uint64_t i = 0; i < scripts; ++i) {
    const std::uint64_t seed = settings.seed + i;
    progress.show(to_string(flavour), seed);
    ++totals.scripts;
    run_check(flavour, seed, settings, totals);
  }
  return totals;
}

std::vector<Flavour> flavours_of(const Settings& settings) {
  if (const auto only = flavour_of(settings.flavour)) return {*only};
  return {kFlavours.begin(), kFlavours.end()};
}

void print(const ChangeCounts& counts) {
  std::cout << counts.steps << " operations (" << counts.batches << " batches, " << counts.refusals << " refused), "
            << counts.insertions << " insertions, " << counts.removals << " removals, " << counts.replacements
            << " replacements, " << counts.validations << " validations, " << counts.rebuilds
            << " comparisons with rebuilds, " << counts.oracles << " with the oracle";
}

/// The number of steps of some worlds, and the number of steps or changes that were undone.
struct UndoCounts {
  std::size_t steps = 0;
  std::size_t undone = 0;

  UndoCounts& operator+=(const UndoCounts& other) {
    steps += other.steps;
    undone += other.undone;
    return *this;
  }
};

struct BridgesCounts : UndoCounts {};

void print(const BridgesCounts& counts) {
  std::cout << counts.steps << " changes, " << counts.undone << " steps undone";
}

struct RollbackCounts : UndoCounts {};

void print(const RollbackCounts& counts) {
  std::cout << counts.steps << " rollbacks, " << counts.undone << " changes taken back";
}

void print(const HistoryCounts& counts) {
  std::cout << counts.steps << " steps: " << counts.operations << " operations (" << counts.refusals << " refused), "
            << counts.marks << " marks, " << counts.rewinds << " rewinds, " << counts.attempts << " attempts, "
            << counts.snapshots << " snapshots, " << counts.snapshots_of_ticks << " snapshots of ticks, "
            << counts.sharing_replicas << " new replicas that share pages, " << counts.comparisons
            << " snapshots compared again later, " << counts.clones << " clones, " << counts.saves << " saves";
}

/// Checks random worlds of each flavour, one seed after another, until the worlds of the flavour have made its share of
/// `total` steps. check(flavour, seed, left, counts) checks one world, which makes at most `left` steps if it can make
/// so few. It adds what the world has done to `counts`, and returns a description of the first fault, or an empty text.
/// Prints the counts of each flavour and of all together.
template <class Counts, class Check>
int run_worlds(const Settings& settings, std::uint64_t total, Check&& check) {
  const std::vector<Flavour> flavours = flavours_of(settings);
  Progress progress(total);
  std::size_t faults = 0;
  Counts all;
  for (std::size_t i = 0; i < flavours.size(); ++i) {
    const std::string_view name = to_string(flavours[i]);
    const std::uint64_t steps = (total + flavours.size() - 1 - i) / flavours.size();
    const auto start = std::chrono::steady_clock::now();
    Counts some;
    for (std::uint64_t seed = settings.seed; some.steps < steps; ++seed) {
      const std::uint64_t before = some.steps;
      const std::string fault = check(flavours[i], seed, steps - before, some);
      progress.show(name, seed, some.steps - before);
      if (fault.empty()) continue;
      ++faults;
      std::cout << name << ", seed " << seed << ": " << fault << std::endl;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << name << ": ";
    print(some);
    std::cout << ", " << faults << " faults so far, " << seconds.count() << " s" << std::endl;
    all += some;
  }
  progress.end();
  std::cout << "all: ";
  print(all);
  std::cout << ", " << faults << " faults" << std::endl;
  return faults == 0 ? 0 : 1;
}

int run_changes(const Settings& settings) {
  static constexpr std::uint64_t kStepsOfWorld = 500;
  const auto check = [](Flavour flavour, std::uint64_t seed, std::uint64_t left, ChangeCounts& counts) {
    const std::size_t live_count = 10 + seed % 6 * 10;
    const ChangeScript script = random_changes(flavour, seed, std::min(left, kStepsOfWorld), live_count);
    const ChangesReport report = check_changes(script, seed, {.with_rebuild = 200, .with_oracle = 20});
    counts += report.counts;
    if (!report.fault) return std::string();
    return report_failure(script, "changes-" + std::string(to_string(flavour)) + "-" + std::to_string(seed), seed);
  };
  return run_worlds<ChangeCounts>(settings, settings.changes, check);
}

/// Compares the bridges with a rebuild after every step.
int run_bridges(const Settings& settings) {
  constexpr std::size_t kStepsOfWorld = 500;
  const auto check = [](Flavour flavour, std::uint64_t seed, std::uint64_t /*left*/, BridgesCounts& counts) {
    const std::size_t live_count = 20 + seed % 5 * 10;
    const ChangeScript script = random_changes(flavour, seed, kStepsOfWorld, live_count);
    const BridgesReport report = check_bridges(script, seed);
    counts += {report.changes, report.undone};
    return report.fault ? report_bridges_failure(script, seed) : std::string();
  };
  return run_worlds<BridgesCounts>(settings, settings.bridges, check);
}

/// Plays games with rollback.
int run_rollbacks(const Settings& settings) {
  static constexpr std::uint64_t kRollbacksOfWorld = 25;
  const auto check = [](Flavour flavour, std::uint64_t seed, std::uint64_t left, RollbackCounts& counts) {
    const RollbackReport report = check_rollbacks(flavour, seed, std::min(left, kRollbacksOfWorld));
    counts += {report.rollbacks, report.changes};
    return report.fault;
  };
  return run_worlds<RollbackCounts>(settings, settings.rollbacks, check);
}

/// Mixes operations, marks, rewinds, attempts, snapshots, clones and saves.
int run_history(const Settings& settings) {
  static constexpr std::uint64_t kStepsOfWorld = 500;
  const auto check = [](Flavour flavour, std::uint64_t seed, std::uint64_t left, HistoryCounts& counts) {
    const HistoryReport report = check_history(flavour, seed, std::min(left, kStepsOfWorld));
    counts += report.counts;
    return report.fault;
  };
  return run_worlds<HistoryCounts>(settings, settings.history, check);
}

/// The kind of scenes to find paths in: their obstacles or their flavour.
struct PathKind {
  std::string_view name;
  std::function<PathCase(std::uint64_t seed)> make;
};

constexpr std::size_t kQueries = 5;

std::vector<PathKind> path_kinds(const Settings& settings) {
  std::vector<PathKind> kinds;
  const auto add = [&](std::string_view name, auto make) {
    if (settings.flavour.empty() || settings.flavour == name) kinds.push_back({name, make});
  };
  for (const Obstacles obstacles : kObstacles) {
    add(to_string(obstacles), [obstacles](std::uint64_t seed) { return random_path_case(obstacles, seed, kQueries); });
  }
  for (const Flavour flavour : kFlavours) {
    add(to_string(flavour), [flavour, items = settings.operations](std::uint64_t seed) {
      return random_path_case(flavour, seed, items, kQueries);
    });
  }
  return kinds;
}

struct PathTotals {
  std::size_t queries = 0;
  std::size_t faults = 0;
  std::array<PathRatios, kPathAlgorithms.size()> ratios;

  PathTotals& operator+=(const PathTotals& other) {
    queries += other.queries;
    faults += other.faults;
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios.at(i) += other.ratios.at(i);
    return *this;
  }
};

void print(const PathTotals& totals) {
  std::cout << totals.queries << " queries, " << totals.faults << " faults";
  for (std::size_t i = 0; i < totals.ratios.size(); ++i) {
    const PathRatios& ratios = totals.ratios.at(i);
    std::cout << ", " << to_string(kPathAlgorithms.at(i)) << ": " << ratios.count << " found, " << ratios.mean()
              << " times the shortest, at worst " << ratios.worst;
  }
}

PathTotals run_path_kind(const PathKind& kind, std::uint64_t count, const Settings& settings, Progress& progress) {
  PathTotals totals;
  for (std::uint64_t seed = settings.seed; seed < settings.seed + count; ++seed) {
    progress.show(kind.name, seed);
    const PathCase path_case = kind.make(seed);
    const PathReport report = check_paths(path_case);
    totals += {report.queries, report.fault ? 1U : 0U, report.ratios};
    if (!report.fault) continue;
    const std::string name = "path-" + std::string(kind.name) + "-" + std::to_string(seed);
    std::cout << report_failure(path_case, name) << std::endl;
  }
  return totals;
}

int run_paths(const Settings& settings) {
  const std::vector<PathKind> kinds = path_kinds(settings);
  Progress progress(settings.paths);
  PathTotals all;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::uint64_t count = (settings.paths + kinds.size() - 1 - i) / kinds.size();
    const auto start = std::chrono::steady_clock::now();
    const PathTotals totals = run_path_kind(kinds[i], count, settings, progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << kinds[i].name << ": " << count << " scenes, ";
    print(totals);
    std::cout << ", " << seconds.count() << " s" << std::endl;
    all += totals;
  }
  progress.end();
  std::cout << "all: ";
  print(all);
  std::cout << std::endl;
  return all.faults == 0 ? 0 : 1;
}

/// Searches again from positions on paths.
int run_path_positions(const Settings& settings) {
  constexpr std::size_t kPositionsPerPath = 10;
  constexpr std::size_t kQueriesPerScene = 40;
  std::size_t faults = 0;
  PathPositionsReport all;
  for (const Obstacles obstacles : kObstacles) {
    const bool has_solids_only = obstacles == Obstacles::boxes || obstacles == Obstacles::tiles;
    PathPositionsReport some;
    for (std::uint64_t seed = settings.seed; some.positions < settings.positions / kObstacles.size(); ++seed) {
      const PathCase path_case = random_path_case(obstacles, seed, kQueriesPerScene);
      const PathPositionsReport report = check_path_positions(path_case, kPositionsPerPath, has_solids_only);
      some.paths += report.paths;
      some.positions += report.positions;
      some.moved += report.moved;
      some.worst = std::max(some.worst, report.worst);
      if (!report.fault) continue;
      ++faults;
      std::cout << to_string(obstacles) << ", seed " << seed << ": " << *report.fault << std::endl;
    }
    std::cout << to_string(obstacles) << ": " << some.positions << " positions on " << some.paths << " paths, "
              << some.moved << " moved, longer by at most " << some.worst << " of the domain's size" << std::endl;
    all.paths += some.paths;
    all.positions += some.positions;
    all.moved += some.moved;
  }
  std::cout << "all: " << all.positions << " positions on " << all.paths << " paths, " << all.moved << " moved, "
            << faults << " faults" << std::endl;
  return faults == 0 ? 0 : 1;
}

/// Compares the stages of the predicates with each other.
int run_predicates(const Settings& settings) {
  constexpr std::uint64_t kEveryNth = 50;
  constexpr std::uint64_t kCallsOfDraw = 1'000'000;  // then draws other points
  bool agree = true;
  for (const NearMiss kind : kNearMisses) {
    const auto start = std::chrono::steady_clock::now();
    Agreement all;
    for (std::uint64_t seed = settings.seed; all.calls < settings.predicates / kNearMisses.size() && agree; ++seed) {
      const Agreement some = compare_stages(kind, seed, kCallsOfDraw, kEveryNth);
      all += some;
      if (some.fault.empty()) continue;
      agree = false;
      std::cout << to_string(kind) << ", seed " << seed << ": " << some.fault << std::endl;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << to_string(kind) << ": " << all.calls << " calls of each question, " << all.doubles
              << " decided in doubles, " << all.on_lattice << " on a lattice, " << all.against_integers
              << " held against integers of any size, " << seconds.count() << " s" << std::endl;
  }
  return agree ? 0 : 1;
}

int run(const Settings& settings) {
  const std::vector<Flavour> flavours = flavours_of(settings);
  Progress progress(settings.scripts);
  std::size_t faults = 0;
  for (std::size_t i = 0; i < flavours.size(); ++i) {
    const std::uint64_t scripts = (settings.scripts + flavours.size() - 1 - i) / flavours.size();
    const auto start = std::chrono::steady_clock::now();
    const Totals totals = run_flavour(flavours[i], scripts, settings, progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    faults += totals.faults;
    std::cout << to_string(flavours[i]) << ": " << totals.scripts << " scripts, " << totals.operations
              << " operations, " << totals.vertices << " vertices, " << totals.faults << " faults, " << seconds.count()
              << " s" << std::endl;
  }
  progress.end();
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace waywright::test

int main(int argc, char** argv) {
  waywright::test::Settings settings;
  CLI::App app("Random worlds against the oracle, for as long as asked.", "waywright_soak");
  app.add_option("--scripts", settings.scripts, "Count of scenes, over all flavours")->capture_default_str();
  app.add_option("--operations", settings.operations, "Items of each scene")->capture_default_str();
  app.add_option("--changes", settings.changes,
                 "Count of insertions, removals, replacements and batches in worlds that change, instead of scenes");
  app.add_option("--bridges", settings.bridges,
                 "Count of changes in worlds whose bridges are compared with a rebuild, instead of scenes");
  app.add_option("--rollbacks", settings.rollbacks,
                 "Count of rollbacks of 8 ticks with 10 changes each, instead of scenes");
  app.add_option("--history", settings.history,
                 "Count of steps in worlds that go back, try out, copy, save and publish, instead of scenes");
  app.add_option("--seed", settings.seed, "Seed of the first scene; the others follow it")->capture_default_str();
  app.add_option("--predicates", settings.predicates,
                 "Count of calls of each predicate, stage against stage, instead of scenes");
  app.add_option("--positions", settings.positions,
                 "Count of positions on paths from which a path is asked for again, instead of scenes");
  app.add_option("--paths", settings.paths, "Count of scenes to find paths in, instead of scenes");
  app.add_option(
         "--flavour", settings.flavour,
         "lattice, small, large, mantissas or mixed; of --paths also boxes, walls, polylines, tiles or mixture; "
         "all when not given")
      ->check(CLI::Validator(
          [](const std::string& name) {
            const bool known = waywright::test::flavour_of(name) || waywright::test::obstacles_of(name);
            return known ? std::string() : "no flavour is called '" + name + "'";
          },
          "FLAVOUR"));
  CLI11_PARSE(app, argc, argv);
  if (settings.predicates > 0) return waywright::test::run_predicates(settings);
  if (settings.paths > 0) return waywright::test::run_paths(settings);
  if (settings.positions > 0) return waywright::test::run_path_positions(settings);
  if (waywright::test::obstacles_of(settings.flavour)) {
    std::cerr << "waywright_soak: '" << settings.flavour << "' is a flavour of --paths only\n";
    return 2;
  }
  if (settings.bridges > 0) return waywright::test::run_bridges(settings);
  if (settings.rollbacks > 0) return waywright::test::run_rollbacks(settings);
  if (settings.history > 0) return waywright::test::run_history(settings);
  return settings.changes > 0 ? waywright::test::run_changes(settings) : waywright::test::run(settings);
}
