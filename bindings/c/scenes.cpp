#include <string>
#include <utility>

#include "internal.hpp"
#include "structs.hpp"

namespace waywright::c {

namespace {

/// Moves the value of a result into an object of the caller, or records the error.
template <class T>
ww_status keep(Result<T> result, T& kept) {
  if (!result.ok()) return fail(result.error());
  kept = std::move(*result);
  return WW_OK;
}

const ScriptLine& line_at(const ww_script* script, std::size_t index) {
  const std::vector<ScriptLine>& lines = object(script).lines;
  require(index < lines.size(), "a script has no line of this index");
  return lines[index];
}

}  // namespace

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_scene_format_of(const char* file_name, ww_scene_format* format) {
  return guarded([&] {
    ww_scene_format& out = answer(format);
    const Result<SceneFormat> found = scene_format(to_view(file_name));
    if (found.ok()) out = static_cast<ww_scene_format>(*found);
    return status_of(found);
  });
}

ww_status ww_scene_read(const char* file_name, ww_scene* scene) {
  return guarded([&] { return keep(read_scene(std::string(to_view(file_name))), object(scene)); });
}

ww_status ww_scene_parse_movingai_map(const char* text, size_t length, const char* name, ww_scene* scene) {
  return guarded([&] { return keep(parse_movingai_map(to_view(text, length), to_view(name)), object(scene)); });
}

ww_status ww_scene_parse_triangle_poly(const char* text, size_t length, const char* name, const char* node_text,
                                       size_t node_length, const char* node_name, ww_scene* scene) {
  return guarded([&] {
    return keep(parse_triangle_poly(to_view(text, length), to_view(name), to_view(node_text, node_length),
                                    text_or_empty(node_name)),
                object(scene));
  });
}

ww_status ww_scene_parse_triangle_node(const char* text, size_t length, const char* name, ww_scene* scene) {
  return guarded([&] { return keep(parse_triangle_node(to_view(text, length), to_view(name)), object(scene)); });
}

ww_status ww_scene_parse_saved_world(const void* bytes, size_t size, const char* name, ww_scene* scene) {
  return guarded([&] {
    return keep(parse_saved_world(to_view(static_cast<const char*>(bytes), size), to_view(name)), object(scene));
  });
}

ww_status ww_scene_set(ww_scene* scene, ww_box domain, const ww_items* items, ww_bool y_down) {
  return guarded([&] {
    Scene& kept = object(scene);
    kept = Scene{to_cpp(domain), object(items), is_set(y_down)};
    return WW_OK;
  });
}

ww_status ww_scene_get_info(const ww_scene* scene, ww_scene_info* info) {
  return guarded([&] {
    const StructOut out(info);
    const Scene& given = object(scene);
    out.write({0, to_c(given.y_down), to_c(given.domain), given.items.size()});
    return WW_OK;
  });
}

ww_status ww_scene_items(const ww_scene* scene, const ww_items** items) {
  return guarded([&] {
    answer(items) = opaque<ww_items>(&object(scene).items);
    return WW_OK;
  });
}

ww_status ww_scene_to_script(const ww_scene* scene, ww_text* text) {
  return guarded([&] {
    object(text) = to_script(object(scene));
    return WW_OK;
  });
}

ww_status ww_script_parse(const char* text, size_t length, const char* name, ww_script* script) {
  return guarded([&] { return keep(parse_script(to_view(text, length), to_view(name)), object(script)); });
}

ww_status ww_script_domain(const ww_script* script, ww_box* domain, uint32_t* line) {
  return guarded([&] {
    const Script& given = object(script);
    answer(domain) = to_c(given.domain);
    write_if_wanted(line, given.domain_line);
    return WW_OK;
  });
}

ww_status ww_script_line_count(const ww_script* script, size_t* count) {
  return guarded([&] {
    answer(count) = object(script).lines.size();
    return WW_OK;
  });
}

ww_status ww_script_get_line(const ww_script* script, size_t index, ww_script_line* line) {
  return guarded([&] {
    const StructOut out(line);
    const ScriptLine& given = line_at(script, index);
    ww_script_line result{};
    result.kind = static_cast<ww_script_line_kind>(given.kind);
    result.word = to_string(given).data();
    result.line = given.line;
    result.has_radius = to_c(given.has_radius);
    result.has_algorithm = to_c(given.algorithm.has_value());
    result.has_end_tolerance = to_c(given.end_tolerance.has_value());
    result.has_goal = to_c(given.has_goal);
    result.algorithm = static_cast<ww_path_algorithm>(given.algorithm.value_or(PathAlgorithm::optimal));
    result.id = given.item.id.value;
    result.from = to_c(given.from);
    result.to = to_c(given.to);
    result.agent = to_c(given.agent);
    result.end_tolerance = given.end_tolerance.value_or(0.0);
    result.has_items_hash = to_c(given.items_hash.has_value());
    result.tick = given.tick;
    result.items_hash = to_c(given.items_hash.value_or(ItemsHash{}));
    out.write(result);
    return WW_OK;
  });
}

ww_status ww_script_item(const ww_script* script, size_t index, ww_items* items) {
  return guarded([&] {
    std::vector<Item>& list = object(items);
    std::vector<Item> copy{line_at(script, index).item};
    list = std::move(copy);
    return WW_OK;
  });
}

ww_status ww_script_scene(const ww_script* script, ww_scene* scene) {
  return guarded([&] {
    object(scene) = scene_of(object(script));
    return WW_OK;
  });
}

ww_status ww_scenario_parse(const char* text, size_t length, const char* name, ww_scenario* scenario) {
  return guarded([&] { return keep(parse_movingai_scenario(to_view(text, length), to_view(name)), object(scenario)); });
}

ww_status ww_scenario_count(const ww_scenario* scenario, size_t* count) {
  return guarded([&] {
    answer(count) = object(scenario).size();
    return WW_OK;
  });
}

ww_status ww_scenario_get(const ww_scenario* scenario, size_t index, ww_scenario_query* query, char* map,
                          size_t capacity, size_t* count) {
  return guarded([&] {
    const StructOut out(query);
    const std::vector<ScenarioQuery>& queries = object(scenario);
    require(index < queries.size(), "a scenario has no query of this index");
    const ScenarioQuery& given = queries[index];
    out.write(to_c(given));
    return write_text(given.map, map, capacity, count);
  });
}
