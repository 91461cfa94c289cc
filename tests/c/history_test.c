/* Tests copies of worlds, going back, trying out, and limits of operations. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

static int have_equal_hashes(const ww_world* a, const ww_world* b) {
  ww_items_hash of_a, of_b;
  ww_mesh_hash mesh_of_a, mesh_of_b;
  CHECK_OK(ww_world_items_hash(a, &of_a));
  CHECK_OK(ww_world_items_hash(b, &of_b));
  CHECK_OK(ww_world_mesh_hash(a, &mesh_of_a));
  CHECK_OK(ww_world_mesh_hash(b, &mesh_of_b));
  return memcmp(&of_a, &of_b, sizeof of_a) == 0 && memcmp(&mesh_of_a, &mesh_of_b, sizeof mesh_of_a) == 0;
}

static uint64_t index_of_error(void) {
  ww_error error = {0};
  error.struct_size = sizeof error;
  CHECK_OK(ww_last_error(&error));
  return error.index;
}

void test_copies(void) {
  ww_world* world = make_town(1);
  ww_world* clone = NULL;
  ww_world_options options = {0};
  ww_id id = 0, same_id = 0;
  uint64_t version = 0, same_version = 0;
  options.struct_size = sizeof options;
  CHECK_OK(ww_world_set_new_vertex_limit(world, 1000));
  CHECK_OK(ww_world_clone(world, &clone));
  CHECK(have_equal_hashes(world, clone));
  CHECK_OK(ww_world_get_options(clone, &options));
  CHECK(options.keep_abstraction == 1 && options.keep_bridges == 1 && options.new_vertex_limit == 1000);
  CHECK(options.struct_size == sizeof options);
  CHECK_OK(ww_world_version(world, &version));
  CHECK_OK(ww_world_version(clone, &same_version));
  CHECK(version == same_version);
  CHECK_OK(ww_world_insert_point(clone, at(5, 5), 0, &same_id));
  CHECK(!have_equal_hashes(world, clone));
  CHECK_OK(ww_world_insert_point(world, at(5, 5), 0, &id));
  CHECK(id == 2 && same_id == 2 && have_equal_hashes(world, clone));
  ww_world_destroy(world);
  CHECK_OK(ww_world_reserve_ids(clone, 1000));
  CHECK_OK(ww_world_reserve_ids(clone, 10)); /* no effect: the world has seen a larger id */
  CHECK_OK(ww_world_largest_id_seen(clone, &id));
  CHECK(id == 1000);
  CHECK_OK(ww_world_insert_point(clone, at(6, 5), 0, &id));
  CHECK(id == 1001);
  CHECK_STATUS(ww_world_reserve_ids(clone, UINT64_MAX), WW_BAD_ID);
  CHECK_STATUS(ww_world_clone(NULL, &world), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_clone(clone, NULL), WW_INVALID_ARGUMENT);
  ww_world_destroy(clone);
}

void test_limits(void) {
  ww_world_options options;
  ww_world* world = NULL;
  ww_error error = {0};
  size_t limit = 0, count = 0;
  error.struct_size = sizeof error;
  CHECK_OK(ww_world_options_init(&options, sizeof options));
  CHECK(options.new_vertex_limit == SIZE_MAX);
  options.new_vertex_limit = 3;
  CHECK_OK(ww_world_create(box(0, 0, 100, 100), &options, &world));
  CHECK_OK(ww_world_insert_segment(world, at(10, 50), at(90, 50), 0, NULL)); /* the two ends */
  CHECK_OK(ww_world_insert_segment(world, at(50, 10), at(50, 90), 0, NULL)); /* the ends and a crossing */
  CHECK_OK(ww_world_vertex_count(world, &count));
  CHECK_STATUS(ww_world_insert_segment(world, at(20, 40), at(60, 60), 7, NULL), WW_TOO_MANY_VERTICES); /* 4 */
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_TOO_MANY_VERTICES && error.item == 7);
  CHECK_OK(ww_world_vertex_count(world, &limit));
  CHECK(limit == count);
  CHECK_OK(ww_world_new_vertex_limit(world, &limit));
  CHECK(limit == 3);
  CHECK_OK(ww_world_set_new_vertex_limit(world, SIZE_MAX));
  CHECK_OK(ww_world_insert_segment(world, at(20, 40), at(60, 60), 7, NULL));
  ww_world_destroy(world);
}

void test_going_back(void) {
  ww_world* world = make_town(0);
  ww_world* before = NULL;
  ww_memory_use use = {0};
  uint64_t tick = 0, version = 0, later = 0;
  ww_id id = 0;
  use.struct_size = sizeof use;
  CHECK_STATUS(ww_world_mark(world, &tick), WW_NO_HISTORY);
  CHECK_STATUS(ww_world_rewind(world, 1), WW_NO_HISTORY);
  CHECK_OK(ww_world_keep_history(world, 2));
  CHECK_STATUS(ww_world_rewind(world, 1), WW_UNKNOWN_TICK);
  CHECK_OK(ww_world_mark(world, &tick));
  CHECK(tick == 1);
  CHECK_OK(ww_world_clone(world, &before));
  CHECK_OK(ww_world_insert_segment(world, at(5, 5), at(9, 5), 0, &id));
  CHECK(id == 2);
  CHECK_OK(ww_world_remove(world, 1));
  CHECK_OK(ww_world_mark(world, NULL));
  CHECK_OK(ww_world_memory(world, &use));
  CHECK(use.history > 0);
  CHECK_OK(ww_world_version(world, &version));
  CHECK_OK(ww_world_rewind(world, 1));
  CHECK_OK(ww_world_version(world, &later));
  CHECK(later == version + 1 && have_equal_hashes(world, before));
  CHECK_OK(ww_world_insert_point(world, at(5, 5), 0, &id));
  CHECK(id == 2);
  CHECK_STATUS(ww_world_rewind(world, 2), WW_UNKNOWN_TICK);
  CHECK(index_of_error() == 2);
  CHECK_OK(ww_world_mark(world, &tick));
  CHECK(tick == 2);
  CHECK_OK(ww_world_mark(world, &tick));
  CHECK(tick == 3);
  CHECK_STATUS(ww_world_rewind(world, 1), WW_OLD_TICK);
  CHECK_OK(ww_world_rewind(world, 2));
  CHECK_OK(ww_world_rewind(before, 1)); /* the copy has the history, too */
  CHECK_OK(ww_world_keep_history(world, 0));
  CHECK_STATUS(ww_world_rewind(world, 2), WW_NO_HISTORY);
  ww_world_destroy(before);
  ww_world_destroy(world);
}

typedef struct Question {
  ww_world* world;
  ww_world* other;
  ww_search* search; /* in the world */
  ww_path_watch* watch;
  ww_output output;
  ww_replay_writer* writer;
  ww_context* context;
  ww_path* path;
  ww_path_query query;
  int asked;
  ww_status answer;
} Question;

static ww_status find_path_then(const ww_world* changed, void* user_data) {
  Question* const question = user_data;
  CHECK(changed == question->world);
  ++question->asked;
  CHECK_OK(ww_world_find_path(changed, &question->query, question->context, question->path));
  return question->answer;
}

/* Calls everything that a question must not call for its world. */
static ww_status break_rules(const ww_world* changed, void* user_data) {
  Question* const question = user_data;
  ww_world* const world = question->world;
  ww_world* clone = NULL;
  ww_search* search = NULL;
  ww_path_watch* watch = NULL;
  ww_replay_writer* writer = NULL;
  ww_bool answer = 0;
  ww_change change;
  ww_shape shape;
  const ww_point point = at(1, 1);
  memset(&change, 0, sizeof change);
  change.kind = WW_CHANGE_REMOVE;
  change.id = 1;
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  CHECK_OK(ww_search_create(&search));
  ++question->asked;
  CHECK_STATUS(ww_world_insert_point(world, point, 0, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_remove(world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_apply(world, &change, 1, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_insert_points(world, &point, 1, 0, NULL, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_attempt(world, &change, 1, find_path_then, question), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_would_disconnect(world, &change, 1, &point, 1, NULL, &answer), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_keep_history(world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_mark(world, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_rewind(world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_reserve_ids(world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_set_new_vertex_limit(world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_shrink_to_fit(world), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_clone(changed, &clone), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_search_begin(search, changed, &question->query), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_search_step(question->search, 1, &answer), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_path_watch_create(changed, &watch), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_path_watch_update(question->watch, changed), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_replay_writer_create(&question->output, changed, 1, &writer), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_replay_writer_tick(question->writer, changed), WW_INVALID_ARGUMENT);
  /* It may do all this with another world. */
  CHECK_OK(ww_world_insert_point(question->other, point, 0, NULL));
  CHECK_OK(ww_search_begin(search, question->other, &question->query));
  CHECK_OK(ww_search_step(search, 1000, &answer));
  ww_search_destroy(search);
  return WW_OK;
}

static ww_status ask_another(const ww_world* changed, void* user_data) {
  Question* const question = user_data;
  ww_change change;
  Question nested = *question;
  CHECK(changed == question->world);
  memset(&change, 0, sizeof change);
  change.kind = WW_CHANGE_REMOVE;
  change.id = 1;
  nested.world = question->other;
  nested.answer = WW_OK;
  CHECK_OK(ww_world_attempt(question->other, &change, 1, find_path_then, &nested));
  CHECK_STATUS(ww_world_remove(question->world, 1), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_world_remove(question->other, 1));
  ++question->asked;
  return WW_OK;
}

static ww_bool forget(const void* bytes, size_t size, void* user_data) {
  (void)bytes;
  (void)size;
  (void)user_data;
  return 1;
}

void test_trying_out(void) {
  static const ww_point fence[] = {{50, 60}, {50, 100}};
  ww_world* before = NULL;
  Question question;
  ww_shape shape;
  ww_change changes[2];
  ww_path_info info = {0};
  ww_bool is_done = 0;
  uint64_t version = 0, later = 0;
  info.struct_size = sizeof info;
  memset(&question, 0, sizeof question);
  question.world = make_town(0);
  question.other = make_town(0);
  CHECK_OK(ww_world_clone(question.world, &before));
  CHECK_OK(ww_context_create(&question.context));
  CHECK_OK(ww_path_create(&question.path));
  CHECK_OK(ww_search_create(&question.search));
  CHECK_OK(ww_path_watch_create(question.world, &question.watch));
  question.output.struct_size = sizeof question.output;
  question.output.write = forget;
  CHECK_OK(ww_replay_writer_create(&question.output, question.world, 1, &question.writer));
  CHECK_OK(ww_path_query_init(&question.query, sizeof question.query));
  question.query.start = at(10, 70);
  question.query.goal = at(90, 70);
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_SEGMENT;
  shape.points = fence;
  shape.point_count = 2;
  memset(changes, 0, sizeof changes);
  changes[0].shape = &shape;
  changes[1].kind = WW_CHANGE_REMOVE;
  changes[1].id = 1;
  CHECK_OK(ww_search_begin(question.search, question.world, &question.query));
  CHECK_OK(ww_world_version(question.world, &version));

  CHECK_OK(ww_world_attempt(question.world, changes, 1, find_path_then, &question));
  CHECK_OK(ww_path_get_info(question.path, &info));
  CHECK(question.asked == 1 && info.status == WW_PATH_FOUND && info.point_count == 4); /* below the house */
  CHECK_OK(ww_world_attempt(question.world, changes, 2, find_path_then, &question));
  CHECK_OK(ww_path_get_info(question.path, &info));
  CHECK(question.asked == 2 && info.point_count == 3); /* around the lower end of the fence */
  question.answer = 4711;
  CHECK(ww_world_attempt(question.world, changes, 2, find_path_then, &question) == 4711);
  question.answer = WW_OUT_OF_DOMAIN;
  CHECK(ww_world_attempt(question.world, changes, 2, find_path_then, &question) == WW_OUT_OF_DOMAIN);
  CHECK(question.asked == 4);
  changes[1].id = 99;
  CHECK_STATUS(ww_world_attempt(question.world, changes, 2, find_path_then, &question), WW_UNKNOWN_ID);
  CHECK(question.asked == 4 && index_of_error() == 1);
  CHECK_STATUS(ww_world_attempt(question.world, changes, 1, NULL, NULL), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_world_attempt(question.world, changes, 1, break_rules, &question));
  CHECK(question.asked == 5);
  CHECK_OK(ww_world_attempt(question.world, changes, 1, ask_another, &question));
  CHECK(question.asked == 6);

  CHECK_OK(ww_world_version(question.world, &later));
  CHECK(version == later && have_equal_hashes(question.world, before));
  CHECK_OK(ww_search_step(question.search, 1000, &is_done));
  CHECK(is_done);
  CHECK_OK(ww_path_watch_update(question.watch, question.world));
  CHECK_OK(ww_replay_writer_tick(question.writer, question.world));
  ww_path_watch_destroy(question.watch);
  ww_replay_writer_destroy(question.writer);
  ww_search_destroy(question.search);
  ww_path_destroy(question.path);
  ww_context_destroy(question.context);
  ww_world_destroy(before);
  ww_world_destroy(question.other);
  ww_world_destroy(question.world);
}

void test_disconnecting(void) {
  static const ww_point doors[] = {{10, 50}, {90, 50}};
  static const ww_point outside[] = {{10, 50}, {101, 50}};
  static const ww_point above[] = {{50, 60}, {50, 95}}; /* leaves a gap of 5 above the house */
  static const ww_point below[] = {{50, 40}, {50, 5}};  /* leaves a gap of 5 below it */
  static const ww_point across[] = {{20, 0}, {20, 100}};
  ww_world* world = make_town(1);
  ww_world* plain = make_town(0);
  ww_shape shapes[2];
  ww_change changes[2];
  ww_bool answer = 1;
  size_t i;
  memset(changes, 0, sizeof changes);
  for (i = 0; i < 2; ++i) {
    CHECK_OK(ww_shape_init(&shapes[i], sizeof shapes[i]));
    shapes[i].kind = WW_ITEM_SEGMENT;
    shapes[i].points = i == 0 ? above : below;
    shapes[i].point_count = 2;
    changes[i].shape = &shapes[i];
  }
  CHECK_OK(ww_world_would_disconnect(world, changes, 2, doors, 2, NULL, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_would_disconnect(world, changes, 2, doors, 2, &(ww_agent){2.5}, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_would_disconnect(world, changes, 2, doors, 2, &(ww_agent){2.6}, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_would_disconnect(world, changes, 1, doors, 2, &(ww_agent){2.6}, &answer));
  CHECK(answer == 0);
  shapes[0].points = across;
  CHECK_OK(ww_world_would_disconnect(plain, changes, 1, doors, 2, NULL, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_would_disconnect(plain, changes, 1, doors, 1, NULL, &answer));
  CHECK(answer == 0);
  CHECK_STATUS(ww_world_would_disconnect(plain, changes, 1, doors, 2, &(ww_agent){1}, &answer), WW_NO_BRIDGES);
  CHECK_STATUS(ww_world_would_disconnect(plain, changes, 1, doors, 2, &(ww_agent){-1}, &answer), WW_BAD_RADIUS);
  CHECK_STATUS(ww_world_would_disconnect(plain, changes, 1, outside, 2, NULL, &answer), WW_OUT_OF_DOMAIN);
  CHECK(index_of_error() == 1);
  ww_world_destroy(plain);
  ww_world_destroy(world);
}
