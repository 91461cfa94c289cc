/* The objects of a test of memory, and the data for their calls. */
#ifndef WAYWRIGHT_TESTS_C_MEMORY_STATE_H
#define WAYWRIGHT_TESTS_C_MEMORY_STATE_H

#include <stddef.h>
#include <waywright.h>

/* Everything that a call may use. */
typedef struct State {
  ww_world* world;
  ww_context* context;
  ww_items* items;
  ww_path* path;
  ww_path* other_path;
  ww_paths* paths;
  ww_search* search;
  ww_mesh* mesh;
  ww_text* text;
  ww_scene* scene;
  ww_script* script;
  ww_scenario* scenario;
  ww_svg_overlay* overlay;
  ww_path_watch* watch;
  ww_replay_writer* writer;
  ww_replay* replay;
  ww_text* saved;   /* the bytes of the world */
  ww_world* made;   /* by the call */
  ww_context* more; /* by the call */
} State;

/* Makes all objects of a state, except those that a call makes. */
void make_state(State* state);
/* Destroys all objects of a state. */
void destroy_state(State* state);

/* The corners of bar(). */
extern const ww_point kBar[4];
/* A polygon that the world of a state can insert. */
ww_shape bar(void);
/* A query that the world of a state can answer. */
ww_path_query query_of(double radius);
/* The number of bytes that counter() has taken. */
extern size_t log_size;
/* An output that only counts the bytes. */
ww_output counter(void);

#endif
