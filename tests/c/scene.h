/* Points, boxes and a small world for the tests. */
#ifndef WAYWRIGHT_TESTS_C_SCENE_H
#define WAYWRIGHT_TESTS_C_SCENE_H

#include <waywright.h>

ww_point at(double x, double y);
ww_box box(double x0, double y0, double x1, double y1);
int is_at(ww_point point, double x, double y);
/* Whether two numbers are equal up to rounding errors. */
int is_near(double a, double b);

/* A world over (0, 0) to (100, 100), with the square house (40, 40) to (60, 60) under the id 1. */
ww_world* make_town(ww_bool keep_bridges);

#endif
