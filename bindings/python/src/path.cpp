#include "path.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "bind.hpp"
#include "structs.hpp"

// Paths and positions on them.

namespace waywright::python {

namespace {

using PathClass = py::class_<Path>;

constexpr double kNanosecondsPerSecond = 1e9;

const Path& found(const Path& path) {
  if (path.status != PathStatus::found) throw py::value_error("this path was not found: it has no positions");
  if (path.points.empty() && path.pieces.empty()) {
    throw py::value_error("this path has no points: find_paths_from() gives them with wants_points=True");
  }
  return path;
}

py::array pieces_of(const py::object& self) {
  const auto& pieces = self.cast<const Path&>().pieces;
  if (pieces.empty()) return py::array(piece_type(), py::ssize_t{0});
  py::array array(piece_type(), {static_cast<py::ssize_t>(pieces.size())}, {sizeof(PathPiece)}, pieces.data(), self);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array channel_of(const py::object& self) {
  const auto& channel = self.cast<const Path&>().channel;
  const auto count = static_cast<py::ssize_t>(channel.size());
  return view_numbers(channel.empty() ? nullptr : &channel.data()->left.x, {count, 2, 2},
                      {sizeof(Portal), sizeof(Point), sizeof(double)}, self);
}

std::optional<std::pair<Point, Point>> moved(const std::optional<MovedEnd>& end) {
  if (!end) return std::nullopt;
  return std::pair(end->from, end->to);
}

std::optional<MovedEnd> moved_from(const py::object& end) {
  if (end.is_none()) return std::nullopt;
  const auto pair = end.cast<std::pair<Point, Point>>();
  return MovedEnd{pair.first, pair.second};
}

std::size_t segment_count(const Path& path) {
  return path.pieces.empty() ? std::max<std::size_t>(path.points.size(), 2) - 1 : path.pieces.size();
}

std::vector<Point> walk(const Path& path, double step) {
  constexpr double kMostSteps = 1e7;
  if (!(step > 0.0)) throw py::value_error("the step must be above 0");
  if (!(path.length / step <= kMostSteps)) {
    throw py::value_error("the step is too small: a walk along this path would take more than 10,000,000 steps");
  }
  PathPosition position = path.at(0.0);
  std::vector<Point> points = {position.at};
  for (double before = -1.0; position.distance < path.length && position.distance > before;) {
    before = position.distance;
    position = path.advance(position, step);
    points.push_back(position.at);
  }
  return points;
}

std::string repr_of(const Path& path) {
  if (path.status != PathStatus::found) return "<waywright.Path " + std::string(to_string(path.status)) + ">";
  const py::str length = py::repr(py::float_(path.length));
  const std::string count = path.pieces.empty() ? std::to_string(path.points.size()) + " points"
                                                : std::to_string(path.pieces.size()) + " pieces, radius " +
                                                      std::string(py::str(py::repr(py::float_(path.agent.radius))));
  return "<waywright.Path found, length " + std::string(length) + ", " + count + ">";
}

/// The ends of a query for a pickle.
py::object state_of_ends(const std::optional<QueryEnds>& ends) {
  if (!ends) return py::none();
  return py::make_tuple(ends->start, ends->goal, ends->end_tolerance, ends->has_many_goals);
}

std::optional<QueryEnds> ends_from(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto ends = state.cast<py::tuple>();
  if (ends.size() != 4) throw py::value_error("the pickled path is damaged");
  return QueryEnds{ends[0].cast<Point>(), ends[1].cast<Point>(), ends[2].cast<std::optional<double>>(),
                   ends[3].cast<bool>()};
}

py::tuple state_of(const Path& path) {
  return py::make_tuple(path.status, path.length, path.lower_bound, path.agent, bytes_of(path.points),
                        bytes_of(path.pieces), bytes_of(path.channel), path.expansions, path.time.count(),
                        moved(path.moved_start), moved(path.moved_goal), bytes_of(path.blockers),
                        path.widest ? py::cast(*path.widest) : py::none(), state_of_ends(path.ends));
}

/// Returns whether the numbers of a piece are plausible, so that each function of a path ends.
bool is_usable(const PathPiece& piece) {
  constexpr double kLargestAngle = 16.0;  // an arc starts between -pi and pi, and turns by less than a circle
  const bool has_kind = piece.kind == PathPiece::Kind::line || piece.kind == PathPiece::Kind::arc;
  const bool has_angles = std::abs(piece.start_angle) <= kLargestAngle && std::abs(piece.end_angle) <= kLargestAngle;
  return has_kind && has_angles && is_in_range(piece.from) && is_in_range(piece.to) && is_in_range(piece.centre) &&
         is_in_range(piece.radius);
}

bool is_usable(const QueryEnds& ends) {
  return is_in_range(ends.start) && is_in_range(ends.goal) && (!ends.end_tolerance || *ends.end_tolerance >= 0.0);
}

/// Returns whether the numbers of a path are plausible. The numbers in a damaged pickle may not be.
bool is_usable(const Path& path) {
  return std::isfinite(path.length) && path.length >= 0.0 && std::isfinite(path.agent.radius) &&
         path.agent.radius >= 0.0 && (!path.ends || is_usable(*path.ends)) &&
         std::all_of(path.points.begin(), path.points.end(), [](const Point& point) { return is_in_range(point); }) &&
         std::all_of(path.pieces.begin(), path.pieces.end(), [&](const PathPiece& piece) {
           return is_usable(piece) &&
                  piece.radius <= path.agent.radius;  // polyline() counts with the radius of the path
         });
}

std::unique_ptr<Path> path_from(const py::tuple& state) {
  if (state.size() != 14) throw py::value_error("the pickled path is damaged");
  auto path = std::make_unique<Path>();
  path->status = state[0].cast<PathStatus>();
  path->length = state[1].cast<double>();
  path->lower_bound = state[2].cast<double>();
  path->agent = state[3].cast<Agent>();
  path->points = from_bytes<Point>(state[4].cast<py::bytes>());
  path->pieces = from_bytes<PathPiece>(state[5].cast<py::bytes>());
  path->channel = from_bytes<Portal>(state[6].cast<py::bytes>());
  path->expansions = state[7].cast<std::size_t>();
  path->time = std::chrono::nanoseconds(state[8].cast<std::int64_t>());
  path->moved_start = moved_from(state[9]);
  path->moved_goal = moved_from(state[10]);
  path->blockers = from_bytes<ItemId>(state[11].cast<py::bytes>());
  if (!state[12].is_none()) path->widest = state[12].cast<WidestPath>();
  path->ends = ends_from(state[13]);
  if (!is_usable(*path)) throw py::value_error("the pickled path is damaged");
  return path;
}

void bind_position(py::module_& module) {
  py::class_<PathPosition> position(module, "PathPosition", "A position on a path.");
  bind_members(position);
  position.def("__repr__", [](const PathPosition& self) {
    return "<waywright.PathPosition " + to_string(self.at) + " at distance " +
           std::string(py::str(py::repr(py::float_(self.distance)))) + ">";
  });
}

void bind_walk(PathClass& path) {
  path.def(
          "at",
          [](const Path& self, double distance, Precision precision) { return found(self).at(distance, precision); },
          py::arg("distance"), py::arg("precision") = Precision::float64,
          R"(Returns the position at a distance from the start, along the path.

The result is rounded so that it does not lie beyond a wall. ``precision`` is 'float64' or 'float32'.

>>> world.find_path((10, 70), (90, 70)).at(15)
<waywright.PathPosition (25, 70) at distance 15.0>
)")
      .def(
          "advance",
          [](const Path& self, const PathPosition& position, double step, Precision precision) {
            if (position.segment >= segment_count(found(self))) {
              throw py::value_error("the position is not on this path: take one that this path has returned");
            }
            return self.advance(position, step, precision);
          },
          py::arg("position"), py::arg("step"), py::arg("precision") = Precision::float64,
          "Returns the position that lies ``step`` farther along the path than a position that this path has returned.")
      .def(
          "nearest",
          [](const Path& self, Point point, Precision precision) { return found(self).nearest(point, precision); },
          py::arg("point"), py::arg("precision") = Precision::float64,
          "Returns the position on the path that is nearest to a point.")
      .def(
          "walk", [](const Path& self, double step) { return own_points(walk(found(self), step)); }, py::arg("step"),
          R"(Returns the positions of an agent that starts at the start of the path and walks ``step`` in each tick.

>>> world.find_path((10, 70), (30, 70)).walk(8)
array([[10., 70.],
       [18., 70.],
       [26., 70.],
       [30., 70.]])
)")
      .def(
          "polyline", [](const Path& self, double tolerance) { return own_points(self.polyline(tolerance).value()); },
          py::arg("tolerance"), R"(Returns the path as points: no arc is farther than ``tolerance`` from them.

>>> world.find_path((10, 45), (90, 45), agent=waywright.Agent(radius=5)).polyline(0.5).shape
(6, 2)
)");
}

void bind_facts(PathClass& path) {
  path.def_property_readonly(
          "status", [](const Path& self) { return self.status; },
          "'found', 'start-blocked', 'goal-blocked' or 'no-path'.")
      .def_property_readonly(
          "found", [](const Path& self) { return self.status == PathStatus::found; }, "Whether there is a path.")
      .def_property_readonly(
          "length", [](const Path& self) { return self.length; }, "The length; 0 if there is no path.")
      .def_property_readonly(
          "lower_bound", [](const Path& self) { return self.lower_bound; },
          "A lower bound: no path is shorter than this number.")
      .def_property_readonly(
          "agent", [](const Path& self) { return self.agent; }, "The agent of the query.")
      .def_property_readonly(
          "points", [](const py::object& self) { return view_points(self.cast<const Path&>().points, self); },
          "The start, the turns and the goal: an array that shares the memory of the path. It is empty for a "
          "radius above 0.")
      .def_property_readonly(
          "pieces", &pieces_of,
          "The lines and arcs of a path for a radius above 0: a structured array with the fields kind "
          "(0: line, 1: arc), from, to, centre, radius, start_angle and end_angle.")
      .def_property_readonly("channel", &channel_of,
                             "The edges that the path crosses, if the query wants them: an array (N, 2, 2).")
      .def_property_readonly(
          "expansions", [](const Path& self) { return self.expansions; },
          "The number of triangles that the search entered.")
      .def_property_readonly(
          "time", [](const Path& self) { return static_cast<double>(self.time.count()) / kNanosecondsPerSecond; },
          "The seconds that the search took, if the query wants them.")
      .def_property_readonly(
          "moved_start", [](const Path& self) { return moved(self.moved_start); },
          "If the search moved the start: the start of the query, and the point where the path begins. Otherwise None.")
      .def_property_readonly(
          "moved_goal", [](const Path& self) { return moved(self.moved_goal); },
          "If the search moved the goal: the goal of the query, and the point where the path ends. Otherwise None.")
      .def_property_readonly(
          "blockers", [](const Path& self) { return self.blockers; },
          "The ids of the items that block an end, ascending.")
      .def_property_readonly(
          "widest", [](const Path& self) { return self.widest; },
          "A WidestPath: the largest disc that can move from start to goal, if the disc of the query cannot. Otherwise "
          "None.");
}

}  // namespace

void set_budget(PathBudget& budget, std::optional<std::size_t> expansions, std::optional<double> time) {
  budget.expansions = expansions.value_or(time ? PathBudget::kNoLimit : 0);
  if (!time) return;
  if (!(*time >= 0.0)) throw py::value_error("budget_time must be a number of seconds, 0 or more");
  constexpr double kLongest = 1e9;  // thirty years
  if (*time < kLongest) {
    budget.time = std::chrono::nanoseconds(static_cast<std::int64_t>(*time * kNanosecondsPerSecond));
  }
}

py::dtype piece_type() {
  static_assert(sizeof(PathPiece::Kind) == 1);
  const auto names = py::make_tuple("kind", "from", "to", "centre", "radius", "start_angle", "end_angle");
  const auto formats = py::make_tuple("u1", "2f8", "2f8", "2f8", "f8", "f8", "f8");
  const auto offsets = py::make_tuple(offsetof(PathPiece, kind), offsetof(PathPiece, from), offsetof(PathPiece, to),
                                      offsetof(PathPiece, centre), offsetof(PathPiece, radius),
                                      offsetof(PathPiece, start_angle), offsetof(PathPiece, end_angle));
  return py::dtype(py::list(names), py::list(formats), py::list(offsets), sizeof(PathPiece));
}

void bind_path(py::module_& module) {
  bind_position(module);
  PathClass path(module, "Path", R"(
The answer to a path query: the path, and facts about the search.

>>> path = world.find_path((10, 45), (90, 45))
>>> path
<waywright.Path found, length 80.8276253029822, 4 points>
>>> path.points
array([[10., 45.],
       [40., 40.],
       [60., 40.],
       [90., 45.]])
)");
  bind_facts(path);
  bind_walk(path);
  path.def("__bool__", [](const Path& self) { return self.status == PathStatus::found; })
      .def("__repr__", &repr_of)
      .def(py::pickle(&state_of, &path_from));
  module.attr("PIECE_DTYPE") = piece_type();
}

}  // namespace waywright::python
