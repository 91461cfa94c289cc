#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "waywright/item.hpp"
#include "waywright/world.hpp"

#include "oracle/dump_text.hpp"
#include "support/random_changes.hpp"

/// Compares the library's worlds with CGAL's constrained triangulations with exact constructions, used as CGAL's manual
/// recommends. Only this test and the benchmarks use CGAL. The library does not use it.
namespace waywright::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Plain = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_intersections_tag>;
using Cdt = CGAL::Constrained_triangulation_plus_2<Plain>;

/// The data on which both libraries must agree: the vertices as exact rationals, and the constrained edges by their
/// ends, each with the items whose sides lie on it.
struct Mesh {
  std::set<std::string> vertices;
  std::map<std::pair<std::string, std::string>, std::set<std::uint64_t>> edges;

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

void add_edge(Mesh& mesh, const std::string& a, const std::string& b, std::uint64_t id) {
  mesh.edges[std::minmax(a, b)].insert(id);
}

class CgalWorld {
 public:
  explicit CgalWorld(const Box& box) {
    const auto& [low, high] = box;
    insert({0}, {ItemKind::polygon, {{low, {high.x, low.y}, high, {low.x, high.y}}}});
  }

  void insert(ItemId id, const Shape& shape) {
    for (const PointSpan& ring : shape.rings) {
      for (const Point& p : ring) cdt_.insert(cgal_point(p));
      const std::size_t side_count = shape.kind == ItemKind::polygon ? ring.size() : ring.size() - 1;
      for (std::size_t i = 0; i < side_count; ++i) {
        const Point& from = ring[i];
        const Point& to = ring[(i + 1) % ring.size()];
        if (from != to) ids_[cdt_.insert_constraint(cgal_point(from), cgal_point(to))] = id.value;
      }
    }
  }

  [[nodiscard]] Mesh mesh() const {
    Mesh result;
    for (const auto vertex : cdt_.finite_vertex_handles()) result.vertices.insert(text(vertex->point()));
    for (auto edge = cdt_.subconstraints_begin(); edge != cdt_.subconstraints_end(); ++edge) {
      const auto& [from, to] = edge->first;
      const auto end = cdt_.contexts_end(from, to);
      for (auto context = cdt_.contexts_begin(from, to); context != end; ++context) {
        add_edge(result, text(from->point()), text(to->point()), ids_.at(context->id()));
      }
    }
    return result;
  }

 private:
  static Kernel::Point_2 cgal_point(const Point& p) { return {p.x, p.y}; }

  /// Returns the fraction in lowest terms, as the kernel's number types store it. A whole number has denominator 1.
  static std::string text(const Kernel::FT& value) {
    std::ostringstream out;
    out << CGAL::exact(value);
    std::string result = out.str();
    const std::size_t slash = result.find('/');
    if (slash == std::string::npos) return result + " 1";
    return result.replace(slash, 1, " ");
  }

  static std::string text(const Kernel::Point_2& p) { return text(p.x()) + " " + text(p.y()); }

  Cdt cdt_;
  std::map<Cdt::Constraint_id, std::uint64_t> ids_;
};

Mesh mesh_of(const World& world) {
  const std::string dump = world.dump();
  std::string fault;
  const auto sections = oracle::read_dump(dump, fault);
  EXPECT_TRUE(sections) << fault;
  Mesh result;
  if (!sections) return result;
  std::vector<std::string> vertices(sections->vertices.begin(), sections->vertices.end());
  for (const std::string_view line : sections->constraints) {
    std::istringstream words{std::string(line)};
    std::size_t from = 0;
    std::size_t to = 0;
    words >> from >> to;
    for (std::uint64_t id = 0; words >> id;) add_edge(result, vertices.at(from), vertices.at(to), id);
  }
  result.vertices.insert(vertices.begin(), vertices.end());
  return result;
}

class CgalDifferential : public ::testing::TestWithParam<Flavour> {};

constexpr std::uint64_t kScripts = 100;

TEST_P(CgalDifferential, InsertedItemsGiveTheSameVerticesAndEdges) {
  for (std::uint64_t seed = 0; seed < kScripts; ++seed) {
    const Scene scene = random_scene(GetParam(), seed, 5 + seed % 50);
    World world = World::create(scene.domain).value();
    CgalWorld cgal(scene.domain);
    for (const Item& item : scene.items) {
      ASSERT_TRUE(world.insert(item.shape, item.id).ok());
      cgal.insert(item.id, item.shape);
    }
    ASSERT_EQ(mesh_of(world), cgal.mesh()) << "seed " << seed << '\n' << to_script(scene);
  }
}

// When CGAL removes a constraint it keeps the crossings of that constraint. So this test builds a new CGAL world from
// the remaining items.
TEST_P(CgalDifferential, WhatRemainsAfterChangesHasTheSameVerticesAndEdges) {
  for (std::uint64_t seed = 0; seed < kScripts; ++seed) {
    const ChangeScript script = random_changes(GetParam(), seed, 120, 5 + seed % 50);
    World world = World::create(script.domain).value();
    LiveItems live(script.domain);
    for (const Step& step : script.steps) ASSERT_EQ(perform(world, step).ok(), live.apply(step).ok());
    CgalWorld cgal(script.domain);
    for (const auto& [id, shape] : live.items()) cgal.insert(id, shape);
    ASSERT_EQ(mesh_of(world), cgal.mesh()) << "seed " << seed << '\n' << to_script(script);
  }
}

INSTANTIATE_TEST_SUITE_P(Flavours, CgalDifferential, ::testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

}  // namespace
}  // namespace waywright::test
