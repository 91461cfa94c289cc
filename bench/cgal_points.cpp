#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "harness.hpp"
#include "point_benchmarks.hpp"
#include "registers.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

// Predicates are exact; points without segments need no constructions.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using HierarchyVertex = CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using HierarchyStructure =
    CGAL::Triangulation_data_structure_2<HierarchyVertex, CGAL::Triangulation_face_base_2<Kernel>>;
using Hierarchy = CGAL::Triangulation_hierarchy_2<CGAL::Delaunay_triangulation_2<Kernel, HierarchyStructure>>;

template <class Triangulation>
void insert_corners(Triangulation& triangulation, const Box& box) {
  for (const Point& corner : {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}}) {
    triangulation.insert(Kernel::Point_2(corner.x, corner.y));
  }
}

Kernel::Point_2 point_of(const Item& item) {
  const Point& point = item.shape.rings.front().front();
  return {point.x, point.y};
}

/// A contender for points without segments. It stores the vertex of each point.
template <class Triangulation, bool kStartsFromLast>
class CgalPoints {
 public:
  explicit CgalPoints(const Box& domain) { insert_corners(triangulation_, domain); }

  void insert(const Item& item) {
    const auto start = kStartsFromLast ? last_ : typename Triangulation::Face_handle();
    const auto vertex = triangulation_.insert(point_of(item), start);
    last_ = vertex->face();
    if (vertices_.size() <= item.id.value) vertices_.resize(2 * item.id.value + 1);
    vertices_[item.id.value] = vertex;
  }

  void update(const Update& update) {
    if (!update.removed.is_null()) triangulation_.remove(vertices_[update.removed.value]);
    if (!update.inserted.id.is_null()) insert(update.inserted);
  }

  [[nodiscard]] std::size_t vertex_count() const { return triangulation_.number_of_vertices(); }
  [[nodiscard]] std::string fault() const { return triangulation_.is_valid() ? "" : "is_valid() says no"; }

 private:
  Triangulation triangulation_;
  typename Triangulation::Face_handle last_;
  std::vector<typename Triangulation::Vertex_handle> vertices_;
};

using FromLast = CgalPoints<Delaunay, true>;
using WithHierarchy = CgalPoints<Hierarchy, false>;

void time_bulk(benchmark::State& state, const Workload& workload) {
  std::vector<Kernel::Point_2> points;
  for (const Update& update : workload.updates) points.push_back(point_of(update.inserted));
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      Delaunay triangulation;
      insert_corners(triangulation, workload.domain);
      state.ResumeTiming();
      triangulation.insert(points.begin(), points.end());
      state.PauseTiming();
      state.counters["vertices"] = static_cast<double>(triangulation.number_of_vertices());
    }
    state.ResumeTiming();
  }
  report_time_per_operation(state, points.size());
}

using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

void time_bulk_segments(benchmark::State& state, const Workload& workload) {
  std::vector<Kernel::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  for (const Update& update : workload.updates) {
    for (const Point& end : update.inserted.shape.rings.front()) points.emplace_back(end.x, end.y);
    segments.emplace_back(points.size() - 2, points.size() - 1);
  }
  for ([[maybe_unused]] const auto iteration : state) {
    state.PauseTiming();
    {
      Constrained triangulation;
      insert_corners(triangulation, workload.domain);
      state.ResumeTiming();
      triangulation.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
      state.PauseTiming();
      state.counters["vertices"] = static_cast<double>(triangulation.number_of_vertices());
    }
    state.ResumeTiming();
  }
  report_time_per_operation(state, segments.size());
}

void time_location(benchmark::State& state, const PointsToLocate& workload) {
  Hierarchy triangulation;
  insert_corners(triangulation, {{0.0, 0.0}, {1.0, 1.0}});
  std::vector<Kernel::Point_2> points;
  for (const Point& point : workload.points) points.emplace_back(point.x, point.y);
  triangulation.insert(points.begin(), points.end());
  for ([[maybe_unused]] const auto iteration : state) {
    for (const Point& target : workload.targets) {
      benchmark::DoNotOptimize(triangulation.locate(Kernel::Point_2(target.x, target.y)));
    }
  }
  report_time_per_operation(state, workload.targets.size());
  state.counters["vertices"] = static_cast<double>(triangulation.number_of_vertices());
}

}  // namespace

void register_cgal_points() {
  for (const std::size_t count : kThesisPointCounts) {
    register_updates<WithHierarchy>("thesis_points/" + std::to_string(count), "cgal_hierarchy",
                                    [count] { return thesis_points(count); });
  }
  for (const PointSize& size : point_sizes()) {
    const std::size_t count = size.count;
    register_updates<WithHierarchy>(size.name("random_points"), "cgal_hierarchy",
                                    [count] { return uniform_points(count); });
    register_updates<FromLast>(size.name("sorted_points"), "cgal", [count] { return sorted_points(count); });
    benchmark::RegisterBenchmark((size.name("bulk_points") + "/cgal").c_str(),
                                 [count](benchmark::State& state) { time_bulk(state, uniform_points(count)); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
    for (const LocationKind& kind : location_kinds()) {
      benchmark::RegisterBenchmark((size.name(kind.name) + "/cgal_hierarchy").c_str(),
                                   [kind, count](benchmark::State& state) { time_location(state, kind.make(count)); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
  for (const PointSize& row : lattice_rows()) {
    register_updates<FromLast>(row.name("lattice"), "cgal", [row] { return lattice_points(row.count); });
    benchmark::RegisterBenchmark((row.name("bulk_lattice") + "/cgal").c_str(),
                                 [row](benchmark::State& state) { time_bulk(state, lattice_points(row.count)); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark(
      ("bulk_segments/" + std::to_string(kSegmentCount) + "/cgal").c_str(),
      [](benchmark::State& state) { time_bulk_segments(state, disjoint_segments(kSegmentCount)); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  register_updates<FromLast>("point_removal/" + std::to_string(kRemovalCount), "cgal",
                             [] { return point_removal(kRemovalCount); });
}

}  // namespace waywright::bench
