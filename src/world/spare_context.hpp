#pragma once

#include <atomic>
#include <memory>

#include "waywright/query_context.hpp"

namespace waywright {

/// A context that a world keeps for queries that bring none. So these, too, cost what they search: the arrays of a new
/// context have room for the whole mesh.
///
/// Threads: queries may borrow at once. One gets the context that is kept, the others make their own.
class SpareContext {
 public:
  SpareContext() = default;
  ~SpareContext() { release(); }
  SpareContext(const SpareContext&) = delete;
  SpareContext& operator=(const SpareContext&) = delete;

  /// A context for one query. Afterwards the world keeps it.
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
