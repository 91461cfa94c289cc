#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "harness.hpp"
#include "real_scenes.hpp"
#include "workloads.hpp"

namespace waywright::bench {

/// Registers experiment 5 for a contender.
template <class Contender>
void register_segments(const std::string& contender) {
  for (const std::size_t count : {1000U, 8000U}) {
    const std::string size = '/' + std::to_string(count);
    register_updates<Contender>("short_segments" + size, contender, [count] { return short_segments(count); });
  }
  for (const std::size_t count : {100U, 400U}) {
    const std::string size = '/' + std::to_string(count);
    register_updates<Contender>("long_segments" + size, contender, [count] { return long_segments(count); });
  }
  for (const std::size_t count : {100U, 1000U}) {
    const std::string size = '/' + std::to_string(count);
    register_updates<Contender>("random_segments" + size, contender, [count] { return random_segments(count); });
  }
}

/// Registers experiment 6 for a contender.
template <class Contender>
void register_moving_square(const std::string& contender) {
  for (const std::size_t steps : {1000U, 8000U}) {
    const std::string size = '/' + std::to_string(steps);
    register_updates<Contender>("moving_square_aligned" + size, contender,
                                [steps] { return moving_square(Rotation::none, steps); });
    register_updates<Contender>("moving_square_45" + size, contender,
                                [steps] { return moving_square(Rotation::by_45, steps); });
    register_updates<Contender>("moving_square_30" + size, contender,
                                [steps] { return moving_square(Rotation::by_30, steps); });
  }
}

/// Registers the benchmarks in which polygons are inserted and removed.
template <class Contender>
void register_rts(const std::string& contender) {
  constexpr std::size_t kSteps = 20000;
  const std::string size = '/' + std::to_string(kSteps);
  register_updates<Contender>("rts" + size, contender, [] { return rts(Crowd::overlapping, kSteps); });
  register_updates<Contender>("rts_sparse" + size, contender, [] { return rts(Crowd::sparse, kSteps); });
  register_updates<Contender>("rts_disjoint" + size, contender, [] { return rts(Crowd::disjoint, kSteps); });
}

/// Registers the benchmarks that build real scenes item by item.
template <class Contender>
void register_real_scenes(const std::string& contender) {
  for (const std::string& file : real_scene_files()) {
    const std::string name = "map/" + file.substr(file.rfind('/') + 1) + '/' + contender;
    benchmark::RegisterBenchmark(name.c_str(),
                                 [file, is_checked = std::make_shared<bool>(false)](benchmark::State& state) {
                                   const auto workload = read_real_scene(file);
                                   if (!workload) return skip_without_data(state, file);
                                   time_updates<Contender>(state, *workload, *is_checked);
                                 })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace waywright::bench
