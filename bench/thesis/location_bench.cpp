#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "constraint/constrained_triangulation.hpp"
#include "harness.hpp"
#include "location_strategies.hpp"
#include "thesis/registers.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

using Triangulation = constraint::ConstrainedTriangulation::Triangulation;

constexpr std::size_t kQueryCount = 10000;

std::vector<Point> points_of(const Workload& workload) {
  std::vector<Point> points;
  for (const Update& update : workload.updates) points.push_back(update.inserted.shape.rings.front().front());
  return points;
}

/// Returns random whole points from the range of thesis_points(), but different ones.
std::vector<Point> queries() {
  const std::vector<Point> points = points_of(thesis_points(2 * kQueryCount));
  return {points.end() - kQueryCount, points.end()};
}

/// The library's own strategy: starts from the vertices that updates left in its sectors.
class OwnSectors {
 public:
  explicit OwnSectors(const Box&) {}
  locate::Located find(const Triangulation& triangulation, const Point& point) { return triangulation.locate(point); }
  void found(const Point&, mesh::HalfEdge) {}
};

/// One of the strategies of the thesis.
template <class Strategy>
class By {
 public:
  explicit By(const Box& box) : strategy_(make(box)) {}

  locate::Located find(const Triangulation& triangulation, const Point& point) {
    const Ground<exact::Geometry> ground{triangulation.topology(), triangulation.geometry(), triangulation.ghost()};
    return locate_by(strategy_, ground, point);
  }
  void found(const Point& point, mesh::HalfEdge h) { strategy_.found(point, h); }

 private:
  static Strategy make(const Box& box) {
    if constexpr (std::is_constructible_v<Strategy, Box>) {
      return Strategy(box);
    } else {
      return Strategy();
    }
  }

  Strategy strategy_;
};

template <class Method>
void insert_all(Triangulation& triangulation, Method& method, const std::vector<Point>& points) {
  for (const Point& point : points) {
    triangulation.begin();
    const auto inserted = triangulation.insert(point, method.find(triangulation, point));
    method.found(point, triangulation.topology().outgoing(inserted.vertex));
  }
}

/// Measures the wall time of one call of `job`.
template <class Job>
void time_once(benchmark::State& state, std::size_t operation_count, Job job) {
  for ([[maybe_unused]] const auto iteration : state) state.SetIterationTime(job());
  report_time_per_operation(state, operation_count);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class Method>
void time_insertion(benchmark::State& state, std::size_t count) {
  const Workload workload = thesis_points(count);
  const std::vector<Point> points = points_of(workload);
  time_once(state, count, [&] {
    Triangulation triangulation(workload.domain, {1, 2, 3, 4});
    Method method(workload.domain);
    const auto begin = std::chrono::steady_clock::now();
    insert_all(triangulation, method, points);
    const double seconds = seconds_since(begin);
    state.counters["vertices"] = static_cast<double>(triangulation.topology().vertex_count() - 1);
    return seconds;
  });
}

template <class Method>
void time_location(benchmark::State& state, std::size_t count) {
  const Workload workload = thesis_points(count);
  Triangulation triangulation(workload.domain, {1, 2, 3, 4});
  for (const Point& point : points_of(workload)) triangulation.insert(point);
  const std::vector<Point> points = queries();
  time_once(state, points.size(), [&] {
    Method method(workload.domain);
    const auto begin = std::chrono::steady_clock::now();
    for (const Point& located : points) benchmark::DoNotOptimize(method.find(triangulation, located));
    return seconds_since(begin);
  });
  state.counters["vertices"] = static_cast<double>(triangulation.topology().vertex_count() - 1);
}

template <class Method>
void register_method(const std::string& contender, std::size_t count) {
  const auto add = [&](const std::string& workload, void (*run)(benchmark::State&, std::size_t)) {
    const std::string name = workload + '/' + std::to_string(count) + '/' + contender;
    benchmark::RegisterBenchmark(name.c_str(), [run, count](benchmark::State& state) { run(state, count); })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  add("location", time_location<Method>);
  add("insertion", time_insertion<Method>);
}

}  // namespace

void register_location() {
  for (std::size_t count = 1000; count <= 10000; count += 1000) {
    register_method<OwnSectors>("waywright", count);
    register_method<By<LastFace>>("last_face", count);
    register_method<By<CubeRootSampling>>("cube_root", count);
    register_method<By<SectorsOfSearches>>("sectors_16", count);
  }
}

}  // namespace waywright::bench
