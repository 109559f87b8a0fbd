// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads ask what the first query that needs it prepares. With the preset tsan, unordered accesses fail.
#include <gtest/gtest.h>

#include <barrier>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/cases/workloads/workload.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"
#include "robust/scene/scene.h"

namespace touchstone::concurrency_tests {
namespace {

struct Question {
  Polygon polygon;
  Motion motion;  ///< the ball at its start is exactly tangent, which only exact forms decide
};

/// About polygons whose edges queries scan, and polygons over whose edges they need a hierarchy.
std::vector<Question> draw(workloads::Family family, std::size_t vertices) {
  workloads::Workload workload;
  workload.family = family, workload.vertices = vertices;
  workload.ball = workloads::BallPlace::LatticeTangent, workload.way = workloads::Way::Start;
  std::vector<Question> questions;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const workloads::Sample sample = workloads::sample(workload, 2026, i);
    questions.push_back({sample.polygon, std::get<Motion>(sample.question())});
  }
  return questions;
}

/// Several threads at once ask what make() returns, then one thread asks what another call returns: ask() must answer
/// the same.
template <class Make, class Ask>
void expect_same_answers(const Make& make, const Ask& ask) {
  constexpr int kThreads = 4;
  const auto shared = make();
  std::vector<decltype(ask(shared))> answers(kThreads);
  {
    std::barrier start(kThreads);
    std::vector<std::jthread> threads;
    for (auto& own : answers)
      threads.emplace_back([&] {
        start.arrive_and_wait();
        own = ask(shared);
      });
  }
  const auto expected = ask(make());
  for (const auto& own : answers) EXPECT_TRUE(own == expected);
}

class Concurrent : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(OfVertices, Concurrent, testing::Values(12, 100), testing::PrintToStringParamName());

TEST_P(Concurrent, QueriesPrepareAPolygonOnce) {
  const std::vector<Question> questions = draw(workloads::Family::Star, GetParam());
  const auto make = [&] {
    std::vector<std::pair<filtered::PreparedPolygon, exact::PreparedPolygon>> prepared;
    for (const auto& [polygon, motion] : questions) prepared.emplace_back(polygon, polygon);
    return prepared;
  };
  expect_same_answers(make, [&](const auto& prepared) {
    std::vector<std::tuple<Answer, FirstContact, PlaneSide, Answer>> answers;
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      const auto& [polygon, truth] = prepared[i];
      const auto& [ball, to] = questions[i].motion;
      const Ball beyond_the_frame{ball.center * 0x1p900, ball.radius};
      answers.emplace_back(filtered::answer(ball, polygon), filtered::first_contact(questions[i].motion, polygon),
                           filtered::plane_side(beyond_the_frame, polygon), exact::answer(ball, truth));
    }
    return answers;
  });
}

TEST_P(Concurrent, QueriesPrepareTheFacesOfASceneOnce) {
  const std::vector<Question> outlines = draw(workloads::Family::Star, GetParam());
  std::vector<Question> questions = draw(workloads::Family::Triangle, 3);
  scene::Faces faces;
  for (const Question& question : questions) {
    const Polygon& p = question.polygon;
    faces.triangles.push_back({p.vertex(0), p.vertex(1), p.vertex(2)});
  }
  for (const Question& question : outlines) faces.polygons.push_back(question.polygon);
  questions.insert(questions.end(), outlines.begin(), outlines.end());
  std::vector<Ball> balls;
  for (const Question& question : questions) balls.push_back(question.motion.ball);
  const auto make = [&] {
    auto scene = std::make_unique<scene::Scene>();
    scene->add("given", faces);
    scene->add("moved", faces, Pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}});
    return std::pair(std::move(scene), filtered::TriangleSet(faces.triangles));
  };
  expect_same_answers(make, [&](const auto& shared) {
    const auto& [scene, triangles] = shared;
    std::vector<std::tuple<std::vector<scene::FaceId>, double, FirstContact, bool>> answers;
    for (const Question& question : questions) {
      const Ball& ball = question.motion.ball;
      const auto first = scene->first_contact(question.motion);
      answers.emplace_back(scene->touched(ball), scene->nearest(ball)->distance,
                           first ? first->contact : FirstContact{}, filtered::any_contact(ball, triangles));
    }
    return std::pair(answers, scene->touched(balls));
  });
}

}  // namespace
}  // namespace touchstone::concurrency_tests
