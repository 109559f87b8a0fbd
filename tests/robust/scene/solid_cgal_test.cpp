// SPDX-License-Identifier: GPL-3.0-or-later
// Solids against CGAL's Side_of_triangle_mesh over its kernel of exact numbers.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "robust/scene/solid.h"

namespace touchstone::scene_tests {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using workloads::Random;

/// Adds the faces of a grid of n by m squares, whose last row and column meet the first.
void add_closed_grid(Mesh& mesh, std::uint32_t n, std::uint32_t m) {
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

/// A torus about the z axis, whose coordinates use all bits.
Mesh torus() {
  constexpr std::uint32_t n = 60, m = 30;
  Mesh mesh;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m;
      const double radius = 3 + std::cos(v) + 0.2 * std::sin(5 * u);
      mesh.vertices.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
    }
  add_closed_grid(mesh, n, m);
  return mesh;
}

/// A block over a square of a lattice, with hills on a lattice, too, and a flat bottom.
Mesh hills(std::uint64_t seed) {
  constexpr std::uint32_t n = 16;
  Random random(seed, 0);
  Mesh mesh;
  const auto top = [](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  const auto bottom = [&](std::uint32_t i, std::uint32_t j) { return (n + 1) * (n + 1) + top(i, j); };
  for (const bool high : {true, false})
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        mesh.vertices.emplace_back(i, j, high ? static_cast<double>(random.integer(1, 4)) : 0);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      add(top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1));
      add(bottom(i, j), bottom(i, j + 1), bottom(i + 1, j + 1), bottom(i + 1, j));
    }
    add(bottom(i, 0), bottom(i + 1, 0), top(i + 1, 0), top(i, 0));
    add(bottom(i + 1, n), bottom(i, n), top(i, n), top(i + 1, n));
    add(bottom(0, i + 1), bottom(0, i), top(0, i), top(0, i + 1));
    add(bottom(n, i), bottom(n, i + 1), top(n, i + 1), top(n, i));
  }
  return mesh;
}

PointLocation of_cgal(CGAL::Bounded_side side) {
  return side == CGAL::ON_BOUNDED_SIDE ? PointLocation::Inside
         : side == CGAL::ON_BOUNDARY   ? PointLocation::Boundary
                                       : PointLocation::Outside;
}

/// Compares answers about points on the mesh, level with its vertices, at halves, and anywhere.
void compare(const Mesh& mesh, std::uint64_t seed) {
  SurfaceMesh surface;
  for (const Eigen::Vector3d& p : mesh.vertices) surface.add_vertex({p.x(), p.y(), p.z()});
  const auto vertex = [](std::uint32_t number) { return SurfaceMesh::Vertex_index(number); };
  for (const auto& face : mesh.faces) surface.add_face(vertex(face[0]), vertex(face[1]), vertex(face[2]));
  ASSERT_EQ(surface.number_of_faces(), mesh.faces.size());
  const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side(surface);
  const scene::Solid solid(mesh);
  int counts[3] = {0, 0, 0};
  for (std::uint64_t i = 0; i < 10 * TOUCHSTONE_SAMPLES; ++i) {
    Random random(seed, i);
    const auto drawn = [&]() -> const Eigen::Vector3d& {
      return mesh
          .vertices[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(mesh.vertices.size()) - 1))];
    };
    Eigen::Vector3d p = drawn();
    switch (random.integer(0, 3)) {
      case 0: break;
      case 1: p = {drawn().x(), drawn().y(), p.z()}; break;
      case 2: p = (p + drawn()) / 2; break;
      default: p = p + (drawn() - p) * random.unit();
    }
    const PointLocation expected = of_cgal(side({p.x(), p.y(), p.z()}));
    ++counts[static_cast<int>(expected)];
    EXPECT_EQ(solid.locate(p), expected) << "point " << i << ": " << p.transpose();
  }
  for (const int count : counts) EXPECT_GT(2 * count, TOUCHSTONE_SAMPLES) << "the points do not tell";
}

TEST(SolidAndCgal, AgreeAboutATorus) { compare(torus(), 1); }

TEST(SolidAndCgal, AgreeAboutHillsOnALattice) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) compare(hills(seed), seed);
}

}  // namespace
}  // namespace touchstone::scene_tests
