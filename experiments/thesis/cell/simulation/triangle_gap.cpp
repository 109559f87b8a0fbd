// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/triangle_gap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace touchstone::cell {
namespace {

using Vertices = std::array<Eigen::Vector3d, 3>;

/// Whether the projections onto a direction, which need not be of length 1, are that far apart. A projection of three
/// products is rounded by less than 4 units in the last place of their sum, a length by less than that of its own.
bool apart_along(const Eigen::Vector3d& direction, const Vertices& first, const Vertices& second, double distance) {
  const double length = direction.norm();
  if (!(length > 0)) return false;
  double low[2], high[2], size = 0;
  const std::array both{&first, &second};
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = high[i] = direction.dot((*both[i])[0]);
    for (const Eigen::Vector3d& vertex : *both[i]) {
      const double at = direction.dot(vertex);
      low[i] = std::min(low[i], at), high[i] = std::max(high[i], at);
      size = std::max(size, vertex.cwiseAbs().maxCoeff());
    }
  }
  constexpr double kRounding = 1e-14;
  const double gap = std::max(low[1] - high[0], low[0] - high[1]);
  return gap > length * (distance * (1 + kRounding) + kRounding * size);
}

}  // namespace

bool further_apart(const Triangle& first, const Triangle& second, double distance) {
  const Vertices a{first.a, first.b, first.c}, b{second.a, second.b, second.c};
  const auto apart = [&](const Eigen::Vector3d& direction) { return apart_along(direction, a, b, distance); };
  for (int axis = 0; axis < 3; ++axis)
    if (apart(Eigen::Vector3d::Unit(axis))) return true;
  std::array<Vertices, 2> edges;
  std::array<Eigen::Vector3d, 2> normals;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vertices& v = i == 0 ? a : b;
    edges[i] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    normals[i] = edges[i][0].cross(edges[i][1]);
    if (apart(normals[i])) return true;
  }
  for (std::size_t i = 0; i < 2; ++i)
    for (const Eigen::Vector3d& edge : edges[i])
      if (apart(normals[i].cross(edge))) return true;
  for (const Eigen::Vector3d& one : edges[0])
    for (const Eigen::Vector3d& other : edges[1])
      if (apart(one.cross(other))) return true;
  return false;
}

}  // namespace touchstone::cell
