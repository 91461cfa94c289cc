#pragma once

#include <cstddef>
#include <functional>

#include "world_handle.hpp"

namespace waywright::python {

/// A piece of a batch: the queries from `begin` up to `end`.
struct Chunk {
  std::size_t index = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The queries of a batch, divided into chunks, which threads answer one after the other.
class Batch {
 public:
  /// Requires: `threads` is 1 or more.
  Batch(std::size_t count, std::size_t threads);

  [[nodiscard]] std::size_t chunk_count() const { return chunk_count_; }
  [[nodiscard]] Chunk chunk(std::size_t index) const;

  /// Answers the queries of a chunk. Throws IndexedError if the world refuses one.
  using Answer = std::function<void(QueryContext& context, const Chunk& chunk)>;
  /// Calls `answer` for each chunk, on the calling thread and on others. Reports progress on the calling thread.
  /// Requires: the calling thread does not hold the GIL, and the world does not change.
  /// Exceptions: BadResult for the refused query with the smallest index. The exceptions of the reporter. After such an
  /// exception, some queries have no answer.
  void run(ContextPool& contexts, Reporter& reporter, const Answer& answer) const;

 private:
  std::size_t count_;
  std::size_t threads_;
  std::size_t chunk_size_;
  std::size_t chunk_count_;
};

/// Throws a BadResult that says that the world refused the query at `index`.
[[noreturn]] void refuse_query(Error error, std::size_t index);

}  // namespace waywright::python
