#include <optional>
#include <string>

#include "bind.hpp"
#include "structs.hpp"

// Pictures in SVG.

namespace waywright::python {

namespace {

/// Returns the ends of the query whose answer is `path`, or nothing if the path was not found.
std::optional<std::pair<Point, Point>> ends_of(const Path& path) {
  if (path.pieces.empty()) return std::nullopt;
  return std::pair(path.moved_start ? path.moved_start->from : path.pieces.front().from,
                   path.moved_goal ? path.moved_goal->from : path.pieces.back().to);
}

void add_path(SvgOverlay& overlay, const Path& path) {
  if (const auto ends = ends_of(path)) {
    PathQuery query{.start = ends->first, .goal = ends->second, .agent = path.agent};
    overlay.disc_paths.push_back({query, path});
  } else if (!path.points.empty()) {
    overlay.paths.push_back(path);
  }
}

SvgOverlay overlay_of(const py::object& paths, const py::object& polylines, const py::object& discs,
                      const py::object& labels) {
  SvgOverlay overlay;
  if (py::isinstance<Path>(paths)) {
    add_path(overlay, paths.cast<const Path&>());
  } else {
    for (const py::handle path : paths) add_path(overlay, path.cast<const Path&>());
  }
  for (const py::handle polyline : polylines) {
    const auto points = polyline.cast<PointsArg>();
    overlay.polylines.push_back({.points = {points.span().begin(), points.span().end()}});
  }
  for (const py::handle element : discs) {
    const auto disc = element.cast<std::tuple<Point, double>>();
    overlay.discs.push_back({.centre = std::get<0>(disc), .radius = std::get<1>(disc)});
  }
  for (const py::handle element : labels) {
    const auto label = element.cast<std::tuple<Point, std::string>>();
    overlay.labels.push_back({.at = std::get<0>(label), .text = std::get<1>(label)});
  }
  return overlay;
}

}  // namespace

template <class Class>
void bind_svg(Class& world) {
  using Handle = typename Class::type;
  world.def(
      "to_svg",
      [](const Handle& self, const py::object& paths, WAYWRIGHT_SVG_OPTIONS_PARAMETERS, const py::object& polylines,
         const py::object& discs, const py::object& labels) {
        const SvgOverlay overlay = overlay_of(paths, polylines, discs, labels);
        const SvgOptions options = to_svg_options(WAYWRIGHT_SVG_OPTIONS_NAMES);
        return self.read_long([&](const World& w) { return to_svg(w, overlay, options).value(); });
      },
      py::arg("paths") = py::tuple(), WAYWRIGHT_SVG_OPTIONS_ARGUMENTS, py::arg("polylines") = py::tuple(),
      py::arg("discs") = py::tuple(), py::arg("labels") = py::tuple(),
      R"(Returns a picture of the world as SVG text, with a path or a list of paths.

``polylines`` are lists of points, ``discs`` pairs (centre, radius), ``labels`` pairs (point, text). ``theme`` is
'automatic', 'light' or 'dark'.

>>> svg = world.to_svg(world.find_path((10, 45), (90, 45)), title="My world")
>>> svg.startswith("<svg")
True
)");
}

template void bind_svg(WorldClass& world);
template void bind_svg(SnapshotClass& snapshot);

}  // namespace waywright::python
