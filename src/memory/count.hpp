#pragma once

#include <cstddef>

#include "waywright/memory_use.hpp"

namespace waywright::memory {

/// Adds the memory of a vector's elements to `part`, and the memory of its unused capacity to the spare memory.
template <class Vector>
void count(MemoryUse& use, std::size_t MemoryUse::*part, const Vector& vector) {
  using Element = typename Vector::value_type;
  use.*part += vector.size() * sizeof(Element);
  use.spare += (vector.capacity() - vector.size()) * sizeof(Element);
}

/// Adds the memory of the whole capacity of vectors to the spare memory.
template <class... Vectors>
void count_spare(MemoryUse& use, const Vectors&... vectors) {
  use.spare += ((vectors.capacity() * sizeof(typename Vectors::value_type)) + ...);
}

/// Frees the unused capacity of vectors. If there is no memory for a smaller array, the vector does not change.
template <class... Vectors>
void shrink(Vectors&... vectors) {
  (vectors.shrink_to_fit(), ...);
}

/// Empties vectors and frees all their memory.
template <class... Vectors>
void release(Vectors&... vectors) noexcept {
  ((vectors = Vectors()), ...);
}

}  // namespace waywright::memory
