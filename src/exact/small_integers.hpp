#pragma once

#include <optional>

#include "exact/exact_point.hpp"
#include "exact/sign.hpp"

/// Stage 2 of the predicates: explicit points with integer coordinates that lie within 2^29 of each other, as game
/// worlds have them. Differences then have 30 bits, products of two 60, and the in-circle determinant less than 125: it
/// fits 128 bits, which need no heap.
namespace waywright::exact::small_integers {

/// Empty where the points aren't such.
[[nodiscard]] std::optional<Sign> orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
[[nodiscard]] std::optional<Sign> in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                            const ExactPoint& d);

}  // namespace waywright::exact::small_integers
