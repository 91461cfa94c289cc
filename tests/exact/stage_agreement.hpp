#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/crossing.hpp"
#include "exact/predicates.hpp"
#include "support/random.hpp"

namespace waywright::test {

/// Kinds of points whose determinants are often zero or nearly zero.
enum class NearMiss : unsigned char {
  small_lattice,   ///< integers up to 8: many collinear and cocircular points
  decimals,        ///< multiples of 0.1
  on_a_line,       ///< doubles next to a line
  on_a_circle,     ///< doubles next to a circle
  crossings,       ///< crossings of walls between points of a small lattice, and such points
  fine_crossings,  ///< crossings of nearly parallel walls between doubles
  far_crossings,   ///< the same, a thousand times nearer to one another than to the origin
  flat_crossings,  ///< the same as fine_crossings, with all y coordinates times 2^-40
  steep_crossings  ///< the same as flat_crossings, with x and y exchanged
};
inline constexpr std::array kNearMisses = {
    NearMiss::small_lattice, NearMiss::decimals,       NearMiss::on_a_line,
    NearMiss::on_a_circle,   NearMiss::crossings,      NearMiss::fine_crossings,
    NearMiss::far_crossings, NearMiss::flat_crossings, NearMiss::steep_crossings};

inline std::string_view to_string(NearMiss kind) {
  constexpr std::array<std::string_view, 9> kNames = {"small_lattice", "decimals",       "on_a_line",
                                                      "on_a_circle",   "crossings",      "fine_crossings",
                                                      "far_crossings", "flat_crossings", "steep_crossings"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// A thousand points of one kind.
class NearMisses {
 public:
  NearMisses(NearMiss kind, std::uint64_t seed) : random_(seed) {
    while (points_.size() < 1000) add(kind);
  }

  [[nodiscard]] const exact::ExactPosition& any() { return points_[random_.below(points_.size())]; }

 private:
  double between(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }
  double fraction() { return between(0, std::int64_t{1} << 53) * 0x1p-53; }
  double nudge() { return between(-2, 2) * 0x1p-52; }

  void add(NearMiss kind) {
    switch (kind) {
      case NearMiss::small_lattice:
        points_.push_back({between(-8, 8), between(-8, 8)});
        break;
      case NearMiss::decimals:
        points_.push_back({between(0, 30) * 0.1, between(0, 30) * 0.1});
        break;
      case NearMiss::on_a_line: {
        const double t = fraction();
        points_.push_back({0.1 + 0.7 * t + nudge(), 0.3 + 0.6 * t + nudge()});
        break;
      }
      case NearMiss::on_a_circle: {
        const double t = fraction();
        points_.push_back({(1 - t * t) / (1 + t * t) + nudge(), 2 * t / (1 + t * t) + nudge()});
        break;
      }
      case NearMiss::crossings:
        if (random_.chance(30)) points_.push_back({between(-4, 4), between(-4, 4)});
        add_crossing({lattice_point(), lattice_point(), lattice_point(), lattice_point()});
        break;
      case NearMiss::fine_crossings:
        add_crossing({{0.0, fraction()}, {1.0, fraction()}, {0.1, 0.5 + nudge()}, {0.9, 0.5 + nudge()}});
        break;
      case NearMiss::far_crossings: {
        const auto far = [&](double x, double y) -> Point { return {0.7 + x * 0x1p-10, 0.6 + y * 0x1p-10}; };
        const auto level = [&] { return 0.5 + between(-2, 2) * 0x1p-43; };
        add_crossing({far(0.0, fraction()), far(1.0, fraction()), far(0.1, level()), far(0.9, level())});
        break;
      }
      case NearMiss::flat_crossings:
      case NearMiss::steep_crossings: {
        const auto thin = [&](double along, double across) -> Point {
          across *= 0x1p-40;
          return kind == NearMiss::flat_crossings ? Point{along, across} : Point{across, along};
        };
        const Point end = thin(0.0, fraction());
        if (random_.chance(5)) points_.push_back(exact::explicit_position(end));
        add_crossing({end, thin(1.0, fraction()), thin(0.1, 0.5 + nudge()), thin(0.9, 0.5 + nudge())});
        break;
      }
    }
  }
  Point lattice_point() { return {between(-4, 4), between(-4, 4)}; }

  void add_crossing(const exact::Crossing& crossing) {
    const auto& [a, b] = crossing.ab;
    const auto& [c, d] = crossing.cd;
    if ((b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x)) return;
    const exact::RoundedCrossing rounded = exact::integers::round_to_nearest(crossing);
    if (rounded.is_exact) {
      points_.push_back(exact::explicit_position(rounded.nearest));
      return;
    }
    crossings_.push_back(crossing);
    points_.push_back({rounded.nearest.x, rounded.nearest.y, &crossings_.back()});
  }

  Random random_;
  std::deque<exact::Crossing> crossings_;
  std::vector<exact::ExactPosition> points_;
};

struct Agreement {
  std::uint64_t calls = 0;             ///< rounds: one call each of orientation, in-circle and order
  std::uint64_t doubles = 0;           ///< rounds in which the first stage decided both signs
  std::uint64_t on_lattice = 0;        ///< rounds in which the second stage could decide all three
  std::uint64_t against_integers = 0;  ///< rounds that the last stage checked too
  std::string fault;                   ///< the first disagreement, or empty

  Agreement& operator+=(const Agreement& other) {
    calls += other.calls;
    doubles += other.doubles;
    on_lattice += other.on_lattice;
    against_integers += other.against_integers;
    return *this;
  }
};

/// Returns the sign that the bounds give for a box that holds just these points.
inline exact::Sign orientation_in_box(const exact::ExactPosition& a, const exact::ExactPosition& b,
                                      const exact::ExactPosition& c) {
  const Box box = {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                   {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
  return exact::filter::sign_beyond(exact::filter::orientation_determinant(a, b, c),
                                    exact::filter::largest_orientation_error(box));
}

inline exact::Sign in_circle_in_box(const exact::ExactPosition& a, const exact::ExactPosition& b,
                                    const exact::ExactPosition& c, const exact::ExactPosition& d) {
  const Box box = {{std::min({a.x, b.x, c.x, d.x}), std::min({a.y, b.y, c.y, d.y})},
                   {std::max({a.x, b.x, c.x, d.x}), std::max({a.y, b.y, c.y, d.y})}};
  return exact::filter::coarse::in_circle(a, b, c, d, exact::filter::coarse::in_circle_position_term(box));
}
/// Returns the sign that the coarse bound gives from the position of the last point alone.
inline exact::Sign coarse_in_circle(const exact::ExactPosition& a, const exact::ExactPosition& b,
                                    const exact::ExactPosition& c, const exact::ExactPosition& d) {
  return exact::filter::coarse::in_circle(a, b, c, d, exact::filter::coarse::in_circle_position_term(d));
}

/// Compares the first stage, with each of its bounds, with the second stage in all calls. Compares both with the last
/// stage in every n-th call. Checks that swapped arguments give the opposite sign.
inline Agreement compare_stages(NearMiss kind, std::uint64_t seed, std::uint64_t calls, std::uint64_t every_nth) {
  NearMisses source(kind, seed);
  Agreement result;
  const auto misleads = [](exact::Sign bounded, const std::optional<exact::Sign>& right) {
    return bounded != exact::Sign::zero && right && bounded != *right;
  };
  const auto differ = [](const auto& one, const auto& other) { return one && other && *one != *other; };
  for (; result.calls < calls && result.fault.empty(); ++result.calls) {
    const exact::ExactPosition &a = source.any(), &b = source.any(), &c = source.any(), &d = source.any();
    const auto turn = exact::filter::fine::orientation(a, b, c);
    const exact::Sign coarse_turn = exact::filter::coarse::orientation(a, b, c);
    const exact::Sign boxed_turn = orientation_in_box(a, b, c);
    const auto lattice_turn = exact::lattice::orientation(a, b, c);
    const auto circle = exact::filter::fine::in_circle(a, b, c, d);
    const exact::Sign coarse_circle = coarse_in_circle(a, b, c, d);
    const exact::Sign boxed_circle = in_circle_in_box(a, b, c, d);
    const auto whole_circle = exact::lattice::whole_in_circle(a, b, c, d);
    const auto lattice_circle = exact::lattice::in_circle(a, b, c, d);
    const auto order = exact::lattice::compare(a, b);
    result.doubles += turn && circle ? 1 : 0;
    result.on_lattice += lattice_turn && lattice_circle && order ? 1 : 0;
    if (differ(turn, lattice_turn)) result.fault = "orientation: doubles against lattice";
    if (differ(circle, lattice_circle)) result.fault = "in-circle: doubles against lattice";
    if (differ(exact::any_origin::in_circle(a, b, c, d), lattice_circle)) result.fault = "in-circle: any origin";
    if (differ(whole_circle, lattice_circle)) result.fault = "in-circle: whole numbers against lattice";
    for (const auto& exact_turn : {turn, lattice_turn}) {
      if (misleads(coarse_turn, exact_turn)) result.fault = "orientation: coarse bound";
      if (misleads(boxed_turn, exact_turn)) result.fault = "orientation: bound of the box";
    }
    for (const auto& exact_circle : {circle, lattice_circle}) {
      if (misleads(coarse_circle, exact_circle)) result.fault = "in-circle: coarse bound";
      if (misleads(boxed_circle, exact_circle)) result.fault = "in-circle: bound of the box";
    }
    if (order && *order != exact::compare(a, b)) result.fault = "order: doubles against lattice";
    const auto swapped_turn = exact::lattice::orientation(b, a, c);
    const auto swapped_circle = exact::lattice::in_circle(a, b, d, c);
    // Which of the points is the origin may decide whether a suitable lattice exists.
    if (lattice_turn && swapped_turn && *lattice_turn != -*swapped_turn) result.fault = "orientation: swapped";
    if (lattice_circle && swapped_circle && *lattice_circle != -*swapped_circle) result.fault = "in-circle: swapped";
    if (result.calls % every_nth != 0) continue;
    ++result.against_integers;
    const exact::Sign right_turn = exact::integers::orientation(a, b, c);
    if (exact::orientation(a, b, c) != right_turn) result.fault = "orientation: integers";
    if (turn && *turn != right_turn) result.fault = "orientation: doubles against integers";
    if (misleads(boxed_turn, right_turn)) result.fault = "orientation: bound of the box against integers";
    const std::optional<exact::Sign> right_circle = exact::integers::in_circle(a, b, c, d);
    if (exact::in_circle(a, b, c, d) != right_circle) result.fault = "in-circle: integers";
    if (differ(circle, right_circle)) result.fault = "in-circle: doubles against integers";
    if (differ(exact::any_origin::in_circle(a, b, c, d), right_circle)) {
      result.fault = "in-circle: any origin against integers";
    }
    if (exact::compare(a, b) != exact::integers::compare(a, b)) result.fault = "order: integers";
  }
  if (!result.fault.empty()) result.fault += ", call " + std::to_string(result.calls);
  return result;
}

}  // namespace waywright::test
