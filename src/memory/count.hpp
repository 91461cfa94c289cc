#pragma once

#include <cstddef>

#include "waywright/memory_use.hpp"

namespace waywright::memory {

/// Counts a vector's elements in with a part, and the rest of its memory as spare.
template <class Vector>
void count(MemoryUse& use, std::size_t MemoryUse::*part, const Vector& vector) {
  using Element = typename Vector::value_type;
  use.*part += vector.size() * sizeof(Element);
  use.spare += (vector.capacity() - vector.size()) * sizeof(Element);
}

/// Counts all that vectors have as spare.
template <class... Vectors>
void count_spare(MemoryUse& use, const Vectors&... vectors) {
  use.spare += ((vectors.capacity() * sizeof(typename Vectors::value_type)) + ...);
}

/// Gives back what vectors have ready to grow into. Keeps it if there is no memory for the smaller array.
template <class... Vectors>
void shrink(Vectors&... vectors) {
  (vectors.shrink_to_fit(), ...);
}

/// Empties vectors and gives back all their memory.
template <class... Vectors>
void release(Vectors&... vectors) noexcept {
  ((vectors = Vectors()), ...);
}

}  // namespace waywright::memory
