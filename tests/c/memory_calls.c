#include "memory_calls.h"

#include <string.h>

#include "check.h"
#include "counting_allocator.h"
#include "scene.h"

static const char kMap[] = "type octile\nheight 2\nwidth 3\nmap\n..@\n..@\n";
static const char kScript[] = "waywright 1\ndomain 0 0 10 10\nsegment 1 4 0 4 7\npath 1 1 7 1 0\n";
const char kFile[] = "waywright_c_memory_test.wwb";
static const char kLog[] = "waywright 1\ndomain 0 0 9 9\npoint 1 2 2\ntick 1\nsegment 2 1 1 8 5\ntick 2\nremove 1\n";
static const char kScenario[] = "version 1\n0 a_long_name_of_a_map_in_a_folder/arena.map 49 40 1 11 2 12 1.41\n";

/* If a function makes several calls, it returns the status of the first one that fails. */
static ww_status create_world(State* s) { return ww_world_create(box(0, 0, 1, 1), NULL, &s->made); }
static ww_status create_context(State* s) { return ww_context_create(&s->more); }
static ww_status insert_polygon(State* s) { return ww_world_insert_polygon(s->world, kBar, 4, 0, NULL); }
static ww_status insert_polyline(State* s) { return ww_world_insert_polyline(s->world, kBar, 4, 0, NULL); }
static ww_status insert_point(State* s) { return ww_world_insert_point(s->world, at(70, 70), 0, NULL); }
static ww_status insert_segment(State* s) { return ww_world_insert_segment(s->world, at(1, 1), at(99, 98), 0, NULL); }
static ww_status insert(State* s) {
  const ww_shape shape = bar();
  return ww_world_insert(s->world, &shape, 0, NULL);
}
static ww_status insert_all(State* s) { return ww_world_insert_all(s->world, s->items, NULL, NULL); }
static ww_status insert_all_on_threads(State* s) {
  ww_bulk_options options;
  CHECK_OK(ww_bulk_options_init(&options, sizeof options));
  options.threads = 2;
  return ww_world_insert_all(s->world, s->items, &options, NULL);
}
static ww_status insert_points(State* s) { return ww_world_insert_points(s->world, kBar, 4, 0, NULL, NULL); }
static ww_status remove_item(State* s) { return ww_world_remove(s->world, 3); }
static ww_status replace(State* s) {
  const ww_shape shape = bar();
  return ww_world_replace(s->world, 1, &shape);
}
static ww_status apply(State* s) {
  const ww_shape shape = bar();
  ww_change changes[2];
  ww_id ids[2];
  memset(changes, 0, sizeof changes);
  changes[0].kind = WW_CHANGE_REMOVE;
  changes[0].id = 1;
  changes[1].shape = &shape;
  return ww_world_apply(s->world, changes, 2, ids);
}
static ww_status item_ids(State* s) { return ww_world_item_ids(s->world, NULL, 0, NULL); }
static ww_status item(State* s) { return ww_world_item(s->world, 1, s->items); }
static ww_status items(State* s) { return ww_world_items(s->world, s->context, s->items); }
static ww_status add_item(State* s) {
  const ww_shape shape = bar();
  return ww_items_add(s->items, 7, &shape);
}
static ww_status locate(State* s) {
  ww_location location;
  location.struct_size = sizeof location;
  return ww_world_locate(s->world, at(50, 50), s->context, &location, NULL, 0, NULL);
}
static ww_status items_at(State* s) { return ww_world_items_at(s->world, at(50, 50), s->context, NULL, 0, NULL); }
static ww_status items_in(State* s) {
  return ww_world_items_in(s->world, box(0, 0, 60, 60), s->context, NULL, 0, NULL);
}
static ww_status items_crossed(State* s) {
  return ww_world_items_crossed(s->world, at(1, 50), at(99, 50), s->context, NULL, 0, NULL);
}
static ww_status cast_ray(State* s) {
  ww_ray_hit hit;
  hit.struct_size = sizeof hit;
  return ww_world_ray(s->world, at(1, 50), at(99, 50), NULL, s->context, &hit, NULL, 0, NULL);
}
static ww_status sweep_disc(State* s) {
  ww_ray_hit hit;
  hit.struct_size = sizeof hit;
  return ww_world_ray(s->world, at(10, 50), at(90, 50), &(ww_agent){3}, s->context, &hit, NULL, 0, NULL);
}
static ww_status fit_disc(State* s) {
  ww_bool fits = 0;
  return ww_world_fit_disc(s->world, at(50, 50), &(ww_agent){30}, s->context, &fits, NULL, 0, NULL);
}
static ww_status nearest_fit(State* s) {
  ww_nearest_fit_query query;
  ww_nearest_fit fit;
  fit.struct_size = sizeof fit;
  CHECK_OK(ww_nearest_fit_query_init(&query, sizeof query));
  query.point = at(50, 50);
  query.agent.radius = 2;
  query.has_goal = 1;
  query.goal = at(90, 90);
  return ww_world_nearest_fit(s->world, &query, s->context, &fit);
}
static ww_status widest_path(State* s) {
  ww_widest_path widest;
  widest.struct_size = sizeof widest;
  return ww_world_widest_path(s->world, at(10, 55), at(90, 55), NULL, s->context, &widest, NULL, 0, NULL, NULL, 0,
                              NULL);
}
static ww_status bridges(State* s) {
  return ww_world_bridges(s->world, box(0, 0, 100, 100), s->context, NULL, 0, NULL, NULL, 0, NULL);
}
static ww_status find_path_with(State* s, ww_path_algorithm algorithm, double radius) {
  ww_path_query query = query_of(radius);
  query.algorithm = algorithm;
  query.budget_expansions = UINT64_MAX;
  return ww_world_find_path(s->world, &query, s->context, s->path);
}
static ww_status find_optimal_path(State* s) { return find_path_with(s, WW_ALGORITHM_OPTIMAL, 0); }
static ww_status find_ta_path(State* s) { return find_path_with(s, WW_ALGORITHM_TA, 0); }
static ww_status find_tra_path(State* s) { return find_path_with(s, WW_ALGORITHM_TRA, 0); }
static ww_status find_disc_path(State* s) { return find_path_with(s, WW_ALGORITHM_OPTIMAL, 2); }
static ww_status find_no_disc_path(State* s) { return find_path_with(s, WW_ALGORITHM_OPTIMAL, 15); }
static ww_status find_paths(State* s) {
  ww_path_query queries[2];
  queries[0] = query_of(0);
  queries[1] = query_of(2);
  return ww_world_find_paths(s->world, queries, 2, 1, NULL, s->context, s->paths);
}
static ww_status find_paths_on_threads(State* s) {
  ww_path_query queries[2];
  queries[0] = query_of(0);
  queries[1] = query_of(2);
  return ww_world_find_paths(s->world, queries, 2, 2, NULL, s->context, s->paths);
}
static ww_status find_paths_from(State* s) {
  ww_many_goals_query query;
  CHECK_OK(ww_many_goals_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goals = kBar;
  query.goal_count = 4;
  query.wants_points = 1;
  return ww_world_find_paths_from(s->world, &query, s->context, s->paths);
}
static ww_status path_polyline(State* s) { return ww_path_polyline(s->other_path, 1, NULL, 0, NULL); }
static ww_status search(State* s) {
  const ww_path_query query = query_of(0);
  ww_bool is_done = 0;
  const ww_status begun = ww_search_begin(s->search, s->world, &query);
  return begun != WW_OK ? begun : ww_search_step(s->search, 100000, &is_done);
}
static ww_status search_windows(State* s) {
  CHECK_OK(ww_search_record_windows(s->search, 1));
  return search(s);
}
static ww_status is_clear(State* s) {
  ww_bool answer = 0;
  return ww_world_is_clear(s->world, kBar, 4, NULL, s->context, &answer);
}
static ww_status find_affected(State* s) {
  const ww_path* paths[1];
  paths[0] = s->other_path;
  return ww_world_find_affected(s->world, paths, 1, 0, NULL, 0, NULL);
}
static ww_status snapshot(State* s) { return ww_world_snapshot(s->world, s->context, s->mesh); }
static ww_status dump(State* s) { return ww_world_dump(s->world, s->text); }
static ww_status mesh_hash(State* s) {
  ww_mesh_hash hash;
  return ww_world_mesh_hash(s->world, &hash);
}
static ww_status validate(State* s) {
  ww_bool is_valid = 0;
  const ww_status status = ww_world_validate(s->world, &is_valid, s->text);
  CHECK(status != WW_OK || is_valid);
  return status;
}
static ww_status shrink_to_fit(State* s) { return ww_world_shrink_to_fit(s->world); }
static ww_status parse_map(State* s) { return ww_scene_parse_movingai_map(kMap, sizeof kMap - 1, "a.map", s->scene); }
static ww_status read_scene(State* s) { return ww_scene_read(WAYWRIGHT_TEST_SCRIPT, s->scene); }
static ww_status set_scene(State* s) { return ww_scene_set(s->scene, box(0, 0, 1, 1), s->items, 0); }
static ww_status to_script(State* s) {
  const ww_status set = ww_scene_set(s->scene, box(0, 0, 100, 100), s->items, 0);
  return set != WW_OK ? set : ww_scene_to_script(s->scene, s->text);
}
static ww_status parse_script(State* s) {
  const ww_status parsed = ww_script_parse(kScript, sizeof kScript - 1, "a.wws", s->script);
  return parsed != WW_OK ? parsed : ww_script_scene(s->script, s->scene);
}
static ww_status parse_scenario(State* s) {
  return ww_scenario_parse(kScenario, sizeof kScenario - 1, "a.scen", s->scenario);
}
static ww_status draw(State* s) {
  const ww_path_query query = query_of(2);
  ww_status status = ww_svg_add_path(s->overlay, s->other_path);
  if (status == WW_OK) status = ww_svg_add_disc_path(s->overlay, &query, s->path);
  if (status == WW_OK) status = ww_svg_add_label(s->overlay, at(1, 1), "a text of more than 16 letters", 1, 14, NULL);
  if (status == WW_OK) status = ww_world_to_svg(s->world, s->overlay, NULL, s->text);
  return status;
}
static ww_status clone_world(State* s) { return ww_world_clone(s->world, &s->made); }
static ww_status mark(State* s) { return ww_world_mark(s->world, NULL); }
static ww_status go_back(State* s) { return ww_world_rewind(s->world, 1); }
static ww_status find_path_in(const ww_world* changed, void* user_data) {
  State* const s = user_data;
  const ww_path_query query = query_of(2);
  return ww_world_find_path(changed, &query, s->context, s->path);
}
static ww_status attempt(State* s) {
  const ww_shape shape = bar();
  ww_change change;
  memset(&change, 0, sizeof change);
  change.shape = &shape;
  return ww_world_attempt(s->world, &change, 1, find_path_in, s);
}
static ww_status would_disconnect_with(State* s, double radius) {
  const ww_shape shape = bar();
  ww_change change;
  ww_bool answer = 0;
  memset(&change, 0, sizeof change);
  change.shape = &shape;
  return ww_world_would_disconnect(s->world, &change, 1, kBar, 4, &(ww_agent){radius}, &answer);
}
static ww_status would_disconnect(State* s) { return would_disconnect_with(s, 0); }
static ww_status would_disconnect_discs(State* s) { return would_disconnect_with(s, 2); }
static ww_status create_watch(State* s) {
  ww_path_watch* watch = NULL;
  const ww_status status = ww_path_watch_create(s->world, &watch);
  ww_path_watch_destroy(watch);
  return status;
}
static ww_status watch_path(State* s) {
  size_t count = 0;
  const ww_status status = ww_path_watch_add(s->watch, 2, s->other_path);
  CHECK_OK(ww_path_watch_count(s->watch, &count));
  CHECK(count == (status == WW_OK ? 2 : 1));
  return status;
}
static ww_status update_watch(State* s) {
  size_t count = 0;
  const ww_status status = ww_path_watch_update(s->watch, s->world);
  CHECK_OK(ww_path_watch_blocked(s->watch, NULL, 0, &count));
  CHECK(status != WW_OK || count == 1);
  return status;
}
static ww_status save_to_output(State* s) {
  const ww_output output = counter();
  return ww_world_save(s->world, &output);
}
static ww_status save_bytes(State* s) { return ww_world_save_bytes(s->world, s->text); }
static ww_status save_file(State* s) { return ww_world_save_file(s->world, kFile); }
static ww_status load_bytes(State* s) {
  const char* bytes = NULL;
  size_t size = 0;
  CHECK_OK(ww_text_bytes(s->saved, &bytes, &size));
  return ww_world_load_bytes(bytes, size, NULL, &s->made);
}
static ww_status load_file(State* s) { return ww_world_load_file(kFile, NULL, &s->made); }
static ww_status parse_saved_world(State* s) {
  const char* bytes = NULL;
  size_t size = 0;
  CHECK_OK(ww_text_bytes(s->saved, &bytes, &size));
  return ww_scene_parse_saved_world(bytes, size, "a.wwb", s->scene);
}
static ww_status create_writer(State* s) {
  const ww_output output = counter();
  ww_replay_writer* writer = NULL;
  const ww_status status = ww_replay_writer_create(&output, s->world, 1, &writer);
  ww_replay_writer_destroy(writer);
  return status;
}
static ww_status record(State* s) {
  const ww_shape shape = bar();
  const size_t before = log_size;
  ww_change change;
  ww_status status;
  memset(&change, 0, sizeof change);
  change.id = 9;
  change.shape = &shape;
  status = ww_replay_writer_record(s->writer, &change, 1, NULL);
  CHECK((status == WW_OK) == (log_size > before));
  return status;
}
static ww_status end_tick(State* s) {
  const size_t before = log_size;
  uint64_t tick = 0;
  const ww_status status = ww_replay_writer_tick(s->writer, s->world);
  CHECK_OK(ww_replay_writer_last_tick(s->writer, &tick));
  CHECK((status == WW_OK) == (log_size > before) && tick == (status == WW_OK ? 1 : 0));
  return status;
}
static ww_status replay(State* s) {
  const ww_status parsed = ww_script_parse(kLog, sizeof kLog - 1, "log", s->script);
  return parsed != WW_OK ? parsed : ww_replay_run(s->replay, s->script, NULL, NULL);
}
static ww_status find_difference(State* s) {
  ww_replay_difference difference;
  const ww_status parsed = ww_script_parse(kLog, sizeof kLog - 1, "log", s->script);
  difference.struct_size = sizeof difference;
  return parsed != WW_OK ? parsed : ww_find_difference(s->script, s->script, &difference, NULL, 0, NULL);
}
static ww_status copy_path(State* s) { return ww_path_copy(s->other_path, s->path); }
/* The message of an error may need memory. If there is none, it is the name of the status. */
static ww_status error_message(State* s) {
  char message[256] = "";
  const size_t before = failures;
  CHECK_STATUS(ww_world_remove(s->world, 99), WW_UNKNOWN_ID);
  CHECK_OK(ww_last_error_message(message, sizeof message, NULL));
  if (failures == before) return WW_OK;
  CHECK(strcmp(message, "unknown-id") == 0);
  return WW_OUT_OF_MEMORY;
}
/* The error of a text keeps its message. */
static ww_status refuse_script(State* s) {
  const ww_status status =
      ww_script_parse("waywright 1\nfly to the moon\n", 28, "a_long_name_of_a_file.wws", s->script);
  CHECK(status == WW_MALFORMED || status == WW_OUT_OF_MEMORY);
  return status == WW_MALFORMED ? WW_OK : status;
}

const Case kCases[] = {
    {"create_world", create_world, 0},
    {"create_context", create_context, 0},
    {"insert_polygon", insert_polygon, 1},
    {"insert_polyline", insert_polyline, 1},
    {"insert_point", insert_point, 1},
    {"insert_segment", insert_segment, 1},
    {"insert", insert, 1},
    {"insert_all", insert_all, 1},
    {"insert_all_on_threads", insert_all_on_threads, 1},
    {"insert_points", insert_points, 1},
    {"remove_item", remove_item, 1},
    {"replace", replace, 1},
    {"apply", apply, 1},
    {"item_ids", item_ids, 0},
    {"item", item, 0},
    {"items", items, 0},
    {"add_item", add_item, 0},
    {"locate", locate, 0},
    {"items_at", items_at, 0},
    {"items_in", items_in, 0},
    {"items_crossed", items_crossed, 0},
    {"cast_ray", cast_ray, 0},
    {"sweep_disc", sweep_disc, 0},
    {"fit_disc", fit_disc, 0},
    {"nearest_fit", nearest_fit, 0},
    {"widest_path", widest_path, 0},
    {"bridges", bridges, 0},
    {"find_optimal_path", find_optimal_path, 0},
    {"find_ta_path", find_ta_path, 0},
    {"find_tra_path", find_tra_path, 0},
    {"find_disc_path", find_disc_path, 0},
    {"find_no_disc_path", find_no_disc_path, 0},
    {"find_paths", find_paths, 0},
    {"find_paths_on_threads", find_paths_on_threads, 0},
    {"find_paths_from", find_paths_from, 0},
    {"path_polyline", path_polyline, 0},
    {"search", search, 0},
    {"search_windows", search_windows, 0},
    {"is_clear", is_clear, 0},
    {"find_affected", find_affected, 0},
    {"clone_world", clone_world, 0},
    {"mark", mark, 0},
    {"go_back", go_back, 1},
    {"attempt", attempt, 0},
    {"would_disconnect", would_disconnect, 0},
    {"would_disconnect_discs", would_disconnect_discs, 0},
    {"create_watch", create_watch, 0},
    {"watch_path", watch_path, 0},
    {"update_watch", update_watch, 0},
    {"save_to_output", save_to_output, 0},
    {"save_bytes", save_bytes, 0},
    {"save_file", save_file, 0},
    {"load_file", load_file, 0}, /* the file of the case before */
    {"load_bytes", load_bytes, 0},
    {"parse_saved_world", parse_saved_world, 0},
    {"create_writer", create_writer, 0},
    {"record", record, 0},
    {"end_tick", end_tick, 0},
    {"replay", replay, 0},
    {"find_difference", find_difference, 0},
    {"copy_path", copy_path, 0},
    {"snapshot", snapshot, 0},
    {"dump", dump, 0},
    {"mesh_hash", mesh_hash, 0},
    {"validate", validate, 0},
    {"shrink_to_fit", shrink_to_fit, 0},
    {"parse_map", parse_map, 0},
    {"read_scene", read_scene, 0},
    {"set_scene", set_scene, 0},
    {"to_script", to_script, 0},
    {"parse_script", parse_script, 0},
    {"parse_scenario", parse_scenario, 0},
    {"draw", draw, 0},
    {"error_message", error_message, 0},
    {"refuse_script", refuse_script, 0},
};
const size_t kCaseCount = sizeof kCases / sizeof kCases[0];

const Call kWarmQueries[] = {
    locate,   items_at,    items_in,          items_crossed, cast_ray,      sweep_disc,
    fit_disc, nearest_fit, find_optimal_path, find_ta_path,  find_tra_path, find_disc_path,
    is_clear, snapshot,    widest_path,       bridges,
};
const size_t kWarmQueryCount = sizeof kWarmQueries / sizeof kWarmQueries[0];
