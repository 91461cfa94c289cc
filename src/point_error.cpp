#include "point_error.hpp"

#include <cmath>
#include <string>

#include "exact/exact_point.hpp"

namespace waywright {

Error range_error(const Point& point, std::size_t index) {
  const bool is_x = !exact::in_range(point.x);
  const double value = is_x ? point.x : point.y;
  std::string message = std::string(is_x ? "x" : "y") + " of point " + std::to_string(index);
  if (!std::isfinite(value)) {
    message += " is not finite";
  } else if (std::abs(value) > exact::kLargestCoordinate) {
    message += " lies beyond +-2^100";
  } else {
    message += " is nearer to 0 than 2^-100 without being 0";
  }
  return {ErrorCode::coordinate_range, std::move(message), {}, index};
}

std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index) {
  if (!exact::in_range(point)) return range_error(point, index);
  if (point.x < domain.min.x || point.x > domain.max.x || point.y < domain.min.y || point.y > domain.max.y) {
    return Error{ErrorCode::out_of_domain, "point " + std::to_string(index) + " lies outside the domain", {}, index};
  }
  return std::nullopt;
}

}  // namespace waywright
