/* usage: run_script SCRIPT
   Carries out a world script, one function of waywright.h for each line, and prints the answers of `waywright run`: the
   same objects, numbers with 17 digits. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

typedef struct Run {
  ww_world* world;
  ww_context* context;
  ww_items* items; /* the item of the current line */
  ww_path* path;
  ww_text* text;
  ww_point* points; /* the points of the item */
  size_t point_count;
  size_t* ring_sizes;
  size_t ring_count;
  ww_id* ids; /* the list of the current answer */
  size_t id_count;
  size_t id_capacity;
} Run;

static void stop(const char* what) {
  char message[512] = "";
  ww_last_error_message(message, sizeof message, NULL);
  fprintf(stderr, "run_script: %s: %s\n", what, message);
  exit(2);
}

static void must(ww_status status, const char* what) {
  if (status != WW_OK) stop(what);
}

static void* grow(void* old, size_t count, size_t size) {
  void* const memory = realloc(old, (count + 1) * size);
  if (memory == NULL) stop("no memory");
  return memory;
}

/* Makes room for a list of ids that did not fit. Returns 1 if the call must be repeated. */
static int must_repeat(Run* run, ww_status status) {
  if ((status != WW_OK && status != WW_BUFFER_TOO_SMALL) || run->id_count <= run->id_capacity) return 0;
  run->ids = grow(run->ids, run->id_count, sizeof *run->ids);
  run->id_capacity = run->id_count;
  return 1;
}

static char* read_file(const char* name, size_t* size) {
  FILE* const file = fopen(name, "rb");
  char* text = NULL;
  size_t capacity = 0, done = 0;
  if (file == NULL) stop("cannot open the script");
  do {
    *size += done;
    capacity = *size + 65536;
    text = grow(text, capacity, 1);
    done = fread(text + *size, 1, 65536, file);
  } while (done > 0);
  fclose(file);
  return text;
}

static void print_string(const char* text) {
  putchar('"');
  for (; *text != '\0'; ++text) {
    if (*text == '"' || *text == '\\') putchar('\\');
    putchar(*text);
  }
  putchar('"');
}

static void print_point(ww_point point) { printf("%.17g,%.17g", point.x, point.y); }

static void print_ids(const char* name, const ww_id* ids, size_t count) {
  size_t i;
  printf(",\"%s\":[", name);
  for (i = 0; i < count; ++i) printf("%s%llu", i == 0 ? "" : ",", (unsigned long long)ids[i]);
  putchar(']');
}

static void print_opening(const ww_script_line* line) {
  printf("{\"line\":%lu,\"op\":\"%s\"", (unsigned long)line->line, line->word);
}

/* Prints an error, if there is one. Returns 1 if there is none. */
static int is_done(const ww_script_line* line, ww_status status) {
  char message[512] = "";
  if (status == WW_OK) return 1;
  if (status < 0) stop("a call failed");
  ww_last_error_message(message, sizeof message, NULL);
  print_opening(line);
  printf(",\"error\":\"%s\",\"message\":", ww_status_name(status));
  print_string(message);
  puts("}");
  return 0;
}

static ww_shape shape_of_line(Run* run) {
  ww_shape shape;
  ww_item_info info;
  info.struct_size = sizeof info;
  must(ww_items_get_info(run->items, 0, &info), "ww_items_get_info");
  run->points = grow(run->points, info.point_count, sizeof *run->points);
  run->ring_sizes = grow(run->ring_sizes, info.ring_count, sizeof *run->ring_sizes);
  must(ww_items_points(run->items, 0, run->points, info.point_count, &run->point_count), "ww_items_points");
  must(ww_items_ring_sizes(run->items, 0, run->ring_sizes, info.ring_count, &run->ring_count), "ww_items_ring_sizes");
  must(ww_shape_init(&shape, sizeof shape), "ww_shape_init");
  shape.kind = info.kind;
  shape.fill = info.fill;
  shape.points = run->points;
  shape.point_count = run->point_count;
  shape.ring_sizes = run->ring_sizes;
  shape.ring_count = run->ring_count;
  return shape;
}

static void locate(Run* run, const ww_script_line* line) {
  ww_location location;
  ww_status status;
  size_t i;
  location.struct_size = sizeof location;
  do {
    status =
        ww_world_locate(run->world, line->from, run->context, &location, run->ids, run->id_capacity, &run->id_count);
  } while (must_repeat(run, status));
  if (!is_done(line, status)) return;
  print_opening(line);
  printf(",\"at\":\"%s\",\"vertices\":[", ww_location_kind_name(location.kind));
  for (i = 0; i < location.vertex_count; ++i) {
    printf("%s[", i == 0 ? "" : ",");
    print_point(location.vertices[i]);
    putchar(']');
  }
  putchar(']');
  print_ids("inside", run->ids, run->id_count);
  puts("}");
}

static void cast_ray(Run* run, const ww_script_line* line) {
  ww_ray_hit hit;
  ww_status status;
  hit.struct_size = sizeof hit;
  do {
    status = ww_world_ray(run->world, line->from, line->to, &line->agent, run->context, &hit, run->ids,
                          run->id_capacity, &run->id_count);
  } while (must_repeat(run, status));
  if (!is_done(line, status)) return;
  print_opening(line);
  printf(",\"hit\":%s", hit.hit ? "true" : "false");
  if (hit.hit) {
    printf(",\"at\":[");
    print_point(hit.at);
    if (line->has_radius) {
      printf("],\"contact\":[");
      print_point(hit.contact);
    }
    putchar(']');
    print_ids("items", run->ids, run->id_count);
  }
  puts("}");
}

static void fit_disc(Run* run, const ww_script_line* line) {
  ww_bool fits = 0;
  ww_status status;
  do {
    status = ww_world_fit_disc(run->world, line->from, &line->agent, run->context, &fits, run->ids, run->id_capacity,
                               &run->id_count);
  } while (must_repeat(run, status));
  if (!is_done(line, status)) return;
  print_opening(line);
  printf(",\"free\":%s", fits ? "true" : "false");
  print_ids("items", run->ids, run->id_count);
  puts("}");
}

static void find_nearest_fit(Run* run, const ww_script_line* line) {
  ww_nearest_fit_query query;
  ww_nearest_fit fit;
  fit.struct_size = sizeof fit;
  must(ww_nearest_fit_query_init(&query, sizeof query), "ww_nearest_fit_query_init");
  query.point = line->from;
  query.agent = line->agent;
  query.has_goal = line->has_goal;
  query.goal = line->to;
  if (!is_done(line, ww_world_nearest_fit(run->world, &query, run->context, &fit))) return;
  print_opening(line);
  printf(",\"found\":%s", fit.is_found ? "true" : "false");
  if (fit.is_found) {
    printf(",\"at\":[");
    print_point(fit.at);
    putchar(']');
  }
  puts("}");
}

static int compare_ids(const void* a, const void* b) {
  const ww_id x = *(const ww_id*)a, y = *(const ww_id*)b;
  return x < y ? -1 : x > y;
}

static void print_widest(Run* run) {
  ww_widest_path widest;
  size_t from_count = 0, to_count = 0, i, kept = 0;
  widest.struct_size = sizeof widest;
  must(ww_path_widest(run->path, &widest, NULL, 0, &from_count, NULL, 0, &to_count), "ww_path_widest");
  if (!widest.is_limited) return;
  run->ids = grow(run->ids, from_count + to_count, sizeof *run->ids);
  run->id_capacity = from_count + to_count;
  must(ww_path_widest(run->path, &widest, run->ids, from_count, NULL, run->ids + from_count, to_count, NULL),
       "ww_path_widest");
  qsort(run->ids, from_count + to_count, sizeof *run->ids, compare_ids);
  for (i = 0; i < from_count + to_count; ++i) {
    if (kept == 0 || run->ids[kept - 1] != run->ids[i]) run->ids[kept++] = run->ids[i];
  }
  printf(",\"widest\":{\"radius\":%.17g,\"gap\":[[", widest.radius);
  print_point(widest.from);
  printf("],[");
  print_point(widest.to);
  printf("]]");
  print_ids("items", run->ids, kept);
  putchar('}');
}

static void print_pieces(Run* run, const ww_path_info* info) {
  ww_path_piece* const pieces = grow(NULL, info->piece_count, sizeof *pieces);
  size_t i;
  run->points = grow(run->points, info->point_count, sizeof *run->points);
  must(ww_path_points(run->path, run->points, info->point_count, NULL), "ww_path_points");
  must(ww_path_pieces(run->path, pieces, info->piece_count, NULL), "ww_path_pieces");
  for (i = 1; i < info->point_count; ++i) {
    printf("%s{\"line\":[", i == 1 ? "" : ",");
    print_point(run->points[i - 1]);
    putchar(',');
    print_point(run->points[i]);
    printf("]}");
  }
  for (i = 0; i < info->piece_count && info->length > 0; ++i) {
    printf("%s{\"%s\":[", i == 0 ? "" : ",", pieces[i].kind == WW_PIECE_LINE ? "line" : "arc");
    if (pieces[i].kind == WW_PIECE_LINE) {
      print_point(pieces[i].from);
      putchar(',');
      print_point(pieces[i].to);
    } else {
      print_point(pieces[i].centre);
      printf(",%.17g,%.17g,%.17g", pieces[i].radius, pieces[i].start_angle, pieces[i].end_angle);
    }
    printf("]}");
  }
  free(pieces);
}

static void print_moved(const char* name, ww_bool has, ww_point from, ww_point to) {
  if (!has) return;
  printf(",\"%s\":[[", name);
  print_point(from);
  printf("],[");
  print_point(to);
  printf("]]");
}

static void find_path(Run* run, const ww_script_line* line) {
  ww_path_query query;
  ww_path_info info;
  info.struct_size = sizeof info;
  must(ww_path_query_init(&query, sizeof query), "ww_path_query_init");
  query.start = line->from;
  query.goal = line->to;
  query.agent = line->agent;
  if (line->has_algorithm) query.algorithm = line->algorithm;
  query.has_end_tolerance = line->has_end_tolerance;
  query.end_tolerance = line->end_tolerance;
  if (!is_done(line, ww_world_find_path(run->world, &query, run->context, run->path))) return;
  must(ww_path_get_info(run->path, &info), "ww_path_get_info");
  print_opening(line);
  if (info.status == WW_PATH_FOUND) {
    printf(",\"found\":true,\"length\":%.17g,\"pieces\":[", info.length);
    print_pieces(run, &info);
    putchar(']');
    print_moved("moved_start", info.has_moved_start, info.moved_start.from, info.moved_start.to);
    print_moved("moved_goal", info.has_moved_goal, info.moved_goal.from, info.moved_goal.to);
  } else {
    printf(",\"found\":false,\"reason\":\"%s\"", ww_path_status_name(info.status));
    if (info.status != WW_PATH_NO_PATH) {
      run->ids = grow(run->ids, info.blocker_count, sizeof *run->ids);
      run->id_capacity = info.blocker_count;
      must(ww_path_blockers(run->path, run->ids, run->id_capacity, &run->id_count), "ww_path_blockers");
      print_ids("items", run->ids, run->id_count);
    }
    if (info.has_widest) print_widest(run);
  }
  puts("}");
}

static void test_clear(Run* run, const ww_script_line* line) {
  ww_bool is_clear = 0;
  shape_of_line(run);
  if (!is_done(line, ww_world_is_clear(run->world, run->points, run->point_count, NULL, run->context, &is_clear)))
    return;
  print_opening(line);
  printf(",\"clear\":%s}\n", is_clear ? "true" : "false");
}

static void check_world(Run* run, const ww_script_line* line) {
  char fault[512] = "";
  ww_bool is_valid = 0;
  must(ww_world_validate(run->world, &is_valid, run->text), "ww_world_validate");
  print_opening(line);
  printf(",\"ok\":%s", is_valid ? "true" : "false");
  if (!is_valid) {
    ww_text_read(run->text, fault, sizeof fault, NULL);
    printf(",\"fault\":");
    print_string(fault);
  }
  puts("}");
}

static void print_hashes(Run* run, const ww_script_line* line) {
  ww_items_hash items;
  ww_mesh_hash mesh;
  char items_text[33], mesh_text[65];
  must(ww_world_items_hash(run->world, &items), "ww_world_items_hash");
  must(ww_world_mesh_hash(run->world, &mesh), "ww_world_mesh_hash");
  must(ww_items_hash_text(&items, items_text, sizeof items_text, NULL), "ww_items_hash_text");
  must(ww_mesh_hash_text(&mesh, mesh_text, sizeof mesh_text, NULL), "ww_mesh_hash_text");
  print_opening(line);
  printf(",\"items\":\"%s\",\"mesh\":\"%s\"}\n", items_text, mesh_text);
}

static void compare_hash(Run* run, const ww_script_line* line) {
  ww_items_hash computed;
  char expected_text[33], computed_text[33];
  must(ww_world_items_hash(run->world, &computed), "ww_world_items_hash");
  if (!line->has_items_hash || memcmp(&computed, &line->items_hash, sizeof computed) == 0) return;
  must(ww_items_hash_text(&line->items_hash, expected_text, sizeof expected_text, NULL), "ww_items_hash_text");
  must(ww_items_hash_text(&computed, computed_text, sizeof computed_text, NULL), "ww_items_hash_text");
  print_opening(line);
  printf(",\"tick\":%llu,\"same\":false,\"expected\":\"%s\",\"computed\":\"%s\"}\n", (unsigned long long)line->tick,
         expected_text, computed_text);
}

static void carry_out(Run* run, const ww_script_line* line) {
  ww_shape shape;
  switch (line->kind) {
    case WW_SCRIPT_INSERT:
      shape = shape_of_line(run);
      is_done(line, ww_world_insert(run->world, &shape, line->id, NULL));
      break;
    case WW_SCRIPT_REMOVE:
      is_done(line, ww_world_remove(run->world, line->id));
      break;
    case WW_SCRIPT_REPLACE:
      shape = shape_of_line(run);
      is_done(line, ww_world_replace(run->world, line->id, &shape));
      break;
    case WW_SCRIPT_LOCATE:
      locate(run, line);
      break;
    case WW_SCRIPT_RAY:
      cast_ray(run, line);
      break;
    case WW_SCRIPT_DISC:
      fit_disc(run, line);
      break;
    case WW_SCRIPT_NEAREST:
      find_nearest_fit(run, line);
      break;
    case WW_SCRIPT_PATH:
      find_path(run, line);
      break;
    case WW_SCRIPT_CLEAR:
      test_clear(run, line);
      break;
    case WW_SCRIPT_CHECK:
      check_world(run, line);
      break;
    case WW_SCRIPT_HASH:
      print_hashes(run, line);
      break;
    case WW_SCRIPT_TICK:
      compare_hash(run, line);
      break;
    case WW_SCRIPT_MARK:
      must(ww_world_mark(run->world, NULL), "ww_world_mark");
      break;
    case WW_SCRIPT_REWIND:
      is_done(line, ww_world_rewind(run->world, line->tick));
      break;
    default:
      stop("a line of an unknown kind");
  }
}

static ww_script_line line_at(const ww_script* script, size_t index) {
  ww_script_line line;
  line.struct_size = sizeof line;
  must(ww_script_get_line(script, index, &line), "ww_script_get_line");
  return line;
}

int main(int argc, char** argv) {
  Run run;
  ww_script* script = NULL;
  ww_world_options options;
  ww_box domain;
  size_t size = 0, count = 0, i;
  char* text;
  if (argc != 2) return 2;
  memset(&run, 0, sizeof run);
  must(ww_script_create(&script), "ww_script_create");
  must(ww_context_create(&run.context), "ww_context_create");
  must(ww_items_create(&run.items), "ww_items_create");
  must(ww_path_create(&run.path), "ww_path_create");
  must(ww_text_create(&run.text), "ww_text_create");
  text = read_file(argv[1], &size);
  must(ww_script_parse(text, size, argv[1], script), "ww_script_parse");
  must(ww_script_domain(script, &domain, NULL), "ww_script_domain");
  must(ww_script_line_count(script, &count), "ww_script_line_count");
  must(ww_world_options_init(&options, sizeof options), "ww_world_options_init");
  for (i = 0; i < count; ++i) { /* the same condition as in the command */
    const ww_script_line line = line_at(script, i);
    if ((line.kind == WW_SCRIPT_PATH || line.has_goal) && line.agent.radius > 0) options.keep_bridges = 1;
  }
  must(ww_world_create(domain, &options, &run.world), "ww_world_create");
  must(ww_world_keep_history(run.world, count), "ww_world_keep_history");
  for (i = 0; i < count; ++i) {
    const ww_script_line line = line_at(script, i);
    must(ww_script_item(script, i, run.items), "ww_script_item");
    carry_out(&run, &line);
  }
  free(text);
  free(run.points);
  free(run.ring_sizes);
  free(run.ids);
  ww_world_destroy(run.world);
  ww_text_destroy(run.text);
  ww_path_destroy(run.path);
  ww_items_destroy(run.items);
  ww_context_destroy(run.context);
  ww_script_destroy(script);
  return 0;
}
