#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "waywright/predicate_counts.hpp"
#include "waywright/script.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "input.hpp"
#include "json_lines.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "runner.hpp"

namespace waywright::command {

namespace {

Script load_script(const std::string& name) {
  Result<Script> script = parse_script(read_text(name), name);
  if (!script.ok()) throw Failure(script.error().message);
  return std::move(script).value();
}

World create_world(const Script& script, const std::string& name) {
  Result<World> world = World::create(script.domain);
  if (!world.ok()) throw Failure(fmt::format("{}:{}: {}", name, script.domain_line, world.error().message));
  return std::move(world).value();
}

/// All operations, or those up to the one that ends the run early.
struct RunResult {
  ExitStatus status = kDone;
  bool to_the_end = true;
};

RunResult carry_out(const Script& script, const RunOptions& options, Runner& runner) {
  RunResult result;
  Progress progress("run");
  std::size_t done = 0;
  for (const Operation& operation : script.operations) {
    progress.show(done++, script.operations.size());
    const Outcome outcome = runner.carry_out(operation);
    if (outcome == Outcome::check_failed) result.status = kRefused;
    if (outcome == Outcome::refused && options.strict) return {kRefused, false};
    if (options.check && !runner.validate_after(operation)) return {kRefused, false};
  }
  return result;
}

}  // namespace

ExitStatus run(const RunOptions& options) {
  if (same_file(options.dump, options.svg)) throw Failure("waywright: --dump and --svg name the same file");
  const Script script = load_script(options.script);
  World world = create_world(script, options.script);
  OutputFile dump(options.dump);
  OutputFile svg(options.svg);
  StandardOutput output;
  Runner runner(world, output);

  const RunResult result = carry_out(script, options, runner);
  output.flush();
  if (options.stats) fmt::print(stderr, "{}\n", json_line(predicate_counts(), world.memory()));
  if (!result.to_the_end) return result.status;
  if (dump.wanted()) dump.write(world.dump());
  if (svg.wanted()) {
    SvgOptions picture;
    picture.title = title_of(options.script);
    svg.write(to_svg(world, runner.paths(), picture));
  }
  dump.commit();
  svg.commit();
  return result.status;
}

}  // namespace waywright::command
