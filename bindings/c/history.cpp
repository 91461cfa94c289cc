#include "internal.hpp"

namespace waywright::c {

namespace {

/// A question of ww_world_attempt that a thread is asking. While it asks one, it can ask another one about another
/// world.
class Question {
 public:
  explicit Question(const World& world) : world_(&world), outer_(innermost) { innermost = this; }
  ~Question() { innermost = outer_; }
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;

  /// Returns whether the calling thread is asking a question about the world.
  static bool is_about(const World& world) {
    for (const Question* question = innermost; question != nullptr; question = question->outer_) {
      if (question->world_ == &world) return true;
    }
    return false;
  }

 private:
  static thread_local constinit Question* innermost;

  const World* world_;
  Question* outer_;
};

thread_local constinit Question* Question::innermost = nullptr;

}  // namespace

void require_no_question(const World& world) {
  require(!Question::is_about(world), "this world is trying changes out: the question may only make queries");
}

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_keep_history(ww_world* world, size_t ticks) {
  return guarded([&] {
    changing(world).keep_history(ticks);
    return WW_OK;
  });
}

ww_status ww_world_mark(ww_world* world, uint64_t* tick) {
  return guarded([&] {
    World& marked = changing(world);
    // No world has the tick 0. So this call only says whether the world keeps a history, which mark() requires.
    const Result<void> none = marked.rewind(0);
    if (none.error().code == ErrorCode::no_history) return fail(none.error());
    write_if_wanted(tick, marked.mark());
    return ww_status{WW_OK};
  });
}

ww_status ww_world_rewind(ww_world* world, uint64_t tick) {
  return guarded([&] { return status_of(changing(world).rewind(tick)); });
}

ww_status ww_world_attempt(ww_world* world, const ww_change* changes, size_t change_count, ww_question question,
                           void* user_data) {
  return guarded([&] {
    require(question != nullptr, "an attempt needs a question");
    World& tried = changing(world);
    const Result<ww_status> answered = tried.attempt(to_changes(changes, change_count), [&](const World& changed) {
      const Question asked(changed);
      return question(opaque<ww_world>(&changed), user_data);
    });
    return answered.ok() ? *answered : fail(answered.error());
  });
}

ww_status ww_world_would_disconnect(ww_world* world, const ww_change* changes, size_t change_count,
                                    const ww_point* points, size_t point_count, double radius,
                                    ww_bool* would_disconnect) {
  return guarded([&] {
    ww_bool& out = answer(would_disconnect);
    const Result<bool> found =
        changing(world).would_disconnect(to_changes(changes, change_count), to_points(points, point_count), radius);
    if (found.ok()) out = to_c(*found);
    return status_of(found);
  });
}
