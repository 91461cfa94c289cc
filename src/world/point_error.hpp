#pragma once

#include <cstddef>
#include <optional>

#include "waywright/error.hpp"
#include "waywright/point.hpp"

#include "exact/position.hpp"

namespace waywright {

/// Returns the error in the coordinates of `point`, or nothing. Messages call the point `name`.
[[nodiscard]] std::optional<Error> find_range_error(const Point& point, std::size_t index,
                                                    const detail::PointName& name);

/// Returns whether a query or a change may use `point` in a world over `domain`.
[[nodiscard]] inline bool is_point_of(const Box& domain, const Point& point) {
  return is_in_range(point) && point.x >= domain.min.x && point.x <= domain.max.x && point.y >= domain.min.y &&
         point.y <= domain.max.y;
}

/// Returns the error in `point`. Its index in a list is `index`, and messages call it `name`. Requires: is_point_of()
/// is false.
[[nodiscard]] Error point_error(const Box& domain, const Point& point, std::size_t index,
                                const detail::PointName& name);

/// Returns the error in `point`, or nothing.
[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index,
                                                           const detail::PointName& name) {
  if (is_point_of(domain, point)) return std::nullopt;
  return point_error(domain, point, index, name);
}

[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index) {
  return find_point_error(domain, point, index, {"point", index});
}

/// Returns the error in the box of a query, or nothing. The box may reach beyond the domain.
[[nodiscard]] std::optional<Error> find_box_error(const Box& box);

}  // namespace waywright
