// SPDX-License-Identifier: GPL-3.0-or-later
// What the generators of scenes must not miss.
#include "tests/robust/scene/adversarial_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robust/support/signed_zeros.h"

namespace touchstone::scene_tests {
namespace {

TEST(AdversarialScenes, HaveNegativeZeros) {
  contact_tests::NegativeZeros seen;
  bool turned = false, moved = false;
  for (const Kind kind : all_kinds()) {
    const auto objects = draw_objects(kind, 2026, 0);
    for (const scene::Faces& faces : objects)
      for (const Triangle& triangle : faces.triangles) seen.look_at(triangle);
    for (std::uint64_t index = 0; index < 50; ++index) {
      seen.look_at(draw_ball(objects, 2026, index));
      const Pose pose = draw_pose(objects, 2026, index);
      turned = turned || (pose.rotation.array() == 0 && pose.rotation.array().unaryExpr([](double x) {
                           return std::signbit(x);
                         })).any();
      moved = moved || (pose.translation.z() == 0 && std::signbit(pose.translation.z()));
    }
  }
  EXPECT_TRUE(seen.center);
  EXPECT_TRUE(seen.radius);
  EXPECT_TRUE(seen.vertex);
  EXPECT_TRUE(turned);
  EXPECT_TRUE(moved);
}

}  // namespace
}  // namespace touchstone::scene_tests
