#include "oracle/oracle.hpp"

#include <cstddef>
#include <gmock/gmock.h>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/small_scenes.hpp"

namespace waywright::oracle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two walls cross at (3/4, 3/4); one ends inside the domain's left side. In the quadrilateral left of the crossing, the
// circle through (0, 1), (0, 3) and the crossing has its centre at (3/4, 2), so (3, 3) lies outside the circle.
const OracleScene kCrossing = square(3, {segment(5, {3, 3}, {0, 0}), segment(9, {0, 1}, {3, 0})});
const std::string kCrossingDump =
    "vertices 6\n"
    "0 1 0 1\n0 1 1 1\n0 1 3 1\n3 4 3 4\n3 1 0 1\n3 1 3 1\n"
    "triangles 5\n"
    "0 3 1\n0 4 3\n1 3 2\n2 3 5\n3 4 5\n"
    "constraints 9\n"
    "0 1 0\n0 3 5\n0 4 0\n1 2 0\n1 3 9\n2 5 0\n3 4 9\n3 5 5\n4 5 0\n";

const std::string kEmptySquareDump =
    "vertices 4\n0 1 0 1\n0 1 4 1\n4 1 0 1\n4 1 4 1\n"
    "triangles 2\n0 2 3\n0 3 1\n"
    "constraints 4\n0 1 0\n0 2 0\n1 3 0\n2 3 0\n";

std::string with(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

std::string fault_of(const OracleScene& scene, const std::string& dump) {
  return check_dump(scene, dump).value_or("no fault");
}

TEST(OracleExpected, CrossingIsReducedAndCutsBothWalls) {
  const ExpectedMesh mesh = expected_vertices_and_constraints(kCrossing);
  EXPECT_THAT(mesh.vertices, ElementsAre("0 1 0 1", "0 1 1 1", "0 1 3 1", "3 4 3 4", "3 1 0 1", "3 1 3 1"));
  ASSERT_EQ(mesh.constraints.size(), 9U);
  EXPECT_EQ(mesh.constraints[1], (OracleConstraint{0, 3, {5}}));
  EXPECT_EQ(mesh.constraints[4], (OracleConstraint{1, 3, {9}}));
  EXPECT_EQ(mesh.constraints[7], (OracleConstraint{3, 5, {5}}));
}

TEST(OracleExpected, OverlapsShareTheirPieces) {
  // On y = 0: the domain from 0 to 8, item 3 from 2 to 6, item 4 (a side of a polygon) from 4 to 8, item 5 a point at
  // 7.
  const OracleScene scene = square(8, {segment(3, {2, 0}, {6, 0}),
                                       {4, OracleKind::polygon, {{{4, 0}, {8, 0}, {8, 4}}}},
                                       {5, OracleKind::point, {{{7, 0}}}}});
  const ExpectedMesh mesh = expected_vertices_and_constraints(scene);
  EXPECT_THAT(mesh.vertices, ElementsAre("0 1 0 1", "0 1 8 1", "2 1 0 1", "4 1 0 1", "6 1 0 1", "7 1 0 1", "8 1 0 1",
                                         "8 1 4 1", "8 1 8 1"));
  const std::vector<OracleConstraint> constraints{{0, 1, {0}},       {0, 2, {0}}, {1, 8, {0}},    {2, 3, {0, 3}},
                                                  {3, 4, {0, 3, 4}}, {3, 7, {4}}, {4, 5, {0, 4}}, {5, 6, {0, 4}},
                                                  {6, 7, {0, 4}},    {7, 8, {0}}};
  EXPECT_EQ(mesh.constraints, constraints);
}

TEST(OracleExpected, CrossingsThatCoincideAreOneVertex) {
  // Four walls through (2, 2): one of them occurs twice, one consists of two sides of a polyline, and one ends there.
  const OracleScene scene = square(4, {segment(1, {1, 1}, {3, 3}),
                                       segment(2, {1, 3}, {3, 1}),
                                       segment(3, {3, 1}, {1, 3}),
                                       {4, OracleKind::polyline, {{{2, 1}, {2, 2}, {2, 3}}}},
                                       segment(6, {1, 2}, {2, 2}),
                                       segment(7, {2, 2}, {2, 2})});
  const Oracle oracle(scene);
  EXPECT_EQ(oracle.vertex_count(), 4U + 7U + 1U);
  EXPECT_EQ(oracle.crossing_count(), 0U);  // (2, 2) is a corner as well
  EXPECT_EQ(oracle.constraint_count(), 4U + 7U);
}

TEST(OracleExpected, PositionsAreExactAtTheEndsOfTheRange) {
  const double big = 0x1p100;
  const double tiny = 0x1p-100;
  const OracleScene scene{{{-big, -big}, {big, big}},
                          {segment(1, {-big, tiny}, {big, tiny}), segment(2, {-0.0, -1}, {0, 1})}};
  const ExpectedMesh mesh = expected_vertices_and_constraints(scene);
  ASSERT_EQ(mesh.vertices.size(), 9U);
  EXPECT_EQ(mesh.vertices[0], "-1267650600228229401496703205376 1 -1267650600228229401496703205376 1");
  EXPECT_EQ(mesh.vertices[3], "0 1 -1 1");
  EXPECT_EQ(mesh.vertices[4], "0 1 1 1267650600228229401496703205376");
  EXPECT_EQ(mesh.vertices[5], "0 1 1 1");
}

TEST(OracleExpected, NearestDoublesAreCorrectlyRounded) {
  // The walls (0, 0)-(1, q) and (0, p)-(1, p) cross at (p/q, p); IEEE division rounds p/q correctly.
  for (int q = 2; q < 60; ++q) {
    for (int p = 1; p < q; ++p) {
      const OracleScene scene{{{-1, -1}, {100, 100}},
                              {segment(1, {0, 0}, {1, double(q)}), segment(2, {0, double(p)}, {1, double(p)})}};
      const Oracle oracle(scene);
      const OraclePoint crossing{double(p) / double(q), double(p)};
      EXPECT_THAT(oracle.nearest_vertices(), ::testing::Contains(crossing)) << p << "/" << q;
      EXPECT_EQ(oracle.crossing_count(), 1U);
    }
  }
}

TEST(OracleDump, AcceptsTheRightMesh) {
  EXPECT_EQ(fault_of(kCrossing, kCrossingDump), "no fault");
  EXPECT_EQ(fault_of(square(4), kEmptySquareDump), "no fault");
}

TEST(OracleDump, RefusesWrongForm) {
  const auto fault = [](const std::string& old_part, const std::string& new_part) {
    return fault_of(kCrossing, with(kCrossingDump, old_part, new_part));
  };
  EXPECT_THAT(fault("vertices 6", "vertices  6"), HasSubstr("expected 'vertices COUNT'"));
  EXPECT_THAT(fault("vertices 6", "Vertices 6"), HasSubstr("expected 'vertices COUNT'"));
  EXPECT_THAT(fault("triangles 5", "triangles 05"), HasSubstr("expected 'triangles COUNT'"));
  EXPECT_THAT(fault("triangles 5", "triangles 4"), HasSubstr("expected 'constraints COUNT'"));
  EXPECT_THAT(fault("constraints 9", "constraints 10"), HasSubstr("ends after 9 of 10 lines"));
  EXPECT_THAT(fault("4 5 0\n", "4 5 0"), HasSubstr("ends after 8 of 9 lines"));
  EXPECT_THAT(fault("4 5 0\n", "4 5 0\n\n"), HasSubstr("text after the last constraint"));
  EXPECT_THAT(fault("0 4 3\n", "0 4 3 \n"), HasSubstr("is not three vertices"));
  EXPECT_THAT(fault("0 4 3\n", "0 4 6\n"), HasSubstr("is not three vertices"));
  EXPECT_THAT(fault("0 4 3\n", "0 4 -3\n"), HasSubstr("is not three vertices"));
  EXPECT_THAT(fault("3 4 3 4", "3 4 3 4\r"), HasSubstr("is not four integers"));
  EXPECT_THAT(fault("3 4 3 4", "3 4 03 4"), HasSubstr("is not four integers"));
  EXPECT_THAT(fault("0 1 1 1", "-0 1 1 1"), HasSubstr("is not four integers"));
  EXPECT_THAT(fault_of(kCrossing, ""), HasSubstr("expected 'vertices COUNT'"));
}

TEST(OracleDump, RefusesWrongVertices) {
  const auto fault = [](const std::string& old_part, const std::string& new_part) {
    return fault_of(kCrossing, with(kCrossingDump, old_part, new_part));
  };
  EXPECT_THAT(fault("3 4 3 4", "6 8 3 4"), HasSubstr("not reduced"));
  EXPECT_THAT(fault("0 1 1 1", "0 2 1 1"), HasSubstr("not reduced"));
  EXPECT_THAT(fault("3 4 3 4", "-3 -4 3 4"), HasSubstr("not positive"));
  EXPECT_THAT(fault("3 4 3 4", "3 0 3 4"), HasSubstr("not positive"));
  EXPECT_THAT(fault("3 4 3 4", "3 4 3 5"), HasSubstr("vertex 3 is '3 4 3 5', expected '3 4 3 4'"));
  EXPECT_THAT(fault("0 1 1 1\n0 1 3 1\n", "0 1 3 1\n0 1 1 1\n"), HasSubstr("out of order"));
  EXPECT_THAT(fault_of(square(4), with(kEmptySquareDump, "vertices 4\n", "vertices 5\n-1 1 0 1\n")),
              HasSubstr("vertex 0"));
  EXPECT_THAT(fault_of(square(4), with(kEmptySquareDump, "4 1 4 1\n", "")), HasSubstr("expected 'triangles COUNT'"));
}

TEST(OracleDump, RefusesWrongConstraints) {
  const auto fault = [](const std::string& old_part, const std::string& new_part) {
    return fault_of(kCrossing, with(kCrossingDump, old_part, new_part));
  };
  EXPECT_THAT(fault("1 3 9", "1 3 5"), HasSubstr("constraint 4"));
  EXPECT_THAT(fault("1 3 9", "1 3 9 9"), HasSubstr("constraint 4"));
  EXPECT_THAT(fault("1 3 9", "1 3 5 9"), HasSubstr("constraint 4"));
  EXPECT_THAT(fault("1 3 9", "3 1 9"), HasSubstr("constraint 4"));
  EXPECT_THAT(fault("0 1 0\n0 3 5\n", "0 3 5\n0 1 0\n"), HasSubstr("out of order"));
  EXPECT_THAT(fault("constraints 9\n", "constraints 10\n0 1 0\n"), HasSubstr("constraint 1 is '0 1 0'"));
  EXPECT_THAT(fault_of(kCrossing, with(with(kCrossingDump, "constraints 9", "constraints 8"), "4 5 0\n", "")),
              HasSubstr("constraint 8 is missing"));
}

TEST(OracleDump, RefusesWrongTriangles) {
  const auto fault = [](const std::string& old_part, const std::string& new_part) {
    return fault_of(kCrossing, with(kCrossingDump, old_part, new_part));
  };
  EXPECT_THAT(fault("0 3 1", "0 1 3"), HasSubstr("not counter-clockwise"));
  EXPECT_THAT(fault("0 3 1", "0 3 3"), HasSubstr("not counter-clockwise"));
  EXPECT_THAT(fault("0 3 1", "0 3 5"), HasSubstr("not counter-clockwise"));
  EXPECT_THAT(fault("3 4 5", "4 5 3"), HasSubstr("smallest index"));
  EXPECT_THAT(fault("0 3 1\n0 4 3\n", "0 4 3\n0 3 1\n"), HasSubstr("out of order"));
  EXPECT_THAT(fault("0 4 3\n", "0 3 1\n"), HasSubstr("there twice"));
}

TEST(OracleDump, RefusesHolesAndOverlaps) {
  const auto fault = [](const std::string& old_part, const std::string& new_part) {
    return fault_of(kCrossing, with(kCrossingDump, old_part, new_part));
  };
  // A triangle is missing: its inner edges belong to one triangle only, off the boundary.
  EXPECT_THAT(fault("triangles 5\n0 3 1\n0 4 3\n1 3 2\n2 3 5\n3 4 5\n", "triangles 4\n0 3 1\n0 4 3\n1 3 2\n3 4 5\n"),
              HasSubstr("is in 1 triangles, off the domain's border"));
  // A triangle that overlaps others.
  EXPECT_THAT(fault("triangles 5\n0 3 1\n", "triangles 6\n0 3 1\n0 3 2\n"), HasSubstr("is in"));
  // A corner of the domain that belongs to no triangle.
  EXPECT_THAT(fault("triangles 5\n0 3 1\n0 4 3\n1 3 2\n2 3 5\n3 4 5\n", "triangles 3\n0 3 1\n0 4 3\n3 4 5\n"),
              HasSubstr("vertex 2 is in no triangle"));
}

TEST(OracleDump, RefusesAConstrainedEdgeThatIsNoSide) {
  // The wall 7 is one diagonal of the square; the triangles have the other one.
  const OracleScene scene = square(4, {segment(7, {0, 4}, {4, 0})});
  const std::string right = with(with(kEmptySquareDump, "0 2 3\n0 3 1\n", "0 2 1\n1 2 3\n"),
                                 "constraints 4\n0 1 0\n0 2 0\n", "constraints 5\n0 1 0\n0 2 0\n1 2 7\n");
  EXPECT_EQ(fault_of(scene, right), "no fault");
  EXPECT_THAT(fault_of(scene, with(right, "0 2 1\n1 2 3\n", "0 2 3\n0 3 1\n")),
              HasSubstr("'1 2' is no triangle's edge"));
}

TEST(OracleDump, RefusesTheWrongDiagonal) {
  EXPECT_THAT(fault_of(kCrossing, with(kCrossingDump, "1 3 2\n2 3 5\n", "1 3 5\n1 5 2\n")),
              HasSubstr("edge '1 5' fails the empty-circle test"));
  EXPECT_THAT(fault_of(square(4), with(kEmptySquareDump, "0 2 3\n0 3 1\n", "0 2 1\n1 2 3\n")),
              HasSubstr("edge '1 2' breaks the tie rule"));
}

TEST(OracleLocate, NamesVertexEdgeAndFace) {
  const Oracle oracle(kCrossing);
  const auto locations = oracle.locate(kCrossingDump, {{0.75, 0.75}, {1.5, 1.5}, {0, 2}, {2.5, 1}, {0.25, 2}, {3, 3}});
  ASSERT_EQ(locations.size(), 6U);
  EXPECT_EQ(locations[0].kind, OracleLocation::Kind::vertex);
  EXPECT_THAT(locations[0].vertices, ElementsAre(OraclePoint{0.75, 0.75}));
  EXPECT_EQ(locations[1].kind, OracleLocation::Kind::edge);
  EXPECT_THAT(locations[1].vertices, ElementsAre(OraclePoint{0.75, 0.75}, OraclePoint{3, 3}));
  EXPECT_EQ(locations[2].kind, OracleLocation::Kind::edge);
  EXPECT_THAT(locations[2].vertices, ElementsAre(OraclePoint{0, 1}, OraclePoint{0, 3}));
  EXPECT_EQ(locations[3].kind, OracleLocation::Kind::face);
  EXPECT_THAT(locations[3].vertices, ElementsAre(OraclePoint{0.75, 0.75}, OraclePoint{3, 0}, OraclePoint{3, 3}));
  EXPECT_EQ(locations[4].kind, OracleLocation::Kind::face);
  EXPECT_THAT(locations[4].vertices, ElementsAre(OraclePoint{0, 1}, OraclePoint{0.75, 0.75}, OraclePoint{0, 3}));
  EXPECT_EQ(locations[5].kind, OracleLocation::Kind::vertex);
}

TEST(OracleConnected, ConnectsThroughFreeEdgesOnly) {
  // The walls 5 and 9 divide the square into four pieces: left, bottom, right and the rest above.
  const Oracle oracle(kCrossing);
  EXPECT_TRUE(oracle.connected(kCrossingDump, {0.125, 2}, {2, 2.5}));
  EXPECT_FALSE(oracle.connected(kCrossingDump, {0.125, 2}, {2.5, 1}));
  EXPECT_FALSE(oracle.connected(kCrossingDump, {0.125, 0.5}, {2, 2.5}));
  EXPECT_TRUE(oracle.connected(kCrossingDump, {0.75, 0.75}, {2, 2.5}));
  EXPECT_TRUE(oracle.connected(kCrossingDump, {2, 2}, {2.5, 1}));
  EXPECT_TRUE(oracle.connected(kCrossingDump, {2, 2}, {2, 2.5}));
  EXPECT_FALSE(oracle.connected(kCrossingDump, {0, 0}, {2, 2.5}));
}

TEST(OracleConnected, KeepsOutOfSolids) {
  // The lower right half is solid.
  const OracleScene scene = square(4, {{1, OracleKind::polygon, {{{0, 0}, {4, 0}, {4, 4}}}}});
  const std::string dump =
      with(with(kEmptySquareDump, "constraints 4\n0 1 0\n0 2 0\n", "constraints 5\n0 1 0\n0 2 0 1\n0 3 1\n"), "2 3 0\n",
           "2 3 0 1\n");
  EXPECT_EQ(fault_of(scene, dump), "no fault");
  const Oracle oracle(scene);
  EXPECT_TRUE(oracle.connected(dump, {1, 2}, {3, 3}));
  EXPECT_FALSE(oracle.connected(dump, {1, 2}, {4, 1}));
  EXPECT_FALSE(oracle.connected(dump, {4, 1}, {4, 2}));
  EXPECT_TRUE(oracle.connected(dump, {4, 1}, {4, 1}));
}

TEST(OracleCover, EvenOddWithItsBoundary) {
  // 1: a square with a square hole that contains an island. 2: a bow tie. 3: a ring that visits its corners twice. 4: a
  // point. 5: a polygon without area.
  const OracleScene scene = square(
      20, {{1,
            OracleKind::polygon,
            {{{1, 1}, {9, 1}, {9, 9}, {1, 9}}, {{2, 2}, {2, 8}, {8, 8}, {8, 2}}, {{4, 4}, {6, 4}, {6, 6}, {4, 6}}}},
           {2, OracleKind::polygon, {{{10, 0}, {14, 4}, {14, 0}, {10, 4}}}},
           {3, OracleKind::polygon, {{{10, 10}, {14, 10}, {14, 14}, {10, 10}, {14, 10}, {14, 14}}}},
           {4, OracleKind::polygon, {{{5, 5}, {5, 5}}}},
           {5, OracleKind::polygon, {{{12, 2}, {18, 2}}}},
           {6, OracleKind::segment, {{{1, 5}, {3, 5}}}}});
  const Oracle oracle(scene);
  EXPECT_THAT(oracle.covering_polygons({1.5, 5}), ElementsAre(1));
  EXPECT_TRUE(oracle.strictly_inside({1.5, 5}));
  EXPECT_THAT(oracle.covering_polygons({3, 3}), IsEmpty());
  EXPECT_FALSE(oracle.strictly_inside({3, 3}));
  EXPECT_THAT(oracle.covering_polygons({2, 2}), ElementsAre(1));
  EXPECT_FALSE(oracle.strictly_inside({2, 2}));
  EXPECT_THAT(oracle.covering_polygons({5, 5}), ElementsAre(1, 4));
  EXPECT_TRUE(oracle.strictly_inside({5, 5}));
  EXPECT_THAT(oracle.covering_polygons({12, 2}), ElementsAre(2, 5));
  EXPECT_FALSE(oracle.strictly_inside({12, 2}));
  EXPECT_THAT(oracle.covering_polygons({13, 2}), ElementsAre(2, 5));
  EXPECT_TRUE(oracle.strictly_inside({13, 2}));
  EXPECT_THAT(oracle.covering_polygons({12, 1}), IsEmpty());
  EXPECT_THAT(oracle.covering_polygons({13, 11}), IsEmpty());
  EXPECT_THAT(oracle.covering_polygons({14, 12}), ElementsAre(3));
  EXPECT_FALSE(oracle.strictly_inside({14, 12}));
  EXPECT_THAT(oracle.covering_polygons({12, 12}), ElementsAre(3));
  // Just beside the slanted side of 3, by the smallest step of a double.
  EXPECT_THAT(oracle.covering_polygons({12, 0x1.8000000000001p3}), IsEmpty());
}

TEST(OracleCover, NonzeroWithItsBoundary) {
  // 1: a square that contains a square with the same direction, which contains a ring that turns twice in the opposite
  // direction. 2: a bow tie. 3: a ring that visits its corners twice. 4: two squares that overlap and have opposite
  // directions.
  const OracleScene scene = square(
      20,
      {{1,
        OracleKind::polygon,
        {{{1, 1}, {9, 1}, {9, 9}, {1, 9}},
         {{2, 2}, {8, 2}, {8, 8}, {2, 8}},
         {{4, 4}, {4, 6}, {6, 6}, {6, 4}, {4, 4}, {4, 6}, {6, 6}, {6, 4}}},
        true},
       {2, OracleKind::polygon, {{{10, 0}, {14, 4}, {14, 0}, {10, 4}}}, true},
       {3, OracleKind::polygon, {{{10, 10}, {14, 10}, {14, 14}, {10, 10}, {14, 10}, {14, 14}}}, true},
       {4, OracleKind::polygon, {{{1, 11}, {5, 11}, {5, 15}, {1, 15}}, {{3, 13}, {3, 17}, {7, 17}, {7, 13}}}, true}});
  const Oracle oracle(scene);
  for (const OraclePoint inside : {OraclePoint{1.5, 5}, OraclePoint{3, 3}}) {
    EXPECT_THAT(oracle.covering_polygons(inside), ElementsAre(1));
    EXPECT_TRUE(oracle.strictly_inside(inside));
  }
  EXPECT_THAT(oracle.covering_polygons({5, 5}), IsEmpty());
  EXPECT_THAT(oracle.covering_polygons({2, 2}), ElementsAre(1));
  EXPECT_FALSE(oracle.strictly_inside({2, 2}));
  EXPECT_THAT(oracle.covering_polygons({11, 2}), ElementsAre(2));
  EXPECT_TRUE(oracle.strictly_inside({13, 2}));
  EXPECT_THAT(oracle.covering_polygons({12, 1}), IsEmpty());
  EXPECT_THAT(oracle.covering_polygons({13, 11}), ElementsAre(3));
  EXPECT_TRUE(oracle.strictly_inside({13, 11}));
  EXPECT_FALSE(oracle.strictly_inside({12, 12}));
  EXPECT_THAT(oracle.covering_polygons({2, 12}), ElementsAre(4));
  EXPECT_THAT(oracle.covering_polygons({6, 16}), ElementsAre(4));
  EXPECT_THAT(oracle.covering_polygons({4, 14}), IsEmpty());
}

}  // namespace
}  // namespace waywright::oracle
