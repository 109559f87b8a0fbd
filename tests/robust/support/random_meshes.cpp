// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/random_meshes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/mesh/weld.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::mesh_tests {
namespace {

using Eigen::Vector3d;
using workloads::Random;

constexpr std::uint64_t kSeed = 2026;
constexpr std::uint64_t kSignStream = ~std::uint64_t{0}, kCutStream = kSignStream - 1;  // balls take one for each face

/// Columns of random heights, most of them 0, their tops and the walls between them; a face here and there is left out,
/// flipped, doubled, folded back or has another face without area beside it.
Mesh draw_mesh(std::uint64_t index) {
  Random random(kSeed, index);
  const auto columns = static_cast<int>(random.integer(1, 7)), rows = static_cast<int>(random.integer(1, 7));
  const std::int64_t highest = random.integer(0, 2), rare = random.integer(4, 40);
  std::vector<int> heights;
  for (int k = 0; k < columns * rows; ++k) {
    const bool raised = random.integer(0, 3) == 0;
    heights.push_back(raised ? static_cast<int>(random.integer(0, highest)) : 0);
  }
  const auto height = [&](int i, int j) {
    return i < 0 || j < 0 || i >= columns || j >= rows ? 0 : heights[static_cast<std::size_t>(j * columns + i)];
  };
  // Three integer directions, seldom orthogonal.
  Vector3d u, v, w, origin;
  for (int k = 0; k < 3; ++k) {
    const auto draw = [&random](std::int64_t most) { return static_cast<double>(random.integer(-most, most)); };
    u[k] = draw(9), v[k] = draw(9), w[k] = draw(9), origin[k] = draw(1000);
  }
  Mesh mesh;
  const auto quad = [&](std::array<std::array<int, 3>, 4> corners) {
    if (random.integer(0, rare) == 0) return;
    std::array<std::uint32_t, 4> n{};
    for (std::size_t c = 0; c < 4; ++c) {
      n[c] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.emplace_back(origin + corners[c][0] * u + corners[c][1] * v + corners[c][2] * w);
    }
    std::vector<std::vector<std::uint32_t>> faces{{n[0], n[1], n[2]}, {n[0], n[2], n[3]}};
    if (random.coin()) faces = {{n[0], n[1], n[3]}, {n[1], n[2], n[3]}};
    if (random.integer(0, 4 * rare) == 0) std::swap(faces[0][0], faces[0][1]);
    if (random.integer(0, 4 * rare) == 0) faces.push_back(faces[1]);
    if (random.integer(0, 4 * rare) == 0) faces.push_back({n[2], n[1], n[0]});
    if (random.integer(0, 4 * rare) == 0) faces.push_back({n[0], n[1], n[1]});
    mesh.faces.insert(mesh.faces.end(), faces.begin(), faces.end());
  };
  for (int i = -1; i < columns; ++i)
    for (int j = -1; j < rows; ++j) {
      const int h = height(i, j);
      if (i >= 0 && j >= 0) quad({{{i, j, h}, {i + 1, j, h}, {i + 1, j + 1, h}, {i, j + 1, h}}});
      for (int z = std::min(h, height(i + 1, j)); z < std::max(h, height(i + 1, j)); ++z)
        quad({{{i + 1, j, z}, {i + 1, j + 1, z}, {i + 1, j + 1, z + 1}, {i + 1, j, z + 1}}});
      for (int z = std::min(h, height(i, j + 1)); z < std::max(h, height(i, j + 1)); ++z)
        quad({{{i, j + 1, z}, {i + 1, j + 1, z}, {i + 1, j + 1, z + 1}, {i, j + 1, z + 1}}});
    }
  return mesh::weld(mesh);
}

/// The mesh with some faces cut in two from the middle of a side, where their neighbours lack a vertex. Halves of small
/// integers are exact.
Mesh bisected(const Mesh& mesh, std::uint64_t index) {
  Random random(kSeed, index, kCutStream);
  Mesh cut{mesh.vertices, {}};
  for (const auto& face : mesh.faces) {
    const auto k = static_cast<std::size_t>(random.integer(0, 2));
    const std::uint32_t a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
    if (a == b || random.integer(0, 2) != 0) {
      cut.faces.push_back(face);
      continue;
    }
    const auto middle = static_cast<std::uint32_t>(cut.vertices.size());
    cut.vertices.emplace_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    cut.faces.insert(cut.faces.end(), {{a, middle, c}, {middle, b, c}});
  }
  return mesh::weld(cut);
}

/// The mesh moved so that its first vertex is the origin; as it was where that would round.
Mesh from_first_vertex(Mesh mesh) {
  const Vector3d first = mesh.vertices.front();
  const bool exact = std::ranges::all_of(mesh.vertices, [&](const Vector3d& vertex) {
    for (int k = 0; k < 3; ++k)
      if (filtered::detail::two_difference(vertex[k], first[k]).low != 0) return false;  // exact
    return true;
  });
  if (exact)
    for (Vector3d& vertex : mesh.vertices) vertex -= first;
  return mesh;
}

}  // namespace

Mesh cube() {
  Mesh mesh;
  for (int k = 0; k < 8; ++k) mesh.vertices.emplace_back(k & 1, k >> 1 & 1, k >> 2);
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh grid(int columns, int rows, const std::function<bool(int, int)>& there, bool flipped) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.vertices.emplace_back(i, j, 0);
  const auto number = [columns](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if (!there(i, j)) continue;
      mesh.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      mesh.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  if (flipped)
    for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

Mesh winding(int squares) {
  const std::vector<Vector3d> arms{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  Mesh mesh{{{0, 0, 0}, arms[0]}, {}};
  for (int k = 0; k < squares; ++k) {
    const auto a = static_cast<std::size_t>(k) % 4, b = (a + 1) % 4;
    // Another turn is a little larger, so that its vertices are other ones.
    const auto size = static_cast<double>(1 + (k + 1) / 4);
    const auto from = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    mesh.vertices.emplace_back(2 * size * (arms[a] + arms[b]));
    mesh.vertices.emplace_back(size * arms[b]);
    mesh.faces.push_back({0, from, from + 1});
    mesh.faces.push_back({0, from + 1, from + 2});
  }
  return mesh;
}

Mesh unwelded(const Mesh& mesh) {
  Mesh apart;
  for (const auto& face : mesh.faces) {
    auto& corners = apart.faces.emplace_back();
    for (const std::uint32_t vertex : face) {
      corners.push_back(static_cast<std::uint32_t>(apart.vertices.size()));
      apart.vertices.push_back(mesh.vertices[vertex]);
    }
  }
  return apart;
}

Mesh shaken(Mesh mesh, double most, std::uint64_t index) {
  Random random(kSeed, index, 1);
  for (Vector3d& vertex : mesh.vertices)
    for (int k = 0; k < 3; ++k) vertex[k] += most * (2 * random.unit() - 1);
  return mesh;
}

void for_each_random_mesh(std::uint64_t count,
                          const std::function<void(const Mesh&, std::uint64_t, const std::string&)>& f) {
  for (std::uint64_t index = 0; index < count; ++index) {
    Mesh mesh = draw_mesh(index);
    if (index % 3 == 2) mesh = bisected(bisected(mesh, index), index);
    if (index % 2 == 1) mesh = from_first_vertex(std::move(mesh));
    Random random(kSeed, index, kSignStream);
    contact_tests::sign_zeros(mesh, random);
    f(mesh, index, "mesh " + std::to_string(index));
  }
}

std::vector<Ball> balls_near(const Mesh& mesh, const std::vector<std::uint32_t>& faces, std::uint64_t index) {
  Random random(kSeed, index, 2 + faces[0]);
  const auto draw = [&random](std::size_t count) {
    return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(count) - 1));
  };
  std::vector<Ball> balls;
  for (int k = 0; k < 3; ++k) {
    const auto& face = mesh.faces[faces[draw(faces.size())]];
    const Vector3d &a = mesh.vertices[face[0]], &b = mesh.vertices[face[1]], &c = mesh.vertices[face[2]];
    // At a vertex, on an edge or within the face; there, or off it.
    const auto kind = random.integer(0, 2);
    const double s = kind == 0 ? 0 : random.unit(), t = kind == 2 ? (1 - s) * random.unit() : 0;
    Vector3d center = a + s * (b - a) + t * (c - a);
    if (random.integer(0, 3) != 0)
      for (int axis = 0; axis < 3; ++axis) center[axis] += random.log_uniform(-3, 3);
    // As far as another face is, or one double from it.
    const auto& other = mesh.faces[faces[draw(faces.size())]];
    const Polygon polygon({mesh.vertices[other[0]], mesh.vertices[other[1]], mesh.vertices[other[2]]});
    const double distance = exact::answer({center, 0}, polygon).distance;
    balls.push_back({center, std::max(0.0, workloads::move_by_doubles(distance, random.integer(-1, 1)))});
    contact_tests::sign_zeros(balls.back(), random);
  }
  return balls;
}

}  // namespace touchstone::mesh_tests
