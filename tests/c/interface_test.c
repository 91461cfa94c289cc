/* Calls every group of functions of waywright.h. The expected answers come from the geometry of the scenes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"

static ww_point at(double x, double y) {
  ww_point point;
  point.x = x;
  point.y = y;
  return point;
}

static ww_box box(double x0, double y0, double x1, double y1) {
  ww_box result;
  result.min = at(x0, y0);
  result.max = at(x1, y1);
  return result;
}

static int is_at(ww_point point, double x, double y) { return point.x == x && point.y == y; }
static int is_near(double a, double b) { return fabs(a - b) <= 1e-9 * (1 + fabs(b)); }

/* A world over (0, 0) to (100, 100), with the square house (40, 40) to (60, 60) under the id 1. */
static ww_world* make_town(ww_bool keep_bridges) {
  ww_world_options options;
  ww_world* world = NULL;
  ww_point corners[4];
  ww_id id = 0;
  size_t count = 0;
  CHECK_OK(ww_world_options_init(&options, sizeof options));
  options.keep_bridges = keep_bridges;
  CHECK_OK(ww_world_create(box(0, 0, 100, 100), &options, &world));
  CHECK_OK(ww_rectangle(box(40, 40, 60, 60), corners, 4, &count));
  CHECK(count == 4 && is_at(corners[1], 60, 40) && is_at(corners[3], 40, 60));
  CHECK_OK(ww_world_insert_polygon(world, corners, 4, 0, &id));
  CHECK(id == 1);
  return world;
}

static void test_versions_and_names(void) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", WW_VERSION_MAJOR, WW_VERSION_MINOR, WW_VERSION_PATCH);
  CHECK(strcmp(ww_version(), text) == 0);
  CHECK(ww_version_number() == WW_VERSION_NUMBER);
  CHECK(strcmp(ww_status_name(WW_OK), "ok") == 0);
  CHECK(strcmp(ww_status_name(WW_OUT_OF_DOMAIN), "out-of-domain") == 0);
  CHECK(strcmp(ww_status_name(WW_MALFORMED), "malformed") == 0);
  CHECK(strcmp(ww_status_name(WW_OUT_OF_MEMORY), "out-of-memory") == 0);
  CHECK(strcmp(ww_status_name(1000), "unknown") == 0);
  CHECK(strcmp(ww_item_kind_name(WW_ITEM_POLYLINE), "polyline") == 0);
  CHECK(strcmp(ww_fill_rule_name(WW_FILL_NONZERO), "nonzero") == 0);
  CHECK(strcmp(ww_location_kind_name(WW_LOCATION_EDGE), "edge") == 0);
  CHECK(strcmp(ww_path_algorithm_name(WW_ALGORITHM_TRA), "tra") == 0);
  CHECK(strcmp(ww_path_status_name(WW_PATH_NO_PATH), "no-path") == 0);
  CHECK(strcmp(ww_path_status_name(-1), "unknown") == 0);
}

static void test_shapes(void) {
  ww_shape shape;
  ww_point points[6];
  ww_point centroid;
  ww_box bounds;
  size_t count = 0;
  CHECK_OK(ww_regular_polygon(at(5, 5), 2, 4, points, 6, &count));
  CHECK(count == 4 && is_at(points[0], 7, 5));
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_POLYGON;
  shape.points = points;
  CHECK_OK(ww_rectangle(box(2, 2, 6, 4), points, 6, &count));
  shape.point_count = count;
  CHECK_OK(ww_centroid(&shape, &centroid));
  CHECK(is_at(centroid, 4, 3));
  CHECK_OK(ww_bounding_box(points, 4, &bounds));
  CHECK(is_at(bounds.min, 2, 2) && is_at(bounds.max, 6, 4));
  CHECK_OK(ww_translated(&shape, 10, 1, points, 6, &count));
  CHECK(count == 4 && is_at(points[0], 12, 3) && is_at(points[2], 16, 5));
}

static void test_changes(void) {
  static const ww_point chain[] = {{1, 1}, {2, 1}, {2, 2}};
  static const ww_point rings[] = {{70, 70}, {90, 70}, {90, 90}, {70, 90}, {75, 75}, {85, 75}, {85, 85}};
  static const size_t ring_sizes[] = {4, 3};
  static const ww_point moved[] = {{30, 10}, {40, 10}};
  ww_world* world = make_town(0);
  ww_items* items = NULL;
  ww_shape shape;
  ww_change changes[3];
  ww_item_info info = {0};
  ww_items_hash before, after;
  ww_point points[8];
  size_t sizes[4];
  ww_id ids[8];
  ww_id id = 0;
  ww_bool contains = 0;
  uint64_t version = 0;
  size_t count = 0;
  CHECK_OK(ww_items_create(&items));
  CHECK_OK(ww_world_insert_point(world, at(10, 10), 20, &id));
  CHECK(id == 20);
  CHECK_OK(ww_world_insert_segment(world, at(20, 10), at(30, 10), 0, &id));
  CHECK(id == 21);
  CHECK_OK(ww_world_insert_polyline(world, chain, 3, 7, NULL));
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_POLYGON;
  shape.fill = WW_FILL_NONZERO;
  shape.points = rings;
  shape.point_count = 7;
  shape.ring_sizes = ring_sizes;
  shape.ring_count = 2;
  CHECK_OK(ww_world_insert(world, &shape, 30, NULL));

  CHECK_OK(ww_world_item_ids(world, NULL, 0, &count));
  CHECK(count == 5);
  CHECK_STATUS(ww_world_item_ids(world, ids, 2, &count), WW_BUFFER_TOO_SMALL);
  CHECK(count == 5 && ids[0] == 1 && ids[1] == 7);
  CHECK_OK(ww_world_item_ids(world, ids, 8, &count));
  CHECK(count == 5 && ids[2] == 20 && ids[3] == 21 && ids[4] == 30);
  CHECK_OK(ww_world_item(world, 30, items));
  info.struct_size = sizeof info;
  CHECK_OK(ww_items_info(items, 0, &info));
  CHECK(info.kind == WW_ITEM_POLYGON && info.fill == WW_FILL_NONZERO && info.id == 30);
  CHECK(info.point_count == 7 && info.ring_count == 2);
  CHECK_OK(ww_items_ring_sizes(items, 0, sizes, 4, &count));
  CHECK(count == 2 && sizes[0] == 4 && sizes[1] == 3);
  CHECK_OK(ww_items_points(items, 0, points, 8, &count));
  CHECK(count == 7 && memcmp(points, rings, sizeof rings) == 0);

  CHECK_OK(ww_world_items_hash(world, &before));
  CHECK_STATUS(ww_world_insert_segment(world, at(0, 0), at(200, 0), 0, NULL), WW_OUT_OF_DOMAIN);
  CHECK_STATUS(ww_world_insert_point(world, at(5, 5), 20, NULL), WW_ID_IN_USE);
  CHECK_STATUS(ww_world_remove(world, 99), WW_UNKNOWN_ID);
  CHECK_STATUS(ww_world_insert_point(world, at(NAN, 5), 0, NULL), WW_COORDINATE_RANGE);
  CHECK_STATUS(ww_world_insert_polyline(world, NULL, 0, 0, NULL), WW_EMPTY_SHAPE);
  shape.kind = WW_ITEM_SEGMENT;
  shape.ring_sizes = NULL;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_EMPTY_SHAPE);
  CHECK_OK(ww_world_items_hash(world, &after));
  CHECK(memcmp(&before, &after, sizeof before) == 0);

  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_SEGMENT;
  shape.points = moved;
  shape.point_count = 2;
  CHECK_OK(ww_world_replace(world, 21, &shape));
  memset(changes, 0, sizeof changes);
  changes[0].kind = WW_CHANGE_REMOVE;
  changes[0].id = 30;
  changes[1].kind = WW_CHANGE_INSERT;
  changes[1].shape = &shape;
  changes[2].kind = WW_CHANGE_REPLACE;
  changes[2].id = 7;
  changes[2].shape = &shape;
  CHECK_OK(ww_world_version(world, &version));
  CHECK(version == 6); /* 5 insertions, 1 replacement */
  CHECK_OK(ww_world_apply(world, changes, 3, ids));
  CHECK(ids[0] == 30 && ids[1] == 31 && ids[2] == 7);
  CHECK_OK(ww_world_version(world, &version));
  CHECK(version == 7);
  CHECK_OK(ww_world_contains(world, 30, &contains));
  CHECK(contains == 0);
  CHECK_OK(ww_world_remove(world, 31));
  CHECK_OK(ww_world_item_count(world, &count));
  CHECK(count == 4);
  changes[2].id = 99;
  CHECK_STATUS(ww_world_apply(world, changes + 1, 2, NULL), WW_UNKNOWN_ID);
  CHECK_OK(ww_world_item_count(world, &count));
  CHECK(count == 4);
  ww_items_destroy(items);
  ww_world_destroy(world);
}

static void test_errors(void) {
  ww_world* world = make_town(0);
  ww_error error = {0};
  char message[128];
  size_t count = 0;
  error.struct_size = sizeof error;
  CHECK_STATUS(ww_world_remove(world, 99), WW_UNKNOWN_ID);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_UNKNOWN_ID && error.item == 99);
  CHECK_OK(ww_last_error_message(message, sizeof message, &count));
  CHECK(strcmp(message, "no item has id 99") == 0 && count == sizeof "no item has id 99");
  CHECK_STATUS(ww_last_error_message(message, 3, NULL), WW_BUFFER_TOO_SMALL);
  CHECK(strcmp(message, "no") == 0);
  CHECK_STATUS(ww_world_remove(NULL, 1), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_INVALID_ARGUMENT && error.item == 0);
  ww_world_destroy(world);
  ww_world_destroy(NULL);
}

static size_t progress_calls = 0;
static int progress_ended = 0;
static void count_progress(size_t done, size_t total, void* user_data) {
  CHECK(user_data == &progress_calls);
  ++progress_calls;
  progress_ended = done == total;
}

static size_t job_runs = 0;
static void run_backwards(size_t count, ww_job job, void* job_data, void* user_data) {
  CHECK(user_data == &job_runs);
  ++job_runs;
  while (count > 1) job(job_data, --count); /* omits job 0 */
}

static void test_bulk(void) {
  enum { kCount = 3000 };
  ww_point* points = malloc(kCount * sizeof *points);
  ww_bulk_options options;
  ww_job_system jobs;
  ww_world* town = make_town(0);
  ww_world* copy = NULL;
  ww_context* context = NULL;
  ww_items* items = NULL;
  ww_mesh_hash of_town, of_copy;
  ww_id first = 0;
  ww_box domain;
  size_t i, count = 0;
  for (i = 0; i < kCount; ++i) points[i] = at((double)(i % 60) + 0.5, (double)(i / 60) + 0.25);
  memset(&jobs, 0, sizeof jobs);
  jobs.struct_size = sizeof jobs;
  jobs.run = run_backwards;
  jobs.user_data = &job_runs;
  CHECK_OK(ww_bulk_options_init(&options, sizeof options));
  CHECK(options.threads == 1 && options.jobs == NULL && options.progress == NULL);
  options.threads = 3;
  options.progress = count_progress;
  options.progress_user_data = &progress_calls;
  options.jobs = &jobs;
  CHECK_OK(ww_world_insert_points(town, points, kCount, 100, &options, &first));
  CHECK(first == 100 && progress_calls > 0 && progress_ended);

  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_items_create(&items));
  CHECK_OK(ww_world_items(town, context, items));
  CHECK_OK(ww_items_count(items, &count));
  CHECK(count == kCount + 1);
  CHECK_OK(ww_world_domain(town, &domain));
  CHECK_OK(ww_world_create(domain, NULL, &copy));
  CHECK_OK(ww_world_insert_all(copy, items, &options, NULL));
  CHECK(job_runs > 0);
  CHECK_OK(ww_world_mesh_hash(town, &of_town));
  CHECK_OK(ww_world_mesh_hash(copy, &of_copy));
  CHECK(memcmp(&of_town, &of_copy, sizeof of_town) == 0);
  options.threads = 0;
  CHECK_STATUS(ww_world_insert_all(copy, items, &options, NULL), WW_INVALID_ARGUMENT);
  free(points);
  ww_items_destroy(items);
  ww_context_destroy(context);
  ww_world_destroy(copy);
  ww_world_destroy(town);
}

static void test_locating(void) {
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_location location = {0};
  ww_crossed_item crossed[4];
  ww_ray_hit hit = {0};
  ww_id ids[4];
  size_t count = 0;
  location.struct_size = sizeof location;
  hit.struct_size = sizeof hit;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_world_insert_segment(world, at(80, 0), at(80, 90), 5, NULL));
  CHECK_OK(ww_world_locate(world, at(40, 60), context, &location, ids, 4, &count));
  CHECK(location.kind == WW_LOCATION_VERTEX && location.vertex_count == 1 && is_at(location.vertices[0], 40, 60));
  CHECK(count == 1 && ids[0] == 1);
  CHECK_OK(ww_world_locate(world, at(80, 0.5), context, &location, NULL, 0, &count));
  CHECK(location.kind == WW_LOCATION_EDGE && location.vertex_count == 2 && count == 0);
  CHECK_STATUS(ww_world_locate(world, at(101, 0), context, &location, ids, 4, &count), WW_OUT_OF_DOMAIN);
  CHECK_OK(ww_world_items_at(world, at(50, 50), context, ids, 4, &count));
  CHECK(count == 1 && ids[0] == 1);
  CHECK_OK(ww_world_items_in(world, box(50, 50, 90, 55), context, ids, 4, &count));
  CHECK(count == 2 && ids[0] == 1 && ids[1] == 5);
  CHECK_OK(ww_world_items_crossed(world, at(50, 50), at(90, 50), context, crossed, 4, &count));
  CHECK(count == 2 && crossed[0].id == 1 && is_at(crossed[0].at, 60, 50));
  CHECK(crossed[1].id == 5 && is_at(crossed[1].at, 80, 50));
  CHECK_OK(ww_world_ray(world, at(10, 50), at(90, 50), context, &hit, ids, 4, &count));
  CHECK(hit.hit == 1 && is_at(hit.at, 40, 50) && count == 1 && ids[0] == 1);
  CHECK_OK(ww_world_ray(world, at(90, 50), at(100, 50), context, &hit, ids, 4, &count));
  CHECK(hit.hit == 1 && count == 1 && ids[0] == 0);
  CHECK_OK(ww_world_sweep_disc(world, at(10, 50), at(90, 50), 5, context, &hit, ids, 4, &count));
  CHECK(hit.hit == 1 && is_at(hit.at, 35, 50) && is_at(hit.contact, 40, 50) && count == 1 && ids[0] == 1);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_discs(void) {
  ww_world* world = make_town(1);
  ww_world* plain = make_town(0);
  ww_context* context = NULL;
  ww_nearest_fit_query query;
  ww_nearest_fit fit = {0};
  ww_widest_path widest = {0};
  ww_bool fits = 1;
  ww_id from[4], to[4];
  size_t from_count = 0, to_count = 0;
  CHECK_OK(ww_context_create(&context));
  fit.struct_size = sizeof fit;
  widest.struct_size = sizeof widest;
  CHECK_OK(ww_world_fit_disc(world, at(30, 50), 12, context, &fits, from, 4, &from_count));
  CHECK(fits == 0 && from_count == 1 && from[0] == 1);
  CHECK_OK(ww_world_fit_disc(world, at(30, 50), 10, context, &fits, from, 4, &from_count));
  CHECK(fits == 1 && from_count == 0);
  CHECK_OK(ww_nearest_fit_query_init(&query, sizeof query));
  CHECK(isinf(query.limit));
  query.point = at(45, 50);
  query.radius = 5;
  CHECK_OK(ww_world_nearest_fit(world, &query, context, &fit));
  CHECK(fit.is_found == 1 && is_at(fit.at, 35, 50) && fit.distance == 10);
  query.limit = 9;
  CHECK_OK(ww_world_nearest_fit(world, &query, context, &fit));
  CHECK(fit.is_found == 0);
  query.limit = INFINITY;
  query.has_goal = 1;
  query.goal = at(90, 90);
  CHECK_OK(ww_world_nearest_fit(world, &query, context, &fit));
  CHECK(fit.is_found == 1 && is_at(fit.at, 35, 50));
  CHECK_STATUS(ww_world_nearest_fit(plain, &query, context, &fit), WW_NO_BRIDGES);
  CHECK_OK(ww_world_widest_path(world, at(10, 50), at(90, 50), context, &widest, from, 4, &from_count, to, 4, &to_count));
  CHECK(widest.is_connected == 1 && widest.is_limited == 1 && widest.radius == 20);
  CHECK(from_count >= 1 && to_count >= 1 && (from[0] == 1 || to[0] == 1));
  CHECK_STATUS(ww_world_widest_path(plain, at(10, 50), at(90, 50), context, &widest, NULL, 0, NULL, NULL, 0, NULL),
               WW_NO_BRIDGES);
  ww_context_destroy(context);
  ww_world_destroy(plain);
  ww_world_destroy(world);
}

static void test_point_paths(void) {
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
  CHECK(is_at(info.moved_goal_from, 42, 50) && is_at(info.moved_goal_to, 40, 50));
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
  query.radius = 1;
  CHECK_STATUS(ww_world_find_path(world, &query, context, path), WW_NO_BRIDGES);
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_disc_paths(void) {
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
  query.radius = 5;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.status == WW_PATH_FOUND && info.radius == 5 && info.point_count == 0);
  CHECK_OK(ww_path_pieces(path, pieces, 8, &count));
  CHECK(count == 3 && pieces[0].kind == WW_PIECE_LINE && pieces[1].kind == WW_PIECE_ARC);
  CHECK(is_at(pieces[1].centre, 50, 60) && pieces[1].radius == 5 && pieces[1].end_angle < pieces[1].start_angle);
  CHECK_OK(ww_path_polyline(path, 1.0, NULL, 0, &count));
  CHECK(count == 4); /* the ends of three pieces; one segment replaces the arc */
  CHECK_OK(ww_path_widest(path, &widest, NULL, 0, NULL, NULL, 0, NULL));
  CHECK(widest.is_connected == 0);
  query.start = at(21, 50);
  query.goal = at(79, 50);
  query.radius = 20.5; /* the gap above the wall is 40 wide */
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

static void test_many_paths(void) {
  static const ww_point goals[] = {{90, 55}, {50, 50}, {10, 56}};
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_paths* paths = NULL;
  const ww_path* path = NULL;
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
  many.wants_points = 1;
  CHECK_OK(ww_world_find_paths_from(world, &many, context, paths));
  CHECK_OK(ww_paths_get(paths, 0, &path));
  CHECK_OK(ww_path_get_info(path, &info));
  CHECK(info.point_count == 4);
  ww_paths_destroy(paths);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_search(void) {
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
  CHECK_OK(ww_world_insert_segment(world, at(50, 60), at(50, 90), 2, NULL)); /* the way round is below now */
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

static void test_following_changes(void) {
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
  CHECK_OK(ww_world_is_clear(world, line, 2, context, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_is_clear_between(world, at(10, 50), at(90, 50), context, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_version(world, &version));
  CHECK_OK(ww_world_insert_segment(world, at(20, 20), at(20, 40), 0, NULL));
  CHECK_OK(ww_world_is_affected(world, line, 2, version, &answer));
  CHECK(answer == 1);
  CHECK_OK(ww_world_is_path_affected(world, paths[0], version, &answer));
  CHECK(answer == 0);
  CHECK_OK(ww_world_find_affected(world, (const ww_path* const*)paths, 2, version, indices, 2, &count));
  CHECK(count == 1 && indices[0] == 1);
  CHECK_OK(ww_world_is_clear(world, line, 2, context, &answer));
  CHECK(answer == 0);
  for (i = 0; i < 2; ++i) ww_path_destroy(paths[i]);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_mesh(void) {
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_mesh* mesh = NULL;
  ww_text* text = NULL;
  ww_point vertices[16];
  ww_triangle triangles[32];
  ww_constrained_edge edges[16];
  ww_id ids[16];
  ww_mesh_hash hash;
  ww_items_hash items_hash;
  ww_memory_use use = {0};
  ww_predicate_counts counts = {0};
  char hex[65];
  ww_bool is_valid = 0;
  size_t vertex_count = 0, triangle_count = 0, count = 0;
  use.struct_size = sizeof use;
  counts.struct_size = sizeof counts;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_mesh_create(&mesh));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_world_vertex_count(world, &vertex_count));
  CHECK_OK(ww_world_triangle_count(world, &triangle_count));
  CHECK(vertex_count == 8 && triangle_count == 10); /* Euler: 2 * 8 - 2 - 4 border vertices */
  CHECK_OK(ww_world_snapshot(world, context, mesh));
  CHECK_OK(ww_mesh_vertices(mesh, vertices, 16, &count));
  CHECK(count == 8 && is_at(vertices[0], 0, 0) && is_at(vertices[7], 100, 100));
  CHECK_OK(ww_mesh_triangles(mesh, triangles, 32, &count));
  CHECK(count == 10 && triangles[0].vertices[0] == 0);
  CHECK_OK(ww_mesh_constrained_edges(mesh, edges, 16, &count));
  CHECK(count == 8 && edges[0].vertices[0] == 0 && edges[0].id_count == 1);
  CHECK_OK(ww_mesh_ids(mesh, ids, 16, &count));
  CHECK(count == 8 && ids[edges[0].first_id] == 0);
  CHECK_OK(ww_world_dump(world, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &count));
  CHECK(count > 100);
  CHECK_OK(ww_world_mesh_hash(world, &hash));
  CHECK_STATUS(ww_mesh_hash_text(&hash, hex, 64, &count), WW_BUFFER_TOO_SMALL);
  CHECK(count == 65);
  CHECK_OK(ww_mesh_hash_text(&hash, hex, 65, &count));
  CHECK(strlen(hex) == 64);
  CHECK_OK(ww_world_items_hash(world, &items_hash));
  CHECK_OK(ww_items_hash_text(&items_hash, hex, 65, &count));
  CHECK(strlen(hex) == 32 && count == 33);
  CHECK_OK(ww_world_validate(world, &is_valid, text));
  CHECK(is_valid == 1);
  CHECK_OK(ww_text_read(text, hex, 65, &count));
  CHECK(count == 1 && hex[0] == '\0');
  CHECK_OK(ww_world_memory(world, &use));
  CHECK(use.vertices > 0 && use.faces > 0 && use.bridges == 0);
  CHECK(use.total == use.vertices + use.crossings + use.faces + use.walls + use.items + use.sectors + use.abstraction +
                         use.bridges + use.spare);
  count = use.total;
  CHECK_OK(ww_world_shrink_to_fit(world));
  CHECK_OK(ww_world_memory(world, &use));
  CHECK(use.total <= count);
  CHECK_OK(ww_get_predicate_counts(&counts));
  CHECK(counts.orientation.doubles > 0);
  ww_text_destroy(text);
  ww_mesh_destroy(mesh);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_scenes(void) {
  static const char map[] = "type octile\nheight 2\nwidth 3\nmap\n..@\n..@\n";
  static const char node[] = "2 2 0 0\n1 1 2\n2 3 4\n";
  static const char poly[] = "0 2 0 0\n1 0\n1 1 2\n0\n";
  static const char scenario_text[] = "version 1\n0\tfolder/arena.map\t49\t40\t1\t11\t2\t12\t1.41\n";
  ww_scene* scene = NULL;
  ww_script* script = NULL;
  ww_scenario* scenario = NULL;
  ww_text* text = NULL;
  ww_world* world = NULL;
  const ww_items* items = NULL;
  ww_scene_info info = {0};
  ww_scenario_query query = {0};
  ww_scene_format format = -1;
  ww_error error = {0};
  char buffer[256];
  size_t count = 0;
  info.struct_size = sizeof info;
  query.struct_size = sizeof query;
  error.struct_size = sizeof error;
  CHECK_OK(ww_scene_create(&scene));
  CHECK_OK(ww_script_create(&script));
  CHECK_OK(ww_scenario_create(&scenario));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_scene_format_of("a.poly", &format));
  CHECK(format == WW_SCENE_TRIANGLE_POLY);
  CHECK_STATUS(ww_scene_format_of("a.png", &format), WW_NOT_SUPPORTED);
  CHECK_OK(ww_scene_parse_movingai_map(map, sizeof map - 1, "small.map", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 1 && info.item_count == 1 && is_at(info.domain.max, 3, 2));
  CHECK_OK(ww_scene_items(scene, &items));
  CHECK_OK(ww_world_create(info.domain, NULL, &world));
  CHECK_OK(ww_world_insert_all(world, items, NULL, NULL));
  CHECK_OK(ww_scene_to_script(scene, text));
  CHECK_OK(ww_text_read(text, buffer, sizeof buffer, &count));
  CHECK(strncmp(buffer, "waywright 1\n", 12) == 0);
  CHECK_OK(ww_script_parse(buffer, count - 1, "again", script));
  CHECK_OK(ww_script_scene(script, scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 0 && info.item_count == 1);
  CHECK_OK(ww_scene_parse_triangle_node(node, sizeof node - 1, "a.node", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.item_count == 2);
  CHECK_OK(ww_scene_parse_triangle_poly(poly, sizeof poly - 1, "a.poly", node, sizeof node - 1, "a.node", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.item_count == 1);
  CHECK_OK(ww_scene_set(scene, box(0, 0, 5, 5), items, 1));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 1 && is_at(info.domain.max, 5, 5));
  CHECK_STATUS(ww_scene_read("/no/such/file.wws", scene), WW_UNREADABLE);
  CHECK_STATUS(ww_script_parse("waywright 1\nfly\n", 16, "bad.wws", script), WW_MALFORMED);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_MALFORMED && error.index == 2);
  CHECK_OK(ww_last_error_message(buffer, sizeof buffer, NULL));
  CHECK(strncmp(buffer, "bad.wws:2: ", 11) == 0);

  CHECK_OK(ww_scenario_parse(scenario_text, sizeof scenario_text - 1, "a.scen", scenario));
  CHECK_OK(ww_scenario_count(scenario, &count));
  CHECK(count == 1);
  CHECK_OK(ww_scenario_get(scenario, 0, &query, buffer, sizeof buffer, &count));
  CHECK(strcmp(buffer, "folder/arena.map") == 0 && count == 17 && query.width == 49 && query.height == 40);
  CHECK(query.line == 2 && query.length == 1.41 && is_near(query.precision, 0.005));
  ww_world_destroy(world);
  ww_text_destroy(text);
  ww_scenario_destroy(scenario);
  ww_script_destroy(script);
  ww_scene_destroy(scene);
}

static int contains(const char* text, const char* part) { return strstr(text, part) != NULL; }

static void test_pictures(void) {
  static const ww_point line[] = {{5, 5}, {9, 8}, {5, 11}};
  ww_world* world = make_town(1);
  ww_context* context = NULL;
  ww_path* path = NULL;
  ww_text* text = NULL;
  ww_svg_overlay* overlay = NULL;
  ww_svg_options options;
  ww_svg_frame frame = {0};
  ww_path_query query;
  ww_ray_hit hit = {0};
  ww_location location = {0};
  ww_point pixels, back;
  ww_id ids[4];
  char* svg = NULL;
  size_t size = 0, count = 0;
  hit.struct_size = sizeof hit;
  location.struct_size = sizeof location;
  frame.struct_size = sizeof frame;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_create(&path));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_svg_overlay_create(&overlay));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goal = at(90, 55);
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_svg_add_path(overlay, path));
  query.radius = 5;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_svg_add_disc_path(overlay, &query, path));
  CHECK_OK(ww_world_ray(world, at(10, 50), at(90, 50), context, &hit, ids, 4, &count));
  CHECK_OK(ww_svg_add_ray(overlay, at(10, 50), at(90, 50), &hit, ids, count));
  CHECK_OK(ww_world_locate(world, at(50, 50), context, &location, ids, 4, &count));
  CHECK_OK(ww_svg_add_location(overlay, at(50, 50), &location, ids, count));
  CHECK_OK(ww_svg_add_failed_path(overlay, at(10, 10), at(50, 50), WW_PATH_GOAL_BLOCKED));
  CHECK_OK(ww_svg_add_disc(overlay, at(20, 20), 2, "#d55e00", "Archers in C"));
  CHECK_OK(ww_svg_add_polyline(overlay, line, 3, 4, 1, NULL, NULL));
  CHECK_OK(ww_svg_add_label(overlay, at(20, 20), "a label in C", 2, 14, NULL));
  CHECK_OK(ww_svg_add_key(overlay, "a key in C", "red"));
  CHECK_OK(ww_svg_add_elements(overlay, "<circle cx=\"3\" cy=\"4\" r=\"2\"/>"));
  CHECK_OK(ww_svg_options_init(&options, sizeof options));
  CHECK(options.width == 1200 && options.mesh == 1 && options.has_crop == 0);
  options.title = "a title in C";
  CHECK_OK(ww_world_to_svg(world, overlay, &options, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &size));
  svg = malloc(size);
  CHECK_OK(ww_text_read(text, svg, size, &count));
  CHECK(count == size && strlen(svg) + 1 == size);
  CHECK(contains(svg, "<svg") && contains(svg, "a title in C") && contains(svg, "Archers in C"));
  CHECK(contains(svg, "a label in C") && contains(svg, "a key in C") && contains(svg, "cx=\"3\" cy=\"4\""));
  CHECK(contains(svg, "path of a disc, radius 5") && contains(svg, "ray from"));
  free(svg);
  CHECK_OK(ww_svg_overlay_clear(overlay));
  CHECK_OK(ww_world_to_svg(world, NULL, NULL, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &count));
  CHECK(count < size);
  CHECK_OK(ww_svg_get_frame(box(0, 0, 100, 100), &options, &frame));
  CHECK_OK(ww_svg_to_picture(&frame, at(25, 75), &pixels));
  CHECK(is_near(pixels.x, frame.map.min.x + 25 * frame.scale) && is_near(pixels.y, frame.map.min.y + 25 * frame.scale));
  CHECK_OK(ww_svg_to_world(&frame, pixels, &back));
  CHECK(is_near(back.x, 25) && is_near(back.y, 75));
  options.has_crop = 1;
  options.crop = box(5, 5, 5, 5);
  CHECK_STATUS(ww_world_to_svg(world, NULL, &options, text), WW_BAD_DOMAIN);
  ww_svg_overlay_destroy(overlay);
  ww_text_destroy(text);
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

static void test_broken_rules(void) {
  static const size_t ring_sizes[] = {2, SIZE_MAX};
  ww_world* world = make_town(0);
  ww_world* other = NULL;
  ww_context* context = NULL;
  ww_shape shape;
  ww_world_options options;
  ww_location location = {0};
  ww_change change;
  ww_point point = {0, 0};
  ww_id ids[2];
  size_t count = 0;
  CHECK_OK(ww_context_create(&context));
  CHECK_STATUS(ww_context_create(NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_create(box(0, 0, 0, 1), NULL, &other), WW_BAD_DOMAIN);
  CHECK_STATUS(ww_world_create(box(0, 0, 1, 1), NULL, NULL), WW_INVALID_ARGUMENT);
  options.struct_size = 3;
  CHECK_STATUS(ww_world_create(box(0, 0, 1, 1), &options, &other), WW_INVALID_ARGUMENT);
  options.struct_size = 1000;
  CHECK_STATUS(ww_world_create(box(0, 0, 1, 1), &options, &other), WW_INVALID_ARGUMENT);
  CHECK(other == NULL);
  CHECK_STATUS(ww_world_options_init(&options, 1000), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_locate(world, point, context, &location, ids, 2, &count), WW_INVALID_ARGUMENT);
  location.struct_size = sizeof location;
  CHECK_STATUS(ww_world_locate(world, point, context, &location, NULL, 2, &count), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_locate(world, point, NULL, &location, ids, 2, &count), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_locate(NULL, point, context, &location, ids, 2, &count), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_insert_polyline(world, NULL, 3, 0, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_regular_polygon(point, 1, 2, NULL, 0, &count), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_bounding_box(NULL, 0, NULL), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  CHECK_STATUS(ww_centroid(&shape, &point), WW_INVALID_ARGUMENT);
  shape.points = &point;
  shape.point_count = 1;
  shape.ring_sizes = ring_sizes;
  shape.ring_count = 2;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_INVALID_ARGUMENT);
  shape.ring_count = 0;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_INVALID_ARGUMENT);
  shape.ring_sizes = NULL;
  shape.kind = 4;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_INVALID_ARGUMENT);
  shape.kind = WW_ITEM_POINT;
  shape.fill = -1;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_INVALID_ARGUMENT);
  memset(&change, 0, sizeof change);
  change.kind = 3;
  CHECK_STATUS(ww_world_apply(world, &change, 1, NULL), WW_INVALID_ARGUMENT);
  change.kind = WW_CHANGE_INSERT;
  CHECK_STATUS(ww_world_apply(world, &change, 1, NULL), WW_INVALID_ARGUMENT);
  CHECK_OK(ww_world_item_count(world, &count));
  CHECK(count == 1);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

int main(void) {
  test_versions_and_names();
  test_shapes();
  test_changes();
  test_errors();
  test_bulk();
  test_locating();
  test_discs();
  test_point_paths();
  test_disc_paths();
  test_many_paths();
  test_search();
  test_following_changes();
  test_mesh();
  test_scenes();
  test_pictures();
  test_broken_rules();
  return result_of_checks();
}
