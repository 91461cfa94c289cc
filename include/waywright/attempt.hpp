#pragma once

#include <type_traits>

#include "waywright/error.hpp"

namespace waywright {

class World;

namespace detail {

/// The result of World::attempt() for a question that returns a T.
template <class T>
struct ResultOf {
  using Type = Result<T>;
};
template <class T>
struct ResultOf<Result<T>> {
  using Type = Result<T>;
};

/// The result of World::attempt() for a question of this type.
template <class Question>
using ResultOfAttempt = typename ResultOf<std::remove_cvref_t<std::invoke_result_t<Question&, const World&>>>::Type;

/// Asks a question about a world. Returns the answer, or success if the question returns nothing.
template <class Question>
ResultOfAttempt<Question> ask(Question& question, const World& world) {
  if constexpr (std::is_void_v<std::invoke_result_t<Question&, const World&>>) {
    question(world);
    return {};
  } else {
    return question(world);
  }
}

/// The destructor of this class ends the attempt in a world, unless release() was called. `W` is World, which is
/// complete where this template is instantiated.
template <class W>
class AttemptGuard {
 public:
  explicit AttemptGuard(W& world) : world_(&world) {}
  ~AttemptGuard() {
    if (world_ != nullptr) world_->end_attempt();
  }
  AttemptGuard(const AttemptGuard&) = delete;
  AttemptGuard& operator=(const AttemptGuard&) = delete;

  void release() { world_ = nullptr; }

 private:
  W* world_;
};

}  // namespace detail

}  // namespace waywright
