/* Tests saving, loading and replaying. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

/* A file in memory. */
typedef struct Memory {
  char bytes[4096];
  size_t size;
  size_t limit; /* how many bytes there is room for */
  size_t position;
  size_t largest_read; /* the most bytes that one call provides */
  int flushes;
  int is_broken;
} Memory;

static ww_bool write_to_memory(const void* bytes, size_t size, void* user_data) {
  Memory* const memory = user_data;
  CHECK(size > 0);
  if (size > memory->limit - memory->size) return 0;
  memcpy(memory->bytes + memory->size, bytes, size);
  memory->size += size;
  return 1;
}

static ww_bool flush_memory(void* user_data) {
  Memory* const memory = user_data;
  ++memory->flushes;
  return memory->is_broken ? 0 : 2; /* every number except 0 is true */
}

static size_t read_from_memory(void* buffer, size_t size, void* user_data) {
  Memory* const memory = user_data;
  size_t count = memory->size - memory->position;
  CHECK(size > 0);
  if (memory->is_broken) return SIZE_MAX;
  if (count > size) count = size;
  if (count > memory->largest_read) count = memory->largest_read;
  memcpy(buffer, memory->bytes + memory->position, count);
  memory->position += count;
  return count;
}

static ww_output output_to(Memory* memory) {
  ww_output output;
  memset(memory, 0, sizeof *memory);
  memory->limit = sizeof memory->bytes;
  memset(&output, 0, sizeof output);
  output.struct_size = sizeof output;
  output.write = write_to_memory;
  output.flush = flush_memory;
  output.user_data = memory;
  return output;
}

static ww_input input_from(Memory* memory) {
  ww_input input;
  memory->position = 0;
  memory->largest_read = 3;
  memset(&input, 0, sizeof input);
  input.struct_size = sizeof input;
  input.read = read_from_memory;
  input.user_data = memory;
  return input;
}

static ww_world* make_rich_town(void) {
  static const ww_point rings[] = {{70, 70}, {90, 70}, {90, 90}, {70, 90}, {75, 75}, {85, 75}, {85, 85}};
  static const size_t ring_sizes[] = {4, 3};
  ww_world* world = make_town(1);
  ww_shape shape;
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_POLYGON;
  shape.fill = WW_FILL_NONZERO;
  shape.points = rings;
  shape.point_count = 7;
  shape.ring_sizes = ring_sizes;
  shape.ring_count = 2;
  CHECK_OK(ww_world_insert(world, &shape, 30, NULL));
  CHECK_OK(ww_world_insert_segment(world, at(0.1, 0.2), at(30, 77), 5, NULL));
  CHECK_OK(ww_world_insert_polyline(world, rings, 3, 0, NULL));
  CHECK_OK(ww_world_insert_point(world, at(1, 2), 0, NULL));
  CHECK_OK(ww_world_reserve_ids(world, 500));
  return world;
}

static int are_equal(const ww_world* a, const ww_world* b) {
  ww_mesh_hash of_a, of_b;
  ww_world_options options = {0};
  ww_id id = 0;
  options.struct_size = sizeof options;
  CHECK_OK(ww_world_mesh_hash(a, &of_a));
  CHECK_OK(ww_world_mesh_hash(b, &of_b));
  CHECK_OK(ww_world_get_options(b, &options));
  CHECK(options.keep_bridges == 1 && options.keep_abstraction == 1);
  CHECK_OK(ww_world_largest_id_seen(b, &id));
  CHECK(id == 500);
  return memcmp(&of_a, &of_b, sizeof of_a) == 0;
}

static void test_bytes(const ww_world* world, const Memory* saved) {
  ww_world* loaded = NULL;
  ww_text* bytes = NULL;
  ww_scene* scene = NULL;
  ww_scene_info info = {0};
  ww_error error = {0};
  const char* data = NULL;
  char* altered = NULL;
  ww_bool is_saved = 0;
  size_t size = 0, count = 0;
  info.struct_size = sizeof info;
  error.struct_size = sizeof error;
  CHECK_OK(ww_text_create(&bytes));
  CHECK_OK(ww_scene_create(&scene));
  CHECK_OK(ww_world_save_bytes(world, bytes));
  CHECK_OK(ww_text_bytes(bytes, &data, &size));
  CHECK_OK(ww_text_read(bytes, NULL, 0, &count));
  CHECK(count == size + 1 && data[size] == '\0');
  CHECK(size == saved->size && memcmp(data, saved->bytes, size) == 0);
  CHECK_OK(ww_is_saved_world(data, size, &is_saved));
  CHECK(is_saved == 1);
  CHECK_OK(ww_is_saved_world("waywright 1\n", 12, &is_saved));
  CHECK(is_saved == 0);
  CHECK_OK(ww_world_load_bytes(data, size, NULL, &loaded));
  CHECK(are_equal(world, loaded));
  ww_world_destroy(loaded);
  CHECK_OK(ww_scene_parse_saved_world(data, size, "a.wwb", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.item_count == 5 && is_at(info.domain.max, 100, 100));

  loaded = NULL;
  altered = malloc(size + 1);
  memcpy(altered, data, size + 1);
  CHECK_STATUS(ww_world_load_bytes(altered, size + 1, NULL, &loaded), WW_MALFORMED);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.index == size);
  CHECK_STATUS(ww_world_load_bytes(altered, size - 1, NULL, &loaded), WW_MALFORMED);
  CHECK_STATUS(ww_world_load_bytes(NULL, 0, NULL, &loaded), WW_MALFORMED);
  CHECK_STATUS(ww_world_load_bytes(NULL, 1, NULL, &loaded), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_scene_parse_saved_world(altered, 20, "a.wwb", scene), WW_MALFORMED);
  altered[size / 2] ^= 1;
  CHECK_STATUS(ww_world_load_bytes(altered, size, NULL, &loaded), WW_MALFORMED);
  CHECK(loaded == NULL);
  free(altered);
  ww_scene_destroy(scene);
  ww_text_destroy(bytes);
}

static size_t progress_calls = 0;
static void count_progress(size_t done, size_t total, void* user_data) {
  CHECK(user_data == &progress_calls && done <= total);
  ++progress_calls;
}

static void test_input(const ww_world* world, Memory* saved) {
  ww_input input = input_from(saved);
  ww_bulk_options options;
  ww_world* loaded = NULL;
  CHECK_OK(ww_bulk_options_init(&options, sizeof options));
  options.progress = count_progress;
  options.progress_user_data = &progress_calls;
  saved->size += 5; /* the library leaves what follows the world */
  CHECK_OK(ww_world_load(&input, &options, &loaded));
  CHECK(are_equal(world, loaded) && progress_calls > 0 && saved->position == saved->size - 5);
  ww_world_destroy(loaded);
  loaded = NULL;
  CHECK_STATUS(ww_world_load(&input, NULL, &loaded), WW_MALFORMED); /* only 5 bytes */
  saved->size -= 5;
  saved->position = 0;
  saved->is_broken = 1;
  CHECK_STATUS(ww_world_load(&input, NULL, &loaded), WW_UNREADABLE);
  saved->is_broken = 0;
  CHECK_STATUS(ww_world_load(&input, NULL, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_load(NULL, NULL, &loaded), WW_INVALID_ARGUMENT);
  input.read = NULL;
  CHECK_STATUS(ww_world_load(&input, NULL, &loaded), WW_INVALID_ARGUMENT);
  CHECK(loaded == NULL);
}

static void test_files(const ww_world* world) {
  static const char name[] = "waywright_c_test.wwb"; /* in the folder of the build */
  ww_world* loaded = NULL;
  ww_scene* scene = NULL;
  ww_scene_format format = -1;
  CHECK_OK(ww_scene_create(&scene));
  CHECK_OK(ww_scene_format_of(name, &format));
  CHECK(format == WW_SCENE_SAVED_WORLD);
  CHECK_OK(ww_world_save_file(world, name));
  CHECK_OK(ww_world_load_file(name, NULL, &loaded));
  CHECK(are_equal(world, loaded));
  CHECK_OK(ww_scene_read(name, scene));
  CHECK(remove(name) == 0);
  ww_world_destroy(loaded);
  loaded = NULL;
  CHECK_STATUS(ww_world_load_file(name, NULL, &loaded), WW_UNREADABLE);
  CHECK_STATUS(ww_world_save_file(world, "/no/such/folder/a.wwb"), WW_UNWRITABLE);
  CHECK_STATUS(ww_world_save_file(world, NULL), WW_INVALID_ARGUMENT);
  CHECK(loaded == NULL);
  ww_scene_destroy(scene);
}

void test_saving(void) {
  static Memory memory;
  ww_world* world = make_rich_town();
  ww_output output = output_to(&memory);
  CHECK_OK(ww_world_save(world, &output));
  CHECK(memory.flushes == 1);
  test_bytes(world, &memory);
  test_input(world, &memory);
  test_files(world);
  output = output_to(&memory);
  memory.limit = 50;
  CHECK_STATUS(ww_world_save(world, &output), WW_UNWRITABLE);
  output = output_to(&memory);
  memory.is_broken = 1;
  CHECK_STATUS(ww_world_save(world, &output), WW_UNWRITABLE);
  output = output_to(&memory);
  output.flush = NULL;
  CHECK_OK(ww_world_save(world, &output));
  output.write = NULL;
  CHECK_STATUS(ww_world_save(world, &output), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_save(world, NULL), WW_INVALID_ARGUMENT);
  CHECK_STATUS(ww_world_save(NULL, &output), WW_INVALID_ARGUMENT);
  ww_world_destroy(world);
}

/* Plays three ticks in a town and writes their log. */
static void write_log(Memory* memory) {
  static const ww_point wall[] = {{1, 1}, {9, 2}};
  ww_world* world = make_town(0);
  ww_output output = output_to(memory);
  ww_replay_writer* writer = NULL;
  ww_shape shape;
  ww_change changes[2];
  ww_id ids[2];
  uint64_t tick = 9;
  CHECK_OK(ww_shape_init(&shape, sizeof shape));
  shape.kind = WW_ITEM_SEGMENT;
  shape.points = wall;
  shape.point_count = 2;
  memset(changes, 0, sizeof changes);
  changes[0].shape = &shape;
  changes[1].kind = WW_CHANGE_REMOVE;
  changes[1].id = 1;
  CHECK_STATUS(ww_replay_writer_create(&output, world, 0, &writer), WW_INVALID_ARGUMENT);
  CHECK(memory->size == 0 && writer == NULL);
  CHECK_OK(ww_replay_writer_create(&output, world, 2, &writer));
  CHECK_OK(ww_replay_writer_last_tick(writer, &tick));
  CHECK(tick == 0);
  CHECK_OK(ww_world_apply(world, changes, 2, ids));
  CHECK_STATUS(ww_replay_writer_record(writer, changes, 2, NULL), WW_BAD_ID); /* the id of the insertion is 0 */
  CHECK_OK(ww_replay_writer_record(writer, changes, 2, ids));
  CHECK_OK(ww_replay_writer_tick(writer, world));
  CHECK(memory->flushes == 0);
  CHECK_OK(ww_replay_writer_tick(writer, world));
  CHECK(memory->flushes == 1);
  CHECK_OK(ww_world_insert_point(world, at(3, 3), 8, NULL));
  changes[0].id = 8;
  shape.kind = WW_ITEM_POINT;
  shape.point_count = 1;
  CHECK_OK(ww_replay_writer_record(writer, changes, 1, NULL)); /* not what has happened: the world has (3, 3) */
  CHECK_OK(ww_replay_writer_tick(writer, world));
  CHECK_OK(ww_replay_writer_tick(writer, world));
  CHECK_OK(ww_replay_writer_last_tick(writer, &tick));
  CHECK(tick == 4);
  memory->limit = memory->size + 3;
  CHECK_STATUS(ww_replay_writer_tick(writer, world), WW_UNWRITABLE);
  ww_replay_writer_destroy(writer);
  writer = NULL;
  CHECK_STATUS(ww_replay_writer_create(&output, world, 1, &writer), WW_UNWRITABLE);
  CHECK(writer == NULL);
  ww_world_destroy(world);
}

static void test_differences(const char* log) {
  static const char other_log[] =
      "waywright 1\ndomain 0 0 9 9\npoint 1 2 2\ntick 1\npoint 2 3 3\ntick 2\npoint 3 4 4\n";
  static const char refused_log[] = "waywright 1\ndomain 0 0 9 9\npoint 1 2 2\npoint 1 3 3\ntick 1\n";
  static const char short_log[] = "waywright 1\ndomain 0 0 9 9\npoint 1 2 2\ntick 1\nremove 1\ntick 2\n";
  ww_script* script = NULL;
  ww_script* other = NULL;
  ww_replay* replay = NULL;
  ww_replay_result result = {0};
  ww_replay_difference difference = {0};
  ww_error error = {0};
  char message[100];
  ww_id ids[4];
  size_t count = 0;
  result.struct_size = sizeof result;
  difference.struct_size = sizeof difference;
  error.struct_size = sizeof error;
  CHECK_OK(ww_script_create(&script));
  CHECK_OK(ww_script_create(&other));
  CHECK_OK(ww_replay_create(&replay));
  CHECK_OK(ww_script_parse(refused_log, sizeof refused_log - 1, "log", script));
  CHECK_OK(ww_replay_run(replay, script, NULL, NULL));
  CHECK_OK(ww_replay_get_result(replay, &result));
  CHECK(result.is_same == 0 && result.is_refused == 1 && result.line == 4 && result.tick == 1);
  CHECK_OK(ww_replay_changed(replay, ids, 4, &count));
  CHECK(count == 1 && ids[0] == 1);
  CHECK_OK(ww_replay_refusal(replay, &error, message, sizeof message, &count));
  CHECK(error.status == WW_ID_IN_USE && error.item == 1 && strlen(message) + 1 == count && count > 1);

  CHECK_OK(ww_script_parse(other_log, sizeof other_log - 1, "log", script));
  CHECK_OK(ww_script_parse(short_log, sizeof short_log - 1, "log", other));
  CHECK_OK(ww_find_difference(script, other, &difference, ids, 4, &count));
  CHECK(difference.is_different == 1 && difference.kind == WW_DIFFERENCE_CHANGE && difference.tick == 2);
  CHECK(difference.line == 5 && difference.other_line == 5 && difference.item == 2 && difference.other_item == 1);
  CHECK(count == 0 && difference.struct_size == sizeof difference);
  CHECK_OK(ww_find_difference(script, script, &difference, ids, 4, &count));
  CHECK(difference.is_different == 0);
  CHECK_OK(ww_script_parse(log, strlen(log), "log", other));
  CHECK_OK(ww_find_difference(script, other, &difference, NULL, 0, NULL));
  CHECK(difference.kind == WW_DIFFERENCE_DOMAIN && difference.line == 2);
  ww_replay_destroy(replay);
  ww_script_destroy(other);
  ww_script_destroy(script);
}

static size_t lines_reported = 0;
static void count_lines(size_t done, size_t total, void* user_data) {
  CHECK(user_data == &lines_reported && done <= total);
  ++lines_reported;
}

void test_replaying(void) {
  static Memory memory;
  ww_script* script = NULL;
  ww_replay* replay = NULL;
  ww_replay_result result = {0};
  ww_script_line line = {0};
  ww_error error = {0};
  ww_id ids[4];
  char text[4];
  size_t count = 0;
  result.struct_size = sizeof result;
  line.struct_size = sizeof line;
  error.struct_size = sizeof error;
  write_log(&memory);
  memory.bytes[memory.size] = '\0';
  CHECK_OK(ww_script_create(&script));
  CHECK_OK(ww_replay_create(&replay));
  CHECK_OK(ww_script_parse(memory.bytes, memory.size, "log", script));
  CHECK_OK(ww_script_get_line(script, 4, &line)); /* after the house, the segment, the removal and the first tick */
  CHECK(line.kind == WW_SCRIPT_TICK && line.tick == 2 && line.has_items_hash == 1 && strcmp(line.word, "tick") == 0);
  CHECK_OK(ww_replay_run(replay, script, count_lines, &lines_reported));
  CHECK_OK(ww_replay_get_result(replay, &result));
  CHECK(result.is_same == 0 && result.is_refused == 0 && result.ticks == 4 && result.tick == 4 &&
        result.last_same == 2);
  CHECK(lines_reported > 0 && memcmp(&result.expected, &result.computed, sizeof result.expected) != 0);
  CHECK_OK(ww_replay_changed(replay, ids, 4, &count));
  CHECK(count == 1 && ids[0] == 8);
  CHECK_OK(ww_replay_refusal(replay, &error, text, sizeof text, &count));
  CHECK(error.status == WW_OK && count == 1 && text[0] == '\0');
  *strstr(memory.bytes, "tick 3") = '\0'; /* only the first two ticks, whose hashes are right, and a change */
  CHECK_OK(ww_script_parse(memory.bytes, strlen(memory.bytes), "log", script));
  CHECK_OK(ww_replay_run(replay, script, NULL, NULL));
  CHECK_OK(ww_replay_get_result(replay, &result));
  CHECK(result.is_same == 1 && result.ticks == 2);
  test_differences(memory.bytes);
  ww_replay_destroy(replay);
  ww_script_destroy(script);
}
