/* The functions that the WebAssembly module has besides those of waywright.h: the memory of the module, and calls that
   do the work of many. Rules, errors and names are those of waywright.h. */
#ifndef WAYWRIGHT_MODULE_H
#define WAYWRIGHT_MODULE_H

#include "c/waywright.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the largest size of the memory of the module, in bytes. An allocation beyond it fails. */
WW_API void ww_js_set_memory_limit(size_t bytes);
/* Returns how many bytes the library and the wrapper have allocated. Cost: linear in the number of allocations. */
WW_API size_t ww_js_memory_in_use(void);

/* Makes bulk options report their progress to the import `progress` of the module. */
WW_API void ww_js_report_progress(ww_bulk_options* options);

/* Like ww_world_attempt, with the import `question` of the module as the question. */
WW_API ww_status ww_js_world_attempt(ww_world* world, const ww_change* changes, size_t change_count);

/* Like ww_replay_run, with the import `progress` of the module if `has_progress` is set. */
WW_API ww_status ww_js_replay_run(ww_replay* replay, const ww_script* log, ww_bool has_progress);
/* Like ww_replay_writer_create. The writer appends to `log`, which must exist as long as the writer. */
WW_API ww_status ww_js_replay_writer_create(const ww_world* world, uint64_t ticks_per_hash, ww_text* log,
                                            ww_replay_writer** writer);
/* Removes the characters of a text. */
WW_API ww_status ww_js_text_clear(ww_text* text);

/* Finds a path for each pair of ends: start and goal, one after the other. The other members are those of `query`. */
WW_API ww_status ww_js_find_paths(const ww_world* world, const ww_path_query* query, const ww_point* ends,
                                  size_t query_count, ww_context* context, ww_paths* paths);
/* Writes the status and the length of each path of a list. The arrays have room for all paths; they may be null. */
WW_API ww_status ww_js_paths_info(const ww_paths* paths, uint8_t* statuses, double* lengths);
/* Writes the points of all paths, one after the other: those of path i are the elements offsets[i] to offsets[i + 1]
   - 1. `offsets` has room for one element more than there are paths. */
WW_API ww_status ww_js_paths_points(const ww_paths* paths, uint32_t* offsets, ww_point* points, size_t capacity,
                                    size_t* count);
/* Moves a position on each of `path_count` paths by `step`. Null paths stay where they are. For each position, writes
   x, y and the heading x, y to `states`. */
WW_API ww_status ww_js_paths_advance(const ww_path* const* paths, size_t path_count, ww_path_position* positions,
                                     double step, double* states);

#ifdef __cplusplus
}
#endif

#endif
