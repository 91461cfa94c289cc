#include "internal.hpp"
#include "structs.hpp"

namespace waywright::c {

namespace {

ww_location to_c(const Location& location) {
  ww_location result{0, static_cast<ww_location_kind>(location.kind), location.vertex_count, {}};
  for (std::size_t i = 0; i < location.vertices.size(); ++i) result.vertices[i] = c::to_c(location.vertices[i]);
  return result;
}

}  // namespace

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_locate(const ww_world* world, ww_point point, ww_context* context, ww_location* location,
                          ww_id* polygons, size_t capacity, size_t* count) {
  return guarded([&] {
    const StructOut out(location);
    const ListOut<ww_id> list(polygons, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).locate(to_cpp(point), kept.query, kept.location);
    if (!done.ok()) return fail(done.error());
    out.write(to_c(kept.location));
    return write_ids(kept.location.polygons, list);
  });
}

ww_status ww_world_items_at(const ww_world* world, ww_point point, ww_context* context, ww_id* items, size_t capacity,
                            size_t* count) {
  return guarded([&] {
    const ListOut<ww_id> list(items, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).items_at(to_cpp(point), kept.query, kept.ids);
    return done.ok() ? write_ids(kept.ids, list) : fail(done.error());
  });
}

ww_status ww_world_items_crossed(const ww_world* world, ww_point from, ww_point to, ww_context* context,
                                 ww_crossed_item* items, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_crossed_item> list(items, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).items_crossed(to_cpp(from), to_cpp(to), kept.query, kept.crossed);
    if (!done.ok()) return fail(done.error());
    return list.write(kept.crossed, [](const CrossedItem& item) { return c::to_c(item); });
  });
}

ww_status ww_world_items_in(const ww_world* world, ww_box box, ww_context* context, ww_id* items, size_t capacity,
                            size_t* count) {
  return guarded([&] {
    const ListOut<ww_id> list(items, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).items_in(to_cpp(box), kept.query, kept.ids);
    return done.ok() ? write_ids(kept.ids, list) : fail(done.error());
  });
}

ww_status ww_world_ray(const ww_world* world, ww_point from, ww_point to, const ww_agent* agent, ww_context* context,
                       ww_ray_hit* hit, ww_id* items, size_t capacity, size_t* count) {
  return guarded([&] {
    const StructOut out(hit);
    const ListOut<ww_id> list(items, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).ray(to_cpp(from), to_cpp(to), to_cpp(agent), kept.query, kept.hit);
    if (!done.ok()) return fail(done.error());
    out.write(c::to_c(kept.hit));
    return write_ids(kept.hit.items, list);
  });
}

ww_status ww_world_fit_disc(const ww_world* world, ww_point centre, const ww_agent* agent, ww_context* context,
                            ww_bool* fits, ww_id* items, size_t capacity, size_t* count) {
  return guarded([&] {
    ww_bool& out = answer(fits);
    const ListOut<ww_id> list(items, capacity, count);
    Context& kept = object(context);
    const Result<void> done = object(world).fit_disc(to_cpp(centre), to_cpp(agent), kept.query, kept.fit);
    if (!done.ok()) return fail(done.error());
    out = c::to_c(kept.fit.fits);
    return write_ids(kept.fit.items, list);
  });
}

ww_status ww_nearest_fit_query_init(ww_nearest_fit_query* query, size_t struct_size) {
  return init_struct(query, struct_size, kDefaultNearestFitQuery);
}

ww_status ww_world_nearest_fit(const ww_world* world, const ww_nearest_fit_query* query, ww_context* context,
                               ww_nearest_fit* fit) {
  return guarded([&] {
    const StructOut out(fit);
    const NearestFitQuery wanted = to_cpp(read_struct(query, kDefaultNearestFitQuery));
    NearestFit found;
    const Result<void> done = object(world).nearest_fit(wanted, object(context).query, found);
    if (!done.ok()) return fail(done.error());
    out.write(c::to_c(found));
    return ww_status{WW_OK};
  });
}

ww_status ww_world_widest_path(const ww_world* world, ww_point start, ww_point goal, const ww_agent* agent,
                               ww_context* context, ww_widest_path* widest, ww_id* from_items, size_t from_capacity,
                               size_t* from_count, ww_id* to_items, size_t to_capacity, size_t* to_count) {
  return guarded([&] {
    const StructOut out(widest);
    const ListOut<ww_id> from_list(from_items, from_capacity, from_count);
    const ListOut<ww_id> to_list(to_items, to_capacity, to_count);
    Context& kept = object(context);
    const Result<void> done =
        object(world).widest_path(to_cpp(start), to_cpp(goal), to_cpp(agent), kept.query, kept.widest);
    if (!done.ok()) return fail(done.error());
    out.write(c::to_c(kept.widest));
    const ww_status from_status = write_ids(kept.widest.from_items, from_list);
    const ww_status to_status = write_ids(kept.widest.to_items, to_list);
    return from_status != WW_OK ? from_status : to_status;
  });
}

ww_status ww_world_bridges(const ww_world* world, ww_box box, ww_context* context, ww_bridge* bridges, size_t capacity,
                           size_t* count, ww_id* ids, size_t id_capacity, size_t* id_count) {
  return guarded([&] {
    const ListOut<ww_bridge> list(bridges, capacity, count);
    const ListOut<ww_id> id_list(ids, id_capacity, id_count);
    Context& kept = object(context);
    const Result<void> done = object(world).bridges(to_cpp(box), kept.query, kept.bridges);
    if (!done.ok()) return fail(done.error());
    const ww_status status = list.write(kept.bridges.bridges, [](const Bridge& bridge) { return c::to_c(bridge); });
    const ww_status id_status = write_ids(kept.bridges.ids, id_list);
    return status != WW_OK ? status : id_status;
  });
}

ww_status ww_world_is_clear(const ww_world* world, const ww_point* points, size_t point_count, const ww_agent* agent,
                            ww_context* context, ww_bool* is_clear) {
  return guarded([&] {
    ww_bool& out = answer(is_clear);
    const Result<bool> done =
        object(world).is_clear(to_points(points, point_count), to_cpp(agent), object(context).query);
    if (done.ok()) out = c::to_c(*done);
    return status_of(done);
  });
}

ww_status ww_world_is_clear_between(const ww_world* world, ww_point from, ww_point to, const ww_agent* agent,
                                    ww_context* context, ww_bool* is_clear) {
  return guarded([&] {
    ww_bool& out = answer(is_clear);
    const Result<bool> done = object(world).is_clear(to_cpp(from), to_cpp(to), to_cpp(agent), object(context).query);
    if (done.ok()) out = c::to_c(*done);
    return status_of(done);
  });
}

ww_status ww_world_is_affected(const ww_world* world, const ww_point* points, size_t point_count, const ww_agent* agent,
                               uint64_t since, ww_bool* is_affected) {
  return guarded([&] {
    const PointSpan line = to_points(points, point_count);
    answer(is_affected) = c::to_c(object(world).is_affected(std::span<const Point>(line), since, to_cpp(agent)));
    return WW_OK;
  });
}

ww_status ww_world_is_path_affected(const ww_world* world, const ww_path* path, uint64_t since, ww_bool* is_affected) {
  return guarded([&] {
    answer(is_affected) = c::to_c(object(world).is_affected(object(path), since));
    return WW_OK;
  });
}

ww_status ww_world_find_affected(const ww_world* world, const ww_path* const* paths, size_t path_count, uint64_t since,
                                 size_t* indices, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<size_t> list(indices, capacity, count);
    const World& asked = object(world);
    const std::span<const ww_path* const> given = to_span(paths, path_count);
    std::vector<std::size_t> affected;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (asked.is_affected(object(given[i]), since)) affected.push_back(i);
    }
    return list.write(affected, [](std::size_t index) { return index; });
  });
}

ww_status ww_world_version(const ww_world* world, uint64_t* version) {
  return guarded([&] {
    answer(version) = object(world).version();
    return WW_OK;
  });
}

ww_status ww_world_changes_since(const ww_world* world, uint64_t since, ww_bool* is_known, ww_changed_box* boxes,
                                 size_t capacity, size_t* count) {
  return guarded([&] {
    ww_bool& out = answer(is_known);
    const ListOut<ww_changed_box> list(boxes, capacity, count);
    const std::optional<std::span<const ChangedBox>> changes = object(world).changes_since(since);
    out = c::to_c(changes.has_value());
    return list.write(changes.value_or(std::span<const ChangedBox>()),
                      [](const ChangedBox& changed) { return c::to_c(changed); });
  });
}
