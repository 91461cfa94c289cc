#include "waywright/query_context.hpp"

#include <memory>

#include "clearance/bridge_lister.hpp"
#include "clearance/widest.hpp"
#include "constraint/canonical.hpp"
#include "constraint/item_queries.hpp"
#include "nav/abstraction.hpp"
#include "path/finder.hpp"
#include "path/fit_finder.hpp"
#include "path/polyline_walk.hpp"
#include "world/query_scratch.hpp"

namespace waywright {

detail::QueryScratch::QueryScratch()
    : items(std::make_unique<constraint::ItemQueryScratch>()),
      order(std::make_unique<constraint::CanonicalOrder>()),
      swept_disc(std::make_unique<constraint::SweptDisc>()),
      cover_finder(std::make_unique<nav::ComponentCoverFinder>()),
      bridge_lister(std::make_unique<clearance::BridgeLister>()),
      widest_gap_finder(std::make_unique<clearance::WidestGapFinder>()),
      fits(std::make_unique<path::FitFinder>()),
      finder(std::make_unique<path::Finder>(*fits)),
      polyline_walk(std::make_unique<path::PolylineWalk>()) {}
detail::QueryScratch::~QueryScratch() = default;

QueryContext::QueryContext() : scratch_(std::make_unique<detail::QueryScratch>()) {}
QueryContext::~QueryContext() = default;
QueryContext::QueryContext(QueryContext&&) noexcept = default;
QueryContext& QueryContext::operator=(QueryContext&&) noexcept = default;

}  // namespace waywright
