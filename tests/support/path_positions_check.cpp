#include "support/path_positions_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "waywright/query_context.hpp"
#include "waywright/world.hpp"

#include "support/path_scene_check.hpp"
#include "support/point_text.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

double length_of(const std::vector<Point>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
  }
  return length;
}

/// Who computes a position on a path, and in which arithmetic.
enum class Maker { path_double, path_float, program_double, program_float };
constexpr std::array kMakers{Maker::path_double, Maker::path_float, Maker::program_double, Maker::program_float};

class PathPositionsCheck {
 public:
  PathPositionsCheck(const PathCase& path_case, std::size_t positions_per_path, bool has_solids_only)
      : path_case_(path_case),
        positions_per_path_(positions_per_path),
        has_solids_only_(has_solids_only),
        random_(path_case.scene.items.size() * 7919 + path_case.queries.size()),
        size_(path_case.scene.domain.max.x - path_case.scene.domain.min.x) {}

  PathPositionsReport run() {
    World world = World::create(path_case_.scene.domain).value();
    for (const Item& item : path_case_.scene.items) world.insert(item.shape, item.id).value();
    for (const Ends& ends : path_case_.queries) {
      for (const PathAlgorithm algorithm : kPathAlgorithms) {
        const PathQuery query{.start = ends.start, .goal = ends.goal, .algorithm = algorithm};
        if (auto done = world.find_path(query, context_, path_); !done) return failed(done.error().message());
        if (path_.status != PathStatus::found || path_.length == 0.0) continue;
        ++report_.paths;
        for (std::size_t i = 0; i < positions_per_path_; ++i) {
          if (report_.fault = check_position(world, query); report_.fault) return report_;
        }
      }
    }
    return report_;
  }

 private:
  PathPositionsReport failed(std::string fault) {
    report_.fault = std::move(fault);
    return report_;
  }

  std::optional<std::string> check_position(const World& world, const PathQuery& query) {
    const double share = static_cast<double>(random_.below(1U << 30)) * 0x1p-30;
    const PathPosition position = path_.at(share * path_.length);
    const Maker maker = kMakers[random_.below(kMakers.size())];
    const Point start = point_of(position, maker);
    ++report_.positions;
    PathQuery again = query;
    again.start = start;
    if (auto done = world.find_path(again, context_, answer_); !done) return done.error().message();
    const std::string text = std::string(to_string(query.algorithm)) + " from " + text_of(query.start) + " to " +
                             text_of(query.goal) + ", again from " + text_of(start);
    if (answer_.status != PathStatus::found) return text + ": " + std::string(to_string(answer_.status));
    if (answer_.moved_start) ++report_.moved;
    const bool is_own = maker == Maker::program_double || maker == Maker::program_float;
    if (is_own && !has_solids_only_) return std::nullopt;
    if (query.algorithm != PathAlgorithm::optimal) return std::nullopt;
    const double excess = (answer_.length - (path_.length - position.distance)) / size_;
    report_.worst = std::max(report_.worst, excess);
    const bool is_float = maker == Maker::path_float || maker == Maker::program_float;
    if (excess > (is_float ? 0x1p-20 : 0x1p-44)) {
      return text + ": longer by " + std::to_string(excess * size_) + " than what was left of the path, of length " +
             std::to_string(length_of(path_.points));
    }
    return std::nullopt;
  }

  /// Computes a position as a program does that knows only the path's points.
  template <class Number>
  [[nodiscard]] Point interpolated(const PathPosition& position) const {
    const Point& a = path_.points[position.segment];
    const Point& b = path_.points[std::min(position.segment + 1, path_.points.size() - 1)];
    const auto length = static_cast<Number>(std::hypot(b.x - a.x, b.y - a.y));
    if (length == Number{0}) return a;
    const Number share = static_cast<Number>(position.distance - position.before) / length;
    const auto between = [&](double from, double to) {
      const auto start = static_cast<Number>(from);
      return static_cast<double>(start + share * (static_cast<Number>(to) - start));
    };
    return {between(a.x, b.x), between(a.y, b.y)};
  }

  [[nodiscard]] Point point_of(const PathPosition& position, Maker maker) const {
    switch (maker) {
      case Maker::path_double:
        return position.at;
      case Maker::path_float:
        return path_.at(position.distance, Precision::float32).at;
      case Maker::program_double:
        return interpolated<double>(position);
      case Maker::program_float:
        break;
    }
    return interpolated<float>(position);
  }

  const PathCase& path_case_;
  std::size_t positions_per_path_;
  bool has_solids_only_;
  Random random_;
  double size_;
  QueryContext context_;
  Path path_;
  Path answer_;
  PathPositionsReport report_;
};

}  // namespace

PathPositionsReport check_path_positions(const PathCase& path_case, std::size_t positions_per_path,
                                         bool has_solids_only) {
  return PathPositionsCheck(path_case, positions_per_path, has_solids_only).run();
}

}  // namespace waywright::test
