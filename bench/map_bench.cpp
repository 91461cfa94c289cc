#include <string>

#include <benchmark/benchmark.h>

#include "at_once.hpp"
#include "constraint_benchmarks.hpp"
#include "harness.hpp"
#include "real_scenes.hpp"
#include "registers.hpp"
#include "waywright_contender.hpp"

namespace waywright::bench {
namespace {

/// Times the construction from the items in the order of the file.
void register_at_once(const std::string& file, const std::string& contender, const WorldOptions& options) {
  const std::string name = "bulk_map/" + file.substr(file.rfind('/') + 1) + '/' + contender;
  benchmark::RegisterBenchmark(name.c_str(),
                               [file, options](benchmark::State& state) {
                                 const auto workload = read_real_scene(file);
                                 if (!workload) return skip_without_data(state, file);
                                 time_items_at_once(state, *workload, options);
                               })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_maps() {
  register_real_scenes<Waywright>("waywright");
  for (const std::string& file : real_scene_files()) {
    register_at_once(file, "waywright", kMeshOnly);
    register_at_once(file, "waywright_for_paths", {});
  }
}

}  // namespace waywright::bench
