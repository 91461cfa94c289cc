#include "runner.hpp"

#include <string>
#include <utility>

#include "json_lines.hpp"
#include "picture.hpp"

namespace waywright::command {

namespace {

Request request_of(const ScriptLine& operation) { return {to_string(operation), operation.line}; }

}  // namespace

Outcome Runner::carry_out(const ScriptLine& operation) {
  switch (operation.kind) {
    case ScriptLineKind::insert:
      return insert(operation);
    case ScriptLineKind::locate:
      return locate(operation);
    case ScriptLineKind::path:
      return find_path(operation);
    case ScriptLineKind::check:
      return check(operation);
    case ScriptLineKind::remove:
      return remove(operation);
    case ScriptLineKind::replace:
      return replace(operation);
    case ScriptLineKind::hash:
      output_.write_line(json_line(request_of(operation), world_.items_hash(), world_.mesh_hash()));
      return Outcome::done;
    case ScriptLineKind::ray:
      return cast_ray(operation);
    case ScriptLineKind::clear:
      return test_clear(operation);
    case ScriptLineKind::disc:
      return fit_disc(operation);
    case ScriptLineKind::nearest:
      return find_nearest_fit(operation);
    case ScriptLineKind::tick:
      return compare_hash(operation);
    case ScriptLineKind::mark:
      static_cast<void>(world_.mark());  // the parser has compared its number
      return Outcome::done;
    case ScriptLineKind::rewind:
      return rewind(operation);
  }
  return Outcome::done;
}

bool Runner::validate_after(const ScriptLine& operation) {
  const Validation validation = world_.validate();
  if (!validation.ok) output_.write_line(json_line({"check", operation.line}, validation));
  return validation.ok;
}

Outcome Runner::insert(const ScriptLine& operation) {
  const Result<ItemId> inserted = world_.insert(operation.item.shape, operation.item.id);
  if (!inserted.ok()) return refuse(operation, inserted.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::remove(const ScriptLine& operation) {
  const Result<void> removed = world_.remove(operation.item.id);
  if (!removed.ok()) return refuse(operation, removed.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::replace(const ScriptLine& operation) {
  const Result<void> replaced = world_.replace(operation.item.id, operation.item.shape);
  if (!replaced.ok()) return refuse(operation, replaced.error());
  clear_queries();
  return Outcome::done;
}

Outcome Runner::locate(const ScriptLine& operation) {
  const Result<void> located = world_.locate(operation.from, context_, location_);
  if (!located.ok()) return refuse(operation, located.error());
  output_.write_line(json_line(request_of(operation), location_));
  if (overlay_ != nullptr) overlay_->locations.push_back({operation.from, location_});
  return Outcome::done;
}

Outcome Runner::cast_ray(const ScriptLine& operation) {
  const Result<void> cast = operation.has_radius
                                ? world_.sweep_disc(operation.from, operation.to, operation.radius, context_, hit_)
                                : world_.ray(operation.from, operation.to, hit_);
  if (!cast.ok()) return refuse(operation, cast.error());
  output_.write_line(json_line(request_of(operation), hit_, operation.has_radius ? RayOf::disc : RayOf::point));
  if (overlay_ != nullptr) overlay_->rays.push_back({operation.from, operation.to, hit_});
  return Outcome::done;
}

Outcome Runner::fit_disc(const ScriptLine& operation) {
  const Result<void> tried = world_.fit_disc(operation.from, operation.radius, context_, fit_);
  if (!tried.ok()) return refuse(operation, tried.error());
  output_.write_line(json_line(request_of(operation), fit_));
  return Outcome::done;
}

Outcome Runner::find_nearest_fit(const ScriptLine& operation) {
  NearestFitQuery query{.point = operation.from, .radius = operation.radius};
  if (operation.has_goal) query.goal = operation.to;
  NearestFit fit;
  const Result<void> searched = world_.nearest_fit(query, context_, fit);
  if (!searched.ok()) return refuse(operation, searched.error());
  output_.write_line(json_line(request_of(operation), fit));
  return Outcome::done;
}

Outcome Runner::find_path(const ScriptLine& operation) {
  PathQuery query{operation.from, operation.to, operation.radius, operation.algorithm.value_or(PathAlgorithm::optimal)};
  query.end_tolerance = operation.end_tolerance;
  Path path;
  const Result<void> searched = world_.find_path(query, context_, path);
  if (!searched.ok()) return refuse(operation, searched.error());
  output_.write_line(json_line(request_of(operation), path));
  if (overlay_ != nullptr) add_answer(*overlay_, query, std::move(path));
  return Outcome::done;
}

Outcome Runner::test_clear(const ScriptLine& operation) {
  const Result<bool> is_clear = world_.is_clear(operation.item.shape.rings.points(), context_);
  if (!is_clear.ok()) return refuse(operation, is_clear.error());
  output_.write_line(json_line(request_of(operation), *is_clear));
  return Outcome::done;
}

Outcome Runner::check(const ScriptLine& operation) {
  const Validation validation = world_.validate();
  output_.write_line(json_line(request_of(operation), validation));
  return validation.ok ? Outcome::done : Outcome::check_failed;
}

Outcome Runner::compare_hash(const ScriptLine& operation) {
  const ItemsHash computed = world_.items_hash();
  if (!operation.items_hash || *operation.items_hash == computed) return Outcome::done;
  output_.write_line(json_line(request_of(operation), operation.tick, *operation.items_hash, computed));
  return Outcome::check_failed;
}

Outcome Runner::rewind(const ScriptLine& operation) {
  const Result<void> rewound = world_.rewind(operation.tick);
  if (!rewound.ok()) return refuse(operation, rewound.error());
  clear_queries();
  return Outcome::done;
}

void Runner::clear_queries() {
  if (overlay_ != nullptr) *overlay_ = {};
}

Outcome Runner::refuse(const ScriptLine& operation, const Error& error) {
  output_.write_line(json_line(request_of(operation), error));
  return Outcome::refused;
}

}  // namespace waywright::command
