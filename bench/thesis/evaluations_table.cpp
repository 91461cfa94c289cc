#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "waywright/predicate_counts.hpp"

#include "exact/geometry.hpp"
#include "exact/position.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/tables.hpp"
#include "thesis/triangulated.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

template <class Geometry>
void insert_all(const Workload& workload) {
  const auto triangulated = triangulate<Geometry>(workload.domain);
  for (const Update& update : workload.updates) triangulated->update(update);
}

}  // namespace

void print_evaluations_table() {
  std::printf(
      "| constraints | interval + exact: evaluated with intervals | evaluated with rationals | "
      "Waywright: decided in doubles | in integers of fixed width | in integers of any width |\n"
      "| ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (std::size_t count = 100; count <= 1000; count += 100) {
    const Workload workload = random_segments(count);
    IntervalArithmetic::evaluations = {};
    insert_all<IntervalGeometry>(workload);
    const Evaluations rival = IntervalArithmetic::evaluations;
    exact::counts = {};
    insert_all<exact::Geometry>(workload);
    const PredicateCounts ours = exact::counts;
    const auto both = [&](std::uint64_t StageCounts::*stage) {
      return static_cast<std::size_t>(ours.orientation.*stage + ours.in_circle.*stage);
    };
    std::printf("| %zu | %zu | %zu | %zu | %zu | %zu |\n", count, rival.interval, rival.exact,
                both(&StageCounts::doubles), both(&StageCounts::lattice), both(&StageCounts::integers));
  }
}

}  // namespace waywright::bench
