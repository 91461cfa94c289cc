#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/changes_check.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

struct Settings {
  std::uint64_t scripts = 1000;  ///< in all, dealt out evenly to the flavours
  std::size_t operations = 60;   ///< items of a scene
  std::uint64_t seed = 1;
  std::string flavour;        ///< the only one, all of them when empty
  bool paths = false;         ///< ask for paths too
  std::uint64_t changes = 0;  ///< steps of worlds that change, in all; when above 0, instead of scenes
};

struct Totals {
  std::uint64_t scripts = 0;
  std::size_t operations = 0;
  std::size_t vertices = 0;
  std::size_t faults = 0;
};

/// One line that is written over again and again; none where nobody watches.
class Progress {
 public:
  explicit Progress(std::uint64_t all) : all_(all), shown_(isatty(STDERR_FILENO) == 1) {}

  void show(Flavour flavour, std::uint64_t seed) {
    ++done_;
    if (!shown_) return;
    std::cerr << '\r' << done_ << " of " << all_ << ", " << to_string(flavour) << ' ' << seed << "    " << std::flush;
  }

  void end() const {
    if (shown_) std::cerr << '\n';
  }

 private:
  std::uint64_t all_;
  std::uint64_t done_ = 0;
  bool shown_;
};

using CheckOfSeed = SceneReport (*)(const Scene&, Flavour, std::uint64_t);

void run_check(CheckOfSeed check, const char* what, Flavour flavour, std::uint64_t seed, const Settings& settings,
               Totals& totals) {
  const Scene scene = random_scene(flavour, seed, settings.operations);
  const SceneReport report = check(scene, flavour, seed);
  totals.operations += report.operations;
  totals.vertices += report.vertices;
  if (!report.fault) return;
  ++totals.faults;
  const std::string name = std::string(what) + "-" + std::string(to_string(flavour)) + "-" + std::to_string(seed);
  std::cout << report_failure(scene, name, [&](const Scene& less) { return check(less, flavour, seed); }) << std::endl;
}

/// Seeds start at settings.seed, so runs with seeds far enough apart share no scene.
Totals run_flavour(Flavour flavour, std::uint64_t scripts, const Settings& settings, Progress& progress) {
  Totals totals;
  for (std::uint64_t i = 0; i < scripts; ++i) {
    const std::uint64_t seed = settings.seed + i;
    progress.show(flavour, seed);
    ++totals.scripts;
    run_check(check_scene, "world", flavour, seed, settings, totals);
    if (settings.paths) run_check(check_paths, "path", flavour, seed, settings, totals);
  }
  return totals;
}

std::vector<Flavour> flavours_of(const Settings& settings) {
  if (!settings.flavour.empty()) return {*flavour_of(settings.flavour)};
  return {kFlavours.begin(), kFlavours.end()};
}

void print(const ChangeCounts& counts, std::size_t faults) {
  std::cout << counts.steps << " operations (" << counts.batches << " batches, " << counts.refusals << " refused), "
            << counts.insertions << " insertions, " << counts.removals << " removals, " << counts.replacements
            << " replacements, " << counts.validations << " validations, " << counts.rebuilds
            << " comparisons with rebuilds, " << counts.oracles << " with the oracle, " << faults << " faults";
}

/// One world's life after another, until the flavour has made its share of the steps.
ChangeCounts change_flavour(Flavour flavour, std::uint64_t steps, std::uint64_t seed, std::size_t& faults) {
  constexpr std::uint64_t kStepsOfWorld = 500;
  ChangeCounts counts;
  for (; counts.steps < steps; ++seed) {
    const std::uint64_t left = steps - counts.steps;
    const std::size_t live_count = 10 + seed % 6 * 10;
    const ChangeScript script = random_changes(flavour, seed, std::min(left, kStepsOfWorld), live_count);
    const ChangesReport report = check_changes(script, seed, {.with_rebuild = 200, .with_oracle = 20});
    counts += report.counts;
    if (!report.fault) continue;
    ++faults;
    const std::string name = "changes-" + std::string(to_string(flavour)) + "-" + std::to_string(seed);
    std::cout << report_failure(script, name, seed) << std::endl;
  }
  return counts;
}

int run_changes(const Settings& settings) {
  const std::vector<Flavour> flavours = flavours_of(settings);
  ChangeCounts all;
  std::size_t all_faults = 0;
  for (std::size_t i = 0; i < flavours.size(); ++i) {
    const std::uint64_t steps = (settings.changes + flavours.size() - 1 - i) / flavours.size();
    const auto start = std::chrono::steady_clock::now();
    std::size_t faults = 0;
    const ChangeCounts counts = change_flavour(flavours[i], steps, settings.seed, faults);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << to_string(flavours[i]) << ": ";
    print(counts, faults);
    std::cout << ", " << seconds.count() << " s" << std::endl;
    all += counts;
    all_faults += faults;
  }
  std::cout << "all: ";
  print(all, all_faults);
  std::cout << std::endl;
  return all_faults == 0 ? 0 : 1;
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
  app.add_option("--seed", settings.seed, "Seed of the first scene; the others follow it")->capture_default_str();
  app.add_flag("--paths", settings.paths, "Ask for paths in each scene too");
  app.add_option("--flavour", settings.flavour, "lattice, small, large, mantissas or mixed; all when not given")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return waywright::test::flavour_of(name) ? std::string() : "no flavour is called '" + name + "'";
          },
          "FLAVOUR"));
  CLI11_PARSE(app, argc, argv);
  return settings.changes > 0 ? waywright::test::run_changes(settings) : waywright::test::run(settings);
}
