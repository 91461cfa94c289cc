#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/path.hpp"
#include "waywright/world.hpp"

#include "oracle/adapter.hpp"
#include "oracle/oracle.hpp"
#include "support/point_text.hpp"
#include "support/random.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

using Fault = std::optional<std::string>;

constexpr std::size_t kQueries = 8;

/// A corner of an item a third of the time, so that paths start and end on walls.
Point query_end(const Scene& scene, Flavour flavour, Random& random) {
  if (scene.items.empty() || random.chance(67)) return random_point(flavour, scene.domain, random);
  const auto& rings = scene.items[random.below(scene.items.size())].shape.rings;
  const auto& ring = rings[random.below(rings.size())];
  return ring[random.below(ring.size())];
}

PathStatus expected_status(const oracle::Oracle& oracle, std::string_view dump, const PathQuery& query) {
  const oracle::OraclePoint start = oracle::to_oracle(query.start);
  const oracle::OraclePoint goal = oracle::to_oracle(query.goal);
  if (oracle.strictly_inside(start)) return PathStatus::start_blocked;
  if (oracle.strictly_inside(goal)) return PathStatus::goal_blocked;
  return oracle.connected(dump, start, goal) ? PathStatus::found : PathStatus::no_path;
}

double length_of(const std::vector<Point>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

Fault path_fault(const oracle::Oracle& oracle, std::string_view dump, const PathQuery& query, const Path& path) {
  const PathStatus expected = expected_status(oracle, dump, query);
  if (path.status != expected) {
    return std::string(to_string(path.status)) + " instead of " + std::string(to_string(expected));
  }
  if (path.status != PathStatus::found) {
    if (!path.points.empty() || path.length != 0.0) return "a path although there is none";
    return std::nullopt;
  }
  if (path.points.empty() || path.points.front() != query.start || path.points.back() != query.goal) {
    return "the path does not lead from start to goal";
  }
  const double length = length_of(path.points);
  if (std::fabs(path.length - length) > 1e-12 * length) return "the length is not that of the points";
  return oracle.check_path(oracle::to_oracle(path.points));
}

}  // namespace

SceneReport check_paths(const Scene& scene, Flavour flavour, std::uint64_t seed) {
  SceneReport report;
  Result<World> world = World::create(scene.domain);
  if (!world) return {"create: " + world.error().message, 0, 0};
  for (const Item& item : scene.items) {
    ++report.operations;
    if (const auto inserted = world->insert(item.shape, item.id); !inserted) return {inserted.error().message, 0, 0};
  }
  report.vertices = world->vertex_count();
  const oracle::Oracle oracle(oracle::to_oracle(scene));
  const std::string dump = world->dump();
  report.fault = oracle.check_dump(dump);
  Random random(seed);
  QueryContext context;
  Path path;
  for (std::size_t i = 0; i < kQueries && !report.fault; ++i) {
    ++report.operations;
    const PathQuery query{query_end(scene, flavour, random), query_end(scene, flavour, random), 0.0, PathAlgorithm::ta};
    const Result<void> done = world->find_path(query, context, path);
    report.fault = done ? path_fault(oracle, dump, query, path) : Fault(done.error().message);
    if (report.fault) {
      report.fault = "path " + text_of(query.start) + " " + text_of(query.goal) + " 0 ta: " + *report.fault;
    }
  }
  return report;
}

}  // namespace waywright::test
