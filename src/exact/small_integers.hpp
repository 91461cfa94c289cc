#pragma once

#include <optional>

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"

/// Stage 2 of the in-circle test: explicit points with integer coordinates that lie within 2^29 of each other, as game
/// worlds have them. Differences then have 30 bits, squared lengths 61, and the determinant less than 125: it fits 128
/// bits, which need no heap. Orientation needs no such stage: of such points its filter is exact.
namespace waywright::exact::small_integers {

/// Empty where the points aren't such.
[[nodiscard]] std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                            const ExactPoint& d);

}  // namespace waywright::exact::small_integers
