// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/studies/soak/measure.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"

namespace touchstone::soak {
namespace {

namespace adversarial = workloads::adversarial;
using scene::FaceId;
using scene::NearestFace;

/// Object 0 of the scene has the triangles, object 1 the other polygons.
class Crowd {
 public:
  Crowd(std::uint64_t seed, std::uint64_t index) {
    std::vector<Triangle> triangles;
    std::vector<Polygon> polygons;
    for (std::uint64_t i = kCrowdFaces * index; i < kCrowdFaces * (index + 1); ++i) {
      auto extreme = i % 16 == 5 ? adversarial::draw_extreme_case(seed, i) : std::nullopt;
      cases_.push_back(extreme ? *std::move(extreme) : adversarial::draw_case(seed, i));
      names_.push_back(adversarial::name_of_case(seed, i));
      const adversarial::Case& drawn = cases_.back();
      if (const auto triangle = drawn.triangle()) {
        ids_.push_back({0, static_cast<std::uint32_t>(triangles.size())});
        triangles.push_back(*triangle);
      } else {
        ids_.push_back({1, static_cast<std::uint32_t>(polygons.size())});
        polygons.push_back(drawn.polygon);
      }
      exact_.emplace_back(drawn.polygon);
      prepared_.emplace_back(drawn.polygon);
      balls_.push_back(drawn.ball);
    }
    for (const std::int64_t doubles : {-8, -7, -6, -5, -4, -3, -2, -1, 1, 2, 3, 4, 5, 6, 7, 8})
      for (const adversarial::Case& drawn : cases_)
        balls_.push_back({drawn.ball.center, workloads::move_radius_by_doubles(drawn.ball.radius, doubles)});
    for (const adversarial::Case& drawn : cases_) {
      double least = std::numeric_limits<double>::infinity();
      for (const filtered::PreparedPolygon& face : prepared_)
        least = std::min(least, filtered::answer(drawn.ball, face).distance);
      least_distances_.push_back(least);
    }
    scene_.add("triangles", {triangles, {}});
    scene_.add("polygons", {{}, polygons});
  }

  [[nodiscard]] const scene::Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Ball>& balls() const { return balls_; }
  /// Returns which case a ball belongs to, from 0.
  [[nodiscard]] static std::size_t case_of(std::size_t ball) { return ball % kCrowdFaces; }
  [[nodiscard]] adversarial::Family family(std::size_t ball) const { return cases_[case_of(ball)].family; }

  /// Returns the faces that a ball touches, ascending: its own by `exact`, the others by `filtered`, one by one.
  [[nodiscard]] std::vector<FaceId> touched(std::size_t ball) const {
    std::vector<FaceId> found;
    for (std::size_t face = 0; face < kCrowdFaces; ++face)
      if (face == case_of(ball) ? exact::contact(balls_[ball], exact_[face])
                                : filtered::contact(balls_[ball], prepared_[face]))
        found.push_back(ids_[face]);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Returns whether this is the nearest face with the answer that `filtered` gives about it. Among faces at the same
  /// distance, or at distances that round to the same double, it may be any of them.
  [[nodiscard]] bool is_nearest(const NearestFace& found, std::size_t ball) const {
    const auto face = std::find(ids_.begin(), ids_.end(), found.face);
    if (face == ids_.end()) return false;
    const Answer answer = filtered::answer(balls_[ball], prepared_[static_cast<std::size_t>(face - ids_.begin())]);
    return found.feature == answer.nearest && found.point == answer.point && found.distance == answer.distance &&
           found.contact_normal == answer.contact_normal && found.depth == answer.depth &&
           found.distance == least_distances_[case_of(ball)];
  }

  /// Returns the line of a difference: the ball and the polygon of its own case.
  [[nodiscard]] std::string line(std::size_t ball, const std::string& question) const {
    const adversarial::Case& drawn = cases_[case_of(ball)];
    const cases::Shapes shapes{balls_[ball], drawn.polygon};
    return cases::case_line(names_[case_of(ball)], shapes, {std::string(to_string(drawn.family)), question},
                            exact_answer(shapes));
  }

 private:
  std::vector<adversarial::Case> cases_;
  std::vector<std::string> names_;
  std::vector<FaceId> ids_;
  std::vector<exact::PreparedPolygon> exact_;
  std::vector<filtered::PreparedPolygon> prepared_;
  std::vector<double> least_distances_;  // from the centre of each case
  std::vector<Ball> balls_;              // seventeen of each case, enough to walk together
  scene::Scene scene_;
};

bool same(const NearestFace& a, const NearestFace& b) {
  const auto all = [](const NearestFace& n) {
    return std::tie(n.face, n.feature, n.point, n.distance, n.contact_normal, n.depth);
  };
  return all(a) == all(b);
}

}  // namespace

void compare_crowd(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally) {
  if (index >= std::numeric_limits<std::uint64_t>::max() / kCrowdFaces)
    throw std::invalid_argument("crowd " + std::to_string(index) + " has cases beyond 2^64 - 1");
  const Crowd crowd(seed, index);
  const std::vector<Ball>& balls = crowd.balls();
  std::vector<std::vector<FaceId>> truth;
  for (std::size_t i = 0; i < balls.size(); ++i) truth.push_back(crowd.touched(i));

  std::vector<Difference> differences;
  std::vector<bool> differ(balls.size());
  const auto differs = [&](std::size_t ball, const std::string& question) {
    differences.push_back({index, crowd.line(ball, question)});
    differ[ball] = true;
  };
  tbb::task_arena one_core(1);  // there all balls walk together
  const auto ask = [&](const char* question, const auto& asks) {
    try {
      one_core.execute(asks);
    } catch (const std::exception& error) {
      differs(0, std::string(question) + ": " + error.what());
    }
  };
  ask("crowd, touches", [&] {
    const auto touches = std::make_unique<bool[]>(balls.size());
    tested.touches(crowd.scene(), balls, {touches.get(), balls.size()});
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (touches[i] == truth[i].empty()) differs(i, "crowd, touches");
  });
  ask("crowd, touched", [&] {
    const auto touched = tested.touched(crowd.scene(), balls);
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (touched.at(i) != truth[i]) differs(i, "crowd, touched");
  });
  ask("crowd, nearest", [&] {
    const auto nearest = tested.nearest(crowd.scene(), std::span(balls).first(kCrowdFaces));
    for (std::size_t i = 0; i < kCrowdFaces; ++i) {
      if (!crowd.is_nearest(nearest.at(i).value(), i)) differs(i, "crowd, nearest");
      if (!same(*nearest[i], crowd.scene().nearest(balls[i]).value())) differs(i, "crowd, nearest of single balls");
    }
  });

  for (std::size_t i = 0; i < balls.size(); ++i) {
    Outcomes& outcomes = tally.at(crowd.family(i), Way::Crowd);
    ++outcomes.cases;
    ++outcomes.by_stage[static_cast<std::size_t>(filtered::StageCounts().last())];
    outcomes.differences += differ[i] ? 1 : 0;
  }
  tally.add_case(std::move(differences));
}

}  // namespace touchstone::soak
