#pragma once

// Made by scripts/make_structs.py from bindings/structs.toml. Do not edit.

#include <chrono>
#include <cstdint>
#include <limits>

#include "internal.hpp"

// clang-format off

namespace waywright::c {

// Agent. If it has members that the table lacks, this function does not compile.
inline void check_members(const Agent& given) {
  [[maybe_unused]] const auto& [m0] = given;
  static_cast<void>(given.radius);
}
inline Agent to_cpp(const ww_agent& given) {
  Agent result{};
  result.radius = given.radius;
  return result;
}
/// Reads an agent that may be null: then it is a point.
inline Agent to_cpp(const ww_agent* given) { return given != nullptr ? to_cpp(*given) : Agent{}; }
inline ww_agent to_c(const Agent& given) {
  ww_agent result{};
  result.radius = given.radius;
  return result;
}

// MovedEnd. If it has members that the table lacks, this function does not compile.
inline void check_members(const MovedEnd& given) {
  [[maybe_unused]] const auto& [m0, m1] = given;
  static_cast<void>(given.from);
  static_cast<void>(given.to);
}
inline MovedEnd to_cpp(const ww_moved_end& given) {
  MovedEnd result{};
  result.from = to_cpp(given.from);
  result.to = to_cpp(given.to);
  return result;
}
inline ww_moved_end to_c(const MovedEnd& given) {
  ww_moved_end result{};
  result.from = to_c(given.from);
  result.to = to_c(given.to);
  return result;
}

// Portal. If it has members that the table lacks, this function does not compile.
inline void check_members(const Portal& given) {
  [[maybe_unused]] const auto& [m0, m1] = given;
  static_cast<void>(given.left);
  static_cast<void>(given.right);
}
inline ww_portal to_c(const Portal& given) {
  ww_portal result{};
  result.left = to_c(given.left);
  result.right = to_c(given.right);
  return result;
}

// WorldOptions. If it has members that the table lacks, this function does not compile.
inline void check_members(const WorldOptions& given) {
  [[maybe_unused]] const auto& [m0, m1, m2] = given;
  static_cast<void>(given.keep_abstraction);
  static_cast<void>(given.keep_bridges);
  static_cast<void>(given.new_vertex_limit);
}
inline constexpr ww_world_options kDefaultWorldOptions{
    .struct_size = sizeof(ww_world_options),
    .keep_abstraction = 1,
    .keep_bridges = 0,
    .new_vertex_limit = kNoVertexLimit,
};
inline WorldOptions to_cpp(const ww_world_options& given) {
  WorldOptions result{};
  result.keep_abstraction = is_set(given.keep_abstraction);
  result.keep_bridges = is_set(given.keep_bridges);
  result.new_vertex_limit = given.new_vertex_limit;
  return result;
}
inline ww_world_options to_c(const WorldOptions& given) {
  ww_world_options result{};
  result.keep_abstraction = to_c(given.keep_abstraction);
  result.keep_bridges = to_c(given.keep_bridges);
  result.new_vertex_limit = given.new_vertex_limit;
  return result;
}

// SvgOptions. If it has members that the table lacks, this function does not compile.
inline void check_members(const SvgOptions& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6, m7] = given;
  static_cast<void>(given.theme);
  static_cast<void>(given.width);
  static_cast<void>(given.mesh);
  static_cast<void>(given.axes);
  static_cast<void>(given.ids);
  static_cast<void>(given.y_down);
  static_cast<void>(given.crop);
  static_cast<void>(given.title);
}
inline constexpr ww_svg_options kDefaultSvgOptions{
    .struct_size = sizeof(ww_svg_options),
    .theme = WW_SVG_AUTOMATIC,
    .width = 1200.0,
    .mesh = 1,
    .axes = 1,
    .ids = 1,
    .y_down = 0,
    .has_crop = 0,
    .crop = {},
    .title = nullptr,
};
inline SvgOptions to_cpp(const ww_svg_options& given) {
  SvgOptions result{};
  result.theme = to_enum(given.theme, SvgTheme::dark);
  result.width = given.width;
  result.mesh = is_set(given.mesh);
  result.axes = is_set(given.axes);
  result.ids = is_set(given.ids);
  result.y_down = is_set(given.y_down);
  if (is_set(given.has_crop)) result.crop = to_cpp(given.crop);
  result.title = std::string(text_or_empty(given.title));
  return result;
}

// CrossedItem. If it has members that the table lacks, this function does not compile.
inline void check_members(const CrossedItem& given) {
  [[maybe_unused]] const auto& [m0, m1] = given;
  static_cast<void>(given.id);
  static_cast<void>(given.at);
}
inline ww_crossed_item to_c(const CrossedItem& given) {
  ww_crossed_item result{};
  result.id = to_c(given.id);
  result.at = to_c(given.at);
  return result;
}

// RayHit. If it has members that the table lacks, this function does not compile.
inline void check_members(const RayHit& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3] = given;
  static_cast<void>(given.hit);
  static_cast<void>(given.at);
  static_cast<void>(given.items);
  static_cast<void>(given.contact);
}
inline ww_ray_hit to_c(const RayHit& given) {
  ww_ray_hit result{};
  result.hit = to_c(given.hit);
  result.at = to_c(given.at);
  result.contact = to_c(given.contact);
  return result;
}

// NearestFitQuery. If it has members that the table lacks, this function does not compile.
inline void check_members(const NearestFitQuery& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3] = given;
  static_cast<void>(given.point);
  static_cast<void>(given.agent);
  static_cast<void>(given.goal);
  static_cast<void>(given.limit);
}
inline constexpr ww_nearest_fit_query kDefaultNearestFitQuery{
    .struct_size = sizeof(ww_nearest_fit_query),
    .point = {},
    .agent = {},
    .has_goal = 0,
    .goal = {},
    .limit = std::numeric_limits<double>::infinity(),
};
inline NearestFitQuery to_cpp(const ww_nearest_fit_query& given) {
  NearestFitQuery result{};
  result.point = to_cpp(given.point);
  result.agent = to_cpp(given.agent);
  if (is_set(given.has_goal)) result.goal = to_cpp(given.goal);
  result.limit = given.limit;
  return result;
}

// NearestFit. If it has members that the table lacks, this function does not compile.
inline void check_members(const NearestFit& given) {
  [[maybe_unused]] const auto& [m0, m1, m2] = given;
  static_cast<void>(given.is_found);
  static_cast<void>(given.at);
  static_cast<void>(given.distance);
}
inline ww_nearest_fit to_c(const NearestFit& given) {
  ww_nearest_fit result{};
  result.is_found = to_c(given.is_found);
  result.at = to_c(given.at);
  result.distance = given.distance;
  return result;
}

// WidestPath. If it has members that the table lacks, this function does not compile.
inline void check_members(const WidestPath& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6] = given;
  static_cast<void>(given.is_connected);
  static_cast<void>(given.is_limited);
  static_cast<void>(given.radius);
  static_cast<void>(given.from);
  static_cast<void>(given.to);
  static_cast<void>(given.from_items);
  static_cast<void>(given.to_items);
}
inline ww_widest_path to_c(const WidestPath& given) {
  ww_widest_path result{};
  result.is_connected = to_c(given.is_connected);
  result.is_limited = to_c(given.is_limited);
  result.radius = given.radius;
  result.from = to_c(given.from);
  result.to = to_c(given.to);
  return result;
}

// Bridge. If it has members that the table lacks, this function does not compile.
inline void check_members(const Bridge& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6] = given;
  static_cast<void>(given.from);
  static_cast<void>(given.to);
  static_cast<void>(given.radius);
  static_cast<void>(given.has_foot);
  static_cast<void>(given.first_id);
  static_cast<void>(given.from_count);
  static_cast<void>(given.to_count);
}
inline ww_bridge to_c(const Bridge& given) {
  ww_bridge result{};
  result.from = to_c(given.from);
  result.to = to_c(given.to);
  result.radius = given.radius;
  result.has_foot = to_c(given.has_foot);
  result.first_id = given.first_id;
  result.from_count = given.from_count;
  result.to_count = given.to_count;
  return result;
}

// PathQuery. If it has members that the table lacks, this function does not compile.
inline void check_members(const PathQuery& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6, m7] = given;
  static_cast<void>(given.start);
  static_cast<void>(given.goal);
  static_cast<void>(given.agent);
  static_cast<void>(given.algorithm);
  static_cast<void>(given.end_tolerance);
  static_cast<void>(given.budget);
  static_cast<void>(given.wants_channel);
  static_cast<void>(given.wants_time);
}
inline constexpr ww_path_query kDefaultPathQuery{
    .struct_size = sizeof(ww_path_query),
    .start = {},
    .goal = {},
    .agent = {},
    .algorithm = WW_ALGORITHM_OPTIMAL,
    .has_end_tolerance = 0,
    .end_tolerance = {},
    .budget_expansions = 0,
    .budget_nanoseconds = std::numeric_limits<std::int64_t>::max(),
    .wants_channel = 0,
    .wants_time = 0,
};
inline PathQuery to_cpp(const ww_path_query& given) {
  PathQuery result{};
  result.start = to_cpp(given.start);
  result.goal = to_cpp(given.goal);
  result.agent = to_cpp(given.agent);
  result.algorithm = to_enum(given.algorithm, PathAlgorithm::optimal);
  if (is_set(given.has_end_tolerance)) result.end_tolerance = given.end_tolerance;
  result.budget.expansions = to_expansions(given.budget_expansions);
  result.budget.time = std::chrono::nanoseconds(given.budget_nanoseconds);
  result.wants_channel = is_set(given.wants_channel);
  result.wants_time = is_set(given.wants_time);
  return result;
}

// ManyGoalsQuery. If it has members that the table lacks, this function does not compile.
inline void check_members(const ManyGoalsQuery& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4] = given;
  static_cast<void>(given.start);
  static_cast<void>(given.goals);
  static_cast<void>(given.agent);
  static_cast<void>(given.wants_points);
  static_cast<void>(given.end_tolerance);
}
inline constexpr ww_many_goals_query kDefaultManyGoalsQuery{
    .struct_size = sizeof(ww_many_goals_query),
    .start = {},
    .goals = nullptr,
    .goal_count = 0,
    .agent = {},
    .wants_points = 0,
    .has_end_tolerance = 0,
    .end_tolerance = {},
};
inline ManyGoalsQuery to_cpp(const ww_many_goals_query& given) {
  ManyGoalsQuery result{};
  result.start = to_cpp(given.start);
  result.goals = to_points(given.goals, given.goal_count);
  result.agent = to_cpp(given.agent);
  result.wants_points = is_set(given.wants_points);
  if (is_set(given.has_end_tolerance)) result.end_tolerance = given.end_tolerance;
  return result;
}

// PathInfo. If it has members that the table lacks, this function does not compile.
inline void check_members(const Path& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13] = given;
  static_cast<void>(given.status);
  static_cast<void>(given.length);
  static_cast<void>(given.lower_bound);
  static_cast<void>(given.agent);
  static_cast<void>(given.expansions);
  static_cast<void>(given.time);
  static_cast<void>(given.points);
  static_cast<void>(given.pieces);
  static_cast<void>(given.channel);
  static_cast<void>(given.blockers);
  static_cast<void>(given.moved_start);
  static_cast<void>(given.moved_goal);
  static_cast<void>(given.widest);
  static_cast<void>(given.ends);
}
inline ww_path_info to_c(const Path& given) {
  ww_path_info result{};
  result.status = static_cast<ww_path_status>(given.status);
  result.length = given.length;
  result.lower_bound = given.lower_bound;
  result.agent = to_c(given.agent);
  result.expansions = given.expansions;
  result.nanoseconds = given.time.count();
  result.point_count = given.points.size();
  result.piece_count = given.pieces.size();
  result.channel_count = given.channel.size();
  result.blocker_count = given.blockers.size();
  result.has_moved_start = to_c(given.moved_start.has_value());
  if (given.moved_start) result.moved_start = to_c(*given.moved_start);
  result.has_moved_goal = to_c(given.moved_goal.has_value());
  if (given.moved_goal) result.moved_goal = to_c(*given.moved_goal);
  result.has_widest = to_c(given.widest.has_value());
  return result;
}

// PathPiece. If it has members that the table lacks, this function does not compile.
inline void check_members(const PathPiece& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6] = given;
  static_cast<void>(given.kind);
  static_cast<void>(given.from);
  static_cast<void>(given.to);
  static_cast<void>(given.centre);
  static_cast<void>(given.radius);
  static_cast<void>(given.start_angle);
  static_cast<void>(given.end_angle);
}
inline ww_path_piece to_c(const PathPiece& given) {
  ww_path_piece result{};
  result.kind = static_cast<ww_piece_kind>(given.kind);
  result.from = to_c(given.from);
  result.to = to_c(given.to);
  result.centre = to_c(given.centre);
  result.radius = given.radius;
  result.start_angle = given.start_angle;
  result.end_angle = given.end_angle;
  return result;
}

// PathPosition. If it has members that the table lacks, this function does not compile.
inline void check_members(const PathPosition& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4] = given;
  static_cast<void>(given.at);
  static_cast<void>(given.heading);
  static_cast<void>(given.segment);
  static_cast<void>(given.before);
  static_cast<void>(given.distance);
}
inline PathPosition to_cpp(const ww_path_position& given) {
  PathPosition result{};
  result.at = to_cpp(given.at);
  result.heading = to_cpp(given.heading);
  result.segment = given.segment;
  result.before = given.before;
  result.distance = given.distance;
  return result;
}
inline ww_path_position to_c(const PathPosition& given) {
  ww_path_position result{};
  result.at = to_c(given.at);
  result.heading = to_c(given.heading);
  result.segment = given.segment;
  result.before = given.before;
  result.distance = given.distance;
  return result;
}

// SearchWindow. If it has members that the table lacks, this function does not compile.
inline void check_members(const SearchWindow& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4] = given;
  static_cast<void>(given.root);
  static_cast<void>(given.edge);
  static_cast<void>(given.interval);
  static_cast<void>(given.length);
  static_cast<void>(given.bound);
}
inline ww_search_window to_c(const SearchWindow& given) {
  ww_search_window result{};
  result.root = to_c(given.root);
  result.edge = to_c(given.edge);
  result.interval = to_c(given.interval);
  result.length = given.length;
  result.bound = given.bound;
  return result;
}

// ChangedBox. If it has members that the table lacks, this function does not compile.
inline void check_members(const ChangedBox& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3] = given;
  static_cast<void>(given.version);
  static_cast<void>(given.box);
  static_cast<void>(given.is_insertion);
  static_cast<void>(given.is_removal);
}
inline ww_changed_box to_c(const ChangedBox& given) {
  ww_changed_box result{};
  result.version = given.version;
  result.box = to_c(given.box);
  result.is_insertion = to_c(given.is_insertion);
  result.is_removal = to_c(given.is_removal);
  return result;
}

// ScenarioQuery. If it has members that the table lacks, this function does not compile.
inline void check_members(const ScenarioQuery& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6, m7] = given;
  static_cast<void>(given.map);
  static_cast<void>(given.line);
  static_cast<void>(given.width);
  static_cast<void>(given.height);
  static_cast<void>(given.start);
  static_cast<void>(given.goal);
  static_cast<void>(given.length);
  static_cast<void>(given.precision);
}
inline ww_scenario_query to_c(const ScenarioQuery& given) {
  ww_scenario_query result{};
  result.line = given.line;
  result.width = given.width;
  result.height = given.height;
  result.start = to_c(given.start);
  result.goal = to_c(given.goal);
  result.length = given.length;
  result.precision = given.precision;
  return result;
}

// MemoryUse. If it has members that the table lacks, this function does not compile.
inline void check_members(const MemoryUse& given) {
  [[maybe_unused]] const auto& [m0, m1, m2, m3, m4, m5, m6, m7, m8, m9] = given;
  static_cast<void>(given.vertices);
  static_cast<void>(given.crossings);
  static_cast<void>(given.faces);
  static_cast<void>(given.walls);
  static_cast<void>(given.items);
  static_cast<void>(given.sectors);
  static_cast<void>(given.abstraction);
  static_cast<void>(given.bridges);
  static_cast<void>(given.history);
  static_cast<void>(given.spare);
}
inline ww_memory_use to_c(const MemoryUse& given) {
  ww_memory_use result{};
  result.vertices = given.vertices;
  result.crossings = given.crossings;
  result.faces = given.faces;
  result.walls = given.walls;
  result.items = given.items;
  result.sectors = given.sectors;
  result.abstraction = given.abstraction;
  result.bridges = given.bridges;
  result.history = given.history;
  result.spare = given.spare;
  result.total = given.total();
  return result;
}

}  // namespace waywright::c
