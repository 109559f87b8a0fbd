// SPDX-License-Identifier: GPL-3.0-or-later
// The soak: its cases are what it says, it finds planted errors, and killed runs end as whole ones do.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/commands.h"
#include "experiments/program/output.h"
#include "experiments/program/sweep.h"
#include "experiments/studies/soak/measure.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::soak {
namespace {

namespace adversarial = workloads::adversarial;
using run_tests::Scratch;
using run_tests::text_of;

using run_tests::kNeverStop;
using run_tests::kSilent;

/// Returns the tally of a whole run.
Tally whole(const Settings& settings, const SystemUnderTest& tested = {}) {
  Tally tally;
  run_campaign(settings, tested, {kNeverStop, kSilent}, tally);
  return tally;
}

std::string line_of(const adversarial::Case& c) { return cases::case_line("", cases::Shapes{c.ball, c.polygon}, {}); }

TEST(SoakCases, AreLegalAndOfTheirFamily) {
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    const adversarial::Case c = adversarial::draw_case(5, index);
    EXPECT_FALSE(find_fault(c.ball)) << "index " << index;
    EXPECT_FALSE(exact::validate(c.polygon)) << "index " << index;
    EXPECT_EQ(c.family == adversarial::Family::Outline, index % 10 == 9) << "index " << index;
    EXPECT_TRUE(c.family == adversarial::Family::Outline || c.triangle()) << "index " << index;
  }
}

TEST(SoakCases, AreAFunctionOfSeedAndIndex) {
  std::set<std::string> seen;
  for (std::uint64_t index = 0; index < 200; ++index) {
    const std::string line = line_of(adversarial::draw_case(1, index));
    EXPECT_EQ(line, line_of(adversarial::draw_case(1, index))) << "index " << index;
    EXPECT_NE(line, line_of(adversarial::draw_case(2, index))) << "index " << index;
    seen.insert(line);
  }
  EXPECT_EQ(seen.size(), 200U);
}

// Hard where they say so: every family but Anywhere has contacts and misses, ties where it promises them.
TEST(SoakCases, StandAtTheirThresholds) {
  std::array<std::uint64_t, static_cast<std::size_t>(adversarial::Family::Outline) + 1> touching{}, separate{},
      overlapping{}, boundary{};
  for (std::uint64_t index = 0; index < 3000; ++index) {
    const adversarial::Case c = adversarial::draw_case(3, index);
    const Answer answer = exact::answer(c.ball, c.polygon);
    const auto family = static_cast<std::size_t>(c.family);
    touching[family] += answer.relation == Relation::Touching ? 1 : 0;
    separate[family] += answer.relation == Relation::Separate ? 1 : 0;
    overlapping[family] += answer.relation == Relation::Overlapping ? 1 : 0;
    boundary[family] += answer.foot == PointLocation::Boundary ? 1 : 0;
  }
  for (const adversarial::Family family : adversarial::all_families()) {
    const auto f = static_cast<std::size_t>(family);
    EXPECT_GT(separate[f], 10U) << to_string(family);
    EXPECT_GT(overlapping[f], 10U) << to_string(family);
  }
  for (const adversarial::Family family :
       {adversarial::Family::Lattice, adversarial::Family::Tangent, adversarial::Family::Point,
        adversarial::Family::Exponents, adversarial::Family::Scaled, adversarial::Family::Outline})
    EXPECT_GT(touching[static_cast<std::size_t>(family)], 10U) << to_string(family);
  for (const adversarial::Family family : {adversarial::Family::Lattice, adversarial::Family::Tangent,
                                           adversarial::Family::Foot, adversarial::Family::Point})
    EXPECT_GT(boundary[static_cast<std::size_t>(family)], 10U) << to_string(family);
}

/// The arguments of a question in which a number is below 2^-970, or above 2^970: bits of the two.
class Extremes {
 public:
  void add(const std::string& argument, double number) {
    const double size = std::abs(number);
    seen_[argument] |= (size > 0 && size < 0x1p-970 ? 1 : 0) | (size > 0x1p970 ? 2 : 0);
  }
  void add(const std::string& argument, const Eigen::Vector3d& point) {
    for (int axis = 0; axis < 3; ++axis) add(argument + " " + "xyz"[axis], point[axis]);
  }
  void expect_all(std::size_t arguments) const {
    EXPECT_EQ(seen_.size(), arguments);
    for (const auto& [argument, seen] : seen_) EXPECT_EQ(seen, 3) << argument;
  }

 private:
  std::map<std::string, int> seen_;
};

TEST(SoakCases, HaveExtremeNumbersInEveryArgument) {
  Extremes of_triangles, of_outlines;
  for (std::uint64_t index = 0; index < 5000; ++index) {
    const auto c = adversarial::draw_extreme_case(6, index);
    if (!c) continue;
    EXPECT_FALSE(find_fault(c->ball)) << "index " << index;
    EXPECT_FALSE(exact::validate(c->polygon)) << "index " << index;
    Extremes& extremes = c->triangle() ? of_triangles : of_outlines;
    for (std::size_t i = 0; i < 3; ++i) extremes.add("vertex " + std::to_string(i), c->polygon.vertex(i));
    extremes.add("centre", c->ball.center);
    extremes.add("radius", c->ball.radius);
    const Motion motion = adversarial::draw_extreme_motion(*c, 6, index);
    EXPECT_FALSE(find_fault(motion)) << "index " << index;
    extremes.add("start", motion.ball.center);
    extremes.add("end", motion.to);
    extremes.add("moving radius", motion.ball.radius);
  }
  for (const Extremes* extremes : {&of_triangles, &of_outlines}) extremes->expect_all(20);
}

TEST(Soak, CountsEveryCaseOnceEachWay) {
  const Tally tally = whole({.cases = 2000, .seed = 4});
  std::uint64_t triangles = 0, prepared = 0, answers = 0, solids = 0, touching = 0, extreme = 0;
  for (const adversarial::Family family : adversarial::all_families()) {
    for (const Way way : kWays) {
      const Outcomes& o = tally.at(family, way);
      std::uint64_t sum = 0;
      for (const std::uint64_t count : o.by_stage) sum += count;
      EXPECT_EQ(sum, o.cases) << to_string(family) << " " << to_string(way);
    }
    triangles += tally.at(family, Way::Triangle).cases;
    prepared += tally.at(family, Way::Prepared).cases;
    answers += tally.at(family, Way::Answer).cases;
    solids += tally.at(family, Way::Solid).cases;
    touching += tally.at(family, Way::Touching).cases;
    extreme += tally.at(family, Way::Extreme).cases;
  }
  EXPECT_EQ(tally.cases(), 2000U);
  EXPECT_EQ(prepared, 2000U);
  EXPECT_GE(triangles, 1800U);
  EXPECT_GT(answers, 60U);
  EXPECT_LT(answers, 240U);
  EXPECT_GT(solids, 50U);
  EXPECT_GT(touching, 50U);
  EXPECT_GT(extreme, 50U);
  EXPECT_EQ(tally.differing(), 0U);
}

/// Touching does not count, in one overload.
class StrictTriangle : public SystemUnderTest {
  using SystemUnderTest::contact;
  bool contact(const Ball& ball, const Triangle& t) const override {
    return exact::relation(ball, Polygon({t.a, t.b, t.c})) == Relation::Overlapping;
  }
};

/// The last lane of a batch is forgotten.
class ForgetfulBatch : public SystemUnderTest {
  using SystemUnderTest::contact;
  void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) const override {
    SystemUnderTest::contact(ball, triangles.first(triangles.size() - 1), touches.first(touches.size() - 1));
    touches.back() = false;
  }
};

class StrictBatchOfBalls : public SystemUnderTest {
  using SystemUnderTest::contact;
  void contact(std::span<const Ball> balls, const Prepared& polygon, std::span<bool> touches) const override {
    for (std::size_t i = 0; i < balls.size(); ++i) touches[i] = relation(balls[i], polygon) == Relation::Overlapping;
  }
};

class SwappedSides : public SystemUnderTest {
  PlaneSide plane_side(const Ball& ball, const Prepared& polygon) const override {
    const PlaneSide side = SystemUnderTest::plane_side(ball, polygon);
    return side == PlaneSide::InFront ? PlaneSide::Behind : side;
  }
};

class UnroundedDistance : public SystemUnderTest {
  using SystemUnderTest::answer;
  Answer answer(const Ball& ball, const Prepared& polygon) const override {
    Answer answer = SystemUnderTest::answer(ball, polygon);
    answer.distance = std::nextafter(answer.distance, 0.0);
    return answer;
  }
};

class FarthestVertex : public SystemUnderTest {
  filtered::ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) const override {
    filtered::ClosestPoint closest = SystemUnderTest::closest(center, triangle);
    if (closest.feature.kind == Feature::Kind::Vertex) closest.feature.index = (closest.feature.index + 1) % 3;
    return closest;
  }
};

class NoBoundary : public SystemUnderTest {
  PointLocation foot(const Ball& ball, const Prepared& polygon) const override {
    const PointLocation place = SystemUnderTest::foot(ball, polygon);
    return place == PointLocation::Boundary ? PointLocation::Inside : place;
  }
};

class FirstEdgeOnly : public SystemUnderTest {
  std::vector<std::size_t> edges_hit(const Ball& ball, const Prepared& polygon) const override {
    auto edges = SystemUnderTest::edges_hit(ball, polygon);
    if (edges.size() > 1) edges.erase(edges.begin() + 1, edges.end());
    return edges;
  }
};

/// Points of the surface are inside.
class OpenSolid : public SystemUnderTest {
  PointLocation locate(const scene::Solid& solid, const Eigen::Vector3d& point) const override {
    const PointLocation where = SystemUnderTest::locate(solid, point);
    return where == PointLocation::Boundary ? PointLocation::Inside : where;
  }
};

class UnsignedDistance : public SystemUnderTest {
  double signed_distance(const scene::Solid& solid, const Eigen::Vector3d& point) const override {
    return std::abs(SystemUnderTest::signed_distance(solid, point));
  }
};

class Throwing : public SystemUnderTest {
  using SystemUnderTest::contact;
  bool contact(const Ball& ball, const Triangle& triangle) const override {
    const auto first = triangle.a.array().abs();
    const bool extreme = (first < 0x1p-60).any() || (first > 0x1p60).any();
    if (ball.radius == 0 && !extreme) throw std::length_error("no points, please");
    return SystemUnderTest::contact(ball, triangle);
  }
};

/// Grazing does not count, of triangles.
class NoGraze : public SystemUnderTest {
  using SystemUnderTest::contact;
  bool contact(const Motion& motion, const Triangle& triangle) const override {
    return !first_contact(motion, triangle).momentary && SystemUnderTest::contact(motion, triangle);
  }
};

class UnroundedTime : public SystemUnderTest {
  using SystemUnderTest::first_contact;
  FirstContact first_contact(const Motion& motion, const Prepared& polygon) const override {
    FirstContact first = SystemUnderTest::first_contact(motion, polygon);
    if (first.kind == FirstContactKind::Way) first.time = std::nextafter(first.time, 1.0);
    return first;
  }
};

class ForwardsOnly : public SystemUnderTest {
  using SystemUnderTest::contact;
  void contact(std::span<const Motion> motions, const Prepared& polygon, std::span<bool> touches) const override {
    for (std::size_t i = 0; i < motions.size(); ++i)
      touches[i] = SystemUnderTest::contact(motions[i].ball, polygon);  // at the start alone
  }
};

class PlainWithoutEnd : public SystemUnderTest {
  using SystemUnderTest::plain_contact;
  bool plain_contact(const Motion& motion, const Prepared& polygon) const override {
    const FirstContact first = SystemUnderTest::plain_first_contact(motion, polygon);
    return first.contact() && first.time < 1;
  }
};

/// What is extreme is flushed to zero.
class Flushed : public SystemUnderTest {
  using SystemUnderTest::first_contact;
  static Eigen::Vector3d flushed(const Eigen::Vector3d& normal) {
    return normal.unaryExpr([](double x) { return std::abs(x) < 0x1p-970 ? 0 : x; });
  }
  filtered::ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) const override {
    filtered::ClosestPoint closest = SystemUnderTest::closest(center, triangle);
    closest.contact_normal = flushed(closest.contact_normal);
    return closest;
  }
  FirstContact first_contact(const Motion& motion, const Triangle& triangle) const override {
    FirstContact first = SystemUnderTest::first_contact(motion, triangle);
    first.contact_normal = flushed(first.contact_normal);
    return first;
  }
};

/// Is the error found, and told as a case that the judge reads, with the exact answer expected?
void expect_found(const SystemUnderTest& wrong, const std::string& question, Asked asked = Asked::Rest) {
  const bool moving = asked == Asked::Motion;
  const Settings settings{.cases = moving ? 600U : 3000U, .seed = 9, .asked = asked};
  const Tally tally = whole(settings, wrong);
  EXPECT_GT(tally.differing(), 0U) << question;
  ASSERT_FALSE(tally.kept().empty()) << question;
  for (const Difference& difference : tally.kept()) {
    const cases::Case read = cases::read_case(difference.line);
    ASSERT_TRUE(std::holds_alternative<cases::Shapes>(read.content)) << difference.line;
    const std::string before = "soak-s9-i";
    ASSERT_EQ(read.id->rfind(before, 0), 0U) << difference.line;
    EXPECT_EQ(std::stoull(read.id->substr(before.size())), difference.index) << difference.line;
    EXPECT_NE(difference.line.find("\"" + question), std::string::npos) << difference.line;
    const auto& shapes = std::get<cases::Shapes>(read.content);
    const Answer still = exact::answer(shapes.ball(), shapes.polygon);
    EXPECT_EQ(shapes.motion() != nullptr, moving) << difference.line;
    const auto truth =
        moving ? cases::PartialAnswer::of(exact::first_contact(*shapes.motion(), shapes.polygon), still.off_plane, "")
               : cases::PartialAnswer::of(still, "");
    EXPECT_TRUE(cases::differences(*read.expected, truth).empty()) << difference.line;
  }
  // Asked again by its index alone, the first one differs again.
  const std::uint64_t index = tally.kept().front().index;
  EXPECT_EQ(whole({.cases = 1, .seed = 9, .from = index, .asked = asked}, wrong).kept().front(), tally.kept().front());
}

TEST(Soak, FindsPlantedErrors) {
  expect_found(StrictTriangle(), "triangle");
  expect_found(ForgetfulBatch(), "triangle, in a batch");
  expect_found(StrictBatchOfBalls(), "contact, in a batch");
  expect_found(SwappedSides(), "plane");
  expect_found(UnroundedDistance(), "answer");
  expect_found(FarthestVertex(), "closest");
  expect_found(NoBoundary(), "foot");
  expect_found(FirstEdgeOnly(), "edges_hit");
  expect_found(OpenSolid(), "solid, location");
  expect_found(UnsignedDistance(), "solid, distance");
  expect_found(Throwing(), "triangle: no points, please");
  expect_found(Flushed(), "closest");
}

TEST(Soak, FindsPlantedErrorsOfMovingBalls) {
  expect_found(NoGraze(), "contact", Asked::Motion);
  expect_found(UnroundedTime(), "first contact", Asked::Motion);
  expect_found(ForwardsOnly(), "contact, in a batch", Asked::Motion);
  expect_found(PlainWithoutEnd(), "contact, without vectors", Asked::Motion);
  expect_found(Flushed(), "first contact", Asked::Motion);
}

TEST(Soak, CountsEveryMovingCaseOnceEachWay) {
  const Tally tally = whole({.cases = 500, .seed = 4, .asked = Asked::Motion});
  std::uint64_t triangles = 0, prepared = 0, still = 0;
  for (const adversarial::Family family : adversarial::all_families()) {
    triangles += tally.at(family, Way::MovingTriangle).cases;
    prepared += tally.at(family, Way::MovingPrepared).cases;
    still += tally.at(family, Way::Prepared).cases;
  }
  EXPECT_EQ(tally.cases(), 500U);
  EXPECT_EQ(prepared, 500U);
  EXPECT_GE(triangles, 450U);
  EXPECT_EQ(still, 0U);
  EXPECT_EQ(tally.differing(), 0U);
}

// Hard where they say so: balls graze, start in contact and miss, by a double or at rest.
TEST(SoakCases, MoveAcrossTheirThresholds) {
  std::uint64_t start = 0, way = 0, none = 0, momentary = 0, rest = 0;
  for (std::uint64_t index = 0; index < 1000; ++index) {
    const adversarial::Case c = adversarial::draw_case(3, index);
    const Motion motion = adversarial::draw_motion(c, 3, index), again = adversarial::draw_motion(c, 3, index);
    ASSERT_FALSE(find_fault(motion)) << index;
    EXPECT_EQ(motion.to, again.to) << index;
    EXPECT_EQ(motion.ball.radius, again.ball.radius) << index;
    const FirstContact first = exact::first_contact(motion, c.polygon);
    start += first.kind == FirstContactKind::Start ? 1 : 0;
    way += first.kind == FirstContactKind::Way ? 1 : 0;
    none += first.kind == FirstContactKind::None ? 1 : 0;
    momentary += first.momentary ? 1 : 0;
    rest += motion.to == motion.ball.center ? 1 : 0;
  }
  for (const std::uint64_t count : {start, way, none}) EXPECT_GT(count, 100U);
  EXPECT_GT(momentary, 3U);
  EXPECT_GT(rest, 30U);
}

// Only the first ones are kept; the count continues.
TEST(Soak, KeepsTheFirstDifferences) {
  Tally tally;
  for (std::uint64_t i = 3000; i-- > 0;) tally.add_case({{i, "a"}, {i, "b"}});
  EXPECT_EQ(tally.differing(), 3000U);
  ASSERT_EQ(tally.kept().size(), Tally::kMostKept);
  for (std::size_t k = 0; k < tally.kept().size(); ++k)
    EXPECT_EQ(tally.kept()[k], (Difference{k / 2, k % 2 == 0 ? "a" : "b"}));
}

TEST(Soak, TheNumberOfThreadsChangesNothing) {
  const StrictTriangle wrong;
  const Settings one{.cases = 3000, .seed = 6, .threads = 1}, three{.cases = 3000, .seed = 6, .threads = 3};
  EXPECT_EQ(whole(one, wrong), whole(three, wrong));
}

TEST(Soak, PartsAddUpToOneRun) {
  const StrictTriangle wrong;
  const Settings settings{.cases = 3000, .seed = 8, .from = 1'000'000, .threads = 2};
  Tally sum;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    Tally part;
    run_campaign(settings, wrong, {kNeverStop, kSilent, {number, 3}}, part);
    sum += part;
  }
  EXPECT_EQ(sum, whole(settings, wrong));
}

TEST(Soak, TellsOfEveryDifferenceAtOnce) {
  std::atomic<std::uint64_t> told = 0;
  Tally tally;
  run_campaign({.cases = 3000, .seed = 6, .threads = 2}, StrictTriangle(), {kNeverStop, kSilent}, tally,
               [&](const Difference&) { ++told; });
  EXPECT_GT(told, 0U);
  EXPECT_EQ(told, tally.kept().size());
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::soak_command, std::move(arguments));
}

TEST(SoakCommand, PrintsTheCasesThatItWouldAsk) {
  const auto ran =
      run_tests::run_captured(commands::soak_command, {"--seed", "2", "--from", "7", "--samples", "5", "--print"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  std::istringstream lines(ran.out);
  std::string line;
  for (std::uint64_t index = 7; index < 12; ++index) {
    ASSERT_TRUE(std::getline(lines, line));
    const cases::Case read = cases::read_case(line);
    const adversarial::Case drawn = adversarial::draw_case(2, index);
    EXPECT_EQ(read.id, "soak-s2-i" + std::to_string(index));
    const auto& shapes = std::get<cases::Shapes>(read.content);
    EXPECT_EQ(shapes.ball().center, drawn.ball.center);
    EXPECT_EQ(shapes.ball().radius, drawn.ball.radius);
    EXPECT_EQ(shapes.polygon, drawn.polygon);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(SoakCommand, PrintsMotionsThatItWouldAsk) {
  const auto ran = run_tests::run_captured(commands::soak_command,
                                           {"--seed", "2", "--from", "7", "--samples", "1", "--print", "--moving"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto shapes = std::get<cases::Shapes>(cases::read_case(ran.out.substr(0, ran.out.find('\n'))).content);
  const Motion drawn = adversarial::draw_motion(adversarial::draw_case(2, 7), 2, 7);
  ASSERT_TRUE(shapes.motion());
  EXPECT_EQ(shapes.motion()->ball.center, drawn.ball.center);
  EXPECT_EQ(shapes.motion()->to, drawn.to);
}

TEST(SoakCommand, OptionsThatMeanNothingToPrintedCasesAreErrorsThatNameThem) {
  for (const std::vector<std::string>& option :
       {{"--threads", "1"}, {"--output", "folder"}, std::vector<std::string>{"--force"}}) {
    std::vector<std::string> words{"--samples", "1", "--print"};
    words.insert(words.end(), option.begin(), option.end());
    const std::string said = run_tests::message_of<program::UsageError>([&] { run_command(words); });
    EXPECT_NE(said.find(option.front() + " excludes --print"), std::string::npos) << said;
  }
}

TEST(SoakCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_command({"--from", "1.5"}), program::UsageError);
  EXPECT_THROW(run_command({"--from", "18446744073709551615", "--samples", "2"}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::soak
