#pragma once

#include <cstdint>
#include <utility>

#include "waywright/world.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright {

struct World::Impl {
  explicit Impl(const Box& domain) : triangulation(domain) {}

  /// A world without items is made anew: a batch then needs no operation to be all or nothing.
  template <class Batch>
  void insert_all(const Batch& batch) {
    if (triangulation.items().size() == 0) {
      constraint::ExactTriangulation made(triangulation.domain(), batch);
      made.see(triangulation.items().largest_id_seen());
      triangulation = std::move(made);
    } else {
      constraint::ExactTriangulation::Operation operation(triangulation);
      triangulation.insert_all(batch);
      operation.commit();
    }
    ++version;
  }

  constraint::ExactTriangulation triangulation;
  std::uint64_t version = 0;
};

}  // namespace waywright
