#include <cstddef>
#include <cstdio>

#include "exact/geometry.hpp"
#include "thesis/interval_arithmetic.hpp"
#include "thesis/tables.hpp"
#include "thesis/triangulated.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

/// The library's geometry, which counts what its filter leaves open.
class CountingGeometry : public exact::Geometry {
 public:
  struct Questions {
    std::size_t asked = 0;
    std::size_t left_open = 0;
  };
  static Questions questions;

  [[nodiscard]] static exact::Sign orientation(const View& a, const View& b, const View& c) {
    count(exact::filter::orientation(a, b, c).has_value());
    return exact::Geometry::orientation(a, b, c);
  }
  [[nodiscard]] static exact::Sign in_circle(const View& a, const View& b, const View& c, const View& d) {
    count(exact::filter::in_circle(a, b, c, d).has_value());
    return exact::Geometry::in_circle(a, b, c, d);
  }

 private:
  static void count(bool is_answered) {
    ++questions.asked;
    questions.left_open += is_answered ? 0 : 1;
  }
};

CountingGeometry::Questions CountingGeometry::questions;

template <class Geometry>
void insert_all(const Workload& workload) {
  Triangulated<Geometry> triangulated(workload.domain);
  for (const Update& update : workload.updates) triangulated.update(update);
}

}  // namespace

void print_evaluations_table() {
  std::printf(
      "| constraints | interval + exact: asked | left to rationals | Waywright: asked | left to integers |\n"
      "| ---: | ---: | ---: | ---: | ---: |\n");
  for (std::size_t count = 100; count <= 1000; count += 100) {
    const Workload workload = random_segments(count);
    IntervalArithmetic::evaluations = {};
    insert_all<IntervalGeometry>(workload);
    const Evaluations rival = IntervalArithmetic::evaluations;
    CountingGeometry::questions = {};
    insert_all<CountingGeometry>(workload);
    const CountingGeometry::Questions ours = CountingGeometry::questions;
    std::printf("| %zu | %zu | %zu | %zu | %zu |\n", count, rival.interval, rival.exact, ours.asked, ours.left_open);
  }
}

}  // namespace waywright::bench
