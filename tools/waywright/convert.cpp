#include <string_view>

#include <fmt/format.h>

#include "waywright/scene.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
#include "file_names.hpp"
#include "input.hpp"
#include "output.hpp"
#include "picture.hpp"

namespace waywright::command {

namespace {

std::string picture_of(const Scene& scene, const ConvertOptions& options) {
  const SvgOptions picture = svg_options(options.picture, scene.domain, title_of(options.in), scene.y_down);
  return draw(build_world(scene, options.in, 0.0), {}, picture);
}

/// Returns whether OUT becomes a picture; otherwise it becomes a world script. Throws Failure if neither the options
/// nor the file name tells.
bool is_picture(const ConvertOptions& options) {
  const std::string_view name = options.out;
  if (!options.format.empty()) return options.format == "svg";
  if (name.ends_with(".svg")) return true;
  if (name.ends_with(".wws") || name == "-") return false;
  throw Failure(
      fmt::format("waywright: convert writes world scripts (.wws) and pictures (.svg), and '{}' ends in neither; "
                  "--format says which",
                  name));
}

}  // namespace

ExitStatus convert(const ConvertOptions& options) {
  const bool picture = is_picture(options);
  if (!picture && !options.picture.crop.empty()) {
    throw Failure("waywright: convert: --crop is for pictures, and OUT becomes a world script");
  }
  refuse_shared_files(files_of_map(options.in), {{"OUT", options.out}});
  const Scene scene = load_scene(options.in);
  OutputFile out(options.out);
  out.write(picture ? picture_of(scene, options) : to_script(scene));
  out.commit();
  return kDone;
}

}  // namespace waywright::command
