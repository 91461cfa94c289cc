#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "waywright/error.hpp"
#include "waywright/point.hpp"

namespace waywright {

/// What is wrong with the coordinates of `point`, which messages call `name`.
[[nodiscard]] std::optional<Error> find_range_error(const Point& point, std::size_t index, std::string_view name);

/// What is wrong with `point` as a point of a world over `domain`. It is the `index`-th of a list; messages call it
/// `name` or, where that is empty, by its index.
[[nodiscard]] std::optional<Error> find_point_error(const Box& domain, const Point& point, std::size_t index,
                                                    std::string_view name = {});

}  // namespace waywright
