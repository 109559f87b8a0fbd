// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of solids as polygons of the contract, and what is refused, by name.
#include "experiments/thesis/cell/model/solid.h"

#include <gtest/gtest.h>

#include <string>

#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/poses.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/scene/scene.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/model/solids.h"

namespace touchstone::cell {
namespace {

using Operation = Boolean::Operation;

std::string refusal(const Solid& solid) {
  return run_tests::message_of<BadSolid>([&] { return faces_of(solid, "arm/body"); });
}

TEST(SolidFaces, AreAcceptedPolygonsWhoseOffPlaneIsThatOfTheExactAnswer) {
  // A slanted bore: its sides' vertices on the box are not doubles.
  const Solid solid = combined(Operation::Difference, {box({0, 0, 0}, {10, 7, 3}), cylinder(0, {-1, 3, 1}, 12, 0.7, 7),
                                                       cylinder(2, {5, 3, -1}, 9, 1.3, 11)});
  const SolidFaces faces = faces_of(solid, "block");
  EXPECT_EQ(faces.holes(), 4U);
  double largest = 0;
  for (const Face& face : faces.faces) {
    EXPECT_EQ(exact::validate(face.polygon), std::nullopt);
    EXPECT_EQ(face.off_plane, exact::answer({{0, 0, 0}, 1}, exact::PreparedPolygon(face.polygon)).off_plane);
    largest = std::max(largest, face.off_plane);
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 1e-14);
  EXPECT_EQ(faces.off_plane(), largest);
}

// At 1e17 doubles are 16 apart: all corners of a cylinder of radius 1 round to one point.
TEST(SolidFaces, AFaceThatRoundingSpoilsIsNamed) {
  EXPECT_EQ(refusal(cylinder(2, {1e17, 0, 0}, 1, 1, 8)),
            "arm/body: face 2: zero-normal: the outer loop: its Newell normal is zero");
}

TEST(SolidFaces, WhatHasNoInsideIsRefused) {
  EXPECT_EQ(refusal(combined(Operation::Intersection, {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})})),
            "arm/body: the solid has no inside");
}

class MeshSolid : public testing::Test {
 protected:
  [[nodiscard]] Solid mesh(const std::string& text, const char* unit) const {
    program::write_file(scratch.path / "part.obj", text);
    return {MeshFile{scratch.path / "part.obj", workloads::find_unit(unit), workloads::find_unit("mm")}};
  }
  const run_tests::Scratch scratch;
};

TEST_F(MeshSolid, IsMergedConvertedAndPosed) {
  Solid solid = mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", "inch");
  solid.pose = {quarter_turns(1, 1), {0, 0, 100}};
  const SolidFaces faces = faces_of(solid, "arm/body");
  ASSERT_EQ(faces.faces.size(), 1U);
  EXPECT_EQ(faces.merged_from, 2U);
  EXPECT_EQ(faces.volume, std::nullopt);
  // x becomes -z: the square from 100 down to 74.6.
  EXPECT_EQ(faces.faces[0].polygon, Polygon({{0, 0, 100}, {0, 0, 74.6}, {0, 25.4, 74.6}, {0, 25.4, 100}}));
}

TEST_F(MeshSolid, AFaceThatTheContractRejectsIsNamed) {
  const std::string message = refusal(mesh("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "mm"));
  EXPECT_TRUE(message.starts_with("arm/body: " + (scratch.path / "part.obj").string() + ": face 0: zero-normal: "))
      << message;
}

TEST_F(MeshSolid, IsNoPartOfABoolean) {
  const Solid solid = combined(Operation::Union, {box({0, 0, 0}, {1, 1, 1}), mesh("v 0 0 0\n", "mm")});
  EXPECT_TRUE(refusal(solid).ends_with("a mesh cannot be part of a Boolean operation")) << refusal(solid);
}

TEST(SceneFaces, TrianglesComeFirstAndKnowTheirNumbers) {
  const SolidFaces prism = faces_of(cylinder(2, {0, 0, 0}, 1, 1, 3), "prism");
  const ModelFaces faces = scene_faces(prism);
  EXPECT_EQ(faces.faces.triangles.size(), 2U);
  EXPECT_EQ(faces.faces.polygons.size(), 3U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(prism.faces[faces.numbers[i]].polygon.vertex_count(), i < 2 ? 3U : 4U);
  scene::Scene scene;
  scene.add("prism", faces.faces);
  EXPECT_TRUE(scene.touches({{0, 0, 2}, 1}));
  EXPECT_FALSE(scene.touches({{0, 0, 2.5}, 1}));
}

}  // namespace
}  // namespace touchstone::cell
