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

/// Returns the capacity for an array that a bulk load fills with `count` elements. The spare share (1/64) lets the next
/// operations add elements without a copy of the whole array.
[[nodiscard]] constexpr std::size_t with_spare(std::size_t count) { return count + count / 64; }

/// Frees the unused capacity of vectors and arrays. If there is no memory for a smaller one, it does not change.
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
