#include "waywright/scene.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "waywright/save.hpp"
#include "waywright/script.hpp"

#include "io/input_file.hpp"
#include "io/saved_world.hpp"
#include "io/triangle.hpp"

namespace waywright {
namespace {

Result<std::string> read_file(const std::string& file_name) {
  const io::InputFile file = io::open_input_file(file_name);
  if (!file) return io::unreadable(file_name, errno);
  std::string text;
  std::array<char, std::size_t{1} << 16> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    text.append(chunk.data(), count);
  }
  if (std::ferror(file.get()) != 0) return io::unreadable(file_name, errno);
  return text;
}

Result<Scene> read_script(std::string_view text, const std::string& file_name) {
  const Result<Script> script = parse_script(text, file_name);
  if (!script.ok()) return script.error();
  return scene_of(*script);
}

Result<Scene> read_poly(std::string_view text, const std::string& file_name) {
  if (!io::lacks_vertices(text)) return parse_triangle_poly(text, file_name);
  const std::string node_name = file_name.substr(0, file_name.rfind('.')) + ".node";
  const Result<std::string> node_text = read_file(node_name);
  if (!node_text.ok()) {
    Error error = node_text.error();
    error.words = error.message() + "; it should hold the vertices, of which " + file_name + " counts none";
    return error;
  }
  return parse_triangle_poly(text, file_name, *node_text, node_name);
}

}  // namespace

Result<SceneFormat> scene_format(std::string_view file_name) {
  constexpr std::array kEndings{
      std::pair<std::string_view, SceneFormat>{".wws", SceneFormat::script},
      std::pair<std::string_view, SceneFormat>{".map", SceneFormat::movingai},
      std::pair<std::string_view, SceneFormat>{".poly", SceneFormat::triangle_poly},
      std::pair<std::string_view, SceneFormat>{".node", SceneFormat::triangle_node},
      std::pair<std::string_view, SceneFormat>{".wwb", SceneFormat::saved_world},
  };
  for (const auto& [ending, format] : kEndings) {
    if (file_name.ends_with(ending)) return format;
  }
  std::string message(file_name);
  message += ": expected a file name that ends in .wws, .wwb, .map, .poly or .node";
  return Error{.code = ErrorCode::not_supported, .words = std::move(message), .item = {}};
}

bool is_saved_world(std::string_view bytes) { return bytes.starts_with(io::kSavedWorldMagic); }

Result<Scene> parse_saved_world(std::string_view bytes, std::string_view name) {
  std::istringstream stream{std::string(bytes)};
  const auto refuse = [&](Error error) {
    error.words = std::string(name) + ": " + error.message();
    return error;
  };
  const Result<World> world = load_world(stream);
  if (!world.ok()) return refuse(world.error());
  if (stream.peek() != std::istringstream::traits_type::eof()) {
    return refuse({ErrorCode::malformed, "there are more bytes after the saved world", {}, 0});
  }
  return Scene{.domain = world->domain(), .items = world->items(), .y_down = false};
}

Result<Scene> read_scene(const std::string& file_name) {
  const Result<SceneFormat> format = scene_format(file_name);
  const Result<std::string> text = read_file(file_name);
  if (text.ok() && is_saved_world(*text)) return parse_saved_world(*text, file_name);
  if (!format.ok()) return format.error();
  if (!text.ok()) return text.error();
  switch (*format) {
    case SceneFormat::script:
      return read_script(*text, file_name);
    case SceneFormat::movingai:
      return parse_movingai_map(*text, file_name);
    case SceneFormat::triangle_poly:
      return read_poly(*text, file_name);
    case SceneFormat::saved_world:
      return parse_saved_world(*text, file_name);
    case SceneFormat::triangle_node:
      break;
  }
  return parse_triangle_node(*text, file_name);
}

}  // namespace waywright
