#pragma once

#include <vector>

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/ray.hpp"
#include "waywright/script.hpp"
#include "waywright/world.hpp"

#include "output.hpp"

namespace waywright::command {

/// How an operation of a script went.
enum class Outcome : unsigned char { done, refused, check_failed };

/// Carries out a script's operations, one by one, and prints their answers.
class Runner {
 public:
  Runner(World& world, StreamWriter& output) : world_(world), output_(output) {}

  Outcome carry_out(const Operation& operation);
  /// Validates the world; prints only a fault.
  [[nodiscard]] bool validate_after(const Operation& operation);
  /// The paths found since the world last changed.
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }

 private:
  Outcome insert(const Operation& operation);
  Outcome remove(const Operation& operation);
  Outcome replace(const Operation& operation);
  Outcome locate(const Operation& operation);
  Outcome cast_ray(const Operation& operation);
  Outcome find_path(const Operation& operation);
  Outcome check(const Operation& operation);
  Outcome refuse(const Operation& operation, const Error& error);
  Outcome refuse_unsupported(const Operation& operation);

  World& world_;
  StreamWriter& output_;
  QueryContext context_;
  Location location_;
  RayHit hit_;
  std::vector<Path> paths_;
};

}  // namespace waywright::command
