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

/// The kind of coordinates in a random scene.
enum class Flavour : std::uint8_t {
  lattice,    ///< a lattice of 9 x 9: almost everything is degenerate
  small,      ///< integers within ±8000
  large,      ///< integers within ±2^40
  mantissas,  ///< full mantissas within ±1
  mixed,      ///< doubles of very different sizes within ±2^100, and near-misses of 2^-50 of that size
};

inline constexpr std::array kFlavours{Flavour::lattice, Flavour::small, Flavour::large, Flavour::mantissas,
                                      Flavour::mixed};

[[nodiscard]] std::string_view to_string(Flavour flavour);
[[nodiscard]] std::optional<Flavour> flavour_of(std::string_view name);

/// Returns a scene that is the same on every platform for the same arguments. It contains points, segments, polylines
/// and polygons of several rings, with duplicates, overlaps, bundles through one point, corners on sides,
/// self-crossings, zero lengths and repeated points, on the domain's border and inside. Half of the polygons have the
/// fill rule nonzero, see give_fill_rules.
[[nodiscard]] Scene random_scene(Flavour flavour, std::uint64_t seed, std::size_t item_count);

/// Gives half of a scene's polygons the fill rule nonzero. Some of these get another ring, which adds a turn around
/// their inside or takes one away: a ring of the same or another polygon, as it is or reversed, or with its corners in
/// another order.
void give_fill_rules(Scene& scene, std::uint64_t seed);

/// Returns a point of the domain with coordinates of the flavour.
[[nodiscard]] Point random_point(Flavour flavour, const Box& domain, Random& random);

}  // namespace waywright::test
