#pragma once

#include <memory>

namespace waywright::constraint {
struct CanonicalOrder;
struct ItemQueryScratch;
class SweptDisc;
}  // namespace waywright::constraint

namespace waywright::nav {
class ComponentCoverFinder;
}

namespace waywright::clearance {
class BridgeLister;
class WidestGapFinder;
}  // namespace waywright::clearance

namespace waywright::path {
class Finder;
class FitFinder;
class PolylineWalk;
}  // namespace waywright::path

namespace waywright::detail {

/// The scratch memory of queries. A source includes the headers of the parts that it uses.
struct QueryScratch {
  QueryScratch();
  ~QueryScratch();

  std::unique_ptr<constraint::ItemQueryScratch> items;
  std::unique_ptr<constraint::CanonicalOrder> order;
  std::unique_ptr<constraint::SweptDisc> swept_disc;
  std::unique_ptr<nav::ComponentCoverFinder> cover_finder;
  std::unique_ptr<clearance::BridgeLister> bridge_lister;
  std::unique_ptr<clearance::WidestGapFinder> widest_gap_finder;
  std::unique_ptr<path::FitFinder> fits;
  std::unique_ptr<path::Finder> finder;  ///< uses `fits`
  std::unique_ptr<path::PolylineWalk> polyline_walk;
};

}  // namespace waywright::detail
