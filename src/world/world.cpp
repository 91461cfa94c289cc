#include "waywright/world.hpp"

#include <memory>
#include <string>
#include <utility>

#include "base/float_environment.hpp"
#include "constraint/canonical.hpp"
#include "text/sha256.hpp"
#include "world/query_errors.hpp"
#include "world/query_scratch.hpp"
#include "world/world_impl.hpp"

namespace waywright {

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const Box& domain, const WorldOptions& options) {
  const base::FloatEnvironment environment;
  if (auto error = find_range_error(domain.min, 0, "the domain's min")) return *std::move(error);
  if (auto error = find_range_error(domain.max, 1, "the domain's max")) return *std::move(error);
  if (!(domain.min.x < domain.max.x && domain.min.y < domain.max.y)) {
    return Error{ErrorCode::bad_domain, "a domain needs min.x < max.x and min.y < max.y", {}, 0};
  }
  const Box normalised{{domain.min.x + 0.0, domain.min.y + 0.0}, {domain.max.x + 0.0, domain.max.y + 0.0}};
  return World(std::make_unique<Impl>(normalised, options));
}

World World::clone() const {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  return World(std::make_unique<Impl>(*impl_, impl_->history));
}

const Box& World::domain() const { return impl_->triangulation().domain(); }

WorldOptions World::options() const {
  const Kept kept = impl_->layers.kept();
  return {.keep_abstraction = kept.has_abstraction,
          .keep_bridges = kept.has_bridges,
          .new_vertex_limit = impl_->limits.of_operation};
}

std::size_t World::new_vertex_limit() const { return impl_->limits.of_operation; }

void World::set_new_vertex_limit(std::size_t limit) {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  impl_->limits.of_operation = limit;
}

std::uint64_t World::version() const { return impl_->version(); }

std::size_t World::vertex_count() const { return impl_->triangulation().topology().vertex_count() - 1; }

// There are as many ghost faces as vertices on the border of the domain. A triangulated sphere with V vertices has
// 2 V - 4 faces.
std::size_t World::triangle_count() const {
  const mesh::TriangleMesh& mesh = impl_->triangulation().topology();
  std::size_t border = 0;
  mesh.for_each_outgoing(impl_->triangulation().triangulation().ghost(), [&](mesh::HalfEdge) { ++border; });
  return mesh.face_count() - border;
}

MemoryUse World::Impl::memory() const {
  MemoryUse use;
  use.spare = sizeof(Impl) + sizeof(TouchLog);
  layers.count_memory(use);
  change_log.count_memory(use);
  history.count_memory(use);
  touch_log->count_memory(use);
  memory::count_spare(use, outline.corners, outline.ring_ends);
  return use;
}

MemoryUse World::memory() const {
  MemoryUse use = impl_->memory();
  if (impl_->snapshots) impl_->snapshots->count_memory(use);
  return use;
}

void World::shrink_to_fit() {
  WAYWRIGHT_ASSERT(!impl_->attempt, kInAttempt);
  impl_->layers.shrink_to_fit();
  impl_->change_log.shrink_to_fit();
  impl_->history.shrink_to_fit();
  impl_->touch_log->shrink_to_fit();
  impl_->spare_context.release();
  impl_->snapshots.reset();
  memory::release(impl_->outline.corners, impl_->outline.ring_ends);
}

Validation World::validate() const {
  const base::FloatEnvironment environment;
  auto fault = impl_->layers.find_fault();
  if (!fault) return {};
  return {false, *std::move(fault)};
}

ItemsHash World::items_hash() const { return {impl_->triangulation().items().hash()}; }

MeshHash World::mesh_hash() const { return {text::sha256(dump())}; }

void World::snapshot(QueryContext& context, MeshSnapshot& snapshot) const {
  const base::FloatEnvironment environment;
  constraint::take_snapshot(impl_->triangulation(), *context.scratch_->order, snapshot);
}

MeshSnapshot World::snapshot() const {
  QueryContext context;
  MeshSnapshot snapshot;
  this->snapshot(context, snapshot);
  return snapshot;
}

std::string World::dump() const {
  const base::FloatEnvironment environment;
  return constraint::dump(impl_->triangulation());
}

}  // namespace waywright
