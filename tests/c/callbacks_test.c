/* Tests functions of a program that break the rules while the library runs them. The call or the function that broke
   the rule gets WW_INVALID_ARGUMENT, and the world is as before or as the call leaves it. */
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

enum { kCount = 3000, kQueries = 8 };

/* A world, and what a function that uses it too early has found. */
typedef struct visitor {
  ww_world* world;
  ww_snapshot* snapshot;
  ww_context* context;
  size_t calls;
  size_t wrong_index; /* SIZE_MAX if the job system shall be right */
} visitor;

static ww_point* many_points(void) {
  ww_point* points = malloc(kCount * sizeof *points);
  size_t i;
  for (i = 0; i < kCount; ++i) points[i] = at((double)(i % 60) + 0.5, (double)(i / 60) + 0.25);
  return points;
}

static ww_job_system jobs_of(void (*run)(size_t, ww_job, void*, void*), visitor* visited) {
  ww_job_system jobs;
  memset(&jobs, 0, sizeof jobs);
  jobs.struct_size = sizeof jobs;
  jobs.run = run;
  jobs.user_data = visited;
  return jobs;
}

static void call_wrong_job(size_t count, ww_job job, void* job_data, void* user_data) {
  visitor* visited = user_data;
  size_t i;
  ++visited->calls;
  if (visited->wrong_index != SIZE_MAX) job(job_data, count + visited->wrong_index);
  for (i = 0; i < count; ++i) job(job_data, i);
}

/* Uses the world that a call changes. The library refuses each of these calls. */
static void use_changing_world(visitor* visited) {
  ww_error error = {0};
  ww_box domain;
  size_t count = 0;
  ++visited->calls;
  CHECK_STATUS(ww_world_remove(visited->world, 1), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_domain(visited->world, &domain), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_item_ids(visited->world, NULL, 0, &count), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_publish(visited->world, &visited->snapshot), WW_INVALID_ARGUMENT);
  error.struct_size = sizeof error;
  CHECK_STATUS(ww_world_insert_point(visited->world, at(1, 1), 0, NULL), WW_INVALID_ARGUMENT);
  ww_world_destroy(visited->world);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_INVALID_ARGUMENT);
}

static void use_in_progress(size_t done, size_t total, void* user_data) {
  CHECK(done <= total);
  use_changing_world(user_data);
}

static void use_in_run(size_t count, ww_job job, void* job_data, void* user_data) {
  size_t i;
  use_changing_world(user_data);
  for (i = 0; i < count; ++i) job(job_data, i);
}

/* Reads the world that a call reads, which is allowed, and tries to change it, which is not. */
static void use_read_world(visitor* visited) {
  size_t count = 0;
  ++visited->calls;
  CHECK_OK(ww_world_item_count(visited->world, &count));
  CHECK(count == 1);
  CHECK_STATUS(ww_world_remove(visited->world, 1), WW_INVALID_ARGUMENT);
  ww_world_destroy(visited->world);
}

static void use_while_searching(size_t count, ww_job job, void* job_data, void* user_data) {
  size_t i;
  use_read_world(user_data);
  for (i = 0; i < count; ++i) job(job_data, i);
}

static ww_bool use_while_writing(const void* bytes, size_t size, void* user_data) {
  CHECK(bytes != NULL && size > 0);
  use_read_world(user_data);
  return 1;
}

/* Tries to destroy the snapshot that a call saves. */
static ww_bool release_while_writing(const void* bytes, size_t size, void* user_data) {
  visitor* visited = user_data;
  const ww_world* published = NULL;
  CHECK(bytes != NULL && size > 0);
  ++visited->calls;
  ww_snapshot_destroy(visited->snapshot);
  CHECK_OK(ww_snapshot_world(visited->snapshot, &published));
  return 1;
}

static void test_wrong_job_indexes(void) {
  static const size_t offsets[] = {0, 1, 1000000, SIZE_MAX / 2};
  ww_point* points = many_points();
  size_t i, count = 0;
  for (i = 0; i < sizeof offsets / sizeof *offsets; ++i) {
    visitor visited = {NULL, NULL, NULL, 0, 0};
    ww_job_system jobs = jobs_of(call_wrong_job, &visited);
    ww_world* town = make_town(0);
    ww_bulk_options options;
    visited.wrong_index = offsets[i];
    CHECK_OK(ww_bulk_options_init(&options, sizeof options));
    options.threads = 3;
    options.jobs = &jobs;
    CHECK_STATUS(ww_world_insert_points(town, points, kCount, 100, &options, NULL), WW_INVALID_ARGUMENT);
    CHECK(visited.calls == 1);
    CHECK_OK(ww_world_item_count(town, &count));
    CHECK(count == 1);
    visited.wrong_index = SIZE_MAX;
    CHECK_OK(ww_world_insert_points(town, points, kCount, 100, &options, NULL));
    CHECK_OK(ww_world_item_count(town, &count));
    CHECK(count == kCount + 1);
    ww_world_destroy(town);
  }
  free(points);
}

static void test_using_a_changing_world(void) {
  ww_point* points = many_points();
  visitor visited = {NULL, NULL, NULL, 0, 0};
  ww_job_system jobs = jobs_of(use_in_run, &visited);
  ww_bulk_options options;
  ww_items* items = NULL;
  ww_context* context = NULL;
  size_t count = 0;
  visited.world = make_town(0);
  CHECK_OK(ww_items_create(&items));
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_world_items(visited.world, context, items));
  CHECK_OK(ww_bulk_options_init(&options, sizeof options));
  options.threads = 2;
  options.jobs = &jobs;
  options.progress = use_in_progress;
  options.progress_user_data = &visited;
  CHECK_OK(ww_world_insert_points(visited.world, points, kCount, 100, &options, NULL));
  CHECK(visited.calls >= 2 && visited.snapshot == NULL);
  CHECK_OK(ww_world_remove(visited.world, 1));
  visited.calls = 0;
  CHECK_OK(ww_world_insert_all(visited.world, items, &options, NULL));
  CHECK(visited.calls >= 1);
  CHECK_OK(ww_world_item_count(visited.world, &count));
  CHECK(count == kCount + 1);
  ww_context_destroy(context);
  ww_items_destroy(items);
  ww_world_destroy(visited.world);
  free(points);
}

static void test_changing_a_read_world(void) {
  visitor visited = {NULL, NULL, NULL, 0, 0};
  ww_job_system jobs = jobs_of(use_while_searching, &visited);
  const ww_world* published = NULL;
  ww_output output = {0};
  ww_path_query queries[kQueries];
  ww_paths* paths = NULL;
  size_t i, count = 0;
  visited.world = make_town(0);
  CHECK_OK(ww_context_create(&visited.context));
  CHECK_OK(ww_paths_create(&paths));
  for (i = 0; i < kQueries; ++i) {
    CHECK_OK(ww_path_query_init(&queries[i], sizeof queries[i]));
    queries[i].start = at(10, 50);
    queries[i].goal = at(90, 50);
  }
  CHECK_OK(ww_world_find_paths(visited.world, queries, kQueries, 2, &jobs, visited.context, paths));
  CHECK(visited.calls > 0);
  CHECK_OK(ww_paths_count(paths, &count));
  CHECK(count == kQueries);

  output.struct_size = sizeof output;
  output.write = use_while_writing;
  output.user_data = &visited;
  visited.calls = 0;
  CHECK_OK(ww_world_save(visited.world, &output));
  CHECK(visited.calls > 0);

  CHECK_OK(ww_world_publish(visited.world, &visited.snapshot));
  CHECK_OK(ww_snapshot_world(visited.snapshot, &published));
  visited.calls = 0;
  output.write = release_while_writing;
  CHECK_OK(ww_world_save(published, &output));
  CHECK(visited.calls > 0);
  ww_snapshot_destroy(visited.snapshot);
  ww_paths_destroy(paths);
  ww_context_destroy(visited.context);
  ww_world_destroy(visited.world);
}

void test_callbacks(void) {
  test_wrong_job_indexes();
  test_using_a_changing_world();
  test_changing_a_read_world();
}
