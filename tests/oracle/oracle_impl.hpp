#pragma once

#include <utility>
#include <vector>

#include "oracle/arrangement.hpp"
#include "oracle/oracle.hpp"
#include "oracle/solids.hpp"

namespace waywright::oracle {

/// A scene, and the data from which the answers are computed.
struct OracleParts {
  explicit OracleParts(OracleScene given) : scene(std::move(given)), arrangement(scene) {
    solids = solids_of(scene, arrangement.grid);
    const auto box = corners_of(scene.domain);
    domain.rings.emplace_back();
    for (const OraclePoint& p : box) domain.rings.front().push_back(arrangement.grid.point(p));
  }

  OracleScene scene;
  Arrangement arrangement;
  std::vector<Solid> solids;
  Solid domain;  ///< the domain's box as a polygon of id 0
};

struct Oracle::Impl : OracleParts {
  using OracleParts::OracleParts;
};

}  // namespace waywright::oracle
