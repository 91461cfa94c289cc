#include <cstddef>
#include <cstring>
#include <numeric>
#include <optional>

#include "bind.hpp"
#include "parallel.hpp"
#include "path.hpp"
#include "structs.hpp"

// Many path queries at once: arrays of NumPy in and out.

namespace waywright::python {

namespace {

/// The answers of a batch of path queries.
class PathAnswers {
 public:
  PathAnswers(const Batch& batch, std::size_t count)
      : statuses_(count),
        lengths_(count),
        point_offsets_(count + 1),
        piece_offsets_(count + 1),
        points_(batch.chunk_count()),
        pieces_(batch.chunk_count()) {}

  /// Makes room for the points of a chunk.
  void begin(const Chunk& chunk) { points_[chunk.index].reserve(kUsualPoints * (chunk.end - chunk.begin)); }
  void add(const Chunk& chunk, std::size_t query, const Path& path, std::span<const Point> line) {
    statuses_[query] = static_cast<std::uint8_t>(path.status);
    lengths_[query] = path.length;
    add(line, points_[chunk.index], point_offsets_[query + 1]);
    add(std::span(path.pieces), pieces_[chunk.index], piece_offsets_[query + 1]);
  }

  /// Returns statuses, lengths, points, their offsets, pieces, their offsets. Requires: all queries have answers. NumPy
  /// allocates large arrays in huge pages where the system has them, so this copy costs less than a copy to a
  /// std::vector.
  [[nodiscard]] py::tuple arrays() {
    const std::int64_t point_count = add_up(point_offsets_);
    py::array_t<double> points(std::vector<py::ssize_t>{point_count, 2});
    py::array pieces(piece_type(), py::ssize_t{add_up(piece_offsets_)});
    {
      const WithoutGil no_gil;
      join(points_, points.mutable_data());
      join(pieces_, pieces.mutable_data());
    }
    return py::make_tuple(own_numbers(std::move(statuses_)), own_numbers(std::move(lengths_)), points,
                          own_numbers(std::move(point_offsets_)), pieces, own_numbers(std::move(piece_offsets_)));
  }

 private:
  static constexpr std::size_t kUsualPoints = 2;  ///< of a path: a straight one has no turns

  template <class T>
  static void add(std::span<const T> values, std::vector<T>& list, std::int64_t& count) {
    list.insert(list.end(), values.begin(), values.end());
    count = static_cast<std::int64_t>(values.size());
  }
  /// Makes offsets of counts. Returns the last one.
  static std::int64_t add_up(std::vector<std::int64_t>& offsets) {
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    return offsets.back();
  }
  /// Copies the elements of all lists to `target`, and frees the lists.
  template <class T>
  static void join(std::vector<std::vector<T>>& lists, void* target) {
    auto* next = static_cast<std::byte*>(target);
    for (std::vector<T>& list : lists) {
      if (!list.empty()) std::memcpy(next, list.data(), list.size() * sizeof(T));
      next += list.size() * sizeof(T);
      list = {};
    }
  }

  std::vector<std::uint8_t> statuses_;
  std::vector<double> lengths_;
  std::vector<std::int64_t> point_offsets_;
  std::vector<std::int64_t> piece_offsets_;
  std::vector<std::vector<Point>> points_;      ///< of each chunk
  std::vector<std::vector<PathPiece>> pieces_;  ///< of each chunk
};

/// What all queries of a batch have in common.
struct Options {
  PathQuery query;
  bool wants_points = true;
  std::optional<double> tolerance;  ///< of the polylines along the paths of discs
};

/// Finds the paths of a chunk.
void find_chunk(const World& world, QueryContext& context, const Chunk& chunk, std::span<const Point> starts,
                std::span<const Point> goals, const AgentsArg& agents, const Options& options, PathAnswers& answers) {
  thread_local Path path;
  thread_local std::vector<Point> line;
  PathQuery query = options.query;
  if (options.wants_points) answers.begin(chunk);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    query.start = starts[i];
    query.goal = goals[i];
    query.agent = agents[i];
    if (const Result<void> done = world.find_path(query, context, path); !done) refuse_query(done.error(), i);
    std::span<const Point> points = path.points;
    if (options.tolerance && !path.pieces.empty()) {
      if (const Result<void> done = path.polyline(*options.tolerance, line); !done) refuse_query(done.error(), i);
      points = line;
    }
    if (!options.wants_points) {
      points = {};
      path.pieces.clear();
    }
    answers.add(chunk, i, path, points);
  }
}

template <class Handle>
py::object find_paths(const Handle& self, const PointsArg& starts, const PointsArg& goals,
                      WAYWRIGHT_PATH_QUERY_BATCH_PARAMETERS, std::optional<double> tolerance, bool wants_points,
                      ThreadCount threads, const py::object& progress) {
  const std::size_t count = starts.size();
  if (goals.size() != count) throw py::value_error("starts and goals must have the same length");
  agent.check_count(count);
  Options options{.query = to_path_query({}, {}, WAYWRIGHT_PATH_QUERY_BATCH_NAMES),
                  .wants_points = wants_points,
                  .tolerance = tolerance};
  Reporter reporter(progress);
  const Batch batch(count, threads.value);
  PathAnswers answers(batch, count);
  self.read_long([&](const World& world) {
    batch.run(self.contexts(), reporter, [&](QueryContext& context, const Chunk& chunk) {
      find_chunk(world, context, chunk, starts.span(), goals.span(), agent, options, answers);
    });
  });
  return py::module_::import("waywright._batch").attr("PathBatch")(*answers.arrays());
}

}  // namespace

template <class Class>
void bind_path_batches(Class& world) {
  using Handle = typename Class::type;
  world.def("find_paths", &find_paths<Handle>, py::arg("starts"), py::arg("goals"),
            WAYWRIGHT_PATH_QUERY_BATCH_ARGUMENTS, py::arg("tolerance") = py::none(), py::arg("wants_points") = true,
            py::arg("threads") = 1, py::arg("progress") = py::none(),
            R"(Finds a path for each pair of a start and a goal, on several threads.

``agent`` is one agent, or a list with one for each query. With ``tolerance``, the points of a disc's path are the points
of Path.polyline(). Without ``wants_points``, the answer has statuses and lengths only. ``progress`` is a function of two
numbers, how much is done and the total, or True for a bar of tqdm. Ctrl-C ends the call.

>>> batch = world.find_paths([(10, 45), (10, 70)], [(90, 45), (90, 70)], waywright.Agent(radius=5), threads=2)
>>> batch.lengths.round(3)
array([83.303, 80.   ])
)");
}

template void bind_path_batches(WorldClass& world);
template void bind_path_batches(SnapshotClass& snapshot);

}  // namespace waywright::python
