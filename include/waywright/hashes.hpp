#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "waywright/export.hpp"

namespace waywright {

/// @addtogroup world
/// @{

/// The hash of the domain and the live items of a world. World::items_hash returns it. Two worlds with equal domains
/// and equal live items have equal hashes, on every machine and whatever operations led to these items. In practice,
/// two worlds with equal hashes have equal domains and equal items. docs/hashes.md defines the hash, so that other
/// programs can compute it.
///
/// @code{.cpp}
/// const ItemsHash before = world.items_hash();
/// const ItemId id = world.insert_point({3, 3}).value();
/// world.remove(id).value();
/// const bool is_same = world.items_hash() == before;  // == true
/// std::printf("items %s, mesh %s\n", to_string(before).c_str(), to_string(world.mesh_hash()).c_str());
/// @endcode
struct ItemsHash {
  std::array<std::uint64_t, 2> words{};

  friend bool operator==(const ItemsHash&, const ItemsHash&) = default;
};
/// The hash of the mesh of a world: the SHA-256 of its dump. World::mesh_hash returns it. Two worlds with equal domains
/// and equal live items have equal hashes of the mesh, on every machine. docs/hashes.md defines the hash.
struct MeshHash {
  std::array<std::uint8_t, 32> bytes{};

  friend bool operator==(const MeshHash&, const MeshHash&) = default;
};

/// Returns the hash as 32 hexadecimal digits.
[[nodiscard]] WAYWRIGHT_API std::string to_string(const ItemsHash& hash);
/// Returns the hash as 64 hexadecimal digits.
[[nodiscard]] WAYWRIGHT_API std::string to_string(const MeshHash& hash);

/// The answer of World::validate. The function checks the links between triangles; the orientation of each triangle;
/// that the triangles fill the domain and do not overlap; the constrained edges against the items; the empty-circle
/// property of each free edge, and which of two possible edges the mesh contains if four vertices lie on one circle;
/// and that the path abstraction and the bridges equal an abstraction and bridges that it builds anew from the mesh.
///
/// @code{.cpp}
/// const Validation validation = world.validate();
/// if (!validation.ok) std::puts(validation.fault.c_str());
/// @endcode
struct Validation {
  bool ok = true;
  std::string fault;  ///< the first fault; empty if `ok`
};

/// @}

}  // namespace waywright
