#include "world/replica_prefetch.hpp"

namespace waywright {

void ReplicaPrefetch::run(const Triangulation& replica, const Triangulation& world, const nav::Abstraction* abstraction,
                          std::span<const ItemId> ids) {
  constexpr int kSteps = 8;  // few vertices have more edges
  find_corners(replica, world, ids);
  const auto& geometry = world.triangulation().geometry();
  spokes_.clear();
  for (const mesh::Vertex v : corners_) {
    const mesh::HalfEdge h = replica.topology().outgoing(v);
    spokes_.push_back({h, h, mesh::face(h)});
    replica.triangulation().prefetch_star(v);
  }
  for (const mesh::Vertex v : new_corners_) replica.triangulation().prefetch_start(geometry.rounded(number(v)));
  advance_spokes(replica, abstraction);
  starts_.clear();
  for (const mesh::Vertex v : new_corners_) {
    const mesh::Vertex start = replica.triangulation().probable_start(geometry.rounded(number(v)));
    if (start == mesh::kNoVertex) continue;
    replica.triangulation().prefetch(start);
    starts_.push_back(start);
  }
  advance_spokes(replica, abstraction);
  for (const mesh::Vertex v : starts_) {
    if (replica.topology().is_live(v)) replica.topology().prefetch(replica.topology().outgoing(v));
  }
  for (int i = 2; i < kSteps; ++i) advance_spokes(replica, abstraction);
}

/// Fills `corners_` and `new_corners_`, and prefetches their positions.
void ReplicaPrefetch::find_corners(const Triangulation& replica, const Triangulation& world,
                                   std::span<const ItemId> ids) {
  for (const ItemId id : ids) {
    replica.items().prefetch_record(id);
    world.items().prefetch_record(id);
  }
  const auto has_sides = [](const Triangulation& triangulation, ItemId id) {
    const constraint::ItemTable& items = triangulation.items();
    return items.contains(id) && items.kind(items.slot(id)) != ItemKind::point;
  };
  for (const ItemId id : ids) {
    for (const Triangulation* each : {&replica, &world}) {
      if (has_sides(*each, id)) each->items().prefetch_sides(each->items().slot(id));
    }
  }
  corners_.clear();
  new_corners_.clear();
  for (const ItemId id : ids) {
    if (replica.items().contains(id)) {
      replica.items().for_each_corner(replica.items().slot(id), [&](mesh::Vertex v, bool) {
        corners_.push_back(v);
        replica.triangulation().prefetch(v);
        replica.prefetch_corner_uses(v);
      });
    }
    if (world.items().contains(id)) {
      world.items().for_each_corner(world.items().slot(id), [&](mesh::Vertex v, bool) {
        new_corners_.push_back(v);
        world.triangulation().prefetch(v);
      });
    }
  }
}

/// Replaces each spoke by the next one around its vertex, and prefetches what the changes read around its face. Drops
/// the spokes that have gone around their vertex.
void ReplicaPrefetch::advance_spokes(const Triangulation& replica, const nav::Abstraction* abstraction) {
  const mesh::TriangleMesh& mesh = replica.topology();
  std::size_t kept = 0;
  for (Spoke spoke : spokes_) {
    const mesh::HalfEdge h = spoke.h;
    replica.triangulation().prefetch(mesh.target(h));
    const mesh::HalfEdge beyond = mesh.twin(mesh::next(h));
    mesh.prefetch(beyond);
    mesh.prefetch_label(h);
    if (abstraction != nullptr) {
      abstraction->prefetch_component_of(mesh::face(h));
      abstraction->core().prefetch(mesh::face(h));
      abstraction->components().prefetch_component(spoke.before);
      abstraction->prefetch_component_of(mesh::face(beyond));
    }
    spoke.before = mesh::face(h);
    spoke.h = mesh.next_around(h);
    if (spoke.h == spoke.first) continue;
    mesh.prefetch(spoke.h);
    spokes_[kept++] = spoke;
  }
  spokes_.resize(kept);
}

}  // namespace waywright
