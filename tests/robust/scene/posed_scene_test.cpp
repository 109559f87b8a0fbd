// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of objects that move, against brute force over the faces where they stand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "experiments/cases/workloads/random.h"
#include "experiments/program/statistics/shares.h"
#include "robust/scene/posing.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/printing.h"

namespace touchstone::scene_tests {
namespace {

using scene::Scene;
using workloads::Random;

/// A scene that moves from step to step, and the same without it.
class MovingScene {
 public:
  MovingScene(Kind kind, std::uint64_t index, int times)
      : kind_(kind),
        index_(index),
        models_(draw_objects(kind, 2026, index, times)),
        standing_(models_),
        faces_(models_) {
    for (std::size_t i = 0; i < models_.size(); ++i) scene_.add("object " + std::to_string(i), models_[i]);
  }

  /// Moves some objects; those with a face that the pose makes invalid stay.
  void move(std::uint64_t step) {
    for (std::uint32_t i = 0; i < models_.size(); ++i) {
      Random random(2026, 1000 * index_ + step, 66 + i);
      if (random.coin()) continue;
      const Pose before = scene_.pose(i), pose = draw_pose({models_[i]}, 2026, random.bits() >> 1);
      try {
        standing_[i] = posed(pose, models_[i]);
      } catch (const Rejected&) {
        EXPECT_THROW(scene_.set_pose(i, pose), Rejected) << *this;
        EXPECT_EQ(scene_.pose(i), before) << *this;
        continue;
      }
      scene_.set_pose(i, pose);
      ++moves_;
    }
    faces_ = BruteForce(standing_);
  }

  [[nodiscard]] Ball ball(std::uint64_t index) const { return draw_ball(faces_.polygons(), 2026 + index_, index); }
  [[nodiscard]] const BruteForce& faces() const { return faces_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] std::uint64_t moves() const { return moves_; }

  friend std::ostream& operator<<(std::ostream& out, const MovingScene& subject) {
    return out << name(subject.kind_) << ", scene " << subject.index_ << ", moves " << subject.moves_;
  }

 private:
  Kind kind_;
  std::uint64_t index_;
  std::vector<scene::Faces> models_;
  std::vector<scene::Faces> standing_;
  BruteForce faces_;
  Scene scene_;
  std::uint64_t moves_ = 0;
};

/// TOUCHSTONE_SCENE_QUERIES of the environment, which `./check --full` sets to a million.
std::uint64_t queries_asked() {
  const char* asked = std::getenv("TOUCHSTONE_SCENE_QUERIES");
  return asked == nullptr ? 100 * TOUCHSTONE_SAMPLES : std::stoull(asked);
}

// Every query is compared with contact with each face by `filtered`, a part of them also by `exact`. Balls are asked
// one by one and together.
TEST(PosedScene, NeverDiffersFromBruteForce) {
  constexpr std::uint64_t kSteps = 8, kBalls = 75;
  const std::uint64_t asked = queries_asked();
  ASSERT_TRUE(asked > 0 && asked <= 1'000'000'000) << asked;
  std::uint64_t queries = 0, differences = 0, moves = 0, touching = 0;
  for (std::uint64_t index = 0; queries < asked; ++index)
    for (const Kind kind : all_kinds()) {
      MovingScene subject(kind, index, index % 10 == 9 ? 5 : 1);
      for (std::uint64_t step = 0; step < kSteps; ++step) {
        if (step > 0) subject.move(step);
        std::vector<Ball> balls;
        std::vector<Eigen::Vector3d> centers;
        for (std::uint64_t i = 0; i < kBalls; ++i) {
          balls.push_back(subject.ball(kBalls * step + i));
          centers.push_back(balls.back().center);
        }
        const auto touched = subject.scene().touched(balls);
        const auto nearest = subject.scene().nearest_face(centers);
        for (std::uint64_t i = 0; i < kBalls; ++i, ++queries) {
          const std::uint64_t number = kBalls * step + i;
          const Ball& ball = balls[i];
          const auto expected = subject.faces().touched(ball);
          bool same = subject.scene().touched(ball) == expected && subject.scene().touches(ball) == !expected.empty();
          same = same && touched[i] == expected && nearest[i] == subject.scene().nearest_face(ball.center);
          if (number % 50 == 7) {
            same = same && subject.faces().touched_by_exact(ball) == expected;
            same = same && subject.scene().nearest(ball) == subject.faces().nearest_by_exact(ball);
          }
          differences += !same;
          touching += !expected.empty();
          EXPECT_TRUE(same) << subject << ", ball " << number;
        }
      }
      moves += subject.moves();
    }
  std::cout << queries << " queries after " << moves << " moves, " << touching << " with contact: " << differences
            << " differ, at most " << statistics::clopper_pearson(differences, queries, 0.9).upper
            << " of all such queries (95 %, one-sided)\n";
}

TEST(PosedScene, AnswersAsOneBuiltOfPosedFaces) {
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < 3; ++index) {
      const auto models = draw_objects(kind, 2026, index);
      Scene moved, posed_when_added, built;
      std::vector<scene::Faces> standing;
      for (std::uint32_t i = 0; i < models.size(); ++i) {
        Pose pose;
        scene::Faces faces = models[i];
        moved.add(std::to_string(i), models[i]);
        for (std::uint64_t step = 0; step < 4; ++step) try {
            const Pose next = draw_pose({models[i]}, 2026, 100 * index + 10 * step + i);
            scene::Faces there = posed(next, models[i]);
            moved.set_pose(i, next);
            pose = next, faces = std::move(there);
          } catch (const Rejected&) {
          }
        posed_when_added.add(std::to_string(i), models[i], pose);
        built.add(std::to_string(i), faces);
        standing.push_back(std::move(faces));
      }
      const std::vector<Polygon> all = all_polygons(standing);
      for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES / 2; ++i) {
        const Ball ball = draw_ball(all, 2026, i);
        const auto expected = built.touched(ball);
        EXPECT_EQ(moved.touched(ball), expected) << name(kind) << ", scene " << index << ", ball " << i;
        EXPECT_EQ(posed_when_added.touched(ball), expected) << name(kind) << ", scene " << index << ", ball " << i;
        if (i % 5 != 0) continue;
        EXPECT_EQ(moved.nearest(ball), built.nearest(ball)) << name(kind) << ", scene " << index << ", ball " << i;
      }
    }
}

TEST(PosedScene, IsAsBeforeWhenMovedBack) {
  const auto models = draw_objects(Kind::Soup, 2026, 11);
  Scene scene;
  const std::uint32_t object = scene.add("soup", models[0]);
  std::vector<Ball> balls;
  for (std::uint64_t i = 0; i < 100; ++i) balls.push_back(draw_ball(all_polygons({models[0]}), 2026, i));
  const auto before = scene.touched(balls);
  const std::size_t memory = scene.triangle_memory(object);
  for (std::uint64_t step = 0; step < 30; ++step) scene.set_pose(object, draw_pose({models[0]}, 2026, step));
  scene.set_pose(object, {Eigen::Matrix3d::Identity(), {3, 0, 0}});
  EXPECT_NE(scene.touched(balls), before);
  EXPECT_EQ(scene.triangle_memory(object), memory);  // in its own frame
  scene.set_pose(object, {Eigen::Vector3d(2, 1, 1).asDiagonal(), {3, 0, 0}});
  EXPECT_GT(scene.triangle_memory(object), memory);  // all triangles are posed
  scene.set_pose(object, {});
  EXPECT_EQ(scene.touched(balls), before);
  EXPECT_EQ(scene.triangle_memory(object), memory);
}

// Polygons are prepared by whichever thread comes first.
TEST(PosedScene, AnswersBatchesAsSingleQuestionsFromTheFirstOn) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    const auto models = draw_objects(Kind::OffPlane, 2026, index);
    Scene one, other;
    for (std::uint32_t i = 0; i < models.size(); ++i) {
      one.add(std::to_string(i), models[i], {Eigen::Matrix3d::Identity(), {1, 2, 3}});
      other.add(std::to_string(i), models[i], {Eigen::Matrix3d::Identity(), {1, 2, 3}});
    }
    std::vector<Ball> balls;
    for (std::uint64_t i = 0; i < 200; ++i) {
      balls.push_back(draw_ball(all_polygons(models), 2026, i));
      balls.back().center += Eigen::Vector3d(1, 2, 3);
    }
    const auto answers = one.touched(balls, Scene::Objects({0, 2}));
    for (std::size_t i = 0; i < balls.size(); ++i)
      EXPECT_EQ(answers[i], other.touched(balls[i], Scene::Objects({0, 2}))) << "scene " << index << ", ball " << i;
  }
}

TEST(PosedScene, StandsAlikeInEveryFloatingPointEnvironment) {
  for (const Kind kind : all_kinds()) {
    const auto model = draw_objects(kind, 2026, 2)[0];
    const Pose pose{(Eigen::Matrix3d() << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1).finished(), {0, 0, 0}};
    Scene expected;
    std::vector<Ball> balls;
    try {
      const scene::Faces faces = posed(pose, model);
      for (std::uint64_t i = 0; i < 20; ++i) balls.push_back(draw_ball(all_polygons({faces}), 2026, i));
      expected.add("object", faces);
    } catch (const Rejected&) {
      continue;
    }
    for (const contact_tests::State& state : contact_tests::kStates) {
      Scene scene;
      {
        const contact_tests::Environment changed(state);
        scene.add("object", model);
        scene.set_pose(0, pose);
        const bool left = changed.left_as_found();
        EXPECT_TRUE(left) << name(kind) << ", " << state;
      }
      for (const Ball& ball : balls)
        EXPECT_EQ(scene.touched(ball), expected.touched(ball)) << name(kind) << ", " << state;
    }
  }
}

TEST(PosedScene, StaysWhereItWasWhenAPoseIsRejected) {
  Scene scene;
  const Triangle large{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, small{{0, 0, 0}, {0x1p-30, 0, 0}, {0, 0x1p-30, 0}};
  const Polygon square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  // Its notch is narrower than what is left beside 2^30.
  const Polygon notched({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1 + 0x1p-40, 1, 0}, {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}});
  scene.add("shelf", {{large, small, small}, {square, notched}});
  const auto message = [&](const Eigen::Vector3d& translation) {
    try {
      scene.set_pose(0, {Eigen::Matrix3d::Identity(), translation});
    } catch (const Rejected& rejected) {
      return std::string(rejected.what());
    }
    return std::string();
  };
  EXPECT_EQ(message({1, 0, 0}), "");
  const Pose before = scene.pose(0);
  EXPECT_EQ(message({0x1p30, 0, 0}).substr(0, 24), "object \"shelf\", face 1: ");
  EXPECT_EQ(scene.pose(0), before);
  EXPECT_EQ(message({0x1p20, 0, 0}).substr(0, 24), "object \"shelf\", face 4: ");
  EXPECT_EQ(message({0, std::numeric_limits<double>::infinity(), 0}),
            "object \"shelf\": the pose has a number that is not finite");
  EXPECT_TRUE(scene.touches({{2, 0, 0}, 0}));
  EXPECT_FALSE(scene.touches({{0.5, 0, 0}, 0}));
  EXPECT_THROW(scene.set_pose(1, {}), std::out_of_range);
  EXPECT_THROW(scene.add("far", {{small}, {}}, {Eigen::Matrix3d::Identity(), {1e9, 0, 0}}), Rejected);
  EXPECT_EQ(scene.object_count(), 1U);
}

}  // namespace
}  // namespace touchstone::scene_tests
