// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/corpus/corpus.h"
#include "geometry/shapes/rejection.h"
#include "robust/scene/posing.h"

namespace touchstone::corpus {
namespace {

using Eigen::Vector3d;
using workloads::Random;

Vector3d integer_point(Random& random, std::int64_t most) {
  const std::int64_t x = random.integer(-most, most), y = random.integer(-most, most), z = random.integer(-most, most);
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/// The prism of height 2 over a loop in z = 0 that runs counter-clockwise.
Mesh prism(const std::vector<std::array<double, 2>>& outline) {
  const auto count = static_cast<std::uint32_t>(outline.size());
  Mesh mesh;
  for (const double z : {0.0, 2.0})
    for (const auto& [x, y] : outline) mesh.vertices.emplace_back(x, y, z);
  auto& bottom = mesh.faces.emplace_back();
  for (std::uint32_t i = count; i-- > 0;) bottom.push_back(i);
  auto& top = mesh.faces.emplace_back();
  for (std::uint32_t i = 0; i < count; ++i) top.push_back(count + i);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.faces.push_back({i, next, count + next, count + i});
  }
  return mesh;
}

/// Squares of side 1, each of two triangles, at heights up to `highest`.
Mesh grid(Random& random, std::int64_t highest) {
  constexpr std::uint32_t kSide = 4;
  Mesh mesh;
  for (std::uint32_t y = 0; y < kSide; ++y)
    for (std::uint32_t x = 0; x < kSide; ++x)
      mesh.vertices.emplace_back(x, y, static_cast<double>(random.integer(0, highest)));
  for (std::uint32_t y = 0; y + 1 < kSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t corner = y * kSide + x;
      mesh.faces.push_back({corner, corner + 1, corner + kSide + 1});
      mesh.faces.push_back({corner, corner + kSide + 1, corner + kSide});
    }
  return mesh;
}

/// Cuts every face, which is convex, into the triangles at its first corner.
Mesh fans(const Mesh& mesh) {
  Mesh cut{mesh.vertices, {}};
  for (const auto& face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i) cut.faces.push_back({face[0], face[i], face[i + 1]});
  return cut;
}

constexpr std::array<std::string_view, 5> kKinds{"squares", "triangles", "prism", "terrain", "flat"};

Mesh draw_mesh(Random& random, std::size_t kind) {
  const auto side = static_cast<double>(random.integer(1, 3));
  const std::vector<std::array<double, 2>> square{{0, 0}, {side, 0}, {side, side}, {0, side}};
  switch (kind) {
    case 0: return prism(square);
    case 1: return fans(prism(square));
    case 2: return prism({{0, 0}, {3, 0}, {3, side / 2}, {1, side / 2}, {1, 3}, {0, 3}});
    case 3: return grid(random, 2);
    default: return grid(random, 0);
  }
}

/// A rotation by whole numbers over 1, 3 or 7, rounded, and a translation.
Pose draw_pose(Random& random) {
  Pose pose;
  const std::int64_t frame = random.integer(0, 2);
  if (frame == 1) pose.rotation << 1, 2, -2, 2, 1, 2, 2, -2, -1;
  if (frame == 2) pose.rotation << 2, 3, 6, 3, -6, 2, 6, 2, -3;
  pose.rotation /= pose.rotation.row(0).norm();
  const auto tenths = static_cast<double>(random.integer(1, 9));
  pose.translation = integer_point(random, 40) * (tenths / 10);
  return pose;
}

/// A vertex of a face, the middle of an edge, or a point in the face.
Vector3d draw_place(Random& random, const Polygon& face) {
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(face.vertex_count()) - 1));
  Vector3d vertex = face.vertex(i);
  const Vector3d next = face.vertex(face.next(i)), before = face.vertex(face.previous(i));
  switch (random.integer(0, 2)) {
    case 0: return vertex;
    case 1: return (vertex + next) / 2;
    default: return vertex / 2 + next / 4 + before / 4;
  }
}

}  // namespace

std::optional<CorpusCase> draw_mesh_case(std::uint64_t seed, std::uint64_t index, bool moves) try {
  Random random(seed, index, moves ? 'W' : 'M');
  const std::size_t kind = index % kKinds.size();
  Mesh mesh = draw_mesh(random, kind);
  const cases::PosedMesh posed(std::move(mesh), random.coin() ? draw_pose(random) : Pose());
  const auto face = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(posed.faces().size()) - 1));
  const Vector3d place = draw_place(random, posed.faces()[face]);
  const Vector3d away = integer_point(random, 3) / 2;
  const Vector3d center = place + away;
  const double distance = *exact_answer(cases::MeshShapes{Ball{center, 0}, posed}).distance;
  if (distance == 0) return std::nullopt;  // rounded: only where the centre is on the mesh, or next to it
  const auto beside = random.integer(-1, 1);
  const double radius = workloads::move_by_doubles(distance, beside);
  cases::Question question = Ball{center, radius};
  if (moves) {
    const Vector3d along = integer_point(random, 3);
    // Across the centre, where it grazes, or down to the mesh with a smaller ball.
    question = random.coin() ? Motion({center - along, radius}, center + along) : Motion({center, radius / 2}, place);
  }
  return CorpusCase{fmt::format("mesh-{}-{}", moves ? "moving" : "rest", index),
                    cases::MeshShapes{std::move(question), posed},
                    {std::string(kKinds[kind])},
                    "touchstone corpus make"};
} catch (const Rejected&) {
  return std::nullopt;  // rounding to the pose made a face invalid
}

}  // namespace touchstone::corpus
