#include "world/point_error.hpp"

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

}  // namespace waywright
