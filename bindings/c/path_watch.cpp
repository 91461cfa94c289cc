#include "internal.hpp"

namespace waywright::c {

namespace {

ww_status write_keys(const std::vector<std::uint64_t>& keys, const ListOut<std::uint64_t>& out) {
  return out.write(keys, [](std::uint64_t key) { return key; });
}

}  // namespace

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_path_watch_create(const ww_world* world, ww_path_watch** watch) {
  return guarded([&] {
    require_no_question(object(world));
    return make_object(watch, object(world));
  });
}

void ww_path_watch_destroy(ww_path_watch* watch) { destroy_object(watch); }

ww_status ww_path_watch_add(ww_path_watch* watch, uint64_t key, const ww_path* path) {
  return guarded([&] {
    const Path& given = object(path);
    require(given.status != PathStatus::found || !given.points.empty() || !given.pieces.empty(),
            "a watch needs a path with points: set ww_many_goals_query.wants_points");
    object(watch).watch.add(key, given);
    return WW_OK;
  });
}

ww_status ww_path_watch_remove(ww_path_watch* watch, uint64_t key, ww_bool* was_there) {
  return guarded([&] {
    write_if_wanted(was_there, object(watch).watch.remove(key));
    return WW_OK;
  });
}

ww_status ww_path_watch_contains(const ww_path_watch* watch, uint64_t key, ww_bool* contains) {
  return guarded([&] {
    answer(contains) = to_c(object(watch).watch.contains(key));
    return WW_OK;
  });
}

ww_status ww_path_watch_count(const ww_path_watch* watch, size_t* count) {
  return guarded([&] {
    answer(count) = object(watch).watch.size();
    return WW_OK;
  });
}

ww_status ww_path_watch_update(ww_path_watch* watch, const ww_world* world) {
  return guarded([&] {
    Watch& updated = object(watch);
    const World& watched = object(world);
    require(&watched == updated.world, "a path watch belongs to another world");
    require_no_question(watched);
    updated.watch.update(watched, updated.changes);
    return WW_OK;
  });
}

ww_status ww_path_watch_blocked(const ww_path_watch* watch, uint64_t* keys, size_t capacity, size_t* count) {
  return guarded([&] { return write_keys(object(watch).changes.blocked, {keys, capacity, count}); });
}

ww_status ww_path_watch_may_be_blocked(const ww_path_watch* watch, uint64_t* keys, size_t capacity, size_t* count) {
  return guarded([&] { return write_keys(object(watch).changes.may_be_blocked, {keys, capacity, count}); });
}

ww_status ww_path_watch_may_be_too_long(const ww_path_watch* watch, uint64_t* keys, size_t capacity, size_t* count) {
  return guarded([&] { return write_keys(object(watch).changes.may_be_too_long, {keys, capacity, count}); });
}
