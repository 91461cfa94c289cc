#include <utility>

#include "internal.hpp"
#include "structs.hpp"

namespace waywright::c {

namespace {

/// No version of the library refuses more threads. A team has at most 256.
constexpr std::size_t kMostThreads = 256;

const Path& found_path(const ww_path* path) {
  const Path& given = object(path);
  require(!given.points.empty() || !given.pieces.empty(), "a position on a path needs a path with points or pieces");
  return given;
}

/// Returns query number `i` of an array. The struct_size of the first element is the size of each element.
const ww_path_query* query_at(const ww_path_query* queries, std::size_t i) {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(queries);
  return reinterpret_cast<const ww_path_query*>(bytes + i * queries->struct_size);
}

}  // namespace

PathQuery to_query(const ww_path_query* query) { return to_cpp(read_struct(query, kDefaultPathQuery)); }

}  // namespace waywright::c

using namespace waywright;
using namespace waywright::c;

ww_status ww_path_query_init(ww_path_query* query, size_t struct_size) {
  return init_struct(query, struct_size, kDefaultPathQuery);
}

ww_status ww_world_find_path(const ww_world* world, const ww_path_query* query, ww_context* context, ww_path* path) {
  return guarded(
      [&] { return status_of(object(world).find_path(to_query(query), object(context).query, object(path))); });
}

ww_status ww_world_find_paths(const ww_world* world, const ww_path_query* queries, size_t query_count, size_t threads,
                              const ww_job_system* jobs, ww_context* context, ww_paths* paths) {
  return guarded([&] {
    require(threads >= 1, "a search for many paths needs one thread or more");
    const World& asked = object(world);
    std::vector<QueryContext>& contexts = object(context).more;
    std::vector<Path>& answers = object(paths);
    to_span(queries, query_count);
    Jobs system(jobs);
    std::vector<PathQuery> wanted;
    for (std::size_t i = 0; i < query_count; ++i) {
      require(query_at(queries, i)->struct_size == queries->struct_size,
              "the queries of an array differ in struct_size");
      wanted.push_back(to_query(query_at(queries, i)));
    }
    const std::size_t count = std::min({threads, kMostThreads, std::max<std::size_t>(query_count, 1)});
    if (contexts.size() < count) contexts.resize(count);
    const RunningCall running(asked, RunningCall::Use::reads);
    return status_of(asked.find_paths(wanted, std::span(contexts).first(count), answers, system.get()));
  });
}

ww_status ww_many_goals_query_init(ww_many_goals_query* query, size_t struct_size) {
  return init_struct(query, struct_size, kDefaultManyGoalsQuery);
}

ww_status ww_world_find_paths_from(const ww_world* world, const ww_many_goals_query* query, ww_context* context,
                                   ww_paths* paths) {
  return guarded([&] {
    const ManyGoalsQuery wanted = to_cpp(read_struct(query, kDefaultManyGoalsQuery));
    return status_of(object(world).find_paths_from(wanted, object(context).query, object(paths)));
  });
}

ww_status ww_world_default_end_tolerance(const ww_world* world, double* tolerance) {
  return guarded([&] {
    answer(tolerance) = object(world).default_end_tolerance();
    return WW_OK;
  });
}

ww_status ww_paths_count(const ww_paths* paths, size_t* count) {
  return guarded([&] {
    answer(count) = object(paths).size();
    return WW_OK;
  });
}

ww_status ww_paths_get(const ww_paths* paths, size_t index, const ww_path** path) {
  return guarded([&] {
    const std::vector<Path>& list = object(paths);
    require(index < list.size(), "a list of paths has no path of this index");
    answer(path) = opaque<ww_path>(&list[index]);
    return WW_OK;
  });
}

ww_status ww_path_copy(const ww_path* path, ww_path* to) {
  return guarded([&] {
    Path copy = object(path);
    object(to) = std::move(copy);
    return WW_OK;
  });
}

ww_status ww_path_get_info(const ww_path* path, ww_path_info* info) {
  return guarded([&] {
    StructOut(info).write(to_c(object(path)));
    return WW_OK;
  });
}

ww_status ww_path_points(const ww_path* path, ww_point* points, size_t capacity, size_t* count) {
  return guarded([&] { return write_points(object(path).points, ListOut<ww_point>(points, capacity, count)); });
}

ww_status ww_path_pieces(const ww_path* path, ww_path_piece* pieces, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_path_piece> list(pieces, capacity, count);
    return list.write(object(path).pieces, [](const PathPiece& piece) { return to_c(piece); });
  });
}

ww_status ww_path_channel(const ww_path* path, ww_portal* portals, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_portal> list(portals, capacity, count);
    return list.write(object(path).channel, [](const Portal& portal) { return to_c(portal); });
  });
}

ww_status ww_path_blockers(const ww_path* path, ww_id* items, size_t capacity, size_t* count) {
  return guarded([&] { return write_ids(object(path).blockers, ListOut<ww_id>(items, capacity, count)); });
}

ww_status ww_path_widest(const ww_path* path, ww_widest_path* widest, ww_id* from_items, size_t from_capacity,
                         size_t* from_count, ww_id* to_items, size_t to_capacity, size_t* to_count) {
  return guarded([&] {
    const StructOut out(widest);
    const ListOut<ww_id> from_list(from_items, from_capacity, from_count);
    const ListOut<ww_id> to_list(to_items, to_capacity, to_count);
    static const WidestPath none;
    const Path& given = object(path);
    const WidestPath& found = given.widest ? *given.widest : none;
    out.write(to_c(found));
    const ww_status from_status = write_ids(found.from_items, from_list);
    const ww_status to_status = write_ids(found.to_items, to_list);
    return from_status != WW_OK ? from_status : to_status;
  });
}

ww_status ww_path_at(const ww_path* path, double distance, ww_precision precision, ww_path_position* position) {
  return guarded([&] {
    const StructOut out(position);
    out.write(to_c(found_path(path).at(distance, to_enum(precision, Precision::float32))));
    return WW_OK;
  });
}

ww_status ww_path_advance(const ww_path* path, double step, ww_precision precision, ww_path_position* position) {
  return guarded([&] {
    const StructOut out(position);
    const Path& given = found_path(path);
    const ww_path_position from = read_struct(position, {});
    require(from.segment < std::max(given.points.size(), given.pieces.size()), "a position belongs to another path");
    out.write(to_c(given.advance(to_cpp(from), step, to_enum(precision, Precision::float32))));
    return WW_OK;
  });
}

ww_status ww_path_nearest(const ww_path* path, ww_point point, ww_precision precision, ww_path_position* position) {
  return guarded([&] {
    const StructOut out(position);
    out.write(to_c(found_path(path).nearest(to_cpp(point), to_enum(precision, Precision::float32))));
    return WW_OK;
  });
}

ww_status ww_path_polyline(const ww_path* path, double tolerance, ww_point* points, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_point> list(points, capacity, count);
    std::vector<Point> line;
    const Result<void> done = object(path).polyline(tolerance, line);
    return done.ok() ? write_points(line, list) : fail(done.error());
  });
}

ww_status ww_search_begin(ww_search* search, const ww_world* world, const ww_path_query* query) {
  return guarded([&] {
    Search& begun = object(search);
    const World& searched = object(world);
    require_no_question(searched);
    begun.world = &searched;
    return status_of(begun.search.begin(searched, to_query(query)));
  });
}

ww_status ww_search_step(ww_search* search, size_t expansions, ww_bool* is_done) {
  return guarded([&] {
    ww_bool& out = answer(is_done);
    Search& continued = object(search);
    if (continued.search.is_running()) require_no_question(*continued.world);
    const Result<bool> done = continued.search.step(expansions);
    if (done.ok()) out = to_c(*done);
    return status_of(done);
  });
}

ww_status ww_search_path(const ww_search* search, const ww_path** path) {
  return guarded([&] {
    answer(path) = opaque<ww_path>(&object(search).search.path());
    return WW_OK;
  });
}

ww_status ww_search_restarts(const ww_search* search, size_t* restarts) {
  return guarded([&] {
    answer(restarts) = object(search).search.restarts();
    return WW_OK;
  });
}

ww_status ww_search_record_windows(ww_search* search, ww_bool wanted) {
  return guarded([&] {
    object(search).search.record_windows(is_set(wanted));
    return WW_OK;
  });
}

ww_status ww_search_windows(const ww_search* search, ww_search_window* windows, size_t capacity, size_t* count) {
  return guarded([&] {
    const ListOut<ww_search_window> list(windows, capacity, count);
    return list.write(object(search).search.windows(), [](const SearchWindow& window) { return to_c(window); });
  });
}

ww_status ww_search_cancel(ww_search* search) {
  return guarded([&] {
    object(search).search.cancel();
    return WW_OK;
  });
}

ww_status ww_search_is_running(const ww_search* search, ww_bool* is_running) {
  return guarded([&] {
    answer(is_running) = to_c(object(search).search.is_running());
    return WW_OK;
  });
}
