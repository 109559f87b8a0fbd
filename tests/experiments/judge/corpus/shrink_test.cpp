// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "experiments/cases/method.h"
#include "experiments/cases/verdict.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/experiments/judge/corpus/stored.h"

namespace touchstone::corpus {
namespace {

using cases::Shapes;

const std::atomic<bool> never = false;

/// Returns one in `every` of the cases that the method fails, of balls at a place or moving.
std::vector<const Stored*> failed_by(const std::string& method, std::size_t every, bool moving = false) {
  std::vector<const Stored*> failed;
  for (const Stored& stored : stored_cases())
    if ((moving ? stored.first.has_value() : stored.answer.has_value()) && stored.fails(method))
      failed.push_back(&stored);
  std::vector<const Stored*> some;
  for (std::size_t i = 0; i < failed.size(); i += every) some.push_back(failed[i]);
  return some;
}

WrongAnswer wrong(const cases::Method& method, const Shapes& shapes) {
  return wrong_answer(method, shapes, exact_answer(shapes));
}

Shapes shrunk(const cases::Method& method, const Shapes& shapes) {
  return std::get<Shapes>(shrink(SameFailure(method, shapes), shapes, never));
}

void expect_smaller_and_failing(const cases::Method& method, const Stored& stored) {
  const SameFailure failure(method, stored.shapes());
  const auto small = std::get<Shapes>(shrink(failure, stored.shapes(), never));
  EXPECT_EQ(small.question.index(), stored.shapes().question.index()) << stored;
  EXPECT_FALSE(find_fault(small.ball())) << stored;
  EXPECT_FALSE(exact::validate(small.polygon)) << stored;
  const auto before = size_of(stored.shapes()), after = size_of(small);
  EXPECT_LE(after, before) << stored;
  EXPECT_LE(after.vertices, before.vertices) << stored;
  EXPECT_EQ(exact_answer(small).first, exact_answer(stored.shapes()).first) << stored;
  const auto still = wrong(method, small);
  ASSERT_FALSE(failure.keys().empty()) << stored;
  for (const cases::Key key : failure.keys())
    EXPECT_EQ(std::ranges::count(still.keys, key), 1) << stored << ": " << key.name;
}

void expect_shrunk_once(const cases::Method& method, const Stored& stored) {
  const Shapes once = shrunk(method, stored.shapes()), twice = shrunk(method, once);
  EXPECT_EQ(once.polygon, twice.polygon) << stored;
  EXPECT_EQ(cases::case_line("", once, {}), cases::case_line("", twice, {})) << stored;
}

/// A method, and how many of the cases that it fails are shrunk: one in `every` and, twice, one in `every_twice`.
struct Shrunk {
  std::string method;
  std::size_t every = 60, every_twice = 110;
  bool moving = false;
};

class ShrinkFailures : public testing::TestWithParam<Shrunk> {};

TEST_P(ShrinkFailures, GivesAValidCaseThatIsNoLargerAndFailsInTheSameKeys) {
  const auto failed = failed_by(GetParam().method, GetParam().every, GetParam().moving);
  EXPECT_FALSE(failed.empty());
  for (const Stored* stored : failed) expect_smaller_and_failing(*methods::find_method(GetParam().method), *stored);
}

TEST_P(ShrinkFailures, ChangesNothingThatItHasShrunk) {
  for (const Stored* stored : failed_by(GetParam().method, GetParam().every_twice, GetParam().moving))
    expect_shrunk_once(*methods::find_method(GetParam().method), *stored);
}

INSTANTIATE_TEST_SUITE_P(Methods, ShrinkFailures,
                         testing::Values(Shrunk{"fast"}, Shrunk{"fast-float"}, Shrunk{"thesis"}, Shrunk{"cgal-double"},
                                         Shrunk{"fast", 12, 40, true}, Shrunk{"fast-float", 12, 40, true}),
                         [](const auto& shrunk) {
                           std::string name = shrunk.param.method + (shrunk.param.moving ? "moving" : "");
                           std::erase(name, '-');
                           return name;
                         });

// The tests of the thesis are strict: they miss a ball that touches a face. A triangle with coordinates 0 and 1 is all
// of the U that this failure needs.
TEST(ShrinkOf, AStrictTestKeepsATriangleOfSmallNumbers) {
  const Polygon u(
      {{10, 20, 5}, {70, 20, 5}, {70, 80, 5}, {50, 80, 5}, {50, 40, 5}, {30, 40, 5}, {30, 80, 5}, {10, 80, 5}});
  const Ball ball{{40, 30, 12}, 7};
  const cases::Method& thesis = *methods::find_method("thesis");
  const auto small = std::get<Shapes>(shrink(SameFailure(thesis, Shapes{ball, u}, "contact"), Shapes{ball, u}, never));
  EXPECT_EQ(small.polygon.vertex_count(), 3u);
  EXPECT_LE(size_of(small).bits, 6u);
  EXPECT_EQ(exact::relation(small.ball(), small.polygon), Relation::Touching);
}

TEST(ShrinkOf, AHoleThatMattersIsKeptAndOthersGo) {
  // Doubles miss the ball that touches only an edge of the second hole.
  for (const Stored* stored : failed_by("fast", 1)) {
    if (stored->file != "holes" || stored->polygon().loop_count() != 3) continue;
    const Shapes small = shrunk(*methods::find_method("fast"), stored->shapes());
    EXPECT_LT(small.polygon.loop_count(), 3u) << *stored;
  }
}

TEST(ShrinkOf, WordsStayAsTheyWere) {
  const cases::Method& fast = *methods::find_method("fast");
  for (const Stored* stored : failed_by("fast", 40)) {
    const auto before = wrong(fast, stored->shapes());
    if (std::ranges::count(before.keys, key_of(&cases::PartialAnswer::relation)) == 0) continue;
    const Shapes small = shrunk(fast, stored->shapes());
    EXPECT_EQ(exact::relation(small.ball(), small.polygon), stored->answer->relation) << *stored;
    const auto after = wrong(fast, small);
    EXPECT_EQ(std::ranges::count(after.keys, key_of(&cases::PartialAnswer::relation)), 1) << *stored;
    EXPECT_EQ(after.answer.relation, before.answer.relation) << *stored;
  }
}

TEST(ShrinkOf, NumbersThatAreRoundedWronglyDoNotBecomeAnotherFailure) {
  const cases::Method& fast = *methods::find_method("fast");
  int count = 0;
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer || stored.fails("fast") || count == 15) continue;
    if (wrong(fast, stored.shapes()).keys.empty()) continue;
    const Shapes small = shrunk(fast, stored.shapes());
    const auto still = wrong(fast, small);
    EXPECT_FALSE(still.keys.empty()) << stored;
    EXPECT_FALSE(any_decisive(still.keys)) << stored;
    ++count;
  }
  EXPECT_EQ(count, 15);
}

TEST(ShrinkOf, WhatDoesNotFailIsRefused) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const Ball ball{{1, 1, 1}, 2};
  EXPECT_THROW(SameFailure(*methods::find_method("exact"), Shapes{ball, square}), std::invalid_argument);
  EXPECT_THROW(SameFailure(*methods::find_method("thesis"), Shapes{Ball{{1, 1, 1}, 1}, square}, "foot"),
               std::invalid_argument);
}

TEST(SizeOf, CountsBitsSignsAndExponents) {
  const Polygon triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto bits = [&](double radius) { return size_of(Shapes{Ball{{0, 0, 0}, radius}, triangle}).bits - 2; };
  EXPECT_EQ(bits(0), 0u);
  EXPECT_EQ(bits(1), 1u);
  EXPECT_EQ(bits(3), 2u);
  EXPECT_EQ(bits(0.5), 2u);              // 1, and 1 for the exponent
  EXPECT_EQ(bits(0x1p-1074), 1u + 11u);  // 1, and 1074
  EXPECT_EQ(bits(0x1.fffffffffffffp0), 53u + 6u);
  EXPECT_EQ(size_of(Shapes{Ball{{-1, 0, 0}, 0}, triangle}).bits - 2, 2u);
  EXPECT_EQ(size_of(Shapes{Motion({{0, 0, 0}, 0}, {0, 3, 0}), triangle}).bits - 2, 2u);
}

}  // namespace
}  // namespace touchstone::corpus
