#pragma once

#include <cstddef>
#include <functional>

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// An interface to the threads of your program, for example the job system of a game or a thread pool. Derive a class
/// from it if the library should run its parallel work on your threads. BulkOptions::jobs and World::find_paths take a
/// job system. Without a job system, the library starts threads itself, by std::async.
///
/// @code{.cpp}
/// class PoolJobs : public JobSystem {
///  public:
///   explicit PoolJobs(Pool& pool) : pool_(pool) {}
///   void run(std::size_t count, const std::function<void(std::size_t)>& job) override {
///     pool_.parallel_for(count, job);  // returns when all calls have returned
///   }
///
///  private:
///   Pool& pool_;
/// };
///
/// PoolJobs jobs(pool);
/// const std::vector<Path> paths = world.find_paths(queries, 4, &jobs).value();
/// @endcode
///
/// Results do not depend on the job system.
class WAYWRIGHT_API JobSystem {
 public:
  JobSystem() = default;
  JobSystem(const JobSystem&) = default;
  JobSystem& operator=(const JobSystem&) = default;
  virtual ~JobSystem();

  /// Calls job(i) once for each i below `count`, and returns when all these calls have returned.
  ///
  /// Your run() may make the calls on any thread (the calling thread, too), in any order, at the same time or one after
  /// the other. No job waits for another job. Your run() may also omit calls, for example because no thread is idle.
  /// The library then makes these calls itself after run() has returned. As soon as run() has returned or thrown, your
  /// program must not call `job` any more, on any thread.
  ///
  /// The library calls run() on the thread that called the library, several times in one operation, and with a `count`
  /// of 2 or more. If several threads use the library with the same job system at the same time, run() can be called on
  /// these threads at the same time.
  ///
  /// Exceptions: `job` throws nothing. If memory runs out in a job, the function of the library that called run()
  /// throws std::bad_alloc after run() has returned. If run() throws, the same function passes the exception on and
  /// changes no world.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& job) = 0;
};

/// @}

}  // namespace waywright
