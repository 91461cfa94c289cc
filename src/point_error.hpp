#pragma once

#include <cstddef>
#include <optional>

#include "waywright/error.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// What is wrong with a coordinate of `point`. Requires: one is out of range.
[[nodiscard]] Error range_error(const Point& point, std::size_t index);

/// What is wrong with `point`, the `index`-th of a list, as a point of a world over `domain`.
[[nodiscard]] std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index);

}  // namespace waywright
