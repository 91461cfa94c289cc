#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "internal.hpp"
#include "streams.hpp"

namespace waywright::c {

struct ReplayLog {
  ReplayLog(const ww_output* output, const World& world, std::uint64_t ticks_per_hash)
      : buffer(output), stream(&buffer), writer(stream, world, ticks_per_hash) {}

  OutputBuffer buffer;
  std::ostream stream;
  ReplayWriter writer;
};

namespace {

ww_replay_difference to_c(const ReplayDifference& difference) {
  return {0,
          1,
          static_cast<ww_difference_kind>(difference.kind),
          difference.line,
          difference.other_line,
          difference.tick,
          difference.item.value,
          difference.other_item.value};
}

}  // namespace

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_replay_writer_create(const ww_output* output, const ww_world* world, uint64_t ticks_per_hash,
                                  ww_replay_writer** writer) {
  return guarded([&] {
    ww_replay_writer*& out = answer(writer);
    require(ticks_per_hash >= 1, "a replay log needs one tick or more for each hash");
    const World& logged = object(world);
    require_no_question(logged);
    const RunningCall running(logged, RunningCall::Use::reads);
    auto log = std::make_unique<ReplayLog>(output, logged, ticks_per_hash);
    if (!log->stream.good()) return fail(WW_UNWRITABLE, "the replay log cannot be written: the output takes no bytes");
    out = opaque<ww_replay_writer>(log.release());
    return ww_status{WW_OK};
  });
}

void ww_replay_writer_destroy(ww_replay_writer* writer) { destroy_object(writer); }

ww_status ww_replay_writer_record(ww_replay_writer* writer, const ww_change* changes, size_t change_count,
                                  const ww_id* ids) {
  return guarded([&] {
    ReplayLog& log = object(writer);
    const std::vector<Change> list = to_changes(changes, change_count);
    std::vector<ItemId> list_of_ids;
    list_of_ids.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) list_of_ids.push_back(ids != nullptr ? ItemId{ids[i]} : list[i].id);
    return status_of(log.writer.record(list, list_of_ids));
  });
}

ww_status ww_replay_writer_tick(ww_replay_writer* writer, const ww_world* world) {
  return guarded([&] {
    ReplayLog& log = object(writer);
    const World& logged = object(world);
    require_no_question(logged);
    const RunningCall running(logged, RunningCall::Use::reads);
    return status_of(log.writer.tick(logged));
  });
}

ww_status ww_replay_writer_last_tick(const ww_replay_writer* writer, uint64_t* tick) {
  return guarded([&] {
    answer(tick) = object(writer).writer.last_tick();
    return WW_OK;
  });
}

ww_status ww_replay_run(ww_replay* replay, const ww_script* log, ww_progress progress, void* user_data) {
  return guarded([&] {
    ReplayResult& kept = object(replay);
    std::function<void(std::size_t, std::size_t)> report;
    if (progress != nullptr) report = [=](std::size_t done, std::size_t total) { progress(done, total, user_data); };
    Result<ReplayResult> result = waywright::replay(object(log), report);
    if (result.ok()) kept = std::move(*result);
    return status_of(result);
  });
}

ww_status ww_replay_get_result(const ww_replay* replay, ww_replay_result* result) {
  return guarded([&] {
    const StructOut out(result);
    const ReplayResult& given = object(replay);
    out.write({0, to_c(given.is_same), given.ticks, given.tick, given.last_same, given.line,
               to_c(given.refusal.has_value()), to_c(given.expected), to_c(given.computed)});
    return WW_OK;
  });
}

ww_status ww_replay_changed(const ww_replay* replay, ww_id* ids, size_t capacity, size_t* count) {
  return guarded([&] { return write_ids(object(replay).changed, ListOut<ww_id>(ids, capacity, count)); });
}

ww_status ww_replay_refusal(const ww_replay* replay, ww_error* error, char* buffer, size_t capacity, size_t* count) {
  return guarded([&] {
    const StructOut out(error);
    const std::optional<Error>& refusal = object(replay).refusal;
    if (!refusal) {
      out.write({0, WW_OK, 0, 0});
      return write_text("", buffer, capacity, count);
    }
    out.write({0, static_cast<ww_status>(refusal->code), refusal->item.value, refusal->index});
    return write_text(refusal->message(), buffer, capacity, count);
  });
}

ww_status ww_find_difference(const ww_script* log, const ww_script* other, ww_replay_difference* difference,
                             ww_id* changed, size_t capacity, size_t* count) {
  return guarded([&] {
    const StructOut out(difference);
    const ListOut<ww_id> list(changed, capacity, count);
    const std::optional<ReplayDifference> found = find_difference(object(log), object(other));
    out.write(found ? to_c(*found) : ww_replay_difference{});
    return write_ids(found ? found->changed : std::vector<ItemId>(), list);
  });
}
