#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "exact/geometry.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/tables.hpp"
#include "thesis/triangulated.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

template <class Geometry>
void insert_all(const Workload& workload) {
  Triangulated<Geometry> triangulated(workload.domain);
  for (const Update& update : workload.updates) triangulated.update(update);
}

}  // namespace

void print_evaluations_table() {
  std::printf("| constraints | interval | of them exact |\n| ---: | ---: | ---: |\n");
  for (std::size_t count = 100; count <= 1000; count += 100) {
    const Workload workload = random_segments(count);
    IntervalArithmetic::evaluations = {};
    insert_all<IntervalGeometry>(workload);
    const Evaluations evaluations = IntervalArithmetic::evaluations;
    std::printf("| %zu | %llu | %llu |\n", count, static_cast<unsigned long long>(evaluations.interval),
                static_cast<unsigned long long>(evaluations.exact));
  }
}

}  // namespace waywright::bench
