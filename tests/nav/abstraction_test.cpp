#include "nav/abstraction.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "constraint/cover_finder.hpp"
#include "support/case_count.hpp"
#include "support/live_items.hpp"
#include "support/random_changes.hpp"
#include "support/random_scenes.hpp"

namespace waywright::test {
namespace {

using mesh::Face;
using mesh::HalfEdge;
using nav::Abstraction;
using Fault = std::optional<std::string>;

/// A mesh with its abstraction. Changes them in the same order as a world does.
class Reduced {
 public:
  explicit Reduced(const Box& domain) : mesh_(domain), abstraction_(mesh_) {}

  void apply(const std::vector<Change>& changes, const std::vector<ItemId>& ids) {
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    abstraction_.begin();
    for (std::size_t i = 0; i < changes.size(); ++i) {
      if (changes[i].kind != Change::Kind::insert) {
        const std::uint32_t slot = mesh_.items().slot(ids[i]);
        if (mesh_.items().is_polygon(slot)) abstraction_.note_removed(slot);
        mesh_.remove(ids[i]);
      }
      if (changes[i].kind != Change::Kind::remove) {
        mesh_.insert(changes[i].shape, ids[i]);
        const std::uint32_t slot = mesh_.items().slot(ids[i]);
        if (mesh_.items().is_polygon(slot)) abstraction_.note_inserted(slot);
      }
    }
    const mesh::TouchedFaces::Guard guard(touched_);
    touched_.collect(mesh_.topology());
    abstraction_.update(mesh_, touched_);
    operation.commit();
  }
  ItemId insert(const Shape& shape) {
    const ItemId id{mesh_.items().largest_id_seen().value + 1};
    apply({{Change::Kind::insert, id, shape}}, {id});
    return id;
  }
  void remove(ItemId id) { apply({{Change::Kind::remove, id, {}}}, {id}); }

  [[nodiscard]] const constraint::ConstrainedTriangulation& mesh() const { return mesh_; }
  [[nodiscard]] const Abstraction& abstraction() const { return abstraction_; }
  /// Returns the face that contains the point. Requires: the point lies inside a face.
  [[nodiscard]] Face face_at(const Point& point) const { return mesh::face(mesh_.triangulation().locate(point).h); }

 private:
  constraint::ConstrainedTriangulation mesh_;
  Abstraction abstraction_;
  mesh::TouchedFaces touched_;
};

/// The same abstraction, computed from the mesh by the simplest methods.
class Expected {
 public:
  explicit Expected(const constraint::ConstrainedTriangulation& triangulation)
      : triangulation_(triangulation), mesh_(triangulation.topology()), set_(mesh_.face_slots()) {
    std::iota(set_.begin(), set_.end(), 0U);
    for (std::uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      const HalfEdge h = mesh::first(Face{i});
      if (mesh_.is_live(Face{i}) && !triangulation.triangulation().is_ghost_face(h)) faces_.push_back(i);
    }
    for (const std::uint32_t f : faces_) {
      for (const HalfEdge h : free_half_edges(f)) set_[set_of(f)] = set_of(beyond(h));
    }
    core_.insert(faces_.begin(), faces_.end());
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (const std::uint32_t f : faces_) {
        if (core_.contains(f) && passages(f) < 2) {
          core_.erase(f);
          is_done = false;
        }
      }
    }
  }

  [[nodiscard]] Fault fault_of(const Abstraction& abstraction) const {
    if (auto fault = component_fault(abstraction.components())) return fault;
    if (auto fault = cover_fault(abstraction.components())) return fault;
    if (auto fault = core_fault(abstraction.core())) return fault;
    return tree_fault(abstraction.core());
  }

 private:
  [[nodiscard]] std::uint32_t set_of(std::uint32_t f) const {
    while (set_[f] != f) f = set_[f];
    return f;
  }
  [[nodiscard]] std::vector<HalfEdge> free_half_edges(std::uint32_t f) const {
    std::vector<HalfEdge> half_edges = {HalfEdge{3 * f}, HalfEdge{3 * f + 1}, HalfEdge{3 * f + 2}};
    std::erase_if(half_edges, [&](HalfEdge h) { return mesh_.is_fixed(h); });
    return half_edges;
  }
  [[nodiscard]] std::uint32_t beyond(HalfEdge h) const { return number(mesh::face(mesh_.twin(h))); }
  [[nodiscard]] unsigned passages(std::uint32_t f) const {
    unsigned count = 0;
    for (const HalfEdge h : free_half_edges(f)) count += core_.contains(beyond(h)) ? 1 : 0;
    return count;
  }

  [[nodiscard]] Fault component_fault(const nav::Components& components) const {
    std::map<std::uint32_t, nav::Components::Id> id_of;
    std::map<nav::Components::Id, std::uint32_t> size_of;
    for (const std::uint32_t f : faces_) {
      const auto id = components.component_of(Face{f});
      const auto [at, is_new] = id_of.emplace(set_of(f), id);
      if (is_new && size_of.contains(id)) return "two components have one id";
      if (at->second != id) return "a component has two ids";
      ++size_of[id];
    }
    if (components.count() != size_of.size()) return "components are not counted right";
    for (const auto& [id, size] : size_of) {
      if (components.size(id) != size) return "a component has another size";
    }
    return std::nullopt;
  }

  [[nodiscard]] Fault cover_fault(const nav::Components& components) const {
    constraint::CoverFinder cover_finder;
    for (const std::uint32_t f : faces_) {
      std::vector<std::uint32_t> expected = cover_finder.of_face(triangulation_, mesh::first(Face{f}));
      std::vector<std::uint32_t> kept;
      components.for_each_cover(Face{f}, [&](std::uint32_t item) { kept.push_back(item); });
      std::sort(expected.begin(), expected.end());
      std::sort(kept.begin(), kept.end());
      if (kept != expected) return "face " + std::to_string(f) + " is covered by others";
      if (components.is_covered(Face{f}) != !expected.empty()) return "is_covered is wrong";
    }
    return std::nullopt;
  }

  [[nodiscard]] Fault core_fault(const nav::TwoCore& core) const {
    for (const std::uint32_t f : faces_) {
      if (core.is_core(Face{f}) != core_.contains(f)) {
        return "face " + std::to_string(f) + (core_.contains(f) ? " is of the core" : " is not of the core");
      }
      if (core.core_degree(Face{f}) != (core_.contains(f) ? passages(f) : 0)) return "a face has another degree";
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const bool is_passage =
            core_.contains(f) && !mesh_.is_fixed(HalfEdge{h}) && core_.contains(beyond(HalfEdge{h}));
        if (core.is_core_passage(HalfEdge{h}) != is_passage) return "a passage is none, or one is missed";
      }
    }
    return std::nullopt;
  }

  /// Checks that every tree face leads to the core or, where there is no core, to the component's root. In a tree only
  /// one path leads to the core, so it is enough that the face leads there at all.
  [[nodiscard]] Fault tree_fault(const nav::TwoCore& core) const {
    std::map<std::uint32_t, std::uint32_t> root_of;
    std::set<std::uint32_t> sets_with_core;
    for (const std::uint32_t f : core_) sets_with_core.insert(set_of(f));
    for (std::uint32_t f : faces_) {
      std::size_t steps = 0;
      while (!core_.contains(f)) {
        const HalfEdge up = core.towards_core(Face{f});
        if (up == mesh::kNoHalfEdge) break;
        if (number(mesh::face(up)) != f || mesh_.is_fixed(up))
          return "the edge towards the core is no passage of the face";
        if (++steps > faces_.size()) return "the passages towards the core lead around a circle of faces";
        f = beyond(up);
      }
      if (sets_with_core.contains(set_of(f))) {
        if (!core_.contains(f)) return "the passages towards the core do not lead to the core";
      } else if (root_of.emplace(set_of(f), f).first->second != f) {
        return "a tree has two roots";
      }
    }
    return std::nullopt;
  }

  const constraint::ConstrainedTriangulation& triangulation_;
  const mesh::TriangleMesh& mesh_;
  std::vector<std::uint32_t> faces_;
  std::vector<std::uint32_t> set_;  ///< a face of the same component, or the face itself
  std::set<std::uint32_t> core_;
};

/// Compares the maintained abstraction, and one built from the mesh anew, with the expected one.
Fault fault_of(const Reduced& reduced) {
  const Expected expected(reduced.mesh());
  if (auto fault = expected.fault_of(reduced.abstraction())) return fault;
  if (auto fault = expected.fault_of(Abstraction(reduced.mesh()))) return *fault + ", built from nothing";
  return std::nullopt;
}

Shape rectangle(double x0, double y0, double x1, double y1) {
  return {ItemKind::polygon, {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
}

Shape wall(Point a, Point b) { return {ItemKind::segment, {{a, b}}}; }

constexpr Box kTen = {{0, 0}, {10, 10}};

TEST(Abstraction, AnEmptyBoxIsATree) {
  const Reduced reduced(kTen);
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  EXPECT_EQ(reduced.abstraction().components().count(), 1U);
  EXPECT_FALSE(reduced.abstraction().core().is_core(reduced.face_at({5, 1})));
  EXPECT_FALSE(reduced.abstraction().components().is_covered(reduced.face_at({5, 1})));
}

TEST(Abstraction, ASolidIsARingsMiddle) {
  Reduced reduced(kTen);
  const ItemId solid = reduced.insert(rectangle(4, 4, 6, 6));
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  const Abstraction& abstraction = reduced.abstraction();
  EXPECT_EQ(abstraction.components().count(), 2U);
  EXPECT_TRUE(abstraction.components().is_covered(reduced.face_at({5, 4.5})));
  EXPECT_EQ(abstraction.core().core_degree(reduced.face_at({5, 3.5})), 2U) << "between the solid and the border";
  reduced.remove(solid);
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  EXPECT_EQ(abstraction.components().count(), 1U);
  EXPECT_FALSE(abstraction.core().is_core(reduced.face_at({5, 1})));
}

TEST(Abstraction, WallsDivideAComponentAndTheirRemovalConnectsIt) {
  Reduced reduced(kTen);
  const auto is_divided = [&] {
    const nav::Components& components = reduced.abstraction().components();
    return components.component_of(reduced.face_at({1, 4.5})) != components.component_of(reduced.face_at({9, 4.5}));
  };
  reduced.insert(wall({5, 0}, {5, 6}));
  EXPECT_FALSE(is_divided());
  const ItemId upper = reduced.insert(wall({5, 6}, {5, 10}));
  EXPECT_TRUE(is_divided());
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  reduced.remove(upper);
  EXPECT_FALSE(is_divided());
  EXPECT_EQ(fault_of(reduced), std::nullopt);
}

TEST(Abstraction, AWallThatCrossesItselfDividesAComponent) {
  Reduced reduced(kTen);
  for (int x = 1; x < 10; ++x) {
    for (int y = 1; y < 10; ++y) reduced.insert({ItemKind::point, {{{1.0 * x, 1.0 * y}}}});
  }
  reduced.insert({ItemKind::polyline, {{{1.5, 1.5}, {7.5, 1.5}, {7.5, 7.5}, {3.5, 0.5}}}});
  const nav::Components& components = reduced.abstraction().components();
  EXPECT_NE(components.component_of(reduced.face_at({6.5, 3.2})), components.component_of(reduced.face_at({1.5, 8.2})));
  EXPECT_EQ(fault_of(reduced), std::nullopt);
}

TEST(Abstraction, SolidsInSolidsAreCoveredByAll) {
  Reduced reduced(kTen);
  const ItemId inner = reduced.insert(rectangle(4, 4, 6, 6));
  reduced.insert(wall({5, 3}, {5, 7}));
  const ItemId outer = reduced.insert(rectangle(1, 1, 9, 9));
  const auto cover_count = [&](const Point& point) {
    int count = 0;
    reduced.abstraction().components().for_each_cover(reduced.face_at(point), [&](std::uint32_t) { ++count; });
    return count;
  };
  EXPECT_EQ(cover_count({4.5, 4.25}), 2);
  EXPECT_EQ(cover_count({2, 1.5}), 1);
  EXPECT_EQ(cover_count({0.5, 0.25}), 0);
  reduced.remove(outer);
  EXPECT_EQ(cover_count({4.5, 4.25}), 1);
  reduced.remove(inner);
  EXPECT_EQ(cover_count({4.5, 4.25}), 0);
  EXPECT_EQ(fault_of(reduced), std::nullopt);
}

// A ring that visits all its corners twice encloses nothing under the even-odd rule.
TEST(Abstraction, EqualSolidsAreCountedOneByOne) {
  Reduced reduced(kTen);
  const Shape once = rectangle(4, 4, 6, 6);
  Shape twice = once;
  for (const Point& corner : once.rings[0]) twice.rings.add_point(corner);
  std::vector<ItemId> ids;
  for (int i = 0; i < 60; ++i) ids.push_back(reduced.insert(i % 3 == 0 ? twice : once));
  const auto cover_count = [&] {
    int count = 0;
    reduced.abstraction().components().for_each_cover(reduced.face_at({5, 4.5}), [&](std::uint32_t) { ++count; });
    return count;
  };
  EXPECT_EQ(cover_count(), 40);
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  for (std::size_t i = 0; i < ids.size(); ++i) reduced.remove(ids[i * 37 % ids.size()]);
  EXPECT_EQ(cover_count(), 0);
  EXPECT_EQ(fault_of(reduced), std::nullopt);
}

TEST(Abstraction, AFaceBesideManyEqualSolidsHasNoneOfThem) {
  Reduced reduced(kTen);
  for (int i = 0; i < 50; ++i) reduced.insert(rectangle(4, 4, 6, 6));
  reduced.insert({ItemKind::polyline, {{{4, 4}, {3.5, 5}, {4, 6}}}});
  EXPECT_EQ(fault_of(reduced), std::nullopt);
  EXPECT_FALSE(reduced.abstraction().components().is_covered(reduced.face_at({3.9, 5})));
  EXPECT_TRUE(reduced.abstraction().components().is_covered(reduced.face_at({4.1, 5})));
}

/// A wall with a gap that opens and closes, deep in a maze whose component is one tree.
TEST(Abstraction, RingsAreInsertedAndRemovedInATree) {
  Reduced reduced({{0, 0}, {100, 100}});
  std::vector<ItemId> walls;
  for (int i = 1; i < 20; ++i) {
    const double x = 5.0 * i;
    walls.push_back(reduced.insert(i % 2 == 0 ? wall({x, 0}, {x, 95}) : wall({x, 5}, {x, 100})));
    ASSERT_EQ(fault_of(reduced), std::nullopt);
  }
  EXPECT_FALSE(reduced.abstraction().core().is_core(reduced.face_at({52, 51})));
  for (std::size_t i = 2; i < walls.size(); i += 3) {
    reduced.remove(walls[i]);
    ASSERT_EQ(fault_of(reduced), std::nullopt) << "without wall " << i;
    const double x = 5.0 * static_cast<double>(i + 1);
    const ItemId lower = reduced.insert(wall({x, 5}, {x, 45}));
    const ItemId upper = reduced.insert(wall({x, 55}, {x, 95}));
    ASSERT_EQ(fault_of(reduced), std::nullopt) << "with gaps in wall " << i;
    EXPECT_TRUE(reduced.abstraction().core().is_core(reduced.face_at({x - 1, 50.25})));
    reduced.remove(lower);
    ASSERT_EQ(fault_of(reduced), std::nullopt);
    reduced.remove(upper);
    reduced.insert(i % 2 == 1 ? wall({x, 0}, {x, 95}) : wall({x, 5}, {x, 100}));
    ASSERT_EQ(fault_of(reduced), std::nullopt) << "with wall " << i << " again";
  }
}

// These changes do not touch a wall, so the abstraction checks them only briefly. But the area inside the polygon and
// the area outside are different components.
TEST(Abstraction, KeepsComponentsSeparateWhilePointsChangeInOpenSpace) {
  Reduced reduced({{0, 0}, {100, 100}});
  std::vector<Change> lattice{
      {Change::Kind::insert, {}, {ItemKind::polygon, {{{30, 30}, {70, 30}, {70, 70}, {30, 70}}}}}};
  std::vector<ItemId> ids{ItemId{1}};
  for (int x = 2; x < 100; x += 4) {
    for (int y = 2; y < 100; y += 4) {
      const Point point{static_cast<double>(x), static_cast<double>(y)};
      lattice.push_back({Change::Kind::insert, {}, {ItemKind::point, {{point}}}});
      ids.push_back(ItemId{ids.size() + 1});
    }
  }
  reduced.apply(lattice, ids);
  ASSERT_EQ(fault_of(reduced), std::nullopt);
  const ItemId inside{1001};
  const ItemId outside{1002};
  const std::vector<Change> insertions{{Change::Kind::insert, {}, {ItemKind::point, {{{51, 51.5}}}}},
                                       {Change::Kind::insert, {}, {ItemKind::point, {{{11, 11.5}}}}}};
  reduced.apply(insertions, {inside, outside});
  ASSERT_EQ(fault_of(reduced), std::nullopt);
  reduced.apply({{Change::Kind::remove, inside, {}}, {Change::Kind::remove, outside, {}}}, {inside, outside});
  ASSERT_EQ(fault_of(reduced), std::nullopt);
  reduced.apply({insertions[0]}, {inside});
  ASSERT_EQ(fault_of(reduced), std::nullopt);
  reduced.remove(inside);
  ASSERT_EQ(fault_of(reduced), std::nullopt);
}

class AbstractionOfChanges : public testing::TestWithParam<Flavour> {};

INSTANTIATE_TEST_SUITE_P(Flavours, AbstractionOfChanges, testing::ValuesIn(kFlavours),
                         [](const auto& flavour) { return std::string(to_string(flavour.param)); });

TEST_P(AbstractionOfChanges, IsAfterEveryStepThatOfARebuild) {
  for (std::uint64_t seed = is_quick() ? 6 : 0; seed < 24; seed += is_quick() ? 8 : 1) {
    const ChangeScript script = random_changes(GetParam(), seed, 60, 2 + seed);
    Reduced reduced(script.domain);
    LiveItems live(script.domain);
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
      const Result<std::vector<ItemId>> ids = live.apply(script.steps[i]);
      if (!ids) continue;
      reduced.apply(script.steps[i].changes, *ids);
      ASSERT_EQ(fault_of(reduced), std::nullopt) << "seed " << seed << ", step " << i;
      ASSERT_EQ(Expected(reduced.mesh()).fault_of(Abstraction(reduced.mesh())), std::nullopt) << "a rebuild";
    }
  }
}

}  // namespace
}  // namespace waywright::test
