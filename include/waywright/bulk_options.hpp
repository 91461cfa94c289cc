#pragma once

#include <cstddef>
#include <functional>

#include "waywright/job_system.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The options of World::insert_all and World::insert_points.
///
/// @code{.cpp}
/// BulkOptions options;
/// options.threads = 2;
/// options.progress = [](std::size_t done, std::size_t total) { std::printf("%zu of %zu\n", done, total); };
/// world.insert_points({{1, 1}, {2, 1}, {3, 1}}, 100, options).value();
/// @endcode
struct BulkOptions {
  /// The number of threads, 1 or more, including the calling thread. The world is the same for any number. More than
  /// one thread makes the call faster if the world has no items yet. With a job system, this is the number of jobs that
  /// may run at the same time. A number above 256 counts as 256.
  std::size_t threads = 1;
  /// A function that the library calls on the calling thread from time to time, and at the end with `done` equal to
  /// `total`. Only the ratio of the two numbers has a meaning: what they count may differ in other versions. The
  /// function must not use the world. If it throws an exception, the call ends with this exception. If it throws in the
  /// last report, the world contains the items. If it throws in an earlier report, the world does not change.
  std::function<void(std::size_t done, std::size_t total)> progress;
  /// The job system that provides the other threads. If it is null, the library starts threads.
  JobSystem* jobs = nullptr;
};

/// @}

}  // namespace waywright
