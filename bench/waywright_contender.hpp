#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "waywright/world.hpp"

#include "workloads.hpp"

namespace waywright::bench {

/// Options for a triangulation without the path abstraction, as the other contenders have none.
inline constexpr WorldOptions kMeshOnly{.keep_abstraction = false};

/// This library. An update is a removal and an insertion.
class Waywright {
 public:
  explicit Waywright(const Box& domain, const WorldOptions& options = kMeshOnly)
      : world_(World::create(domain, options).value()) {}

  void insert(const Item& item) { static_cast<void>(world_.insert(item.shape, item.id).value()); }

  void update(const Update& update) {
    if (!update.removed.is_null()) world_.remove(update.removed).value();
    if (!update.inserted.id.is_null()) insert(update.inserted);
  }

  [[nodiscard]] MeshSnapshot snapshot() const { return world_.snapshot(); }
  [[nodiscard]] std::size_t vertex_count() const { return world_.vertex_count(); }
  [[nodiscard]] std::string fault() const { return world_.validate().fault; }

 protected:
  World& world() { return world_; }

 private:
  World world_;
};

/// This library. An update replaces a shape. For workloads that keep their ids.
class WaywrightReplace : public Waywright {
 public:
  using Waywright::Waywright;

  void update(const Update& update) { world().replace(update.removed, update.inserted.shape).value(); }
};

/// One of the contenders above, which also maintains the path abstraction.
template <class Contender>
class ForPaths : public Contender {
 public:
  explicit ForPaths(const Box& domain) : Contender(domain, WorldOptions{}) {}
};

/// One of the contenders above, which also maintains the path abstraction and the bridges, for paths of discs.
template <class Contender>
class ForDiscs : public Contender {
 public:
  explicit ForDiscs(const Box& domain) : Contender(domain, WorldOptions{.keep_bridges = true}) {}
};

}  // namespace waywright::bench
