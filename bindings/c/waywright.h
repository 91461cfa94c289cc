/* Waywright for C: a dynamic, exact constrained Delaunay triangulation, and paths through it.

   docs/c.md introduces this interface, and docs/languages.md lists the C++ function behind each function here. The C++
   headers in include/waywright describe each operation in full, with its cost and its source.

   Rules for all functions:
   - Lengths, radii and coordinates are doubles in one unit, which you choose. Angles are in radians, counter-clockwise
     from the x axis.
   - Every function that can fail returns a ww_status: WW_OK, or the reason why the call did nothing. If a call fails,
     ww_last_error() and ww_last_error_message() say more. No exception leaves the library.
   - Every function can return WW_OUT_OF_MEMORY, WW_INVALID_ARGUMENT and WW_INTERNAL_ERROR, and every function with a
     list or a text can return WW_BUFFER_TOO_SMALL. The comments name the other errors of each function.
   - After an error, answers (structs, lists, and objects that the call writes) have no meaning. A world, and the
     paths of a path watch, are as before the call.
   - The functions ww_..._create make an object, which belongs to you until you pass it to ww_..._destroy. The functions
     ww_..._destroy accept null. You may destroy objects in any order.
   - The library copies what it needs. After a call, you may free or change your arrays, structs and texts. If a
     function gives you a pointer, its comment says how long the pointer is valid.
   - Structs that can grow in later versions begin with struct_size. For a struct with options, call its function
     ww_..._init. For a struct with an answer, set struct_size to its size yourself:
         ww_location location = {.struct_size = sizeof location};
   - A list has three parameters: a buffer, its capacity, and count. The function writes as many elements as the buffer
     holds, and sets *count to the number of all elements. If the buffer is too small, the status is
     WW_BUFFER_TOO_SMALL: the answer is then complete except for the missing elements. A null buffer with capacity 0 is
     never too small, so you can ask for the count first. `count` may be null.
   - A text is a list of characters that ends with a zero byte. The capacity and the count include the zero byte. A
     buffer that is too small also ends with a zero byte. Texts are UTF-8. File names are as fopen() takes them.
   - Your functions that the library calls get the user_data that you gave with them. The library calls them on the
     thread that called it, except the functions of an allocator. They must return: they must not call longjmp, nor
     throw an exception. They must not use the objects of the call that runs them, except where the comment allows it.
     If your function breaks this rule for the world of the running call, the function of the library that it calls does
     nothing and returns WW_INVALID_ARGUMENT. ww_world_destroy and ww_snapshot_destroy return no status: they do
     nothing, too, and ww_last_error() gives the error.
   - Threads: several threads may read one object at once. While a thread changes an object, no other thread may use it.
     A function whose parameter is `const ww_world*` reads the world. Only one call at a time may use a context: make
     one for each thread. The library has no other shared data, except the allocator. */
#ifndef WAYWRIGHT_H
#define WAYWRIGHT_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(WAYWRIGHT_C_BUILDING)
#define WW_API __declspec(dllexport)
#elif defined(_WIN32)
#define WW_API __declspec(dllimport)
#elif defined(__GNUC__)
#define WW_API __attribute__((visibility("default")))
#else
#define WW_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header: 1.2.3 is 10203. */
#define WW_VERSION_MAJOR 0
#define WW_VERSION_MINOR 1
#define WW_VERSION_PATCH 0
#define WW_VERSION_NUMBER (WW_VERSION_MAJOR * 10000 + WW_VERSION_MINOR * 100 + WW_VERSION_PATCH)

/* ---------------------------------------------------------------------------------------------------------------------
   Values */

/* 0 or 1. As an argument, every number except 0 counts as 1. */
typedef int32_t ww_bool;

/* The id of an item: 1 to 2^63 - 1. 0 is null. In a list of the items on a wall, 0 is the border of the domain. */
typedef uint64_t ww_id;

/* A world takes every coordinate in its range exactly as it is. */
typedef struct ww_point {
  double x;
  double y;
} ww_point;

/* A closed box with sides parallel to the axes. */
typedef struct ww_box {
  ww_point min;
  ww_point max;
} ww_box;

/* What moves: a point, or a disc with a radius. */
typedef struct ww_agent {
  double radius; /* of the disc, 0 or more; with the radius 0 the agent is a point */
} ww_agent;

/* The range of coordinates: 2^100 and 2^-100. */
#define WW_LARGEST_COORDINATE 1267650600228229401496703205376.0
#define WW_SMALLEST_COORDINATE 7.8886090522101180541172856528278622967e-31

/* Returns whether a world accepts a coordinate: 0, or a magnitude from WW_SMALLEST_COORDINATE to
   WW_LARGEST_COORDINATE. */
WW_API ww_bool ww_is_in_range(double coordinate);

typedef int32_t ww_status;
/* The statuses above 0 are the values of waywright::ErrorCode. The statuses below 0 exist only in C. A later version
   may add statuses. */
enum {
  WW_OK = 0,
  WW_COORDINATE_RANGE = 1,   /* a coordinate that is not finite, beyond +-2^100, or nearer to 0 than 2^-100 but not 0 */
  WW_OUT_OF_DOMAIN = 2,      /* a point outside the world's domain */
  WW_ID_IN_USE = 3,          /* a live item has this id already */
  WW_UNKNOWN_ID = 4,         /* no live item has this id */
  WW_BAD_RADIUS = 5,         /* a radius that is negative or not finite */
  WW_BAD_DISTANCE = 6,       /* a distance that is negative, not a number, or too small */
  WW_BAD_ID = 7,             /* an id above 2^63 - 1; ww_world_reserve_ids and replay logs refuse the id 0, too */
  WW_BAD_DOMAIN = 8,         /* a domain without min.x < max.x and min.y < max.y, or a box with min beyond max */
  WW_BAD_SHAPE = 9,          /* a number of rings or points that the kind of the item does not allow, for example 0 */
  WW_TOO_LARGE = 10,         /* more than 2^27 vertices, not counting new crossings, or more than 350 million in all */
  WW_TOO_MANY_VERTICES = 11, /* an operation that would make more vertices than the new_vertex_limit of the world */
  WW_WORLD_GONE = 12,        /* the world of a search no longer exists */
  WW_NOT_SUPPORTED = 13,     /* a request that this version, this build or this world does not support */
  WW_NO_BRIDGES = 14,        /* a query that needs bridges, of a world that does not keep them */
  WW_NO_HISTORY = 15,        /* a mark, a rewind or a snapshot of a tick, of a world without history */
  WW_OLD_TICK = 16,          /* a tick that the history of a world contained, but no longer contains */
  WW_UNKNOWN_TICK = 17,      /* a tick that ww_world_mark has not returned, or that a rewind has dropped */
  WW_UNREADABLE = 18,        /* a file or an input that cannot be opened or read */
  WW_MALFORMED = 19,         /* text or bytes that do not follow their format */
  WW_UNWRITABLE = 20,        /* a file or an output that cannot be written */

  WW_OUT_OF_MEMORY = -1,    /* there is not enough memory; no world has changed */
  WW_INVALID_ARGUMENT = -2, /* a broken rule of this interface: a null pointer, a wrong size, an unknown kind */
  WW_BUFFER_TOO_SMALL = -3, /* a list does not fit in the caller's buffer */
  WW_INTERNAL_ERROR = -4    /* a bug in the library; destroy the objects that the call used */
};

/* Returns the name of a status: "out-of-domain". Returns "unknown" for a number that is no status. The text that a
   function ww_..._name returns is never null, and is valid as long as the library is loaded. */
WW_API const char* ww_status_name(ww_status status);

/* Returns the version of the library as text: "0.1.0". The text is valid as long as the library is loaded. */
WW_API const char* ww_version(void);
/* Returns the version of the library as a number like WW_VERSION_NUMBER. */
WW_API int32_t ww_version_number(void);

/* The error of the last call on this thread that did not return WW_OK. Later successful calls do not change it. */
typedef struct ww_error {
  uint32_t struct_size;
  ww_status status; /* WW_OK if no call has failed yet */
  ww_id item;       /* the id that caused the error, or 0 */
  uint64_t index;   /* the index of the refused element in its list (from 0), or a line number (from 1) */
} ww_error;

/* Gives the last error of this thread. A call of ww_last_error or ww_last_error_message does not change this error. */
WW_API ww_status ww_last_error(ww_error* error);
/* Writes the last error in words, in English: "the goal, (7, 12), lies outside the domain, (0, 0) to (10, 10)". The
   text is empty if no call has failed yet. */
WW_API ww_status ww_last_error_message(char* buffer, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Memory of the library */

/* The functions from which the library takes its memory. The library calls them on any thread, on several at once. */
typedef struct ww_allocator {
  uint32_t struct_size;
  /* Returns `size` bytes (1 or more) at a multiple of `alignment`, or null. */
  void* (*allocate)(size_t size, size_t alignment, void* user_data);
  /* Frees memory that allocate() has returned for the same alignment. The library never passes null. */
  void (*deallocate)(void* memory, size_t alignment, void* user_data);
  void* user_data;
} ww_allocator;

/* Sets the allocator of the whole process. Null restores malloc and free. Call it before you make the first object, or
   after you have destroyed all objects: as long as the library holds memory, the status is WW_INVALID_ARGUMENT.
   Errors: WW_NOT_SUPPORTED, if the library was built without allocator hooks (docs/c.md says when).
   Threads: no other thread may use the library during this call. */
WW_API ww_status ww_set_allocator(const ww_allocator* allocator);

/* ---------------------------------------------------------------------------------------------------------------------
   Objects */

typedef struct ww_world ww_world;                 /* obstacles, and their mesh */
typedef struct ww_context ww_context;             /* the memory that queries keep between calls; one for each thread */
typedef struct ww_items ww_items;                 /* a list of items: ids and shapes */
typedef struct ww_path ww_path;                   /* the answer to a path query */
typedef struct ww_paths ww_paths;                 /* the answers to several path queries */
typedef struct ww_search ww_search;               /* a path search in slices */
typedef struct ww_path_watch ww_path_watch;       /* watches the paths of many agents while a world changes */
typedef struct ww_snapshot ww_snapshot;           /* an immutable world for readers on other threads */
typedef struct ww_mesh ww_mesh;                   /* a copy of the mesh of a world */
typedef struct ww_text ww_text;                   /* text or bytes that the library has written */
typedef struct ww_scene ww_scene;                 /* a domain and items, as a file gives them */
typedef struct ww_script ww_script;               /* the lines of a world script */
typedef struct ww_scenario ww_scenario;           /* the queries of a scenario of Moving AI */
typedef struct ww_replay_writer ww_replay_writer; /* writes a replay log */
typedef struct ww_replay ww_replay;               /* the answer of a replay */
typedef struct ww_svg_overlay ww_svg_overlay;     /* what a picture shows besides the world */

/* These functions make empty objects. Use one object for many answers: it keeps its memory, so that later calls need
   not allocate. (The functions that make the other objects are with their groups below.) */
WW_API ww_status ww_context_create(ww_context** context);
WW_API void ww_context_destroy(ww_context* context);
WW_API ww_status ww_items_create(ww_items** items);
WW_API void ww_items_destroy(ww_items* items);
WW_API ww_status ww_path_create(ww_path** path);
WW_API void ww_path_destroy(ww_path* path);
WW_API ww_status ww_paths_create(ww_paths** paths);
WW_API void ww_paths_destroy(ww_paths* paths);
WW_API ww_status ww_search_create(ww_search** search);
WW_API void ww_search_destroy(ww_search* search);
WW_API ww_status ww_mesh_create(ww_mesh** mesh);
WW_API void ww_mesh_destroy(ww_mesh* mesh);
WW_API ww_status ww_text_create(ww_text** text);
WW_API void ww_text_destroy(ww_text* text);
WW_API ww_status ww_scene_create(ww_scene** scene);
WW_API void ww_scene_destroy(ww_scene* scene);
WW_API ww_status ww_script_create(ww_script** script);
WW_API void ww_script_destroy(ww_script* script);
WW_API ww_status ww_scenario_create(ww_scenario** scenario);
WW_API void ww_scenario_destroy(ww_scenario* scenario);
WW_API ww_status ww_replay_create(ww_replay** replay);
WW_API void ww_replay_destroy(ww_replay* replay);
WW_API ww_status ww_svg_overlay_create(ww_svg_overlay** overlay);
WW_API void ww_svg_overlay_destroy(ww_svg_overlay* overlay);

/* Writes a text to a buffer. The text may contain further zero bytes before the zero byte at its end. */
WW_API ww_status ww_text_read(const ww_text* text, char* buffer, size_t capacity, size_t* count);
/* Sets *bytes to the bytes of the text and *size to their number, without the zero byte that follows them. The bytes
   belong to the text, and are valid until it changes or is destroyed. */
WW_API ww_status ww_text_bytes(const ww_text* text, const char** bytes, size_t* size);

/* ---------------------------------------------------------------------------------------------------------------------
   Shapes and items */

typedef int32_t ww_item_kind;
enum {
  WW_ITEM_POINT = 0,    /* a vertex, no wall */
  WW_ITEM_SEGMENT = 1,  /* a straight line; a segment of length 0 acts as a point */
  WW_ITEM_POLYLINE = 2, /* an open polyline; its straight pieces are walls */
  WW_ITEM_POLYGON = 3   /* a solid obstacle of one or more closed rings */
};
/* Returns the name of a kind in world scripts: "polyline". */
WW_API const char* ww_item_kind_name(ww_item_kind kind);

/* Which positions lie inside a polygon. The winding number of a position says how often the rings go around it
   counter-clockwise, minus how often they go around it clockwise. */
typedef int32_t ww_fill_rule;
enum {
  WW_FILL_EVEN_ODD = 0, /* inside if the winding number is odd: a ring in a ring bounds a hole */
  WW_FILL_NONZERO = 1   /* inside if the winding number is not 0: an inner ring in the opposite direction is a hole */
};
/* Returns the name of a fill rule: "even-odd". */
WW_API const char* ww_fill_rule_name(ww_fill_rule rule);

/* The form of an item. A point has 1 point, a segment has 2, a polyline has 1 or more; these have one ring. A
   polygon has one or more rings. The side from the last point of a ring to its first point belongs to the ring, so you
   need not repeat the first point. The shape refers to points of yours, which must exist during each call with the
   shape. */
typedef struct ww_shape {
  uint32_t struct_size;
  ww_item_kind kind;
  ww_fill_rule fill;      /* for a polygon */
  const ww_point* points; /* the points of all rings, ring after ring */
  size_t point_count;
  /* The number of points of each ring; their sum is point_count. Null stands for one ring of all points. */
  const size_t* ring_sizes;
  size_t ring_count; /* has no meaning if ring_sizes is null */
} ww_shape;

/* Sets all members to 0 and null: the kind WW_ITEM_POINT, and one ring without points. */
WW_API ww_status ww_shape_init(ww_shape* shape, size_t struct_size);

/* Writes the corners of a rectangle, counter-clockwise from its lower left corner. */
WW_API ww_status ww_rectangle(ww_box box, ww_point* points, size_t capacity, size_t* count);
/* Writes the corners of a regular polygon, counter-clockwise from the corner to the right of the centre. Each corner is
   rounded to doubles. The result is the same on every machine. A polygon has 3 corners or more: for fewer, the function
   writes none, and a world refuses a polygon without corners (WW_BAD_SHAPE). */
WW_API ww_status ww_regular_polygon(ww_point centre, double radius, size_t corner_count, ww_point* points,
                                    size_t capacity, size_t* count);
/* Writes the points of a shape, moved by (dx, dy) and rounded to doubles. The rings keep their sizes. `points` may be
   the array of the shape. */
WW_API ww_status ww_translated(const ww_shape* shape, double dx, double dy, ww_point* points, size_t capacity,
                               size_t* count);
/* Computes the centroid of a shape with one point or more, in plain doubles: for a polygon the centroid of the area
   inside, otherwise the mean of the points. If rings cross, the result is an approximation. */
WW_API ww_status ww_centroid(const ww_shape* shape, ww_point* centroid);
/* Computes the smallest box that contains the points, one or more. */
WW_API ww_status ww_bounding_box(const ww_point* points, size_t point_count, ww_box* box);

/* Facts about an item of a list. */
typedef struct ww_item_info {
  uint32_t struct_size;
  ww_item_kind kind;
  ww_fill_rule fill;
  ww_id id;
  size_t point_count;
  size_t ring_count;
} ww_item_info;

/* Removes all items from a list. */
WW_API ww_status ww_items_clear(ww_items* items);
/* Appends a copy of a shape. If id is 0, a world that inserts the item chooses the id. */
WW_API ww_status ww_items_add(ww_items* items, ww_id id, const ww_shape* shape);
/* Gives the number of items of a list. */
WW_API ww_status ww_items_count(const ww_items* items, size_t* count);
/* Gives facts about an item. The items of a list have the indices 0 to count - 1. */
WW_API ww_status ww_items_get_info(const ww_items* items, size_t index, ww_item_info* info);
/* Writes the points of an item, ring after ring. */
WW_API ww_status ww_items_points(const ww_items* items, size_t index, ww_point* points, size_t capacity, size_t* count);
/* Writes the number of points of each ring of an item. */
WW_API ww_status ww_items_ring_sizes(const ww_items* items, size_t index, size_t* ring_sizes, size_t capacity,
                                     size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Making a world */

/* The options of a world. */
typedef struct ww_world_options {
  uint32_t struct_size;
  ww_bool keep_abstraction; /* whether the world maintains the path abstraction: see docs/paths.md */
  ww_bool keep_bridges;     /* whether the world can answer path queries for discs */
  size_t new_vertex_limit;  /* the largest number of vertices that one operation may make; no limit by default */
} ww_world_options;

/* Sets all options to their defaults. `struct_size` is sizeof(ww_world_options). */
WW_API ww_status ww_world_options_init(ww_world_options* options, size_t struct_size);
/* Makes an empty world over a closed box. `options` may be null: then all options have their defaults.
   Errors: WW_COORDINATE_RANGE, WW_BAD_DOMAIN. */
WW_API ww_status ww_world_create(ww_box domain, const ww_world_options* options, ww_world** world);
WW_API void ww_world_destroy(ww_world* world);
/* Makes an independent copy of a world: with the same domain, options, items, mesh, hashes, version and history. It
   chooses the same ids for later items. Searches and path watches of the world do not belong to the copy. */
WW_API ww_status ww_world_clone(const ww_world* world, ww_world** clone);
/* Gives the domain of the world. */
WW_API ww_status ww_world_domain(const ww_world* world, ww_box* domain);
/* Gives the options with which the world was made, and its present new_vertex_limit. */
WW_API ww_status ww_world_get_options(const ww_world* world, ww_world_options* options);

/* ---------------------------------------------------------------------------------------------------------------------
   Changing items. Each call is one operation: the world carries it out completely or changes nothing.
   If `id` is 0, the world chooses the id: the largest id that it has seen, plus 1. `inserted` receives the id, and may
   be null. No arrangement of items is an error: items may cross, overlap, repeat each other or have length 0. Errors of
   insertions: WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN, WW_ID_IN_USE, WW_BAD_ID, WW_BAD_SHAPE, WW_TOO_LARGE,
   WW_TOO_MANY_VERTICES. ww_error.index is the index of the refused point in the shape. */

/* Inserts a shape of any kind. */
WW_API ww_status ww_world_insert(ww_world* world, const ww_shape* shape, ww_id id, ww_id* inserted);
/* Inserts a point: a vertex that stays as long as the item is live. It is not a wall. */
WW_API ww_status ww_world_insert_point(ww_world* world, ww_point point, ww_id id, ww_id* inserted);
/* Inserts a segment from `a` to `b`. */
WW_API ww_status ww_world_insert_segment(ww_world* world, ww_point a, ww_point b, ww_id id, ww_id* inserted);
/* Inserts an open polyline through one or more points. Its straight pieces are walls. */
WW_API ww_status ww_world_insert_polyline(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                          ww_id* inserted);
/* Inserts a solid obstacle of one ring, with the fill rule WW_FILL_EVEN_ODD. The side from the last point to the first
   belongs to the ring. For several rings or another fill rule, use ww_world_insert. */
WW_API ww_status ww_world_insert_polygon(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                         ww_id* inserted);
/* Removes an item. Errors: WW_UNKNOWN_ID, WW_BAD_ID. */
WW_API ww_status ww_world_remove(ww_world* world, ww_id id);
/* Gives an item another shape, for example to move it. The item keeps its id. Errors: WW_UNKNOWN_ID, and the errors of
   insertions. */
WW_API ww_status ww_world_replace(ww_world* world, ww_id id, const ww_shape* shape);

/* ---------------------------------------------------------------------------------------------------------------------
   Changing many items at once */

/* A job of the library. The library divides its work into parts with the indices 0, 1, 2, ... The call job(job_data, i)
   does the part with the index i. It does not fail. */
typedef void (*ww_job)(void* job_data, size_t index);

/* The threads of your program. Without a job system, the library starts threads itself. */
typedef struct ww_job_system {
  uint32_t struct_size;
  /* Calls job(job_data, i) once for each i below `count`, on any threads, in any order, and returns when all these
     calls have returned. No job waits for another one. run() may omit calls: the library then makes them itself. As
     soon as run() has returned, your program must not call job() any more, on any thread. If run() calls job() with
     another index, this call does nothing, and the function of the library returns WW_INVALID_ARGUMENT. The library
     calls run() on the thread that called the library. */
  void (*run)(size_t count, ww_job job, void* job_data, void* user_data);
  void* user_data;
} ww_job_system;

typedef struct ww_bulk_options {
  uint32_t struct_size;
  /* Null, or a function that the library calls on the calling thread from time to time, and at the end with done ==
     total. Only the ratio of the two numbers has a meaning. The function must not use the world. */
  void (*progress)(size_t done, size_t total, void* user_data);
  void* progress_user_data;
  size_t threads;            /* 1 by default; including the calling thread; a number above 256 counts as 256 */
  const ww_job_system* jobs; /* null by default: the library starts threads itself */
} ww_bulk_options;

/* Sets all options to their defaults. `struct_size` is sizeof(ww_bulk_options). */
WW_API ww_status ww_bulk_options_init(ww_bulk_options* options, size_t struct_size);

/* Inserts all items of a list as one operation. This is much faster than one call for each item. `options` may be null.
   `ids` is null, or an array with room for one id for each item. The world is the same for any number of threads.
   Errors: the errors of insertions. ww_error.index is the index of the refused item. */
WW_API ww_status ww_world_insert_all(ww_world* world, const ww_items* items, const ww_bulk_options* options,
                                     ww_id* ids);
/* Inserts many points as one operation. The first has the id `first`, or an id that the world chooses if `first` is 0,
   and each further one the next id. `first_id` receives the id of the first point, and may be null. `options` may be
   null. Errors: the errors of insertions. ww_error.index is the index of the refused point. */
WW_API ww_status ww_world_insert_points(ww_world* world, const ww_point* points, size_t point_count, ww_id first,
                                        const ww_bulk_options* options, ww_id* first_id);

typedef int32_t ww_change_kind;
enum { WW_CHANGE_INSERT = 0, WW_CHANGE_REMOVE = 1, WW_CHANGE_REPLACE = 2 };

/* A change of one item. This struct does not grow. */
typedef struct ww_change {
  ww_change_kind kind;
  ww_id id;              /* of an insertion: 0 lets the world choose */
  const ww_shape* shape; /* for an insertion or a replacement */
} ww_change;

/* Makes several changes, one after the other, as one operation. `ids` is null, or an array with room for one id for
   each change, which receives the id of its item.
   Errors: the errors of insertions, and WW_UNKNOWN_ID. ww_error.index is the index of the refused change. */
WW_API ww_status ww_world_apply(ww_world* world, const ww_change* changes, size_t change_count, ww_id* ids);

/* ---------------------------------------------------------------------------------------------------------------------
   Going back and trying out */

/* Makes the world keep its last `ticks` ticks from now on. If the history has more ticks, the world drops the oldest.
   With 0, the world drops its history and keeps none. A world keeps no history by default. */
WW_API ww_status ww_world_keep_history(ww_world* world, size_t ticks);
/* Names the current state of the world. `tick` receives its number, and may be null: 1 for the first call, and one more
   for each further call. After a rewind, the numbers continue from the tick to which the world went back.
   Errors: WW_NO_HISTORY. */
WW_API ww_status ww_world_mark(ww_world* world, uint64_t* tick);
/* Brings back the state of the world at a tick, as one operation: its items, next id, mesh and hashes. The later ticks
   then no longer exist. Only the version differs: it grows by one.
   Errors: WW_NO_HISTORY; WW_OLD_TICK, if the history no longer has the tick; WW_UNKNOWN_TICK, if no mark has this tick.
   ww_error.index is the tick. */
WW_API ww_status ww_world_rewind(ww_world* world, uint64_t tick);

/* A question about a changed world. `changed` is the world of the call ww_world_attempt. The question may call all
   functions that take a `const ww_world*`, except ww_world_clone, ww_search_begin, ww_path_watch_create,
   ww_path_watch_update, ww_replay_writer_create and ww_replay_writer_tick. For this world, these six functions and all
   functions that take a `ww_world*` return WW_INVALID_ARGUMENT. So does ww_search_step for a search in this world. The
   question must not destroy this world. */
typedef ww_status (*ww_question)(const ww_world* changed, void* user_data);
/* Makes changes, asks a question about the changed world, and takes the changes back. Afterwards the world is as
   before, bit for bit; only its spare memory may be larger. The question writes its answer to user_data. The function
   returns the status that the question returned, but does not store it as the last error. So if the question has chosen
   this status itself, ww_last_error() still gives the error of an earlier call. The function asks no question if the
   world refuses a change.
   Errors: the errors of ww_world_apply, and the errors that the question returns.
   Threads: the whole call, with the question, is a change of the world. */
WW_API ww_status ww_world_attempt(ww_world* world, const ww_change* changes, size_t change_count, ww_question question,
                                  void* user_data);
/* Finds out whether changes would enclose an agent. The answer is 1 in two cases: the agent can move from one of the
   points to another now, but not after the changes; or one of the points is not blocked now, but is blocked after the
   changes. Points that are blocked or not connected now do not matter. The function makes no change. The decision is
   exact. ww_world_find_path may move a blocked point to a free position, but this function takes each point as it is.
   Errors: the errors of ww_world_apply; WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN, WW_BAD_RADIUS; WW_NOT_SUPPORTED, if the
   radius is 0 and the world does not keep its abstraction; WW_NO_BRIDGES, if the radius is above 0 and the world does
   not keep its bridges. ww_error.index is the index of the refused point or change.
   Threads: the call is a change of the world. */
WW_API ww_status ww_world_would_disconnect(ww_world* world, const ww_change* changes, size_t change_count,
                                           const ww_point* points, size_t point_count, const ww_agent* agent,
                                           ww_bool* would_disconnect);

/* ---------------------------------------------------------------------------------------------------------------------
   Limiting operations, for programs that take shapes from people whom they do not know: two polylines of n points can
   have n^2 crossings. */

/* Sets the largest number of vertices that one operation may make: those at new corners and at new crossings, of all
   items of the operation together. If an operation would make more vertices, it changes nothing and returns
   WW_TOO_MANY_VERTICES. SIZE_MAX stands for no limit. ww_error.item is the item at which the operation passed the
   limit. */
WW_API ww_status ww_world_set_new_vertex_limit(ww_world* world, size_t limit);
/* Gives the largest number of vertices that one operation may make. */
WW_API ww_status ww_world_new_vertex_limit(const ww_world* world, size_t* limit);

/* ---------------------------------------------------------------------------------------------------------------------
   Reading items */

/* Gives the largest id that the world has seen, or 0 if it has seen none: the largest id of all items that it has ever
   contained, or the id given to ww_world_reserve_ids. If the world chooses an id, it is this id plus 1. */
WW_API ww_status ww_world_largest_id_seen(const ww_world* world, ww_id* id);
/* Lets the world continue its ids after `last`, as if it had seen this id. Does nothing if the world has seen a larger
   id. The call is not an operation: it does not change the version. Errors: WW_BAD_ID. */
WW_API ww_status ww_world_reserve_ids(ww_world* world, ww_id last);
/* Finds out whether a live item has this id. */
WW_API ww_status ww_world_contains(const ww_world* world, ww_id id, ww_bool* contains);
/* Gives the number of live items. */
WW_API ww_status ww_world_item_count(const ww_world* world, size_t* item_count);
/* Writes the ids of all live items, ascending. */
WW_API ww_status ww_world_item_ids(const ww_world* world, ww_id* ids, size_t capacity, size_t* count);
/* Sets `items` to a copy of the item with this id. Its shape is as you inserted it, with two exceptions. Of equal
   consecutive points (in a polygon, also of the last and the first point of a ring), the copy has only one. (A segment
   always has two points.) And the fill rule of an item that is not a polygon is WW_FILL_EVEN_ODD. Errors:
   WW_UNKNOWN_ID, WW_BAD_ID. */
WW_API ww_status ww_world_item(const ww_world* world, ww_id id, ww_items* items);
/* Sets `items` to copies of all live items, ascending by id. */
WW_API ww_status ww_world_items(const ww_world* world, ww_context* context, ww_items* items);

/* ---------------------------------------------------------------------------------------------------------------------
   Locating and asking. Errors, unless a comment names others: WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN. */

typedef int32_t ww_location_kind;
enum { WW_LOCATION_VERTEX = 0, WW_LOCATION_EDGE = 1, WW_LOCATION_FACE = 2 };
/* Returns the name of a kind of location: "vertex", "edge", "face". */
WW_API const char* ww_location_kind_name(ww_location_kind kind);

typedef struct ww_location {
  uint32_t struct_size;
  ww_location_kind kind;
  size_t vertex_count;
  ww_point vertices[3]; /* 1, 2 or 3 vertices, rounded to nearest; the vertices of a face are counter-clockwise */
} ww_location;

/* Finds the vertex, edge or face at a point. The list is the polygons that contain the point in their interior or on
   their boundary, ascending. */
WW_API ww_status ww_world_locate(const ww_world* world, ww_point point, ww_context* context, ww_location* location,
                                 ww_id* polygons, size_t capacity, size_t* count);
/* Finds the items that contain a point: polygons that cover it, and items with a side or corner there; ascending. */
WW_API ww_status ww_world_items_at(const ww_world* world, ww_point point, ww_context* context, ww_id* items,
                                   size_t capacity, size_t* count);

/* An item that a segment meets. */
typedef struct ww_crossed_item {
  ww_id id;    /* the id of the item */
  ww_point at; /* where the segment meets a side of the item, or where their overlap starts; rounded to nearest */
} ww_crossed_item;

/* Finds the items whose sides a segment meets, and the positions where it meets them, in the order from `from` to `to`.
   An item occurs once for each position where the segment meets its sides. Items at one position ascend. The border of
   the domain is not listed. */
WW_API ww_status ww_world_items_crossed(const ww_world* world, ww_point from, ww_point to, ww_context* context,
                                        ww_crossed_item* items, size_t capacity, size_t* count);
/* Finds the items that have a position in common with a closed box, ascending. The box may reach beyond the domain.
   Errors: WW_COORDINATE_RANGE; WW_BAD_DOMAIN, if min is beyond max. */
WW_API ww_status ww_world_items_in(const ww_world* world, ww_box box, ww_context* context, ww_id* items,
                                   size_t capacity, size_t* count);

/* The first wall that an agent touches. */
typedef struct ww_ray_hit {
  uint32_t struct_size;
  ww_bool hit;      /* whether the agent touches a wall; if not, the points have no meaning */
  ww_point at;      /* where the agent is when it first touches a wall, rounded */
  ww_point contact; /* the position on the touched walls that is nearest to `at`; for a point agent, it equals `at` */
} ww_ray_hit;

/* Finds the first wall that an agent touches while it moves straight from `from` to `to`: the segment of a point, or a
   moving disc. A disc touches a wall that is not farther from its centre than the radius. If it touches a wall before
   it moves, the hit is at the start. The border of the domain is a wall, too. The decision is exact. The list is the
   items that the agent touches at the hit, ascending; 0 is the border. Further errors: WW_BAD_RADIUS. */
WW_API ww_status ww_world_ray(const ww_world* world, ww_point from, ww_point to, const ww_agent* agent,
                              ww_context* context, ww_ray_hit* hit, ww_id* items, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Discs. A disc may touch walls. Like paths, discs ignore items of the kind WW_ITEM_POINT. All decisions are exact.
   Errors: WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN; with an agent also WW_BAD_RADIUS. */

/* Finds out whether a disc fits at a position: the centre does not lie strictly inside a polygon, and no wall is nearer
   to it than the radius. The list is the items that stop it, ascending; 0 is the border of the domain. */
WW_API ww_status ww_world_fit_disc(const ww_world* world, ww_point centre, const ww_agent* agent, ww_context* context,
                                   ww_bool* fits, ww_id* items, size_t capacity, size_t* count);

/* A query for the nearest point at which a disc fits. */
typedef struct ww_nearest_fit_query {
  uint32_t struct_size;
  ww_point point;   /* the answer is the point nearest to this one */
  ww_agent agent;   /* what must fit there; a point by default */
  ww_bool has_goal; /* whether `goal` is set */
  ww_point goal;    /* if it is set, the answer is a position from which the disc can move to this point */
  double limit;     /* the largest distance of the answer from `point`; infinity by default */
} ww_nearest_fit_query;

/* The nearest point at which a disc fits and, if the query has a goal, from which it can move to the goal. */
typedef struct ww_nearest_fit {
  uint32_t struct_size;
  ww_bool is_found; /* whether there is an answer within the limit; if not, the other members are 0 */
  ww_point at;      /* the point; that the disc fits there is an exact decision */
  double distance;  /* the distance from the point of the query to `at` */
} ww_nearest_fit;

/* Sets all members to their defaults. `struct_size` is sizeof(ww_nearest_fit_query). */
WW_API ww_status ww_nearest_fit_query_init(ww_nearest_fit_query* query, size_t struct_size);
/* Finds, among all points where a disc fits, the nearest one to query->point. The C++ header clearance.hpp says how
   precise the distance is. Of several equally near points that the search finds, the first in (x, y) order is the
   answer. (If query->point lies at a vertex, all positions of an arc around this vertex are equally near. The search
   finds one of them, and rounding errors decide which one it is.)
   ww_error.index is 0 for the point and 1 for the goal. Further errors: WW_BAD_DISTANCE, if the limit is negative or
   not a number; with a goal, WW_NO_BRIDGES if the radius is above 0 and the world does not keep its bridges, and
   WW_NOT_SUPPORTED if the radius is 0 and the world does not keep its abstraction. */
WW_API ww_status ww_world_nearest_fit(const ww_world* world, const ww_nearest_fit_query* query, ww_context* context,
                                      ww_nearest_fit* fit);

/* The largest disc that can move from a start to a goal, and the gap that stops every larger disc. */
typedef struct ww_widest_path {
  uint32_t struct_size;
  ww_bool is_connected; /* whether a disc with a radius above 0 can move to the goal; if not, all others are 0 */
  ww_bool is_limited;   /* whether a gap between the ends limits the disc */
  double radius;        /* the largest radius of a disc that passes all gaps; infinity if no gap limits it */
  ww_point from;        /* where the narrowest gap starts: the corner of an item, or of the domain */
  ww_point to;          /* where this gap ends, rounded */
} ww_widest_path;

/* Finds the largest disc that can move from start to goal, and the gap that stops every larger disc. The answer does
   not say whether the disc fits at the start and at the goal: ww_world_fit_disc says this. The radius of `agent` does
   not matter. The lists are the items with
   a side at the two ends of the gap, ascending; 0 is the border of the domain. Further errors: WW_NO_BRIDGES. */
WW_API ww_status ww_world_widest_path(const ww_world* world, ww_point start, ww_point goal, const ww_agent* agent,
                                      ww_context* context, ww_widest_path* widest, ww_id* from_items,
                                      size_t from_capacity, size_t* from_count, ww_id* to_items, size_t to_capacity,
                                      size_t* to_count);

/* A bridge: the straight connection between two walls at the gap between them. A disc that passes between the walls
   crosses the bridge. */
typedef struct ww_bridge {
  ww_point from;       /* the corner of an item, or of the domain, at which it starts */
  ww_point to;         /* where it ends: at another corner, or at a foot, rounded */
  double radius;       /* the largest radius of a disc that passes */
  ww_bool has_foot;    /* whether it ends at a foot: strictly inside a wall, which it meets at a right angle */
  uint32_t first_id;   /* the index in `ids` of its first id */
  uint32_t from_count; /* the number of items with a side at `from`; their ids come first, ascending */
  uint32_t to_count;   /* the number of items with a side at `to`; their ids come next, ascending */
} ww_bridge;

/* Lists the bridges that have a position in common with a closed box, sorted by `from`, then by `to`. The box may reach
   beyond the domain. The list does not contain the bridges in the interior of polygons. In `ids`, 0 is the border of
   the domain. Errors: WW_COORDINATE_RANGE; WW_BAD_DOMAIN, if min is beyond max; WW_NO_BRIDGES. */
WW_API ww_status ww_world_bridges(const ww_world* world, ww_box box, ww_context* context, ww_bridge* bridges,
                                  size_t capacity, size_t* count, ww_id* ids, size_t id_capacity, size_t* id_count);

/* ---------------------------------------------------------------------------------------------------------------------
   Paths */

/* docs/paths.md says when to choose which algorithm. */
typedef int32_t ww_path_algorithm;
enum {
  WW_ALGORITHM_TA = 0,     /* a first path quickly, and a better one within a budget */
  WW_ALGORITHM_TRA = 1,    /* a good path in very little time; needs the abstraction if the radius is 0 */
  WW_ALGORITHM_OPTIMAL = 2 /* the shortest path */
};
/* Returns the name of an algorithm: "ta", "tra", "optimal". */
WW_API const char* ww_path_algorithm_name(ww_path_algorithm algorithm);
/* Sets *algorithm to the algorithm with this name. Errors: WW_INVALID_ARGUMENT, if there is none. */
WW_API ww_status ww_path_algorithm_by_name(const char* name, ww_path_algorithm* algorithm);

/* A query for a path from a start to a goal. */
typedef struct ww_path_query {
  uint32_t struct_size;
  /* where the path starts */
  ww_point start;
  /* where the path ends */
  ww_point goal;
  /* what moves; a point by default; for a disc, the world must keep its bridges */
  ww_agent agent;
  /* `optimal` by default, for the shortest path; the others take less time and may find longer paths */
  ww_path_algorithm algorithm;
  /* whether `end_tolerance` is set */
  ww_bool has_end_tolerance;
  /* how far the search may move a blocked end; the default allows for rounding errors; 0: not at all */
  double end_tolerance;
  /* for `ta`: the number of triangles that the search may enter; with 0, the default, the first path is the answer */
  uint64_t budget_expansions;
  /* for `ta`: the time since the start of the search; no limit by default */
  int64_t budget_nanoseconds;
  /* whether the answer has the edges that a point agent crosses */
  ww_bool wants_channel;
  /* whether the answer has the time of the search */
  ww_bool wants_time;
} ww_path_query;

/* Sets all members to their defaults. `struct_size` is sizeof(ww_path_query). */
WW_API ww_status ww_path_query_init(ww_path_query* query, size_t struct_size);
/* Finds a path, or finds out that there is none. Both are answers, not errors: ww_path_get_info says which of the two.
   The path may touch walls and vertices, but it never passes through a wall. At a vertex with walls, it never passes
   from one wedge between walls into another. The search may move a blocked start or goal to a free position within the
   tolerance. Errors: WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN,
   WW_BAD_RADIUS; WW_BAD_DISTANCE, for the tolerance; WW_NOT_SUPPORTED, if the radius is 0, the algorithm is TRA and the
   world does not keep its abstraction; WW_NO_BRIDGES, if the radius is above 0 and the world does not keep its
   bridges. */
WW_API ww_status ww_world_find_path(const ww_world* world, const ww_path_query* query, ww_context* context,
                                    ww_path* path);
/* Finds a path for each query, in their order, on `threads` threads, 1 or more; a number above 256 counts as 256.
   `queries` is an array whose elements all have the struct_size of the first one. `jobs` may be null: the library then
   starts threads. Errors: the errors of ww_world_find_path. ww_error.index is the index of the refused query. */
WW_API ww_status ww_world_find_paths(const ww_world* world, const ww_path_query* queries, size_t query_count,
                                     size_t threads, const ww_job_system* jobs, ww_context* context, ww_paths* paths);

/* A query for the shortest paths from one start to many goals. */
typedef struct ww_many_goals_query {
  uint32_t struct_size;
  ww_point start;            /* where the paths start */
  const ww_point* goals;     /* where the paths end; the points must exist during the call */
  size_t goal_count;         /* the number of goals */
  ww_agent agent;            /* what moves; a point by default */
  ww_bool wants_points;      /* whether the answers have points or pieces, besides status and length */
  ww_bool has_end_tolerance; /* whether `end_tolerance` is set */
  double end_tolerance;      /* how far the search may move a blocked end, as in a path query */
} ww_many_goals_query;

/* Sets all members to their defaults. `struct_size` is sizeof(ww_many_goals_query). */
WW_API ww_status ww_many_goals_query_init(ww_many_goals_query* query, size_t struct_size);
/* Finds the shortest path to each goal, in the order of the goals. For many goals, this is faster than one query for
   each. Errors: the errors of ww_world_find_path. ww_error.index is 0 for the start, and i + 1 for goals[i]. */
WW_API ww_status ww_world_find_paths_from(const ww_world* world, const ww_many_goals_query* query, ww_context* context,
                                          ww_paths* paths);
/* Gives the end_tolerance of queries without has_end_tolerance: the largest magnitude of a coordinate of the domain,
   times 2^-20. It allows for the rounding errors of positions that are kept as float. */
WW_API ww_status ww_world_default_end_tolerance(const ww_world* world, double* tolerance);

WW_API ww_status ww_paths_count(const ww_paths* paths, size_t* count);
/* Sets *path to a path of the list. It belongs to the list, and is valid until the list changes or is destroyed. */
WW_API ww_status ww_paths_get(const ww_paths* paths, size_t index, const ww_path** path);
/* Sets `to` to a copy of a path, for example of one that belongs to a list or a search. */
WW_API ww_status ww_path_copy(const ww_path* path, ww_path* to);

typedef int32_t ww_path_status;
enum {
  WW_PATH_FOUND = 0,
  WW_PATH_START_BLOCKED = 1, /* the start lies strictly inside a polygon, or a wall is nearer than the radius */
  WW_PATH_GOAL_BLOCKED = 2,  /* the goal lies strictly inside a polygon, or a wall is nearer than the radius */
  WW_PATH_NO_PATH = 3        /* no path connects start and goal, for another reason than the two above */
};
/* Returns the name of a status of paths: "found", "start-blocked", "goal-blocked", "no-path". */
WW_API const char* ww_path_status_name(ww_path_status status);

/* An end that the search has moved. */
typedef struct ww_moved_end {
  ww_point from; /* the point in the query */
  ww_point to;   /* where the path starts or ends instead */
} ww_moved_end;

/* Facts about a path. */
typedef struct ww_path_info {
  uint32_t struct_size;
  /* whether there is a path; if not, why */
  ww_path_status status;
  /* the length; 0 if there is no path */
  double length;
  /* no path is shorter; equals `length` if the path is proven shortest; 0 if there is no path */
  double lower_bound;
  /* the agent of the query */
  ww_agent agent;
  /* the triangles that the search entered; for a disc, also the straight lines that it examined, and 0 if there is
     no path */
  uint64_t expansions;
  /* the time of the search; 0 unless the query has asked for the time */
  int64_t nanoseconds;
  /* the number of points */
  size_t point_count;
  /* the number of lines and arcs */
  size_t piece_count;
  /* the number of edges in the channel */
  size_t channel_count;
  /* the number of items that block an end */
  size_t blocker_count;
  /* whether `moved_start` is set */
  ww_bool has_moved_start;
  /* how the search has moved the start */
  ww_moved_end moved_start;
  /* whether `moved_goal` is set */
  ww_bool has_moved_goal;
  /* how the search has moved the goal */
  ww_moved_end moved_goal;
  /* whether the answer has a widest path */
  ww_bool has_widest;
} ww_path_info;

typedef int32_t ww_piece_kind;
enum { WW_PIECE_LINE = 0, WW_PIECE_ARC = 1 };

/* A piece of the path of a disc's centre: a line, or an arc around a centre. */
typedef struct ww_path_piece {
  ww_piece_kind kind; /* whether it is a line or an arc */
  ww_point from;      /* where it starts */
  ww_point to;        /* where it ends */
  ww_point centre;    /* of an arc: a corner of an item, or of the domain */
  double radius;      /* of an arc: the radius of the agent */
  double start_angle; /* of an arc: the angle from the centre to `from`, in radians */
  double end_angle;   /* of an arc: larger than the start angle if the arc turns left, otherwise smaller */
} ww_path_piece;

/* An edge that a path crosses, as seen from an agent on the path; rounded to nearest. */
typedef struct ww_portal {
  ww_point left;  /* the left end of the edge */
  ww_point right; /* its right end */
} ww_portal;

/* Gives facts about a path. A new ww_path is a path with the status WW_PATH_NO_PATH. */
WW_API ww_status ww_path_get_info(const ww_path* path, ww_path_info* info);
/* Writes the start, the turns and the goal: nothing if there is no path, or if the query has a radius above 0. */
WW_API ww_status ww_path_points(const ww_path* path, ww_point* points, size_t capacity, size_t* count);
/* Writes the lines and arcs of the path of a disc's centre: nothing if there is no path, or if the radius is 0. */
WW_API ww_status ww_path_pieces(const ww_path* path, ww_path_piece* pieces, size_t capacity, size_t* count);
/* Writes the edges that the path of a point agent crosses, in order, if the query has wants_channel. */
WW_API ww_status ww_path_channel(const ww_path* path, ww_portal* portals, size_t capacity, size_t* count);
/* Writes the items that block an end, ascending: nothing if no end is blocked. 0 is the border of the domain. */
WW_API ww_status ww_path_blockers(const ww_path* path, ww_id* items, size_t capacity, size_t* count);
/* Gives the largest disc that can move from start to goal, if no path for the disc of the query exists
   (WW_PATH_NO_PATH) and a smaller disc can move there. Otherwise the function sets is_connected to 0. The lists are as
   in ww_world_widest_path. */
WW_API ww_status ww_path_widest(const ww_path* path, ww_widest_path* widest, ww_id* from_items, size_t from_capacity,
                                size_t* from_count, ww_id* to_items, size_t to_capacity, size_t* to_count);

/* The type in which your program keeps coordinates: double or float. */
typedef int32_t ww_precision;
enum { WW_FLOAT64 = 0, WW_FLOAT32 = 1 };

/* A position on a path. For a point agent, the coordinates are rounded away from the walls at the turns of the path:
   you can use the position as the start of a query. For a disc, they are rounded to nearest. */
typedef struct ww_path_position {
  uint32_t struct_size;
  ww_point at;      /* the point at this position */
  ww_point heading; /* the direction of the path there, of length 1; (0, 0) on a path of length 0 */
  size_t segment;   /* the position lies between the points `segment` and `segment` + 1, or on the piece `segment` */
  double before;    /* the length of the path from its start to the start of this segment or piece */
  double distance;  /* the length of the path from its start to this position */
} ww_path_position;

/* Gives the position at a distance from the start, along the path. A distance below 0 or a NaN gives the start, a
   distance above the length gives the goal. Errors of ww_path_at, ww_path_advance and ww_path_nearest:
   WW_INVALID_ARGUMENT, if the path has no points and no pieces. */
WW_API ww_status ww_path_at(const ww_path* path, double distance, ww_precision precision, ww_path_position* position);
/* Moves a position of this path farther along the path by `step`: one step of a unit that walks. *position must come
   from one of these functions for this path. */
WW_API ww_status ww_path_advance(const ww_path* path, double step, ww_precision precision, ww_path_position* position);
/* Gives the position on the path that is nearest to a point, for example for a unit that has left its path. */
WW_API ww_status ww_path_nearest(const ww_path* path, ww_point point, ww_precision precision,
                                 ww_path_position* position);
/* Writes the path as points, for programs that cannot use arcs: for a point agent its points; for a disc so many points
   that the straight segments between them are nowhere farther than `tolerance` from the path. Writes nothing if there
   is no path. Errors: WW_BAD_DISTANCE, if the tolerance is negative, not a number, or below 2^-20 times the radius. */
WW_API ww_status ww_path_polyline(const ww_path* path, double tolerance, ww_point* points, size_t capacity,
                                  size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Searches in slices: each call of ww_search_step is one slice. Use them if a whole search takes more time than one
   frame of your program has. Between the slices you may query, change and even destroy the world. If a change touches
   the start, the goal or a triangle at which the search has looked, the search starts again.
   Threads: a search belongs to one thread at a time. ww_search_begin and ww_search_step read the world. */

/* Starts a search, and cancels the search that is running. Errors: the errors of ww_world_find_path. After an error no
   search is running. */
WW_API ww_status ww_search_begin(ww_search* search, const ww_world* world, const ww_path_query* query);
/* Continues the search until it has entered `expansions` further triangles, or a few more. For a radius above 0,
   `expansions` also counts the straight lines that the search examines, as ww_path_info.expansions does. Sets *is_done
   to 1 if the search is done, or if no search is running.
   Errors: WW_WORLD_GONE, if the world was destroyed. This error, and WW_OUT_OF_MEMORY, cancel the search. */
WW_API ww_status ww_search_step(ww_search* search, size_t expansions, ww_bool* is_done);
/* Sets *path to the answer, or to the best path so far. The status of the path is WW_PATH_NO_PATH as long as the search
   has found none. The path belongs to the search, and is valid until a call changes or destroys the search. */
WW_API ww_status ww_search_path(const ww_search* search, const ww_path** path);
/* Gives the number of times that the search has started again because of changes of the world. */
WW_API ww_status ww_search_restarts(const ww_search* search, size_t* restarts);
/* Sets whether the searches that begin from now on record their windows (ww_search_window). They record none by
   default. */
WW_API ww_status ww_search_record_windows(ww_search* search, ww_bool wanted);

/* A window: the piece of an edge of the mesh that is visible from one point, the root of the window. The root is the
   start of the path or a turn of the path. To follow a window, the search enters a triangle of this edge. The
   coordinates are rounded: use them only for pictures. */
typedef struct ww_search_window {
  ww_point root;      /* the last turn of the path, or its start */
  ww_portal edge;     /* the whole edge; left and right as seen from the root */
  ww_portal interval; /* the piece of the edge that is visible from the root */
  double length;      /* the length of the path from the start to the root */
  double bound;       /* up to rounding, no path through the window to the goal is shorter than this */
} ww_search_window;

/* Lists the windows that the search has followed since its last start, in order: one or more for each triangle that it
   has entered. The list is empty if the search does not record them; if the algorithm is not WW_ALGORITHM_OPTIMAL; if
   the radius is above 0; and if no search was necessary, for example because the straight segment from the start to
   the goal meets no wall, and no vertex between its ends. */
WW_API ww_status ww_search_windows(const ww_search* search, ww_search_window* windows, size_t capacity, size_t* count);
/* Cancels the search, if one is running. */
WW_API ww_status ww_search_cancel(ww_search* search);
/* Finds out whether a search has begun and is neither done nor cancelled. */
WW_API ww_status ww_search_is_running(const ww_search* search, ww_bool* is_running);

/* ---------------------------------------------------------------------------------------------------------------------
   Following changes */

/* Finds out whether an agent can walk along a polyline, for example along the points of a path. It may touch walls and
   walk along them. Discs are not supported yet. It must not pass through a wall or the interior of a polygon, nor at a
   vertex from one wedge between walls into another. The decision is exact. Without points, the answer is 0. Errors:
   WW_COORDINATE_RANGE, WW_OUT_OF_DOMAIN, WW_BAD_RADIUS; WW_NOT_SUPPORTED, if the radius is above 0. ww_error.index is
   the index of the refused point. */
WW_API ww_status ww_world_is_clear(const ww_world* world, const ww_point* points, size_t point_count,
                                   const ww_agent* agent, ww_context* context, ww_bool* is_clear);
/* Finds out whether an agent can walk straight from one point to another. Errors: as for ww_world_is_clear. */
WW_API ww_status ww_world_is_clear_between(const ww_world* world, ww_point from, ww_point to, const ww_agent* agent,
                                           ww_context* context, ww_bool* is_clear);
/* Finds out whether a polyline meets the bounding box of an item that an operation after version `since` has inserted
   or removed. For a disc, finds out whether it may touch such a box. If not, and if the polyline was clear at that
   version, it is still clear. The answer is 1 if the world no longer has all bounding boxes since then: it keeps at
   least the last 2,048 boxes. */
WW_API ww_status ww_world_is_affected(const ww_world* world, const ww_point* points, size_t point_count,
                                      const ww_agent* agent, uint64_t since, ww_bool* is_affected);
/* Finds out whether the operations after version `since` affect a path. For a point agent, the answer is the answer of
   ww_world_is_affected for the points of the path. The path of a disc is affected if one of the bounding boxes is so
   near that the disc may touch it. A path that was not found is never affected. A path that is not affected need not be
   the shortest one any more. */
WW_API ww_status ww_world_is_path_affected(const ww_world* world, const ww_path* path, uint64_t since,
                                           ww_bool* is_affected);
/* Writes the indices of the affected paths, ascending. */
WW_API ww_status ww_world_find_affected(const ww_world* world, const ww_path* const* paths, size_t path_count,
                                        uint64_t since, size_t* indices, size_t capacity, size_t* count);
/* Gives the number of operations that the world has carried out. It grows by one with each operation that succeeds. */
WW_API ww_status ww_world_version(const ww_world* world, uint64_t* version);

/* A region that an operation has changed. This struct does not grow. */
/* A region that an operation has changed. A replacement has two boxes: one for the removal of the old shape, and one
   for the insertion of the new shape. */
typedef struct ww_changed_box {
  uint64_t version;     /* the version of the world after the operation */
  ww_box box;           /* the bounding box of an item; the last box of an operation can have several items */
  ww_bool is_insertion; /* whether the operation inserted an item in the box */
  ww_bool is_removal;   /* whether the operation removed an item in the box */
} ww_changed_box;

/* Writes the regions that the operations after version `since` have changed, the oldest first: the bounding box of each
   segment, polyline or polygon that they inserted or removed. If the world no longer has all boxes since that version,
   or if `since` is above the version of the world, the function sets *is_known to 0 and writes no box.
   ww_world_is_affected says how many boxes a world keeps. */
WW_API ww_status ww_world_changes_since(const ww_world* world, uint64_t since, ww_bool* is_known, ww_changed_box* boxes,
                                        size_t capacity, size_t* count);

/* A snapshot is an immutable world with the state that a world had when ww_world_publish was called, or at an earlier
   tick. Other threads query it while one thread changes the world, and neither waits for the other. The first snapshot
   costs as much as ww_world_clone; a later one costs time only for the items that have changed, if the earlier
   snapshots have been destroyed.
   Threads: each handle belongs to one thread at a time; give each thread a handle of its own by ww_snapshot_copy.
   Threads may copy and destroy their handles while another thread calls any function on the world. */
WW_API ww_status ww_world_publish(ww_world* world, ww_snapshot** snapshot);
/* Makes a snapshot with the state that the world had at a tick (ww_world_mark), as if ww_world_publish had been called
   then. The world does not change. So a program can keep many earlier states in the history, which takes memory only
   for the items that have changed, and can read each of them. The first call costs as much as ww_world_clone and
   ww_world_rewind; the cost of a later one depends on the items that have changed since the tick, if the earlier
   snapshots of ticks have been destroyed. In the snapshot, ww_world_changes_since knows only the boxes that the world
   still had when you made the snapshot.
   Errors: the errors of ww_world_rewind. */
WW_API ww_status ww_world_publish_tick(ww_world* world, uint64_t tick, ww_snapshot** snapshot);
/* Makes another handle of the same immutable world. The cost does not depend on the world. */
WW_API ww_status ww_snapshot_copy(const ww_snapshot* snapshot, ww_snapshot** copy);
/* Destroys a handle. If it was the last handle of an immutable world, the library frees the memory of this world or
   uses it again. A snapshot may outlive its world. */
WW_API void ww_snapshot_destroy(ww_snapshot* snapshot);
/* Sets *world to the immutable world. You can pass this world to all functions that take a `const ww_world*`, except
   ww_path_watch_update, on several threads at once, each with its own context. The world is valid until you destroy
   this handle. Do not destroy the world itself. */
WW_API ww_status ww_snapshot_world(const ww_snapshot* snapshot, const ww_world** world);

/* A path watch holds copies of the paths of many agents under keys that you choose. After operations, it says which
   agents should search again. It looks only at paths near the changes, so its cost depends on what has changed.
   Threads: a watch belongs to one thread at a time; making and updating it reads the world. */
WW_API ww_status ww_path_watch_create(const ww_world* world, ww_path_watch** watch);
WW_API void ww_path_watch_destroy(ww_path_watch* watch);
/* Watches a copy of a path under a key, instead of the path that the watch has under this key. The path must be the
   answer of a query (found or not) in the world as it is now, or as it was at the last update. An older answer is
   allowed, too, if its path is not blocked in the world as it was at the last update. Errors: WW_INVALID_ARGUMENT, if
   the path is found, but has no points and no pieces (ww_many_goals_query.wants_points). */
WW_API ww_status ww_path_watch_add(ww_path_watch* watch, uint64_t key, const ww_path* path);
/* Stops watching the path under a key. `was_there` receives whether there was one, and may be null. */
WW_API ww_status ww_path_watch_remove(ww_path_watch* watch, uint64_t key, ww_bool* was_there);
/* Finds out whether the watch has a path under a key. */
WW_API ww_status ww_path_watch_contains(const ww_path_watch* watch, uint64_t key, ww_bool* contains);
/* Gives the number of paths that the watch has. */
WW_API ww_status ww_path_watch_count(const ww_path_watch* watch, size_t* count);
/* Finds out what the operations since the last update, or since the watch was made, mean for the paths. `world` must be
   the world for which the watch was made. The watch keeps all paths. The three functions below read the answer, until
   the next update. A path can be in two of the lists. */
WW_API ww_status ww_path_watch_update(ww_path_watch* watch, const ww_world* world);
/* Writes the keys of the paths of point agents that are no longer clear, ascending. The list contains no path that is
   clear. */
WW_API ww_status ww_path_watch_blocked(const ww_path_watch* watch, uint64_t* keys, size_t capacity, size_t* count);
/* Writes the keys of the paths of discs to which an inserted item is so near that the disc may touch it, ascending. */
WW_API ww_status ww_path_watch_may_be_blocked(const ww_path_watch* watch, uint64_t* keys, size_t capacity,
                                              size_t* count);
/* Writes the keys of the paths that may be longer than necessary, because an operation removed an item that may have
   blocked a shorter path; ascending. The list also contains the paths that were not found, but are possible now. No
   other path has become longer than necessary. */
WW_API ww_status ww_path_watch_may_be_too_long(const ww_path_watch* watch, uint64_t* keys, size_t capacity,
                                               size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Mesh, hashes, memory */

/* The hash of the domain and the live items. It is the same on every machine, whatever operations led to these items.
   docs/hashes.md defines both hashes. */
typedef struct ww_items_hash {
  uint64_t words[2];
} ww_items_hash;
/* The SHA-256 of the text that ww_world_dump writes. */
typedef struct ww_mesh_hash {
  uint8_t bytes[32];
} ww_mesh_hash;

/* The vertices of a triangle, as indices in the list of vertices; counter-clockwise, from the smallest. */
typedef struct ww_triangle {
  uint32_t vertices[3];
} ww_triangle;
/* An edge on which sides of items, or the border of the domain, lie. */
typedef struct ww_constrained_edge {
  uint32_t vertices[2]; /* indices in the list of vertices, the smaller first */
  uint32_t first_id;    /* the index of the first id of the edge in the list of ids */
  uint32_t id_count;    /* the number of ids of the edge */
} ww_constrained_edge;

/* Gives the number of vertices of the mesh: the corners of the domain, the corners of items, and the crossings. */
WW_API ww_status ww_world_vertex_count(const ww_world* world, size_t* vertex_count);
/* Gives the number of triangles of the mesh. */
WW_API ww_status ww_world_triangle_count(const ww_world* world, size_t* triangle_count);
/* Copies the mesh as lists. (ww_world_publish, not this function, makes an immutable world for other threads.) Sets
   `mesh` to a copy of the mesh in canonical order: vertices by (x, y), triangles and edges by their indices. */
WW_API ww_status ww_world_snapshot(const ww_world* world, ww_context* context, ww_mesh* mesh);
/* Writes the vertices, rounded to nearest. */
WW_API ww_status ww_mesh_vertices(const ww_mesh* mesh, ww_point* vertices, size_t capacity, size_t* count);
/* Writes the triangles, sorted by their indices. */
WW_API ww_status ww_mesh_triangles(const ww_mesh* mesh, ww_triangle* triangles, size_t capacity, size_t* count);
/* Writes the constrained edges, sorted by their indices. */
WW_API ww_status ww_mesh_constrained_edges(const ww_mesh* mesh, ww_constrained_edge* edges, size_t capacity,
                                           size_t* count);
/* Writes the ids of the items on all constrained edges, edge after edge; 0 is the border of the domain. */
WW_API ww_status ww_mesh_ids(const ww_mesh* mesh, ww_id* ids, size_t capacity, size_t* count);
/* Sets `text` to the mesh as canonical text with exact coordinates. Worlds with equal domains and equal live items have
   equal texts. */
WW_API ww_status ww_world_dump(const ww_world* world, ww_text* text);
/* Gives the hash of the items. Every operation updates the hash, so this call takes constant time. */
WW_API ww_status ww_world_items_hash(const ww_world* world, ww_items_hash* hash);
/* Computes the hash of the mesh, at the cost of ww_world_dump. */
WW_API ww_status ww_world_mesh_hash(const ww_world* world, ww_mesh_hash* hash);
/* Writes a hash as 32 hexadecimal digits. */
WW_API ww_status ww_items_hash_text(const ww_items_hash* hash, char* buffer, size_t capacity, size_t* count);
/* Writes a hash as 64 hexadecimal digits. */
WW_API ww_status ww_mesh_hash_text(const ww_mesh_hash* hash, char* buffer, size_t capacity, size_t* count);
/* Checks the whole world, exactly, at a cost linear in the mesh. `fault` receives the first fault as text, which is
   empty if the world is valid; it may be null. */
WW_API ww_status ww_world_validate(const ww_world* world, ww_bool* is_valid, ww_text* fault);

/* The memory of a world in bytes, by purpose. */
typedef struct ww_memory_use {
  uint32_t struct_size;
  size_t vertices;    /* for each vertex: its point, an edge from it, the items with a corner there */
  size_t crossings;   /* for vertices at crossings: the lines that cross there */
  size_t faces;       /* for each triangle: its vertices and neighbours */
  size_t walls;       /* for each constrained edge: the sides that lie on it */
  size_t items;       /* ids, kinds and sides of the items */
  size_t sectors;     /* squares of a grid, each with a vertex at which the walks of point location start */
  size_t abstraction; /* the path abstraction */
  size_t bridges;     /* the bridges */
  size_t history;     /* the ticks to which the world can return */
  size_t spare;       /* unused capacity of arrays, and the scratch of operations */
  size_t total;       /* the sum of all of them */
} ww_memory_use;

/* Gives the memory of the world, by purpose. */
WW_API ww_status ww_world_memory(const ww_world* world, ww_memory_use* use);
/* Frees most of the spare memory. Changes no answer and no hash. The next operations allocate it again. */
WW_API ww_status ww_world_shrink_to_fit(ww_world* world);

/* The number of calls of one predicate, by the stage of the arithmetic that decided the call. */
typedef struct ww_stage_counts {
  uint64_t doubles;  /* doubles with a proven error bound; for crossings: if only the final division is rounded */
  uint64_t lattice;  /* integers of a fixed width */
  uint64_t integers; /* integers of any size */
} ww_stage_counts;
typedef struct ww_predicate_counts {
  uint32_t struct_size;
  ww_stage_counts orientation; /* whether a point lies left of, on or right of a line */
  ww_stage_counts in_circle;   /* whether a point lies inside a circle */
  ww_stage_counts order;       /* which of two points comes first in (x, y) order */
  ww_stage_counts crossing;    /* where two lines cross */
} ww_predicate_counts;

/* Gives the counts of the calling thread since its start, for all worlds together. */
WW_API ww_status ww_get_predicate_counts(ww_predicate_counts* counts);

/* ---------------------------------------------------------------------------------------------------------------------
   Saving and loading worlds. docs/formats.md describes the format. A saved world contains the domain, the options
   keep_abstraction and keep_bridges, the items, and the largest id that the world has seen. It does not contain the
   version, the history and the new_vertex_limit. Equal worlds give equal bytes on every machine. Every later version of
   the library reads the files of this version. */

/* Something that takes bytes: a file, a socket, memory. */
typedef struct ww_output {
  uint32_t struct_size;
  /* Takes `size` bytes, 1 or more. Returns 1, or 0 if it cannot take all of them. */
  ww_bool (*write)(const void* bytes, size_t size, void* user_data);
  /* Null, or a function that brings the bytes to their destination. Returns 1, or 0 if it cannot do this. */
  ww_bool (*flush)(void* user_data);
  void* user_data;
} ww_output;

/* Something that provides bytes. */
typedef struct ww_input {
  uint32_t struct_size;
  /* Writes 1 to `size` bytes to `buffer` and returns their number. Returns 0 at the end of the input, and SIZE_MAX if
     the input cannot be read. The library asks for few bytes at a time and never for more than it needs: if a call is
     expensive, keep a buffer. */
  size_t (*read)(void* buffer, size_t size, void* user_data);
  void* user_data;
} ww_input;

/* Writes a world to an output, and flushes it. Errors: WW_UNWRITABLE; the output may then have a piece of the world. */
WW_API ww_status ww_world_save(const ww_world* world, const ww_output* output);
/* Writes a world to a file: to a temporary file in the same folder, which then takes the name of the file. So at every
   moment the file is the old one or the new one. Errors: WW_UNWRITABLE; the old file then stays as it is. */
WW_API ww_status ww_world_save_file(const ww_world* world, const char* file_name);
/* Sets `bytes` to the bytes of a saved world. ww_text_bytes gives them, and their number. */
WW_API ww_status ww_world_save_bytes(const ww_world* world, ww_text* bytes);

/* Makes a world from an input, and reads no byte after the last byte of the world. The function checks the form of the
   bytes, their checksum, and the hash of the items. `options` may be null; progress reports the construction of the
   mesh, after all bytes have been read. Errors: WW_UNREADABLE, if the input fails; WW_MALFORMED, if the bytes are not a
   complete, unaltered saved world; WW_NOT_SUPPORTED, if they need a later version of the library. ww_error.index is the
   number of bytes that the function had read when it found the fault, and the bytes of the wrong value count, too. It
   is 0 if a world refuses the domain or an item. */
WW_API ww_status ww_world_load(const ww_input* input, const ww_bulk_options* options, ww_world** world);
/* Makes a world from a file, which must contain nothing else. Errors: the errors of ww_world_load. */
WW_API ww_status ww_world_load_file(const char* file_name, const ww_bulk_options* options, ww_world** world);
/* Makes a world from bytes, which must contain nothing else. Errors: the errors of ww_world_load. */
WW_API ww_status ww_world_load_bytes(const void* bytes, size_t size, const ww_bulk_options* options, ww_world** world);
/* Finds out whether bytes start like a saved world. */
WW_API ww_status ww_is_saved_world(const void* bytes, size_t size, ww_bool* is_saved_world);

/* ---------------------------------------------------------------------------------------------------------------------
   Scenes, scripts, scenarios. Their formats are in docs/formats.md. A text that you pass is a pointer and a length in
   bytes; it needs no zero byte. `name` is the name of the text in error messages: "NAME:LINE: ...". ww_error.index is
   the number of the line, from 1. Errors of all functions that parse: WW_MALFORMED, and WW_COORDINATE_RANGE for the
   files of Triangle. */

typedef int32_t ww_scene_format;
enum {
  WW_SCENE_SCRIPT = 0,        /* .wws, a world script: the items that are left after all changes */
  WW_SCENE_MOVINGAI = 1,      /* .map of Moving AI: blocked tiles become polygons */
  WW_SCENE_TRIANGLE_POLY = 2, /* .poly of Triangle: segments, and points for the other vertices */
  WW_SCENE_TRIANGLE_NODE = 3, /* .node of Triangle: points */
  WW_SCENE_SAVED_WORLD = 4    /* .wwb, a saved world: its domain and its items */
};

typedef struct ww_scene_info {
  uint32_t struct_size;
  ww_bool y_down; /* whether the y axis of the file points down */
  ww_box domain;
  size_t item_count;
} ww_scene_info;

/* Gives the format for the ending of a file name. Errors: WW_NOT_SUPPORTED. */
WW_API ww_status ww_scene_format_of(const char* file_name, ww_scene_format* format);
/* Sets a scene to the contents of a file. A file that starts like a saved world counts as a saved world. Otherwise the
   ending of the file name says the format.
   Errors: WW_UNREADABLE, WW_NOT_SUPPORTED, WW_MALFORMED, WW_COORDINATE_RANGE. */
WW_API ww_status ww_scene_read(const char* file_name, ww_scene* scene);
/* Sets a scene to a map of Moving AI. Tile (x, y) is the square [x, x + 1] x [y, y + 1], and y points down. */
WW_API ww_status ww_scene_parse_movingai_map(const char* text, size_t length, const char* name, ww_scene* scene);
/* Sets a scene to a .poly file of Triangle. `node_text` is null, or the text of the .node file of the same name, for a
   .poly file without vertices. */
WW_API ww_status ww_scene_parse_triangle_poly(const char* text, size_t length, const char* name, const char* node_text,
                                              size_t node_length, const char* node_name, ww_scene* scene);
/* Sets a scene to a .node file of Triangle. */
WW_API ww_status ww_scene_parse_triangle_node(const char* text, size_t length, const char* name, ww_scene* scene);
/* Sets a scene to the domain and the items of a saved world. To get its options and its next id, too, use
   ww_world_load_bytes. Errors: WW_MALFORMED, WW_NOT_SUPPORTED. */
WW_API ww_status ww_scene_parse_saved_world(const void* bytes, size_t size, const char* name, ww_scene* scene);
/* Sets a scene to a copy of a domain and items. */
WW_API ww_status ww_scene_set(ww_scene* scene, ww_box domain, const ww_items* items, ww_bool y_down);
/* Gives facts about a scene. */
WW_API ww_status ww_scene_get_info(const ww_scene* scene, ww_scene_info* info);
/* Sets *items to the items of the scene. They belong to the scene, and are valid until it changes or is destroyed. */
WW_API ww_status ww_scene_items(const ww_scene* scene, const ww_items** items);
/* Sets `text` to a scene as a world script. */
WW_API ww_status ww_scene_to_script(const ww_scene* scene, ww_text* text);

typedef int32_t ww_script_line_kind;
enum {
  WW_SCRIPT_INSERT = 0,
  WW_SCRIPT_REMOVE = 1,
  WW_SCRIPT_REPLACE = 2,
  WW_SCRIPT_LOCATE = 3,
  WW_SCRIPT_RAY = 4,
  WW_SCRIPT_DISC = 5,
  WW_SCRIPT_NEAREST = 6,
  WW_SCRIPT_PATH = 7,
  WW_SCRIPT_CHECK = 8,
  WW_SCRIPT_HASH = 9,
  WW_SCRIPT_CLEAR = 10,
  WW_SCRIPT_TICK = 11,
  WW_SCRIPT_MARK = 12,
  WW_SCRIPT_REWIND = 13
};

/* One line of a world script. Numbers that the line does not have are 0, and its algorithm is WW_ALGORITHM_OPTIMAL.
   ww_script_item gives the shape of an insertion or replacement, and the points of WW_SCRIPT_CLEAR. */
typedef struct ww_script_line {
  uint32_t struct_size;
  ww_script_line_kind kind;
  const char* word; /* the first word of the line: "segment"; valid as long as the library is loaded */
  uint32_t line;    /* the line in the text, from 1 */
  ww_bool has_radius;
  ww_bool has_algorithm;
  ww_bool has_end_tolerance;
  ww_bool has_goal;
  ww_path_algorithm algorithm;
  ww_id id;      /* of an insertion, removal or replacement */
  ww_point from; /* of WW_SCRIPT_LOCATE, _RAY, _DISC, _NEAREST and _PATH */
  ww_point to;   /* of WW_SCRIPT_RAY and _PATH; the goal of _NEAREST if has_goal is 1 */
  ww_agent agent;
  double end_tolerance;
  ww_bool has_items_hash;   /* for WW_SCRIPT_TICK */
  uint64_t tick;            /* the number of WW_SCRIPT_TICK; for _MARK and _REWIND the tick of ww_world_mark */
  ww_items_hash items_hash; /* for WW_SCRIPT_TICK */
} ww_script_line;

/* Sets `script` to the lines of a world script. Accepts points outside the domain: only a world refuses them. */
WW_API ww_status ww_script_parse(const char* text, size_t length, const char* name, ww_script* script);
/* Gives the domain. `line` receives its line in the text, from 1, and may be null. */
WW_API ww_status ww_script_domain(const ww_script* script, ww_box* domain, uint32_t* line);
/* Gives the number of lines. */
WW_API ww_status ww_script_line_count(const ww_script* script, size_t* count);
/* Gives the line with this index. The lines have the indices 0 to count - 1. */
WW_API ww_status ww_script_get_line(const ww_script* script, size_t index, ww_script_line* line);
/* Sets `items` to a copy of the item of one line. */
WW_API ww_status ww_script_item(const ww_script* script, size_t index, ww_items* items);
/* Sets a scene to the items that are left after all changes of a script. Ignores changes that a world would refuse. */
WW_API ww_status ww_script_scene(const ww_script* script, ww_scene* scene);

/* A query of a scenario of Moving AI. */
typedef struct ww_scenario_query {
  uint32_t struct_size;
  uint32_t line;    /* the line in the text, from 1 */
  uint64_t width;   /* the width of the map in tiles */
  uint64_t height;  /* the height of the map in tiles */
  ww_point start;   /* where the path starts */
  ww_point goal;    /* where the path ends */
  double length;    /* the length of the path that the author has found; negative if the author found none */
  double precision; /* half a unit of the last digit of `length` */
} ww_scenario_query;

/* Sets `scenario` to the queries of a scenario file. */
WW_API ww_status ww_scenario_parse(const char* text, size_t length, const char* name, ww_scenario* scenario);
/* Gives the number of queries. */
WW_API ww_status ww_scenario_count(const ww_scenario* scenario, size_t* count);
/* Gives one query. `map` receives the file name of the map, a text. */
WW_API ww_status ww_scenario_get(const ww_scenario* scenario, size_t index, ww_scenario_query* query, char* map,
                                 size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Replay logs. A log is a world script with the items of a world, each change that you record, and a hash of the items
   every few ticks. The command `waywright replay` reads it. */

/* Starts a log: writes the domain and the items of the world. Writes a hash at each tick whose number is a multiple of
   `ticks_per_hash`, 1 or more. The functions of the output must work as long as the writer exists. Errors:
   WW_UNWRITABLE. */
WW_API ww_status ww_replay_writer_create(const ww_output* output, const ww_world* world, uint64_t ticks_per_hash,
                                         ww_replay_writer** writer);
WW_API void ww_replay_writer_destroy(ww_replay_writer* writer);
/* Records changes that the world has made. `ids` has the id of each change, for example the answer of ww_world_apply.
   Null stands for the ids in the changes, which then must not be 0. Errors: WW_BAD_ID; WW_UNWRITABLE: the writer cannot
   continue then. */
WW_API ww_status ww_replay_writer_record(ww_replay_writer* writer, const ww_change* changes, size_t change_count,
                                         const ww_id* ids);
/* Ends a tick. Ticks count from 1. At a tick with a hash, the function also flushes the output.
   Errors: WW_UNWRITABLE. */
WW_API ww_status ww_replay_writer_tick(ww_replay_writer* writer, const ww_world* world);
/* Gives the number of the last tick, or 0 before the first tick. */
WW_API ww_status ww_replay_writer_last_tick(const ww_replay_writer* writer, uint64_t* tick);

/* A function that the library calls to report how much of a call is done. */
typedef void (*ww_progress)(size_t done, size_t total, void* user_data);

/* The answer of a replay. The members from `tick` on have no meaning if is_same is 1. */
typedef struct ww_replay_result {
  uint32_t struct_size;
  ww_bool is_same;        /* whether all changes and rewinds were made and all hashes are equal */
  uint64_t ticks;         /* the number of ticks that were replayed */
  uint64_t tick;          /* the first tick whose hash differs, or during which the world refused a change or rewind */
  uint64_t last_same;     /* the last tick before `tick` whose hash is equal, or 0 */
  uint32_t line;          /* the line of the hash, or of the refused change or rewind, in the script */
  ww_bool is_refused;     /* whether the world refused a change or rewind: ww_replay_refusal says why */
  ww_items_hash expected; /* the hash in the log */
  ww_items_hash computed; /* the hash of the replayed world */
} ww_replay_result;

/* Makes the changes of a log in a new world, and compares the hash of its items with each hash in the log. Stops at the
   first difference, which is no error. Ignores queries. `progress` may be null; it counts lines of the log. Errors:
   WW_COORDINATE_RANGE, WW_BAD_DOMAIN, for the domain. */
WW_API ww_status ww_replay_run(ww_replay* replay, const ww_script* log, ww_progress progress, void* user_data);
/* Gives the answer of the last replay. Before the first one, is_same is 1 and ticks is 0. */
WW_API ww_status ww_replay_get_result(const ww_replay* replay, ww_replay_result* result);
/* Writes the items that were changed after tick `last_same`, ascending, or the refused item. */
WW_API ww_status ww_replay_changed(const ww_replay* replay, ww_id* ids, size_t capacity, size_t* count);
/* Gives the error of the refused change, and its text. If no change was refused, error->status is WW_OK and the text is
   empty. */
WW_API ww_status ww_replay_refusal(const ww_replay* replay, ww_error* error, char* buffer, size_t capacity,
                                   size_t* count);

typedef int32_t ww_difference_kind;
enum {
  WW_DIFFERENCE_DOMAIN = 0, /* the domains differ */
  WW_DIFFERENCE_CHANGE = 1, /* a change, mark or rewind differs, or one log lacks it */
  WW_DIFFERENCE_HASH = 2,   /* all changes are equal up to this tick, but its hash differs */
  WW_DIFFERENCE_LENGTH = 3  /* one log ends after this tick, or the next ticks have different numbers */
};

/* The first difference between two logs. The members after is_different have no meaning if it is 0. */
typedef struct ww_replay_difference {
  uint32_t struct_size;
  ww_bool is_different;
  ww_difference_kind kind;
  uint32_t line;       /* the line in the first log, or 0 if this log ends before the difference */
  uint32_t other_line; /* the line in the second log, or 0 if this log ends before the difference */
  uint64_t tick;       /* the tick during which the logs begin to differ */
  ww_id item;          /* for WW_DIFFERENCE_CHANGE: the item that `line` of the first log changes, or 0 */
  ww_id other_item;    /* for WW_DIFFERENCE_CHANGE: the item that `other_line` of the second log changes, or 0 */
} ww_replay_difference;

/* Compares two logs, change by change and hash by hash. Ignores queries, and the hash of a tick that has no hash in the
   other log. The list is the items that were changed since the last equal hash, ascending, if a hash differs. */
WW_API ww_status ww_find_difference(const ww_script* log, const ww_script* other, ww_replay_difference* difference,
                                    ww_id* changed, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Pictures */

typedef int32_t ww_svg_theme;
enum { WW_SVG_AUTOMATIC = 0, WW_SVG_LIGHT = 1, WW_SVG_DARK = 2 };

/* The options of a picture. The part of the picture that shows the world is the map. The title, the axes and the
   legend lie around the map. */
typedef struct ww_svg_options {
  uint32_t struct_size;
  ww_svg_theme theme; /* `automatic` by default */
  double width;       /* in pixels, 240 to 100,000; 1200 by default; the height follows from the content */
  ww_bool mesh;       /* whether the picture shows the edges of the mesh that are not constrained; true by default */
  ww_bool axes;       /* whether it has marks with coordinates, a scale bar, and the direction of y; true by default */
  ww_bool ids;        /* whether it shows the kind and the id of an item while the pointer is on it; true by default */
  ww_bool y_down;     /* whether the y axis of the world points down */
  ww_bool has_crop;   /* whether `crop` is set */
  ww_box crop;        /* the box that the picture shows; it may extend beyond the domain, which is the default */
  const char* title;  /* the text above the map; none by default */
} ww_svg_options;

/* The transform between a world and its picture. */
typedef struct ww_svg_frame {
  uint32_t struct_size;
  ww_bool y_down;
  ww_box shown; /* what the picture shows, in the coordinates of the world */
  ww_box map;   /* the box of the map in the coordinates of the picture, that is, in pixels */
  double scale; /* the pixels of one unit of length */
} ww_svg_frame;

/* Sets all options to their defaults. `struct_size` is sizeof(ww_svg_options). */
WW_API ww_status ww_svg_options_init(ww_svg_options* options, size_t struct_size);
/* Sets `text` to a picture of the world as SVG. `overlay` and `options` may be null. docs/pictures.md shows examples.
   Errors: WW_COORDINATE_RANGE; WW_BAD_DOMAIN, if min of the crop box is not below its max; WW_OUT_OF_DOMAIN, if the
   crop box has no area in common with the domain. */
WW_API ww_status ww_world_to_svg(const ww_world* world, const ww_svg_overlay* overlay, const ww_svg_options* options,
                                 ww_text* text);
/* Gives the transform of the picture of a world over `domain` with these options.
   Errors: the errors of ww_world_to_svg. */
WW_API ww_status ww_svg_get_frame(ww_box domain, const ww_svg_options* options, ww_svg_frame* frame);
/* Gives the position of a point of the world in the picture, in pixels from the upper left corner, downwards. */
WW_API ww_status ww_svg_to_picture(const ww_svg_frame* frame, ww_point point, ww_point* pixels);
/* Gives the point of the world at a position in the picture. */
WW_API ww_status ww_svg_to_world(const ww_svg_frame* frame, ww_point pixels, ww_point* point);

/* An overlay is what a picture shows on top of the world. It copies what you add. A colour is any CSS colour; null
   stands for the colour of the theme. A hint is the text on hover; null for none. */

/* Removes everything from an overlay. */
WW_API ww_status ww_svg_overlay_clear(ww_svg_overlay* overlay);
/* Adds the path of a point agent. The picture omits paths without points. */
WW_API ww_status ww_svg_add_path(ww_svg_overlay* overlay, const ww_path* path);
/* Adds a query with a radius above 0 and its answer. The picture shows the path, the area that the disc covers, and the
   items that stop the disc. */
WW_API ww_status ww_svg_add_disc_path(ww_svg_overlay* overlay, const ww_path_query* query, const ww_path* path);
/* Adds a path query without a path: a dashed line between two marks, and the status. */
WW_API ww_status ww_svg_add_failed_path(ww_svg_overlay* overlay, ww_point start, ww_point goal, ww_path_status status);
/* Adds a query of ww_world_ray and its answer. */
WW_API ww_status ww_svg_add_ray(ww_svg_overlay* overlay, ww_point from, ww_point to, const ww_ray_hit* hit,
                                const ww_id* items, size_t item_count);
/* Adds a query of ww_world_locate and its answer. */
WW_API ww_status ww_svg_add_location(ww_svg_overlay* overlay, ww_point at, const ww_location* location,
                                     const ww_id* polygons, size_t polygon_count);
/* Adds a disc, for example a unit. */
WW_API ww_status ww_svg_add_disc(ww_svg_overlay* overlay, ww_point centre, double radius, const char* colour,
                                 const char* hint);
/* Adds a line through several points. `width` is in pixels, 0.1 to 60. */
WW_API ww_status ww_svg_add_polyline(ww_svg_overlay* overlay, const ww_point* points, size_t point_count, double width,
                                     ww_bool dashed, const char* colour, const char* hint);
/* Adds a text beside `at`. The text keeps a disc of `radius` (in units of the world) around `at` free. `size` is in
   pixels, 4 to 200; 14 is usual. */
WW_API ww_status ww_svg_add_label(ww_svg_overlay* overlay, ww_point at, const char* text, double radius, double size,
                                  const char* colour);
/* Adds an entry to the legend. */
WW_API ww_status ww_svg_add_key(ww_svg_overlay* overlay, const char* text, const char* colour);
/* Appends SVG elements in the coordinates of the picture. They must be well-formed XML. */
WW_API ww_status ww_svg_add_elements(ww_svg_overlay* overlay, const char* elements);

#ifdef __cplusplus
}
#endif

#endif
