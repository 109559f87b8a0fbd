// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/ball_cover.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/bvh/box.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/lifted_box.h"

namespace touchstone::cell {
namespace {

constexpr double kMostBalls = 1e6;
constexpr double kGenerous = 1 + 1e-14;  // more than the roundings of a norm add up to

/// The ball around a box, not smaller than it by rounding.
Ball around(const Box& box) {
  const Eigen::Vector3d center = box.low + (box.high - box.low) / 2;
  return {center, (center - box.low).cwiseMax(box.high - center).norm() * kGenerous};
}

Box box_of(const scene::Faces& faces) {
  Box whole;
  for (const Triangle& triangle : faces.triangles) whole = whole.joined(box(triangle));
  for (const Polygon& polygon : faces.polygons)
    whole = whole.joined(scene::detail::lifted_box(polygon, filtered::PreparedPolygon(polygon)));
  return whole;
}

double area_of(const scene::Faces& faces) {
  double area = 0;
  for (const Triangle& triangle : faces.triangles)
    area += (triangle.b - triangle.a).cross(triangle.c - triangle.a).norm() / 2;
  for (const Polygon& polygon : faces.polygons) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
      normal += (polygon.vertex(i) - polygon.vertex(0)).cross(polygon.vertex(polygon.next(i)) - polygon.vertex(0));
    area += normal.norm() / 2;
  }
  return area;
}

std::array<Box, 2> halves(const Box& box) {
  Eigen::Index longest = 0;
  (box.high - box.low).maxCoeff(&longest);
  std::array<Box, 2> halves{box, box};
  const double middle = box.low[longest] + (box.high[longest] - box.low[longest]) / 2;
  halves[0].high[longest] = halves[1].low[longest] = middle;
  return halves;
}

}  // namespace

BallCover::BallCover(const scene::Faces& faces, double overhang) {
  const Box whole = box_of(faces);
  if (whole.empty()) return;
  if (const double balls = 3 * area_of(faces) / (overhang * overhang); !(balls <= kMostBalls))
    throw std::length_error(fmt::format("about {:.2g} balls that reach {:g} beyond it would cover it; at most {:g} may",
                                        balls, overhang, kMostBalls));
  scene::Scene scene;
  scene.add("faces", faces);
  std::vector<Box> boxes{whole};
  nodes_.push_back({around(whole), false, 0, 0});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {  // breadth first
    const Ball ball = nodes_[i].ball;
    const double reach = ball.radius <= overhang ? (scene.nearest(ball)->distance + ball.radius) * kGenerous : 0;
    if (ball.radius <= overhang && reach <= overhang) {
      nodes_[i].smallest = true;
      overhang_ = std::max(overhang_, reach);
      continue;
    }
    nodes_[i].first_child = static_cast<std::uint32_t>(nodes_.size());
    for (const Box& half : halves(boxes[i])) {
      const Ball smaller = around(half);
      if (!scene.touches(smaller)) continue;
      ++nodes_[i].children;
      nodes_.push_back({smaller, false, 0, 0});
      boxes.push_back(half);
    }
  }
}

bool BallCover::any(const Pose& pose, const std::function<bool(const Ball&)>& test) const {
  if (nodes_.empty()) return false;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    if (!test(posed_generously(pose, node.ball))) continue;
    if (node.smallest) return true;
    for (std::uint32_t i = 0; i < node.children; ++i) open.push_back(node.first_child + i);
  }
  return false;
}

bool BallCover::may_be_near(const Pose& pose, const BallCover& other, const Pose& its_pose, double distance) const {
  if (nodes_.empty() || other.nodes_.empty()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const Node &mine = nodes_[i], &its = other.nodes_[j];
    const Ball a = posed_generously(pose, mine.ball), b = posed_generously(its_pose, its.ball);
    if ((a.center - b.center).norm() > (a.radius + b.radius + distance) * kGenerous) continue;
    if (mine.smallest && its.smallest) return true;
    if (its.smallest || (!mine.smallest && mine.ball.radius > its.ball.radius)) {
      for (std::uint32_t child = 0; child < mine.children; ++child) open.emplace_back(mine.first_child + child, j);
    } else {
      for (std::uint32_t child = 0; child < its.children; ++child) open.emplace_back(i, its.first_child + child);
    }
  }
  return false;
}

std::vector<Ball> BallCover::smallest() const {
  std::vector<Ball> balls;
  for (const Node& node : nodes_)
    if (node.smallest) balls.push_back(node.ball);
  return balls;
}

Ball posed_generously(const Pose& pose, const Ball& ball) {
  // Products of rotations of an arm are off by some 1e-15 an element, so is each of nine products and sums.
  const double error = 1e-13 * (ball.center.cwiseAbs().sum() + ball.radius + pose.translation.cwiseAbs().sum());
  return {pose.rotation * ball.center + pose.translation, ball.radius + error};
}

}  // namespace touchstone::cell
