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

std::optional<Error> find_box_error(const Box& box) {
  if (auto error = find_range_error(box.min, 0, "the box's min")) return error;
  if (auto error = find_range_error(box.max, 1, "the box's max")) return error;
  if (box.min.x <= box.max.x && box.min.y <= box.max.y) return std::nullopt;
  return Error{ErrorCode::bad_domain, "a box needs min.x <= max.x and min.y <= max.y", {}, 0};
}

}  // namespace waywright
