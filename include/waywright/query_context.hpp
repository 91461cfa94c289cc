#pragma once

#include "waywright/export.hpp"
#include "waywright/owned.hpp"

namespace waywright {

namespace detail {
struct QueryScratch;
}

/// The scratch memory of queries. Many threads may query one world at once, each with a context of its own. A context
/// serves any number of worlds, one query at a time; kept between queries, it spares them every allocation. No answer
/// depends on what a context served before. One that has been moved from may only be assigned to or destroyed.
class WAYWRIGHT_API QueryContext {
 public:
  QueryContext();
  ~QueryContext();
  QueryContext(QueryContext&&) noexcept;
  QueryContext& operator=(QueryContext&&) noexcept;

 private:
  friend class World;
  detail::Owned<detail::QueryScratch, detail::kMovedContext> scratch_;
};

}  // namespace waywright
