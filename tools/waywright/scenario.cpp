#include "waywright/scenario.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "waywright/path.hpp"
#include "waywright/scene.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "file_names.hpp"
#include "input.hpp"
#include "output.hpp"
#include "picture.hpp"
#include "progress.hpp"

namespace waywright::command {

namespace {

/// The comparison of an answer with the length that the scenario gives.
enum class Verdict : unsigned char { same, shorter, longer, missing, surprising };

struct Answer {
  PathStatus status = PathStatus::no_path;
  double length = 0.0;
  std::size_t expansions = 0;
  double microseconds = 0.0;
  Verdict verdict = Verdict::same;
};

double ratio_of(const ScenarioQuery& query, const Answer& answer) {
  return query.length > 0.0 ? answer.length / query.length : 1.0;
}

/// The number of answers with a status, for a line of the summary.
struct StatusCount {
  PathStatus status = PathStatus::found;
  const char* name = nullptr;
};

constexpr std::array<StatusCount, 4> kDiscCounts{{{PathStatus::found, "path found"},
                                                  {PathStatus::no_path, "no path"},
                                                  {PathStatus::start_blocked, "start blocked"},
                                                  {PathStatus::goal_blocked, "goal blocked"}}};

/// Two lengths are the same if they differ by no more than the precision of the given length plus the rounding errors
/// of doubles.
Verdict verdict_of(const ScenarioQuery& query, const Path& path) {
  const bool is_found = path.status == PathStatus::found;
  if (query.length < 0.0) return is_found ? Verdict::surprising : Verdict::same;
  if (!is_found) return Verdict::missing;
  if (std::fabs(path.length - query.length) <= 1e-9 * query.length + query.precision) return Verdict::same;
  return path.length < query.length ? Verdict::shorter : Verdict::longer;
}

/// Returns whether two blocked tiles of a map touch only at this point. An agent at this point may count as being in
/// either of the two free areas there. So the length in a scenario may be the length of a path from the other area.
bool is_between_tiles(const World& world, const Point& point, QueryContext& context) {
  if (std::floor(point.x) != point.x || std::floor(point.y) != point.y) return false;
  const auto is_blocked = [&](double dx, double dy) {
    Location location;
    const Result<void> done = world.locate({point.x + dx, point.y + dy}, context, location);
    return done.ok() && !location.polygons.empty();
  };
  const bool low = is_blocked(-0.5, -0.5);
  const bool right = is_blocked(0.5, -0.5);
  return low != right && is_blocked(0.5, 0.5) == low && is_blocked(-0.5, 0.5) == right;
}

std::vector<ScenarioQuery> load_scenario(const std::string& name) {
  Result<std::vector<ScenarioQuery>> queries = parse_movingai_scenario(read_text(name), name);
  if (!queries.ok()) throw Failure(queries.error().message());
  return std::move(queries).value();
}

/// Returns the name of a map without folders and without ending, because the same map may be in another format. A
/// scenario may come from a system with other separators.
std::string_view stem_of(std::string_view name) {
  name.remove_prefix(std::min(name.find_last_of("/\\") + 1, name.size()));
  return name.substr(0, name.rfind('.'));
}

/// Throws Failure if a query is for another map.
void check_map(const ScenarioOptions& options, const Scene& scene, const std::vector<ScenarioQuery>& queries) {
  constexpr std::string_view kAdvice = "; give that map, or add --any-map to carry out these queries, too";
  if (options.any_map) return;
  for (const ScenarioQuery& query : queries) {
    if (options.map != "-" && stem_of(query.map) != stem_of(options.map)) {
      throw Failure(fmt::format("{}:{}: the query is for the map '{}', and the map given is '{}'{}", options.scenario,
                                query.line, query.map, title_of(options.map), kAdvice));
    }
    const Point size = scene.domain.max;
    const bool counts_tiles = scene.y_down;  // only such a map measures its size in tiles
    if (counts_tiles && (static_cast<double>(query.width) != size.x || static_cast<double>(query.height) != size.y)) {
      throw Failure(fmt::format("{}:{}: the query is for a map of {} x {} tiles, and {} has {} x {}{}",
                                options.scenario, query.line, query.width, query.height, title_of(options.map), size.x,
                                size.y, kAdvice));
    }
  }
}

/// Returns whether the ends of the queries can be tiles of the map: whole numbers below its width and height.
bool are_tiles(const Scene& scene, const std::vector<ScenarioQuery>& queries) {
  const bool counts_tiles = scene.y_down;  // only such a map has tiles
  const auto is_tile = [&](const Point& end) {
    return std::floor(end.x) == end.x && std::floor(end.y) == end.y && end.x < scene.domain.max.x &&
           end.y < scene.domain.max.y;
  };
  return counts_tiles && std::all_of(queries.begin(), queries.end(), [&](const ScenarioQuery& query) {
           return is_tile(query.start) && is_tile(query.goal);
         });
}

/// Moves each end from the first corner of its tile to the centre of the tile.
void move_to_centres(std::vector<ScenarioQuery>& queries) {
  for (ScenarioQuery& query : queries) {
    for (Point* const end : {&query.start, &query.goal}) *end = {end->x + 0.5, end->y + 0.5};
  }
}

/// Returns the indices of the queries to draw. Throws Failure.
std::vector<std::size_t> chosen_queries(const ScenarioOptions& options, std::size_t count) {
  if (options.svg.empty() != options.queries.empty()) {
    throw Failure("waywright: --svg and --query go together: the file, and the queries to draw");
  }
  std::vector<std::size_t> chosen;
  for (const std::size_t number : options.queries) {
    if (number < 1 || number > count) {
      throw Failure(
          fmt::format("waywright: --query {}: the queries of {} are 1 to {}", number, options.scenario, count));
    }
    chosen.push_back(number - 1);
  }
  return chosen;
}

class ScenarioRun {
 public:
  /// `at_centres` is true if the ends of the queries have been moved to the centres of their tiles.
  ScenarioRun(const ScenarioOptions& options, double radius, bool at_centres, const World& world,
              std::vector<ScenarioQuery> queries)
      : options_(options), radius_(radius), at_centres_(at_centres), world_(world), queries_(std::move(queries)) {}

  /// Answers every query. Throws Failure if the world refuses one.
  void ask_all() {
    Progress progress("query");
    QueryContext context;
    Path path;
    for (const ScenarioQuery& query : queries_) {
      progress.show(answers_.size(), queries_.size());
      const std::chrono::duration<double, std::micro> time = ask(query, context, path);
      const bool is_ambiguous =
          is_between_tiles(world_, query.start, context) || is_between_tiles(world_, query.goal, context);
      ambiguous_count_ += is_ambiguous ? 1 : 0;
      answers_.push_back({path.status, path.length, path.expansions, time.count(), verdict_of(query, path)});
    }
  }

  /// Returns the answers of the chosen queries, for a picture.
  [[nodiscard]] SvgOverlay overlay_of(const std::vector<std::size_t>& chosen) const {
    SvgOverlay overlay;
    QueryContext context;
    for (const std::size_t i : chosen) {
      Path path;
      ask(queries_[i], context, path);
      add_answer(overlay, {queries_[i].start, queries_[i].goal, radius_}, std::move(path));
    }
    return overlay;
  }

  /// Returns a line for each query, after a line of column names.
  [[nodiscard]] std::string csv() const {
    std::string out = "query,start_x,start_y,goal_x,goal_y,given,status,length,ratio,expansions,microseconds\n";
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const ScenarioQuery& query = queries_[i];
      const Answer& answer = answers_[i];
      fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},", i + 1, query.start.x, query.start.y,
                     query.goal.x, query.goal.y, query.length, to_string(answer.status));
      if (answer.status == PathStatus::found) {
        fmt::format_to(std::back_inserter(out), "{},", answer.length);
        if (!is_of_discs()) fmt::format_to(std::back_inserter(out), "{}", ratio_of(query, answer));
      } else {
        out += ',';
      }
      fmt::format_to(std::back_inserter(out), ",{},{:.3f}\n", answer.expansions, answer.microseconds);
    }
    return out;
  }

  [[nodiscard]] std::string summary() const {
    std::string out = fmt::format("{} queries of {} through {}, algorithm {}", queries_.size(),
                                  title_of(options_.scenario), title_of(options_.map), to_string(options_.algorithm));
    out += is_of_discs() ? fmt::format(", radius {}\n", radius_) : "\n";
    if (is_of_discs()) {
      append_statuses(out);
    } else {
      append_verdicts(out);
    }
    append_percentiles(out);
    if (is_of_discs()) out += "The lengths in the scenario are for points: they are not compared.\n";
    if (at_centres_) out += "The ends are the centres of their tiles.\n";
    out.pop_back();
    return out;
  }

 private:
  [[nodiscard]] bool is_of_discs() const { return radius_ > 0.0; }

  static void append_count(std::string& out, std::string_view name, std::size_t count) {
    fmt::format_to(std::back_inserter(out), "{:<28}{:>9}\n", name, count);
  }

  template <typename Condition>
  [[nodiscard]] std::size_t count_of(const Condition& condition) const {
    return static_cast<std::size_t>(std::count_if(answers_.begin(), answers_.end(), condition));
  }

  void append_verdicts(std::string& out) const {
    const auto line = [&](std::string_view name, Verdict verdict) {
      append_count(out, name, count_of([&](const Answer& answer) { return answer.verdict == verdict; }));
    };
    line("as given", Verdict::same);
    line("shorter than given", Verdict::shorter);
    line("longer than given", Verdict::longer);
    line("no path where one is given", Verdict::missing);
    line("a path where none is given", Verdict::surprising);
    append_count(out, "an end between two tiles", ambiguous_count_);
  }

  void append_statuses(std::string& out) const {
    for (const StatusCount& line : kDiscCounts) {
      append_count(out, line.name, count_of([&](const Answer& answer) { return answer.status == line.status; }));
    }
  }

  /// Finds the path of a query. Returns the time that this took.
  std::chrono::nanoseconds ask(const ScenarioQuery& query, QueryContext& context, Path& path) const {
    PathQuery asked{query.start, query.goal, {.radius = radius_}, options_.algorithm};
    asked.wants_time = true;
    const Result<void> done = world_.find_path(asked, context, path);
    if (done.ok()) return path.time;
    const char* const hint =
        done.error().code == ErrorCode::out_of_domain ? "; is this the scenario of another map?" : "";
    throw Failure(fmt::format("{}:{}: {}{}", options_.scenario, query.line, done.error().message(), hint));
  }

  void append_percentiles(std::string& out) const {
    std::vector<double> times;
    std::vector<double> expansions;
    std::vector<double> ratios;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      times.push_back(answers_[i].microseconds);
      expansions.push_back(static_cast<double>(answers_[i].expansions));
      if (answers_[i].status != PathStatus::found) continue;
      lengths.push_back(answers_[i].length);
      if (queries_[i].length > 0.0) ratios.push_back(ratio_of(queries_[i], answers_[i]));
    }
    fmt::format_to(std::back_inserter(out), "{:<28}{:>9}{:>11}{:>11}{:>11}{:>11}\n", "", "mean", "median", "90 %",
                   "99 %", "max");
    append_row(out, "microseconds", times, 1);
    append_row(out, "expansions", expansions, 1);
    if (is_of_discs()) {
      append_row(out, "length", lengths, 3);
    } else {
      append_row(out, "length / given", ratios, 6);
    }
  }

  /// A percentile is one of the values: the smallest that at least this percentage of all values does not exceed.
  static void append_row(std::string& out, const char* name, std::vector<double> values, int digits) {
    if (values.empty()) return;
    std::sort(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values) sum += value;
    const auto at = [&](std::size_t percent) { return values[(values.size() * percent + 99) / 100 - 1]; };
    fmt::format_to(std::back_inserter(out), "{0:<28}{2:>9.{1}f}{3:>11.{1}f}{4:>11.{1}f}{5:>11.{1}f}{6:>11.{1}f}\n",
                   name, digits, sum / static_cast<double>(values.size()), at(50), at(90), at(99), values.back());
  }

  const ScenarioOptions& options_;
  double radius_;
  bool at_centres_;
  const World& world_;
  std::vector<ScenarioQuery> queries_;
  std::vector<Answer> answers_;
  std::size_t ambiguous_count_ = 0;  ///< number of queries with an end between two tiles
};

}  // namespace

ExitStatus scenario(const ScenarioOptions& options) {
  if (options.map == "-" && options.scenario == "-") {
    throw Failure("waywright: MAP and SCENARIO cannot both be standard input");
  }
  const double radius = parse_radius(options.radius);
  std::vector<NamedFile> inputs = files_of_map(options.map);
  inputs.push_back({"SCENARIO", options.scenario});
  refuse_shared_files(inputs, {{"--csv", options.csv}, {"--svg", options.svg}});
  std::vector<ScenarioQuery> queries = load_scenario(options.scenario);
  const std::vector<std::size_t> chosen = chosen_queries(options, queries.size());
  const Scene scene = load_scene(options.map);
  check_map(options, scene, queries);
  OutputFile csv(options.csv);
  OutputFile svg(options.svg);
  const SvgOptions picture = svg_options(options.picture, scene.domain, title_of(options.scenario), scene.y_down);
  const World world = build_world(scene, options.map, radius);
  // At a corner of a tile beside an obstacle no disc fits. A disc of radius 0.5 fits at the centre of each free tile.
  const bool at_centres = radius > 0.0 && are_tiles(scene, queries);
  if (at_centres) move_to_centres(queries);

  ScenarioRun run(options, radius, at_centres, world, std::move(queries));
  run.ask_all();
  StreamWriter output(stream_beside({options.csv, options.svg}));
  output.write_line(run.summary());
  output.flush();
  if (csv.wanted()) csv.write(run.csv());
  if (svg.wanted()) {
    svg.write(draw(world, run.overlay_of(chosen), picture));
  }
  csv.commit();
  svg.commit();
  return kDone;
}

}  // namespace waywright::command
