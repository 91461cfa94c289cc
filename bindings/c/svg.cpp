#include <string>
#include <utility>

#include "internal.hpp"
#include "structs.hpp"

namespace waywright::c {

namespace {

/// Returns the domain's part of the transform that a frame describes.
SvgFrame to_frame(const ww_svg_frame* frame) {
  const ww_svg_frame given = read_struct(frame, {});
  return {to_cpp(given.shown), to_cpp(given.map.min), given.scale, is_set(given.y_down)};
}

std::vector<ItemId> to_ids(const ww_id* ids, std::size_t count) {
  const std::span<const ww_id> given = to_span(ids, count);
  return {given.begin(), given.end()};
}

}  // namespace

SvgOptions to_options(const ww_svg_options* options) {
  return to_cpp(options != nullptr ? read_struct(options, kDefaultSvgOptions) : kDefaultSvgOptions);
}

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_svg_options_init(ww_svg_options* options, size_t struct_size) {
  return init_struct(options, struct_size, kDefaultSvgOptions);
}

ww_status ww_world_to_svg(const ww_world* world, const ww_svg_overlay* overlay, const ww_svg_options* options,
                          ww_text* text) {
  return guarded([&] {
    std::string& out = object(text);
    const SvgOverlay none;
    Result<std::string> drawn = to_svg(object(world), overlay != nullptr ? object(overlay) : none, to_options(options));
    if (drawn.ok()) out = std::move(*drawn);
    return status_of(drawn);
  });
}

ww_status ww_svg_get_frame(ww_box domain, const ww_svg_options* options, ww_svg_frame* frame) {
  return guarded([&] {
    const StructOut out(frame);
    const Result<SvgFrame> found = svg_frame(to_cpp(domain), to_options(options));
    if (!found.ok()) return fail(found.error());
    out.write({0, to_c(found->y_down()), to_c(found->shown()), to_c(found->map()), found->scale()});
    return ww_status{WW_OK};
  });
}

ww_status ww_svg_to_picture(const ww_svg_frame* frame, ww_point point, ww_point* pixels) {
  return guarded([&] {
    answer(pixels) = to_c(to_frame(frame).to_picture(to_cpp(point)));
    return WW_OK;
  });
}

ww_status ww_svg_to_world(const ww_svg_frame* frame, ww_point pixels, ww_point* point) {
  return guarded([&] {
    answer(point) = to_c(to_frame(frame).to_world(to_cpp(pixels)));
    return WW_OK;
  });
}

ww_status ww_svg_overlay_clear(ww_svg_overlay* overlay) {
  return guarded([&] {
    object(overlay) = {};
    return WW_OK;
  });
}

ww_status ww_svg_add_path(ww_svg_overlay* overlay, const ww_path* path) {
  return guarded([&] {
    object(overlay).paths.push_back(object(path));
    return WW_OK;
  });
}

ww_status ww_svg_add_disc_path(ww_svg_overlay* overlay, const ww_path_query* query, const ww_path* path) {
  return guarded([&] {
    object(overlay).disc_paths.push_back({to_query(query), object(path)});
    return WW_OK;
  });
}

ww_status ww_svg_add_failed_path(ww_svg_overlay* overlay, ww_point start, ww_point goal, ww_path_status status) {
  return guarded([&] {
    object(overlay).failed_paths.push_back({to_cpp(start), to_cpp(goal), to_enum(status, PathStatus::no_path)});
    return WW_OK;
  });
}

ww_status ww_svg_add_ray(ww_svg_overlay* overlay, ww_point from, ww_point to, const ww_ray_hit* hit, const ww_id* items,
                         size_t item_count) {
  return guarded([&] {
    const ww_ray_hit given = read_struct(hit, {});
    RayHit copy{is_set(given.hit), to_cpp(given.at), to_ids(items, item_count), to_cpp(given.contact)};
    object(overlay).rays.push_back({to_cpp(from), to_cpp(to), std::move(copy)});
    return WW_OK;
  });
}

ww_status ww_svg_add_location(ww_svg_overlay* overlay, ww_point at, const ww_location* location, const ww_id* polygons,
                              size_t polygon_count) {
  return guarded([&] {
    const ww_location given = read_struct(location, {});
    Location copy;
    require(given.vertex_count <= copy.vertices.size(), "a location has more than 3 vertices");
    copy.kind = to_enum(given.kind, LocationKind::face);
    copy.vertex_count = given.vertex_count;
    for (std::size_t i = 0; i < copy.vertices.size(); ++i) copy.vertices[i] = to_cpp(given.vertices[i]);
    copy.polygons = to_ids(polygons, polygon_count);
    object(overlay).locations.push_back({to_cpp(at), std::move(copy)});
    return WW_OK;
  });
}

ww_status ww_svg_add_disc(ww_svg_overlay* overlay, ww_point centre, double radius, const char* colour,
                          const char* hint) {
  return guarded([&] {
    object(overlay).discs.push_back(
        {to_cpp(centre), radius, std::string(text_or_empty(colour)), std::string(text_or_empty(hint))});
    return WW_OK;
  });
}

ww_status ww_svg_add_polyline(ww_svg_overlay* overlay, const ww_point* points, size_t point_count, double width,
                              ww_bool dashed, const char* colour, const char* hint) {
  return guarded([&] {
    object(overlay).polylines.push_back({to_points(points, point_count), width, is_set(dashed),
                                         std::string(text_or_empty(colour)), std::string(text_or_empty(hint))});
    return WW_OK;
  });
}

ww_status ww_svg_add_label(ww_svg_overlay* overlay, ww_point at, const char* text, double radius, double size,
                           const char* colour) {
  return guarded([&] {
    object(overlay).labels.push_back(
        {to_cpp(at), std::string(to_view(text)), radius, size, std::string(text_or_empty(colour))});
    return WW_OK;
  });
}

ww_status ww_svg_add_key(ww_svg_overlay* overlay, const char* text, const char* colour) {
  return guarded([&] {
    object(overlay).keys.push_back({std::string(to_view(text)), std::string(text_or_empty(colour))});
    return WW_OK;
  });
}

ww_status ww_svg_add_elements(ww_svg_overlay* overlay, const char* elements) {
  return guarded([&] {
    object(overlay).elements += to_view(elements);
    return WW_OK;
  });
}
