#include "waywright/world_snapshot.hpp"

#include "internal.hpp"

// Snapshots for readers on other threads.

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_publish(ww_world* world, ww_snapshot** snapshot) {
  return guarded([&] { return make_object(snapshot, changing(world).publish()); });
}

ww_status ww_world_publish_tick(ww_world* world, uint64_t tick, ww_snapshot** snapshot) {
  return guarded([&] {
    Result<WorldSnapshot> published = changing(world).publish(tick);
    return published ? make_object(snapshot, *std::move(published)) : status_of(published);
  });
}

ww_status ww_snapshot_copy(const ww_snapshot* snapshot, ww_snapshot** copy) {
  return guarded([&] { return make_object(copy, WorldSnapshot(object(snapshot))); });
}

void ww_snapshot_destroy(ww_snapshot* snapshot) {
  if (snapshot == nullptr) return;
  guarded([&] {
    WorldSnapshot& released = object(snapshot);
    require_unused(*released);
    delete &released;
    return WW_OK;
  });
}

ww_status ww_snapshot_world(const ww_snapshot* snapshot, const ww_world** world) {
  return guarded([&] {
    answer(world) = opaque<ww_world>(&*object(snapshot));
    return ww_status{WW_OK};
  });
}
