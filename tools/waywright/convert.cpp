#include <string_view>

#include <fmt/format.h>

#include "waywright/scene.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "commands.hpp"
#include "failure.hpp"
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

}  // namespace

ExitStatus convert(const ConvertOptions& options) {
  const std::string_view name = options.out;
  const bool picture = name.ends_with(".svg");
  if (!picture && !name.ends_with(".wws")) {
    throw Failure(fmt::format("waywright: convert writes .wws and .svg files, and '{}' ends in neither", name));
  }
  const Scene scene = load_scene(options.in);
  OutputFile out(options.out);
  out.write(picture ? draw(scene, options) : to_script(scene));
  out.commit();
  return kDone;
}

}  // namespace waywright::command
