// SPDX-License-Identifier: GPL-3.0-or-later
// Third-party engines: right for easy cases, wrong for the cases where this is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/cases/method.h"
#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/triangulate.h"
#include "robust/exact/exact.h"
#include "robust/filtered/motion.h"

namespace touchstone::methods {
namespace {

using workloads::BallPlace;
using workloads::Workload;

/// Returns the number of random triangles or polygons that an engine gets wrong.
struct Wrong {
  int hits = 0, misses = 0, unsure = 0;
  [[nodiscard]] int all() const { return hits + misses; }
};

Wrong wrong(const cases::Method& engine, const Workload& workload, double radius_factor) {
  Wrong wrong;
  for (std::uint64_t n = 0; n < 3 * TOUCHSTONE_SAMPLES; ++n) {
    auto sample = workloads::sample(workload, 2026, n);
    sample.ball.radius *= radius_factor;
    const bool truth = exact::contact(sample.ball, sample.polygon);
    const auto answer = engine.prepare(sample.polygon)->ask(sample.ball, cases::QueryKind::Contact).contact;
    if (!answer)
      ++wrong.unsure;
    else if (*answer && !truth)
      ++wrong.hits;
    else if (!*answer && truth)
      ++wrong.misses;
  }
  return wrong;
}

class OwnEngine : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    engine = find_method(GetParam());
    if (engine == nullptr) GTEST_SKIP() << "this program was built without " << GetParam();
  }
  const cases::Method* engine = nullptr;
};

const Workload kTriangles{.family = workloads::Family::Triangle, .ball = BallPlace::NearFace};
const Workload kOutlines{.family = workloads::Family::Star, .ball = BallPlace::NearEdge};
const Workload kTangent{.family = workloads::Family::Triangle, .ball = BallPlace::LatticeTangent};

// Excludes small balls with large coordinates, for which floats, and GJK with its tolerance of 1e-10, may err.
TEST_P(OwnEngine, IsRightATenthFromTheBoundaryAsFarAsItsNumbersReach) {
  const std::string name = GetParam();
  const bool coarse = name == "bullet-float" || name == "libccd" || name == "ode";
  const int allowed = coarse ? 3 * TOUCHSTONE_SAMPLES / 5 + 5 : 0;  // a fifth, and what few samples scatter
  for (const Workload& workload : {kTriangles, kOutlines})
    for (const double factor : {0.9, 1.1}) {
      const Wrong counted = wrong(*engine, workload, factor);
      EXPECT_LE(counted.hits, allowed) << factor;
      EXPECT_LE(counted.misses, allowed) << factor;
      EXPECT_EQ(counted.unsure, 0) << factor;
    }
}

TEST_P(OwnEngine, IsWrongAboutExactTangencyUnlessItIsExact) {
  const Wrong counted = wrong(*engine, kTangent, 1);
  const std::string name = GetParam();
  if (name == "cgal-epeck-distance" || name == "cgal-epeck-intersect" || name == "cgal-epick-intersect") {
    EXPECT_EQ(counted.all(), 0);
  } else {
    EXPECT_GT(counted.all(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, OwnEngine,
                         testing::Values("fcl", "libccd", "bullet", "bullet-float", "ode", "embree-fast",
                                         "cgal-double-distance", "cgal-double-intersect", "cgal-epick-distance",
                                         "cgal-epick-intersect", "cgal-epeck-distance", "cgal-epeck-intersect"),
                         [](const auto& engine) {
                           std::string name = engine.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

struct WrongMotions {
  int invented = 0, missed = 0, asked = 0;
  double worst_time = 0;
};

constexpr int kMotions = std::max(TOUCHSTONE_SAMPLES, 30);  // of fewer, too few pass an edge

/// Asks about balls that pass an edge, with `factor` times the radius with which they graze; polygons have sizes of
/// about 1.
WrongMotions wrong_motions(const cases::Method& engine, double factor) {
  WrongMotions wrong;
  const Workload workload{.family = workloads::Family::Star,
                          .placement = workloads::Placement::LatticeFrame,
                          .ball = BallPlace::NearEdge,
                          .vertices = 8,
                          .way = workloads::Way::Across};
  for (std::uint64_t n = 0; n < kMotions; ++n) {
    const auto sample = workloads::sample(workload, 2026, n);
    const double unit = std::exp2(-std::ilogb(workloads::extent_of(sample.polygon)));
    auto loops = workloads::loops_of(sample.polygon);
    for (Loop& loop : loops)
      for (Eigen::Vector3d& vertex : loop) vertex *= unit;
    const Polygon polygon = workloads::polygon_of(loops);
    Motion motion{{unit * sample.ball.center, 0}, unit * *sample.to};
    const filtered::PreparedPolygon prepared(polygon);
    const double grazing = workloads::grazing_radius(
        motion, [&prepared](const Motion& asked) { return filtered::contact(asked, prepared); });
    if (grazing < 0.05) continue;  // less than tolerances in units of length are made for
    motion.ball.radius = factor * grazing;
    const auto answer = engine.prepare(polygon)->ask_moving(motion).value();
    const FirstContact truth = filtered::first_contact(motion, prepared);
    ++wrong.asked;
    wrong.invented += answer.contact == true && !truth.contact() ? 1 : 0;
    wrong.missed += answer.contact == false && truth.contact() ? 1 : 0;
    if (truth.contact() && answer.contact == true && answer.time)
      wrong.worst_time = std::max(wrong.worst_time, std::abs(*answer.time - truth.time));
  }
  return wrong;
}

TEST(Engines, AreRightAboutMotionsATenthFromGrazing) {
  for (const char* name : {"bullet", "bullet-float", "libccd", "fcl", "cgal-double-distance", "cgal-epick-distance",
                           "cgal-epeck-distance"}) {
    const cases::Method* engine = find_method(name);
    if (engine == nullptr) continue;  // this program was built without it
    const WrongMotions less = wrong_motions(*engine, 0.9), more = wrong_motions(*engine, 1.1);
    EXPECT_GT(less.asked, kMotions / 10) << name;
    EXPECT_EQ(less.invented, 0) << name;
    EXPECT_EQ(more.missed, 0) << name;
    EXPECT_LT(more.worst_time, 0.02) << name;  // FCL asks at 100 places
  }
}

// A ball above the middle of a triangle, at half its radius, on either side and for either way round.
TEST(Engines, SeeATriangleFromBothSides) {
  const Eigen::Vector3d a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  for (const Polygon& polygon : {Polygon({a, b, c}), Polygon({a, c, b})})
    for (const double height : {0.5, -0.5})
      for (const auto& engine : all_methods()) {
        const auto answer = engine->prepare(polygon)->ask({{1, 1, height}, 1}, cases::QueryKind::Contact);
        if (answer.contact) {
          EXPECT_TRUE(*answer.contact) << engine->name() << " at " << height;
        }
      }
}

// With nothing set, Bullet reports points of contact within 0.035 of the radius of a ball that is smaller than the
// mesh.
TEST(Engines, BulletHasAThresholdUnlessItIsToldOtherwise) {
  const cases::Method *bullet = find_method("bullet"), *defaults = find_method("bullet-defaults");
  if (bullet == nullptr) GTEST_SKIP() << "this program was built without bullet";
  const Polygon triangle({{3, 0, 0}, {0, 3, 0}, {0, 0, 3}});
  const auto contact = [&](const cases::Method& method, double height) {
    const Eigen::Vector3d center = Eigen::Vector3d::Ones() + height * Eigen::Vector3d::Ones().normalized();
    return method.prepare(triangle)->ask({center, 1}, cases::QueryKind::Contact).contact;
  };
  EXPECT_EQ(contact(*bullet, 0.99), true);
  EXPECT_EQ(contact(*bullet, 1.01), false);
  EXPECT_EQ(contact(*defaults, 1.03), true);
  EXPECT_EQ(contact(*defaults, 1.04), false);
}

// Of a rotated polygon the contract asks about the lifted vertices, and an exact kernel that has others answers another
// question.
TEST(Engines, ExactKernelsAnswerOnlyWhereTheQuestionIsTheSame) {
  int unsure = 0;
  for (const auto placement : {workloads::Placement::LatticeFrame, workloads::Placement::Rotated})
    for (std::uint64_t n = 0; n < TOUCHSTONE_SAMPLES; ++n) {
      const auto sample = workloads::sample(
          {.family = workloads::Family::Star, .placement = placement, .ball = BallPlace::NearFace}, 2026, n);
      const bool same = exact::answer(sample.ball, sample.polygon).off_plane == 0;
      for (const char* name : {"cgal-epeck-distance", "cgal-epeck-intersect"}) {
        const auto answer = find_method(name)->prepare(sample.polygon)->ask(sample.ball, cases::QueryKind::Contact);
        EXPECT_EQ(answer.unsure, !same) << name << ", " << sample.id;
        if (same) {
          EXPECT_EQ(answer.contact, exact::contact(sample.ball, sample.polygon)) << name << ", " << sample.id;
        }
      }
      unsure += same ? 0 : 1;
    }
  EXPECT_GT(unsure, TOUCHSTONE_SAMPLES / 2);
}

TEST(Engines, MeshesShareTheirVertices) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const std::vector<Triangle> triangles = triangles_of(square);
  const Mesh mesh(triangles);
  EXPECT_EQ(mesh.vertices.size(), 4U);
  ASSERT_EQ(mesh.corners.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto corner = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(mesh.corners[i][k])]; };
    EXPECT_EQ(corner(0), triangles[i].a);
    EXPECT_EQ(corner(1), triangles[i].b);
    EXPECT_EQ(corner(2), triangles[i].c);
  }
}

TEST(Engines, ThatGiveNoTimeGiveNone) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const Motion falls{{{2, 1, 5}, 1}, {2, 1, -5}}, rests{{{2, 1, 0.5}, 1}, {2, 1, 0.5}};
  const auto answer = find_method("cgal-epeck-distance")->prepare(square)->ask_moving(falls).value();
  EXPECT_EQ(answer.contact, true);
  EXPECT_FALSE(answer.time);
  EXPECT_FALSE(find_method("cgal-epeck-intersect")->prepare(square)->ask_moving(falls));
  if (const cases::Method* bullet = find_method("bullet")) {
    EXPECT_NEAR(bullet->prepare(square)->ask_moving(falls)->time.value(), 0.4, 1e-3);
    EXPECT_EQ(bullet->prepare(square)->ask_moving(rests)->time, 0);
  }
}

TEST(Engines, CannotBeAskedWhereTheyWouldEndTheProgram) {
  const Polygon huge({{0, 0, 0}, {4e300, 0, 0}, {0, 4e300, 0}});
  const auto answer = find_method("cgal-epick-intersect")
                          ->prepare(huge)
                          ->ask({{1e300, 1e300, 2e300}, 2e300}, cases::QueryKind::Contact);
  EXPECT_TRUE(answer.unsure);
  EXPECT_FALSE(answer.contact);
  const auto exact = find_method("cgal-epeck-intersect")
                         ->prepare(huge)
                         ->ask({{1e300, 1e300, 2e300}, 2e300}, cases::QueryKind::Contact);
  EXPECT_FALSE(exact.unsure);
  EXPECT_TRUE(exact.contact);
}

}  // namespace
}  // namespace touchstone::methods
