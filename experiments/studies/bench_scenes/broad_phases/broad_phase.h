// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/studies/bench_scenes/library.h"
#include "geometry/bvh/box.h"
#include "geometry/contact/fast_triangle.h"

// Structures that textbooks of collision detection name, a page each: they find candidates, and `fast::contact`
// decides. All are conservative: every triangle that the ball touches is a candidate.
namespace touchstone::bench_scenes {

/// Returns a box around the ball, rounded outwards.
[[nodiscard]] inline Box box_around(const Ball& ball) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::nextafter(ball.center[i] - ball.radius, -std::numeric_limits<double>::infinity());
    box.high[i] = std::nextafter(ball.center[i] + ball.radius, std::numeric_limits<double>::infinity());
  }
  return box;
}
[[nodiscard]] inline std::vector<Box> boxes_of(std::span<const Triangle> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box(triangle));
  return boxes;
}
[[nodiscard]] inline Box around(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all = all.joined(box);
  return all;
}

/// A scene by a structure that is built of triangles and has a member `find(ball, test)`: it applies the test to the
/// numbers of all candidates, perhaps repeatedly, until it returns true.
template <class Structure>
class BroadPhaseScene : public BuiltScene {
 public:
  explicit BroadPhaseScene(std::span<const Triangle> triangles) : triangles_(triangles), structure_(triangles) {}

  [[nodiscard]] bool any(const Ball& ball) const override {
    bool found = false;
    structure_.find(ball, [&](std::uint32_t i) { return found = fast::contact(ball, triangles_[i]); });
    return found;
  }
  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    structure_.find(ball, [&](std::uint32_t i) {
      triangles.push_back(i);
      return false;
    });
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::erase_if(triangles, [&](std::uint32_t i) { return !fast::contact(ball, triangles_[i]); });
  }

 private:
  std::span<const Triangle> triangles_;
  Structure structure_;
};

template <class Structure>
[[nodiscard]] Library broad_phase(const std::string& name) {
  return {.name = name,
          .build = [](const Mesh& mesh) -> std::unique_ptr<BuiltScene> {
            return std::make_unique<BroadPhaseScene<Structure>>(mesh.triangles);
          },
          .knows_nearest = false};
}

}  // namespace touchstone::bench_scenes
