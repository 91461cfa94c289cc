#include "world/query_errors.hpp"

#include <cmath>

namespace waywright {

namespace {

Error error_about(ErrorCode code, const Point& point, std::size_t index, const detail::PointName& name) {
  Error error{code, {}, {}, index};
  error.words.point_name = name;
  error.words.point = point;
  return error;
}

}  // namespace

std::optional<Error> find_range_error(const Point& point, std::size_t index, const detail::PointName& name) {
  if (is_in_range(point)) return std::nullopt;
  return error_about(ErrorCode::coordinate_range, point, index, name);
}

Error point_error(const Box& domain, const Point& point, std::size_t index, const detail::PointName& name) {
  if (auto error = find_range_error(point, index, name)) return *std::move(error);
  Error error = error_about(ErrorCode::out_of_domain, point, index, name);
  error.words.domain = domain;
  return error;
}

std::optional<Error> find_box_error(const Box& box) {
  if (auto error = find_range_error(box.min, 0, "the box's min")) return error;
  if (auto error = find_range_error(box.max, 1, "the box's max")) return error;
  if (box.min.x <= box.max.x && box.min.y <= box.max.y) return std::nullopt;
  return Error{ErrorCode::bad_domain, "a box needs min.x <= max.x and min.y <= max.y", {}, 0};
}

std::optional<Error> find_agent_error(const Agent& agent) {
  if (agent.radius >= 0.0 && std::isfinite(agent.radius)) return std::nullopt;
  return Error{ErrorCode::bad_radius, "the radius is negative or not finite", {}, 0};
}

std::optional<Error> find_agent_error(const Kept& kept, const Agent& agent) {
  if (auto error = find_agent_error(agent)) return error;
  if (agent.radius == 0.0 || kept.has_bridges) return std::nullopt;
  return Error{ErrorCode::no_bridges,
               "a radius above 0 needs a world that keeps its bridges: create it with the option keep_bridges",
               {},
               0};
}

std::optional<Error> find_tolerance_error(const std::optional<double>& tolerance) {
  if (!tolerance || *tolerance >= 0.0) return std::nullopt;
  return Error{ErrorCode::bad_distance, "the end tolerance is negative or not a number", {}, 0};
}

std::optional<Error> find_query_error(const Box& domain, const Kept& kept, const PathQuery& query) {
  if (auto error = find_point_error(domain, query.start, 0, "the start")) return error;
  if (auto error = find_point_error(domain, query.goal, 1, "the goal")) return error;
  if (auto error = find_agent_error(kept, query.agent)) return error;
  if (auto error = find_tolerance_error(query.end_tolerance)) return error;
  if (query.agent.radius == 0.0 && query.algorithm == PathAlgorithm::tra && !kept.has_abstraction) {
    return Error{ErrorCode::not_supported, "the path algorithm tra needs a world that keeps its abstraction", {}, 0};
  }
  return std::nullopt;
}

}  // namespace waywright
