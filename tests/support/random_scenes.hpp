#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "waywright/point.hpp"
#include "waywright/scene.hpp"

#include "support/random.hpp"

namespace waywright::test {

/// What coordinates a random scene has.
enum class Flavour : std::uint8_t {
  lattice,    ///< a lattice of 9 x 9: nothing but degeneracies
  small,      ///< integers within ±8000
  large,      ///< integers within ±2^40
  mantissas,  ///< full mantissas within ±1
  mixed,      ///< doubles of wildly mixed size within ±2^100, and near-misses of 2^-50 of that size
};

inline constexpr std::array kFlavours{Flavour::lattice, Flavour::small, Flavour::large, Flavour::mantissas,
                                      Flavour::mixed};

[[nodiscard]] std::string_view to_string(Flavour flavour);
[[nodiscard]] std::optional<Flavour> flavour_of(std::string_view name);

/// A scene that is the same everywhere for the same arguments: points, segments, polylines and polygons of several
/// rings, with duplicates, overlaps, bundles through one point, corners on sides, self-crossings, zero lengths and
/// repeated points, on the domain's boundary and off it. Half of the polygons are nonzero ones, see give_fill_rules.
[[nodiscard]] Scene random_scene(Flavour flavour, std::uint64_t seed, std::size_t item_count);

/// Makes half of a scene's polygons nonzero ones. Some of these get rings that turn once more around their inside, or
/// back: a ring of theirs or of another polygon, as it is or the other way round, or their corners in another order.
void give_fill_rules(Scene& scene, std::uint64_t seed);

/// A point of the domain as the flavour has them.
[[nodiscard]] Point random_point(Flavour flavour, const Box& domain, Random& random);

}  // namespace waywright::test
