#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "waywright/version.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "failure.hpp"
#include "output.hpp"
#include "platform.hpp"

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
    "\nwaywright help COMMAND says more. A file named - is standard input or standard output; where a file goes to\n"
    "standard output, answers go to standard error. No file is written over one that is read.\n"
    "Exit status: 0 done, 1 a check failed, logs differ or (--strict) an operation was refused, 2 bad arguments, a\n"
    "file that cannot be read or written, or malformed input.\n";
constexpr const char* kAboutMap =
    "The map: .wws, .wwb, .map, .poly or .node; - is a world script or a saved world on standard input";
constexpr const char* kRunExamples =
    "Examples:\n"
    "  waywright run world.wws --svg world.svg                the final world, and what was asked of it\n"
    "  waywright run world.wws --svg region.svg --crop 0 0 50 40 --theme dark\n"
    "  waywright run world.wws --dump world.dump --check      the final mesh; validated after every operation\n"
    "  generate | waywright run - --strict                    from standard input, stop at the first refusal\n"
    "  waywright run world.wws --dump - | sha256sum           the final mesh alone on standard output\n"
    "\nThe files are written when the script has run to its end, whole or not at all. --stats prints one JSON line\n"
    "on standard error: how many questions about points were decided in doubles (with a proven error bound), on a\n"
    "lattice (integers of a fixed width) and in integers of any size, for each kind of question; and how many bytes\n"
    "the world takes at the end, by what they are for.\n";
constexpr const char* kPathExamples =
    "Examples:\n"
    "  waywright path arena.map --from 5 17 --to 44 30\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --svg path.svg --no-mesh\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --algorithm ta\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --radius 1.5 --svg path.svg\n"
    "\nPrints one JSON line: the path's length and pieces, or why there is none. With --radius, the pieces are lines\n"
    "and arcs of the path of the disc's centre. If only a smaller disc gets through, the line says how large it may\n"
    "be, and which gap stops larger discs. Maps: .wws, .wwb, .map (Moving AI), .poly and .node (Triangle).\n";
constexpr const char* kScenarioExamples =
    "Examples:\n"
    "  waywright scenario arena.map arena.map.scen\n"
    "  waywright scenario arena.map arena.map.scen --algorithm ta --csv arena.csv\n"
    "  waywright scenario arena.map arena.map.scen --svg arena.svg --query 17 --query 160\n"
    "  waywright scenario arena.map arena.map.scen --radius 0.45\n"
    "\nPrints how the paths compare with the lengths that the scenario gives, and percentiles of time,\n"
    "expansions and length. The scenario is of Moving AI, version 1; queries count from 1. Each query must name the\n"
    "map, whose folders and ending do not matter, and the size of a .map. The queries with an end where two blocked\n"
    "cells touch at a corner are counted: there the given length may start on the other side.\n"
    "With --radius, all queries are for a disc. The lengths in a scenario are for points, so they are not compared:\n"
    "the summary counts paths, queries without a path, and ends at which the disc does not fit. If the ends in the\n"
    "scenario of a .map are whole numbers, they are cells, and the disc starts and ends at the centres of cells.\n";
constexpr const char* kConvertExamples =
    "Examples:\n"
    "  waywright convert arena.map arena.wws\n"
    "  waywright convert greenland.node greenland.svg\n"
    "  waywright convert face.poly face.svg --no-mesh\n"
    "  waywright convert arena.map arena.wwb                  a saved world, which loads quickly\n"
    "  waywright convert arena.map - --format svg | display\n";

constexpr const char* kReplayExamples =
    "Examples:\n"
    "  waywright replay game.wws                              make the changes again, and compare the hashes\n"
    "  waywright replay here.wws there.wws                    where two machines began to differ\n"
    "\nA replay log is a world script with lines `tick N HASH`; the library's ReplayWriter writes it. With one log,\n"
    "prints one JSON line: the first tick whose hash differs, and the items that changed since the last tick whose\n"
    "hash was the same. With two logs, prints the first change or hash in which they differ. The exit status is 1 if\n"
    "there is a difference.\n";

/// The definition of the command line, and the values that it has after parsing.
struct CommandLine {
  CLI::App app{kAbout, "waywright"};
  RunOptions run_options;
  PathOptions path_options;
  ScenarioOptions scenario_options;
  ConvertOptions convert_options;
  ReplayOptions replay_options;
  CLI::App* run = nullptr;
  CLI::App* path = nullptr;
  CLI::App* scenario = nullptr;
  CLI::App* convert = nullptr;
  CLI::App* replay = nullptr;
  CLI::App* help = nullptr;
  std::string helped;  ///< the command in `help COMMAND`; empty for `help` alone
};

std::string check_file_name(const std::string& name) { return name.empty() ? "the file's name is empty" : ""; }

/// Adds an argument that names a file, without an option.
void add_file(CLI::App& command, const std::string& name, std::string& value, const std::string& about) {
  command.add_option(name, value, about)->check(check_file_name)->required();
}

/// Adds an option that names an output file.
CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& value, const std::string& about) {
  return command.add_option(name, value, about)->type_name("FILE")->check(check_file_name);
}

void add_algorithm(CLI::App& command, PathAlgorithm& algorithm) {
  const auto read = [&algorithm](const std::string& word) {
    const auto named = path_algorithm(word);
    if (!named) throw CLI::ValidationError("--algorithm", "'" + word + "' is none of optimal, ta and tra");
    algorithm = *named;
  };
  command.add_option_function<std::string>("--algorithm", read, "optimal (the default), ta or tra")->type_name("NAME");
}

void add_radius(CLI::App& command, std::string& radius) {
  command
      .add_option("--radius", radius,
                  "The radius of the agent, 0 or more: 0 (the default) is a point, else it is a disc")
      ->type_name("R");
}

CLI::Option* add_theme(CLI::App& command, SvgTheme& theme) {
  const auto read = [&theme](const std::string& word) {
    if (word != "auto" && word != "light" && word != "dark") {
      throw CLI::ValidationError("--theme", "'" + word + "' is none of auto, light and dark");
    }
    theme = word == "light" ? SvgTheme::light : word == "dark" ? SvgTheme::dark : SvgTheme::automatic;
  };
  return command
      .add_option_function<std::string>(
          "--theme", read, "The picture's colours: auto (as the viewer prefers; the default), light or dark")
      ->type_name("NAME");
}

/// Adds the options of a picture. They need `file`, the option that names the picture's file, or null if the command
/// has no such option.
void add_picture(CLI::App& command, PictureOptions& options, CLI::Option* file) {
  command.add_flag("--no-mesh", options.no_mesh, "Leave the mesh out of the picture");
  CLI::Option* const no_axes =
      command.add_flag("--no-axes", options.no_axes, "Leave ticks, coordinates and the scale bar out of the picture");
  CLI::Option* const theme = add_theme(command, options.theme);
  const char* const about = "Show only the region of the world between these corners, the lower coordinates first";
  CLI::Option* const crop = command.add_option("--crop", options.crop, about)
                                ->type_size(4)
                                ->expected(1)
                                ->allow_extra_args(false)
                                ->type_name("X0 Y0 X1 Y1");
  if (file == nullptr) return;
  for (CLI::Option* const option : {no_axes, theme, crop}) option->needs(file);
}

std::string check_format(const std::string& name) {
  const bool is_known = name == "wws" || name == "wwb" || name == "svg";
  return is_known ? "" : "'" + name + "' is none of wws, wwb and svg";
}

/// Returns the number that the word consists of, or nothing.
std::optional<std::size_t> read_count(const std::string& word) {
  std::size_t number = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, number);
  if (stop != end || fault != std::errc{}) return std::nullopt;
  return number;
}

std::string check_query_number(const std::string& word) {
  const bool is_good = read_count(word).value_or(0) > 0;
  return is_good ? "" : "'" + word + "' is not the number of a query, which counts from 1";
}

std::string check_vertex_count(const std::string& word) {
  return read_count(word) ? "" : "'" + word + "' is not a number of vertices, 0 or more";
}

void add_run(CommandLine& line) {
  RunOptions& options = line.run_options;
  line.run = line.app.add_subcommand("run", "Run a world script, one JSON line per answer");
  add_file(*line.run, "SCRIPT", options.script, "The script (.wws); - is standard input");
  add_file_option(*line.run, "--dump", options.dump, "Write the final mesh, exactly, as text");
  CLI::Option* const svg =
      add_file_option(*line.run, "--svg", options.svg, "Draw the final world, and the queries since it last changed");
  add_picture(*line.run, options.picture, svg);
  line.run->add_flag("--check", options.check, "Validate after every operation; stop at the first fault");
  line.run->add_flag("--strict", options.strict, "Stop at the first refused operation");
  line.run->add_flag("--stats", options.stats,
                     "Tell on standard error which stage of the arithmetic decided how much, and where the memory is");
  line.run->add_option("--limit", options.limit, "Refuse an operation that would make more vertices than this")
      ->type_name("N")
      ->check(check_vertex_count);
  line.run->footer(kRunExamples);
}

void add_path(CommandLine& line) {
  PathOptions& options = line.path_options;
  line.path = line.app.add_subcommand("path", "Find one path through a map");
  add_file(*line.path, "MAP", options.map, kAboutMap);
  line.path->add_option("--from", options.from, "Where the path starts")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false)
      ->type_name("X Y")
      ->required();
  line.path->add_option("--to", options.to, "Where it ends")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false)
      ->type_name("X Y")
      ->required();
  add_radius(*line.path, options.radius);
  add_algorithm(*line.path, options.algorithm);
  CLI::Option* const svg = add_file_option(*line.path, "--svg", options.svg, "Draw the map and the path");
  add_picture(*line.path, options.picture, svg);
  line.path->footer(kPathExamples);
}

void add_scenario(CommandLine& line) {
  ScenarioOptions& options = line.scenario_options;
  line.scenario = line.app.add_subcommand("scenario", "Find all paths of a scenario and sum them up");
  add_file(*line.scenario, "MAP", options.map, kAboutMap);
  add_file(*line.scenario, "SCENARIO", options.scenario, "The queries (.scen); - is standard input");
  add_radius(*line.scenario, options.radius);
  add_algorithm(*line.scenario, options.algorithm);
  add_file_option(*line.scenario, "--csv", options.csv, "Write a line for each query");
  CLI::Option* const svg = add_file_option(*line.scenario, "--svg", options.svg,
                                           "Draw the map and the paths of the queries named by --query");
  line.scenario->add_option("--query", options.queries, "A query to draw")
      ->type_name("N")
      ->allow_extra_args(false)
      ->check(check_query_number);
  line.scenario->add_flag("--any-map", options.any_map, "Ask the queries although they name another map or size");
  add_picture(*line.scenario, options.picture, svg);
  line.scenario->footer(kScenarioExamples);
}

void add_convert(CommandLine& line) {
  ConvertOptions& options = line.convert_options;
  line.convert = line.app.add_subcommand("convert", "Turn a map into a world script, a saved world or a picture");
  add_file(*line.convert, "MAP", options.in, kAboutMap);
  add_file(*line.convert, "OUT", options.out, "The file to write (.wws, .wwb or .svg); - is standard output");
  line.convert->add_option("--format", options.format, "wws, wwb or svg, where the ending of OUT does not say it")
      ->type_name("NAME")
      ->check(check_format);
  add_picture(*line.convert, options.picture, nullptr);
  line.convert->footer(kConvertExamples);
}

void add_replay(CommandLine& line) {
  ReplayOptions& options = line.replay_options;
  line.replay = line.app.add_subcommand("replay", "Make the changes of a log again, or compare two logs");
  add_file(*line.replay, "LOG", options.log, "The log (.wws); - is standard input");
  line.replay->add_option("OTHER_LOG", options.other, "A log to compare with")->check(check_file_name);
  line.replay->footer(kReplayExamples);
}

void add_help(CommandLine& line) {
  line.help = line.app.add_subcommand("help", "Say more about a command");
  line.help->add_option("COMMAND", line.helped, "The command; without one, what they all do");
}

std::unique_ptr<CommandLine> make_command_line() {
  auto line = std::make_unique<CommandLine>();
  line->app.set_version_flag("--version", "waywright " WAYWRIGHT_VERSION, "Print the version");
  line->app.require_subcommand(0, 1);
  line->app.allow_windows_style_options(false);
  line->app.footer(kExamples);
  add_run(*line);
  add_path(*line);
  add_scenario(*line);
  add_convert(*line);
  add_replay(*line);
  add_help(*line);
  return line;
}

void print_text(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  StreamWriter output(StandardStream::output);
  output.write_line(text);
  output.flush();
}

/// Prints help and the version on standard output. All else is an error, reported in one line.
ExitStatus answer(const CommandLine& line, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) {
    const auto commands = line.app.get_subcommands();
    const std::string asked = commands.empty() ? "waywright" : "waywright " + commands.front()->get_name();
    throw Failure(fmt::format("{}: {} (see {} --help)", asked, error.what(), asked));
  }
  const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
  print_text(version ? std::string(error.what()) : line.app.help());
  return kDone;
}

/// `help COMMAND` prints the same as `COMMAND --help`.
ExitStatus help(const std::string& command) {
  const auto line = make_command_line();
  if (!command.empty() && command_named(line->app, command) == nullptr) {
    throw Failure(fmt::format("waywright help: '{}' is not a command; the commands are {}", command,
                              names_of_commands(line->app)));
  }
  try {
    line->app.parse(command + " --help");
  } catch (const CLI::ParseError& error) {
    return answer(*line, error);
  }
  return kDone;
}

ExitStatus dispatch(int argc, const char* const* argv) {
  const auto line = make_command_line();
  check_arguments(line->app, {argv + std::min(argc, 1), argv + argc});
  try {
    line->app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return answer(*line, error);
  }
  if (line->run->parsed()) return run(line->run_options);
  if (line->path->parsed()) return path(line->path_options);
  if (line->scenario->parsed()) return scenario(line->scenario_options);
  if (line->convert->parsed()) return convert(line->convert_options);
  if (line->replay->parsed()) return replay(line->replay_options);
  return help(line->helped);
}

}  // namespace

}  // namespace waywright::command

int main(int argc, char** argv) {
  using namespace waywright::command;
  prepare_standard_streams();
  try {
    return dispatch(argc, argv);
  } catch (const std::bad_alloc&) {
    print_message("waywright: not enough memory");
  } catch (const std::exception& error) {
    print_message(error.what());
  }
  return kUnusable;
}
