// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that cover faces: nothing is left bare, and nothing reaches further than is said.
#include "experiments/thesis/cell/simulation/ball_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/model/solid_faces.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell_simulation_tests {
namespace {

using cell::BallCover;
using workloads::Random;

scene::Faces faces_of_part(const std::string& name) {
  static const auto parts = cell::build_model(cell::read_cell(kAristo));
  const auto part = std::ranges::find(parts, name, &cell::ModelPart::name);
  return cell::scene_faces(part->faces).faces;
}

/// A point of a random triangle of vertices of the face, which lies in the face where that is convex.
Eigen::Vector3d point_of(const Polygon& face, Random& random) {
  const auto n = face.vertex_count();
  const auto vertex = [&](std::size_t i) { return face.vertex(i % n); };
  const auto first = below(random, n);
  const double u = random.unit(), v = random.unit() * (1 - u);
  return (1 - u - v) * vertex(first) + u * vertex(first + 1) + v * vertex(first + 1 + below(random, n));
}

TEST(BallCover, EveryPointOfAFaceIsInABall) {
  scene::Faces faces;
  for (const char* name : {"Axis3/elbow", "Axis1/motor"}) {
    const scene::Faces more = faces_of_part(name);
    faces.polygons.insert(faces.polygons.end(), more.polygons.begin(), more.polygons.end());
    faces.triangles.insert(faces.triangles.end(), more.triangles.begin(), more.triangles.end());
  }
  const std::vector<Ball> balls = BallCover(faces, 15).smallest();
  for (std::uint64_t n = 0; n < 20 * TOUCHSTONE_SAMPLES; ++n) {
    Random random(11, n);
    const Polygon& face = faces.polygons[below(random, faces.polygons.size())];
    const Eigen::Vector3d point = point_of(face, random);
    if (scene::Scene scene; scene.add("face", {{}, {face}}) == 0 && scene.nearest({point, 0})->distance > 1e-9)
      continue;
    EXPECT_TRUE(std::ranges::any_of(
        balls, [&](const Ball& ball) { return (ball.center - point).norm() <= ball.radius + 1e-9; }))
        << "sample " << n << " at " << point.transpose();
  }
}

// Parts of kilometres, or an overhang of nothing, would take all memory.
TEST(BallCover, MoreThanAMillionBallsAreRefused) {
  const scene::Faces faces = faces_of_part("gripper/Gripper1");
  EXPECT_THROW(BallCover(faces, 1e-3), std::length_error);
  EXPECT_THROW(BallCover(faces, 1e-300), std::length_error);
  try {
    (void)cell::cover_arm(cell::build_model(cell::read_cell(kAristo)), 1e-3);
    FAIL();
  } catch (const std::length_error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("the part Base/", 0), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("; --cover-margin allows larger ones"), std::string::npos) << error.what();
  }
}

TEST(BallCover, NoBallReachesFurtherThanTheOverhang) {
  const scene::Faces faces = faces_of_part("gripper/Gripper1");
  scene::Scene scene;
  scene.add("faces", faces);
  for (const double allowed : {3.0, 8.0, 20.0}) {
    const BallCover cover(faces, allowed);
    EXPECT_LE(cover.overhang(), allowed);
    EXPECT_GT(cover.overhang(), allowed / 4) << "smaller than it need be";
    const std::vector<Ball> balls = cover.smallest();
    double furthest = 0;
    for (std::uint64_t n = 0; n < 20 * TOUCHSTONE_SAMPLES; ++n) {
      Random random(12, n);
      const Ball& ball = balls[below(random, balls.size())];
      const Eigen::Vector3d direction{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
      const Eigen::Vector3d point = ball.center + ball.radius * direction.normalized();
      furthest = std::max(furthest, scene.nearest({point, 0})->distance);
    }
    EXPECT_LE(furthest, cover.overhang() + 1e-9);
  }
}

// A cover that is asked from its largest ball down says no only where nothing of the faces is there.
TEST(BallCover, WhatTouchesTheFacesIsNeverPassedOver) {
  const scene::Faces faces = faces_of_part("Axis2/fork");
  const BallCover cover(faces, 10);
  scene::Scene scene;
  scene.add("faces", faces);
  int touching = 0, near = 0;
  for (std::uint64_t n = 0; n < 5 * TOUCHSTONE_SAMPLES; ++n) {
    Random random(13, n);
    const Ball obstacle{{between(random, -80, 80), between(random, -130, 130), between(random, -80, 380)},
                        between(random, 0, 20)};
    Pose pose;
    const double angle = between(random, 0, 6.28);
    pose.rotation << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle);
    pose.translation = {between(random, -500, 500), 20, 300};
    const Eigen::Vector3d there = pose.rotation * obstacle.center + pose.translation;
    const bool said = cover.any(
        pose, [&](const Ball& ball) { return (ball.center - there).norm() <= ball.radius + obstacle.radius; });
    const double distance = scene.nearest({obstacle.center, 0})->distance;
    if (distance <= obstacle.radius) {
      ++touching;
      EXPECT_TRUE(said) << n;
    } else if (said) {
      ++near;
      EXPECT_LE(distance, obstacle.radius + cover.overhang() + 1e-6) << n;
    }
  }
  EXPECT_GT(touching, TOUCHSTONE_SAMPLES / 10);
  EXPECT_GT(near, TOUCHSTONE_SAMPLES / 20);
}

TEST(BallCover, OfNothingIsEmpty) {
  const BallCover cover({}, 1);
  EXPECT_TRUE(cover.smallest().empty());
  EXPECT_FALSE(cover.any({}, [](const Ball&) { return true; }));
}

}  // namespace
}  // namespace touchstone::cell_simulation_tests
