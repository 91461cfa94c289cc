#pragma once

#include <cstddef>
#include <optional>

#include "waywright/error.hpp"
#include "waywright/point.hpp"

#include "exact/exact_point.hpp"

namespace waywright {

/// What is wrong with the coordinates of `point`, which messages call `name`.
[[nodiscard]] std::optional<Error> find_range_error(const Point& point, std::size_t index,
                                                    const detail::PointName& name);

/// Whether `point` may be asked about in a world over `domain`.
[[nodiscard]] inline bool is_point_of(const Box& domain, const Point& point) {
  return is_in_range(point) && point.x >= domain.min.x && point.x <= domain.max.x && point.y >= domain.min.y &&
         point.y <= domain.max.y;
}

/// What is wrong with `point` as a point of a world over `domain`, where is_point_of() says that something is. It is
/// the `index`-th of a list; messages call it `name`.
[[nodiscard]] Error point_error(const Box& domain, const Point& point, std::size_t index,
                                const detail::PointName& name);

/// That, or nothing.
[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index,
                                                           const detail::PointName& name) {
  if (is_point_of(domain, point)) return std::nullopt;
  return point_error(domain, point, index, name);
}

[[nodiscard]] inline std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index) {
  return find_point_error(domain, point, index, {"point", index});
}

}  // namespace waywright
