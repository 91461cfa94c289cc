/* The code in docs/c.md, after the quick start. snippets_test.py compares both. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

static ww_bool write_to_stream(const void* bytes, size_t size, void* user_data) {
  return fwrite(bytes, 1, size, user_data) == size;
}

static ww_bool flush_stream(void* user_data) { return fflush(user_data) == 0; }

static ww_status save_to_stream(const ww_world* world, FILE* stream) {
  ww_output output = {.struct_size = sizeof output};
  output.write = write_to_stream;
  output.flush = flush_stream;
  output.user_data = stream;
  return ww_world_save(world, &output);
}

static size_t read_from_stream(void* buffer, size_t size, void* user_data) {
  const size_t count = fread(buffer, 1, size, user_data);
  return count == 0 && ferror((FILE*)user_data) ? SIZE_MAX : count;
}

static ww_status load_from_stream(FILE* stream, ww_world** world) {
  ww_input input = {.struct_size = sizeof input};
  input.read = read_from_stream;
  input.user_data = stream;
  return ww_world_load(&input, NULL, world);
}

typedef struct question {
  ww_path_query query;
  ww_context* context;
  ww_path* path; /* the answer */
} question;

static ww_status find_path_then(const ww_world* changed, void* user_data) {
  question* asked = user_data;
  return ww_world_find_path(changed, &asked->query, asked->context, asked->path);
}

static ww_status find_path_without(ww_world* world, ww_id obstacle, question* asked) {
  const ww_change change = {.kind = WW_CHANGE_REMOVE, .id = obstacle};
  return ww_world_attempt(world, &change, 1, find_path_then, asked);
}

static void test_streams(const ww_world* world) {
  ww_world* loaded = NULL;
  ww_items_hash before, after;
  FILE* const stream = tmpfile();
  CHECK(stream != NULL);
  if (stream == NULL) return;
  CHECK_OK(save_to_stream(world, stream));
  rewind(stream);
  CHECK_OK(load_from_stream(stream, &loaded));
  CHECK_OK(ww_world_items_hash(world, &before));
  CHECK_OK(ww_world_items_hash(loaded, &after));
  CHECK(memcmp(&before, &after, sizeof before) == 0);
  ww_world_destroy(loaded);
  fclose(stream);
}

static void test_points(const ww_path* path) {
  size_t count = 0;
  ww_path_points(path, NULL, 0, &count); /* asks for the count only */
  ww_point* points = malloc(count * sizeof *points);
  ww_path_points(path, points, count, &count); /* reads */
  CHECK(count == 2 && is_at(points[0], 10, 55) && is_at(points[1], 90, 55));
  free(points);
}

void test_snippets(void) {
  ww_world* world = make_town(0);
  question asked;
  CHECK_OK(ww_context_create(&asked.context));
  CHECK_OK(ww_path_create(&asked.path));
  CHECK_OK(ww_path_query_init(&asked.query, sizeof asked.query));
  asked.query.start = at(10, 55);
  asked.query.goal = at(90, 55);
  CHECK_OK(find_path_without(world, 1, &asked));
  test_points(asked.path); /* straight, because the question asks about the world without the house */
  test_streams(world);
  ww_path_destroy(asked.path);
  ww_context_destroy(asked.context);
  ww_world_destroy(world);
}
