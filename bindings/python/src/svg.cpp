#include <optional>
#include <string>

#include "bind.hpp"

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
      [](const Handle& self, const py::object& paths, const py::object& polylines, const py::object& discs,
         const py::object& labels, double width, bool mesh, bool axes, bool ids, bool y_down, SvgTheme theme,
         std::optional<Box> crop, const std::string& title) {
        const SvgOverlay overlay = overlay_of(paths, polylines, discs, labels);
        const SvgOptions options{.width = width,
                                 .mesh = mesh,
                                 .axes = axes,
                                 .ids = ids,
                                 .y_down = y_down,
                                 .theme = theme,
                                 .crop = crop,
                                 .title = title};
        return self.read_long([&](const World& w) { return to_svg(w, overlay, options).value(); });
      },
      py::arg("paths") = py::tuple(), py::kw_only(), py::arg("polylines") = py::tuple(), py::arg("discs") = py::tuple(),
      py::arg("labels") = py::tuple(), py::arg("width") = 1200.0, py::arg("mesh") = true, py::arg("axes") = true,
      py::arg("ids") = true, py::arg("y_down") = false, py::arg("theme") = SvgTheme::automatic,
      py::arg("crop") = py::none(), py::arg("title") = "",
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
