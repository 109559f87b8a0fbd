// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "experiments/studies/scenes/balls.h"
#include "geometry/shapes/ball.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {
namespace {

// Half the balls lie near a face; a fair share touches something and a fair share does not.
TEST(RandomBalls, TouchAndMiss) {
  const std::vector<scene::Faces> objects{{{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 0, 9}, {8, 0, 9}, {0, 8, 9}}}, {}}};
  scene::Scene scene;
  scene.add("two", objects.front());
  const RandomBalls random(objects);
  int touching[2] = {0, 0};
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Ball ball = cases::ball_of(random.draw(1, i).question);
    EXPECT_FALSE(find_fault(ball));
    touching[i % 2] += scene.touches(ball) ? 1 : 0;
  }
  EXPECT_GT(touching[0], 80);
  EXPECT_LT(touching[0], 195);
  EXPECT_GT(touching[1], 5);
  EXPECT_LT(touching[1], 150);
}

// Spans of coordinates, and what is added to them, overflow.
TEST(RandomBalls, AreFiniteWhereTheScenesExtentIsNot) {
  const double far = 1.7e308, most = std::numeric_limits<double>::max();
  for (const double x : {far, most}) {
    const RandomBalls random({{{{{-x, -x, 0}, {x, -x, 0}, {x, x, 1}}}, {}}});
    for (std::uint64_t i = 0; i < 2000; ++i) EXPECT_FALSE(find_fault(cases::ball_of(random.draw(1, i).question))) << i;
  }
}

}  // namespace
}  // namespace touchstone::scenes
