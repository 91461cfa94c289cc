/* Tests the regions that operations have changed, and path watches. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

void test_changed_regions(void) {
  static const ww_point moved[] = {{30, 10}, {35, 20}};
  ww_world* world = make_town(0);
  ww_shape shape;
  ww_changed_box boxes[4];
  ww_bool is_known = 0;
  uint64_t version = 0;
  size_t i, count = 0;
  CHECK_OK(ww_world_version(world, &version));
  CHECK_OK(ww_world_changes_since(world, version, &is_known, boxes, 4, &count));
  CHECK(is_known == 1 && count == 0);
  CHECK_OK(ww_world_insert_segment(world, at(5, 9), at(7, 8), 2, NULL));
  CHECK_OK(ww_world_insert_point(world, at(3, 3), 3, NULL)); /* no wall: no box */
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_SEGMENT;
  shape.points = moved;
  shape.point_count = 2;
  CHECK_OK(ww_world_replace(world, 2, &shape));
  CHECK_STATUS(ww_world_changes_since(world, version, &is_known, boxes, 2, &count), WW_BUFFER_TOO_SMALL);
  CHECK(count == 3);
  CHECK_OK(ww_world_changes_since(world, version, &is_known, boxes, 4, &count));
  CHECK(is_known == 1 && count == 3);
  CHECK(boxes[0].version == version + 1 && boxes[0].is_insertion == 1 && boxes[0].is_removal == 0);
  CHECK(is_at(boxes[0].box.min, 5, 8) && is_at(boxes[0].box.max, 7, 9));
  CHECK(boxes[1].version == version + 3 && boxes[2].version == version + 3);
  CHECK(boxes[1].is_removal + boxes[2].is_removal == 1 && boxes[1].is_insertion + boxes[2].is_insertion == 1);
  for (i = 0; i < 3000; ++i) CHECK_OK(ww_world_replace(world, 2, &shape));
  CHECK_OK(ww_world_changes_since(world, version, &is_known, boxes, 4, &count));
  CHECK(is_known == 0 && count == 0);
  ww_world_destroy(world);
}

static void find_path(const ww_world* world, ww_point start, ww_point goal, double radius, ww_path* path) {
  ww_context* context = NULL;
  ww_path_query query;
  ww_path_info info = {0};
  info.struct_size = sizeof info;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = start;
  query.goal = goal;
  query.agent.radius = radius;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND);
  ww_context_destroy(context);
}

/* The three lists of the last update, each with at most two keys. */
typedef struct Lists {
  uint64_t blocked[2], may_be_blocked[2], too_long[2];
  size_t blocked_count, may_be_blocked_count, too_long_count;
} Lists;

static Lists update(ww_path_watch* watch, const ww_world* world) {
  Lists lists;
  CHECK_OK(ww_path_watch_update(watch, world));
  CHECK_OK(ww_path_watch_blocked(watch, lists.blocked, 2, &lists.blocked_count));
  CHECK_OK(ww_path_watch_may_be_blocked(watch, lists.may_be_blocked, 2, &lists.may_be_blocked_count));
  CHECK_OK(ww_path_watch_may_be_too_long(watch, lists.too_long, 2, &lists.too_long_count));
  return lists;
}

void test_path_watch(void) {
  ww_world* world = make_town(1);
  ww_world* other = make_town(0);
  ww_path_watch* watch = NULL;
  ww_path* path = NULL;
  Lists lists;
  ww_bool answer = 1;
  size_t count = 1;
  CHECK_OK(ww_path_create(&path));
  CHECK_OK(ww_path_watch_create(world, &watch));
  CHECK_OK(ww_path_watch_count(watch, &count));
  CHECK(count == 0);
  find_path(world, at(10, 90), at(90, 90), 0, path);
  CHECK_OK(ww_path_watch_add(watch, 7, path));
  find_path(world, at(10, 30), at(90, 30), 0, path);
  CHECK_OK(ww_path_watch_add(watch, UINT64_MAX, path));
  find_path(world, at(10, 55), at(90, 55), 0, path); /* around the house */
  CHECK_OK(ww_path_watch_add(watch, 11, path));
  find_path(world, at(10, 10), at(90, 10), 4, path); /* a disc */
  CHECK_OK(ww_path_watch_add(watch, 0, path));
  ww_path_destroy(path); /* the watch has copies */
  CHECK_OK(ww_path_watch_count(watch, &count));
  CHECK(count == 4);
  lists = update(watch, world);
  CHECK(lists.blocked_count == 0 && lists.may_be_blocked_count == 0 && lists.too_long_count == 0);

  CHECK_OK(ww_world_insert_segment(world, at(20, 20), at(20, 40), 2, NULL));
  lists = update(watch, world);
  CHECK(lists.blocked_count == 1 && lists.blocked[0] == UINT64_MAX);
  CHECK(lists.may_be_blocked_count == 0 && lists.too_long_count == 0);
  CHECK_OK(ww_world_insert_segment(world, at(20, 13), at(30, 13), 3, NULL)); /* 3 above the centre of the disc */
  lists = update(watch, world);
  CHECK(lists.blocked_count == 0 && lists.may_be_blocked_count == 1 && lists.may_be_blocked[0] == 0);
  CHECK_OK(ww_world_remove(world, 1));
  lists = update(watch, world);
  CHECK(lists.blocked_count == 0 && lists.too_long_count == 1 && lists.too_long[0] == 11);

  CHECK_OK(ww_path_watch_contains(watch, 11, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_path_watch_remove(watch, 11, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_path_watch_remove(watch, 11, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_path_watch_remove(watch, 12, NULL));
  CHECK_OK(ww_path_watch_contains(watch, 11, &answer));
  CHECK(answer == 0);
  CHECK_STATUS(ww_path_watch_update(watch, other), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_path_watch_add(watch, 1, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_path_watch_create(NULL, &watch), WW_INVALID_ARGUMENT);
  ww_world_destroy(world); /* before the watch */
  ww_path_watch_destroy(watch);
  ww_path_watch_destroy(NULL);
  ww_world_destroy(other);
}

/* A snapshot stays as it is while its world changes, also after the end of the world. */
void test_snapshots(void) {
  ww_world* world = make_town(0);
  ww_snapshot *snapshot = NULL, *copy = NULL;
  const ww_world *then = NULL, *also_then = NULL;
  ww_items_hash before, after;
  size_t count = 0;
  CHECK_OK(ww_world_items_hash(world, &before));
  CHECK_OK(ww_world_item_count(world, &count));
  CHECK_OK(ww_world_publish(world, &snapshot));
  CHECK_OK(ww_snapshot_copy(snapshot, &copy));
  CHECK_OK(ww_world_insert_segment(world, at(5, 9), at(7, 8), 2, NULL));
  CHECK_OK(ww_snapshot_world(snapshot, &then));
  CHECK_OK(ww_snapshot_world(copy, &also_then));
  CHECK(then == also_then && then != world);
  ww_snapshot_destroy(snapshot);
  ww_world_destroy(world);
  CHECK_OK(ww_world_items_hash(then, &after));
  CHECK(memcmp(&before, &after, sizeof before) == 0);
  CHECK_STATUS(ww_snapshot_world(NULL, &then), WW_INVALID_ARGUMENT);
  ww_snapshot_destroy(copy);
  ww_snapshot_destroy(NULL);
}

/* The snapshot of a tick has the items of the tick, and the world keeps its own. */
void test_snapshots_of_ticks(void) {
  ww_world* world = make_town(0);
  ww_snapshot* snapshot = NULL;
  const ww_world* then = NULL;
  ww_items_hash before, after;
  uint64_t tick = 0;
  ww_bool is_there = 0;
  CHECK_STATUS(ww_world_publish_tick(world, 1, &snapshot), WW_NO_HISTORY);
  CHECK_OK(ww_world_keep_history(world, 3));
  CHECK_OK(ww_world_mark(world, &tick));
  CHECK_OK(ww_world_items_hash(world, &before));
  CHECK_OK(ww_world_insert_segment(world, at(5, 9), at(7, 8), 2, NULL));
  CHECK_OK(ww_world_publish_tick(world, tick, &snapshot));
  CHECK_OK(ww_snapshot_world(snapshot, &then));
  CHECK_OK(ww_world_items_hash(then, &after));
  CHECK(memcmp(&before, &after, sizeof before) == 0);
  CHECK_OK(ww_world_contains(world, 2, &is_there));
  CHECK(is_there);
  ww_snapshot_destroy(snapshot);
  snapshot = NULL;
  CHECK_STATUS(ww_world_publish_tick(world, tick + 1, &snapshot), WW_UNKNOWN_TICK);
  CHECK(snapshot == NULL);
  CHECK_STATUS(ww_world_publish_tick(world, tick, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_publish_tick(NULL, tick, &snapshot), WW_INVALID_ARGUMENT);
  ww_world_destroy(world);
}
