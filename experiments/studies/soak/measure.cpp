// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/soak/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"

namespace touchstone::soak {
namespace {

namespace adversarial = workloads::adversarial;
using filtered::StageCounts;

constexpr std::uint64_t kWholeOneIn = 16;

/// Returns the polygon with a notch at a corner: a hole that has the corner as a vertex, or the outline visits the
/// corner again after it. Returns nothing if that is not a polygon, as where the corner is not convex.
std::optional<Polygon> with_touching_loops(const Polygon& polygon, std::uint64_t index) {
  std::vector<Loop> loops = workloads::loops_of(polygon);
  Loop& outer = loops.front();
  const std::size_t n = outer.size(), i = index / 2 % n;
  const Eigen::Vector3d at = outer[i], back = outer[(i + n - 1) % n] - at, ahead = outer[(i + 1) % n] - at;
  const Eigen::Vector3d p = at + back / 4 + ahead / 8, q = at + back / 8 + ahead / 4;
  if (index % 2 == 0)
    loops.push_back({at, p, q});
  else
    outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(i) + 1, {p, q, at});
  try {
    Polygon result = workloads::polygon_of(loops);
    if (!exact::validate(result)) return result;
  } catch (const Rejected&) {  // neighbouring vertices are equal, or a number is not finite
  }
  return std::nullopt;
}

/// All questions about one case.
class Comparison {
 public:
  Comparison(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally)
      : tested_(tested), seed_(seed), index_(index), case_(adversarial::draw_case(seed, index)), tally_(tally) {}

  void ask_all() {
    const exact::PreparedPolygon truth(case_.polygon);
    const bool touches = exact::contact(case_.ball, truth);
    if (const auto triangle = case_.triangle())
      ask(Way::Triangle, [&](auto& c) { ask_triangle(*triangle, touches, c); });
    std::optional<filtered::PreparedPolygon> prepared;
    ask(Way::Prepared, [&](auto& counts) {
      prepared.emplace(case_.polygon);
      ask_prepared(*prepared, touches, counts);
    });
    if (prepared && is_asked_whole()) {
      ask(Way::Answer, [&](auto& counts) { ask_whole(*prepared, truth, counts); });
      const PlaneSide side = exact::plane_side({case_.ball.center, 0}, truth);
      if (const auto triangle = case_.triangle(); triangle && side != PlaneSide::Intersects)
        ask(Way::Solid, [&](auto&) { ask_solid(*triangle, side, exact::answer(case_.ball, truth).point); });
      ask_touching(Way::Touching, [&](const filtered::PreparedPolygon& touching, auto& counts) {
        const exact::PreparedPolygon touching_truth(case_.polygon);
        ask_prepared(touching, exact::contact(case_.ball, touching_truth), counts);
        ask_whole(touching, touching_truth, counts);
      });
    }
    if (is_asked_whole()) ask_extreme();
    tally_.add_case(std::move(differences_));
  }

  void ask_all_moving() {
    const Motion motion = adversarial::draw_motion(case_, seed_, index_);
    take(motion);
    const FirstContact truth = exact::first_contact(motion, case_.polygon);
    if (const auto triangle = case_.triangle())
      ask(Way::MovingTriangle, [&](auto& counts) { ask_moving(motion, *triangle, truth, counts); });
    ask(Way::MovingPrepared, [&](auto& counts) {
      const filtered::PreparedPolygon prepared(case_.polygon);
      ask_moving(motion, prepared, truth, counts);
    });
    if (is_asked_whole())
      ask_touching(Way::MovingTouching, [&](const filtered::PreparedPolygon& touching, auto& counts) {
        ask_moving(motion, touching, exact::first_contact(motion, case_.polygon), counts);
      });
    if (is_asked_whole()) ask_extreme_moving();
    tally_.add_case(std::move(differences_));
  }

 private:
  void ask_extreme() {
    if (!take_extreme()) return;
    const exact::PreparedPolygon truth(case_.polygon);
    const bool touches = exact::contact(case_.ball, truth);
    ask(Way::Extreme, [&](auto& counts) {
      const filtered::PreparedPolygon prepared(case_.polygon);
      ask_prepared(prepared, touches, counts);
      ask_whole(prepared, truth, counts);
      const auto triangle = case_.triangle();
      if (!triangle) return;
      ask_triangle(*triangle, touches, counts);
      if (const PlaneSide side = exact::plane_side({case_.ball.center, 0}, truth); side != PlaneSide::Intersects)
        ask_solid(*triangle, side, exact::answer(case_.ball, truth).point);
    });
  }

  void ask_extreme_moving() {
    if (!take_extreme()) return;
    const Motion motion = adversarial::draw_extreme_motion(case_, seed_, index_);
    take(motion);
    const FirstContact truth = exact::first_contact(motion, case_.polygon);
    ask(Way::MovingExtreme, [&](auto& counts) {
      ask_moving(motion, filtered::PreparedPolygon(case_.polygon), truth, counts);
      if (const auto triangle = case_.triangle()) ask_moving(motion, *triangle, truth, counts);
    });
  }

  /// Goes over to extreme numbers, if they are a case.
  bool take_extreme() {
    std::optional<adversarial::Case> extreme = adversarial::draw_extreme_case(seed_, index_);
    if (extreme) case_ = *std::move(extreme);
    return extreme.has_value();
  }
  /// Goes over to a ball that moves.
  void take(const Motion& motion) {
    case_.ball = motion.ball;
    to_ = motion.to;
  }

  static_assert(kWholeOneIn == std::uint64_t{1} << (64 - 60));

  /// A multiplier spreads the share over all families, which go by the index.
  [[nodiscard]] bool is_asked_whole() const { return index_ * 0x9e3779b97f4a7c15 >> 60 == 0; }

  /// Counts the case for one way of asking.
  template <class Questions>
  void ask(Way way, const Questions& questions) {
    const std::size_t before = differences_.size();
    StageCounts counts;
    try {
      questions(counts);
    } catch (const std::exception& error) {
      differs(std::string(to_string(way)) + ": " + error.what(), case_.ball, case_.polygon);
    }
    Outcomes& outcomes = tally_.at(case_.family, way);
    ++outcomes.cases;
    ++outcomes.by_stage[static_cast<std::size_t>(counts.last())];
    outcomes.differences += differences_.size() > before ? 1 : 0;
  }

  /// Goes over to a polygon whose loops touch, if there is one.
  template <class Questions>
  void ask_touching(Way way, const Questions& questions) {
    std::optional<Polygon> touching = with_touching_loops(case_.polygon, index_);
    if (!touching) return;
    case_.polygon = *std::move(touching);
    ask(way, [&](auto& counts) { questions(filtered::PreparedPolygon(case_.polygon), counts); });
  }

  /// Compares by ==, not by cases::differing_keys: every function of `filtered` returns the very type that `exact`
  /// does.
  void expect(bool same, const char* question) {
    if (!same) differs(question, case_.ball, case_.polygon);
  }

  void ask_triangle(const Triangle& t, bool touches, StageCounts& counts) {
    expect(tested_.contact(case_.ball, t) == touches, "triangle");
    expect(tested_.contact(case_.ball, t, counts) == touches, "triangle, counted");
    expect(tested_.plain_contact(case_.ball, t) == touches, "triangle, without vectors");

    const std::array<Triangle, 6> orders{
        {{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.c, t.b, t.a}, {t.b, t.a, t.c}, {t.a, t.c, t.b}}};
    std::array<bool, 6> found{};
    const auto expect_all = [&](const char* question) {
      for (std::size_t i = 0; i < orders.size(); ++i)
        if (found[i] != touches) differs(question, case_.ball, Polygon({orders[i].a, orders[i].b, orders[i].c}));
    };
    tested_.contact(case_.ball, orders, found);
    expect_all("triangle, in a batch");
    const filtered::TriangleSet set(orders);
    tested_.contact(case_.ball, set, found);
    expect_all("triangle, in a set");
    tested_.plain_contact(case_.ball, set, found);
    expect_all("triangle, in a set, without vectors");
  }

  void ask_prepared(const filtered::PreparedPolygon& prepared, bool touches, StageCounts& counts) {
    expect(tested_.contact(case_.ball, prepared) == touches, "contact");
    expect(tested_.contact(case_.ball, prepared, counts) == touches, "contact, counted");
    expect(tested_.plain_contact(case_.ball, prepared) == touches, "contact, without vectors");
  }

  void ask_whole(const filtered::PreparedPolygon& prepared, const exact::PreparedPolygon& truth, StageCounts& counts) {
    const Ball& ball = case_.ball;
    const Answer answer = exact::answer(ball, truth);
    expect(tested_.relation(ball, prepared) == answer.relation, "relation");
    expect(tested_.plane_side(ball, prepared) == answer.plane, "plane");
    expect(tested_.foot(ball, prepared) == answer.foot, "foot");
    expect(tested_.edges_hit(ball, prepared) == answer.edges_hit, "edges_hit");
    expect(tested_.answer(ball, prepared) == answer, "answer");
    expect(tested_.answer(ball, prepared, counts) == answer, "answer, counted");
    expect(tested_.plain_answer(ball, prepared) == answer, "answer, without vectors");
    if (const auto triangle = case_.triangle()) {
      const filtered::ClosestPoint closest{answer.nearest, answer.point, answer.distance, answer.contact_normal};
      expect(tested_.closest(ball.center, *triangle) == closest, "closest");
      expect(tested_.plain_closest(ball.center, *triangle) == closest, "closest, without vectors");
    }
    ask_neighbours(prepared, truth);
  }

  /// Nine balls, so that vectors of 2, 4 and 8 leave one over.
  void ask_neighbours(const filtered::PreparedPolygon& prepared, const exact::PreparedPolygon& truth) {
    std::array<Ball, 9> balls;
    std::array<bool, 9> found{};
    for (std::int64_t i = 0; i < 9; ++i) {
      balls[static_cast<std::size_t>(i)] = {case_.ball.center,
                                            workloads::move_radius_by_doubles(case_.ball.radius, i - 4)};
    }
    tested_.contact(balls, prepared, found);
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (found[i] != exact::contact(balls[i], truth)) differs("contact, in a batch", balls[i], case_.polygon);
  }

  /// About the tetrahedron of the triangle and the ball's centre, which lies on this side of it: at the closest point
  /// of the triangle, at its neighbours among the doubles, and farther inside and outside.
  void ask_solid(const Triangle& t, PlaneSide side, const Eigen::Vector3d& closest) {
    const Eigen::Vector3d& apex = case_.ball.center;
    const auto [a, b, c] = side == PlaneSide::Behind ? Triangle{t.a, t.b, t.c} : Triangle{t.a, t.c, t.b};
    const std::array<Triangle, 4> faces{{{a, b, c}, {b, a, apex}, {c, b, apex}, {a, c, apex}}};
    const scene::Solid solid(faces);
    std::vector<exact::PreparedPolygon> truths;
    for (const Triangle& face : faces) truths.emplace_back(Polygon({face.a, face.b, face.c}));

    std::vector<Eigen::Vector3d> points{closest, apex, 0.5 * (closest + apex), 2 * closest - apex};
    for (int axis = 0; axis < 3; ++axis)
      for (const double to : {-1.0, 1.0}) {
        points.push_back(closest);
        points.back()[axis] = std::nextafter(closest[axis], to * std::numeric_limits<double>::infinity());
      }
    for (const Eigen::Vector3d& point : points) {
      if (!point.allFinite()) continue;
      bool inside = true, touches = false;
      double distance = std::numeric_limits<double>::infinity();
      for (const exact::PreparedPolygon& face : truths) {
        const Answer answer = exact::answer({point, 0}, face);
        inside &= answer.plane == PlaneSide::Behind, touches |= answer.contact();
        distance = std::min(distance, answer.distance);
      }
      const PointLocation where = touches  ? PointLocation::Boundary
                                  : inside ? PointLocation::Inside
                                           : PointLocation::Outside;
      expect(tested_.locate(solid, point) == where, "solid, location");
      expect(tested_.signed_distance(solid, point) == (inside && !touches ? -distance : distance), "solid, distance");
    }
  }

  /// Of a triangle or a prepared polygon.
  template <class Asked>
  void ask_moving(const Motion& motion, const Asked& asked, const FirstContact& truth, StageCounts& counts) {
    expect(tested_.first_contact(motion, asked, counts) == truth, "first contact, counted");
    expect(tested_.first_contact(motion, asked) == truth, "first contact");
    expect(tested_.plain_first_contact(motion, asked) == truth, "first contact, without vectors");
    expect(tested_.contact(motion, asked, counts) == truth.contact(), "contact, counted");
    expect(tested_.contact(motion, asked) == truth.contact(), "contact");
    expect(tested_.plain_contact(motion, asked) == truth.contact(), "contact, without vectors");
    ask_batch(motion, asked, truth.contact());
  }

  /// Contact is the same backwards.
  void ask_batch(const Motion& motion, const filtered::PreparedPolygon& prepared, bool touches) {
    const std::array<Motion, 3> motions{{motion, {{motion.to, motion.ball.radius}, motion.ball.center}, motion}};
    std::array<bool, 3> found{};
    tested_.contact(motions, prepared, found);
    for (const bool each : found) expect(each == touches, "contact, in a batch");
  }
  void ask_batch(const Motion& motion, const Triangle& t, bool touches) {
    const std::array<Triangle, 3> triangles{{t, {t.b, t.a, t.c}, {t.b, t.c, t.a}}};
    std::array<bool, 3> found{};
    tested_.contact(motion, triangles, found);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != touches)
        differs("contact, in a batch", case_.ball, Polygon({triangles[i].a, triangles[i].b, triangles[i].c}));
  }

  void differs(const std::string& question, const Ball& ball, const Polygon& polygon) {
    cases::Shapes shapes{ball, polygon};
    if (to_) shapes.question = Motion{ball, *to_};
    differences_.push_back(
        {index_, cases::case_line(adversarial::name_of_case(seed_, index_), shapes,
                                  {std::string(to_string(case_.family)), question}, exact_answer(shapes))});
  }

  const SystemUnderTest& tested_;
  std::uint64_t seed_, index_;
  adversarial::Case case_;
  std::optional<Eigen::Vector3d> to_;  // of a moving ball
  Tally& tally_;
  std::vector<Difference> differences_;
};

}  // namespace

void compare(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally) {
  Comparison(tested, seed, index, tally).ask_all();
}

void compare_moving(const SystemUnderTest& tested, std::uint64_t seed, std::uint64_t index, Tally& tally) {
  Comparison(tested, seed, index, tally).ask_all_moving();
}

std::string_view to_string(Way way) {
  switch (way) {
    case Way::Triangle: return "triangle";
    case Way::Prepared: return "prepared";
    case Way::Answer: return "answer";
    case Way::Solid: return "solid";
    case Way::Touching: return "touching";
    case Way::MovingTriangle: return "moving-triangle";
    case Way::MovingPrepared: return "moving-prepared";
    case Way::MovingTouching: return "moving-touching";
    case Way::Extreme: return "extreme";
    case Way::MovingExtreme: break;
  }
  return "moving-extreme";
}

void Tally::add_case(std::vector<Difference> differences) {
  ++cases_;
  if (differences.empty()) return;
  ++differing_;
  std::move(differences.begin(), differences.end(), std::back_inserter(kept_));
  keep_first();
}

Tally& Tally::operator+=(const Tally& other) {
  program::add(outcomes_, other.outcomes_);
  cases_ += other.cases_;
  differing_ += other.differing_;
  kept_.insert(kept_.end(), other.kept_.begin(), other.kept_.end());
  keep_first();
  return *this;
}

/// By index; those of one case stay in their order.
void Tally::keep_first() {
  std::stable_sort(kept_.begin(), kept_.end(),
                   [](const Difference& a, const Difference& b) { return a.index < b.index; });
  if (kept_.size() > kMostKept) kept_.resize(kMostKept);
}

std::uint64_t run_campaign(const Settings& settings, const SystemUnderTest& tested, const program::RunControl& control,
                           Tally& tally, const std::function<void(const Difference&)>& tell) {
  const auto ask = settings.asked == Asked::Rest ? compare : compare_moving;
  constexpr std::uint64_t kBlock = 256;  // 10 to 40 ms on one core
  return program::run_sweep(
      settings.cases, settings.threads, control, Tally(), tally,
      [&](std::uint64_t i, Tally& part) {
        Tally one;
        ask(tested, settings.seed, settings.from + i, one);
        for (const Difference& difference : one.kept()) tell(difference);
        part += one;
      },
      kBlock);
}

}  // namespace touchstone::soak
