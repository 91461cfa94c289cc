#pragma once

#include "waywright/error.hpp"
#include "waywright/location.hpp"
#include "waywright/path.hpp"
#include "waywright/query_context.hpp"
#include "waywright/script.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"

#include "output.hpp"

namespace waywright::command {

/// The outcome of one line of a script.
enum class Outcome : unsigned char { done, refused, check_failed };

/// Carries out the lines of a script, one by one, and prints their answers.
class Runner {
 public:
  /// Unless `overlay` is null, keeps in it the queries since the last change of the world, with their answers.
  Runner(World& world, StreamWriter& output, SvgOverlay* overlay) : world_(world), output_(output), overlay_(overlay) {}

  Outcome carry_out(const ScriptLine& line);
  /// Validates the world after a line. Prints only an error.
  [[nodiscard]] bool validate_after(const ScriptLine& line);

 private:
  Outcome insert(const ScriptLine& line);
  Outcome remove(const ScriptLine& line);
  Outcome replace(const ScriptLine& line);
  Outcome locate(const ScriptLine& line);
  Outcome cast_ray(const ScriptLine& line);
  Outcome fit_disc(const ScriptLine& line);
  Outcome find_nearest_fit(const ScriptLine& line);
  Outcome find_path(const ScriptLine& line);
  Outcome test_clear(const ScriptLine& line);
  Outcome check(const ScriptLine& line);
  Outcome compare_hash(const ScriptLine& line);
  Outcome rewind(const ScriptLine& line);
  void clear_queries();
  Outcome refuse(const ScriptLine& line, const Error& error);

  World& world_;
  StreamWriter& output_;
  SvgOverlay* overlay_;
  QueryContext context_;
  Location location_;
  RayHit hit_;
  DiscFit fit_;
};

}  // namespace waywright::command
