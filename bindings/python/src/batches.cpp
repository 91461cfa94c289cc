#include <optional>

#include "bind.hpp"
#include "parallel.hpp"

// Many short queries at once: arrays of NumPy in and out.

namespace waywright::python {

namespace {

/// Checks that two lists of a batch have the same length.
void check_lengths(std::size_t a, std::size_t b, const char* message) {
  if (a != b) throw py::value_error(message);
}

/// The ids of a batch, query after query.
class IdLists {
 public:
  IdLists(const Batch& batch, std::size_t count) : lists_(batch.chunk_count()), offsets_(count + 1) {}

  void add(const Chunk& chunk, std::size_t query, const std::vector<ItemId>& ids) {
    lists_[chunk.index].insert(lists_[chunk.index].end(), ids.begin(), ids.end());
    offsets_[query + 1] = static_cast<std::int64_t>(ids.size());
  }
  /// Returns the ids of all queries and the offsets of each query.
  [[nodiscard]] std::pair<py::array, py::array> arrays() {
    std::vector<ItemId> all;
    for (const auto& list : lists_) all.insert(all.end(), list.begin(), list.end());
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
    return {own_ids(std::move(all)), own_numbers(std::move(offsets_))};
  }

 private:
  std::vector<std::vector<ItemId>> lists_;  ///< of each chunk
  std::vector<std::int64_t> offsets_;
};

/// Calls `answer(world, context, chunk, query)` for each query of a batch.
template <class Handle, class Function>
void run(const Handle& self, const Batch& batch, const py::object& progress, const Function& answer) {
  Reporter reporter(progress);
  self.read_long([&](const World& world) {
    batch.run(self.contexts(), reporter, [&](QueryContext& context, const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const Result<void> done = answer(world, context, chunk, i);
        if (!done) refuse_query(done.error(), i);
      }
    });
  });
}

template <class Handle>
py::tuple cast_rays(const Handle& self, const PointsArg& starts, const PointsArg& ends, const AgentsArg& agents,
                    ThreadCount threads, const py::object& progress) {
  const std::size_t count = starts.size();
  check_lengths(count, ends.size(), "starts and ends must have the same length");
  agents.check_count(count);
  const Batch batch(count, threads.value);
  IdLists ids(batch, count);
  std::vector<std::uint8_t> hits(count);
  std::vector<Point> at(count);
  std::vector<Point> contacts(count);
  const std::span<const Point> from = starts.span();
  const std::span<const Point> to = ends.span();
  run(self, batch, progress, [&](const World& world, QueryContext& context, const Chunk& chunk, std::size_t i) {
    thread_local RayHit hit;
    const Result<void> done = world.ray(from[i], to[i], agents[i], context, hit);
    if (!done) return done;
    hits[i] = hit.hit ? 1 : 0;
    at[i] = hit.at;
    contacts[i] = hit.contact;
    ids.add(chunk, i, hit.items);
    return done;
  });
  const auto [items, offsets] = ids.arrays();
  return py::make_tuple(own_numbers(std::move(hits)).attr("view")("bool"), own_points(std::move(at)),
                        own_points(std::move(contacts)), items, offsets);
}

template <class Handle>
py::object fit_discs(const Handle& self, const PointsArg& centres, const AgentsArg& agents, ThreadCount threads,
                     const py::object& progress) {
  agents.check_count(centres.size());
  const Batch batch(centres.size(), threads.value);
  std::vector<std::uint8_t> fits(centres.size());
  const std::span<const Point> points = centres.span();
  run(self, batch, progress, [&](const World& world, QueryContext& context, const Chunk&, std::size_t i) {
    thread_local DiscFit fit;
    const Result<void> done = world.fit_disc(points[i], agents[i], context, fit);
    if (done) fits[i] = fit.fits ? 1 : 0;
    return done;
  });
  return own_numbers(std::move(fits)).attr("view")("bool");
}

template <class Handle>
py::tuple nearest_fits(const Handle& self, const PointsArg& points, const AgentsArg& agents, double limit,
                       ThreadCount threads, const py::object& progress) {
  agents.check_count(points.size());
  const Batch batch(points.size(), threads.value);
  std::vector<std::uint8_t> found(points.size());
  std::vector<Point> at(points.size());
  std::vector<double> distances(points.size());
  const std::span<const Point> all = points.span();
  run(self, batch, progress, [&](const World& world, QueryContext& context, const Chunk&, std::size_t i) {
    NearestFit fit;
    const Result<void> done = world.nearest_fit({.point = all[i], .agent = agents[i], .limit = limit}, context, fit);
    if (!done) return done;
    found[i] = fit.is_found ? 1 : 0;
    at[i] = fit.at;
    distances[i] = fit.distance;
    return done;
  });
  return py::make_tuple(own_numbers(std::move(found)).attr("view")("bool"), own_points(std::move(at)),
                        own_numbers(std::move(distances)));
}

template <class Handle>
py::tuple items_at_all(const Handle& self, const PointsArg& points, ThreadCount threads, const py::object& progress) {
  const Batch batch(points.size(), threads.value);
  IdLists ids(batch, points.size());
  const std::span<const Point> all = points.span();
  run(self, batch, progress, [&](const World& world, QueryContext& context, const Chunk& chunk, std::size_t i) {
    thread_local std::vector<ItemId> items;
    const Result<void> done = world.items_at(all[i], context, items);
    if (done) ids.add(chunk, i, items);
    return done;
  });
  const auto [items, offsets] = ids.arrays();
  return py::make_tuple(items, offsets);
}

template <class Handle>
py::object are_clear(const Handle& self, const PointsArg& starts, const PointsArg& ends, const AgentsArg& agents,
                     ThreadCount threads, const py::object& progress) {
  check_lengths(starts.size(), ends.size(), "starts and ends must have the same length");
  agents.check_count(starts.size());
  const Batch batch(starts.size(), threads.value);
  std::vector<std::uint8_t> clear(starts.size());
  const std::span<const Point> from = starts.span();
  const std::span<const Point> to = ends.span();
  run(self, batch, progress, [&](const World& world, QueryContext& context, const Chunk&, std::size_t i) {
    const Result<bool> is_clear = world.is_clear(from[i], to[i], agents[i], context);
    if (!is_clear) return Result<void>(is_clear.error());
    clear[i] = *is_clear ? 1 : 0;
    return Result<void>();
  });
  return own_numbers(std::move(clear)).attr("view")("bool");
}

}  // namespace

template <class Class>
void bind_batches(Class& world) {
  using Handle = typename Class::type;
  bind_path_batches(world);
  world
      .def("_rays", &cast_rays<Handle>, py::arg("starts"), py::arg("ends"), py::arg("agent"), py::arg("threads"),
           py::arg("progress"))
      .def("_nearest_fits", &nearest_fits<Handle>, py::arg("points"), py::arg("agent"), py::arg("limit"),
           py::arg("threads"), py::arg("progress"))
      .def("_items_at_all", &items_at_all<Handle>, py::arg("points"), py::arg("threads"), py::arg("progress"))
      .def("fit_discs", &fit_discs<Handle>, py::arg("centres"), py::arg("agent"), py::kw_only(), py::arg("threads") = 1,
           py::arg("progress") = py::none(),
           R"(Returns an array that says for each centre whether a disc fits there.

>>> world.fit_discs([(30, 50), (38, 50), (50, 50)], waywright.Agent(radius=5))
array([ True, False, False])
)")
      .def("are_clear", &are_clear<Handle>, py::arg("starts"), py::arg("ends"), py::arg("agent") = Agent{},
           py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
           R"(Returns an array that says for each segment whether an agent can walk along it.

>>> world.are_clear([(10, 50), (10, 70)], [(90, 50), (90, 70)])
array([False,  True])
)");
}

template void bind_batches(WorldClass& world);
template void bind_batches(SnapshotClass& snapshot);

}  // namespace waywright::python
