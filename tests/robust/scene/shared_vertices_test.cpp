// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/scene/detail/shared_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

namespace touchstone::scene_tests {
namespace {

using namespace scene::detail;

/// A closed mesh like a torus: `across` x `across` squares, of two triangles each. No two points are the same.
std::vector<Triangle> torus(std::size_t across) {
  std::vector<Triangle> result;
  const auto point = [across](std::size_t i, std::size_t j) {
    const auto x = static_cast<double>(i % across), y = static_cast<double>(j % across);
    return Eigen::Vector3d(x / 3, y / 7, x * y / 11);
  };
  for (std::size_t i = 0; i < across; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      result.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
      result.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  return result;
}

/// Triangles above each other, of which no two share a vertex.
std::vector<Triangle> soup(std::size_t count) {
  std::vector<Triangle> result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto z = static_cast<double>(i);
    result.push_back({{0, 1, z}, {1, 0, z}, {1, 1, z}});
  }
  return result;
}

std::vector<std::uint32_t> in_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

bool have_equal_bits(const Triangle& a, const Triangle& b) { return std::memcmp(&a, &b, sizeof(Triangle)) == 0; }

double memory_each(const std::vector<Triangle>& triangles) {
  const TrianglesOfSharedVertices shared(triangles, in_order(triangles.size()));
  return static_cast<double>(shared.memory()) / static_cast<double>(triangles.size());
}

// More than two parts, so that triangles of different parts share vertices, and the last part is not full.
TEST(SharedVertices, EachPlaceHasTheBitsOfItsTriangle) {
  for (const auto& triangles : {torus(100), soup(20'000), soup(1), std::vector<Triangle>()}) {
    std::vector<std::uint32_t> order = in_order(triangles.size());
    std::reverse(order.begin(), order.end());
    const TrianglesOfSharedVertices shared(triangles, order);
    ASSERT_EQ(shared.size(), triangles.size());
    for (std::size_t place = 0; place < order.size(); ++place)
      ASSERT_TRUE(have_equal_bits(shared[place].copy(), triangles[order[place]])) << "place " << place;
  }
}

TEST(SharedVertices, ZerosKeepTheirSigns) {
  const std::vector<Triangle> triangles{{{0.0, 0.0, 0.0}, {1, 0.0, 0}, {0, 1, 0.0}},
                                        {{-0.0, 0.0, 0.0}, {1, -0.0, 0}, {0, 1, -0.0}}};
  const TrianglesOfSharedVertices shared(triangles, in_order(2));
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(have_equal_bits(shared[i].copy(), triangles[i])) << i;
}

TEST(SharedVertices, AVertexIsStoredOnce) {
  const std::vector<Triangle> two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  const TrianglesOfSharedVertices shared(two, in_order(2));
  EXPECT_EQ(&shared[0].b, &shared[1].a);
  EXPECT_EQ(&shared[0].c, &shared[1].c);
  EXPECT_NE(&shared[0].a, &shared[1].b);
}

TEST(SharedVertices, TakeTheMemoryThatIsPromised) {
  EXPECT_LE(memory_each(torus(200)), 21);
  EXPECT_LE(memory_each(soup(50'000)), 79);
}

}  // namespace
}  // namespace touchstone::scene_tests
