#pragma once

#include <atomic>
#include <memory>

#include "waywright/query_context.hpp"

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

namespace waywright {

/// The context that a world keeps for queries without a context. If each such query made a new context, it would spend
/// time on arrays as large as the mesh.
///
/// Threads: several queries may borrow a context at the same time. One of them gets the kept context, and the others
/// get new contexts.
class SpareContext {
 public:
  SpareContext() = default;
  ~SpareContext() { release(); }
  SpareContext(const SpareContext&) = delete;
  SpareContext& operator=(const SpareContext&) = delete;

  /// A context for one query. The destructor gives the context to the world, which keeps it.
  class Loan {
   public:
    explicit Loan(SpareContext& from) : from_(from), context_(from.kept_.exchange(nullptr)) {
      if (context_ == nullptr) context_ = std::make_unique<QueryContext>();
    }
    ~Loan() { delete from_.kept_.exchange(context_.release()); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    [[nodiscard]] QueryContext& operator*() const { return *context_; }

   private:
    SpareContext& from_;
    std::unique_ptr<QueryContext> context_;
  };
  [[nodiscard]] Loan borrow() { return Loan(*this); }

  void release() noexcept { delete kept_.exchange(nullptr); }

 private:
  std::atomic<QueryContext*> kept_ = nullptr;
};

}  // namespace waywright
