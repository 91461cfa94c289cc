#include "runner.hpp"

#include <string>
#include <utility>

#include "json_lines.hpp"
#include "picture.hpp"

namespace waywright::command {

namespace {

Request request_of(const ScriptLine& line) { return {to_string(line), line.line}; }

}  // namespace

Outcome Runner::carry_out(const ScriptLine& line) {
  switch (line.kind) {
    case ScriptLineKind::insert:
      return insert(line);
    case ScriptLineKind::locate:
      return locate(line);
    case ScriptLineKind::path:
      return find_path(line);
    case ScriptLineKind::check:
      return check(line);
    case ScriptLineKind::remove:
      return remove(line);
    case ScriptLineKind::replace:
      return replace(line);
    case ScriptLineKind::hash:
      output_.write_line(json_line(request_of(line), world_.items_hash(), world_.mesh_hash()));
      return Outcome::done;
    case ScriptLineKind::ray:
      return cast_ray(line);
    case ScriptLineKind::clear:
      return test_clear(line);
    case ScriptLineKind::disc:
      return fit_disc(line);
    case ScriptLineKind::nearest:
      return find_nearest_fit(line);
    case ScriptLineKind::tick:
      return compare_hash(line);
    case ScriptLineKind::mark:
      static_cast<void>(world_.mark());  // the parser has compared its number
      return Outcome::done;
    case ScriptLineKind::rewind:
      return rewind(line);
  }
  return Outcome::done;
}

bool Runner::validate_after(const ScriptLine& line) {
  const Validation validation = world_.validate();
  if (!validation.ok) output_.write_line(json_line({"check", line.line}, validation));
  return validation.ok;
}

Outcome Runner::insert(const ScriptLine& line) {
  const Result<ItemId> inserted = world_.insert(line.item.shape, line.item.id);
  if (!inserted.ok()) return refuse(line, inserted.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::remove(const ScriptLine& line) {
  const Result<void> removed = world_.remove(line.item.id);
  if (!removed.ok()) return refuse(line, removed.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::replace(const ScriptLine& line) {
  const Result<void> replaced = world_.replace(line.item.id, line.item.shape);
  if (!replaced.ok()) return refuse(line, replaced.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::locate(const ScriptLine& line) {
  const Result<void> located = world_.locate(line.from, context_, location_);
  if (!located.ok()) return refuse(line, located.error());
  output_.write_line(json_line(request_of(line), location_));
  if (overlay_ != nullptr) overlay_->locations.push_back({line.from, location_});
  return Outcome::done;
}

Outcome Runner::cast_ray(const ScriptLine& line) {
  const Result<void> cast = world_.ray(line.from, line.to, line.agent, context_, hit_);
  if (!cast.ok()) return refuse(line, cast.error());
  output_.write_line(json_line(request_of(line), hit_, line.has_radius ? RayOf::disc : RayOf::point));
  if (overlay_ != nullptr) overlay_->rays.push_back({line.from, line.to, hit_});
  return Outcome::done;
}

Outcome Runner::fit_disc(const ScriptLine& line) {
  const Result<void> tried = world_.fit_disc(line.from, line.agent, context_, fit_);
  if (!tried.ok()) return refuse(line, tried.error());
  output_.write_line(json_line(request_of(line), fit_));
  return Outcome::done;
}

Outcome Runner::find_nearest_fit(const ScriptLine& line) {
  NearestFitQuery query{.point = line.from, .agent = line.agent};
  if (line.has_goal) query.goal = line.to;
  NearestFit fit;
  const Result<void> searched = world_.nearest_fit(query, context_, fit);
  if (!searched.ok()) return refuse(line, searched.error());
  output_.write_line(json_line(request_of(line), fit));
  return Outcome::done;
}

Outcome Runner::find_path(const ScriptLine& line) {
  PathQuery query{line.from, line.to, line.agent, line.algorithm.value_or(PathAlgorithm::optimal)};
  query.end_tolerance = line.end_tolerance;
  Path path;
  const Result<void> searched = world_.find_path(query, context_, path);
  if (!searched.ok()) return refuse(line, searched.error());
  output_.write_line(json_line(request_of(line), path));
  if (overlay_ != nullptr) add_answer(*overlay_, query, std::move(path));
  return Outcome::done;
}

Outcome Runner::test_clear(const ScriptLine& line) {
  const Result<bool> is_clear = world_.is_clear(line.item.shape.rings.points(), {}, context_);
  if (!is_clear.ok()) return refuse(line, is_clear.error());
  output_.write_line(json_line(request_of(line), *is_clear));
  return Outcome::done;
}

Outcome Runner::check(const ScriptLine& line) {
  const Validation validation = world_.validate();
  output_.write_line(json_line(request_of(line), validation));
  return validation.ok ? Outcome::done : Outcome::check_failed;
}

Outcome Runner::compare_hash(const ScriptLine& line) {
  const ItemsHash computed = world_.items_hash();
  if (!line.items_hash || *line.items_hash == computed) return Outcome::done;
  output_.write_line(json_line(request_of(line), line.tick, *line.items_hash, computed));
  return Outcome::check_failed;
}

Outcome Runner::rewind(const ScriptLine& line) {
  const Result<void> rewound = world_.rewind(line.tick);
  if (!rewound.ok()) return refuse(line, rewound.error());
  clear_queries();
  return Outcome::done;
}

void Runner::clear_queries() {
  if (overlay_ != nullptr) *overlay_ = {};
}

Outcome Runner::refuse(const ScriptLine& line, const Error& error) {
  output_.write_line(json_line(request_of(line), error));
  return Outcome::refused;
}

}  // namespace waywright::command
