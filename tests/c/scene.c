#include "scene.h"

#include <math.h>
#include <stddef.h>

#include "check.h"

ww_point at(double x, double y) {
  ww_point point;
  point.x = x;
  point.y = y;
  return point;
}

ww_box box(double x0, double y0, double x1, double y1) {
  ww_box result;
  result.min = at(x0, y0);
  result.max = at(x1, y1);
  return result;
}

int is_at(ww_point point, double x, double y) { return point.x == x && point.y == y; }
int is_near(double a, double b) { return fabs(a - b) <= 1e-9 * (1 + fabs(b)); }

ww_world* make_town(ww_bool keep_bridges) {
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
