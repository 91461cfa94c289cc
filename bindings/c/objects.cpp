#include <memory>
#include <utility>

#include "internal.hpp"

namespace waywright::c {

namespace {

template <class Opaque>
ww_status create(Opaque** out) noexcept {
  return guarded([&] { return make_object(out); });
}

const Item& item_at(const ww_items* items, std::size_t index) {
  const std::vector<Item>& list = object(items);
  require(index < list.size(), "a list of items has no item of this index");
  return list[index];
}

}  // namespace

Shape to_shape(const ww_shape* given) {
  const ww_shape shape = read_struct(given, {});
  const PointSpan points = to_points(shape.points, shape.point_count);
  Shape result;
  result.kind = to_enum(shape.kind, ItemKind::polygon);
  result.fill = to_enum(shape.fill, FillRule::nonzero);
  result.rings.reserve(points.size());
  if (shape.ring_sizes == nullptr) {
    result.rings.push_back(points);
    return result;
  }
  std::size_t done = 0;
  for (const std::size_t size : to_span(shape.ring_sizes, shape.ring_count)) {
    require(size <= points.size() - done, "the ring sizes of a shape add up to more than its number of points");
    result.rings.push_back(PointSpan(points.subspan(done, size)));
    done += size;
  }
  require(done == points.size(), "the ring sizes of a shape add up to less than its number of points");
  return result;
}

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_context_create(ww_context** context) { return create(context); }
void ww_context_destroy(ww_context* context) { destroy_object(context); }
ww_status ww_items_create(ww_items** items) { return create(items); }
void ww_items_destroy(ww_items* items) { destroy_object(items); }
ww_status ww_path_create(ww_path** path) { return create(path); }
void ww_path_destroy(ww_path* path) { destroy_object(path); }
ww_status ww_paths_create(ww_paths** paths) { return create(paths); }
void ww_paths_destroy(ww_paths* paths) { destroy_object(paths); }
ww_status ww_search_create(ww_search** search) { return create(search); }
void ww_search_destroy(ww_search* search) { destroy_object(search); }
ww_status ww_mesh_create(ww_mesh** mesh) { return create(mesh); }
void ww_mesh_destroy(ww_mesh* mesh) { destroy_object(mesh); }
ww_status ww_text_create(ww_text** text) { return create(text); }
void ww_text_destroy(ww_text* text) { destroy_object(text); }
ww_status ww_scene_create(ww_scene** scene) { return create(scene); }
void ww_scene_destroy(ww_scene* scene) { destroy_object(scene); }
ww_status ww_script_create(ww_script** script) { return create(script); }
void ww_script_destroy(ww_script* script) { destroy_object(script); }
ww_status ww_scenario_create(ww_scenario** scenario) { return create(scenario); }
void ww_scenario_destroy(ww_scenario* scenario) { destroy_object(scenario); }
ww_status ww_replay_create(ww_replay** replay) { return create(replay); }
void ww_replay_destroy(ww_replay* replay) { destroy_object(replay); }
ww_status ww_svg_overlay_create(ww_svg_overlay** overlay) { return create(overlay); }
void ww_svg_overlay_destroy(ww_svg_overlay* overlay) { destroy_object(overlay); }

ww_status ww_text_read(const ww_text* text, char* buffer, size_t capacity, size_t* count) {
  return guarded([&] { return write_text(object(text), buffer, capacity, count); });
}

ww_status ww_text_bytes(const ww_text* text, const char** bytes, size_t* size) {
  return guarded([&] {
    const std::string& given = object(text);
    const char*& out = answer(bytes);
    answer(size) = given.size();
    out = given.c_str();
    return WW_OK;
  });
}

ww_bool ww_is_in_range(double coordinate) { return to_c(is_in_range(coordinate)); }

ww_status ww_shape_init(ww_shape* shape, size_t struct_size) { return init_struct(shape, struct_size, {}); }

ww_status ww_rectangle(ww_box box, ww_point* points, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_point> out(points, capacity, count);
    const ww_point corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    return out.write(std::span(corners), [](const ww_point& point) { return point; });
  });
}

ww_status ww_regular_polygon(ww_point centre, double radius, size_t corner_count, ww_point* points, size_t capacity,
                             size_t* count) {
  return guarded([&] {
    const ListOut<ww_point> out(points, capacity, count);
    return write_points(Shape::regular_polygon(to_cpp(centre), radius, corner_count).rings.points(), out);
  });
}

ww_status ww_translated(const ww_shape* shape, double dx, double dy, ww_point* points, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_point> out(points, capacity, count);
    const Shape moved = translated(to_shape(shape), dx, dy);
    return write_points(moved.rings.points(), out);
  });
}

ww_status ww_centroid(const ww_shape* shape, ww_point* centroid) {
  return guarded([&] {
    ww_point& out = answer(centroid);
    const Shape given = to_shape(shape);
    require(!given.rings.points().empty(), "a shape has no point, so it has no centroid");
    out = to_c(waywright::centroid(given));
    return WW_OK;
  });
}

ww_status ww_bounding_box(const ww_point* points, size_t point_count, ww_box* box) {
  return guarded([&] {
    ww_box& out = answer(box);
    require(point_count > 0, "there is no point, so there is no bounding box");
    out = to_c(Box::bounding(to_points(points, point_count)));
    return WW_OK;
  });
}

ww_status ww_items_clear(ww_items* items) {
  return guarded([&] {
    object(items).clear();
    return WW_OK;
  });
}

ww_status ww_items_add(ww_items* items, ww_id id, const ww_shape* shape) {
  return guarded([&] {
    object(items).push_back({id, to_shape(shape)});
    return WW_OK;
  });
}

ww_status ww_items_count(const ww_items* items, size_t* count) {
  return guarded([&] {
    answer(count) = object(items).size();
    return WW_OK;
  });
}

ww_status ww_items_get_info(const ww_items* items, size_t index, ww_item_info* info) {
  return guarded([&] {
    const StructOut out(info);
    const Item& item = item_at(items, index);
    out.write({0, static_cast<ww_item_kind>(item.shape.kind), static_cast<ww_fill_rule>(item.shape.fill), item.id.value,
               item.shape.rings.points().size(), item.shape.rings.size()});
    return WW_OK;
  });
}

ww_status ww_items_points(const ww_items* items, size_t index, ww_point* points, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_point> out(points, capacity, count);
    return write_points(item_at(items, index).shape.rings.points(), out);
  });
}

ww_status ww_items_ring_sizes(const ww_items* items, size_t index, size_t* ring_sizes, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<size_t> out(ring_sizes, capacity, count);
    return out.write(item_at(items, index).shape.rings, [](PointSpan ring) { return ring.size(); });
  });
}
