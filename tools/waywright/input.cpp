#include "input.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "waywright/error.hpp"
#include "waywright/save.hpp"

#include "base/number_text.hpp"
#include "failure.hpp"
#include "formats/map_format.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "text/file_types.hpp"

namespace waywright::command {

namespace {

using text::FileType;

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string read_all(std::FILE* file, const std::string& name) {
  std::string text;
  std::array<char, 1 << 16> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file)) text.append(chunk.data(), count);
  if (std::ferror(file) == 0) return text;
  throw Failure(fmt::format("{}: cannot be read: {}", name == "-" ? "standard input" : name, std::strerror(errno)));
}

double parse_number(std::string_view option, const std::string& word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const auto [stop, fault] = base::read_double(word.data() + (plus ? 1 : 0), end, value);
  if (stop != end || fault == std::errc::invalid_argument) {
    throw Failure(fmt::format("waywright: {}: '{}' is not a decimal number such as -1.5 or 2e3", option, word));
  }
  // A number that is too small becomes the nearest double, as in a script: 0 or a denormal number.
  if (fault == std::errc::result_out_of_range) value = std::strtod(word.c_str(), nullptr);
  if (fault == std::errc::result_out_of_range && std::isinf(value)) {
    throw Failure(fmt::format("waywright: {}: '{}' lies beyond +-2^100", option, word));
  }
  return value;
}

template <class T>
T value_of(Result<T> read) {
  if (!read.ok()) throw Failure(read.error().message());
  return std::move(read).value();
}

Scene parse_map(FileType type, const std::string& text, const std::string& name) {
  Progress progress("read");
  return value_of(
      formats::parse_map(type, text, name, [&](std::size_t done, std::size_t total) { progress.show(done, total); }));
}

/// Reads standard input: a world script, a saved world or GeoJSON.
Scene parse_input(const std::string& text, const std::string& name) {
  const FileType type = text::type_of_bytes(text);
  if (type == FileType::saved_world) return value_of(parse_saved_world(text, name));
  if (type == FileType::geojson) return parse_map(type, text, name);
  return scene_of(value_of(parse_script(text, name)));
}

/// Returns the script that inserts the items of a scene. Its lines have the numbers that they have in to_script().
Script script_of(Scene scene) {
  Script script{.domain = scene.domain, .domain_line = 2, .lines = {}};
  script.lines.reserve(scene.items.size());
  std::uint32_t line = script.domain_line;
  for (Item& item : scene.items) {
    ScriptLine& insertion = script.lines.emplace_back();
    insertion.kind = ScriptLineKind::insert;
    insertion.line = ++line;
    insertion.item = std::move(item);
  }
  return script;
}

}  // namespace

std::string read_text(const std::string& name) {
  if (name == "-") return read_all(stdin, name);
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(name.c_str(), "rb"));
  if (!file) throw Failure(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
  return read_all(file.get(), name);
}

Script load_script(const std::string& name) { return value_of(parse_script(read_text(name), name)); }

RunInput load_run(const std::string& name) {
  const bool is_input = name == "-";
  const std::optional<FileType> named = is_input ? std::nullopt : text::type_of_name(name);
  Scene scene;
  if (named && *named != FileType::script && *named != FileType::picture) {
    scene = load_scene(name);
  } else {
    const std::string text = read_text(name);
    const FileType type = text::type_of_bytes(text);
    const bool is_scene = type == FileType::saved_world || (is_input && type == FileType::geojson);
    if (!is_scene) return {value_of(parse_script(text, name)), false};
    scene = parse_input(text, name);
  }
  const bool y_down = scene.y_down;
  return {script_of(std::move(scene)), y_down};
}

Scene load_scene(const std::string& name) {
  if (name == "-") return parse_input(read_text(name), name);
  if (const auto type = text::type_of_name(name); formats::reads_map(type)) {
    const std::string text = read_text(name);
    return is_saved_world(text) ? value_of(parse_saved_world(text, name)) : parse_map(*type, text, name);
  }
  Result<Scene> scene = read_scene(name);
  if (!scene.ok() && scene.error().code == ErrorCode::not_supported && !scene_format(name).ok()) {
    throw Failure(scene.error().message() + ", or in .geojson, .json, .wkt, .mesh or .obj");
  }
  return value_of(std::move(scene));
}

World load_world(const std::string& name) {
  std::error_code ignored;
  const bool is_readable_twice = name != "-" && std::filesystem::is_regular_file(name, ignored);
  const std::string text = is_readable_twice || name == "-" ? read_text(name) : std::string();
  if (!is_saved_world(text)) return build_world(name == "-" ? parse_input(text, name) : load_scene(name), name, 0.0);
  std::istringstream stream(text);
  Progress progress("load");
  Result<World> world = waywright::load_world(
      stream, {.threads = 1, .progress = [&](std::size_t done, std::size_t total) { progress.show(done, total); }});
  if (!world.ok()) throw Failure(fmt::format("{}: {}", name, world.error().message()));
  if (stream.peek() != std::istringstream::traits_type::eof()) {
    throw Failure(fmt::format("{}: there are more bytes after the saved world", name));
  }
  return std::move(world).value();
}

World build_world(const Scene& scene, const std::string& name, double radius) {
  Result<World> created = World::create(scene.domain, {.keep_bridges = radius > 0.0});
  if (!created.ok()) throw Failure(fmt::format("{}: {}", name, created.error().message()));
  World world = std::move(created).value();
  Progress progress("insert");
  const auto show = [&](std::size_t done, std::size_t total) { progress.show(done, total); };
  if (world.insert_all(scene.items, {.threads = 1, .progress = show}).ok()) return world;
  // The world refuses some items. Inserts all items one by one, so that it gets the others.
  std::size_t left_out = 0;
  std::size_t done = 0;
  std::string first_reason;
  for (const Item& item : scene.items) {
    progress.show(done++, scene.items.size());
    const Result<ItemId> inserted = world.insert(item.shape, item.id);
    if (inserted.ok()) continue;
    if (left_out++ == 0) first_reason = fmt::format("item {}: {}", item.id.value, inserted.error().message());
  }
  progress.finish();
  if (left_out > 0) {
    print_message(fmt::format("{}: left out {} of the items, the first: {}", name, left_out, first_reason));
  }
  return world;
}

std::vector<NamedFile> files_of_map(const std::string& name) {
  std::vector<NamedFile> files{{"MAP", name}};
  if (text::type_of_name(name) == FileType::triangle_poly)
    files.push_back({"MAP", name.substr(0, name.rfind('.')) + ".node"});
  return files;
}

Point parse_point(std::string_view option, const std::vector<std::string>& values) {
  return {parse_number(option, values.at(0)), parse_number(option, values.at(1))};
}

double parse_radius(const std::string& value) {
  const double radius = parse_number("--radius", value);
  if (std::isfinite(radius) && radius >= 0.0) return radius;
  throw Failure(fmt::format("waywright: --radius: '{}' is negative or not finite; a radius is 0 or more", value));
}

std::string title_of(const std::string& name) {
  return name == "-" ? "standard input" : std::filesystem::path(name).filename().string();
}

}  // namespace waywright::command
