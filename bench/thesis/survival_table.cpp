#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

#include "exact/geometry.hpp"
#include "random.hpp"
#include "thesis/child_process.hpp"
#include "thesis/tables.hpp"
#include "thesis/triangulated.hpp"
#include "workloads.hpp"

namespace waywright::bench {
namespace {

/// Returns 40 random segments between the points of a 13 x 13 lattice, and then the removal of every other one. Many of
/// them run through one point, overlap, or end on another.
Workload lattice_scene(std::uint64_t seed) {
  constexpr std::int64_t kSide = 12;
  constexpr std::size_t kCount = 40;
  Random random(seed);
  const auto random_point = [&] {
    const double x = random.between(0, kSide);
    return Point{x, random.between(0, kSide)};
  };
  Workload workload{{{-1.0, -1.0}, {kSide + 1.0, kSide + 1.0}}, {}, {}};
  for (std::size_t id = 1; id <= kCount; ++id) {
    const Point from = random_point();
    workload.updates.push_back({{}, {ItemId{id}, {ItemKind::segment, {{from, random_point()}}}}});
  }
  for (std::size_t id = 1; id <= kCount; id += 2) workload.updates.push_back({ItemId{id}, {}});
  return workload;
}

struct Result {
  MeshCounts before_removal;
  MeshCounts at_end;
  bool is_planar = false;
};

template <class Geometry>
Result run(const Workload& workload) {
  const auto triangulated = triangulate<Geometry>(workload.domain);
  Result result;
  bool was_planar = true;
  for (const Update& update : workload.updates) {
    if (!update.removed.is_null() && result.before_removal.vertices == 0) {
      result.before_removal = triangulated->counts();
      was_planar = triangulated->is_planar();
    }
    triangulated->update(update);
  }
  result.at_end = triangulated->counts();
  result.is_planar = was_planar && triangulated->is_planar();
  return result;
}

template <class Geometry>
std::string outcome_of(const Workload& workload, const Result& right) {
  constexpr double kSeconds = 1.0;  // the correct mesh takes less than a thousandth of this
  const auto outcome = run_in_child(kSeconds, [&] { return run<Geometry>(workload); });
  if (!outcome.result) return outcome.failure;
  const Result& result = *outcome.result;
  if (!result.is_planar) return "faces turned over";
  const bool is_right = result.before_removal == right.before_removal && result.at_end == right.at_end;
  return is_right ? "right" : "another mesh";
}

template <class Geometry>
void print_outcomes(const char* name, std::size_t scenes) {
  std::map<std::string, std::size_t> outcomes;
  for (std::size_t seed = 1; seed <= scenes; ++seed) {
    const Workload workload = lattice_scene(seed);
    ++outcomes[outcome_of<Geometry>(workload, run<exact::Geometry>(workload))];
  }
  std::printf("| %s | %zu |", name, outcomes["right"]);
  const char* separator = " ";
  for (const auto& [how, count] : outcomes) {
    if (how == "right") continue;
    std::printf("%s%zu %s", separator, count, how.c_str());
    separator = ", ";
  }
  std::printf(" |\n");
  std::fflush(stdout);
}

}  // namespace

void print_survival_table(std::size_t scenes) {
  std::printf("| arithmetic | right meshes of %zu | faults in the other scenes |\n| --- | ---: | --- |\n", scenes);
  print_outcomes<DoubleGeometry>("double", scenes);
  print_outcomes<IntervalGeometry>("interval + exact", scenes);
  print_outcomes<RationalGeometry>("rationals", scenes);
  print_outcomes<exact::Geometry>("Waywright", scenes);
}

}  // namespace waywright::bench
