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
  Triangulated<Geometry> triangulated(workload.domain);
  for (const Item& item : workload.before) triangulated.insert(item);
  const Clock::time_point begin = Clock::now();
  for (const Update& update : workload.updates) triangulated.update(update);
  const std::chrono::duration<double> time = Clock::now() - begin;
  return {time.count(), triangulated.counts(), triangulated.is_planar()};
}

/// A new process has to ask for every page of its memory; the first run pays for that, off the clock.
template <class Geometry>
Run run_warm(const Workload& workload) {
  static_cast<void>(run<Geometry>(workload));
  return run<Geometry>(workload);
}

/// A workload, made when it is first asked for, and what its mesh must have.
class Case {
 public:
  explicit Case(std::function<Workload()> make) : make_(std::move(make)) {}

  const Workload& workload() {
    prepare();
    return *workload_;
  }
  const MeshCounts& counts() {
    prepare();
    return counts_;
  }

 private:
  void prepare() {
    if (workload_) return;
    workload_ = make_();
    counts_ = run<exact::Geometry>(*workload_).counts;
  }

  std::function<Workload()> make_;
  std::optional<Workload> workload_;
  MeshCounts counts_;
};

/// What is wrong with how a run ended, or nothing.
std::string failure_of(const Outcome<Run>& outcome, const MeshCounts& counts) {
  if (!outcome.result) return outcome.failure;
  if (outcome.result->counts != counts) return "another mesh";
  return outcome.result->is_planar ? std::string() : "faces turned over";
}

template <class Geometry>
void time_in_child(benchmark::State& state, Case& work) {
  const Workload& workload = work.workload();
  for ([[maybe_unused]] const auto iteration : state) {
    const auto outcome = run_in_child([&] { return run_warm<Geometry>(workload); });
    const std::string failure = failure_of(outcome, work.counts());
    if (!failure.empty()) {
      state.SkipWithError(("failed: " + failure).c_str());
      break;
    }
    state.SetIterationTime(outcome.result->seconds);
    state.counters["vertices"] = static_cast<double>(outcome.result->counts.vertices);
  }
  report_time_per_operation(state, workload.updates.size());
}

template <class Geometry>
void register_contender(const std::string& name, const std::shared_ptr<Case>& work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) { time_in_child<Geometry>(state, *work); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

template <class Make>
void register_case(const std::string& workload, std::size_t size, Make make) {
  const auto work = std::make_shared<Case>([make, size] { return make(size); });
  const std::string name = workload + '/' + std::to_string(size) + '/';
  register_contender<exact::Geometry>(name + "waywright", work);
  register_contender<DoubleGeometry>(name + "double", work);
  register_contender<TunedDoubleGeometry>(name + "double_tuned", work);
  register_contender<IntervalGeometry>(name + "interval_exact", work);
  register_contender<RationalGeometry>(name + "rational", work);
}

}  // namespace

void register_arithmetic() {
  for (std::size_t size = 1000; size <= 10000; size += 1000) register_case("points", size, thesis_points);
  for (std::size_t size = 1000; size <= 8000; size += 1000) register_case("short_segments", size, short_segments);
  for (std::size_t size = 100; size <= 400; size += 100) register_case("long_segments", size, long_segments);
  for (std::size_t size = 100; size <= 1000; size += 100) register_case("random_segments", size, random_segments);
  for (std::size_t size = 1000; size <= 8000; size += 1000) {
    register_case("moving_square_aligned", size, [](std::size_t steps) { return moving_square(Turn::none, steps); });
    register_case("moving_square_45", size, [](std::size_t steps) { return moving_square(Turn::by_45, steps); });
  }
  register_case("rts", 20000, [](std::size_t steps) { return rts(false, steps); });
}

}  // namespace waywright::bench
