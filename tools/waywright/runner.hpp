#pragma once

#include "waywright/error.hpp"
#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/ray.hpp"
#include "waywright/script.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "output.hpp"

namespace waywright::command {

/// The outcome of one operation of a script.
enum class Outcome : unsigned char { done, refused, check_failed };

/// Carries out the operations of a script, one by one, and prints their answers.
class Runner {
 public:
  /// Unless `overlay` is null, keeps in it the queries since the last change of the world, with their answers.
  Runner(World& world, StreamWriter& output, SvgOverlay* overlay) : world_(world), output_(output), overlay_(overlay) {}

  Outcome carry_out(const ScriptLine& operation);
  /// Validates the world after an operation. Prints only an error.
  [[nodiscard]] bool validate_after(const ScriptLine& operation);

 private:
  Outcome insert(const ScriptLine& operation);
  Outcome remove(const ScriptLine& operation);
  Outcome replace(const ScriptLine& operation);
  Outcome locate(const ScriptLine& operation);
  Outcome cast_ray(const ScriptLine& operation);
  Outcome fit_disc(const ScriptLine& operation);
  Outcome find_nearest_fit(const ScriptLine& operation);
  Outcome find_path(const ScriptLine& operation);
  Outcome test_clear(const ScriptLine& operation);
  Outcome check(const ScriptLine& operation);
  Outcome compare_hash(const ScriptLine& operation);
  Outcome rewind(const ScriptLine& operation);
  void clear_queries();
  Outcome refuse(const ScriptLine& operation, const Error& error);

  World& world_;
  StreamWriter& output_;
  SvgOverlay* overlay_;
  QueryContext context_;
  Location location_;
  RayHit hit_;
  DiscFit fit_;
};

}  // namespace waywright::command
