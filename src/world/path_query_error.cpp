#include "world/path_query_error.hpp"

#include <cmath>

#include "world/point_error.hpp"

namespace waywright {

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
