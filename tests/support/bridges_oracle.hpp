#pragma once

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "waywright/point.hpp"

namespace waywright::test::bridge_oracle {

using Rational = boost::multiprecision::cpp_rational;

struct Vector {
  Rational x, y;

  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator*(const Rational& t, const Vector& a) { return {t * a.x, t * a.y}; }
  friend Rational operator*(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
  friend bool operator==(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const Vector& a, const Vector& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
};
inline Vector exactly(const Point& p) { return {Rational(p.x), Rational(p.y)}; }

using Segment = std::pair<Vector, Vector>;
using BridgeSet = std::set<Segment>;

inline Segment ordered(const Vector& a, const Vector& b) { return a < b ? Segment{a, b} : Segment{b, a}; }

inline Vector foot_on(const Vector& w, const Segment& wall) {
  const Vector along = wall.second - wall.first;
  return wall.first + Rational(((w - wall.first) * along) / (along * along)) * along;
}

/// Whether the closed disc with the diameter u v contains a position of the wall other than u and v.
inline bool blocks(const Vector& u, const Vector& v, const Segment& wall) {
  const Vector along = wall.second - wall.first;
  const auto is_in = [&](const Rational& t) {
    const Vector at = wall.first + t * along;
    const Rational power = (at - u) * (at - v);
    return power < 0 || (power == 0 && !(at == u) && !(at == v));
  };
  if (is_in(0) || is_in(1)) return true;
  const Rational nearest = (Rational(1, 2) * (u + v) - wall.first) * along / (along * along);
  return nearest > 0 && nearest < 1 && is_in(nearest);
}

/// Finds all bridges of the walls, straight from the definition.
inline BridgeSet expected_bridges(const std::vector<Segment>& walls) {
  std::set<Vector> ends;
  for (const Segment& wall : walls) ends.insert({wall.first, wall.second});
  std::set<Segment> candidates;
  for (const Vector& w : ends) {
    for (const Vector& v : ends) {
      if (w < v) candidates.insert({w, v});
    }
    for (const Segment& wall : walls) {
      const Vector foot = foot_on(w, wall);
      const bool is_inside = (foot - wall.first) * (foot - wall.second) < 0;
      if (is_inside && !(foot == w) && !ends.contains(foot)) candidates.insert({w, foot});
    }
  }
  BridgeSet bridges;
  for (const Segment& candidate : candidates) {
    const bool is_bridge = std::none_of(walls.begin(), walls.end(), [&](const Segment& wall) {
      return blocks(candidate.first, candidate.second, wall);
    });
    if (is_bridge) bridges.insert(candidate);
  }
  return bridges;
}

}  // namespace waywright::test::bridge_oracle
