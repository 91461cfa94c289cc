/* Lets each allocation of each kind of call fail in turn, through the allocator hooks. A call whose allocation fails
   must return WW_OUT_OF_MEMORY and change no world, and the same call must succeed afterwards. In the end the library
   must have freed all memory. */
#include <stdio.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "counting_allocator.h"
#include "memory_calls.h"
#include "scene.h"

static void hash_of(const State* state, ww_items_hash* items, ww_mesh_hash* mesh, uint64_t* version) {
  CHECK_OK(ww_world_items_hash(state->world, items));
  CHECK_OK(ww_world_mesh_hash(state->world, mesh));
  CHECK_OK(ww_world_version(state->world, version));
}

/* Lets allocation number `failing` of a call fail. Returns whether the call made this allocation. */
static int run_with_failure(const Case* tested, size_t failing, size_t* refused) {
  const int failed_before = failed_checks;
  State state;
  ww_items_hash items_before, items_after;
  ww_mesh_hash mesh_before, mesh_after;
  uint64_t version_before = 0, version_after = 0;
  ww_bool is_valid = 0;
  ww_status status;
  make_state(&state);
  hash_of(&state, &items_before, &mesh_before, &version_before);
  allocations = 0;
  failures = 0;
  failing_allocation = failing;
  status = tested->call(&state);
  failing_allocation = 0;
  CHECK(status == WW_OK || status == WW_OUT_OF_MEMORY);
  CHECK(status == WW_OK || failures > 0);
  if (status == WW_OUT_OF_MEMORY) {
    ++*refused;
    hash_of(&state, &items_after, &mesh_after, &version_after);
    CHECK(memcmp(&items_before, &items_after, sizeof items_before) == 0);
    CHECK(memcmp(&mesh_before, &mesh_after, sizeof mesh_before) == 0 && version_before == version_after);
    CHECK_OK(ww_world_validate(state.world, &is_valid, NULL));
    CHECK(is_valid);
    CHECK_OK(tested->call(&state));
  }
  hash_of(&state, &items_after, &mesh_after, &version_after);
  CHECK((version_before != version_after) == tested->changes_world);
  CHECK_OK(ww_world_validate(state.world, &is_valid, NULL));
  CHECK(is_valid);
  destroy_state(&state);
  if (failed_checks != failed_before) {
    fprintf(stderr, "... in %s, when allocation %lu fails\n", tested->name, (unsigned long)failing);
  }
  return failures > 0;
}

static void test_warm_queries(void) {
  State state;
  size_t i;
  make_state(&state);
  for (i = 0; i < kWarmQueryCount; ++i) {
    CHECK_OK(kWarmQueries[i](&state));
    CHECK_OK(kWarmQueries[i](&state));
    allocations = 0;
    CHECK_OK(kWarmQueries[i](&state));
    if (allocations != 0) fprintf(stderr, "warm query %lu allocates\n", (unsigned long)i);
    CHECK(allocations == 0);
  }
  destroy_state(&state);
}

/* Snapshots of a large world share pages of memory (a file "memfd:waywright"), but not if a program provides all memory
   itself. */
static void test_that_no_pages_are_shared(void) {
  enum { kSide = 250, kSnapshots = 6 };
  static ww_point points[kSide * kSide];
  ww_world* world = NULL;
  ww_snapshot* snapshots[kSnapshots] = {NULL};
  char line[512];
  FILE* maps;
  size_t i;
  for (i = 0; i < kSide * kSide; ++i) points[i] = at((double)(i % kSide) + 1, (double)(i / kSide) + 1);
  CHECK_OK(ww_world_create(box(0, 0, kSide + 1, kSide + 1), NULL, &world));
  CHECK_OK(ww_world_insert_points(world, points, kSide * kSide, 1, NULL, NULL));
  for (i = 0; i < kSnapshots; ++i) {
    CHECK_OK(ww_world_remove(world, (ww_id)i + 1));
    CHECK_OK(ww_world_publish(world, &snapshots[i]));
  }
  maps = fopen("/proc/self/maps", "r");
  while (maps != NULL && fgets(line, sizeof line, maps) != NULL) CHECK(strstr(line, "memfd:waywright") == NULL);
  if (maps != NULL) fclose(maps);
  for (i = 0; i < kSnapshots; ++i) ww_snapshot_destroy(snapshots[i]);
  ww_world_destroy(world);
}

int main(void) {
  ww_allocator allocator;
  ww_context* context = NULL;
  ww_status hooked;
  size_t i, tested = 0;
  memset(&allocator, 0, sizeof allocator);
  allocator.struct_size = sizeof allocator;
  CHECK_STATUS(ww_set_allocator(&allocator), WW_INVALID_ARGUMENT); /* without functions */
  allocator = counting_allocator();
  hooked = ww_set_allocator(&allocator);
  if (hooked == WW_NOT_SUPPORTED) {
    puts("this build has no allocator hooks: nothing tested");
    return 77;
  }
  CHECK_STATUS(hooked, WW_OK);
  CHECK_OK(ww_context_create(&context));
  CHECK(live_blocks > 0);
  CHECK_STATUS(ww_set_allocator(NULL), WW_INVALID_ARGUMENT);
  ww_context_destroy(context);
  CHECK(live_blocks == 0);
  for (i = 0; i < kCaseCount; ++i) {
    size_t refused = 0;
    for (fails_from_then_on = 0; fails_from_then_on < 2; ++fails_from_then_on) {
      size_t failing = 1;
      while (run_with_failure(&kCases[i], failing, &refused) && failed_checks == 0) ++failing, ++tested;
    }
    /* Some calls need no memory here: their context has all that they need, or they only compute. */
    if (refused == 0) printf("%s needs no memory that it cannot do without\n", kCases[i].name);
  }
  test_warm_queries();
  test_that_no_pages_are_shared();
  CHECK(remove(kFile) == 0);
  /* The error of a refused text still has its message. The function frees it. */
  CHECK_OK(ww_set_allocator(NULL));
  CHECK(live_blocks == 0);
  printf("%lu allocations failed\n", (unsigned long)tested);
  return result_of_checks();
}
