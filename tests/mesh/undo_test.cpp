#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/triangle_mesh.hpp"
#include "support/random.hpp"
#include "support/square_mesh.hpp"

namespace waywright::test {
namespace {

using mesh::Face;
using mesh::HalfEdge;
using mesh::kNoHalfEdge;
using mesh::TriangleMesh;
using mesh::Vertex;

struct EdgeState {
  Vertex origin;
  HalfEdge twin;
  mesh::Label label;

  bool operator==(const EdgeState&) const = default;
};

/// All visible state of a mesh, except which half-edge a vertex stores.
struct State {
  std::map<HalfEdge, EdgeState> edges;
  std::set<Vertex> vertices;

  bool operator==(const State&) const = default;
};

State state_of(const TriangleMesh& mesh) {
  State state;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(Face{f})) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge h{3 * f + i};
      state.edges[h] = {mesh.origin(h), mesh.twin(h), mesh.label(h)};
    }
  }
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    if (mesh.is_live(Vertex{v})) state.vertices.insert(Vertex{v});
  }
  return state;
}

/// Frees the faces around `v` and fills the cavity with new faces: a fan from one corner.
void remove_vertex(TriangleMesh& mesh, Vertex v) {
  std::vector<HalfEdge> outer;
  std::vector<mesh::Label> labels;
  std::vector<Face> faces;
  mesh.for_each_outgoing(v, [&](HalfEdge h) {
    outer.push_back(mesh.twin(mesh::next(h)));
    labels.push_back(mesh.label(mesh::next(h)));
    faces.push_back(mesh::face(h));
  });
  const std::size_t count = outer.size();
  std::vector<Vertex> link;
  for (const HalfEdge h : outer) link.push_back(mesh.target(h));
  for (const Face f : faces) mesh.free_face(f);
  HalfEdge last = outer[0];
  mesh::Label last_label = labels[0];
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Face f = mesh.add_face();
    mesh.set_vertices(f, link[0], link[i], link[i + 1]);
    mesh.link(mesh::first(f), last, last_label);
    mesh.link(mesh::next(mesh::first(f)), outer[i], labels[i]);
    last = mesh::previous(mesh::first(f));
    last_label = 0;
  }
  mesh.link(last, outer[count - 1], labels[count - 1]);
  mesh.free_vertex(v);
}

using Triangles = std::vector<TriangleMesh::Triangle>;

/// Returns a random triangulation of a polygon. Each triangle comes before the triangles that share its edges.
Triangles random_triangles(std::uint32_t corner_count, Random& random) {
  const auto over = [&](std::uint32_t from, std::uint32_t to) {
    return TriangleMesh::Triangle{from, from + 1 + static_cast<std::uint32_t>(random.below(to - from - 1)), to};
  };
  Triangles triangles = {over(0, corner_count - 1)};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [from, apex, to] = triangles[i];
    if (apex - from > 1) triangles.push_back(over(from, apex));
    if (to - apex > 1) triangles.push_back(over(apex, to));
  }
  return triangles;
}

/// Fills the cavity of a vertex with a random triangulation, unless that would create an edge that already exists.
void refill(TriangleMesh& mesh, Vertex v, Random& random) {
  std::vector<Vertex> link;
  std::vector<HalfEdge> border;
  mesh.for_each_outgoing(v, [&](HalfEdge h) {
    link.push_back(mesh.target(h));
    border.push_back(mesh::next(h));
  });
  if (mesh.vertex_count() <= 8 || std::set<Vertex>(link.begin(), link.end()).size() != link.size()) return;
  const Triangles triangles = random_triangles(static_cast<std::uint32_t>(link.size()), random);
  for (const auto& [from, apex, to] : triangles) {
    if (apex - from > 1 && mesh.find(link[from], link[apex]) != kNoHalfEdge) return;
    if (to - apex > 1 && mesh.find(link[apex], link[to]) != kNoHalfEdge) return;
  }
  const HalfEdge last = border.back();
  border.pop_back();
  const HalfEdge base = mesh.refill(border, triangles);
  EXPECT_EQ(mesh.origin(base), link.back());
  EXPECT_EQ(mesh.target(base), link.front());
  mesh.close(base, last);
  mesh.free_vertex(v);
}

/// Makes one change of a random kind, if it is possible.
void change(TriangleMesh& mesh, Random& random) {
  HalfEdge h{};
  do {
    h = HalfEdge{static_cast<std::uint32_t>(random.below(mesh.face_slots() * std::size_t{3}))};
  } while (!mesh.is_live(mesh::face(h)));
  switch (random.below(7)) {
    case 0:
      mesh.split_face(mesh::face(h), mesh.add_vertex());
      break;
    case 1:
      mesh.split_edge(h, mesh.add_vertex());
      break;
    case 2:
    case 3:
      if (!mesh.is_fixed(h) && mesh.find(mesh.apex(h), mesh.apex(mesh.twin(h))) == kNoHalfEdge) mesh.flip(h);
      break;
    case 4:
      mesh.set_label(h, static_cast<mesh::Label>(random.below(4)));
      break;
    case 5:
      refill(mesh, mesh.origin(h), random);
      break;
    default: {
      // Only where the fan creates no edge that already exists.
      const Vertex v = mesh.origin(h);
      std::vector<Vertex> link;
      mesh.for_each_outgoing(v, [&](HalfEdge g) { link.push_back(mesh.target(mesh.twin(mesh::next(g)))); });
      bool is_possible = link.size() > 3 && mesh.vertex_count() > 8;
      for (std::size_t i = 2; i + 1 < link.size(); ++i) {
        is_possible = is_possible && mesh.find(link[0], link[i]) == kNoHalfEdge;
      }
      if (is_possible) remove_vertex(mesh, v);
    }
  }
}

TEST(Undo, RollingBackRestoresEveryHalfEdgeLabelAndVertex) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    TriangleMesh mesh = SquareMesh().mesh;
    Random random(seed);
    for (int i = 0; i < 60; ++i) change(mesh, random);
    ASSERT_EQ(mesh.find_fault(), std::nullopt);
    for (int round = 0; round < 10; ++round) {
      const State before = state_of(mesh);
      mesh.begin();
      const std::size_t changes = random.below(25);
      for (std::size_t i = 0; i < changes; ++i) change(mesh, random);
      ASSERT_EQ(mesh.find_fault(), std::nullopt);
      mesh.roll_back();
      ASSERT_EQ(mesh.find_fault(), std::nullopt) << "seed " << seed << ", round " << round;
      ASSERT_EQ(state_of(mesh), before) << "seed " << seed << ", round " << round;
      // The roll back must leave free room: makes the same number of changes again and commits them.
      mesh.begin();
      for (std::size_t i = 0; i < changes / 4; ++i) change(mesh, random);
    }
  }
}

TEST(Undo, TouchedFacesAndVerticesAreThoseThatChanged) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    TriangleMesh mesh = SquareMesh().mesh;
    Random random(seed);
    for (int i = 0; i < 60; ++i) change(mesh, random);
    const State before = state_of(mesh);
    mesh.begin();
    for (int i = 0; i < 6; ++i) change(mesh, random);
    const State after = state_of(mesh);

    std::map<Face, TriangleMesh::Touch> last_touch;
    mesh.for_each_touched_face([&](Face f, TriangleMesh::Touch touch) { last_touch[f] = touch; });
    for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
      const Face f{i};
      const HalfEdge h = mesh::first(f);
      const bool was_live = before.edges.contains(h);
      const bool is_live = after.edges.contains(h);
      bool has_changed = was_live != is_live;
      for (const HalfEdge half : {h, mesh::next(h), mesh::previous(h)}) {
        if (!was_live || !is_live) continue;
        const EdgeState& old_state = before.edges.at(half);
        const EdgeState& new_state = after.edges.at(half);
        has_changed = has_changed || old_state.origin != new_state.origin || old_state.label != new_state.label;
      }
      ASSERT_TRUE(!has_changed || last_touch.contains(f)) << "face " << i << " changed untold, seed " << seed;
      ASSERT_TRUE(!last_touch.contains(f) || (last_touch[f] != TriangleMesh::Touch::freed) == is_live);
    }
    std::set<Vertex> live = before.vertices;
    mesh.for_each_touched_vertex([&](Vertex v, TriangleMesh::Touch touch) {
      if (touch == TriangleMesh::Touch::made) live.insert(v);
      if (touch == TriangleMesh::Touch::freed) live.erase(v);
    });
    ASSERT_EQ(live, after.vertices);
  }
}

}  // namespace
}  // namespace waywright::test
