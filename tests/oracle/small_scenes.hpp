#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "oracle/oracle.hpp"

namespace waywright::oracle {

inline OracleScene square(double side, std::vector<OracleItem> items = {}) {
  return {{{0, 0}, {side, side}}, std::move(items)};
}

inline OracleItem segment(std::uint64_t id, OraclePoint a, OraclePoint b) {
  return {id, OracleKind::segment, {{a, b}}};
}

inline OracleItem box(std::uint64_t id, OraclePoint low, OraclePoint high) {
  return {id, OracleKind::polygon, {{low, {high.x, low.y}, high, {low.x, high.y}}}};
}

}  // namespace waywright::oracle
