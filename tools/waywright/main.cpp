#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "waywright/version.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "output.hpp"
#include "system.hpp"

namespace waywright::command {

namespace {

constexpr const char* kAbout =
    "A world of obstacles that changes while agents find their way through it: an exact, dynamic\n"
    "constrained Delaunay triangulation with pathfinding on top.\n";
constexpr const char* kExamples =
    "Examples:\n"
    "  waywright run world.wws                                run a world script, answers on standard output\n"
    "  waywright path map.wws --from 3 4 --to 90 60           one path through a map\n"
    "  waywright scenario arena.map arena.map.scen            every query of a scenario, and how long it took\n"
    "  waywright convert arena.map arena.svg                  draw a map\n"
    "\nwaywright COMMAND --help says more. Exit status: 0 done, 1 a check failed or (--strict) an operation\n"
    "was refused, 2 bad arguments, a file that cannot be read or written, or malformed input.\n";
constexpr const char* kRunExamples =
    "Examples:\n"
    "  waywright run world.wws --svg world.svg                the final world, and the paths found in it\n"
    "  waywright run world.wws --dump world.dump --check      the final mesh; validated after every operation\n"
    "  generate | waywright run - --strict                    from standard input, stop at the first refusal\n"
    "\nThe files are written when the script has run to its end, whole or not at all. --stats prints one JSON line\n"
    "on standard error: how many questions about points were decided in doubles (with a proven error bound), on a\n"
    "lattice (integers of a fixed width) and in integers of any size, for each kind of question; and how many bytes\n"
    "the world takes at the end, by what they are for.\n";
constexpr const char* kPathExamples =
    "Examples:\n"
    "  waywright path arena.map --from 5 17 --to 44 30\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --svg way.svg --no-mesh\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --algorithm ta\n"
    "\nPrints one JSON line: the path's length and pieces, or why there is none. Maps: .wws, .map (Moving AI),\n"
    ".poly and .node (Triangle).\n";
constexpr const char* kScenarioExamples =
    "Examples:\n"
    "  waywright scenario arena.map arena.map.scen\n"
    "  waywright scenario arena.map arena.map.scen --algorithm ta --csv arena.csv\n"
    "  waywright scenario arena.map arena.map.scen --svg arena.svg --query 17 --query 160\n"
    "\nPrints how the paths compare with the lengths that the scenario gives, and percentiles of time,\n"
    "expansions and length. The scenario is of Moving AI, version 1; queries count from 1. It also counts the queries\n"
    "with an end where two blocked cells touch at a corner: there the given length may start on the other side.\n";
constexpr const char* kConvertExamples =
    "Examples:\n"
    "  waywright convert arena.map arena.wws\n"
    "  waywright convert greenland.node greenland.svg\n"
    "  waywright convert face.poly face.svg --no-mesh\n";

/// The command line: what it may hold, and what it holds once parsed.
struct CommandLine {
  CLI::App app{kAbout, "waywright"};
  RunOptions run_options;
  PathOptions path_options;
  ScenarioOptions scenario_options;
  ConvertOptions convert_options;
  CLI::App* run = nullptr;
  CLI::App* path = nullptr;
  CLI::App* scenario = nullptr;
  CLI::App* convert = nullptr;
};

/// An option that names a file to write.
void add_file(CLI::App& command, const std::string& name, std::string& value, const std::string& about) {
  const auto named = [](const std::string& text) { return std::string(text.empty() ? "the file has no name" : ""); };
  command.add_option(name, value, about)->type_name("FILE")->check(named);
}

void add_algorithm(CLI::App& command, PathAlgorithm& algorithm) {
  const auto read = [&algorithm](const std::string& word) {
    const auto named = path_algorithm(word);
    if (!named) throw CLI::ValidationError("--algorithm", "'" + word + "' is none of optimal, ta and tra");
    algorithm = *named;
  };
  command.add_option_function<std::string>("--algorithm", read, "optimal (the default), ta or tra")->type_name("NAME");
}

void add_run(CommandLine& line) {
  RunOptions& options = line.run_options;
  line.run = line.app.add_subcommand("run", "Run a world script, one JSON line per answer");
  line.run->add_option("SCRIPT", options.script, "The script (.wws); - is standard input")->required();
  add_file(*line.run, "--dump", options.dump, "Write the final mesh, exactly, as text");
  add_file(*line.run, "--svg", options.svg, "Draw the final world");
  line.run->add_flag("--check", options.check, "Validate after every operation; stop at the first fault");
  line.run->add_flag("--strict", options.strict, "Stop at the first refused operation");
  line.run->add_flag("--stats", options.stats,
                     "Tell on standard error which stage of the arithmetic decided how much, and where the memory is");
  line.run->footer(kRunExamples);
}

void add_path(CommandLine& line) {
  PathOptions& options = line.path_options;
  line.path = line.app.add_subcommand("path", "Find one path through a map");
  line.path->add_option("MAP", options.map, "The map, in any format that convert reads")->required();
  line.path->add_option("--from", options.from, "Where the path starts")
      ->type_size(2)
      ->expected(1)
      ->type_name("X Y")
      ->required();
  line.path->add_option("--to", options.to, "Where it ends")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false)
      ->type_name("X Y")
      ->required();
  add_algorithm(*line.path, options.algorithm);
  add_file(*line.path, "--svg", options.svg, "Draw the map and the path");
  line.path->add_flag("--no-mesh", options.no_mesh, "Leave the mesh out of the picture");
  line.path->footer(kPathExamples);
}

void add_scenario(CommandLine& line) {
  ScenarioOptions& options = line.scenario_options;
  line.scenario = line.app.add_subcommand("scenario", "Find all paths of a scenario and sum them up");
  line.scenario->add_option("MAP", options.map, "The map, in any format that convert reads")->required();
  line.scenario->add_option("SCENARIO", options.scenario, "The queries (.scen); - is standard input")->required();
  add_algorithm(*line.scenario, options.algorithm);
  add_file(*line.scenario, "--csv", options.csv, "Write a line for each query");
  add_file(*line.scenario, "--svg", options.svg, "Draw the map and the paths of the queries named by --query");
  line.scenario->add_option("--query", options.queries, "A query to draw")->type_name("N")->allow_extra_args(false);
  line.scenario->add_flag("--no-mesh", options.no_mesh, "Leave the mesh out of the picture");
  line.scenario->footer(kScenarioExamples);
}

void add_convert(CommandLine& line) {
  ConvertOptions& options = line.convert_options;
  line.convert = line.app.add_subcommand("convert", "Turn a map into a world script or a picture");
  line.convert->add_option("IN", options.in, "The map: .wws, .map, .poly or .node")->required();
  line.convert->add_option("OUT", options.out, "What to write: .wws or .svg")->required();
  line.convert->add_flag("--no-mesh", options.no_mesh, "Leave the mesh out of the picture");
  line.convert->footer(kConvertExamples);
}

std::unique_ptr<CommandLine> make_command_line() {
  auto line = std::make_unique<CommandLine>();
  line->app.set_version_flag("--version", "waywright " WAYWRIGHT_VERSION, "Print the version");
  line->app.require_subcommand(0, 1);
  line->app.footer(kExamples);
  add_run(*line);
  add_path(*line);
  add_scenario(*line);
  add_convert(*line);
  return line;
}

void print_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  fmt::print(stderr, "{}\n", text);
}

/// Help and version go to standard output; anything else is a mistake, told in one line.
ExitStatus answer(const CommandLine& line, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) {
    throw Failure(fmt::format("waywright: {} (see waywright --help)", error.what()));
  }
  StandardOutput output;
  const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
  std::string text = version ? std::string(error.what()) : line.app.help();
  while (text.ends_with('\n')) text.pop_back();
  output.write_line(text);
  output.flush();
  return kDone;
}

ExitStatus dispatch(int argc, const char* const* argv) {
  const auto line = make_command_line();
  try {
    line->app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(*line, error);
  }
  if (line->run->parsed()) return run(line->run_options);
  if (line->path->parsed()) return path(line->path_options);
  if (line->scenario->parsed()) return scenario(line->scenario_options);
  if (line->convert->parsed()) return convert(line->convert_options);
  throw Failure("waywright: expected a command: run, path, scenario or convert (see waywright --help)");
}

}  // namespace

}  // namespace waywright::command

int main(int argc, char** argv) {
  using namespace waywright::command;
  prepare_streams();
  try {
    return dispatch(argc, argv);
  } catch (const std::bad_alloc&) {
    print_one_line("waywright: not enough memory");
  } catch (const std::exception& error) {
    print_one_line(error.what());
  }
  return kUnusable;
}
