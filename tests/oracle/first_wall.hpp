#pragma once

#include <cstdint>
#include <vector>

#include "oracle/oracle.hpp"

namespace waywright::oracle {

struct OracleRay {
  OraclePoint from;
  OraclePoint to;
};

struct OracleHit {
  bool hit = false;
  OraclePoint at;                  ///< correctly rounded
  std::vector<std::uint64_t> ids;  ///< of the items with a side there, ascending; 0 is the domain
};

/// Returns where each segment first touches a wall of the scene: the first of all points where it meets any wall.
[[nodiscard]] std::vector<OracleHit> first_walls(OracleScene scene, const std::vector<OracleRay>& rays);

}  // namespace waywright::oracle
