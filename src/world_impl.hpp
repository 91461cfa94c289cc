#pragma once

#include <cstdint>

#include "waywright/world.hpp"

#include "constraint/exact_triangulation.hpp"

namespace waywright {

struct World::Impl {
  explicit Impl(const Box& domain) : triangulation(domain) {}

  constraint::ExactTriangulation triangulation;
  std::uint64_t version = 0;
};

}  // namespace waywright
