// SPDX-License-Identifier: GPL-3.0-or-later
// What the generators of meshes must not miss.
#include "tests/robust/support/random_meshes.h"

#include <gtest/gtest.h>

#include "tests/robust/support/signed_zeros.h"

namespace touchstone::mesh_tests {
namespace {

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

}  // namespace
}  // namespace touchstone::mesh_tests
