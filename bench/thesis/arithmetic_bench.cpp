#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "harness.hpp"
#include "thesis/child_process.hpp"
#include "thesis/registers.hpp"
#include "thesis/triangulated.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

struct Run {
  double seconds = 0.0;  ///< for the updates
  MeshCounts counts;
  bool is_planar = false;
};

template <class Geometry>
Run run(const Workload& workload) {
  using Clock = std::chrono::steady_clock;
  const auto triangulated = triangulate<Geometry>(workload.domain);
  for (const Item& item : workload.before) triangulated->insert(item);
  const Clock::time_point begin = Clock::now();
  for (const Update& update : workload.updates) triangulated->update(update);
  const std::chrono::duration<double> time = Clock::now() - begin;
  return {time.count(), triangulated->counts(), triangulated->is_planar()};
}

/// Runs the workload twice. A new process has to request every page of its memory; the first run, which is not timed,
/// does this.
template <class Geometry>
Run run_warm(const Workload& workload) {
  static_cast<void>(run<Geometry>(workload));
  return run<Geometry>(workload);
}

/// A workload and the counts of its correct mesh. Both are computed when they are first needed.
class Case {
 public:
  explicit Case(std::function<Workload()> make) : make_(std::move(make)) {}

  const Workload& workload() {
    if (!workload_) workload_ = make_();
    return *workload_;
  }
  /// Returns the run with exact arithmetic.
  const Run& right() {
    if (!right_) right_ = run_warm<exact::Geometry>(workload());
    return *right_;
  }

 private:
  std::function<Workload()> make_;
  std::optional<Workload> workload_;
  std::optional<Run> right_;
};

/// The runs of one workload under one arithmetic.
template <class Geometry>
class Contender {
 public:
  /// `patience`: how many times longer than the exact run this contender may take.
  Contender(std::shared_ptr<Case> work, double patience) : work_(std::move(work)), patience_(patience) {}

  void operator()(benchmark::State& state) {
    const Workload& workload = work_->workload();
    for ([[maybe_unused]] const auto iteration : state) {
      const Run run = failure_.empty() ? run_once(workload) : Run{};
      if (!failure_.empty()) {
        state.SkipWithError(("failed: " + failure_).c_str());
        break;
      }
      state.SetIterationTime(run.seconds);
      state.counters["vertices"] = static_cast<double>(run.counts.vertices);
    }
    report_time_per_operation(state, workload.updates.size());
  }

 private:
  /// One run is enough for an arithmetic that fails: all runs are equal.
  Run run_once(const Workload& workload) {
    const double seconds = 1.0 + patience_ * work_->right().seconds;
    const auto outcome = run_in_child(seconds, [&] { return run_warm<Geometry>(workload); });
    if (!outcome.result) {
      failure_ = outcome.failure;
      return {};
    }
    if (outcome.result->counts != work_->right().counts) failure_ = "another mesh";
    if (!outcome.result->is_planar) failure_ = "faces turned over";
    return *outcome.result;
  }

  std::shared_ptr<Case> work_;
  double patience_;
  std::string failure_;
};

template <class Geometry>
void register_contender(const std::string& name, const std::shared_ptr<Case>& work, double patience) {
  const auto contender = std::make_shared<Contender<Geometry>>(work, patience);
  benchmark::RegisterBenchmark(name.c_str(), [contender](benchmark::State& state) { (*contender)(state); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

template <class Make>
void register_case(const std::string& workload, std::size_t size, Make make) {
  constexpr double kOfDoubles = 20.0;
  constexpr double kOfRationals = 1000.0;
  const auto work = std::make_shared<Case>([make, size] { return make(size); });
  const std::string name = workload + '/' + std::to_string(size) + '/';
  register_contender<exact::Geometry>(name + "waywright", work, kOfDoubles);
  register_contender<DoubleGeometry>(name + "double", work, kOfDoubles);
  register_contender<IntervalGeometry>(name + "interval_exact", work, kOfRationals);
  register_contender<RationalGeometry>(name + "rational", work, kOfRationals);
}

}  // namespace

void register_arithmetic() {
  for (std::size_t size = 1000; size <= 10000; size += 1000) register_case("points", size, thesis_points);
  register_case("uniform_points", 10000, uniform_points);
  for (std::size_t size = 1000; size <= 8000; size += 1000) register_case("short_segments", size, short_segments);
  for (std::size_t size = 100; size <= 400; size += 100) register_case("long_segments", size, long_segments);
  for (std::size_t size = 100; size <= 1000; size += 100) register_case("random_segments", size, random_segments);
  for (std::size_t size = 1000; size <= 8000; size += 1000) {
    register_case("moving_square_aligned", size,
                  [](std::size_t steps) { return moving_square(Rotation::none, steps); });
    register_case("moving_square_45", size, [](std::size_t steps) { return moving_square(Rotation::by_45, steps); });
  }
  register_case("rts", 20000, [](std::size_t steps) { return rts(Crowd::overlapping, steps); });
}

}  // namespace waywright::bench
