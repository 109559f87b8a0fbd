// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/scenes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/bvh/box.h"
#include "robust/exact/validate.h"

namespace touchstone::bench_scenes {
namespace {

using workloads::Random;

/// Differences of doubles lose 2^-53 at most, so that triangles that clearly do not lie on a line in doubles do not.
bool is_triangle(const Triangle& t) {
  if (t.a == t.b || t.b == t.c || t.c == t.a) return false;
  const Eigen::Vector3d ab = t.b - t.a, ac = t.c - t.a;
  constexpr double kClear = 1e-10;
  return ab.cross(ac).norm() > kClear * ab.norm() * ac.norm() || !exact::validate(Polygon({t.a, t.b, t.c}));
}

std::vector<Triangle> triangles_of(const touchstone::Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Triangle t{mesh.vertices[face[0]], mesh.vertices[face[i - 1]], mesh.vertices[face[i]]};
      if (is_triangle(t)) triangles.push_back(t);
    }
  return triangles;
}

void scale_to_one(std::vector<Triangle>& triangles) {
  const Box all = box(triangles);
  int exponent = 0;
  (void)std::frexp((all.high - all.low).maxCoeff(), &exponent);
  const double scale = std::ldexp(1.0, -exponent);
  for (Triangle& t : triangles)
    for (Eigen::Vector3d* point : {&t.a, &t.b, &t.c}) *point = scale * (*point - all.low);
}

double median_size(const std::vector<Triangle>& triangles) {
  std::vector<double> sizes;
  sizes.reserve(triangles.size());
  for (const Triangle& t : triangles) sizes.push_back(std::sqrt((t.b - t.a).cross(t.c - t.a).norm()));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

Eigen::Vector3d in_unit_cube(Random& random) {
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = random.unit();
  return point;
}

Eigen::Vector3d point_of(const Triangle& t, Random& random) {
  double u = random.unit(), v = random.unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

}  // namespace

std::vector<Triangle> torus(std::size_t triangles) {
  const auto around =
      std::max<std::size_t>(3, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 4))));
  const std::size_t along = 2 * around;
  const auto at = [&](std::size_t i, std::size_t j) {
    constexpr double kTurn = 2 * std::numbers::pi, kMajor = 3;
    const double a = kTurn * static_cast<double>(i % along) / static_cast<double>(along);
    const double b = kTurn * static_cast<double>(j % around) / static_cast<double>(around);
    const double minor = 1 + 0.05 * std::sin(17 * a) * std::cos(11 * b);
    const double reach = kMajor + minor * std::cos(b);
    return Eigen::Vector3d(reach * std::cos(a), reach * std::sin(a), minor * std::sin(b));
  };
  std::vector<Triangle> all;
  all.reserve(2 * along * around);
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const Eigen::Vector3d corner = at(i, j), opposite = at(i + 1, j + 1);
      all.push_back({corner, at(i + 1, j), opposite});
      all.push_back({corner, opposite, at(i, j + 1)});
    }
  return all;
}

Machine::Machine(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) throw std::runtime_error(folder.string() + ": is no folder");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && workloads::is_own_format(entry.path())) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files) {
    std::vector<Triangle> part = triangles_of(read_mesh(file, OnFault::Skip).mesh);
    scale_to_one(part);
    std::erase_if(part, [](const Triangle& t) { return !is_triangle(t); });
    triangle_count_ += part.size();
    parts_.push_back(std::move(part));
  }
  if (triangle_count_ == 0) throw std::runtime_error(folder.string() + ": holds no mesh (STL, OBJ, OFF or PLY)");
}

std::vector<Triangle> Machine::replicated(std::size_t triangles) const {
  const std::size_t slots = (triangles / triangle_count_ + 1) * parts_.size();
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(slots))));
  std::vector<Triangle> all;
  all.reserve(triangles);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    const std::size_t column = slot % side, row = slot / side % side, layer = slot / side / side;
    const Eigen::Vector3d shift(static_cast<double>(column), static_cast<double>(row), static_cast<double>(layer));
    for (const Triangle& t : parts_[slot % parts_.size()]) {
      if (all.size() == triangles) return all;
      const Triangle moved{t.a + shift, t.b + shift, t.c + shift};
      if (is_triangle(moved)) all.push_back(moved);
    }
  }
  return all;
}

std::string_view to_string(BallPlace place) {
  switch (place) {
    case BallPlace::Near: return "near";
    case BallPlace::Anywhere: return "anywhere";
    case BallPlace::Touching: return "touching";
  }
  return "";
}

std::vector<Ball> draw_scene_balls(BallPlace place, const std::vector<Triangle>& triangles, std::uint64_t count,
                                   std::uint64_t seed) {
  const double size = median_size(triangles);
  const Box all = box(triangles);
  const auto last = static_cast<std::int64_t>(triangles.size() - 1);
  std::vector<Ball> balls;
  balls.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random(seed, i, static_cast<std::uint64_t>(place));
    const double radius = size * (0.5 + random.unit());
    const Eigen::Vector3d free = in_unit_cube(random);
    if (place == BallPlace::Anywhere) {
      balls.push_back({all.low + free.cwiseProduct(all.high - all.low), radius});
    } else {
      const Triangle& t = triangles[static_cast<std::size_t>(random.integer(0, last))];
      balls.push_back({point_of(t, random) + 2 * radius * (2 * free - Eigen::Vector3d::Ones()), radius});
    }
  }
  return balls;
}

}  // namespace touchstone::bench_scenes
