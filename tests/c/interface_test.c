/* Calls every group of functions of waywright.h. The expected answers come from the geometry of the scenes. This file
   tests changes of a world, and questions about it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

static void test_versions_and_names(void) {
  char text[32];
  snprintf(text, sizeof text, "%d.%d.%d", WW_VERSION_MAJOR, WW_VERSION_MINOR, WW_VERSION_PATCH);
  CHECK(strcmp(ww_version(), text) == 0);
  CHECK(ww_version_number() == WW_VERSION_NUMBER);
  CHECK(strcmp(ww_status_name(WW_OK), "ok") == 0);
  CHECK(strcmp(ww_status_name(WW_OUT_OF_DOMAIN), "out-of-domain") == 0);
  CHECK(strcmp(ww_status_name(WW_MALFORMED), "malformed") == 0);
  CHECK(strcmp(ww_status_name(WW_UNWRITABLE), "unwritable") == 0);
  CHECK(strcmp(ww_status_name(WW_UNWRITABLE + 1), "unknown") == 0);
  CHECK(strcmp(ww_status_name(WW_OUT_OF_MEMORY), "out-of-memory") == 0);
  CHECK(strcmp(ww_status_name(1000), "unknown") == 0);
  CHECK(strcmp(ww_item_kind_name(WW_ITEM_POLYLINE), "polyline") == 0);
  CHECK(strcmp(ww_fill_rule_name(WW_FILL_NONZERO), "nonzero") == 0);
  CHECK(strcmp(ww_location_kind_name(WW_LOCATION_EDGE), "edge") == 0);
  CHECK(strcmp(ww_path_algorithm_name(WW_ALGORITHM_TRA), "tra") == 0);
  CHECK(strcmp(ww_path_status_name(WW_PATH_NO_PATH), "no-path") == 0);
  CHECK(strcmp(ww_path_status_name(-1), "unknown") == 0);
  CHECK(WW_LARGEST_COORDINATE == ldexp(1, 100) && WW_SMALLEST_COORDINATE == ldexp(1, -100));
  CHECK(ww_is_in_range(0) == 1 && ww_is_in_range(-WW_LARGEST_COORDINATE) == 1);
  CHECK(ww_is_in_range(NAN) == 0 && ww_is_in_range(WW_SMALLEST_COORDINATE / 2) == 0);
}

static void test_shapes(void) {
  ww_shape shape;
  ww_point points[6];
  ww_point centroid;
  ww_box bounds;
  size_t count = 0;
  CHECK_OK(ww_regular_polygon(at(5, 5), 2, 4, points, 6, &count));
  CHECK(count == 4 && is_at(points[0], 7, 5));
  CHECK_OK(ww_regular_polygon(at(5, 5), 2, 2, points, 6, &count));
  CHECK(count == 0);
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
  CHECK_OK(ww_items_get_info(items, 0, &info));
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
  CHECK_STATUS(ww_world_insert_polyline(world, NULL, 0, 0, NULL), WW_BAD_SHAPE);
  shape.kind = WW_ITEM_SEGMENT;
  shape.ring_sizes = NULL;
  CHECK_STATUS(ww_world_insert(world, &shape, 0, NULL), WW_BAD_SHAPE);
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
  CHECK_OK(ww_world_ray(world, at(10, 50), at(90, 50), NULL, context, &hit, ids, 4, &count));
  CHECK(hit.hit == 1 && is_at(hit.at, 40, 50) && count == 1 && ids[0] == 1);
  CHECK_OK(ww_world_ray(world, at(90, 50), at(100, 50), NULL, context, &hit, ids, 4, &count));
  CHECK(hit.hit == 1 && count == 1 && ids[0] == 0);
  CHECK_OK(ww_world_ray(world, at(10, 50), at(90, 50), &(ww_agent){5}, context, &hit, ids, 4, &count));
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
  CHECK_OK(ww_world_fit_disc(world, at(30, 50), &(ww_agent){12}, context, &fits, from, 4, &from_count));
  CHECK(fits == 0 && from_count == 1 && from[0] == 1);
  CHECK_OK(ww_world_fit_disc(world, at(30, 50), &(ww_agent){10}, context, &fits, from, 4, &from_count));
  CHECK(fits == 1 && from_count == 0);
  CHECK_OK(ww_nearest_fit_query_init(&query, sizeof query));
  CHECK(isinf(query.limit));
  query.point = at(45, 50);
  query.agent.radius = 5;
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
  CHECK_OK(ww_world_widest_path(world, at(10, 50), at(90, 50), NULL, context, &widest, from, 4, &from_count, to, 4,
                                &to_count));
  CHECK(widest.is_connected == 1 && widest.is_limited == 1 && widest.radius == 20);
  CHECK(from_count >= 1 && to_count >= 1 && (from[0] == 1 || to[0] == 1));
  CHECK_STATUS(
      ww_world_widest_path(plain, at(10, 50), at(90, 50), NULL, context, &widest, NULL, 0, NULL, NULL, 0, NULL),
      WW_NO_BRIDGES);
  ww_context_destroy(context);
  ww_world_destroy(plain);
  ww_world_destroy(world);
}

static void test_bridges(void) {
  ww_world* world = make_town(1);
  ww_world* plain = make_town(0);
  ww_context* context = NULL;
  ww_bridge bridges[64];
  ww_id ids[256];
  size_t count = 0, id_count = 0, small = 0;
  const ww_box everything = {{0, 0}, {100, 100}};
  const ww_box between = {{30, 55}, {35, 58}}; /* between the two bridges on the left of the house */
  const ww_box inverted = {{5, 0}, {4, 0}};
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_world_bridges(world, everything, context, NULL, 0, &count, NULL, 0, &id_count));
  CHECK(count == 8 && id_count == 16); /* the house has four corners, and each has a bridge to two borders */
  CHECK_OK(ww_world_bridges(world, everything, context, bridges, 64, &count, ids, 256, &id_count));
  for (size_t i = 0; i < count; ++i) {
    CHECK(bridges[i].has_foot == 1 && bridges[i].from_count == 1 && bridges[i].to_count == 1);
    CHECK(bridges[i].first_id == 2 * i && ids[2 * i] == 1 && ids[2 * i + 1] == 0);
  }
  CHECK(is_at(bridges[0].from, 40, 40) && is_at(bridges[0].to, 0, 40) && bridges[0].radius == 20);
  CHECK_STATUS(ww_world_bridges(world, everything, context, bridges, 1, &small, ids, 256, NULL), WW_BUFFER_TOO_SMALL);
  CHECK(small == count);
  CHECK_STATUS(ww_world_bridges(world, everything, context, bridges, 64, NULL, ids, 1, &small), WW_BUFFER_TOO_SMALL);
  CHECK(small == id_count);
  CHECK_OK(ww_world_bridges(world, between, context, bridges, 64, &count, ids, 256, &id_count));
  CHECK(count == 0 && id_count == 0);
  CHECK_STATUS(ww_world_bridges(world, inverted, context, bridges, 64, &count, ids, 256, &id_count), WW_BAD_DOMAIN);
  CHECK_STATUS(ww_world_bridges(plain, everything, context, bridges, 64, &count, ids, 256, &id_count), WW_NO_BRIDGES);
  ww_context_destroy(context);
  ww_world_destroy(plain);
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
  test_bridges();
  test_broken_rules();
  test_point_paths();
  test_disc_paths();
  test_many_paths();
  test_search();
  test_search_windows();
  test_following_changes();
  test_copies();
  test_limits();
  test_going_back();
  test_trying_out();
  test_disconnecting();
  test_changed_regions();
  test_path_watch();
  test_snapshots();
  test_snapshots_of_ticks();
  test_saving();
  test_replaying();
  test_snippets();
  test_mesh();
  test_scenes();
  test_pictures();
  test_callbacks();
  return result_of_checks();
}
