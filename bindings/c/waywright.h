/* Waywright for C: a dynamic, exact constrained Delaunay triangulation, and paths through it.

   docs/c.md introduces this interface, and docs/languages.md lists the C++ function behind each function here. The C++
   headers in include/waywright describe each operation in full, with its cost and its source.

   Rules for all functions:
   - Every function that can fail returns a ww_status. It is WW_OK, or it says why the call did nothing. Then
     ww_last_error() and ww_last_error_message() say more. No exception leaves the library.
   - The functions ww_..._destroy accept null.
   - Structs that can grow in later versions begin with struct_size. For a struct with options, call its function
     ww_..._init. For a struct with an answer, set struct_size to its size yourself:
         ww_location location = {.struct_size = sizeof location};
   - A list has three parameters: a buffer, its capacity, and count. The function writes as many elements as the buffer
     holds, and sets *count to the number of all elements. If the buffer is too small, the status is
     WW_BUFFER_TOO_SMALL: the answer is then complete except for the missing elements. A null buffer with capacity 0 is
     never too small, so you can ask for the count first. `count` may be null.
   - A text is a list of characters that ends with a zero byte. The zero byte counts. A buffer that is too small also
     ends with a zero byte.
   - Threads: several threads may read one object at once. While a thread changes an object, no other thread may use
     it. Functions whose parameter is `const ww_world*` read the world. A context serves one call at a time. */
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

/* 0 or 1. As an argument, every number but 0 counts as 1. */
typedef int32_t ww_bool;

/* The id of an item: 1 to 2^63 - 1. 0 is null. In a list of the items on a wall, 0 is the border of the domain. */
typedef uint64_t ww_id;

typedef struct ww_point {
  double x;
  double y;
} ww_point;

typedef struct ww_box {
  ww_point min;
  ww_point max;
} ww_box;

typedef int32_t ww_status;
/* The statuses above 0 are the values of waywright::ErrorCode. The statuses below 0 exist only in C. */
enum {
  WW_OK = 0,
  WW_COORDINATE_RANGE = 1, /* a coordinate that is not finite, beyond +-2^100, or nearer to 0 than 2^-100 but not 0 */
  WW_OUT_OF_DOMAIN = 2,    /* a point outside the world's domain */
  WW_ID_IN_USE = 3,        /* a live item has this id already */
  WW_UNKNOWN_ID = 4,       /* no live item has this id */
  WW_BAD_RADIUS = 5,       /* a radius that is negative or not finite */
  WW_BAD_DISTANCE = 6,     /* a distance that is negative, not a number, or too small */
  WW_BAD_ID = 7,           /* an id above 2^63 - 1 */
  WW_BAD_DOMAIN = 8,       /* a domain without min.x < max.x and min.y < max.y, or a box with min beyond max */
  WW_EMPTY_SHAPE = 9,      /* a polyline or ring without points, a polygon without rings */
  WW_TOO_LARGE = 10,       /* more than 2^27 vertices */
  WW_WORLD_GONE = 11,      /* the world of a search no longer exists */
  WW_NOT_SUPPORTED = 12,   /* a request that this version, this build or this world does not support */
  WW_NO_BRIDGES = 13,      /* a query that needs bridges, of a world that does not keep them */
  WW_UNREADABLE = 14,      /* a file that cannot be opened or read */
  WW_MALFORMED = 15,       /* text that does not follow its format */

  WW_OUT_OF_MEMORY = -1,    /* there is not enough memory; no world has changed */
  WW_INVALID_ARGUMENT = -2, /* a broken rule of this interface: a null pointer, a wrong size, an unknown kind */
  WW_BUFFER_TOO_SMALL = -3, /* a list does not fit in the caller's buffer */
  WW_INTERNAL_ERROR = -4    /* a bug in the library; destroy the objects that the call used */
};

/* Returns the name of a status: "out-of-domain". Never null. */
WW_API const char* ww_status_name(ww_status status);

/* Returns the version of the library as text, "0.1.0", and as a number like WW_VERSION_NUMBER. */
WW_API const char* ww_version(void);
WW_API int32_t ww_version_number(void);

/* What the last call on this thread without WW_OK said about its error. */
typedef struct ww_error {
  uint32_t struct_size;
  ww_status status; /* WW_OK if no call has failed yet */
  ww_id item;       /* the id that caused the error, or 0 */
  uint64_t index;   /* the index of the refused element in its list (from 0), or a line number (from 1) */
} ww_error;

WW_API ww_status ww_last_error(ww_error* error);
/* Writes the error in words: "the goal, (7, 12), lies outside the domain, (0, 0) to (10, 10)". */
WW_API ww_status ww_last_error_message(char* buffer, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Memory of the library */

/* The functions from which the library takes its memory. Any thread may call them, several at once. */
typedef struct ww_allocator {
  uint32_t struct_size;
  /* Returns `size` bytes (1 or more) at a multiple of `alignment`, or null. */
  void* (*allocate)(size_t size, size_t alignment, void* user_data);
  /* Frees memory that allocate() has returned for the same alignment. Never called with null. */
  void (*deallocate)(void* memory, size_t alignment, void* user_data);
  void* user_data;
} ww_allocator;

/* Sets the allocator of the whole process. Null restores malloc and free. Call it before you make the first object:
   as long as the library holds memory, the status is WW_INVALID_ARGUMENT. Errors: WW_NOT_SUPPORTED, if the library was
   built without allocator hooks (docs/c.md says when). */
WW_API ww_status ww_set_allocator(const ww_allocator* allocator);

/* ---------------------------------------------------------------------------------------------------------------------
   Objects */

typedef struct ww_world ww_world;             /* obstacles, and their mesh */
typedef struct ww_context ww_context;         /* the memory that queries keep between calls; one for each thread */
typedef struct ww_items ww_items;             /* a list of items: ids and shapes */
typedef struct ww_path ww_path;               /* the answer to a path query */
typedef struct ww_paths ww_paths;             /* the answers to several path queries */
typedef struct ww_search ww_search;           /* a path search in slices */
typedef struct ww_mesh ww_mesh;               /* a copy of the mesh of a world */
typedef struct ww_text ww_text;               /* a text that the library has written */
typedef struct ww_scene ww_scene;             /* a domain and items, as a file gives them */
typedef struct ww_script ww_script;           /* the lines of a world script */
typedef struct ww_scenario ww_scenario;       /* the queries of a scenario of Moving AI */
typedef struct ww_svg_overlay ww_svg_overlay; /* what a picture shows besides the world */

/* You can use an object again and again for answers: it keeps its memory. */
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
WW_API ww_status ww_svg_overlay_create(ww_svg_overlay** overlay);
WW_API void ww_svg_overlay_destroy(ww_svg_overlay* overlay);

/* Reads a text. It may contain zero bytes besides the one at its end. */
WW_API ww_status ww_text_read(const ww_text* text, char* buffer, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Shapes and items */

typedef int32_t ww_item_kind;
enum {
  WW_ITEM_POINT = 0,    /* a vertex, no wall */
  WW_ITEM_SEGMENT = 1,  /* a wall */
  WW_ITEM_POLYLINE = 2, /* an open chain of walls */
  WW_ITEM_POLYGON = 3   /* a solid obstacle of one or more closed rings */
};
WW_API const char* ww_item_kind_name(ww_item_kind kind);

typedef int32_t ww_fill_rule;
enum {
  WW_FILL_EVEN_ODD = 0, /* inside if the winding number is odd: a ring in a ring is a hole */
  WW_FILL_NONZERO = 1   /* inside if the winding number is not 0 */
};
WW_API const char* ww_fill_rule_name(ww_fill_rule rule);

/* The geometry of an item. It refers to points of yours, which the functions below only read. */
typedef struct ww_shape {
  uint32_t struct_size;
  ww_item_kind kind;
  ww_fill_rule fill; /* for a polygon */
  const ww_point* points;
  size_t point_count;
  /* The number of points of each ring; their sum is point_count. Null stands for one ring of all points. */
  const size_t* ring_sizes;
  size_t ring_count;
} ww_shape;

/* Sets the shape to a point without coordinates: kind WW_ITEM_POINT, no points, one ring. */
WW_API ww_status ww_shape_init(ww_shape* shape, size_t struct_size);

/* Writes the corners of a rectangle, counter-clockwise from its lower left corner. */
WW_API ww_status ww_rectangle(ww_box box, ww_point* points, size_t capacity, size_t* count);
/* Writes the corners of a regular polygon of 3 corners or more, counter-clockwise from the corner to the right. */
WW_API ww_status ww_regular_polygon(ww_point centre, double radius, size_t corner_count, ww_point* points,
                                    size_t capacity, size_t* count);
/* Writes the points of a shape, moved by (dx, dy). */
WW_API ww_status ww_translated(const ww_shape* shape, double dx, double dy, ww_point* points, size_t capacity,
                               size_t* count);
/* Computes the centroid of a shape with a point, in plain doubles. */
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

WW_API ww_status ww_items_clear(ww_items* items);
/* Appends a copy of a shape. If id is 0, a world that inserts the item chooses the id. */
WW_API ww_status ww_items_add(ww_items* items, ww_id id, const ww_shape* shape);
WW_API ww_status ww_items_count(const ww_items* items, size_t* count);
WW_API ww_status ww_items_get_info(const ww_items* items, size_t index, ww_item_info* info);
WW_API ww_status ww_items_points(const ww_items* items, size_t index, ww_point* points, size_t capacity, size_t* count);
WW_API ww_status ww_items_ring_sizes(const ww_items* items, size_t index, size_t* ring_sizes, size_t capacity,
                                     size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Making a world */

typedef struct ww_world_options {
  uint32_t struct_size;
  ww_bool keep_abstraction; /* 1 by default: whether the world maintains the path abstraction */
  ww_bool keep_bridges;     /* 0 by default: whether the world can answer path queries for discs */
} ww_world_options;

WW_API ww_status ww_world_options_init(ww_world_options* options, size_t struct_size);
/* Makes an empty world over a closed box. `options` may be null. */
WW_API ww_status ww_world_create(ww_box domain, const ww_world_options* options, ww_world** world);
WW_API void ww_world_destroy(ww_world* world);
WW_API ww_status ww_world_domain(const ww_world* world, ww_box* domain);

/* ---------------------------------------------------------------------------------------------------------------------
   Changing items. Each call is one operation: the world carries it out completely or changes nothing.
   If `id` is 0, the world chooses the id. `inserted` receives the id, and may be null. */

WW_API ww_status ww_world_insert(ww_world* world, const ww_shape* shape, ww_id id, ww_id* inserted);
WW_API ww_status ww_world_insert_point(ww_world* world, ww_point point, ww_id id, ww_id* inserted);
WW_API ww_status ww_world_insert_segment(ww_world* world, ww_point a, ww_point b, ww_id id, ww_id* inserted);
WW_API ww_status ww_world_insert_polyline(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                          ww_id* inserted);
/* Inserts a polygon of one ring. For several rings, use ww_world_insert. */
WW_API ww_status ww_world_insert_polygon(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                         ww_id* inserted);
WW_API ww_status ww_world_remove(ww_world* world, ww_id id);
WW_API ww_status ww_world_replace(ww_world* world, ww_id id, const ww_shape* shape);

/* ---------------------------------------------------------------------------------------------------------------------
   Changing many items at once */

/* A job of the library: call job(job_data, i) for an index i. It does not fail. */
typedef void (*ww_job)(void* job_data, size_t index);

/* The threads of your program. run() calls job(job_data, i) once for each i below count, on any threads, in any order,
   and returns when all these calls have returned. It may omit calls; the library then makes them itself. */
typedef struct ww_job_system {
  uint32_t struct_size;
  void (*run)(size_t count, ww_job job, void* job_data, void* user_data);
  void* user_data;
} ww_job_system;

typedef struct ww_bulk_options {
  uint32_t struct_size;
  /* Null, or a function that the library calls on the calling thread, at the end with done == total. It must not use
     the world. */
  void (*progress)(size_t done, size_t total, void* user_data);
  void* progress_user_data;
  size_t threads;            /* 1 by default; 1 or more, including the calling thread */
  const ww_job_system* jobs; /* null by default: the library starts threads itself */
} ww_bulk_options;

WW_API ww_status ww_bulk_options_init(ww_bulk_options* options, size_t struct_size);

/* Inserts all items of a list as one operation. `options` may be null. `ids` is null, or an array with room for one id
   for each item. */
WW_API ww_status ww_world_insert_all(ww_world* world, const ww_items* items, const ww_bulk_options* options,
                                     ww_id* ids);
/* Inserts many points as one operation. The first has the id `first`, and each further one the next id. `first_id`
   receives the id of the first point, and may be null. */
WW_API ww_status ww_world_insert_points(ww_world* world, const ww_point* points, size_t point_count, ww_id first,
                                        const ww_bulk_options* options, ww_id* first_id);

typedef int32_t ww_change_kind;
enum { WW_CHANGE_INSERT = 0, WW_CHANGE_REMOVE = 1, WW_CHANGE_REPLACE = 2 };

typedef struct ww_change {
  ww_change_kind kind;
  ww_id id;
  const ww_shape* shape; /* for an insertion or a replacement */
} ww_change;

/* Makes several changes, one after the other, as one operation. `ids` is null, or an array with room for one id for
   each change. */
WW_API ww_status ww_world_apply(ww_world* world, const ww_change* changes, size_t change_count, ww_id* ids);

/* ---------------------------------------------------------------------------------------------------------------------
   Reading items */

WW_API ww_status ww_world_contains(const ww_world* world, ww_id id, ww_bool* contains);
WW_API ww_status ww_world_item_count(const ww_world* world, size_t* item_count);
/* Writes the ids of all live items, ascending. */
WW_API ww_status ww_world_item_ids(const ww_world* world, ww_id* ids, size_t capacity, size_t* count);
/* Sets `items` to the item with this id, or to all live items, ascending by id. */
WW_API ww_status ww_world_item(const ww_world* world, ww_id id, ww_items* items);
WW_API ww_status ww_world_items(const ww_world* world, ww_context* context, ww_items* items);

/* ---------------------------------------------------------------------------------------------------------------------
   Locating and asking */

typedef int32_t ww_location_kind;
enum { WW_LOCATION_VERTEX = 0, WW_LOCATION_EDGE = 1, WW_LOCATION_FACE = 2 };
WW_API const char* ww_location_kind_name(ww_location_kind kind);

typedef struct ww_location {
  uint32_t struct_size;
  ww_location_kind kind;
  size_t vertex_count;
  ww_point vertices[3]; /* 1, 2 or 3 vertices, rounded; those of a face counter-clockwise */
} ww_location;

/* Finds the vertex, edge or face at a point. The list is the polygons there, ascending. */
WW_API ww_status ww_world_locate(const ww_world* world, ww_point point, ww_context* context, ww_location* location,
                                 ww_id* polygons, size_t capacity, size_t* count);
/* Finds the items that contain a point, ascending. */
WW_API ww_status ww_world_items_at(const ww_world* world, ww_point point, ww_context* context, ww_id* items,
                                   size_t capacity, size_t* count);

typedef struct ww_crossed_item {
  ww_id id;
  ww_point at; /* where the segment meets a side of the item, rounded */
} ww_crossed_item;

/* Finds the items whose sides a segment meets, in the order from `from` to `to`. */
WW_API ww_status ww_world_items_crossed(const ww_world* world, ww_point from, ww_point to, ww_context* context,
                                        ww_crossed_item* items, size_t capacity, size_t* count);
/* Finds the items that have a position in common with a closed box, ascending. */
WW_API ww_status ww_world_items_in(const ww_world* world, ww_box box, ww_context* context, ww_id* items,
                                   size_t capacity, size_t* count);

typedef struct ww_ray_hit {
  uint32_t struct_size;
  ww_bool hit;      /* whether the segment or the disc touches a wall */
  ww_point at;      /* the first position where it does; for a disc, the position of its centre */
  ww_point contact; /* the position on these walls that is nearest to `at` */
} ww_ray_hit;

/* Finds the first wall that a segment touches. The list is the items with a side there; 0 is the border. */
WW_API ww_status ww_world_ray(const ww_world* world, ww_point from, ww_point to, ww_context* context, ww_ray_hit* hit,
                              ww_id* items, size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Discs */

/* Finds the first wall that a disc touches while its centre moves from `from` to `to`. */
WW_API ww_status ww_world_sweep_disc(const ww_world* world, ww_point from, ww_point to, double radius,
                                     ww_context* context, ww_ray_hit* hit, ww_id* items, size_t capacity,
                                     size_t* count);
/* Finds out whether a disc fits at a position. The list is the items that stop it; 0 is the border. */
WW_API ww_status ww_world_fit_disc(const ww_world* world, ww_point centre, double radius, ww_context* context,
                                   ww_bool* fits, ww_id* items, size_t capacity, size_t* count);

typedef struct ww_nearest_fit_query {
  uint32_t struct_size;
  ww_bool has_goal; /* 0 by default; 1: only positions count from which the disc gets to `goal` */
  ww_point point;
  ww_point goal;
  double radius; /* 0 by default */
  double limit;  /* infinity by default: the largest distance of the answer from `point` */
} ww_nearest_fit_query;

typedef struct ww_nearest_fit {
  uint32_t struct_size;
  ww_bool is_found;
  ww_point at;
  double distance;
} ww_nearest_fit;

WW_API ww_status ww_nearest_fit_query_init(ww_nearest_fit_query* query, size_t struct_size);
/* Finds the point nearest to query->point where a disc fits. */
WW_API ww_status ww_world_nearest_fit(const ww_world* world, const ww_nearest_fit_query* query, ww_context* context,
                                      ww_nearest_fit* fit);

typedef struct ww_widest_path {
  uint32_t struct_size;
  ww_bool is_connected;
  ww_bool is_limited; /* whether a gap limits the disc */
  double radius;      /* the largest radius of a disc that gets through; infinity if no gap limits it */
  ww_point from;      /* the ends of the gap */
  ww_point to;
} ww_widest_path;

/* Finds the largest disc that gets from start to goal. The lists are the items at the two ends of the gap. */
WW_API ww_status ww_world_widest_path(const ww_world* world, ww_point start, ww_point goal, ww_context* context,
                                      ww_widest_path* widest, ww_id* from_items, size_t from_capacity,
                                      size_t* from_count, ww_id* to_items, size_t to_capacity, size_t* to_count);

/* ---------------------------------------------------------------------------------------------------------------------
   Paths */

typedef int32_t ww_path_algorithm;
enum { WW_ALGORITHM_TA = 0, WW_ALGORITHM_TRA = 1, WW_ALGORITHM_OPTIMAL = 2 };
WW_API const char* ww_path_algorithm_name(ww_path_algorithm algorithm);
/* Sets *algorithm to the algorithm with this name. Errors: WW_INVALID_ARGUMENT, if there is none. */
WW_API ww_status ww_path_algorithm_by_name(const char* name, ww_path_algorithm* algorithm);

typedef struct ww_path_query {
  uint32_t struct_size;
  ww_path_algorithm algorithm; /* WW_ALGORITHM_OPTIMAL by default */
  ww_point start;
  ww_point goal;
  double radius;              /* 0 by default: a point agent. Above 0 the world must keep its bridges. */
  double end_tolerance;       /* how far the search may move a blocked end, if has_end_tolerance is set */
  ww_bool has_end_tolerance;  /* 0 by default: the tolerance is that of ww_world_default_end_tolerance */
  ww_bool wants_channel;      /* 0 by default */
  ww_bool wants_time;         /* 0 by default */
  uint64_t budget_expansions; /* for TA: 0 by default; UINT64_MAX for no limit */
  int64_t budget_nanoseconds; /* for TA: INT64_MAX by default, no limit */
} ww_path_query;

WW_API ww_status ww_path_query_init(ww_path_query* query, size_t struct_size);
/* Finds a path, or finds out that there is none: ww_path_info says which. */
WW_API ww_status ww_world_find_path(const ww_world* world, const ww_path_query* query, ww_context* context,
                                    ww_path* path);
/* Finds a path for each query, on `threads` threads, 1 or more. All queries have the struct_size of the first one.
   `jobs` may be null. */
WW_API ww_status ww_world_find_paths(const ww_world* world, const ww_path_query* queries, size_t query_count,
                                     size_t threads, const ww_job_system* jobs, ww_context* context, ww_paths* paths);

typedef struct ww_many_goals_query {
  uint32_t struct_size;
  ww_bool wants_points; /* 0 by default: the answers have only status and length */
  ww_point start;
  const ww_point* goals;
  size_t goal_count;
  double radius;             /* 0 by default */
  double end_tolerance;      /* like ww_path_query.end_tolerance */
  ww_bool has_end_tolerance; /* 0 by default */
} ww_many_goals_query;

WW_API ww_status ww_many_goals_query_init(ww_many_goals_query* query, size_t struct_size);
/* Finds the shortest path to each goal. */
WW_API ww_status ww_world_find_paths_from(const ww_world* world, const ww_many_goals_query* query, ww_context* context,
                                          ww_paths* paths);
WW_API ww_status ww_world_default_end_tolerance(const ww_world* world, double* tolerance);

WW_API ww_status ww_paths_count(const ww_paths* paths, size_t* count);
/* Sets *path to a path of the list. It belongs to the list, and is valid until the list changes. */
WW_API ww_status ww_paths_get(const ww_paths* paths, size_t index, const ww_path** path);

typedef int32_t ww_path_status;
enum { WW_PATH_FOUND = 0, WW_PATH_START_BLOCKED = 1, WW_PATH_GOAL_BLOCKED = 2, WW_PATH_NO_PATH = 3 };
WW_API const char* ww_path_status_name(ww_path_status status);

/* Facts about a path. */
typedef struct ww_path_info {
  uint32_t struct_size;
  ww_path_status status;
  double length;      /* 0 unless found */
  double lower_bound; /* no path is shorter */
  double radius;      /* as in the query */
  uint64_t expansions;
  int64_t nanoseconds; /* 0 unless ww_path_query.wants_time */
  size_t point_count;
  size_t piece_count;
  size_t channel_count;
  size_t blocker_count;
  ww_bool has_moved_start; /* whether the search has moved the start from moved_start_from to moved_start_to */
  ww_bool has_moved_goal;
  ww_point moved_start_from;
  ww_point moved_start_to;
  ww_point moved_goal_from;
  ww_point moved_goal_to;
  ww_bool has_widest; /* whether ww_path_widest has an answer */
} ww_path_info;

typedef int32_t ww_piece_kind;
enum { WW_PIECE_LINE = 0, WW_PIECE_ARC = 1 };

/* A piece of the path of a disc's centre. */
typedef struct ww_path_piece {
  ww_piece_kind kind;
  ww_point from;
  ww_point to;
  ww_point centre;    /* of an arc */
  double radius;      /* of an arc */
  double start_angle; /* of an arc, in radians; larger end_angle: the arc turns left */
  double end_angle;
} ww_path_piece;

/* An edge that a path crosses: its ends, seen from an agent on the path. */
typedef struct ww_portal {
  ww_point left;
  ww_point right;
} ww_portal;

WW_API ww_status ww_path_get_info(const ww_path* path, ww_path_info* info);
/* The start, the turns and the goal. Empty if there is no path, or if the query has a radius above 0. */
WW_API ww_status ww_path_points(const ww_path* path, ww_point* points, size_t capacity, size_t* count);
/* The lines and arcs of the path of a disc. */
WW_API ww_status ww_path_pieces(const ww_path* path, ww_path_piece* pieces, size_t capacity, size_t* count);
/* The edges that the path crosses, if the query has asked for them. */
WW_API ww_status ww_path_channel(const ww_path* path, ww_portal* portals, size_t capacity, size_t* count);
/* The items that block an end. */
WW_API ww_status ww_path_blockers(const ww_path* path, ww_id* items, size_t capacity, size_t* count);
/* The largest disc that gets through, if there is no path for the disc of the query. If there is no such answer, the
   function sets is_connected to 0. */
WW_API ww_status ww_path_widest(const ww_path* path, ww_widest_path* widest, ww_id* from_items, size_t from_capacity,
                                size_t* from_count, ww_id* to_items, size_t to_capacity, size_t* to_count);

typedef int32_t ww_precision;
enum { WW_FLOAT64 = 0, WW_FLOAT32 = 1 };

/* A position on a path. */
typedef struct ww_path_position {
  uint32_t struct_size;
  ww_point at;
  ww_point heading; /* the direction of the path there, of length 1 */
  size_t segment;   /* the position lies between the points `segment` and `segment` + 1, or on the piece `segment` */
  double before;    /* the length of the path from its start to the start of this segment */
  double distance;  /* the length of the path from its start to this position */
} ww_path_position;

/* The position at a distance from the start. Errors of these three functions: WW_INVALID_ARGUMENT, if the path is not
   found. */
WW_API ww_status ww_path_at(const ww_path* path, double distance, ww_precision precision, ww_path_position* position);
/* Moves a position of this path farther along the path by `step`. */
WW_API ww_status ww_path_advance(const ww_path* path, double step, ww_precision precision, ww_path_position* position);
/* The position on the path that is nearest to a point. */
WW_API ww_status ww_path_nearest(const ww_path* path, ww_point point, ww_precision precision,
                                 ww_path_position* position);
/* The path as points that are not farther than `tolerance` from it. */
WW_API ww_status ww_path_polyline(const ww_path* path, double tolerance, ww_point* points, size_t capacity,
                                  size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Searches in slices. Between the slices you may change the world. */

/* Starts a search. It cancels the search that is running. */
WW_API ww_status ww_search_begin(ww_search* search, const ww_world* world, const ww_path_query* query);
/* Continues the search until it has entered `expansions` further triangles. Sets *is_done. */
WW_API ww_status ww_search_step(ww_search* search, size_t expansions, ww_bool* is_done);
/* Sets *path to the answer, or to the best path so far. It belongs to the search, and is valid until the next call that
   changes the search. */
WW_API ww_status ww_search_path(const ww_search* search, const ww_path** path);
WW_API ww_status ww_search_restarts(const ww_search* search, size_t* restarts);
WW_API ww_status ww_search_cancel(ww_search* search);
WW_API ww_status ww_search_is_running(const ww_search* search, ww_bool* is_running);

/* ---------------------------------------------------------------------------------------------------------------------
   Following changes */

/* Whether a point agent can walk along a polyline, or straight from one point to another. */
WW_API ww_status ww_world_is_clear(const ww_world* world, const ww_point* points, size_t point_count,
                                   ww_context* context, ww_bool* is_clear);
WW_API ww_status ww_world_is_clear_between(const ww_world* world, ww_point from, ww_point to, ww_context* context,
                                           ww_bool* is_clear);
/* Whether an operation after version `since` has changed something near the polyline, or near the path. */
WW_API ww_status ww_world_is_affected(const ww_world* world, const ww_point* points, size_t point_count, uint64_t since,
                                      ww_bool* is_affected);
WW_API ww_status ww_world_is_path_affected(const ww_world* world, const ww_path* path, uint64_t since,
                                           ww_bool* is_affected);
/* The indices of the affected paths, ascending. */
WW_API ww_status ww_world_find_affected(const ww_world* world, const ww_path* const* paths, size_t path_count,
                                        uint64_t since, size_t* indices, size_t capacity, size_t* count);
/* The number of operations that the world has carried out. */
WW_API ww_status ww_world_version(const ww_world* world, uint64_t* version);

/* ---------------------------------------------------------------------------------------------------------------------
   Mesh, hashes, memory */

typedef struct ww_items_hash {
  uint64_t words[2];
} ww_items_hash;
typedef struct ww_mesh_hash {
  uint8_t bytes[32];
} ww_mesh_hash;

typedef struct ww_triangle {
  uint32_t vertices[3];
} ww_triangle;
typedef struct ww_constrained_edge {
  uint32_t vertices[2];
  uint32_t first_id; /* the index of the first id of the edge in the list of ids */
  uint32_t id_count;
} ww_constrained_edge;

WW_API ww_status ww_world_vertex_count(const ww_world* world, size_t* vertex_count);
WW_API ww_status ww_world_triangle_count(const ww_world* world, size_t* triangle_count);
/* Copies the mesh in canonical order. */
WW_API ww_status ww_world_snapshot(const ww_world* world, ww_context* context, ww_mesh* mesh);
WW_API ww_status ww_mesh_vertices(const ww_mesh* mesh, ww_point* vertices, size_t capacity, size_t* count);
WW_API ww_status ww_mesh_triangles(const ww_mesh* mesh, ww_triangle* triangles, size_t capacity, size_t* count);
WW_API ww_status ww_mesh_constrained_edges(const ww_mesh* mesh, ww_constrained_edge* edges, size_t capacity,
                                           size_t* count);
WW_API ww_status ww_mesh_ids(const ww_mesh* mesh, ww_id* ids, size_t capacity, size_t* count);
/* Writes the mesh as canonical text with exact coordinates. */
WW_API ww_status ww_world_dump(const ww_world* world, ww_text* text);
WW_API ww_status ww_world_items_hash(const ww_world* world, ww_items_hash* hash);
WW_API ww_status ww_world_mesh_hash(const ww_world* world, ww_mesh_hash* hash);
/* The hashes as 32 and 64 hexadecimal digits. */
WW_API ww_status ww_items_hash_text(const ww_items_hash* hash, char* buffer, size_t capacity, size_t* count);
WW_API ww_status ww_mesh_hash_text(const ww_mesh_hash* hash, char* buffer, size_t capacity, size_t* count);
/* Checks the whole world, exactly. `fault` receives the first fault as text, and may be null. */
WW_API ww_status ww_world_validate(const ww_world* world, ww_bool* is_valid, ww_text* fault);

/* The memory of a world in bytes. */
typedef struct ww_memory_use {
  uint32_t struct_size;
  size_t vertices;
  size_t crossings;
  size_t faces;
  size_t walls;
  size_t items;
  size_t sectors;
  size_t abstraction;
  size_t bridges;
  size_t spare;
  size_t total; /* the sum of all of them */
} ww_memory_use;

WW_API ww_status ww_world_memory(const ww_world* world, ww_memory_use* use);
WW_API ww_status ww_world_shrink_to_fit(ww_world* world);

/* The number of calls of one predicate, by the stage of the arithmetic that decided the call. */
typedef struct ww_stage_counts {
  uint64_t doubles;
  uint64_t lattice;
  uint64_t integers;
} ww_stage_counts;
typedef struct ww_predicate_counts {
  uint32_t struct_size;
  ww_stage_counts orientation;
  ww_stage_counts in_circle;
  ww_stage_counts order;
  ww_stage_counts crossing;
} ww_predicate_counts;

/* The counts of the calling thread since its start. */
WW_API ww_status ww_get_predicate_counts(ww_predicate_counts* counts);

/* ---------------------------------------------------------------------------------------------------------------------
   Scenes, scripts, scenarios. Texts are pointer and length; names are the names of the texts in error messages. */

typedef int32_t ww_scene_format;
enum { WW_SCENE_SCRIPT = 0, WW_SCENE_MOVINGAI = 1, WW_SCENE_TRIANGLE_POLY = 2, WW_SCENE_TRIANGLE_NODE = 3 };

typedef struct ww_scene_info {
  uint32_t struct_size;
  ww_bool y_down; /* whether the y axis of the file points down */
  ww_box domain;
  size_t item_count;
} ww_scene_info;

/* Finds the format for the ending of a file name. */
WW_API ww_status ww_scene_format_of(const char* file_name, ww_scene_format* format);
WW_API ww_status ww_scene_read(const char* file_name, ww_scene* scene);
WW_API ww_status ww_scene_parse_movingai_map(const char* text, size_t length, const char* name, ww_scene* scene);
/* `node_text` is null, or the text of the file .node of the same name. */
WW_API ww_status ww_scene_parse_triangle_poly(const char* text, size_t length, const char* name, const char* node_text,
                                              size_t node_length, const char* node_name, ww_scene* scene);
WW_API ww_status ww_scene_parse_triangle_node(const char* text, size_t length, const char* name, ww_scene* scene);
/* Sets a scene to a copy of a domain and items. */
WW_API ww_status ww_scene_set(ww_scene* scene, ww_box domain, const ww_items* items, ww_bool y_down);
WW_API ww_status ww_scene_get_info(const ww_scene* scene, ww_scene_info* info);
/* Sets *items to the items of the scene. They belong to the scene, and are valid until it changes. */
WW_API ww_status ww_scene_items(const ww_scene* scene, const ww_items** items);
/* Writes a scene as a world script. */
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
  WW_SCRIPT_CLEAR = 10
};

/* One line of a world script. ww_script_item gives the shape of an insertion or replacement, and the points of
   WW_SCRIPT_CLEAR. */
typedef struct ww_script_line {
  uint32_t struct_size;
  ww_script_line_kind kind;
  const char* word; /* the first word of the line; a text that lives as long as the process */
  uint32_t line;    /* the line in the text, from 1 */
  ww_bool has_radius;
  ww_bool has_algorithm;
  ww_bool has_end_tolerance;
  ww_bool has_goal;
  ww_path_algorithm algorithm;
  ww_id id;
  ww_point from;
  ww_point to;
  double radius;
  double end_tolerance;
} ww_script_line;

WW_API ww_status ww_script_parse(const char* text, size_t length, const char* name, ww_script* script);
WW_API ww_status ww_script_domain(const ww_script* script, ww_box* domain, uint32_t* line);
WW_API ww_status ww_script_line_count(const ww_script* script, size_t* count);
WW_API ww_status ww_script_get_line(const ww_script* script, size_t index, ww_script_line* line);
/* Sets `items` to the item of one line. */
WW_API ww_status ww_script_item(const ww_script* script, size_t index, ww_items* items);
/* Sets a scene to the items that are left after all changes of a script. */
WW_API ww_status ww_script_scene(const ww_script* script, ww_scene* scene);

typedef struct ww_scenario_query {
  uint32_t struct_size;
  uint32_t line;
  uint64_t width;
  uint64_t height;
  ww_point start;
  ww_point goal;
  double length;    /* negative if the author found no path */
  double precision; /* half a unit of the last digit of `length` */
} ww_scenario_query;

WW_API ww_status ww_scenario_parse(const char* text, size_t length, const char* name, ww_scenario* scenario);
WW_API ww_status ww_scenario_count(const ww_scenario* scenario, size_t* count);
/* Gives one query. The list is the file name of the map, a text. */
WW_API ww_status ww_scenario_get(const ww_scenario* scenario, size_t index, ww_scenario_query* query, char* map,
                                 size_t capacity, size_t* count);

/* ---------------------------------------------------------------------------------------------------------------------
   Pictures */

typedef int32_t ww_svg_theme;
enum { WW_SVG_AUTOMATIC = 0, WW_SVG_LIGHT = 1, WW_SVG_DARK = 2 };

typedef struct ww_svg_options {
  uint32_t struct_size;
  ww_svg_theme theme; /* WW_SVG_AUTOMATIC by default */
  double width;       /* 1200 pixels by default */
  ww_bool mesh;       /* 1 by default */
  ww_bool axes;       /* 1 by default */
  ww_bool ids;        /* 1 by default */
  ww_bool y_down;     /* 0 by default */
  ww_bool has_crop;   /* 0 by default: the picture shows the domain */
  ww_box crop;
  const char* title; /* null by default */
} ww_svg_options;

/* The transform between a world and its picture. */
typedef struct ww_svg_frame {
  uint32_t struct_size;
  ww_bool y_down;
  ww_box shown; /* what the picture shows, in the coordinates of the world */
  ww_box map;   /* the box of the map in the picture, in pixels */
  double scale; /* the pixels of one unit of length */
} ww_svg_frame;

WW_API ww_status ww_svg_options_init(ww_svg_options* options, size_t struct_size);
/* Writes a picture of the world as SVG. `overlay` and `options` may be null. */
WW_API ww_status ww_world_to_svg(const ww_world* world, const ww_svg_overlay* overlay, const ww_svg_options* options,
                                 ww_text* text);
WW_API ww_status ww_svg_get_frame(ww_box domain, const ww_svg_options* options, ww_svg_frame* frame);
WW_API ww_status ww_svg_to_picture(const ww_svg_frame* frame, ww_point point, ww_point* pixels);
WW_API ww_status ww_svg_to_world(const ww_svg_frame* frame, ww_point pixels, ww_point* point);

/* The overlay copies what you add. A colour is any CSS colour; null stands for the colour of the theme. A hint is the
   text on hover; null for none. */
WW_API ww_status ww_svg_overlay_clear(ww_svg_overlay* overlay);
WW_API ww_status ww_svg_add_path(ww_svg_overlay* overlay, const ww_path* path);
WW_API ww_status ww_svg_add_disc_path(ww_svg_overlay* overlay, const ww_path_query* query, const ww_path* path);
WW_API ww_status ww_svg_add_failed_path(ww_svg_overlay* overlay, ww_point start, ww_point goal, ww_path_status status);
WW_API ww_status ww_svg_add_ray(ww_svg_overlay* overlay, ww_point from, ww_point to, const ww_ray_hit* hit,
                                const ww_id* items, size_t item_count);
WW_API ww_status ww_svg_add_location(ww_svg_overlay* overlay, ww_point at, const ww_location* location,
                                     const ww_id* polygons, size_t polygon_count);
WW_API ww_status ww_svg_add_disc(ww_svg_overlay* overlay, ww_point centre, double radius, const char* colour,
                                 const char* hint);
WW_API ww_status ww_svg_add_polyline(ww_svg_overlay* overlay, const ww_point* points, size_t point_count, double width,
                                     ww_bool dashed, const char* colour, const char* hint);
/* Adds a text beside `at`. The text keeps a disc of `radius` around `at` free. `size` is in pixels, 14 is usual. */
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
