#include "support/path_scene_check.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "oracle/first_wall.hpp"
#include "oracle/oracle.hpp"
#include "oracle/shortest_paths.hpp"
#include "support/oracle_adapter.hpp"
#include "support/point_text.hpp"
#include "support/scene_check.hpp"

namespace waywright::test {
namespace {

using Fault = std::optional<std::string>;

PathStatus status_of(oracle::OracleStatus status) {
  switch (status) {
    case oracle::OracleStatus::found:
      return PathStatus::found;
    case oracle::OracleStatus::start_blocked:
      return PathStatus::start_blocked;
    case oracle::OracleStatus::goal_blocked:
      return PathStatus::goal_blocked;
    case oracle::OracleStatus::no_path:
      break;
  }
  return PathStatus::no_path;
}

std::vector<oracle::OracleRay> rays_of(const PathCase& path_case) {
  std::vector<oracle::OracleRay> rays;
  for (const Ends& query : path_case.queries) {
    rays.push_back({oracle::to_oracle(query.start), oracle::to_oracle(query.goal)});
  }
  return rays;
}

double polyline_length(const std::vector<Point>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

/// Returns by how much lengths may differ due to rounding: 1e-9 of the length, and the rounding of the corners'
/// coordinates.
double tolerance(const Path& path, double length) {
  double largest = 0.0;
  for (const Point& p : path.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return 1e-9 * length + 0x1p-50 * largest;
}

class PathCaseCheck {
 public:
  PathCaseCheck(const PathCase& path_case, const PathFinder& find)
      : path_case_(path_case),
        find_(find),
        oracle_(oracle::to_oracle(path_case.scene)),
        shortest_(oracle::to_oracle(path_case.scene), oracle_ends(path_case)) {}

  PathReport run() {
    report_.fault = first_fault();
    return std::move(report_);
  }

 private:
  Fault first_fault() {
    Result<World> world = World::create(path_case_.scene.domain);
    if (!world) return "create: " + world.error().message();
    for (const Item& item : path_case_.scene.items) {
      if (const auto inserted = world->insert(item.shape, item.id); !inserted) return inserted.error().message();
    }
    report_.vertices = world->vertex_count();
    const auto first_walls = oracle::first_walls(oracle::to_oracle(path_case_.scene), rays_of(path_case_));
    for (const Ends& ends : path_case_.queries) {
      if (const Fault fault = check_ray(*world, ends, first_walls[report_.failed_query])) {
        report_.line = "ray " + text_of(ends.start) + " " + text_of(ends.goal);
        return report_.line + ": " + *fault;
      }
      const auto shortest = shortest_.between(oracle::to_oracle(ends.start), oracle::to_oracle(ends.goal));
      for (std::size_t i = 0; i < kPathAlgorithms.size(); ++i) {
        PathQuery query{ends.start, ends.goal, 0.0, kPathAlgorithms[i]};
        query.end_tolerance = 0.0;  // the oracle does not move ends
        ++report_.queries;
        if (const Fault fault = check_query(*world, query, shortest, report_.ratios[i])) {
          report_.line = "path " + text_of(query.start) + " " + text_of(query.goal) + " 0 " +
                         std::string(to_string(query.algorithm));
          return report_.line + ": " + *fault;
        }
      }
      ++report_.failed_query;
    }
    return std::nullopt;
  }

  Fault check_ray(const World& world, const Ends& ends, const oracle::OracleHit& expected) {
    const Result<void> done = world.ray(ends.start, ends.goal, {}, context_, hit_);
    if (!done) return done.error().message();
    std::vector<std::uint64_t> ids;
    for (const ItemId id : hit_.items) ids.push_back(id.value);
    if (hit_.hit != expected.hit) return "a hit where there is none, or none where there is";
    if (oracle::to_oracle(hit_.at) != expected.at) {
      return "hits at " + text_of(hit_.at) + " instead of " + text_of({expected.at.x, expected.at.y});
    }
    if (ids != expected.ids) return "hits the wrong items";
    return std::nullopt;
  }

  Fault check_query(const World& world, const PathQuery& query, const oracle::ShortestPath& shortest,
                    PathRatios& ratios) {
    if (const Result<void> done = find_(world, query, context_, path_); !done) return done.error().message();
    const PathStatus expected = status_of(shortest.status);
    if (path_.status != expected) {
      return std::string(to_string(path_.status)) + " instead of " + std::string(to_string(expected));
    }
    if (path_.status != PathStatus::found) {
      if (!path_.points.empty() || path_.length != 0.0) return "a path although there is none";
      return std::nullopt;
    }
    if (path_.points.empty() || path_.points.front() != query.start || path_.points.back() != query.goal) {
      return "the path does not lead from start to goal";
    }
    const double length = polyline_length(path_.points);
    const double slack = tolerance(path_, length);
    if (std::fabs(path_.length - length) > slack) return "the length is not that of the points";
    if (const Fault fault = oracle_.check_path(oracle::to_oracle(path_.points))) return fault;
    const std::string lengths = std::to_string(path_.length) + ", the shortest is " + std::to_string(shortest.length);
    if (path_.length < shortest.length - slack) return "the path is too short to be true: " + lengths;
    if (path_.lower_bound > shortest.length + slack) return "the lower bound is above the shortest: " + lengths;
    if (query.algorithm == PathAlgorithm::optimal && path_.length > shortest.length + slack) {
      return "the path is not the shortest: " + lengths;
    }
    if (shortest.length > 0.0) {
      const double ratio = path_.length / shortest.length;
      ratios += {1, ratio, ratio};
    }
    return std::nullopt;
  }

  const PathCase& path_case_;
  const PathFinder& find_;
  oracle::Oracle oracle_;
  oracle::ShortestPaths shortest_;
  QueryContext context_;
  Path path_;
  RayHit hit_;
  PathReport report_;
};

}  // namespace

PathRatios& PathRatios::operator+=(const PathRatios& other) {
  count += other.count;
  sum += other.sum;
  worst = std::max(worst, other.worst);
  return *this;
}

std::vector<oracle::OraclePoint> oracle_ends(const PathCase& path_case) {
  std::vector<oracle::OraclePoint> ends;
  for (const Ends& query : path_case.queries) {
    ends.push_back(oracle::to_oracle(query.start));
    ends.push_back(oracle::to_oracle(query.goal));
  }
  return ends;
}

PathFinder world_finder() {
  return [](const World& world, const PathQuery& query, QueryContext& context, Path& path) {
    return world.find_path(query, context, path);
  };
}

PathReport check_paths(const PathCase& path_case, const PathFinder& find) {
  return PathCaseCheck(path_case, find).run();
}

std::string report_failure(const PathCase& path_case, const std::string& name, const PathFinder& find) {
  const std::size_t failed = check_paths(path_case, find).failed_query;
  const std::vector<Ends> query{path_case.queries.at(failed)};
  const Scene small = shrink(path_case.scene, [&](const Scene& less) {
    return SceneReport{check_paths({less, query}, find).fault, 0, 0};
  });
  const PathReport report = check_paths({small, query}, find);
  const std::string script = to_script(small) + report.line + "\n";
  const auto file = std::filesystem::temp_directory_path() / ("waywright-" + name + ".wws");
  std::ofstream(file, std::ios::binary) << script;
  return name + ": " + report.fault.value_or("fails in company only") + "\nshrunk to " +
         std::to_string(small.items.size()) + " items, " + file.string() + ":\n" + script;
}

}  // namespace waywright::test
