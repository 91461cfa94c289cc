#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "clearance/disc_passage.hpp"
#include "clearance/widest.hpp"
#include "exact/gap.hpp"
#include "support/case_count.hpp"
#include "support/disc_scenes.hpp"
#include "support/random.hpp"

namespace waywright::test {
namespace {

using clearance::Bridges;
using clearance::CellEdge;
using clearance::Cells;
using clearance::GapMemory;
using clearance::Narrowest;
using clearance::WidestSearch;
using disc::NamedScene;

/// A mesh of the walls of a scene, with its bridges.
class GateMap {
 public:
  explicit GateMap(const NamedScene& scene) : mesh_(scene.domain) {
    constraint::ConstrainedTriangulation::UndoGuard operation(mesh_);
    std::uint64_t id = 0;
    for (const auto& [a, b] : scene.walls.segments) {
      if (!(a == b)) mesh_.insert(Shape::segment(a, b), ItemId{++id});
    }
    operation.commit();
    bridges_.emplace(mesh_);
  }

  [[nodiscard]] Cells cells() const { return {mesh_, *bridges_}; }
  /// Returns all gates, from both sides.
  [[nodiscard]] std::vector<CellEdge> gates() const {
    std::vector<CellEdge> gates;
    for (std::uint32_t i = 0; i < 3 * mesh_.topology().face_slots(); ++i) {
      const mesh::HalfEdge h{i};
      if (!mesh_.topology().is_live(mesh::face(h)) || mesh_.triangulation().is_ghost_face(h)) continue;
      if (bridges_->is_bridge(h)) gates.push_back({CellEdge::Kind::bridge, h, Bridges::kNone});
      const std::uint32_t foot = bridges_->foot_at(h);
      if (foot == Bridges::kNone) continue;
      gates.push_back({CellEdge::Kind::foot_down, h, foot});
      gates.push_back({CellEdge::Kind::foot_up, h, foot});
    }
    return gates;
  }

 private:
  constraint::ConstrainedTriangulation mesh_;
  std::optional<Bridges> bridges_;
};

/// Asks about random discs, one after the other, and compares each answer with a search that remembers nothing.
class Questions {
 public:
  explicit Questions(const NamedScene& scene) : map_(scene), cells_(map_.cells()), gates_(map_.gates()) {
    memory_.use(cells_, 1);
  }

  std::size_t refused = 0;
  std::size_t remembered = 0;
  std::size_t known = 0;

  void ask(Random& random) {
    if (gates_.empty()) return;
    const CellEdge start = gates_[random.below(gates_.size())];
    const CellEdge goal = gates_[random.below(gates_.size())];
    // Often exactly half of the length of a gate, or one unit in the last place more.
    double radius = exact::largest_radius(cells_.gap(gates_[random.below(gates_.size())]));
    if (random.chance(50)) radius = std::nextafter(radius, 2 * radius);
    const Narrowest expected = plain_.find(cells_, start, goal);
    const bool is_refused = !expected.is_connected || (expected.gate && is_too_narrow(*expected.gate, radius));
    const auto refusal = memory_.find(cells_, start, goal, radius);
    if (refusal) {
      ++remembered;
      ASSERT_TRUE(is_refused);
      ASSERT_TRUE(memory_.may_refuse(radius));
      if (refusal->is_known) {
        ++known;
        expect_equal(refusal->narrowest, expected);
      }
    }
    search_.begin(cells_, start, goal, radius);
    while (!search_.step(cells_, 1 + random.below(5))) {
      ASSERT_TRUE(!search_.is_refused() || is_refused);
    }
    ASSERT_EQ(search_.is_refused(), is_refused);
    if (!is_refused) return;
    ++refused;
    expect_equal(search_.result(), expected);
    memory_.add(cells_, search_);
  }
  void forget() { memory_.use(cells_, ++state_); }

 private:
  [[nodiscard]] bool is_too_narrow(const CellEdge& gate, double radius) const {
    return exact::compare_to_diameter(cells_.gap(gate), radius) < 0;
  }
  void expect_equal(const Narrowest& narrowest, const Narrowest& expected) const {
    ASSERT_EQ(narrowest.is_connected, expected.is_connected);
    ASSERT_EQ(narrowest.gate.has_value(), expected.gate.has_value());
    if (!expected.gate) return;
    ASSERT_TRUE(*narrowest.gate == *expected.gate || *narrowest.gate == cells_.across(*expected.gate));
  }

  GateMap map_;
  Cells cells_;
  std::vector<CellEdge> gates_;
  GapMemory memory_;
  WidestSearch search_;
  WidestSearch plain_;
  std::uint64_t state_ = 1;
};

class GapMemories : public testing::TestWithParam<disc::SceneKind> {};

TEST_P(GapMemories, RefuseOnlyDiscsThatASearchRefuses) {
  Random random(3);
  std::size_t refused = 0;
  std::size_t remembered = 0;
  std::size_t known = 0;
  for (std::uint64_t i = 0; i < (case_count() + 1) / 2; ++i) {
    SCOPED_TRACE("scene " + std::to_string(i));
    Questions questions(disc::random_scene(random, GetParam()));
    for (int k = 0; k < 200; ++k) {
      questions.ask(random);
      if (HasFatalFailure()) return;
      if (random.chance(1)) questions.forget();
    }
    refused += questions.refused;
    remembered += questions.remembered;
    known += questions.known;
  }
  EXPECT_GT(2 * remembered, refused);
  EXPECT_GT(2 * known, remembered);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GapMemories, testing::ValuesIn(disc::kSceneKinds),
                         [](const auto& kind) { return std::string(to_string(kind.param)); });

}  // namespace
}  // namespace waywright::test
