#include <functional>
#include <memory>
#include <utility>

#include "internal.hpp"
#include "structs.hpp"

namespace waywright::c {

namespace {

constexpr ww_bulk_options kBulkOptions{sizeof(ww_bulk_options), nullptr, nullptr, 1, nullptr};

/// Writes the id of a new item, or records why there is none.
ww_status write_id(const Result<ItemId>& id, ww_id* out) {
  if (id.ok()) write_if_wanted(out, id->value);
  return status_of(id);
}

/// Writes the ids of several items, or records why there are none.
ww_status write_all_ids(const Result<std::vector<ItemId>>& ids, ww_id* out) {
  if (ids.ok() && out != nullptr) std::transform(ids->begin(), ids->end(), out, [](ItemId id) { return id.value; });
  return status_of(ids);
}

Change to_change(const ww_change& change) {
  const auto kind = to_enum(change.kind, Change::Kind::replace);
  return {kind, change.id, kind == Change::Kind::remove ? Shape{} : to_shape(change.shape)};
}

}  // namespace

std::vector<Change> to_changes(const ww_change* changes, std::size_t count) {
  const std::span<const ww_change> given = to_span(changes, count);
  std::vector<Change> list;
  list.reserve(given.size());
  for (const ww_change& change : given) list.push_back(to_change(change));
  return list;
}

Bulk::Bulk(const ww_bulk_options* given) : Bulk(given != nullptr ? read_struct(given, kBulkOptions) : kBulkOptions) {}

Bulk::Bulk(const ww_bulk_options& given) : jobs(given.jobs) {
  require(given.threads >= 1, "a bulk load needs one thread or more");
  options.threads = given.threads;
  options.jobs = jobs.get();
  if (given.progress == nullptr) return;
  options.progress = [call = given.progress, user_data = given.progress_user_data](
                         std::size_t done, std::size_t total) { call(done, total, user_data); };
}

Jobs::Jobs(const ww_job_system* jobs) {
  if (jobs == nullptr) return;
  jobs_ = read_struct(jobs, {});
  require(jobs_.run != nullptr, "a job system needs the function run");
}

void Jobs::run(std::size_t count, const std::function<void(std::size_t)>& job) {
  struct Run {
    std::size_t count;
    const std::function<void(std::size_t)>& job;
    std::atomic<std::int32_t> is_wrong{0};  // threads of the caller write it
  };
  Run run{count, job};
  const ww_job call = [](void* job_data, std::size_t index) {
    Run& called = *static_cast<Run*>(job_data);
    if (index < called.count) {
      called.job(index);
    } else {
      called.is_wrong = 1;
    }
  };
  jobs_.run(count, call, &run, jobs_.user_data);
  require(run.is_wrong == 0, "a job system has called a job with an index that is not below the number of jobs");
}

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_world_options_init(ww_world_options* options, size_t struct_size) {
  return init_struct(options, struct_size, kDefaultWorldOptions);
}

ww_status ww_world_create(ww_box domain, const ww_world_options* options, ww_world** world) {
  return guarded([&] {
    ww_world*& out = answer(world);
    const ww_world_options given =
        options != nullptr ? read_struct(options, kDefaultWorldOptions) : kDefaultWorldOptions;
    Result<World> made = World::create(to_cpp(domain), to_cpp(given));
    if (!made.ok()) return fail(made.error());
    out = opaque<ww_world>(new World(std::move(*made)));
    return ww_status{WW_OK};
  });
}

void ww_world_destroy(ww_world* world) {
  if (world == nullptr) return;
  guarded([&] {
    delete &changing(world);
    return WW_OK;
  });
}

ww_status ww_world_clone(const ww_world* world, ww_world** clone) {
  return guarded([&] {
    require_no_question(object(world));
    return make_object(clone, object(world).clone());
  });
}

ww_status ww_world_domain(const ww_world* world, ww_box* domain) {
  return guarded([&] {
    answer(domain) = to_c(object(world).domain());
    return WW_OK;
  });
}

ww_status ww_world_get_options(const ww_world* world, ww_world_options* options) {
  return guarded([&] {
    const StructOut out(options);
    out.write(to_c(object(world).options()));
    return WW_OK;
  });
}

ww_status ww_world_insert(ww_world* world, const ww_shape* shape, ww_id id, ww_id* inserted) {
  return guarded([&] { return write_id(changing(world).insert(to_shape(shape), id), inserted); });
}

ww_status ww_world_insert_point(ww_world* world, ww_point point, ww_id id, ww_id* inserted) {
  return guarded([&] { return write_id(changing(world).insert_point(to_cpp(point), id), inserted); });
}

ww_status ww_world_insert_segment(ww_world* world, ww_point a, ww_point b, ww_id id, ww_id* inserted) {
  return guarded([&] { return write_id(changing(world).insert_segment(to_cpp(a), to_cpp(b), id), inserted); });
}

ww_status ww_world_insert_polyline(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                   ww_id* inserted) {
  return guarded(
      [&] { return write_id(changing(world).insert_polyline(to_points(points, point_count), id), inserted); });
}

ww_status ww_world_insert_polygon(ww_world* world, const ww_point* points, size_t point_count, ww_id id,
                                  ww_id* inserted) {
  return guarded([&] {
    Rings rings;
    rings.push_back(to_points(points, point_count));
    return write_id(changing(world).insert_polygon(std::move(rings), id), inserted);
  });
}

ww_status ww_world_remove(ww_world* world, ww_id id) {
  return guarded([&] { return status_of(changing(world).remove(id)); });
}

ww_status ww_world_replace(ww_world* world, ww_id id, const ww_shape* shape) {
  return guarded([&] { return status_of(changing(world).replace(id, to_shape(shape))); });
}

ww_status ww_bulk_options_init(ww_bulk_options* options, size_t struct_size) {
  return init_struct(options, struct_size, kBulkOptions);
}

ww_status ww_world_insert_all(ww_world* world, const ww_items* items, const ww_bulk_options* options, ww_id* ids) {
  return guarded([&] {
    const Bulk bulk(options);
    World& changed = changing(world);
    const std::vector<Item>& inserted = object(items);
    const RunningCall running(changed, RunningCall::Use::changes);
    return write_all_ids(changed.insert_all(inserted, bulk.options), ids);
  });
}

ww_status ww_world_insert_points(ww_world* world, const ww_point* points, size_t point_count, ww_id first,
                                 const ww_bulk_options* options, ww_id* first_id) {
  return guarded([&] {
    const Bulk bulk(options);
    World& changed = changing(world);
    const PointSpan inserted = to_points(points, point_count);
    const RunningCall running(changed, RunningCall::Use::changes);
    return write_id(changed.insert_points(inserted, first, bulk.options), first_id);
  });
}

ww_status ww_world_apply(ww_world* world, const ww_change* changes, size_t change_count, ww_id* ids) {
  return guarded([&] { return write_all_ids(changing(world).apply(to_changes(changes, change_count)), ids); });
}

ww_status ww_world_set_new_vertex_limit(ww_world* world, size_t limit) {
  return guarded([&] {
    changing(world).set_new_vertex_limit(limit);
    return WW_OK;
  });
}

ww_status ww_world_new_vertex_limit(const ww_world* world, size_t* limit) {
  return guarded([&] {
    answer(limit) = object(world).new_vertex_limit();
    return WW_OK;
  });
}

ww_status ww_world_largest_id_seen(const ww_world* world, ww_id* id) {
  return guarded([&] {
    answer(id) = object(world).largest_id_seen().value;
    return WW_OK;
  });
}

ww_status ww_world_reserve_ids(ww_world* world, ww_id last) {
  return guarded([&] { return status_of(changing(world).reserve_ids(last)); });
}

ww_status ww_world_contains(const ww_world* world, ww_id id, ww_bool* contains) {
  return guarded([&] {
    answer(contains) = to_c(object(world).contains(id));
    return WW_OK;
  });
}

ww_status ww_world_item_count(const ww_world* world, size_t* item_count) {
  return guarded([&] {
    answer(item_count) = object(world).item_count();
    return WW_OK;
  });
}

ww_status ww_world_item_ids(const ww_world* world, ww_id* ids, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_id> out(ids, capacity, count);
    return write_ids(object(world).item_ids(), out);
  });
}

ww_status ww_world_item(const ww_world* world, ww_id id, ww_items* items) {
  return guarded([&] {
    std::vector<Item>& list = object(items);
    Item item{id, {}};
    if (const Result<void> read = object(world).shape(id, item.shape); !read.ok()) return fail(read.error());
    list.reserve(1);
    list.clear();
    list.push_back(std::move(item));
    return ww_status{WW_OK};
  });
}

ww_status ww_world_items(const ww_world* world, ww_context* context, ww_items* items) {
  return guarded([&] {
    object(world).items(object(context).query, object(items));
    return WW_OK;
  });
}
