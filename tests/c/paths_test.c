/* Tests paths, searches, and what follows changes. */
#include <math.h>
#include <stddef.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

static size_t job_runs = 0;
static void run_backwards(size_t count, ww_job job, void* job_data, void* user_data) {
  CHECK(user_data == &job_runs);
  ++job_runs;
  while (count > 1) job(job_data, --count); /* omits job 0 */
}

void test_point_paths(void) {
  const double length = 2 * sqrt(30.0 * 30.0 + 5.0 * 5.0) + 20;
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_path* path = NULL;
  ww_path_query query;
  ww_path_info info = {0};
  ww_path_position position = {0};
  ww_point points[8];
  ww_portal channel[16];
  ww_id ids[4];
  size_t count = 0;
  double tolerance = 0;
  info.struct_size = sizeof info;
  position.struct_size = sizeof position;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_create(&path));
  CHECK_STATUS(ww_path_at(path, 0, WW_FLOAT64, &position), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  CHECK(query.algorithm == WW_ALGORITHM_OPTIMAL);
  query.start = at(10, 55);
  query.goal = at(90, 55);
  query.wants_channel = 1;
  query.wants_time = 1;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && is_near(info.length, length) && info.point_count == 4);
  CHECK(info.piece_count == 0 && info.nanoseconds > 0 && info.has_moved_start == 0 && info.has_widest == 0);
  CHECK_OK(ww_path_points(path, points, 8, &count));
  CHECK(count == 4 && is_at(points[0], 10, 55) && is_at(points[1], 40, 60) && is_at(points[2], 60, 60));
  CHECK_OK(ww_path_channel(path, channel, 16, &count));
  CHECK(count > 0 && count == info.channel_count);
  CHECK_OK(ww_path_at(path, info.length, WW_FLOAT64, &position));
  CHECK(is_at(position.at, 90, 55));
  CHECK_OK(ww_path_nearest(path, at(50, 70), WW_FLOAT64, &position));
  CHECK(is_at(position.at, 50, 60) && position.segment == 1);
  CHECK_OK(ww_path_advance(path, 5, WW_FLOAT64, &position));
  CHECK(is_near(position.at.x, 55) && position.at.y == 60 && is_at(position.heading, 1, 0));
  position.segment = SIZE_MAX;
  CHECK_STATUS(ww_path_advance(path, 5, WW_FLOAT64, &position), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_path_at(path, 5, 2, &position), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_path_polyline(path, 1, points, 8, &count));
  CHECK(count == 4);
  CHECK_STATUS(ww_path_polyline(path, -1, points, 8, &count), WW_BAD_DISTANCE);

  query.goal = at(50, 50);
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_GOAL_BLOCKED && info.blocker_count == 1);
  CHECK_OK(ww_path_blockers(path, ids, 4, &count));
  CHECK(count == 1 && ids[0] == 1);
  query.goal = at(42, 50);
  query.has_end_tolerance = 1;
  query.end_tolerance = 3;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && info.has_moved_goal == 1);
  CHECK(is_at(info.moved_goal.from, 42, 50) && is_at(info.moved_goal.to, 40, 50));
  CHECK_OK(ww_world_default_end_tolerance(world, &tolerance));
  CHECK(tolerance == 100.0 / (1 << 20));
  query.end_tolerance = -1;
  CHECK_STATUS(ww_world_find_path(world, &query, context, path), WW_BAD_DISTANCE);
  query.has_end_tolerance = 0;
  query.algorithm = 3;
  CHECK_STATUS(ww_world_find_path(world, &query, context, path), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_path_algorithm_by_name("ta", &query.algorithm));
  CHECK(query.algorithm == WW_ALGORITHM_TA);
  CHECK_STATUS(ww_path_algorithm_by_name("best", &query.algorithm), WW_INVALID_ARGUMENT);
  query.goal = at(90, 55);
  query.budget_expansions = UINT64_MAX;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(is_near(info.length, length) && is_near(info.lower_bound, length));
  query.agent.radius = 1;
  CHECK_STATUS(ww_world_find_path(world, &query, context, path), WW_NO_BRIDGES);
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

void test_disc_paths(void) {
  ww_world_options options;
  ww_world* world = NULL;
  ww_context* context = NULL;
  ww_path* path = NULL;
  ww_path_query query;
  ww_path_info info = {0};
  ww_widest_path widest = {0};
  ww_path_piece pieces[8];
  ww_id from[4], to[4];
  size_t count = 0, from_count = 0, to_count = 0;
  info.struct_size = sizeof info;
  widest.struct_size = sizeof widest;
  CHECK_OK(ww_world_options_init(&options, sizeof options));
  options.keep_bridges = 1;
  CHECK_OK(ww_world_create(box(0, 0, 100, 100), &options, &world));
  CHECK_OK(ww_world_insert_segment(world, at(50, 0), at(50, 60), 1, NULL));
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_create(&path));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(20, 50);
  query.goal = at(80, 50);
  query.agent.radius = 5;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && info.agent.radius == 5 && info.point_count == 0);
  CHECK_OK(ww_path_pieces(path, pieces, 8, &count));
  CHECK(count == 3 && pieces[0].kind == WW_PIECE_LINE && pieces[1].kind == WW_PIECE_ARC);
  CHECK(is_at(pieces[1].centre, 50, 60) && pieces[1].radius == 5 && pieces[1].end_angle < pieces[1].start_angle);
  CHECK_OK(ww_path_polyline(path, 1.0, NULL, 0, &count));
  CHECK(count == 4); /* the ends of three pieces; one segment replaces the arc */
  CHECK_OK(ww_path_widest(path, &widest, NULL, 0, NULL, NULL, 0, NULL));
  CHECK(widest.is_connected == 0);
  query.start = at(21, 50);
  query.goal = at(79, 50);
  query.agent.radius = 20.5; /* the gap above the wall is 40 wide */
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_NO_PATH && info.has_widest == 1);
  CHECK_OK(ww_path_widest(path, &widest, from, 4, &from_count, to, 4, &to_count));
  CHECK(widest.is_limited == 1 && widest.radius == 20 && from_count == 1 && to_count == 1);
  CHECK((from[0] == 1 && to[0] == 0) || (from[0] == 0 && to[0] == 1));
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

void test_many_paths(void) {
  static const ww_point goals[] = {{90, 55}, {50, 50}, {10, 56}};
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_paths* paths = NULL;
  const ww_path* path = NULL;
  ww_path* copy = NULL;
  ww_path_watch* watch = NULL;
  ww_many_goals_query many;
  ww_path_query queries[3];
  ww_path_info info = {0};
  ww_job_system jobs;
  size_t i, count = 0;
  memset(&jobs, 0, sizeof jobs);
  jobs.struct_size = sizeof jobs;
  jobs.run = run_backwards;
  jobs.user_data = &job_runs;
  info.struct_size = sizeof info;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_paths_create(&paths));
  for (i = 0; i < 3; ++i) {
    CHECK_OK(ww_path_query_init(&queries[i], sizeof queries[i]));
    queries[i].start = at(10, 55);
    queries[i].goal = goals[i];
  }
  CHECK_OK(ww_world_find_paths(world, queries, 3, 2, &jobs, context, paths));
  CHECK_OK(ww_paths_count(paths, &count));
  CHECK(count == 3);
  CHECK_OK(ww_paths_get(paths, 2, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && info.length == 1);
  CHECK_OK(ww_path_create(&copy));
  CHECK_OK(ww_path_copy(path, copy));
  CHECK_STATUS(ww_path_copy(NULL, copy), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_paths_get(paths, 1, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_GOAL_BLOCKED);
  CHECK_STATUS(ww_paths_get(paths, 3, &path), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_find_paths(world, queries, 3, 0, NULL, context, paths), WW_INVALID_ARGUMENT);
  queries[1].goal = at(101, 0);
  CHECK_STATUS(ww_world_find_paths(world, queries, 3, 1, NULL, context, paths), WW_OUT_OF_DOMAIN);
  queries[1].struct_size = 4;
  CHECK_STATUS(ww_world_find_paths(world, queries, 3, 1, NULL, context, paths), WW_INVALID_ARGUMENT);

  CHECK_OK(ww_many_goals_query_init(&many, sizeof many));
  many.start = at(10, 55);
  many.goals = goals;
  many.goal_count = 3;
  CHECK_OK(ww_world_find_paths_from(world, &many, context, paths));
  CHECK_OK(ww_paths_get(paths, 2, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && info.length == 1 && info.point_count == 0);
  CHECK_OK(ww_path_watch_create(world, &watch));
  CHECK_STATUS(ww_path_watch_add(watch, 1, path), WW_INVALID_ARGUMENT); /* it has no points */
  ww_path_watch_destroy(watch);
  CHECK_OK(ww_path_get_info(copy, &info)); /* although the list has changed */
  CHECK(info.status == WW_PATH_FOUND && info.length == 1 && info.point_count == 2);
  ww_path_destroy(copy);
  many.wants_points = 1;
  CHECK_OK(ww_world_find_paths_from(world, &many, context, paths));
  CHECK_OK(ww_paths_get(paths, 0, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.point_count == 4);
  ww_paths_destroy(paths);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

void test_search(void) {
  ww_world* world = make_town(0);
  ww_search* search = NULL;
  const ww_path* path = NULL;
  ww_path_query query;
  ww_path_info info = {0};
  ww_bool is_done = 0, is_running = 0;
  size_t restarts = 0;
  int steps = 0;
  info.struct_size = sizeof info;
  CHECK_OK(ww_search_create(&search));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goal = at(90, 55);
  CHECK_OK(ww_search_begin(search, world, &query));
  CHECK_OK(ww_search_is_running(search, &is_running));
  CHECK(is_running == 1);
  CHECK_OK(
      ww_world_insert_segment(world, at(50, 60), at(50, 90), 2, NULL)); /* the path now leads around its lower end */
  for (; is_done == 0 && steps < 1000; ++steps) CHECK_OK(ww_search_step(search, 1, &is_done));
  CHECK(is_done == 1);
  CHECK_OK(ww_search_restarts(search, &restarts));
  CHECK(restarts == 1);
  CHECK_OK(ww_search_path(search, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && is_near(info.length, 2 * sqrt(30.0 * 30.0 + 15.0 * 15.0) + 20));
  CHECK_OK(ww_search_begin(search, world, &query));
  CHECK_OK(ww_search_cancel(search));
  CHECK_OK(ww_search_is_running(search, &is_running));
  CHECK(is_running == 0);
  CHECK_OK(ww_search_begin(search, world, &query));
  ww_world_destroy(world);
  CHECK_STATUS(ww_search_step(search, 1, &is_done), WW_WORLD_GONE);
  ww_search_destroy(search);
}

void test_search_windows(void) {
  ww_world* world = make_town(0);
  ww_search* search = NULL;
  const ww_path* path = NULL;
  ww_path_query query;
  ww_path_info info = {0};
  ww_search_window windows[64];
  ww_bool is_done = 0;
  size_t count = 1, turned = 0, all = 0;
  info.struct_size = sizeof info;
  CHECK_OK(ww_search_create(&search));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goal = at(90, 55);
  CHECK_OK(ww_search_begin(search, world, &query));
  CHECK_OK(ww_search_step(search, 1000, &is_done));
  CHECK_OK(ww_search_windows(search, windows, 64, &count));
  CHECK(is_done == 1 && count == 0); /* nobody asked for them */
  CHECK_OK(ww_search_record_windows(search, 1));
  CHECK_OK(ww_search_begin(search, world, &query));
  CHECK_OK(ww_search_step(search, 1000, &is_done));
  CHECK_OK(ww_search_windows(search, windows, 64, &count));
  CHECK_OK(ww_search_path(search, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.expansions > 0 && count >= info.expansions);
  CHECK(is_at(windows[0].root, 10, 55) && windows[0].length == 0);
  for (size_t i = 0; i < count; ++i) {
    if (!is_at(windows[i].root, 40, 60)) continue; /* the path turns here */
    ++turned;
    CHECK(is_near(windows[i].length, sqrt(30.0 * 30.0 + 5.0 * 5.0)));
  }
  CHECK(turned > 0);
  all = count;
  CHECK_STATUS(ww_search_windows(search, windows, 1, &count), WW_BUFFER_TOO_SMALL);
  CHECK(count == all);
  ww_search_destroy(search);
  ww_world_destroy(world);
}

void test_following_changes(void) {
  static const ww_point line[] = {{10, 30}, {90, 30}};
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_path* paths[2] = {NULL, NULL};
  ww_path_query query;
  ww_bool answer = 0;
  uint64_t version = 0;
  size_t indices[2];
  size_t i, count = 0;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  for (i = 0; i < 2; ++i) {
    CHECK_OK(ww_path_create(&paths[i]));
    query.start = at(10, i == 0 ? 90 : 30);
    query.goal = at(90, i == 0 ? 90 : 30);
    CHECK_OK(ww_world_find_path(world, &query, context, paths[i]));
  }
  CHECK_OK(ww_world_is_clear(world, line, 2, NULL, context, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_is_clear_between(world, at(10, 50), at(90, 50), NULL, context, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_version(world, &version));
  CHECK_OK(ww_world_insert_segment(world, at(20, 20), at(20, 40), 0, NULL));
  CHECK_OK(ww_world_is_affected(world, line, 2, NULL, version, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_is_path_affected(world, paths[0], version, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_find_affected(world, (const ww_path* const*)paths, 2, version, indices, 2, &count));
  CHECK(count == 1 && indices[0] == 1);
  CHECK_OK(ww_world_is_clear(world, line, 2, NULL, context, &answer));
  CHECK(answer == 0);
  for (i = 0; i < 2; ++i) ww_path_destroy(paths[i]);
  ww_context_destroy(context);
  ww_world_destroy(world);
}
