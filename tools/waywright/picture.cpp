#include "picture.hpp"

#include <utility>

#include <fmt/format.h>

#include "failure.hpp"
#include "input.hpp"

namespace waywright::command {

SvgOptions svg_options(const PictureOptions& options, const Box& domain, std::string_view title, bool y_down) {
  SvgOptions picture;
  picture.mesh = !options.no_mesh;
  picture.axes = !options.no_axes;
  picture.theme = options.theme;
  picture.y_down = y_down;
  picture.title = title;
  if (!options.crop.empty()) {
    picture.crop = Box{parse_point("--crop", {options.crop.at(0), options.crop.at(1)}),
                       parse_point("--crop", {options.crop.at(2), options.crop.at(3)})};
    const Result<SvgFrame> frame = svg_frame(domain, picture);
    if (!frame.ok()) throw Failure(fmt::format("waywright: --crop: {}", frame.error().message()));
  }
  return picture;
}

std::string draw(const World& world, const SvgOverlay& overlay, const SvgOptions& options) {
  Result<std::string> text = to_svg(world, overlay, options);
  if (!text.ok()) throw Failure(fmt::format("waywright: cannot draw the picture: {}", text.error().message()));
  return std::move(text).value();
}

void add_answer(SvgOverlay& overlay, const PathQuery& query, Path path) {
  if (query.agent.radius > 0.0) {
    overlay.disc_paths.push_back({query, std::move(path)});
  } else if (path.status == PathStatus::found) {
    overlay.paths.push_back(std::move(path));
  } else {
    overlay.failed_paths.push_back({query.start, query.goal, path.status});
  }
}

}  // namespace waywright::command
