// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/scene/counts.h: on faces whose fate is known by hand, and against exact brute force.
#include "robust/scene/counts.h"

#include <gtest/gtest.h>

#include <numeric>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/bigint_sign.h"
#include "robust/filtered/detail/kernels.h"
#include "tests/robust/scene/adversarial_scenes.h"

namespace touchstone::scene_tests {
namespace {

using filtered::Stage;
using scene::CullOutcome;
using scene::FaceCounts;
using scene::Scene;

constexpr CullOutcome kAll[] = {CullOutcome::Box,  CullOutcome::Known, CullOutcome::Slab,
                                CullOutcome::Foot, CullOutcome::Edges, CullOutcome::Touched};

struct Settled {
  CullOutcome outcome;
  std::uint64_t edges_looked_at;
  friend bool operator==(const Settled&, const Settled&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Settled& s) {
    return out << to_string(s.outcome) << ", " << s.edges_looked_at << " edges looked at";
  }
};

/// The fate of the only face of a scene.
Settled settled(const Scene& scene, const Ball& ball) {
  FaceCounts counts;
  (void)scene.touched(ball, counts);
  EXPECT_EQ(counts.faces(), 1U);
  for (const CullOutcome outcome : kAll)
    if (counts.faces(outcome) == 1) return {outcome, counts.edges_looked_at()};
  ADD_FAILURE() << "no outcome";
  return {};
}

Settled settled(scene::Faces faces, const Ball& ball) {
  Scene scene;
  scene.add("the face", std::move(faces));
  return settled(scene, ball);
}

std::uint64_t staged(const FaceCounts& counts) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < filtered::kStages; ++i) sum += counts.tested(static_cast<Stage>(i));
  return sum;
}

// An obtuse triangle, so that its box reaches beyond the corner at (1, 1, 0).
const Triangle kObtuse{{0, 1.5, 0}, {1, 1, 0}, {1.5, 0, 0}};

TEST(FaceCounts, SettleATriangleByTheFirstReasonThatApplies) {
  const auto outcome = [](const Ball& ball) { return settled({{kObtuse}, {}}, ball); };
  EXPECT_EQ(outcome({{3, 0, 0}, 1.25}), (Settled{CullOutcome::Box, 0}));
  EXPECT_EQ(outcome({{0.75, 0.75, 2}, 2}), (Settled{CullOutcome::Touched, 0}))
      << "touches from above, the foot on an edge";
  EXPECT_EQ(outcome({{0.875, 0.875, 2}, 2}), (Settled{CullOutcome::Touched, 0}))
      << "touches from above, the foot inside";
  EXPECT_EQ(outcome({{0.25, 0.25, 0}, 0.5}), (Settled{CullOutcome::Foot, 0})) << "beyond the long edge by 0.71";
  EXPECT_EQ(outcome({{1.25, 1.25, 0}, 0.35}), (Settled{CullOutcome::Edges, 3}))
      << "0.3536 from the corner, 0.335 from the lines";
  EXPECT_EQ(outcome({{1.25, 1.25, 0}, 0.36}), (Settled{CullOutcome::Touched, 3}));
}

// A plane that is not parallel to an axis, so that the box is thick: the ball is in it, and 0.29 from the plane.
TEST(FaceCounts, SettleATriangleByItsSlabExactly) {
  const Triangle tilted{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const auto outcome = [&](const Ball& ball) { return settled({{tilted}, {}}, ball); };
  EXPECT_EQ(outcome({{1, 1, 1.5}, 0.25}), (Settled{CullOutcome::Slab, 0}));
  EXPECT_EQ(outcome({{1, 1, 1.5}, 0.3}), (Settled{CullOutcome::Touched, 0}));
  // sqrt(1/12) is 0.28867513459481287 rounded down, and the ball of that radius does not reach the plane.
  EXPECT_EQ(outcome({{1, 1, 1.5}, 0.28867513459481287}).outcome, CullOutcome::Slab);
  EXPECT_EQ(outcome({{1, 1, 1.5}, 0.28867513459481292}).outcome, CullOutcome::Touched);
}

// An L with arms of 16 steps, so that a ball between the arms is in the box of the whole and of no few edges.
TEST(FaceCounts, SettleAPolygon) {
  Loop loop;
  for (int i = 0; i < 16; ++i) loop.emplace_back(i, 0, 0);
  loop.emplace_back(16, 0, 0);
  for (int i = 16; i > 1; --i) loop.emplace_back(i, 1, 0);
  for (int i = 1; i < 16; ++i) loop.emplace_back(1, i, 0);
  for (int i = 16; i > 0; --i) loop.emplace_back(0, i, 0);
  const Polygon ell(loop);
  const auto outcome = [&](const Ball& ball) { return settled({{}, {ell}}, ball); };
  EXPECT_EQ(outcome({{20, 20, 0}, 1}), (Settled{CullOutcome::Box, 0}));
  EXPECT_EQ(outcome({{12, 12, 0}, 1}), (Settled{CullOutcome::Foot, 0}));
  EXPECT_EQ(outcome({{8.5, 1.5, 0}, 0.49}).outcome, CullOutcome::Edges);
  EXPECT_GT(outcome({{8.5, 1.5, 0}, 0.49}).edges_looked_at, 0U);
  EXPECT_LT(outcome({{8.5, 1.5, 0}, 0.49}).edges_looked_at, loop.size() / 2);
  EXPECT_EQ(outcome({{8.5, 1.5, 0}, 0.5}).outcome, CullOutcome::Touched);
  const Polygon tilted({{4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  EXPECT_EQ(settled({{}, {tilted}}, {{1, 1, 1.5}, 0.25}), (Settled{CullOutcome::Slab, 0}));
}

// A comb of 400 edges: a small disc is near few of them, and inside none.
TEST(FaceCounts, SeeThatMostEdgesOfALargePolygonAreNeverLookedAt) {
  Loop comb;
  for (int tooth = 0; tooth < 100; ++tooth)
    for (const auto& [x, y] : {std::pair(0.0, 1.0), {0.0, 5.0}, {0.5, 5.0}, {0.5, 1.0}})
      comb.emplace_back(tooth + x, y, 0);
  comb.emplace_back(99.5, 0, 0);
  comb.emplace_back(0, 0, 0);
  Scene scene;
  scene.add("comb", {{}, {Polygon(comb)}});
  FaceCounts counts;
  EXPECT_EQ(scene.touched({{50.75, 3, 0}, 0.25}, counts).size(), 1U);
  EXPECT_EQ(counts.edges(), comb.size());
  EXPECT_GE(counts.edges_looked_at(), 1U);
  EXPECT_LE(counts.edges_looked_at(), 24U);
}

// Tangent from above at a height that is not a square root: in doubles the slab cannot tell.
TEST(FaceCounts, TellWhichStageWasTheSlowest) {
  Scene scene;
  scene.add("floor", {{{{-1, -1, 0.1}, {1, -1, 0.1}, {0, 2, 0.1}}}, {}});
  const auto ask = [&](const Ball& ball) {
    FaceCounts counts;
    (void)scene.touches(ball, counts);
    return counts;
  };
  const FaceCounts easy = ask({{0, 0, 0.5}, 0.5}), tangent = ask({{0, 0, 0.35}, 0.25});
  EXPECT_EQ(easy.tested(Stage::Double), 1U);
  EXPECT_EQ(tangent.tested(Stage::Double), 0U);
  EXPECT_EQ(staged(tangent), 1U);
}

TEST(FaceCounts, NamesWhatComesAfterTheAnswer) {
  Scene scene;
  const Triangle near{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, far{{9, 9, 9}, {9, 8, 9}, {8, 9, 9}};
  scene.add("a", {{near, near}, {Polygon({near.a, near.b, near.c})}});
  scene.add("b", {{near}, {}});
  scene.add("c", {{far}, {}});
  FaceCounts counts;
  EXPECT_TRUE(scene.touches({{0, 0, 0}, 1}, counts));
  EXPECT_EQ(counts.faces(), 5U);
  EXPECT_EQ(counts.faces(CullOutcome::Touched), 1U);
  EXPECT_EQ(counts.faces(CullOutcome::Known), 3U);
  EXPECT_EQ(counts.faces(CullOutcome::Box), 1U);
}

TEST(FaceCounts, AreAboutTheChosenObjectsOnly) {
  Scene scene;
  scene.add("a", {{kObtuse}, {}});
  scene.add("b", {{kObtuse, kObtuse}, {}});
  FaceCounts counts;
  (void)scene.touched({{1, 1, 0}, 1}, counts, std::vector<std::uint32_t>{1});
  EXPECT_EQ(counts.faces(), 2U);
  EXPECT_EQ(counts.edges(), 6U);
}

/// The fate of the only face of a scene on the way of a ball.
Settled settled_on_way(scene::Faces faces, const Motion& motion) {
  Scene scene;
  scene.add("the face", std::move(faces));
  FaceCounts counts, first;
  (void)scene.touched(motion, counts);
  (void)scene.first_contact(motion, first);
  EXPECT_EQ(counts, first);
  for (const CullOutcome outcome : kAll)
    if (counts.faces(outcome) == 1) return {outcome, counts.edges_looked_at()};
  ADD_FAILURE() << "no outcome";
  return {};
}

TEST(FaceCounts, SettleATriangleOnTheWay) {
  const Triangle tilted{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const auto outcome = [&](const Motion& motion) { return settled_on_way({{tilted}, {}}, motion); };
  EXPECT_EQ(outcome(Motion({{8, 8, 0}, 1}, {8, 8, 4})), (Settled{CullOutcome::Box, 0}));
  // Along the plane, within the box, at a distance of 0.29.
  EXPECT_EQ(outcome(Motion({{1, 1, 1.5}, 0.25}, {1, 1.5, 1})), (Settled{CullOutcome::Slab, 0}));
  EXPECT_EQ(outcome(Motion({{1, 1, 1.5}, 0.3}, {1, 1.5, 1})), (Settled{CullOutcome::Touched, 3}));
  EXPECT_EQ(outcome(Motion({{1, 1, 1.5}, 0.25}, {1, 1, 2})), (Settled{CullOutcome::Touched, 3})) << "passes through";
  // Through the plane, beside an edge.
  EXPECT_EQ(outcome(Motion({{4, 4, 0}, 0.25}, {0, 0, -0.25})), (Settled{CullOutcome::Touched, 3}));
  EXPECT_EQ(outcome(Motion({{4, 4, 0}, 0.25}, {0, 0, -1})), (Settled{CullOutcome::Edges, 3}));
}

TEST(FaceCounts, SettleAPolygonOnTheWay) {
  const Polygon ell({{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {1, 1, 0}, {1, 8, 0}, {0, 8, 0}});
  const auto outcome = [&](const Motion& motion) { return settled_on_way({{}, {ell}}, motion); };
  EXPECT_EQ(outcome(Motion({{4, 4, 2}, 1}, {4, 5, 2})), (Settled{CullOutcome::Box, 0}));
  EXPECT_EQ(outcome(Motion({{4, 4, 1}, 1}, {4, 4, -1})).outcome, CullOutcome::Edges);
  EXPECT_EQ(outcome(Motion({{4, 2, 1}, 1}, {4, 2, -1})).outcome, CullOutcome::Touched);
  const Polygon tilted({{4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  EXPECT_EQ(settled_on_way({{}, {tilted}}, Motion({{1, 1, 1.5}, 0.25}, {1, 1.5, 1})), (Settled{CullOutcome::Slab, 0}));
}

// A row of walls across the way: the ball comes to the first, and the boxes behind it are not entered.
TEST(FaceCounts, LeaveOutWhatIsTouchedLaterThanTheFirstFace) {
  scene::Faces walls;
  for (int i = 63; i >= 0; --i) {
    const double x = 10.0 * i;
    walls.triangles.push_back({{x, -1, -1}, {x, 1, -1}, {x, 0, 2}});
  }
  Scene scene;
  scene.add("walls", walls);
  const Motion through({{-5, 0, 0}, 0.5}, {635, 0, 0});
  FaceCounts all, first;
  EXPECT_EQ(scene.touched(through, all).size(), 64U);
  EXPECT_EQ(all.tested(), 64U);
  EXPECT_EQ(scene.first_contact(through, first)->face, (scene::FaceId{0, 63}));
  EXPECT_EQ(first.faces(), 64U);
  EXPECT_LE(first.tested(), scene.face_count(0) / 8) << "one leaf";
}

/// Calls f(objects, scene, ball, words) for scenes of each kind.
template <class F>
void for_each_scene_and_ball(std::uint64_t balls, const F& f) {
  for (const Kind kind : all_kinds()) {
    const auto objects = draw_objects(kind, 2027, 0);
    Scene scene;
    for (std::size_t i = 0; i < objects.size(); ++i) scene.add(std::to_string(i), objects[i]);
    for (std::uint64_t i = 0; i < balls; ++i)
      f(objects, scene, draw_ball(objects, 2027, i), name(kind) + ", ball " + std::to_string(i));
  }
}

// Guarantees (1) to (3): everything adds up, and counting changes no answer.
TEST(FaceCounts, AddUpAndLeaveTheAnswersAlone) {
  for_each_scene_and_ball(
      TOUCHSTONE_SAMPLES / 5, [](const auto& objects, const Scene& scene, const Ball& ball, const auto& what) {
        std::uint64_t faces = 0, edges = 0;
        for (const scene::Faces& object : objects) {
          faces += object.triangles.size() + object.polygons.size();
          edges += 3 * object.triangles.size();
          for (const Polygon& polygon : object.polygons) edges += polygon.vertex_count();
        }
        FaceCounts any, all, nearest;
        const auto touched = scene.touched(ball, all);
        EXPECT_EQ(touched, scene.touched(ball)) << what;
        EXPECT_EQ(scene.touches(ball, any), scene.touches(ball)) << what;
        const auto found = scene.nearest(ball, nearest);
        ASSERT_TRUE(found) << what;
        EXPECT_EQ(found->face, scene.nearest(ball)->face) << what;
        for (const FaceCounts* counts : {&any, &all, &nearest}) {
          EXPECT_EQ(counts->faces(), faces) << what;
          EXPECT_EQ(counts->edges(), edges) << what;
          EXPECT_LE(counts->edges_looked_at(), edges) << what;
          EXPECT_EQ(staged(*counts), counts->tested()) << what;
          EXPECT_EQ(counts->tested(), counts->faces(CullOutcome::Slab) + counts->faces(CullOutcome::Foot) +
                                          counts->faces(CullOutcome::Edges) + counts->faces(CullOutcome::Touched))
              << what;
        }
        EXPECT_EQ(all.faces(CullOutcome::Touched), touched.size()) << what;
        EXPECT_EQ(all.faces(CullOutcome::Known), 0U) << what;
        EXPECT_EQ(any.faces(CullOutcome::Touched), touched.empty() ? 0U : 1U) << what;
        EXPECT_EQ(any.faces(CullOutcome::Box), all.faces(CullOutcome::Box)) << what;
        EXPECT_EQ(nearest.faces(CullOutcome::Known), 0U) << what;
        EXPECT_GE(nearest.faces(CullOutcome::Touched), 1U) << what;

        FaceCounts sum = any, both;
        sum += all;
        (void)scene.touches(ball, both);
        (void)scene.touched(ball, both);
        EXPECT_EQ(sum, both) << what;
      });
}

TEST(FaceCounts, AddUpForMovingBallsAndLeaveTheAnswersAlone) {
  for (const Kind kind : all_kinds()) {
    const auto objects = draw_objects(kind, 2027, 0);
    const auto all_faces = all_polygons(objects);
    Scene scene;
    for (std::size_t i = 0; i < objects.size(); ++i) scene.add(std::to_string(i), objects[i]);
    for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES / 5; ++i) {
      const Motion motion = draw_motion(all_faces, 2027, i);
      const std::string what = name(kind) + ", motion " + std::to_string(i);
      FaceCounts any, all, first;
      const auto touched = scene.touched(motion, all);
      EXPECT_EQ(touched, scene.touched(motion)) << what;
      EXPECT_EQ(scene.touches(motion, any), scene.touches(motion)) << what;
      const auto found = scene.first_contact(motion, first), expected = scene.first_contact(motion);
      ASSERT_EQ(found.has_value(), expected.has_value()) << what;
      if (found) {
        EXPECT_EQ(found->face, expected->face) << what;
        EXPECT_EQ(found->contact, expected->contact) << what;
        EXPECT_GE(first.faces(CullOutcome::Touched), 1U) << what;
      }
      for (const FaceCounts* counts : {&any, &all, &first}) {
        EXPECT_EQ(counts->faces(), all_faces.size()) << what;
        EXPECT_LE(counts->edges_looked_at(), counts->edges()) << what;
        EXPECT_EQ(staged(*counts), counts->tested()) << what;
        EXPECT_EQ(counts->faces(CullOutcome::Foot), 0U) << what;
        EXPECT_EQ(counts->tested(), counts->faces(CullOutcome::Slab) + counts->faces(CullOutcome::Edges) +
                                        counts->faces(CullOutcome::Touched))
            << what;
      }
      EXPECT_EQ(all.faces(CullOutcome::Touched), touched.size()) << what;
      EXPECT_EQ(any.faces(CullOutcome::Touched), touched.empty() ? 0U : 1U) << what;
      EXPECT_EQ(any.faces(CullOutcome::Box), all.faces(CullOutcome::Box)) << what;
      EXPECT_GE(first.faces(CullOutcome::Box), all.faces(CullOutcome::Box)) << what;
    }
  }
}

/// Is the foot beyond the line of an edge that the ball does not reach?
bool parted_by_a_line(const Ball& ball, const Triangle& triangle) {
  const auto question = filtered::view_of(ball, triangle);
  for (int i = 0; i < 3; ++i)
    if (bigint_sign(filtered::SignKind::Side, question, i) < 0 &&
        bigint_sign(filtered::SignKind::Line, question, i) > 0)
      return true;
  return false;
}

/// Does the reason hold, and is it the first? By exact arithmetic alone.
void expect_true(CullOutcome outcome, const Ball& ball, const Polygon& face, const std::string& what) {
  const exact::PreparedPolygon prepared(face);
  EXPECT_EQ(outcome == CullOutcome::Touched, exact::contact(ball, prepared)) << what;
  if (outcome == CullOutcome::Box || outcome == CullOutcome::Touched) return;
  EXPECT_EQ(outcome == CullOutcome::Slab, exact::plane_side(ball, prepared) != PlaneSide::Intersects) << what;
  if (outcome != CullOutcome::Slab) {
    EXPECT_EQ(exact::foot(ball, prepared), PointLocation::Outside) << what;
  }
}

// Each face by itself, so that its fate can be seen.
TEST(FaceCounts, GiveReasonsThatHold) {
  for (const Kind kind : all_kinds()) {
    const auto objects = draw_objects(kind, 2028, 0);
    std::vector<Ball> balls;
    for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES / 5; ++i) balls.push_back(draw_ball(objects, 2028, i));
    const auto expect_reasons = [&](const scene::Faces& one, const Polygon& face) {
      Scene scene;
      scene.add("the face", one);
      for (std::size_t i = 0; i < balls.size(); ++i) {
        const CullOutcome outcome = settled(scene, balls[i]).outcome;
        const std::string what = name(kind) + ", ball " + std::to_string(i) + ": " + std::string(to_string(outcome));
        expect_true(outcome, balls[i], face, what);
        if (!one.triangles.empty() && (outcome == CullOutcome::Foot || outcome == CullOutcome::Edges)) {
          EXPECT_EQ(outcome == CullOutcome::Foot, parted_by_a_line(balls[i], one.triangles.front())) << what;
        }
      }
    };
    const scene::Faces& faces = objects.front();
    for (std::size_t i = 0; i < faces.triangles.size(); i += 7) {
      const Triangle& t = faces.triangles[i];
      expect_reasons({{t}, {}}, Polygon({t.a, t.b, t.c}));
    }
    for (const Polygon& polygon : faces.polygons) expect_reasons({{}, {polygon}}, polygon);
  }
}

}  // namespace
}  // namespace touchstone::scene_tests
