// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <span>

#include "experiments/studies/bench_scenes/measure.h"
#include "robust/scene/scene.h"

namespace touchstone::bench_scenes {
namespace {

std::uint64_t number_of(const std::vector<scene::FaceId>& faces) {
  constexpr std::uint64_t kFactor = 0x100'0000'01b3;  // so that sets of as many faces differ
  return std::accumulate(faces.begin(), faces.end(), std::uint64_t{faces.size()},
                         [](std::uint64_t sum, const scene::FaceId& id) { return sum * kFactor + id.face; });
}

/// A scene that is asked about balls, each answer as a number.
class Together {
 public:
  Together(const scene::Scene& scene, SceneQuestion question, std::shared_ptr<const std::vector<Ball>> balls)
      : scene_(scene), question_(question), balls_(std::move(balls)), touches_(new bool[balls_->size()]) {
    for (const Ball& ball : *balls_) centers_.push_back(ball.center);
  }

  [[nodiscard]] std::vector<std::uint64_t> answers(std::size_t first, std::size_t count) const {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(count);
    const auto balls = std::span(*balls_).subspan(first, count);
    switch (question_) {
      case SceneQuestion::Any:
        scene_.touches(balls, {touches_.get(), count});
        numbers.assign(touches_.get(), touches_.get() + count);
        break;
      case SceneQuestion::All:
        for (const auto& faces : scene_.touched(balls)) numbers.push_back(number_of(faces));
        break;
      case SceneQuestion::Nearest:
        for (const auto& face : scene_.nearest_face(std::span(centers_).subspan(first, count)))
          numbers.push_back(face->face);
        break;
    }
    return numbers;
  }
  /// Returns the answer about one ball that was asked alone.
  [[nodiscard]] std::uint64_t answer(std::size_t i) const {
    const Ball& ball = (*balls_)[i];
    switch (question_) {
      case SceneQuestion::Any: return scene_.touches(ball) ? 1 : 0;
      case SceneQuestion::All: return number_of(scene_.touched(ball));
      case SceneQuestion::Nearest: return scene_.nearest_face(ball.center)->face;
    }
    return 0;
  }

 private:
  const scene::Scene& scene_;
  SceneQuestion question_;
  std::shared_ptr<const std::vector<Ball>> balls_;
  std::vector<Eigen::Vector3d> centers_;
  std::unique_ptr<bool[]> touches_;
};

/// Calls f(first, size) for parts of `at_once` balls.
template <class F>
void in_parts(std::size_t count, std::size_t at_once, const F& f) {
  for (std::size_t first = 0; first < count; first += std::min(at_once, count - first))
    f(first, std::min(at_once, count - first));
}

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr const char* kAllTogether = "Scene, all together";

}  // namespace

// Embree's call for a packet of points asks about one after the other, as its manual says, and has no row of its own.
const std::vector<ManyBalls> kManyBalls{
    {"Scene, 64 together", 64, 1, {methods::kEmbree, timing::Goal{0.8}}},
    {"Scene, 1024 together", 1024, 1, {methods::kEmbree, timing::Goal{0.5}}},
    {kAllTogether, kAll, 1, {methods::kEmbree, timing::Goal{0.35}}},
    {"Scene, two cores", kAll, 2, {kAllTogether, timing::Goal{1 / 1.9}}},
};

std::vector<timing::Candidate> many_ball_candidates(const scene::Scene& scene, SceneQuestion question,
                                                    const std::shared_ptr<const std::vector<Ball>>& balls) {
  const auto together = std::make_shared<Together>(scene, question, balls);
  std::vector<timing::Candidate> candidates;
  for (const auto& [name, at_once, cores, goal] : kManyBalls) {
    timing::Candidate candidate;
    candidate.name = name;
    candidate.queries = balls->size();
    candidate.ask = [together, at_once = at_once, cores = cores](std::size_t count) {
      std::uint64_t sum = 0;
      tbb::task_arena(cores).execute([&] {
        in_parts(count, at_once, [&](std::size_t first, std::size_t size) {
          const auto answers = together->answers(first, size);
          sum = std::accumulate(answers.begin(), answers.end(), sum);
        });
      });
      return sum;
    };
    candidate.count_wrong = [together, at_once = at_once](std::size_t count) {
      std::size_t wrong = 0;
      in_parts(count, at_once, [&](std::size_t first, std::size_t size) {
        const auto answers = together->answers(first, size);
        for (std::size_t i = 0; i < size; ++i) wrong += answers[i] != together->answer(first + i) ? 1 : 0;
      });
      return wrong;
    };
    candidate.comparison = goal;
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace touchstone::bench_scenes
