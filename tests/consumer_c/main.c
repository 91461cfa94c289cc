#include <stdio.h>
#include <string.h>
#include <waywright.h>

/* The path leads up and around the wall's upper end: (1, 0), (2, 2), (3, 0). */
static int finds_path(void) {
  const ww_box domain = {{0, 0}, {4, 3}};
  const ww_point below = {2, 0}, above = {2, 2};
  ww_world* world = NULL;
  ww_context* context = NULL;
  ww_path* path = NULL;
  ww_path_query query;
  size_t count = 0;
  if (ww_world_create(domain, NULL, &world) != WW_OK || ww_context_create(&context) != WW_OK) return 0;
  if (ww_path_create(&path) != WW_OK || ww_path_query_init(&query, sizeof query) != WW_OK) return 0;
  query.start.x = 1;
  query.goal.x = 3;
  if (ww_world_insert_segment(world, below, above, 0, NULL) != WW_OK) return 0;
  if (ww_world_find_path(world, &query, context, path) != WW_OK) return 0;
  if (ww_path_points(path, NULL, 0, &count) != WW_OK) return 0;
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
  return count == 3;
}

/* Returns 0 only if the build found the header and the library. */
int main(void) {
  if (!finds_path()) puts("no way around the wall");
  return finds_path() && ww_version_number() == WW_VERSION_NUMBER && strlen(ww_version()) >= 5 ? 0 : 1;
}
