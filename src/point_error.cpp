#include "point_error.hpp"

#include <cmath>
#include <string>

#include "exact/exact_point.hpp"
#include "io/text.hpp"

namespace waywright {

namespace {

std::string place_of(const Point& point) {
  std::string text = "(";
  io::append_number(text, point.x);
  text += ", ";
  io::append_number(text, point.y);
  return text += ')';
}

std::string name_of(std::size_t index, std::string_view name) {
  return name.empty() ? io::with_number("point ", index, "") : std::string(name);
}

}  // namespace

std::optional<Error> find_range_error(const Point& point, std::size_t index, std::string_view name) {
  if (exact::in_range(point)) return std::nullopt;
  const bool is_x = !exact::in_range(point.x);
  const double value = is_x ? point.x : point.y;
  std::string message = (is_x ? "x of " : "y of ") + name_of(index, name) + ", ";
  io::append_number(message, value);
  if (!std::isfinite(value)) {
    message += ", is not finite";
  } else if (std::abs(value) > exact::kLargestCoordinate) {
    message += ", lies beyond +-2^100";
  } else {
    message += ", is nearer to 0 than 2^-100 without being 0";
  }
  return Error{ErrorCode::coordinate_range, std::move(message), {}, index};
}

Error point_error(const Box& domain, const Point& point, std::size_t index, std::string_view name) {
  if (auto error = find_range_error(point, index, name)) return *std::move(error);
  return {ErrorCode::out_of_domain,
          name_of(index, name) + ", " + place_of(point) + ", lies outside the domain, " + place_of(domain.min) +
              " to " + place_of(domain.max),
          {},
          index};
}

}  // namespace waywright
