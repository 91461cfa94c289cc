#include "wasm/module.h"

#include <algorithm>
#include <malloc.h>
#include <new>
#include <string>
#include <vector>

#include "c/internal.hpp"

namespace {

std::size_t memory_limit = ~std::size_t{0};

void report_progress(std::size_t done, std::size_t total, void* user_data);

}  // namespace

extern "C" {

__attribute__((import_module("env"), import_name("question"))) std::int32_t waywright_question();
__attribute__((import_module("env"), import_name("progress"))) void waywright_progress(std::size_t done,
                                                                                       std::size_t total);
// The function of Emscripten by which the allocator makes the memory larger. The linker replaces it by the second one.
int __real_emscripten_resize_heap(std::size_t size);
int __wrap_emscripten_resize_heap(std::size_t size) {
  if (size > memory_limit) return 0;
  // One eighth more than wanted, or else exactly what is wanted.
  const std::size_t generous = size + std::min(memory_limit - size, size / 8);
  return __real_emscripten_resize_heap(generous) != 0 || __real_emscripten_resize_heap(size) != 0 ? 1 : 0;
}
}

namespace {

void report_progress(std::size_t done, std::size_t total, void* /*user_data*/) { waywright_progress(done, total); }

ww_status ask_question(const ww_world* /*changed*/, void* /*user_data*/) { return waywright_question(); }

/// Appends bytes to a ww_text.
ww_bool append(const void* bytes, std::size_t size, void* text) {
  try {
    waywright::c::object(static_cast<ww_text*>(text)).append(static_cast<const char*>(bytes), size);
    return 1;
  } catch (...) {
    return 0;
  }
}

}  // namespace

void ww_js_set_memory_limit(size_t bytes) { memory_limit = bytes; }

size_t ww_js_memory_in_use(void) { return static_cast<size_t>(mallinfo().uordblks); }

void ww_js_report_progress(ww_bulk_options* options) { options->progress = report_progress; }

ww_status ww_js_world_attempt(ww_world* world, const ww_change* changes, size_t change_count) {
  return ww_world_attempt(world, changes, change_count, ask_question, nullptr);
}

ww_status ww_js_replay_run(ww_replay* replay, const ww_script* log, ww_bool has_progress) {
  return ww_replay_run(replay, log, has_progress != 0 ? report_progress : nullptr, nullptr);
}

ww_status ww_js_replay_writer_create(const ww_world* world, uint64_t ticks_per_hash, ww_text* log,
                                     ww_replay_writer** writer) {
  const ww_output output{sizeof(ww_output), append, nullptr, log};
  return ww_replay_writer_create(&output, world, ticks_per_hash, writer);
}

ww_status ww_js_text_clear(ww_text* text) {
  return waywright::c::guarded([&] {
    waywright::c::object(text).clear();
    return WW_OK;
  });
}

ww_status ww_js_find_paths(const ww_world* world, const ww_path_query* query, const ww_point* ends, size_t query_count,
                           ww_context* context, ww_paths* paths) {
  std::vector<ww_path_query> queries;
  try {
    queries.assign(query_count, *query);
  } catch (...) {
    return WW_OUT_OF_MEMORY;
  }
  for (std::size_t i = 0; i < query_count; ++i) {
    queries[i].start = ends[2 * i];
    queries[i].goal = ends[2 * i + 1];
  }
  return ww_world_find_paths(world, queries.data(), query_count, 1, nullptr, context, paths);
}

ww_status ww_js_paths_info(const ww_paths* paths, uint8_t* statuses, double* lengths) {
  std::size_t count = 0;
  ww_status status = ww_paths_count(paths, &count);
  ww_path_info info{};
  info.struct_size = sizeof info;
  for (std::size_t i = 0; i < count && status == WW_OK; ++i) {
    const ww_path* path = nullptr;
    status = ww_paths_get(paths, i, &path);
    if (status == WW_OK) status = ww_path_get_info(path, &info);
    if (statuses != nullptr) statuses[i] = static_cast<uint8_t>(info.status);
    if (lengths != nullptr) lengths[i] = info.length;
  }
  return status;
}

ww_status ww_js_paths_points(const ww_paths* paths, uint32_t* offsets, ww_point* points, size_t capacity,
                             size_t* count) {
  std::size_t path_count = 0;
  ww_status status = ww_paths_count(paths, &path_count);
  std::size_t done = 0;
  bool fits = true;
  for (std::size_t i = 0; i < path_count && status == WW_OK; ++i) {
    const ww_path* path = nullptr;
    std::size_t points_of_path = 0;
    offsets[i] = static_cast<uint32_t>(done);
    status = ww_paths_get(paths, i, &path);
    if (status != WW_OK) break;
    const std::size_t room = done < capacity ? capacity - done : 0;
    status = ww_path_points(path, room > 0 ? points + done : nullptr, room, &points_of_path);
    if (status == WW_BUFFER_TOO_SMALL) status = WW_OK;
    fits = fits && points_of_path <= room;
    done += points_of_path;
  }
  if (status != WW_OK) return status;
  offsets[path_count] = static_cast<uint32_t>(done);
  *count = done;
  return fits ? WW_OK : WW_BUFFER_TOO_SMALL;
}

ww_status ww_js_paths_advance(const ww_path* const* paths, size_t path_count, ww_path_position* positions, double step,
                              double* states) {
  for (std::size_t i = 0; i < path_count; ++i) {
    ww_path_position& position = positions[i];
    if (paths[i] != nullptr) {
      const ww_status status = ww_path_advance(paths[i], step, WW_FLOAT64, &position);
      if (status != WW_OK) return status;
    }
    const double values[] = {position.at.x, position.at.y, position.heading.x, position.heading.y};
    std::copy(std::begin(values), std::end(values), states + 4 * i);
  }
  return WW_OK;
}
