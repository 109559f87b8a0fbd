// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/mesh/merge.h on random meshes, against the faces themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/exact/exact.h"
#include "robust/mesh/merge.h"
#include "tests/robust/mesh/merged.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/random_meshes.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::mesh_tests {
namespace {

using mesh::EdgeCounts;
using mesh::merge_faces;
using mesh::MergedFace;
using mesh::MergedMesh;

Polygon face_of(const Mesh& mesh, std::uint32_t face) {
  Loop loop;
  for (const std::uint32_t vertex : mesh.faces[face]) loop.push_back(mesh.vertices[vertex]);
  return Polygon(loop);
}

// What the generators of meshes must not miss.
TEST(RandomMeshes, HaveNegativeZeros) {
  contact_tests::NegativeZeros seen;
  for_each_random_mesh(50, [&](const Mesh& mesh, std::uint64_t index, const std::string&) {
    for (const auto& face : mesh.faces)
      seen.look_at(Triangle{mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]});
    for (const Ball& ball : balls_near(mesh, {0}, index)) seen.look_at(ball);
  });
  EXPECT_TRUE(seen.center);
  EXPECT_TRUE(seen.radius);
  EXPECT_TRUE(seen.vertex);
}

// Else the properties below would say nothing.
TEST(Merge, MeetsEverythingInRandomMeshes) {
  std::size_t splits = 0, holes = 0, large = 0, rejected = 0;
  EdgeCounts edges;
  for_each_random_mesh(100, [&](const Mesh& mesh, std::uint64_t, const std::string&) {
    const MergedMesh merged = merge_faces(mesh);
    splits += merged.splits;
    rejected += merged.rejected.size();
    edges.non_manifold += merged.edges.non_manifold;
    edges.inconsistent += merged.edges.inconsistent;
    edges.folded += merged.edges.folded;
    edges.kept_apart += merged.edges.kept_apart;
    for (const MergedFace& face : merged.faces) {
      holes += face.polygon.loop_count() - 1;
      large += face.faces.size() > 20 ? 1 : 0;
    }
  });
  EXPECT_GT(splits, 3U);
  EXPECT_GT(holes, 10U);
  EXPECT_GT(large, 10U);
  EXPECT_GT(rejected, 10U);
  EXPECT_GT(edges.non_manifold, 10U);
  EXPECT_GT(edges.inconsistent, 10U);
  EXPECT_GT(edges.folded, 10U);
  EXPECT_GT(edges.kept_apart, 10U);
}

// Guarantees (1) and (2): a polygon is touched exactly where one of its faces is, and as far away as the nearest.
TEST(Merge, IsTheUnionOfItsFaces) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES / 2, [](const Mesh& mesh, std::uint64_t index, const std::string& what) {
    const MergedMesh merged = merge_faces(mesh);
    expect_sound(mesh, merged, what);
    for (const MergedFace& face : merged.faces) {
      EXPECT_EQ(face.off_plane, 0) << what;
      if (face.faces.size() == 1) continue;
      const exact::PreparedPolygon polygon(face.polygon);
      std::vector<exact::PreparedPolygon> parts;
      for (const std::uint32_t part : face.faces) parts.emplace_back(face_of(mesh, part));
      for (const Ball& ball : balls_near(mesh, face.faces, index)) {
        std::size_t nearest = 0;
        bool touched = false;
        for (std::size_t i = 0; i < parts.size(); ++i) {
          touched = touched || exact::contact(ball, parts[i]);
          if (exact::compare_distances(ball, parts[i], parts[nearest]) < 0) nearest = i;
        }
        EXPECT_EQ(exact::contact(ball, polygon), touched) << what;
        EXPECT_EQ(exact::compare_distances(ball, polygon, parts[nearest]), 0) << what;
      }
    }
  });
}

// Guarantee (2): as the faces are oriented.
TEST(Merge, LooksToTheSideToWhichItsFacesLook) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES, [](const Mesh& mesh, std::uint64_t index, const std::string& what) {
    for (const MergedFace& face : merge_faces(mesh).faces)
      for (const Ball& ball : balls_near(mesh, face.faces, index)) {
        const Ball point{ball.center, 0};
        EXPECT_EQ(exact::plane_side(point, face.polygon), exact::plane_side(point, face_of(mesh, face.faces[0])))
            << what;
      }
  });
}

/// How many of the mesh's vertices lie on an edge of the polygon and are not its ends.
std::size_t vertices_within_edges(const Mesh& mesh, const Polygon& polygon) {
  const exact::PreparedPolygon prepared(polygon);
  // At a vertex two edges meet.
  return static_cast<std::size_t>(std::ranges::count_if(mesh.vertices, [&](const Eigen::Vector3d& vertex) {
    return exact::edges_hit({vertex, 0}, prepared).size() == 1;
  }));
}

// Guarantee (4). Faces of the meshes do not have it.
TEST(Merge, HasEveryVertexOnItsEdges) {
  constexpr std::uint64_t kMeshes = 50;  // fewer have no vertex on an edge of a hole
  std::size_t in_faces = 0, in_holes = 0;
  for_each_random_mesh(kMeshes, [&](const Mesh& mesh, std::uint64_t, const std::string& what) {
    const MergedMesh merged = merge_faces(mesh);
    for (const MergedFace& face : merged.faces) {
      EXPECT_EQ(vertices_within_edges(mesh, face.polygon), 0U) << what;
      std::size_t within = 0;
      for (const std::uint32_t part : face.faces) within += vertices_within_edges(mesh, face_of(mesh, part));
      (face.polygon.loop_count() > 1 ? in_holes : in_faces) += within;
    }
  });
  EXPECT_GT(in_faces, 100U);
  EXPECT_GT(in_holes, 10U);
}

// As large as they can be: faces on either side of a shared edge in one plane are together where nothing was cut.
TEST(Merge, KeepsNothingApartThatNeedNotBe) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES, [](const Mesh& mesh, std::uint64_t, const std::string& what) {
    const MergedMesh merged = merge_faces(mesh);
    EXPECT_TRUE(merged.splits > 0 || merged.edges.kept_apart == 0) << what;
  });
}

TEST(Merge, DoesNotDependOnWhichVerticesAreWelded) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES / 4, [](const Mesh& mesh, std::uint64_t, const std::string& what) {
    const MergedMesh merged = merge_faces(mesh), again = merge_faces(unwelded(mesh));
    EXPECT_EQ(merged.edges, again.edges) << what;
  });
}

// Guarantee (3), on meshes whose vertices are off their planes by roundings.
TEST(Merge, StaysWithinItsTolerance) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES / 2, [](const Mesh& planar, std::uint64_t index, const std::string& what) {
    const double tolerance = 1e-3;
    const Mesh mesh = shaken(planar, 2e-3, index);
    const MergedMesh merged = merge_faces(mesh, tolerance);
    expect_sound(mesh, merged, what);
    for (const MergedFace& face : merged.faces) {
      EXPECT_LE(face.off_plane, tolerance) << what;
      const exact::PreparedPolygon polygon(face.polygon);
      for (const Ball& ball : balls_near(mesh, face.faces, index)) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::uint32_t part : face.faces)
          nearest = std::min(nearest, exact::answer(ball, face_of(mesh, part)).distance);
        EXPECT_LE(std::abs(exact::answer(ball, polygon).distance - nearest), face.off_plane + 1e-15) << what;
      }
    }
  });
}

// Guarantee (5).
TEST(Merge, GivesTheSameInEveryFloatingPointEnvironmentAndLeavesItAsFound) {
  for_each_random_mesh(TOUCHSTONE_SAMPLES / 20, [](const Mesh& mesh, std::uint64_t, const std::string& what) {
    const MergedMesh expected = merge_faces(mesh, 1e-4);
    for (const contact_tests::State& state : contact_tests::kStates) {
      const contact_tests::Environment changed(state);
      const MergedMesh merged = merge_faces(mesh, 1e-4);
      const bool left_as_found = changed.left_as_found();
      EXPECT_TRUE(left_as_found) << what << ", " << state;
      EXPECT_EQ(groups(merged), groups(expected)) << what << ", " << state;
    }
  });
}

}  // namespace
}  // namespace touchstone::mesh_tests
