#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "waywright/predicate_counts.hpp"
#include "waywright/script.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "file_names.hpp"
#include "formats/write_geojson.hpp"
#include "input.hpp"
#include "json_lines.hpp"
#include "output.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "runner.hpp"

namespace waywright::command {

namespace {

World create_world(const Script& script, const RunOptions& options) {
  // Only queries that ask where a disc gets to need the bridges, which make changes slower.
  const bool has_discs = std::any_of(script.lines.begin(), script.lines.end(), [](const ScriptLine& line) {
    const bool has_two_ends = line.kind == ScriptLineKind::path || line.has_goal;
    return has_two_ends && line.agent.radius > 0.0;
  });
  Result<World> world = World::create(script.domain, {.keep_bridges = has_discs, .new_vertex_limit = options.limit});
  if (!world.ok()) throw Failure(fmt::format("{}:{}: {}", options.script, script.domain_line, world.error().message()));
  const auto marks = std::count_if(script.lines.begin(), script.lines.end(),
                                   [](const ScriptLine& line) { return line.kind == ScriptLineKind::mark; });
  world->keep_history(static_cast<std::size_t>(marks));
  return std::move(world).value();
}

/// Returns the items of the world, and the paths in the overlay.
std::string geojson_of(const World& world, const SvgOverlay& overlay, bool y_down) {
  formats::GeoJsonWriter writer(world.domain(), y_down);
  for (const Item& item : world.items()) writer.add_item(item);
  for (const Path& path : overlay.paths) writer.add_path(path.points.front(), path.points.back(), path);
  for (const SvgFailedPath& failed : overlay.failed_paths) {
    Path path;
    path.status = failed.status;
    writer.add_path(failed.start, failed.goal, path);
  }
  for (const SvgDiscPath& disc : overlay.disc_paths) writer.add_path(disc.query.start, disc.query.goal, disc.answer);
  return writer.take();
}

/// The result of a run, which carries out all lines of a script or stops after one that ends it early.
struct RunResult {
  ExitStatus status = kDone;
  bool to_the_end = true;
};

RunResult carry_out(const Script& script, const RunOptions& options, Runner& runner) {
  RunResult result;
  Progress progress("run");
  std::size_t done = 0;
  for (const ScriptLine& line : script.lines) {
    progress.show(done++, script.lines.size());
    const Outcome outcome = runner.carry_out(line);
    if (outcome == Outcome::check_failed) result.status = kRefused;
    if (outcome == Outcome::refused && options.strict) return {kRefused, false};
    if (options.check && !runner.validate_after(line)) return {kRefused, false};
  }
  return result;
}

}  // namespace

ExitStatus run(const RunOptions& options) {
  std::vector<NamedFile> inputs = files_of_map(options.script);
  inputs.front().argument = "SCRIPT";
  refuse_shared_files(inputs, {{"--dump", options.dump}, {"--svg", options.svg}, {"--geojson", options.geojson}});
  const auto [script, y_down] = load_run(options.script);
  World world = create_world(script, options);
  OutputFile dump(options.dump);
  OutputFile svg(options.svg);
  OutputFile geojson(options.geojson);
  StreamWriter output(stream_beside({options.dump, options.svg, options.geojson}));
  const SvgOptions picture = svg_options(options.picture, world.domain(), title_of(options.script), y_down);
  SvgOverlay overlay;
  Runner runner(world, output, svg.wanted() || geojson.wanted() ? &overlay : nullptr);

  const RunResult result = carry_out(script, options, runner);
  output.flush();
  if (options.stats) {
    StreamWriter error(StandardStream::error);
    error.write_line(json_line(predicate_counts(), world.memory()));
    error.flush();
  }
  if (!result.to_the_end) return result.status;
  if (dump.wanted()) dump.write(world.dump());
  if (svg.wanted()) svg.write(draw(world, overlay, picture));
  if (geojson.wanted()) geojson.write(geojson_of(world, overlay, y_down));
  dump.commit();
  svg.commit();
  geojson.commit();
  return result.status;
}

}  // namespace waywright::command
