// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/filtered/triangle_set.h: the answers of exact, in every engine and every state.
#include "robust/filtered/triangle_set.h"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using filtered::Stage;
using filtered::StageCounts;
using filtered::TriangleSet;
using filtered::detail::Kernels;
using filtered::detail::TriangleGroup;
using workloads::Random;

bool exact_contact(const Ball& ball, const Triangle& t) { return exact::contact(ball, Polygon({t.a, t.b, t.c})); }

using Answers = std::vector<bool>;

/// Asks about all triangles with one set of kernels. Nothing may be written behind the span.
template <class Counts>
Answers asked(const filtered::detail::KernelTable<Counts>& kernels, const Ball& ball, const TriangleSet& set,
              Counts& counts) {
  const std::unique_ptr<bool[]> touches(new bool[set.size() + 1]());
  touches[set.size()] = true;
  kernels.set_contact(ball, parts_of(set), {touches.get(), set.size()}, counts);
  EXPECT_TRUE(touches[set.size()]);
  return Answers(touches.get(), touches.get() + set.size());
}

std::vector<std::size_t> numbers_of(const Answers& answers) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (answers[i]) numbers.push_back(i);
  return numbers;
}

/// Returns what is wrong with the answers of any engine and any overload; empty if nothing is.
std::string faults(const Ball& ball, const TriangleSet& set, const Answers& truth) {
  std::string wrong;
  const auto expect = [&wrong](bool right, const char* question) {
    if (!right) wrong += std::string(" ") + question;
  };
  const std::vector<std::size_t> hit = numbers_of(truth);
  for (const Kernels* kernels : all_kernels()) {
    filtered::NoCounts none;
    StageCounts counts;
    expect(asked(kernels->plain, ball, set, none) == truth, "contact");
    expect(asked(kernels->counted, ball, set, counts) == truth, "contact-counted");
    expect(kernels->plain.set_any_contact(ball, parts_of(set), none) == !hit.empty(), "any");
    expect(kernels->counted.set_any_contact(ball, parts_of(set), counts) == !hit.empty(), "any-counted");
    expect(kernels->plain.set_triangles_hit(ball, parts_of(set), none) == hit, "hit");
    expect(kernels->counted.set_triangles_hit(ball, parts_of(set), counts) == hit, "hit-counted");
  }
  return wrong;
}

Answers truths(const Ball& ball, const std::vector<Triangle>& triangles) {
  Answers truth;
  for (const Triangle& triangle : triangles) truth.push_back(exact_contact(ball, triangle));
  return truth;
}

// Guarantee (1), for all lengths: full groups and tails.
RC_GTEST_PROP(TriangleSet, IsExactOnHardTriangles, ()) {
  const std::size_t count = *rc::gen::resize(100, rc::gen::inRange<std::size_t>(0, 21));
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < count; ++i) triangles.push_back(triangle_of((*hard_triangles()).polygon));
  const Case c = *hard_triangles();
  if (count > 0) triangles[count / 2] = triangle_of(c.polygon);
  RC_ASSERT(faults(c.ball, TriangleSet(triangles), truths(c.ball, triangles)).empty());
}

// A hard triangle in every lane of its own, so that the group's units are those of the case.
RC_GTEST_PROP(TriangleSet, IsExactOnCopiesOfAHardTriangle, ()) {
  const Case c = *hard_triangles();
  const Triangle t = triangle_of(c.polygon);
  const std::vector<Triangle> orders{{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.c, t.b, t.a},
                                     {t.b, t.a, t.c}, {t.a, t.c, t.b}, {t.a, t.b, t.c}};
  RC_ASSERT(faults(c.ball, TriangleSet(orders), Answers(orders.size(), exact::contact(c.ball, c.polygon))).empty());
}

Eigen::Vector3d point_in_cube(Random& random) {
  const double x = random.unit(), y = random.unit();
  return {x, y, random.unit()};
}

/// A triangle of any shape; one in four is flattened to an aspect of 2^-1 to 2^-30.
Triangle draw_triangle(Random& random) {
  Triangle t{point_in_cube(random), point_in_cube(random), point_in_cube(random)};
  if (random.integer(0, 3) == 0) {
    const double flatness = std::ldexp(1.0, -static_cast<int>(random.integer(1, 30)));
    t.c = t.a + random.unit() * (t.b - t.a) + flatness * (t.c - t.a);
  }
  return t;
}

std::vector<Triangle> draw_triangles(Random& random, std::size_t count) {
  std::vector<Triangle> triangles;
  while (triangles.size() < count) triangles.push_back(draw_triangle(random));
  return triangles;
}

// Radii about each triangle's distance: from one double to 2^-6 of it, where floats begin to decide.
TEST(TriangleSet, IsExactAboutTheDistancesOfItsTriangles) {
  for (std::uint64_t index = 0; index < 2 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(25, index);
    const std::vector<Triangle> triangles = draw_triangles(random, 9);
    const TriangleSet set(triangles);
    const Eigen::Vector3d center = random.coin() ? point_in_cube(random) : 3 * point_in_cube(random);
    for (const Triangle& t : triangles) {
      const double distance = exact::answer({center, 0}, Polygon({t.a, t.b, t.c})).distance;
      for (const double gap : {0.0, 0x1p-52, 0x1p-30, 0x1p-18, 0x1p-15, 0x1p-14, 0x1p-13, 0x1p-12, 0x1p-11, 0x1p-6})
        for (const double side : {-1.0, 1.0}) {
          const Ball ball{center, distance * (1 + side * gap * (0.5 + random.unit() / 2))};
          EXPECT_EQ(faults(ball, set, truths(ball, triangles)), "") << "set " << index << ", gap " << side * gap;
        }
    }
  }
}

// Floats decide what they may, and nothing else: an answer of theirs is never wrong, whatever the single query says.
TEST(TriangleSet, AsksFewAgain) {
  Random random(26, 0);
  constexpr std::size_t kSets = 200, kSize = 16;
  StageCounts counts;
  for (std::size_t i = 0; i < kSets; ++i) {
    const std::vector<Triangle> triangles = draw_triangles(random, kSize);
    const TriangleSet set(triangles);
    const Ball ball{point_in_cube(random), random.unit() / 2};
    std::array<bool, kSize> touches{};
    contact(ball, set, touches, counts);
    for (std::size_t k = 0; k < kSize; ++k) EXPECT_EQ(touches[k], exact_contact(ball, triangles[k]));
  }
  EXPECT_GE(counts.decided_by(Stage::Double), kSets * kSize * 99 / 100);
}

/// One triangle that the ball touches among others that it misses, by how the answers of lanes are told apart.
TEST(TriangleSet, GivesEveryTriangleItsOwnAnswer) {
  const Triangle near{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, beside{{9, 0, 0}, {9, 4, 0}, {9, 0, 4}};
  const Ball ball{{1, 1, 0.5}, 1};
  for (std::size_t size = 0; size <= 20; ++size)
    for (std::size_t touched = 0; touched < size; ++touched) {
      std::vector<Triangle> triangles(size, beside);
      triangles[touched] = near;
      Answers truth(size, false);
      truth[touched] = true;
      EXPECT_EQ(faults(ball, TriangleSet(triangles), truth), "") << touched << " of " << size;
    }
}

TEST(TriangleSet, MayBeEmpty) {
  const TriangleSet empty{std::span<const Triangle>()};
  EXPECT_EQ(empty.size(), 0U);
  EXPECT_EQ(faults({{0, 0, 0}, 1}, empty, {}), "");
}

TEST(TriangleSet, CountsTheStagesThatDecide) {
  const std::vector<Triangle> triangles(11, Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const TriangleSet set(triangles);
  std::array<bool, 11> touches{};
  const auto counts_of = [&](const Ball& ball) {
    StageCounts counts;
    contact(ball, set, touches, counts);
    return counts;
  };
  for (const Ball& ball : {Ball{{1, 1, 1}, 0.5}, Ball{{1, 1, 1}, 1.5}, Ball{{90, 1, 1}, 1}, Ball{{1, 1, 1}, 90}}) {
    const StageCounts counts = counts_of(ball);
    EXPECT_EQ(counts.decided_by(Stage::Double), 11U);
    EXPECT_EQ(counts.last(), Stage::Double);
  }
  EXPECT_EQ(counts_of({{1, 1, 1}, 1}).decided_by(Stage::Double), 0U);
  EXPECT_EQ(counts_of({{1, 1, 1}, 1}).last(), Stage::FixedInteger);
}

// A square times 2^k, from subnormal numbers to the largest, with a ball that touches, misses or is all around it.
TEST(TriangleSet, IsExactAtEveryScale) {
  for (int exponent = -1072; exponent <= 1020; exponent += 4) {
    const double unit = std::ldexp(1.0, exponent);
    const std::vector<Triangle> triangles(3, Triangle{{unit, 0, 0}, {4 * unit, -0.0, 0}, {0, 4 * unit, 0}});
    const TriangleSet set(triangles);
    for (const double radius : {0.0, 1.0, 2.0, 3.0})
      for (const double height : {0.0, -0.0, 1.0, 2.0}) {
        const Ball ball{{unit, unit, height * unit}, radius * unit};
        EXPECT_EQ(faults(ball, set, Answers(3, height <= radius)), "") << "2^" << exponent;
      }
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    for (const Ball& ball : {Ball{{most, 0, -most}, unit}, Ball{{least, -least, 0}, least}, Ball{{0, most, 0}, most}})
      EXPECT_EQ(faults(ball, set, truths(ball, triangles)), "") << "2^" << exponent;
  }
}

// The answers, and what is left behind, in every state of the floating-point unit.
TEST(TriangleSet, DoesNotDependOnTheCallersState) {
  std::vector<std::pair<Ball, std::vector<Triangle>>> cases;
  for (std::uint64_t index = 0; index < 4 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(27, index);
    std::vector<Triangle> triangles = draw_triangles(random, 9);
    const int exponent = std::array{0, 0, -1060, -900, -500, 480, 1000}[static_cast<std::size_t>(random.integer(0, 6))];
    for (Triangle& t : triangles)
      for (Eigen::Vector3d* p : {&t.a, &t.b, &t.c})
        for (double& x : *p) x = std::ldexp(x, exponent);
    Eigen::Vector3d center = point_in_cube(random);
    for (double& x : center) x = std::ldexp(x, exponent);
    const Polygon first({triangles[0].a, triangles[0].b, triangles[0].c});
    if (exact::validate(first)) continue;
    const double distance = exact::answer({center, 0}, first).distance;
    cases.push_back({{center, random.coin() ? distance : std::ldexp(random.unit(), exponent)}, std::move(triangles)});
  }
  // On the triangle, or almost: distances that are computed to be zero.
  cases.push_back({{{0, 0, 0}, 0}, {{{-4, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  cases.push_back({{{0, 1, 0x1p-40}, 0}, {{{-4, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  cases.push_back({{{0, 1, 0x1p-40}, 0x1p-41}, {{{-4, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  cases.push_back({{{0, 1, 0x1p-100}, 0x1p-101}, {{{-4, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  // Small triangles far away: a difference from the group's origin would overflow.
  constexpr double kMost = std::numeric_limits<double>::max();
  for (const double far : {-0x1p1000, -0x1p980, -1.0})
    cases.push_back({{{far, 0, 0}, 1}, {{{kMost, 0, 0}, {kMost, 1, 0}, {kMost, 0, 1}}}});
  for (const auto& [ball, triangles] : cases) {
    Answers truth;
    try {
      truth = truths(ball, triangles);
      (void)TriangleSet(triangles);
    } catch (const Rejected&) {
      continue;  // scaling made a triangle degenerate
    }
    for (const State& state : kStates) {
      const Environment changed(state);
      const TriangleSet set(triangles);
      const std::string wrong = faults(ball, set, truth);
      const bool left_as_found = changed.left_as_found();
      EXPECT_EQ(wrong, "") << state;
      EXPECT_TRUE(left_as_found) << state;
    }
  }
}

Rejection rejection_of(const std::vector<Triangle>& triangles) {
  try {
    (void)TriangleSet(triangles);
  } catch (const Rejected& rejected) {
    return rejected.rejection();
  }
  return {RejectionCode::MalformedCase, "not rejected"};
}

TEST(TriangleSet, RejectsTheFirstTriangleThatIsNone) {
  const Triangle good{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},
      twice{{1, 2, 3}, {1, 2, 3}, {0, 4, 0}}, far{{0, 0, 0}, {4, 0, 0}, {0, HUGE_VAL, 0}};
  const auto expect = [&](std::size_t place, const Triangle& bad, RejectionCode code) {
    std::vector<Triangle> triangles(20, good);
    triangles[place] = bad;
    triangles[19] = far;
    const Rejection found = rejection_of(triangles);
    EXPECT_EQ(found.code, code) << place;
    EXPECT_TRUE(found.message.starts_with("triangle " + std::to_string(place) + ": ")) << found.message;
  };
  for (const std::size_t place : {0U, 3U, 7U, 8U, 18U}) {
    expect(place, line, RejectionCode::ZeroNormal);
    expect(place, twice, RejectionCode::RepeatedVertex);
    expect(place, far, RejectionCode::NotFinite);
  }
  // Flat, but by one double not degenerate.
  EXPECT_EQ(rejection_of({{{0, 0, 0}, {1, 1, 1}, {3, 3, std::nextafter(3, 4)}}}).message, "not rejected");
}

TEST(TriangleSet, RefusesASpanOfAnotherLength) {
  const TriangleSet set(std::vector<Triangle>(2, Triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}));
  std::array<bool, 3> touches{};
  StageCounts counts;
  EXPECT_THROW(contact({{0, 0, 0}, 1}, set, touches), std::invalid_argument);
  EXPECT_THROW(contact({{0, 0, 0}, 1}, set, touches, counts), std::invalid_argument);
}

TEST(TriangleSet, MayBeMoved) {
  const Triangle near{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  TriangleSet first(std::vector<Triangle>{near});
  TriangleSet second(std::move(first));
  first = TriangleSet(std::vector<Triangle>(3, near));
  EXPECT_EQ(second.size(), 1U);
  EXPECT_EQ(triangles_hit({{1, 1, 0.5}, 1}, first), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(any_contact({{1, 1, 0.5}, 1}, second));
}

// What bounds.h promises of stored triangles: an exact comparison of vertices, in the group's units.
TEST(TriangleSet, StoresVerticesNearTheGivenOnes) {
  const mpq_class limit = mpq_class(filtered::detail::bounds::kLaneStored) * filtered::detail::bounds::kLaneStored;
  mpq_class largest = 0;
  for (std::uint64_t index = 0; index < 100 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(28, index);
    std::vector<Triangle> triangles = draw_triangles(random, 8);
    const double shift = std::ldexp(random.unit(), static_cast<int>(random.integer(-30, 20)));
    for (Triangle& t : triangles)
      for (Eigen::Vector3d* p : {&t.a, &t.b, &t.c}) p->x() += shift;
    const TriangleGroup group = filtered::detail::group_of(triangles);
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
      const Eigen::Vector3d* const given[] = {&triangles[lane].a, &triangles[lane].b, &triangles[lane].c};
      for (std::size_t i = 0; i < 3; ++i) {
        mpq_class from_origin = 0, apart = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const mpq_class exact =
              (mpq_class((*given[i])[static_cast<int>(k)]) - mpq_class(group.origin[k])) * mpq_class(group.scale);
          const mpq_class difference = exact - mpq_class(group.vertices[i][k][lane], TriangleGroup::kSteps);
          from_origin += exact * exact;
          apart += difference * difference;
        }
        EXPECT_LE(from_origin, 1) << "sample " << index;
        EXPECT_LE(apart, limit) << "sample " << index;
        largest = std::max(largest, apart);
      }
    }
  }
  EXPECT_GE(largest, limit * 4 / 5) << "it is loose";
}

}  // namespace
}  // namespace touchstone::filtered_tests
