// SPDX-License-Identifier: GPL-3.0-or-later
// Welding, and the guarantees of robust/mesh/merge.h by hand: what is merged, what is kept apart, and where regions are
// cut.
#include "robust/mesh/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/mesh/scene_faces.h"
#include "robust/mesh/weld.h"
#include "tests/robust/mesh/merged.h"
#include "tests/robust/support/limits.h"
#include "tests/robust/support/random_meshes.h"

namespace touchstone::mesh_tests {
namespace {

using contact_tests::kInfinity;
using mesh::EdgeCounts;
using mesh::merge_faces;
using mesh::MergedFace;
using mesh::MergedMesh;

TEST(Weld, KeepsTheFirstOfEqualVerticesInTheirOrder) {
  const Mesh mesh{{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {5, 4, 3}}};
  const Mesh welded = mesh::weld(mesh);
  const std::vector<Eigen::Vector3d> expected{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(welded.vertices, expected);
  EXPECT_EQ(welded.faces, (std::vector<Numbers>{{0, 1, 2}, {3, 0, 1}}));
}

TEST(Weld, TakesBothZerosForOne) {
  const Mesh welded = mesh::weld({{{0, 0, 1}, {-0.0, 0, 1}, {0, -0.0, 1}}, {{0, 1, 2}}});
  EXPECT_EQ(welded.vertices.size(), 1U);
  EXPECT_EQ(welded.faces, (std::vector<Numbers>{{0, 0, 0}}));
}

TEST(Weld, KeepsNeighbouringDoublesApart) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(mesh::weld({{{1, 1, 1}, {1, 1, next}, {1, next, 1}, {next, 1, 1}, {1, 1, 1}}, {}}).vertices.size(), 4U);
}

MergedMesh merged_soundly(const Mesh& mesh, double tolerance = 0) {
  MergedMesh merged = merge_faces(mesh, tolerance);
  expect_sound(mesh, merged, "");
  return merged;
}

TEST(Merge, MakesSixSquaresOfACubeOfTwelveTriangles) {
  const MergedMesh merged = merged_soundly(cube());
  ASSERT_EQ(merged.faces.size(), 6U);
  for (const MergedFace& face : merged.faces) {
    EXPECT_EQ(face.faces.size(), 2U);
    EXPECT_EQ(face.polygon.vertex_count(), 4U);
    EXPECT_EQ(face.off_plane, 0);
  }
  EXPECT_EQ(merged.edges, (EdgeCounts{.merged = 6, .crease = 12}));
  EXPECT_EQ(merged.splits, 0U);
}

TEST(Merge, WeldsTheTrianglesOfASoup) {
  EXPECT_EQ(groups(merged_soundly(unwelded(cube()))), groups(merge_faces(cube())));
}

// Oriented against the axis, so that the outer loop is clockwise as seen along it.
TEST(Merge, FindsTheHoleOfAPlateOnEitherSide) {
  for (const bool flipped : {false, true}) {
    const Mesh plate = grid(
        3, 3, [](int i, int j) { return i != 1 || j != 1; }, flipped);
    const MergedMesh merged = merged_soundly(plate);
    ASSERT_EQ(merged.faces.size(), 1U);
    const Polygon& polygon = merged.faces[0].polygon;
    EXPECT_EQ(polygon.loop_count(), 2U);
    EXPECT_EQ(polygon.loop_end(0), 12U);  // on straight runs too
    EXPECT_EQ(polygon.vertex_count(), 16U);
    const Ball above{{1.5, 1.5, 1}, 1};
    EXPECT_EQ(exact::foot(above, polygon), PointLocation::Outside);
    EXPECT_EQ(exact::plane_side({{1, 1, 1}, 0}, polygon), flipped ? PlaneSide::Behind : PlaneSide::InFront);
  }
}

TEST(Merge, FindsTheOuterLoopWhateverFaceIsFirst) {
  Mesh plate = grid(5, 5, [](int i, int j) { return i != 2 || j != 2; });
  for (std::size_t k = 0; k < plate.faces.size(); ++k) {
    std::rotate(plate.faces.begin(), plate.faces.begin() + 1, plate.faces.end());
    const MergedMesh merged = merged_soundly(plate);
    ASSERT_EQ(merged.faces.size(), 1U) << k;
    EXPECT_EQ(merged.faces[0].polygon.loop_end(0), 20U) << k;
  }
}

TEST(Merge, KeepsAPlateWithinTheHoleOfAnotherApart) {
  const auto ring = [](int i, int j) { return std::max(std::abs(i - 2), std::abs(j - 2)) != 1; };
  const MergedMesh merged = merged_soundly(grid(5, 5, ring));
  ASSERT_EQ(merged.faces.size(), 2U);
  EXPECT_EQ(merged.faces[0].polygon.loop_count(), 2U);
  EXPECT_EQ(merged.faces[1].polygon.loop_count(), 1U);
}

TEST(Merge, MakesOnePolygonOfAFan) {
  Mesh fan{{{0, 0, 5}}, {}};
  const std::vector<std::pair<double, double>> rim{{3, 0}, {1, 1}, {0, 4}, {-2, 1}, {-3, -2}, {0, -1}, {2, -3}};
  for (const auto& [x, y] : rim) fan.vertices.emplace_back(x, y, 5);
  const auto n = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t i = 0; i < n; ++i) fan.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  const MergedMesh merged = merged_soundly(fan);
  ASSERT_EQ(merged.faces.size(), 1U);
  EXPECT_EQ(merged.faces[0].polygon.vertex_count(), n);  // the hub is inside
  EXPECT_EQ(merged.edges, (EdgeCounts{.border = n, .merged = n}));
}

TEST(Merge, KeepsTrianglesApartThatMeetInAPoint) {
  const Mesh bow_tie{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(groups(merged_soundly(bow_tie)), (std::vector<Numbers>{{0}, {1}}));
}

// The hole touches the border in a corner; or two holes touch each other.
TEST(Merge, KeepsARegionWholeThatTouchesItselfInAVertex) {
  for (const bool border : {false, true}) {
    const auto holes = [border](int i, int j) {
      return border ? (i != 0 || j != 0) && (i != 1 || j != 1) : (i != 1 || j != 1) && (i != 2 || j != 2);
    };
    const Mesh plate = grid(4, 4, holes);
    const MergedMesh merged = merged_soundly(plate);
    EXPECT_EQ(merged.faces.size(), 1U);
    EXPECT_EQ(merged.splits, 0U);
    EXPECT_EQ(merged.edges.kept_apart, 0U);
  }
}

// Two triangles in one loop: at its lowest point the loop turns to the right once, within its turn to the left.
TEST(Merge, KnowsTheOrientationOfALoopThatVisitsItsLowestPointTwice) {
  std::vector<std::uint32_t> loop{0, 1, 2, 0, 3, 4};
  for (std::size_t first = 0; first < loop.size(); ++first, std::rotate(loop.begin(), loop.begin() + 1, loop.end())) {
    const Mesh plate{{{0, 0, 0}, {1, 2, 0}, {0, 8, 0}, {8, 0, 0}, {2, 1, 0}, {8, 4, 0}}, {loop, {4, 3, 5}}};
    EXPECT_EQ(merged_soundly(plate).faces.size(), 1U) << first;
  }
}

// Which of the three continues? None: the plate is cut from the end of the fin's foot to wherever it must be.
TEST(Merge, DoesNotMergeAcrossAnEdgeOfThreeFaces) {
  Mesh finned = grid(3, 3, [](int, int) { return true; });
  const std::uint32_t tip = static_cast<std::uint32_t>(finned.vertices.size());
  finned.vertices.emplace_back(1, 1, 1);
  finned.faces.push_back({5, 6, tip});  // from (1, 1) to (2, 1)
  const MergedMesh merged = merged_soundly(finned);
  EXPECT_EQ(merged.edges.non_manifold, 1U);
  EXPECT_EQ(merged.faces.size(), 3U);
  EXPECT_EQ(merged.splits, 1U);
}

TEST(Merge, DoesNotMergeAcrossAnEdgeThatBothRunThroughAlike) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 3, 1}, {1, 2, 3}}};
  const Mesh flipped{mesh.vertices, {mesh.faces[0], {1, 2, 3}}};
  EXPECT_EQ(groups(merged_soundly(flipped)), (std::vector<Numbers>{{0}, {1}}));
  EXPECT_EQ(merge_faces(flipped).edges.inconsistent, 1U);
}

// A strip of three squares, its ends glued with a half twist, flattened: no orientation fits.
TEST(Merge, AccountsForEveryFaceOfAMoebiusStrip) {
  Mesh strip{{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {1, 1, 1}, {3, 1, 1}, {2, 2, 1}}, {}};
  strip.faces = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 3, 0}, {2, 0, 5}};
  const MergedMesh merged = merged_soundly(strip);
  const EdgeCounts& e = merged.edges;
  EXPECT_EQ(e.border + e.non_manifold + e.inconsistent + e.merged + e.folded + e.kept_apart + e.crease, 12U);
  EXPECT_GT(e.inconsistent, 0U);
}

TEST(Merge, KeepsDuplicatesAsTheyAre) {
  const Mesh twice{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
  EXPECT_EQ(groups(merged_soundly(twice)), (std::vector<Numbers>{{0}, {1}}));
  EXPECT_EQ(merge_faces(twice).edges, (EdgeCounts{.inconsistent = 3}));
}

// Both sides of a leaf: a closed surface in one plane.
TEST(Merge, DoesNotMergeFacesThatAreFoldedBack) {
  const Mesh leaf{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  EXPECT_EQ(groups(merged_soundly(leaf)), (std::vector<Numbers>{{0}, {1}}));
  EXPECT_EQ(merge_faces(leaf).edges, (EdgeCounts{.folded = 3}));
}

// Seven right angles about one vertex in one plane: the last squares lie over the first.
TEST(Merge, CutsAWindingThatLiesOverItself) {
  const Mesh ramp = winding(7);
  const MergedMesh merged = merged_soundly(ramp);
  EXPECT_GT(merged.faces.size(), 1U);
  EXPECT_LE(merged.faces.size(), 4U);
}

// Two squares, one over the other, slit from (-1, 0) to (1, 0) and joined crosswise: each side of the one continues in
// the other. Their two outlines would pass for a loop and its hole, but that both run around counterclockwise.
TEST(Merge, CutsSheetsThatAreJoinedCrosswise) {
  const Mesh sheets{
      {{-1, 0, 0},
       {1, 0, 0},
       {0, 0, 0},
       {0.25, 0, 0},  // the slit's ends and two middles
       {-4, 0, 0},
       {4, 0, 0},
       {4, 4, 0},
       {-4, 4, 0},
       {-4, -4, 0},
       {4, -4, 0},
       {-2, 0, 0},
       {2, 0, 0},
       {2, 2, 0},
       {-2, 2, 0},
       {-2, -2, 0},
       {2, -2, 0}},
      {{4, 0, 2, 1, 5, 6, 7}, {5, 1, 3, 0, 4, 8, 9}, {10, 0, 3, 1, 11, 12, 13}, {11, 1, 2, 0, 10, 14, 15}}};
  const MergedMesh merged = merged_soundly(sheets);
  EXPECT_EQ(merged.edges.border, 12U);
  EXPECT_GT(merged.faces.size(), 1U);
  for (const MergedFace& face : merged.faces) EXPECT_EQ(face.polygon.loop_count(), 1U);
}

// The lower half has a vertex on the edge between the two that the upper half lacks.
TEST(Merge, MergesOverATJunction) {
  const Mesh halves{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}},
                    {{0, 1, 2}, {0, 4, 3}, {3, 4, 5}, {3, 5, 1}}};
  const MergedMesh merged = merged_soundly(halves);
  EXPECT_EQ(groups(merged), (std::vector<Numbers>{{0, 1, 2, 3}}));
  EXPECT_EQ(merged.edges, (EdgeCounts{.border = 5, .merged = 4}));
}

// Guarantee (4) at a crease: the upper triangle takes both vertices on its edge, in their order along it, though one of
// them belongs to no face.
TEST(Merge, SplitsEdgesAtTheVerticesOnThem) {
  const Mesh roof{{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {3, 0, 0}, {1, 0, 0}, {2, -1, 1}},
                  {{0, 1, 2}, {0, 5, 3}, {3, 5, 1}}};
  const MergedMesh merged = merged_soundly(roof);
  ASSERT_EQ(groups(merged), (std::vector<Numbers>{{0}, {1, 2}}));
  EXPECT_EQ(merged.faces[0].polygon, Polygon({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 1, 0}}));
  EXPECT_EQ(merged.edges, (EdgeCounts{.border = 4, .merged = 1, .crease = 3}));
}

// A square of two triangles, and a fin that stands on half of the edge between them.
TEST(Merge, MergesOverAnEdgeOnAPartOfWhichAnotherFaceStands) {
  const Mesh finned{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, 1}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}}};
  const MergedMesh merged = merged_soundly(finned);
  EXPECT_EQ(groups(merged), (std::vector<Numbers>{{0, 1}, {2}}));
  EXPECT_EQ(merged.edges, (EdgeCounts{.border = 7, .merged = 2}));
}

TEST(Merge, SplitsNoEdgeAtAVertexOneDoubleBesideIt) {
  Mesh roof{{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {1, 0x1p-1074, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(merged_soundly(roof).faces[0].polygon.vertex_count(), 3U);
  roof.vertices[3].y() = 0;
  EXPECT_EQ(merged_soundly(roof).faces[0].polygon.vertex_count(), 4U);
}

// A face that is not planar would be lifted onto another plane, had it more vertices.
TEST(Merge, KeepsTheCornersOfAFaceThatIsNotPlanar) {
  const Mesh warped{{{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}, {1, 0, 0}}, {{0, 1, 2, 3}}};
  EXPECT_EQ(merged_soundly(warped).faces[0].polygon.vertex_count(), 4U);
}

// A C whose ends lie against each other, except for a vertex that one of them lacks.
TEST(Merge, ClosesARingOverATJunction) {
  Mesh ring = grid(3, 3, [](int i, int j) { return i != 1 || j != 1; });
  // The edge above the lowest square of the left column gets a vertex, in that square alone.
  ring.vertices.emplace_back(0.5, 1, 0);
  const auto middle = static_cast<std::uint32_t>(ring.vertices.size() - 1);
  for (auto& face : ring.faces)
    if (face == std::vector<std::uint32_t>{0, 5, 4}) face = {0, 5, middle};
  ring.faces.push_back({0, middle, 4});
  const MergedMesh merged = merged_soundly(ring);
  ASSERT_EQ(merged.faces.size(), 1U);
  EXPECT_EQ(merged.faces[0].polygon.loop_count(), 2U);
  EXPECT_EQ(merged.splits, 0U);
}

TEST(Merge, NamesTheFacesThatAreNone) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 2, 3}}};
  const MergedMesh merged = merged_soundly(mesh);
  ASSERT_EQ(merged.rejected.size(), 2U);
  EXPECT_EQ(merged.rejected[0].face, 0U);
  EXPECT_EQ(merged.rejected[0].rejection.code, RejectionCode::ZeroNormal);
  EXPECT_EQ(merged.rejected[1].face, 2U);
  EXPECT_EQ(merged.rejected[1].rejection.code, RejectionCode::RepeatedVertex);
  EXPECT_EQ(groups(merged), (std::vector<Numbers>{{1, 3}}));
}

TEST(Merge, TakesPlanarFacesOfManyVerticesAndLeavesWarpedOnes) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {3, 0, 0}, {3, 1, 0.5}},
                  {{0, 1, 2, 3}, {1, 4, 5, 2}, {4, 6, 7, 5}}};
  const MergedMesh merged = merged_soundly(mesh);
  EXPECT_EQ(groups(merged), (std::vector<Numbers>{{0, 1}, {2}}));
  EXPECT_EQ(merged.faces[0].off_plane, 0);
  EXPECT_EQ(merged.faces[1].off_plane, exact::answer({{0, 0, 0}, 0}, merged.faces[1].polygon).off_plane);
  EXPECT_GT(merged.faces[1].off_plane, 0);
}

// One double off is off.
TEST(Merge, DecidesExactlyWhetherFacesShareAPlane) {
  Mesh square{{{0.1, 0.1, 0.3}, {1.1, 0.1, 0.3}, {1.1, 1.1, 0.3}, {0.1, 1.1, 0.3}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(merged_soundly(square).faces.size(), 1U);
  square.vertices[3].z() = std::nextafter(0.3, 1.0);
  EXPECT_EQ(merged_soundly(square).faces.size(), 2U);
  EXPECT_EQ(merged_soundly(square, 1e-15).faces.size(), 1U);
  for (const double size : {0x1p-1060, 0x1p1000}) {  // whose cubes are not doubles
    Mesh scaled{{{0, 0, size}, {size, 0, size}, {size, size, size}, {0, size, size}}, {{0, 1, 2}, {0, 2, 3}}};
    EXPECT_EQ(merged_soundly(scaled).faces.size(), 1U);
    scaled.vertices[3].z() = std::nextafter(size, kInfinity);
    EXPECT_EQ(merged_soundly(scaled).faces.size(), 2U);
  }
}

TEST(Merge, RefusesAToleranceThatIsNone) {
  for (const double tolerance : {-1e-9, kInfinity, std::nan("")})
    EXPECT_THROW((void)merge_faces(cube(), tolerance), std::invalid_argument);
}

TEST(Merge, MergesMoreWithATolerance) {
  const Mesh plate = shaken(grid(8, 8, [](int, int) { return true; }), 1e-6, 1);
  EXPECT_EQ(merged_soundly(plate, 0.01).faces.size(), 1U);
  EXPECT_GT(merged_soundly(plate).faces.size(), 64U);
}

// A large triangle in z = 0 between a rim below and a peak above it: each near its plane, but not near each other's.
TEST(Merge, MeasuresFromThePlaneOfThePolygonAndInsideItToo) {
  const Mesh mesh{
      {{-6, -4, 0}, {6, -4, 0}, {0, 7, 0}, {0, -6, 0.9}, {-8, -8, -0.9}, {8, -8, -0.9}, {8, 8, -0.9}, {-8, 8, -0.9}},
      {{0, 1, 2}, {0, 3, 1}, {4, 5, 3}, {4, 3, 0}, {5, 1, 3}, {5, 6, 1}, {1, 6, 2}, {6, 7, 2}, {7, 0, 2}, {7, 4, 0}}};
  const MergedMesh merged = merged_soundly(mesh, 1);
  EXPECT_GT(merged.faces.size(), 1U);
  EXPECT_LT(merged.faces.size(), 10U);
  for (const MergedFace& face : merged.faces) EXPECT_LE(face.off_plane, 1);
  const MergedMesh whole = merged_soundly(mesh, 2);
  ASSERT_EQ(whole.faces.size(), 1U);
  EXPECT_EQ(whole.faces[0].off_plane, 0.9 + 0.9);  // the peak over the rim
}

// A steep square with a plateau that leans the other way: all look up, but not all to the square's side.
TEST(Merge, DoesNotMergeWhatFoldsAlongTheDroppedAxis) {
  const Mesh mesh{
      {{0.2, 0.2, 0.63},
       {0.8, 0.2, 0.57},
       {0.8, 0.8, 0.57},
       {0.2, 0.8, 0.63},
       {0, 0, 0},
       {1, 0, 1.2},
       {1, 1, 1.2},
       {0, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 0}, {5, 1, 0}, {5, 6, 1}, {6, 2, 1}, {6, 7, 2}, {7, 3, 2}, {7, 4, 3}, {4, 0, 3}}};
  const MergedMesh merged = merged_soundly(mesh, 2);
  EXPECT_GT(merged.splits, 0U);
  EXPECT_GT(merged.faces.size(), 1U);
}

/// A quad, a triangle, one without area, a bow-tie, one of two corners, one of a vertex that there is not, one of a
/// vertex that is not finite, and a triangle.
Mesh with_bad_faces() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 0, 0}, {kNan, 0, 0}, {4, 3, 0}},
          {{0, 1, 2, 3}, {0, 1, 2}, {0, 4, 1}, {0, 6, 1, 3}, {0, 1}, {0, 1, 9}, {0, 5, 1}, {0, 2, 3}}};
}

TEST(SceneFaces, LeaveOutEveryFaceThatIsBadAndNameIt) {
  const Mesh mesh = with_bad_faces();
  const auto door = mesh::scene_faces(mesh, mesh::OnBadFace::LeaveOut);
  EXPECT_EQ(door.numbers, (Numbers{1, 7, 0})) << "triangles come first";
  ASSERT_EQ(door.faces.triangles.size(), 2U);
  EXPECT_EQ(door.faces.triangles[1].b, Eigen::Vector3d(4, 4, 0));
  EXPECT_EQ(door.faces.polygons.size(), 1U);
  std::vector<std::pair<std::uint32_t, RejectionCode>> left_out;
  for (const auto& [face, rejection] : door.left_out) left_out.emplace_back(face, rejection.code);
  EXPECT_EQ(left_out, (std::vector<std::pair<std::uint32_t, RejectionCode>>{{2, RejectionCode::ZeroNormal},
                                                                            {3, RejectionCode::LoopMeetsItself},
                                                                            {4, RejectionCode::TooFewVertices},
                                                                            {5, RejectionCode::MalformedCase},
                                                                            {6, RejectionCode::NotFinite}}));
}

TEST(SceneFaces, TakeFacesWhoseCornersLieOnALineAsSegments) {
  const Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {1, 0, 0}, {0, 4, 0}},
                  {{0, 1, 2}, {0, 3, 1}, {3, 4, 1, 0, 3}, {2, 2, 2}, {4, 4, 0, 0}, {2, 2, 2, 2}, {0, 1, 2, 5}}};
  const auto taken = mesh::scene_faces(mesh, mesh::OnBadFace::AsSegments);
  EXPECT_EQ(taken.numbers, (Numbers{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(taken.left_out.empty());
  std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>> segments;
  for (const auto& [face, corners] : taken.segments) {
    segments.emplace_back(face, corners);
    const auto& loop = mesh.faces[face];
    EXPECT_EQ(taken.faces.triangles[face].a, mesh.vertices[loop[corners[0]]]);
    EXPECT_EQ(taken.faces.triangles[face].b, mesh.vertices[loop[corners[1]]]);
    EXPECT_EQ(taken.faces.triangles[face].c, mesh.vertices[loop[corners[2]]]);
  }
  EXPECT_EQ(segments, (std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>>{
                          {1, {0, 1, 2}}, {2, {2, 3, 3}}, {3, {0, 1, 2}}, {4, {0, 2, 2}}, {5, {0, 0, 0}}}));
  scene::Scene built;
  built.add("mesh", taken.faces);
  EXPECT_EQ(built.touched(Ball{{1, -1, 0}, 1}).size(), 5U);
}

// Crossing loops with a normal of 0, too few corners, vertices that there are not or that are not finite.
TEST(SceneFaces, RefuseOtherBadFacesWhereTheyTakeSegments) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {kNan, 0, 0}};
  for (const std::vector<std::uint32_t>& face :
       {std::vector<std::uint32_t>{0, 1, 2, 3}, {0, 1, 1, 2}, {0, 1}, {}, {0, 0, 9}, {0, 4, 0}})
    EXPECT_THROW((void)mesh::scene_faces({vertices, {face}}, mesh::OnBadFace::AsSegments), Rejected);
}

TEST(SceneFaces, LeaveOutOtherBadFacesWhereTheyTakeSegmentsIfAsked) {
  const Mesh mesh = with_bad_faces();
  const auto taken = mesh::scene_faces(mesh, mesh::OnBadFace::AsSegmentsOrLeaveOut);
  EXPECT_EQ(taken.numbers, (Numbers{1, 2, 7, 0}));
  ASSERT_EQ(taken.segments.size(), 1U);
  EXPECT_EQ(taken.segments[0].face, 2U);
  std::vector<std::uint32_t> left_out;
  for (const auto& [face, rejection] : taken.left_out) left_out.push_back(face);
  EXPECT_EQ(left_out, (Numbers{3, 4, 5, 6}));
  EXPECT_EQ(taken.faces.degenerate, Degenerate::AsSegments);
}

TEST(SceneFaces, AreRefusedForTheFirstBadFaceUnlessTheyAreLeftOut) {
  Mesh mesh = with_bad_faces();
  std::uint32_t first = 2;
  for (; mesh.faces.size() > 3; mesh.faces.erase(mesh.faces.begin() + 2), ++first) {
    try {
      (void)mesh::scene_faces(mesh);
      ADD_FAILURE() << first;
    } catch (const Rejected& rejected) {
      EXPECT_TRUE(std::string(rejected.what()).starts_with("face 2 of the mesh: ")) << rejected.what();
      EXPECT_THROW((void)mesh::face_polygon(mesh, 2), Rejected) << first;
    }
  }
  EXPECT_EQ(mesh::scene_faces(mesh).numbers, (Numbers{1, 2, 0})) << "no face uses the vertex that is not finite";
}

TEST(Weld, DropsVerticesThatAreNotFiniteIfNoFaceUsesThem) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Mesh welded =
      mesh::weld({{{kNan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {kInfinity, 0, 0}, {0, 1, 0}, {1, 0, 0}, {7, 7, 7}},
                  {{1, 2, 4}, {1, 5, 4}}});
  EXPECT_EQ(welded.vertices.size(), 4U);
  EXPECT_EQ(welded.faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_THROW((void)mesh::weld({{{kNan, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}), std::invalid_argument);
  const MergedMesh merged =
      merge_faces({{{kNan, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 2, 3}, {1, 3, 4}}});
  ASSERT_EQ(merged.faces.size(), 1U);
  EXPECT_EQ(merged.faces[0].faces, (Numbers{0, 1}));
}

TEST(SceneFaces, NumberTheMergedFacesAsTheSceneDoes) {
  const Mesh mesh = grid(3, 3, [](int i, int j) { return i != 1 || j != 1; });
  Mesh with_triangle = mesh;
  with_triangle.vertices.insert(with_triangle.vertices.end(), {{9, 9, 9}, {10, 9, 9}, {9, 10, 9}});
  const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
  with_triangle.faces.push_back({n, n + 1, n + 2});
  const MergedMesh merged = merge_faces(with_triangle);
  const auto both = mesh::scene_faces(with_triangle, merged);
  EXPECT_EQ(both.faces.triangles.size(), 1U);
  EXPECT_EQ(both.faces.polygons.size(), 1U);
  EXPECT_EQ(both.merged, (Numbers{1, 0}));
  const auto apart = mesh::scene_faces(with_triangle, merged, 17);
  EXPECT_EQ(apart.faces.triangles.size(), 17U);
  EXPECT_EQ(apart.faces.polygons.size(), 0U);
  EXPECT_EQ(apart.merged.size(), 17U);
  EXPECT_EQ(apart.merged.back(), 1U);
}

}  // namespace
}  // namespace touchstone::mesh_tests
