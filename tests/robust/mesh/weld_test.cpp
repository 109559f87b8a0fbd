// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/mesh/weld.h"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::mesh_tests {
namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;

TEST(Weld, KeepsTheFirstOfEqualVerticesInTheirOrder) {
  const Mesh mesh{{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {5, 4, 3}}};
  const Mesh welded = mesh::weld(mesh);
  const std::vector<Eigen::Vector3d> expected{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(welded.vertices, expected);
  EXPECT_EQ(welded.faces, (Faces{{0, 1, 2}, {3, 0, 1}}));
}

TEST(Weld, TakesBothZerosForOne) {
  const Mesh welded = mesh::weld({{{0, 0, 1}, {-0.0, 0, 1}, {0, -0.0, 1}}, {{0, 1, 2}}});
  EXPECT_EQ(welded.vertices.size(), 1U);
  EXPECT_EQ(welded.faces, (Faces{{0, 0, 0}}));
}

TEST(Weld, KeepsNeighbouringDoublesApart) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(mesh::weld({{{1, 1, 1}, {1, 1, next}, {1, next, 1}, {next, 1, 1}, {1, 1, 1}}, {}}).vertices.size(), 4U);
}

}  // namespace
}  // namespace touchstone::mesh_tests
