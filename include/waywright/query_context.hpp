#pragma once

#include "waywright/export.hpp"
#include "waywright/owned.hpp"

namespace waywright {

/// @addtogroup world
/// @{

namespace detail {
struct QueryScratch;
}

/// The memory that queries keep between calls. Most queries of World have two forms. One form returns its answer in a
/// new object. The other form takes a QueryContext of yours and writes the answer to an object of yours. Make one
/// context for each thread, and pass it to each query of this thread. A query allocates no memory if you have used its
/// context for a query of the same size before. The comments of the queries name a few exceptions.
///
/// @code{.cpp}
/// // `context` and `path` exist as long as the thread's work.
/// for (const PathQuery& query : queries) {
///   world.find_path(query, context, path).value();
///   std::printf("length %g\n", path.length);
/// }
/// @endcode
///
/// You can use one context for any number of worlds. No answer depends on earlier queries with the context. If you move
/// a context to another object, you may only assign to the first object or destroy it.
/// Threads: only one query at a time may use a context. Many threads may query one world at once, each with its own
/// context or without one. Of several queries without a context at once, one uses the context that belongs to the
/// world, and the others make new contexts.
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

/// @}

}  // namespace waywright
