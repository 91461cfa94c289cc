#pragma once

// Made by scripts/make_structs.py from bindings/structs.toml. Do not edit.

#include <limits>
#include <optional>

#include "convert.hpp"
#include "path.hpp"

// clang-format off

namespace waywright::python {

/// Adds the members of Agent and their pickle to its class.
inline void bind_members(py::class_<Agent>& cls) {
  cls
      .def_property_readonly("radius", [](const Agent& self) { return self.radius; },
                             R"(Of the disc, 0 or more; with the radius 0 the agent is a point.)")
      .def(py::pickle([](const Agent& self) { return py::make_tuple(self.radius); },
                      [](const py::tuple& state) {
                        if (state.size() != 1) throw py::value_error("the pickle is damaged");
                        Agent result;
                        result.radius = state[0].cast<decltype(result.radius)>();
                        return result;
                      }));
}
// The options of Agent as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_AGENT_PARAMETERS double radius
#define WAYWRIGHT_AGENT_NAMES radius
#define WAYWRIGHT_AGENT_ARGUMENTS py::kw_only(), py::arg("radius") = 0.0
inline Agent to_agent(WAYWRIGHT_AGENT_PARAMETERS) {
  Agent result{};
  result.radius = radius;
  return result;
}

/// Returns the members of WorldOptions by name.
inline py::dict to_dict(const WorldOptions& given) {
  py::dict result;
  result["keep_abstraction"] = given.keep_abstraction;
  result["keep_bridges"] = given.keep_bridges;
  result["new_vertex_limit"] = given.new_vertex_limit == kNoVertexLimit ? py::object(py::none()) : py::object(py::int_(given.new_vertex_limit));
  return result;
}
// The options of WorldOptions as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_WORLD_OPTIONS_PARAMETERS bool keep_abstraction, bool keep_bridges, std::optional<std::size_t> new_vertex_limit
#define WAYWRIGHT_WORLD_OPTIONS_NAMES keep_abstraction, keep_bridges, new_vertex_limit
#define WAYWRIGHT_WORLD_OPTIONS_ARGUMENTS py::kw_only(), py::arg("keep_abstraction") = true, py::arg("keep_bridges") = false, py::arg("new_vertex_limit") = py::none()
inline WorldOptions to_world_options(WAYWRIGHT_WORLD_OPTIONS_PARAMETERS) {
  WorldOptions result{};
  result.keep_abstraction = keep_abstraction;
  result.keep_bridges = keep_bridges;
  result.new_vertex_limit = new_vertex_limit.value_or(kNoVertexLimit);
  return result;
}

// The options of SvgOptions as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_SVG_OPTIONS_PARAMETERS SvgTheme theme, double width, bool mesh, bool axes, bool ids, bool y_down, std::optional<Box> crop, const std::string& title
#define WAYWRIGHT_SVG_OPTIONS_NAMES theme, width, mesh, axes, ids, y_down, crop, title
#define WAYWRIGHT_SVG_OPTIONS_ARGUMENTS py::kw_only(), py::arg("theme") = SvgTheme::automatic, py::arg("width") = 1200.0, py::arg("mesh") = true, py::arg("axes") = true, py::arg("ids") = true, py::arg("y_down") = false, py::arg("crop") = py::none(), py::arg("title") = ""
inline SvgOptions to_svg_options(WAYWRIGHT_SVG_OPTIONS_PARAMETERS) {
  SvgOptions result{};
  result.theme = theme;
  result.width = width;
  result.mesh = mesh;
  result.axes = axes;
  result.ids = ids;
  result.y_down = y_down;
  result.crop = crop;
  result.title = title;
  return result;
}

/// Adds the members of RayHit and their pickle to its class.
inline void bind_members(py::class_<RayHit>& cls) {
  cls
      .def_property_readonly("hit", [](const RayHit& self) { return self.hit; },
                             R"(Whether the agent touches a wall; if not, the points have no meaning.)")
      .def_property_readonly("at", [](const RayHit& self) { return self.at; },
                             R"(Where the agent is when it first touches a wall, rounded.)")
      .def_property_readonly("items", [](const RayHit& self) { return self.items; },
                             R"(The ids of the items that the agent touches there, ascending; 0 is the border of the domain.)")
      .def_property_readonly("contact", [](const RayHit& self) { return self.contact; },
                             R"(The position on the touched walls that is nearest to ``at``; for a point agent, it equals ``at``.)")
      .def(py::pickle([](const RayHit& self) { return py::make_tuple(self.hit, self.at, bytes_of(self.items), self.contact); },
                      [](const py::tuple& state) {
                        if (state.size() != 4) throw py::value_error("the pickle is damaged");
                        RayHit result;
                        result.hit = state[0].cast<decltype(result.hit)>();
                        result.at = state[1].cast<decltype(result.at)>();
                        result.items = from_bytes<ItemId>(state[2].cast<py::bytes>());
                        result.contact = state[3].cast<decltype(result.contact)>();
                        return result;
                      }));
}

/// Adds the members of DiscFit and their pickle to its class.
inline void bind_members(py::class_<DiscFit>& cls) {
  cls
      .def_property_readonly("fits", [](const DiscFit& self) { return self.fits; },
                             R"(Whether the disc fits.)")
      .def_property_readonly("items", [](const DiscFit& self) { return self.items; },
                             R"(The ids of the items that stop the disc, ascending; 0 is the border of the domain.)")
      .def(py::pickle([](const DiscFit& self) { return py::make_tuple(self.fits, bytes_of(self.items)); },
                      [](const py::tuple& state) {
                        if (state.size() != 2) throw py::value_error("the pickle is damaged");
                        DiscFit result;
                        result.fits = state[0].cast<decltype(result.fits)>();
                        result.items = from_bytes<ItemId>(state[1].cast<py::bytes>());
                        return result;
                      }));
}

// The options of NearestFitQuery as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_NEAREST_FIT_QUERY_PARAMETERS const Agent& agent, std::optional<Point> goal, double limit
#define WAYWRIGHT_NEAREST_FIT_QUERY_NAMES agent, goal, limit
#define WAYWRIGHT_NEAREST_FIT_QUERY_ARGUMENTS py::arg("agent"), py::kw_only(), py::arg("goal") = py::none(), py::arg("limit") = std::numeric_limits<double>::infinity()
inline NearestFitQuery to_nearest_fit_query(Point point, WAYWRIGHT_NEAREST_FIT_QUERY_PARAMETERS) {
  NearestFitQuery result{};
  result.point = point;
  result.agent = agent;
  result.goal = goal;
  result.limit = limit;
  return result;
}

/// Adds the members of NearestFit and their pickle to its class.
inline void bind_members(py::class_<NearestFit>& cls) {
  cls
      .def_property_readonly("is_found", [](const NearestFit& self) { return self.is_found; },
                             R"(Whether there is an answer within the limit; if not, the other members are 0.)")
      .def_property_readonly("at", [](const NearestFit& self) { return self.at; },
                             R"(The point; that the disc fits there is an exact decision.)")
      .def_property_readonly("distance", [](const NearestFit& self) { return self.distance; },
                             R"(The distance from the point of the query to ``at``.)")
      .def(py::pickle([](const NearestFit& self) { return py::make_tuple(self.is_found, self.at, self.distance); },
                      [](const py::tuple& state) {
                        if (state.size() != 3) throw py::value_error("the pickle is damaged");
                        NearestFit result;
                        result.is_found = state[0].cast<decltype(result.is_found)>();
                        result.at = state[1].cast<decltype(result.at)>();
                        result.distance = state[2].cast<decltype(result.distance)>();
                        return result;
                      }));
}

/// Adds the members of WidestPath and their pickle to its class.
inline void bind_members(py::class_<WidestPath>& cls) {
  cls
      .def_property_readonly("is_connected", [](const WidestPath& self) { return self.is_connected; },
                             R"(Whether a disc with a radius above 0 can move to the goal; if not, all others are 0.)")
      .def_property_readonly("is_limited", [](const WidestPath& self) { return self.is_limited; },
                             R"(Whether a gap between the ends limits the disc.)")
      .def_property_readonly("radius", [](const WidestPath& self) { return self.radius; },
                             R"(The largest radius of a disc that passes all gaps; infinity if no gap limits it.)")
      .def_property_readonly("from_items", [](const WidestPath& self) { return self.from_items; },
                             R"(The ids of the items at the first end of the gap; 0 is the border of the domain.)")
      .def_property_readonly("to_items", [](const WidestPath& self) { return self.to_items; },
                             R"(The ids of the items at the second end of the gap.)")
      .def(py::pickle([](const WidestPath& self) { return py::make_tuple(self.is_connected, self.is_limited, self.radius, self.from, self.to, bytes_of(self.from_items), bytes_of(self.to_items)); },
                      [](const py::tuple& state) {
                        if (state.size() != 7) throw py::value_error("the pickle is damaged");
                        WidestPath result;
                        result.is_connected = state[0].cast<decltype(result.is_connected)>();
                        result.is_limited = state[1].cast<decltype(result.is_limited)>();
                        result.radius = state[2].cast<decltype(result.radius)>();
                        result.from = state[3].cast<decltype(result.from)>();
                        result.to = state[4].cast<decltype(result.to)>();
                        result.from_items = from_bytes<ItemId>(state[5].cast<py::bytes>());
                        result.to_items = from_bytes<ItemId>(state[6].cast<py::bytes>());
                        return result;
                      }));
}

// The options of PathQuery as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_PATH_QUERY_PARAMETERS const Agent& agent, PathAlgorithm algorithm, std::optional<double> end_tolerance, std::optional<std::size_t> budget_expansions, std::optional<double> budget_time, bool wants_channel, bool wants_time
#define WAYWRIGHT_PATH_QUERY_NAMES agent, algorithm, end_tolerance, budget_expansions, budget_time, wants_channel, wants_time
#define WAYWRIGHT_PATH_QUERY_ARGUMENTS py::arg("agent") = Agent{}, py::arg("algorithm") = PathAlgorithm::optimal, py::kw_only(), py::arg("end_tolerance") = py::none(), py::arg("budget_expansions") = py::none(), py::arg("budget_time") = py::none(), py::arg("wants_channel") = false, py::arg("wants_time") = false
// The same for a batch: it has one agent for all queries or one for each.
#define WAYWRIGHT_PATH_QUERY_BATCH_PARAMETERS const AgentsArg& agent, PathAlgorithm algorithm, std::optional<double> end_tolerance, std::optional<std::size_t> budget_expansions, std::optional<double> budget_time
#define WAYWRIGHT_PATH_QUERY_BATCH_NAMES Agent{}, algorithm, end_tolerance, budget_expansions, budget_time, false, false
#define WAYWRIGHT_PATH_QUERY_BATCH_ARGUMENTS py::arg("agent") = Agent{}, py::arg("algorithm") = PathAlgorithm::optimal, py::kw_only(), py::arg("end_tolerance") = py::none(), py::arg("budget_expansions") = py::none(), py::arg("budget_time") = py::none()
inline PathQuery to_path_query(Point start, Point goal, WAYWRIGHT_PATH_QUERY_PARAMETERS) {
  PathQuery result{};
  result.start = start;
  result.goal = goal;
  result.agent = agent;
  result.algorithm = algorithm;
  result.end_tolerance = end_tolerance;
  result.wants_channel = wants_channel;
  result.wants_time = wants_time;
  set_budget(result.budget, budget_expansions, budget_time);
  return result;
}

// The options of ManyGoalsQuery as parameters, as names, and as arguments of pybind11.
#define WAYWRIGHT_MANY_GOALS_QUERY_PARAMETERS const Agent& agent, bool wants_points, std::optional<double> end_tolerance
#define WAYWRIGHT_MANY_GOALS_QUERY_NAMES agent, wants_points, end_tolerance
#define WAYWRIGHT_MANY_GOALS_QUERY_ARGUMENTS py::arg("agent") = Agent{}, py::kw_only(), py::arg("wants_points") = false, py::arg("end_tolerance") = py::none()
inline ManyGoalsQuery to_many_goals_query(Point start, const PointsArg& goals, WAYWRIGHT_MANY_GOALS_QUERY_PARAMETERS) {
  ManyGoalsQuery result{};
  result.start = start;
  result.goals = goals.span();
  result.agent = agent;
  result.wants_points = wants_points;
  result.end_tolerance = end_tolerance;
  return result;
}

/// Adds the members of PathPosition and their pickle to its class.
inline void bind_members(py::class_<PathPosition>& cls) {
  cls
      .def_property_readonly("at", [](const PathPosition& self) { return self.at; },
                             R"(The point at this position.)")
      .def_property_readonly("heading", [](const PathPosition& self) { return self.heading; },
                             R"(The direction of the path there, of length 1; (0, 0) on a path of length 0.)")
      .def_property_readonly("segment", [](const PathPosition& self) { return self.segment; },
                             R"(The position lies between the points ``segment`` and ``segment`` + 1, or on the piece ``segment``.)")
      .def_property_readonly("before", [](const PathPosition& self) { return self.before; },
                             R"(The length of the path from its start to the start of this segment or piece.)")
      .def_property_readonly("distance", [](const PathPosition& self) { return self.distance; },
                             R"(The length of the path from its start to this position.)")
      .def(py::pickle([](const PathPosition& self) { return py::make_tuple(self.at, self.heading, self.segment, self.before, self.distance); },
                      [](const py::tuple& state) {
                        if (state.size() != 5) throw py::value_error("the pickle is damaged");
                        PathPosition result;
                        result.at = state[0].cast<decltype(result.at)>();
                        result.heading = state[1].cast<decltype(result.heading)>();
                        result.segment = state[2].cast<decltype(result.segment)>();
                        result.before = state[3].cast<decltype(result.before)>();
                        result.distance = state[4].cast<decltype(result.distance)>();
                        return result;
                      }));
}

/// Returns the members of MemoryUse by name.
inline py::dict to_dict(const MemoryUse& given) {
  py::dict result;
  result["vertices"] = given.vertices;
  result["crossings"] = given.crossings;
  result["faces"] = given.faces;
  result["walls"] = given.walls;
  result["items"] = given.items;
  result["sectors"] = given.sectors;
  result["abstraction"] = given.abstraction;
  result["bridges"] = given.bridges;
  result["history"] = given.history;
  result["spare"] = given.spare;
  result["total"] = given.total();
  return result;
}

}  // namespace waywright::python
