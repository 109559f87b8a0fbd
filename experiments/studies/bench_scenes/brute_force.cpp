// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/brute_force.h"

#include <algorithm>
#include <limits>

#include "experiments/methods/ericson.h"
#include "geometry/bvh/box.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::bench_scenes {
namespace {

Polygon polygon(const Triangle& t) { return Polygon({t.a, t.b, t.c}); }

/// The largest of the distances along the axes, rounded by 2^-53 at most: the triangle is not nearer.
double axis_distance(const Triangle& t, const Eigen::Vector3d& center) {
  const Box around = box(t);
  return std::max(0.0, (around.low - center).cwiseMax(center - around.high).maxCoeff());
}

}  // namespace

std::vector<std::uint32_t> touched_by_brute_force(std::span<const Triangle> triangles, const Ball& ball) {
  constexpr std::size_t kAskAll = 2000;
  std::vector<std::uint32_t> touched;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (triangles.size() > kAskAll && axis_distance(t, ball.center) > 1.5 * ball.radius) continue;
    if (exact::contact(ball, polygon(t))) touched.push_back(i);
  }
  return touched;
}

std::optional<double> first_contact_by_brute_force(std::span<const Triangle> triangles, const Motion& motion) {
  const Eigen::Array3d low = motion.ball.center.cwiseMin(motion.to).array() - 1.5 * motion.ball.radius,
                       high = motion.ball.center.cwiseMax(motion.to).array() + 1.5 * motion.ball.radius;
  std::optional<double> first;
  for (const Triangle& t : triangles) {
    const Box around = box(t);
    if ((around.low.array() > high).any() || (around.high.array() < low).any()) continue;
    const FirstContact contact = exact::first_contact(motion, polygon(t));
    if (contact.contact() && (!first || contact.time < *first)) first = contact.time;
  }
  return first;
}

double least_distance_by_brute_force(std::span<const Triangle> triangles, const Eigen::Vector3d& center) {
  const auto squared = [&](const Triangle& t) { return methods::ericson_squared_distance(center, t); };
  const auto near = std::ranges::min_element(triangles, {}, squared);
  double least = exact_distance(*near, center);
  const double enough = least * (1 + 0x1p-40);
  for (const Triangle& t : triangles)
    if (axis_distance(t, center) <= enough) least = std::min(least, exact_distance(t, center));
  return least;
}

double exact_distance(const Triangle& triangle, const Eigen::Vector3d& center) {
  return exact::answer({center, 0}, polygon(triangle)).distance;
}

}  // namespace touchstone::bench_scenes
