#include "path/taut_string.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "delaunay/triangulation.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using Triangulation = delaunay::Triangulation;
using mesh::HalfEdge;
using mesh::Vertex;

/// A channel through a mesh: the edges that it crosses, each as a half-edge of the face before it, and its two end
/// points.
struct Channel {
  Point start;
  Point goal;
  std::vector<HalfEdge> exits;
};

/// Returns twice the signed area. It is exact, as the coordinates are small whole numbers.
std::int64_t doubled_area(const Point& a, const Point& b, const Point& c) {
  return static_cast<std::int64_t>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

double hypotenuse(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Returns the length of the shortest path through a channel by brute force: connects the start, the goal and the ends
/// of all portals to all later ones that a straight line through the portals between them reaches.
double shortest_by_trying_all(const Triangulation& triangulation, const Channel& channel) {
  const mesh::TriangleMesh& mesh = triangulation.topology();
  const auto coordinates = [&](Vertex v) { return triangulation.geometry().rounded(number(v)); };
  struct Stop {
    Point at;
    std::size_t portal;
    double length;
  };
  std::vector<Point> left, right;
  for (const HalfEdge exit : channel.exits) {
    left.push_back(coordinates(mesh.target(exit)));
    right.push_back(coordinates(mesh.origin(exit)));
  }
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < left.size(); ++i) {
    stops.push_back({left[i], i, std::numeric_limits<double>::infinity()});
    stops.push_back({right[i], i, std::numeric_limits<double>::infinity()});
  }
  stops.push_back({channel.goal, left.size(), std::numeric_limits<double>::infinity()});
  const auto has_end = [&](std::size_t portal, const Point& p) { return p == left[portal] || p == right[portal]; };
  const auto is_free = [&](const Point& from, std::size_t first, const Stop& to) {
    std::size_t last = to.portal;
    while (first < last && has_end(first, from)) ++first;     // the line crosses these where it starts
    while (first < last && has_end(last - 1, to.at)) --last;  // or ends
    if (first < last && from == to.at) return false;          // the channel goes around the point
    for (std::size_t i = first; i < last; ++i) {
      if (doubled_area(from, to.at, left[i]) < 0 || doubled_area(from, to.at, right[i]) > 0) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < stops.size(); ++i) {
    Stop& stop = stops[i];
    if (is_free(channel.start, 0, stop)) stop.length = hypotenuse(channel.start, stop.at);
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_free(stops[k].at, stops[k].portal + 1, stop)) continue;
      stop.length = std::min(stop.length, stops[k].length + hypotenuse(stops[k].at, stop.at));
    }
  }
  return stops.back().length;
}

class TautStrings : public testing::Test {
 protected:
  // Multiples of 3, so that the coordinates of the middle of a face are whole numbers.
  static constexpr std::int64_t kWidth = 20;

  static Triangulation random_mesh(Random& random, std::size_t count) {
    Triangulation result(Box{{0, 0}, {3.0 * kWidth, 3.0 * kWidth}}, {1, 2, 3, 4});
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(3 * random.between(0, kWidth));
      result.insert(Point{x, static_cast<double>(3 * random.between(0, kWidth))});
    }
    return result;
  }

  /// Returns a channel from a corner or the middle of a face to a corner or the middle of another face. It never enters
  /// a face twice.
  static Channel random_channel(Random& random, const Triangulation& triangulation) {
    const mesh::TriangleMesh& mesh = triangulation.topology();
    mesh::Face f{};
    do {
      f = mesh::Face{static_cast<std::uint32_t>(random.below(mesh.face_slots()))};
    } while (!triangulation.is_in_domain(f));
    Channel channel;
    channel.start = end_in(random, triangulation, f);
    std::set<mesh::Face> seen = {f};
    for (const std::size_t most = 1 + random.below(12); channel.exits.size() < most;) {
      std::vector<HalfEdge> passages;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge h{3 * number(f) + i};
        if (!mesh.is_fixed(h) && !seen.contains(mesh::face(mesh.twin(h)))) passages.push_back(h);
      }
      if (passages.empty()) break;
      channel.exits.push_back(passages[random.below(passages.size())]);
      f = mesh::face(mesh.twin(channel.exits.back()));
      seen.insert(f);
    }
    channel.goal = end_in(random, triangulation, f);
    return channel;
  }

 private:
  static Point end_in(Random& random, const Triangulation& triangulation, mesh::Face f) {
    const HalfEdge h = mesh::first(f);
    const auto corner = [&](HalfEdge at) {
      return triangulation.geometry().rounded(number(triangulation.topology().origin(at)));
    };
    const Point a = corner(h), b = corner(mesh::next(h)), c = corner(mesh::previous(h));
    switch (random.below(4)) {
      case 0:
        return a;
      case 1:
        return b;
      default:
        return {(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0};
    }
  }
};

std::vector<Point> points_of(const path::TautTree& tree, std::uint32_t last) {
  std::vector<Point> points = {tree.point(last)};
  for (; last != path::TautTree::kStart; last = tree.parent(last)) points.push_back(tree.point(tree.parent(last)));
  std::reverse(points.begin(), points.end());
  return points;
}

/// Calls one of the two functions for each portal after the first: the one for the end that changed.
template <class Left, class Right>
void for_each_move(const mesh::TriangleMesh& mesh, const Channel& channel, Left&& move_left, Right&& move_right) {
  for (std::size_t i = 1; i < channel.exits.size(); ++i) {
    const HalfEdge entry = mesh.twin(channel.exits[i - 1]);
    channel.exits[i] == mesh::next(entry) ? move_left(mesh.apex(entry)) : move_right(mesh.apex(entry));
  }
}

TEST_F(TautStrings, AreTheShortestPathsThroughTheirChannels) {
  Random random(1);
  path::TautString string;
  path::TautTree tree;
  std::size_t turns = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const Triangulation triangulation = random_mesh(random, 5 + random.below(60));
    const mesh::TriangleMesh& mesh = triangulation.topology();
    for (int i = 0; i < 20; ++i) {
      const Channel channel = random_channel(random, triangulation);
      if (channel.exits.empty()) continue;
      const Vertex left = mesh.target(channel.exits[0]), right = mesh.origin(channel.exits[0]);
      string.begin(triangulation.geometry(), channel.start, left, right, channel.exits.size());
      tree.reset(triangulation.geometry(), channel.start);
      path::Funnel funnel{path::TautTree::kStart, tree.add_visible_from_start(left),
                          tree.add_visible_from_start(right)};
      for_each_move(
          mesh, channel,
          [&](Vertex v) {
            string.move_left(v);
            funnel = tree.move_left(funnel, v);
          },
          [&](Vertex v) {
            string.move_right(v);
            funnel = tree.move_right(funnel, v);
          });
      string.end_at(channel.goal);
      ASSERT_NEAR(string.length(), shortest_by_trying_all(triangulation, channel), 1e-9)
          << "scene " << scene << ", channel " << i;
      const std::vector<Point> of_string(string.points().begin(), string.points().end());
      ASSERT_EQ(of_string, points_of(tree, tree.last_turn(funnel, channel.goal)));
      turns += string.points().size() - 1;
    }
  }
  EXPECT_GT(turns, 2000U);
}

}  // namespace
}  // namespace waywright::test
