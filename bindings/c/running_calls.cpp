#include <algorithm>

#include "internal.hpp"

// Some calls run functions of the caller. This file records which worlds these calls use, because a function of the
// caller must not use the same worlds in another manner.

namespace waywright::c {

namespace {

thread_local constinit const RunningCall* innermost = nullptr;

}  // namespace

RunningCall::RunningCall(const World& world, Use use) : world_(&world), use_(use), outer_(innermost) {
  innermost = this;
}

RunningCall::~RunningCall() { innermost = outer_; }

bool RunningCall::uses(const World& world, std::initializer_list<Use> manners) {
  for (const RunningCall* call = innermost; call != nullptr; call = call->outer_) {
    if (call->world_ == &world && std::find(manners.begin(), manners.end(), call->use_) != manners.end()) return true;
  }
  return false;
}

void require_unchanging(const World& world) {
  require(!RunningCall::uses(world, {RunningCall::Use::changes}),
          "a function that a call runs must not use the world that this call changes");
}

void require_unused(const World& world) {
  require_no_question(world);
  require_unchanging(world);
  require(!RunningCall::uses(world, {RunningCall::Use::reads}),
          "a function that a call runs must not change or destroy the world that this call reads");
}

void require_no_question(const World& world) {
  require(!RunningCall::uses(world, {RunningCall::Use::asks}),
          "this world is trying changes out: the question may only make queries");
}

}  // namespace waywright::c
