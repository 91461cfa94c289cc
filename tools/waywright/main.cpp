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
    "Waywright triangulates a world of obstacles exactly, and finds paths through the world. The obstacles can\n"
    "change, and the triangulation (a constrained Delaunay triangulation) changes with them.\n";
constexpr const char* kExamples =
    "Examples:\n"
    "  waywright run world.wws                                run a world script\n"
    "  waywright path map.wws --from 3 4 --to 90 60           find one path through a map\n"
    "  waywright scenario arena.map arena.map.scen            find a path for each query of a scenario\n"
    "  waywright convert arena.map arena.svg                  draw a map\n"
    "\n`waywright help COMMAND` describes a command. The file name - is standard input or standard output. If the\n"
    "command writes a file to standard output, it writes its answers to standard error. The command never overwrites\n"
    "a file that it reads.\n"
    "Exit status: 0 if the command has done its work; 1 if a check has failed, if two logs differ or, with --strict,\n"
    "if the world has refused a line; 2 if the arguments are wrong, if the command cannot read or write a file, or if\n"
    "the input is malformed.\n";
constexpr const char* kAboutMap =
    "The map: .wws, .wwb, .map, .poly, .node, .geojson, .json, .wkt, .mesh or .obj; - is a world script, a saved world "
    "or GeoJSON on standard input";
constexpr const char* kFormats =
    "Maps: .wws (world script), .wwb (saved world), .map (Moving AI), .poly and .node (Triangle), .geojson and .json\n"
    "(GeoJSON), .wkt (well-known text), .mesh (Polyanya) and .obj (Wavefront; all vertices have\n"
    "the same z). A longitude is an x coordinate and a latitude is a y coordinate, so lengths are in degrees. For\n"
    "lengths in metres, project the file first, for example with ogr2ogr -t_srs.\n";
constexpr const char* kRunExamples =
    "Examples:\n"
    "  waywright run world.wws --svg world.svg                draw the final world, and the queries about it\n"
    "  waywright run world.wws --svg region.svg --crop 0 0 50 40 --theme dark\n"
    "  waywright run world.wws --dump world.dump --check      validate after each line, write the final mesh\n"
    "  generate | waywright run - --strict                    read standard input, stop at the first refused line\n"
    "  waywright run world.wws --dump - | sha256sum           write only the final mesh to standard output\n"
    "\nThe command writes the files after the last line of the script. It writes each file completely or not at all.\n"
    "--stats prints one JSON line on standard error. For each kind of predicate, this line says how many calls were\n"
    "decided in doubles (with a proven error bound), in integers of a fixed width (on a lattice) and in integers of\n"
    "any size. It also says how many bytes the world takes at the end, by purpose.\n";
constexpr const char* kPathExamples =
    "Examples:\n"
    "  waywright path arena.map --from 5 17 --to 44 30\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --svg path.svg --no-mesh\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --algorithm ta\n"
    "  waywright path field.wws --from -3 4 --to 20 -7.5 --radius 1.5 --svg path.svg\n"
    "\nThe command prints one JSON line: the length and the pieces of the path, or the reason why there is no path.\n"
    "With --radius, the pieces are the lines and arcs on which the centre of the disc moves. If only a smaller disc\n"
    "can move from start to goal, the JSON line contains the largest radius, and the gap that stops larger discs.\n"
    "--geojson writes the path as a line.\n";
constexpr const char* kScenarioExamples =
    "Examples:\n"
    "  waywright scenario arena.map arena.map.scen\n"
    "  waywright scenario arena.map arena.map.scen --algorithm ta --csv arena.csv\n"
    "  waywright scenario arena.map arena.map.scen --svg arena.svg --query 17 --query 160\n"
    "  waywright scenario arena.map arena.map.scen --radius 0.45\n"
    "\nThe command compares the lengths of the paths with the lengths in the scenario. It also prints percentiles of\n"
    "the time, of the number of triangles that the searches entered (expansions) and of the length. The scenario is\n"
    "a file of Moving AI, version 1. The first query has the number 1. Each query must contain the name of the map\n"
    "and, for a .map, its size. The folders and the suffix of the name may differ. The summary also counts the\n"
    "queries with an end at which two blocked tiles touch only at a corner. At such an end there are two free tiles,\n"
    "and the path in the scenario may begin in the other one.\n"
    "With --radius, the command finds paths for a disc. The lengths in a scenario are lengths for a point, so the\n"
    "command does not compare them. The summary then counts the paths, the queries without a path, and the ends at\n"
    "which the disc does not fit. If the ends in the scenario of a .map are whole numbers, they are tiles: the disc\n"
    "starts and ends at the centres of these tiles.\n";
constexpr const char* kConvertExamples =
    "Examples:\n"
    "  waywright convert arena.map arena.wws\n"
    "  waywright convert greenland.node greenland.svg\n"
    "  waywright convert face.poly face.svg --no-mesh\n"
    "  waywright convert arena.map arena.wwb                  a saved world, which loads quickly\n"
    "  waywright convert town.geojson town.svg\n"
    "  waywright convert arena.map arena.geojson              the items, for example for QGIS or Shapely\n"
    "  waywright convert arena.map mesh.geojson --format geojson-mesh     the triangles and the constrained edges\n"
    "  waywright convert arena.map - --format svg | display\n\n";

constexpr const char* kReplayExamples =
    "Examples:\n"
    "  waywright replay game.wws                              make the changes again, and compare the hashes\n"
    "  waywright replay here.wws there.wws                    find the first difference of two machines\n"
    "\nA replay log is a world script with lines `tick N HASH`; the library's ReplayWriter writes it. With one log,\n"
    "the command prints one JSON line: the first tick whose hash differs from the computed hash, and the items that\n"
    "have changed since the last tick with an equal hash. With two logs, it prints the first change or hash in which\n"
    "they differ. The exit status is 1 if there is a difference.\n";

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
                  "The radius of the agent, 0 or more. 0 (the default) is a point, a larger radius is a disc")
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
          "--theme", read,
          "The colours of the picture: light, dark or auto (the default: as the viewer of the file prefers)")
      ->type_name("NAME");
}

/// Adds the options of a picture. They need `file`, the option that names the picture's file, or null if the command
/// has no such option.
void add_picture(CLI::App& command, PictureOptions& options, CLI::Option* file) {
  command.add_flag("--no-mesh", options.no_mesh, "Do not draw the mesh");
  CLI::Option* const no_axes =
      command.add_flag("--no-axes", options.no_axes, "Do not draw ticks, coordinates and the scale bar");
  CLI::Option* const theme = add_theme(command, options.theme);
  const char* const about = "Show only the box from (X0, Y0) to (X1, Y1): X0 is less than X1, and Y0 is less than Y1";
  CLI::Option* const crop = command.add_option("--crop", options.crop, about)
                                ->type_size(4)
                                ->expected(1)
                                ->allow_extra_args(false)
                                ->type_name("X0 Y0 X1 Y1");
  if (file == nullptr) return;
  for (CLI::Option* const option : {no_axes, theme, crop}) option->needs(file);
}

std::string check_format(const std::string& name) {
  const bool is_geojson = name == "geojson" || name == "geojson-mesh";
  const bool is_known = name == "wws" || name == "wwb" || name == "svg" || is_geojson;
  return is_known ? "" : "'" + name + "' is none of wws, wwb, svg, geojson and geojson-mesh";
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
  line.run = line.app.add_subcommand("run", "Carry out a world script, and print each answer as one line of JSON");
  add_file(*line.run, "SCRIPT", options.script,
           "The script (.wws), or a map whose items it inserts; - is standard input");
  add_file_option(*line.run, "--dump", options.dump, "Write the final mesh as text, with exact coordinates");
  CLI::Option* const svg =
      add_file_option(*line.run, "--svg", options.svg, "Draw the final world, and the queries after the last change");
  add_picture(*line.run, options.picture, svg);
  add_file_option(*line.run, "--geojson", options.geojson,
                  "Write the final items, and the paths after the last change, as GeoJSON");
  line.run->add_flag("--check", options.check, "Validate the world after each change, and stop at the first fault");
  line.run->add_flag("--strict", options.strict, "Stop at the first line that the world refuses");
  line.run->add_flag("--stats", options.stats,
                     "Print on standard error how many calls of predicates each stage has decided, and the "
                     "memory of the world");
  line.run->add_option("--limit", options.limit, "Refuse each change that would make more than N new vertices")
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
  line.path->add_option("--to", options.to, "Where the path ends")
      ->type_size(2)
      ->expected(1)
      ->allow_extra_args(false)
      ->type_name("X Y")
      ->required();
  add_radius(*line.path, options.radius);
  add_algorithm(*line.path, options.algorithm);
  CLI::Option* const svg = add_file_option(*line.path, "--svg", options.svg, "Draw the map and the path");
  add_picture(*line.path, options.picture, svg);
  add_file_option(*line.path, "--geojson", options.geojson, "Write the path as GeoJSON");
  line.path->footer(std::string(kPathExamples) + "\n" + kFormats);
}

void add_scenario(CommandLine& line) {
  ScenarioOptions& options = line.scenario_options;
  line.scenario = line.app.add_subcommand("scenario", "Find a path for each query of a scenario, and print a summary");
  add_file(*line.scenario, "MAP", options.map, kAboutMap);
  add_file(*line.scenario, "SCENARIO", options.scenario, "The queries (.scen); - is standard input");
  add_radius(*line.scenario, options.radius);
  add_algorithm(*line.scenario, options.algorithm);
  add_file_option(*line.scenario, "--csv", options.csv, "Write a line for each query");
  CLI::Option* const svg = add_file_option(*line.scenario, "--svg", options.svg,
                                           "Draw the map and the paths of the queries that --query selects");
  line.scenario->add_option("--query", options.queries, "The number of a query to draw")
      ->type_name("N")
      ->allow_extra_args(false)
      ->check(check_query_number);
  line.scenario->add_flag("--any-map", options.any_map, "Carry out queries of another map or another size, too");
  add_picture(*line.scenario, options.picture, svg);
  line.scenario->footer(kScenarioExamples);
}

void add_convert(CommandLine& line) {
  ConvertOptions& options = line.convert_options;
  line.convert =
      line.app.add_subcommand("convert", "Write a map as a world script, a saved world, a picture or GeoJSON");
  add_file(*line.convert, "MAP", options.in, kAboutMap);
  add_file(*line.convert, "OUT", options.out,
           "The file to write (.wws, .wwb, .svg, .geojson or .json); - is standard output");
  line.convert
      ->add_option(
          "--format", options.format,
          "wws, wwb, svg, geojson (the items) or geojson-mesh. Necessary if the suffix of OUT is none of these")
      ->type_name("NAME")
      ->check(check_format);
  add_picture(*line.convert, options.picture, nullptr);
  line.convert->footer(std::string(kConvertExamples) + kFormats);
}

void add_replay(CommandLine& line) {
  ReplayOptions& options = line.replay_options;
  line.replay = line.app.add_subcommand("replay", "Make the changes of a log again, or compare two logs");
  add_file(*line.replay, "LOG", options.log, "The log (.wws); - is standard input");
  line.replay->add_option("OTHER_LOG", options.other, "A log to compare with")->check(check_file_name);
  line.replay->footer(kReplayExamples);
}

void add_help(CommandLine& line) {
  line.help = line.app.add_subcommand("help", "Print the help of a command");
  line.help->add_option("COMMAND", line.helped, "The command. Without it, print what each command does");
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
