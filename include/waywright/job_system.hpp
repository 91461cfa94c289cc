#pragma once

#include <cstddef>
#include <functional>

#include "waywright/export.hpp"

namespace waywright {

/// Threads of the program's own, on which the library does what it shares among threads: a game's job system, a thread
/// pool. BulkOptions::jobs and World::find_paths take one. Without it the library starts threads itself, by std::async.
///
///     class PoolJobs : public waywright::JobSystem {
///      public:
///       explicit PoolJobs(Pool& pool) : pool_(pool) {}
///       void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
///         pool_.parallel_for(count, job);  // returns when all is done
///       }
///
///      private:
///       Pool& pool_;
///     };
///
/// Results do not depend on the job system.
class WAYWRIGHT_API JobSystem {
 public:
  JobSystem() = default;
  JobSystem(const JobSystem&) = default;
  JobSystem& operator=(const JobSystem&) = default;
  virtual ~JobSystem();

  /// Calls job(i) once for each i below `count` and returns when all these calls have returned.
  ///
  /// The calls may be made on any thread, the calling one included, in any order, at the same time or one after the
  /// other: no job waits for another. run() may also leave some calls out, for instance because no thread is idle. The
  /// library then makes these calls itself after run() has returned. When run() has returned, or thrown, no call may
  /// be made any more.
  ///
  /// The library calls run() on the thread that called the library, several times in one operation, and with a `count`
  /// of 2 or more. If several threads give the library the same job system at once, run() is called by them at once.
  ///
  /// Exceptions: `job` throws nothing; where memory runs out in a job, the library's own function throws std::bad_alloc
  /// when run() has returned. What run() throws comes out of the library's function, which has then changed no world.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& job) = 0;
};

}  // namespace waywright
