/* Tests copies of the mesh, hashes, memory, files and pictures. */
#include <stdlib.h>
#include <string.h>
#include <waywright.h>

#include "check.h"
#include "scene.h"
#include "tests.h"

void test_mesh(void) {
  ww_world* world = make_town(0);
  ww_context* context = NULL;
  ww_mesh* mesh = NULL;
  ww_text* text = NULL;
  ww_point vertices[16];
  ww_triangle triangles[32];
  ww_constrained_edge edges[16];
  ww_id ids[16];
  ww_mesh_hash hash;
  ww_items_hash items_hash;
  ww_memory_use use = {0};
  ww_predicate_counts counts = {0};
  char hex[65];
  ww_bool is_valid = 0;
  size_t vertex_count = 0, triangle_count = 0, count = 0;
  use.struct_size = sizeof use;
  counts.struct_size = sizeof counts;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_mesh_create(&mesh));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_world_vertex_count(world, &vertex_count));
  CHECK_OK(ww_world_triangle_count(world, &triangle_count));
  CHECK(vertex_count == 8 && triangle_count == 10); /* Euler: 2 * 8 - 2 - 4 border vertices */
  CHECK_OK(ww_world_snapshot(world, context, mesh));
  CHECK_OK(ww_mesh_vertices(mesh, vertices, 16, &count));
  CHECK(count == 8 && is_at(vertices[0], 0, 0) && is_at(vertices[7], 100, 100));
  CHECK_OK(ww_mesh_triangles(mesh, triangles, 32, &count));
  CHECK(count == 10 && triangles[0].vertices[0] == 0);
  CHECK_OK(ww_mesh_constrained_edges(mesh, edges, 16, &count));
  CHECK(count == 8 && edges[0].vertices[0] == 0 && edges[0].id_count == 1);
  CHECK_OK(ww_mesh_ids(mesh, ids, 16, &count));
  CHECK(count == 8 && ids[edges[0].first_id] == 0);
  CHECK_OK(ww_world_dump(world, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &count));
  CHECK(count > 100);
  CHECK_OK(ww_world_mesh_hash(world, &hash));
  CHECK_STATUS(ww_mesh_hash_text(&hash, hex, 64, &count), WW_BUFFER_TOO_SMALL);
  CHECK(count == 65);
  CHECK_OK(ww_mesh_hash_text(&hash, hex, 65, &count));
  CHECK(strlen(hex) == 64);
  CHECK_OK(ww_world_items_hash(world, &items_hash));
  CHECK_OK(ww_items_hash_text(&items_hash, hex, 65, &count));
  CHECK(strlen(hex) == 32 && count == 33);
  CHECK_OK(ww_world_validate(world, &is_valid, text));
  CHECK(is_valid == 1);
  CHECK_OK(ww_text_read(text, hex, 65, &count));
  CHECK(count == 1 && hex[0] == '\0');
  CHECK_OK(ww_world_memory(world, &use));
  CHECK(use.vertices > 0 && use.faces > 0 && use.bridges == 0);
  CHECK(use.total == use.vertices + use.crossings + use.faces + use.walls + use.items + use.sectors + use.abstraction +
                         use.bridges + use.history + use.spare);
  count = use.total;
  CHECK_OK(ww_world_shrink_to_fit(world));
  CHECK_OK(ww_world_memory(world, &use));
  CHECK(use.total <= count);
  CHECK_OK(ww_get_predicate_counts(&counts));
  CHECK(counts.orientation.doubles > 0);
  ww_text_destroy(text);
  ww_mesh_destroy(mesh);
  ww_context_destroy(context);
  ww_world_destroy(world);
}

void test_scenes(void) {
  static const char map[] = "type octile\nheight 2\nwidth 3\nmap\n..@\n..@\n";
  static const char node[] = "2 2 0 0\n1 1 2\n2 3 4\n";
  static const char poly[] = "0 2 0 0\n1 0\n1 1 2\n0\n";
  static const char scenario_text[] = "version 1\n0\tfolder/arena.map\t49\t40\t1\t11\t2\t12\t1.41\n";
  ww_scene* scene = NULL;
  ww_script* script = NULL;
  ww_scenario* scenario = NULL;
  ww_text* text = NULL;
  ww_world* world = NULL;
  const ww_items* items = NULL;
  ww_scene_info info = {0};
  ww_scenario_query query = {0};
  ww_scene_format format = -1;
  ww_error error = {0};
  char buffer[256];
  size_t count = 0;
  info.struct_size = sizeof info;
  query.struct_size = sizeof query;
  error.struct_size = sizeof error;
  CHECK_OK(ww_scene_create(&scene));
  CHECK_OK(ww_script_create(&script));
  CHECK_OK(ww_scenario_create(&scenario));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_scene_format_of("a.poly", &format));
  CHECK(format == WW_SCENE_TRIANGLE_POLY);
  CHECK_STATUS(ww_scene_format_of("a.png", &format), WW_NOT_SUPPORTED);
  CHECK_OK(ww_scene_parse_movingai_map(map, sizeof map - 1, "small.map", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 1 && info.item_count == 1 && is_at(info.domain.max, 3, 2));
  CHECK_OK(ww_scene_items(scene, &items));
  CHECK_OK(ww_world_create(info.domain, NULL, &world));
  CHECK_OK(ww_world_insert_all(world, items, NULL, NULL));
  CHECK_OK(ww_scene_to_script(scene, text));
  CHECK_OK(ww_text_read(text, buffer, sizeof buffer, &count));
  CHECK(strncmp(buffer, "waywright 1\n", 12) == 0);
  CHECK_OK(ww_script_parse(buffer, count - 1, "again", script));
  CHECK_OK(ww_script_scene(script, scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 0 && info.item_count == 1);
  CHECK_OK(ww_scene_parse_triangle_node(node, sizeof node - 1, "a.node", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.item_count == 2);
  CHECK_OK(ww_scene_parse_triangle_poly(poly, sizeof poly - 1, "a.poly", node, sizeof node - 1, "a.node", scene));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.item_count == 1);
  CHECK_OK(ww_scene_set(scene, box(0, 0, 5, 5), items, 1));
  CHECK_OK(ww_scene_get_info(scene, &info));
  CHECK(info.y_down == 1 && is_at(info.domain.max, 5, 5));
  CHECK_STATUS(ww_scene_read("/no/such/file.wws", scene), WW_UNREADABLE);
  CHECK_STATUS(ww_script_parse("waywright 1\nfly\n", 16, "bad.wws", script), WW_MALFORMED);
  CHECK_OK(ww_last_error(&error));
  CHECK(error.status == WW_MALFORMED && error.index == 2);
  CHECK_OK(ww_last_error_message(buffer, sizeof buffer, NULL));
  CHECK(strncmp(buffer, "bad.wws:2: ", 11) == 0);

  CHECK_OK(ww_scenario_parse(scenario_text, sizeof scenario_text - 1, "a.scen", scenario));
  CHECK_OK(ww_scenario_count(scenario, &count));
  CHECK(count == 1);
  CHECK_OK(ww_scenario_get(scenario, 0, &query, buffer, sizeof buffer, &count));
  CHECK(strcmp(buffer, "folder/arena.map") == 0 && count == 17 && query.width == 49 && query.height == 40);
  CHECK(query.line == 2 && query.length == 1.41 && is_near(query.precision, 0.005));
  ww_world_destroy(world);
  ww_text_destroy(text);
  ww_scenario_destroy(scenario);
  ww_script_destroy(script);
  ww_scene_destroy(scene);
}

static int contains(const char* text, const char* part) { return strstr(text, part) != NULL; }

void test_pictures(void) {
  static const ww_point line[] = {{5, 5}, {9, 8}, {5, 11}};
  ww_world* world = make_town(1);
  ww_context* context = NULL;
  ww_path* path = NULL;
  ww_text* text = NULL;
  ww_svg_overlay* overlay = NULL;
  ww_svg_options options;
  ww_svg_frame frame = {0};
  ww_path_query query;
  ww_ray_hit hit = {0};
  ww_location location = {0};
  ww_point pixels, back;
  ww_id ids[4];
  char* svg = NULL;
  size_t size = 0, count = 0;
  hit.struct_size = sizeof hit;
  location.struct_size = sizeof location;
  frame.struct_size = sizeof frame;
  CHECK_OK(ww_context_create(&context));
  CHECK_OK(ww_path_create(&path));
  CHECK_OK(ww_text_create(&text));
  CHECK_OK(ww_svg_overlay_create(&overlay));
  CHECK_OK(ww_path_query_init(&query, sizeof query));
  query.start = at(10, 55);
  query.goal = at(90, 55);
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_svg_add_path(overlay, path));
  query.agent.radius = 5;
  CHECK_OK(ww_world_find_path(world, &query, context, path));
  CHECK_OK(ww_svg_add_disc_path(overlay, &query, path));
  CHECK_OK(ww_world_ray(world, at(10, 50), at(90, 50), NULL, context, &hit, ids, 4, &count));
  CHECK_OK(ww_svg_add_ray(overlay, at(10, 50), at(90, 50), &hit, ids, count));
  CHECK_OK(ww_world_locate(world, at(50, 50), context, &location, ids, 4, &count));
  CHECK_OK(ww_svg_add_location(overlay, at(50, 50), &location, ids, count));
  CHECK_OK(ww_svg_add_failed_path(overlay, at(10, 10), at(50, 50), WW_PATH_GOAL_BLOCKED));
  CHECK_OK(ww_svg_add_disc(overlay, at(20, 20), 2, "#d55e00", "Archers in C"));
  CHECK_OK(ww_svg_add_polyline(overlay, line, 3, 4, 1, NULL, NULL));
  CHECK_OK(ww_svg_add_label(overlay, at(20, 20), "a label in C", 2, 14, NULL));
  CHECK_OK(ww_svg_add_key(overlay, "a key in C", "red"));
  CHECK_OK(ww_svg_add_elements(overlay, "<circle cx=\"3\" cy=\"4\" r=\"2\"/>"));
  CHECK_OK(ww_svg_options_init(&options, sizeof options));
  CHECK(options.width == 1200 && options.mesh == 1 && options.has_crop == 0);
  options.title = "a title in C";
  CHECK_OK(ww_world_to_svg(world, overlay, &options, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &size));
  svg = malloc(size);
  CHECK_OK(ww_text_read(text, svg, size, &count));
  CHECK(count == size && strlen(svg) + 1 == size);
  CHECK(contains(svg, "<svg") && contains(svg, "a title in C") && contains(svg, "Archers in C"));
  CHECK(contains(svg, "a label in C") && contains(svg, "a key in C") && contains(svg, "cx=\"3\" cy=\"4\""));
  CHECK(contains(svg, "path of a disc, radius 5") && contains(svg, "ray from"));
  free(svg);
  CHECK_OK(ww_svg_overlay_clear(overlay));
  CHECK_OK(ww_world_to_svg(world, NULL, NULL, text));
  CHECK_OK(ww_text_read(text, NULL, 0, &count));
  CHECK(count < size);
  CHECK_OK(ww_svg_get_frame(box(0, 0, 100, 100), &options, &frame));
  CHECK_OK(ww_svg_to_picture(&frame, at(25, 75), &pixels));
  CHECK(is_near(pixels.x, frame.map.min.x + 25 * frame.scale) && is_near(pixels.y, frame.map.min.y + 25 * frame.scale));
  CHECK_OK(ww_svg_to_world(&frame, pixels, &back));
  CHECK(is_near(back.x, 25) && is_near(back.y, 75));
  options.has_crop = 1;
  options.crop = box(5, 5, 5, 5);
  CHECK_STATUS(ww_world_to_svg(world, NULL, &options, text), WW_BAD_DOMAIN);
  ww_svg_overlay_destroy(overlay);
  ww_text_destroy(text);
  ww_path_destroy(path);
  ww_context_destroy(context);
  ww_world_destroy(world);
}
