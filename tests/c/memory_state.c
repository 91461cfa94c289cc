#include "memory_state.h"

#include <string.h>

#include "check.h"
#include "scene.h"

size_t log_size = 0;
static ww_bool count_bytes(const void* bytes, size_t size, void* user_data) {
  CHECK(bytes != NULL && user_data == &log_size);
  log_size += size;
  return 1;
}

ww_output counter(void) {
  ww_output output;
  memset(&output, 0, sizeof output);
  output.struct_size = sizeof output;
  output.write = count_bytes;
  output.user_data = &log_size;
  return output;
}

const ww_point kBar[4] = {{20, 30}, {80, 30}, {80, 33}, {20, 33}};

ww_shape bar(void) {
  ww_shape shape;
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_POLYGON;
  shape.points = kBar;
  shape.point_count = 4;
  return shape;
}

ww_path_query query_of(double radius) {
  ww_path_query query;
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goal = at(90, 55);
  query.agent.radius = radius;
  query.wants_channel = 1;
  return query;
}

void make_state(State* state) {
  const ww_path_query query = query_of(0);
  const ww_shape shape = bar();
  const ww_output output = counter();
  ww_world_options options;
  ww_point corners[12];
  size_t count = 0;
  memset(state, 0, sizeof *state);
  CHECK_OK(ww_world_options_init(&options, sizeof options));
  options.keep_bridges = 1;
  CHECK_OK(ww_world_create(box(0, 0, 100, 100), &options, &state->world));
  CHECK_OK(ww_regular_polygon(at(50, 50), 12, 12, corners, 12, &count));
  CHECK_OK(ww_world_insert_polygon(state->world, corners, count, 1, NULL));
  CHECK_OK(ww_world_insert_segment(state->world, at(5, 5), at(95, 8), 2, NULL));
  CHECK_OK(ww_world_insert_segment(state->world, at(30, 2), at(33, 77), 3, NULL));
  CHECK_OK(ww_context_create(&state->context));
  CHECK_OK(ww_items_create(&state->items));
  CHECK_OK(ww_items_add(state->items, 0, &shape));
  CHECK_OK(ww_path_create(&state->path));
  CHECK_OK(ww_path_create(&state->other_path));
  CHECK_OK(ww_world_find_path(state->world, &query, state->context, state->other_path));
  ww_context_destroy(state->context); /* the next one is cold */
  state->context = NULL;
  CHECK_OK(ww_context_create(&state->context));
  CHECK_OK(ww_paths_create(&state->paths));
  CHECK_OK(ww_search_create(&state->search));
  CHECK_OK(ww_mesh_create(&state->mesh));
  CHECK_OK(ww_text_create(&state->text));
  CHECK_OK(ww_scene_create(&state->scene));
  CHECK_OK(ww_script_create(&state->script));
  CHECK_OK(ww_scenario_create(&state->scenario));
  CHECK_OK(ww_svg_overlay_create(&state->overlay));
  CHECK_OK(ww_replay_create(&state->replay));
  CHECK_OK(ww_text_create(&state->saved));
  CHECK_OK(ww_world_save_bytes(state->world, state->saved));
  CHECK_OK(ww_replay_writer_create(&output, state->world, 1, &state->writer));
  CHECK_OK(ww_path_watch_create(state->world, &state->watch));
  CHECK_OK(ww_path_watch_add(state->watch, 1, state->other_path));
  CHECK_OK(ww_world_keep_history(state->world, 4));
  CHECK_OK(ww_world_mark(state->world, NULL));
  CHECK_OK(ww_world_remove(state->world, 2));
  CHECK_OK(ww_world_insert_segment(state->world, at(60, 90), at(70, 40), 4, NULL)); /* across other_path */
}

void destroy_state(State* state) {
  ww_search_destroy(state->search);
  ww_path_watch_destroy(state->watch);
  ww_replay_writer_destroy(state->writer);
  ww_replay_destroy(state->replay);
  ww_text_destroy(state->saved);
  ww_world_destroy(state->world);
  ww_world_destroy(state->made);
  ww_context_destroy(state->context);
  ww_context_destroy(state->more);
  ww_items_destroy(state->items);
  ww_path_destroy(state->path);
  ww_path_destroy(state->other_path);
  ww_paths_destroy(state->paths);
  ww_mesh_destroy(state->mesh);
  ww_text_destroy(state->text);
  ww_scene_destroy(state->scene);
  ww_script_destroy(state->script);
  ww_scenario_destroy(state->scenario);
  ww_svg_overlay_destroy(state->overlay);
}
