#include "internal.hpp"
#include "structs.hpp"

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
      const RunningCall asked(changed, RunningCall::Use::asks);
      return question(opaque<ww_world>(&changed), user_data);
    });
    return answered.ok() ? *answered : fail(answered.error());
  });
}

ww_status ww_world_would_disconnect(ww_world* world, const ww_change* changes, size_t change_count,
                                    const ww_point* points, size_t point_count, const ww_agent* agent,
                                    ww_bool* would_disconnect) {
  return guarded([&] {
    ww_bool& out = answer(would_disconnect);
    const Result<bool> found = changing(world).would_disconnect(to_changes(changes, change_count),
                                                                to_points(points, point_count), to_cpp(agent));
    if (found.ok()) out = to_c(*found);
    return status_of(found);
  });
}
