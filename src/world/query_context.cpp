#include "waywright/query_context.hpp"

#include <memory>

#include "world/query_scratch.hpp"

namespace waywright {

QueryContext::QueryContext() : scratch_(std::make_unique<detail::QueryScratch>()) {}
QueryContext::~QueryContext() = default;
QueryContext::QueryContext(QueryContext&&) noexcept = default;
QueryContext& QueryContext::operator=(QueryContext&&) noexcept = default;

}  // namespace waywright
