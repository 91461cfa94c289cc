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

namespace waywright::command {

namespace {

std::string draw(const Scene& scene, const ConvertOptions& options) {
  SvgOptions picture;
  picture.mesh = !options.no_mesh;
  picture.y_down = scene.y_down;
  picture.title = title_of(options.in);
  return to_svg(build_world(scene, options.in), {}, picture);
}

/// Whether OUT becomes a picture, or else a world script. Throws Failure where nothing says so.
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
  refuse_shared_files(files_of_map(options.in), {{"OUT", options.out}});
  const Scene scene = load_scene(options.in);
  OutputFile out(options.out);
  out.write(picture ? draw(scene, options) : to_script(scene));
  out.commit();
  return kDone;
}

}  // namespace waywright::command
