#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "waywright/world.hpp"

#include "constraint/exact_triangulation.hpp"
#include "path/abstraction.hpp"

namespace waywright {

struct WAYWRIGHT_INTERNAL World::Impl {
  Impl(const Box& domain, const WorldOptions& options) : triangulation(domain) {
    if (options.keep_abstraction) abstraction.emplace(triangulation);
  }
  ~Impl() { *version = kGone; }

  /// Inserts a batch as one operation.
  template <class Batch>
  void insert_all(const Batch& batch, const locate::Crew& crew = {});
  /// Or null.
  [[nodiscard]] const path::Abstraction* kept_abstraction() const { return abstraction ? &*abstraction : nullptr; }

  constraint::ExactTriangulation triangulation;
  std::optional<path::Abstraction> abstraction;
  static constexpr std::uint64_t kGone = std::numeric_limits<std::uint64_t>::max();
  std::shared_ptr<std::uint64_t> version = std::make_shared<std::uint64_t>(0);  ///< outlives the world; kGone then
};

/// Everything from its making to commit() happens or, if it goes before that (memory ran out), has never happened.
class WAYWRIGHT_INTERNAL World::Operation {
 public:
  explicit Operation(Impl& impl) : impl_(impl), operation_(impl.triangulation) {
    if (impl_.abstraction) impl_.abstraction->begin();
  }

  void insert(const Shape& shape, ItemId id) {
    impl_.triangulation.insert(shape, id);
    if (shape.kind == ItemKind::polygon) note_inserted(id);
  }
  template <class Batch>
  void insert_all(const Batch& batch, const locate::Crew& crew = {}) {
    impl_.triangulation.insert_all(batch, crew);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (batch.kind(i) == ItemKind::polygon) note_inserted(batch.id(i));
    }
  }
  void remove(ItemId id) {
    const std::uint32_t slot = impl_.triangulation.items().slot(id);
    if (impl_.abstraction && impl_.triangulation.items().is_polygon(slot)) impl_.abstraction->note_removed(slot);
    impl_.triangulation.remove(id);
  }
  void commit() {
    if (impl_.abstraction) impl_.abstraction->update(impl_.triangulation);
    operation_.commit();
    ++*impl_.version;
  }

 private:
  void note_inserted(ItemId id) {
    if (impl_.abstraction) impl_.abstraction->note_inserted(impl_.triangulation.items().slot(id));
  }

  Impl& impl_;
  constraint::ExactTriangulation::Operation operation_;
};

/// A world without items is made anew: a batch then needs no operation to be all or nothing.
template <class Batch>
void World::Impl::insert_all(const Batch& batch, const locate::Crew& crew) {
  if (triangulation.items().size() != 0) {
    Operation operation(*this);
    operation.insert_all(batch, crew);
    return operation.commit();
  }
  constraint::ExactTriangulation made(triangulation.domain(), batch, crew);
  made.see(triangulation.items().largest_id_seen());
  if (abstraction) abstraction = path::Abstraction(made);
  triangulation = std::move(made);
  ++*version;
}

}  // namespace waywright
