// SPDX-License-Identifier: GPL-3.0-or-later
// Third-party engines: right for easy cases, wrong for the cases where this is known.
#include <gtest/gtest.h>

#include <string>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"
#include "experiments/workloads/workload.h"
#include "robust/exact/exact.h"

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

class Engine : public testing::TestWithParam<const char*> {
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
TEST_P(Engine, IsRightATenthFromTheBoundaryAsFarAsItsNumbersReach) {
  const std::string name = GetParam();
  const bool coarse = name == "embree" || name == "bullet-float" || name == "libccd" || name == "ode";
  const int allowed = coarse ? 3 * TOUCHSTONE_SAMPLES / 5 + 5 : 0;  // a fifth, and what few samples scatter
  for (const Workload& workload : {kTriangles, kOutlines})
    for (const double factor : {0.9, 1.1}) {
      const Wrong counted = wrong(*engine, workload, factor);
      EXPECT_LE(counted.hits, allowed) << factor;
      if (name != "ode") {  // which sees the front alone
        EXPECT_LE(counted.misses, allowed) << factor;
      }
      EXPECT_EQ(counted.unsure, 0) << factor;
    }
}

TEST_P(Engine, IsWrongAboutExactTangencyUnlessItIsExact) {
  const Wrong counted = wrong(*engine, kTangent, 1);
  const std::string name = GetParam();
  if (name == "cgal-epeck-distance" || name == "cgal-epeck-intersect" || name == "cgal-epick-intersect") {
    EXPECT_EQ(counted.all(), 0);
  } else {
    EXPECT_GT(counted.all(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, Engine,
                         testing::Values("fcl", "libccd", "bullet", "bullet-float", "ode", "embree",
                                         "cgal-double-distance", "cgal-double-intersect", "cgal-epick-distance",
                                         "cgal-epick-intersect", "cgal-epeck-distance", "cgal-epeck-intersect"),
                         [](const auto& engine) {
                           std::string name = engine.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

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
