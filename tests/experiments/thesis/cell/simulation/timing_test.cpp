// SPDX-License-Identifier: GPL-3.0-or-later
// The time of a cycle: moves from rest to rest within speeds and accelerations, and the waits that the cell states.
#include "experiments/thesis/cell/simulation/timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

using Changes = std::vector<std::string>;

const Changes kSpeeds{R"(robot.speeds={"base": 50, "shoulder": 40, "elbow": 20, "wrist_pitch": 10})"};
const Changes kAccelerations{
    R"(robot.accelerations={"base": 100, "shoulder": 200, "elbow": 50, "wrist_roll": 100, "wrist_pitch": 120,
       "hand_roll": 100})"};
const Changes kWaits{"gripper.grip_seconds=0.5", "gripper.release_seconds=0.25", "material.milling_seconds=30"};

Changes both(Changes some, const Changes& others) {
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

double seconds(const Arm& arm, const Step& step) { return pace_of(arm, step).value().seconds; }

/// A process of one move of a joint, in steps of one degree.
Process one_move(const Workcell& workcell, Moved joint, int degrees) {
  Process process;
  for (int i = 0; i <= std::abs(degrees); ++i) {
    kinematics::Angles angles = workcell.arm().home;
    angles[joint] += degrees < 0 ? -i : i;
    process.stops.push_back({0, angles, workcell.arm().sphere_at(angles), {}, {}});
  }
  const double whole = degrees;
  process.moves.push_back({Phase::ToStorage, joint, Until::Planned, whole, whole, 0, {}, {}});
  process.transfers.push_back({0, StationSlot::Storage, 0, 0, {}});
  return process;
}

TEST(CycleTime, IsThatOfTheSlowestJointThatTurns) {
  const Workcell workcell = aristo(kSpeeds);
  const Arm& arm = workcell.arm();
  EXPECT_DOUBLE_EQ(seconds(arm, step_of(kBase, -100)), 2);
  // The elbow makes up for the shoulder, the wrist for the elbow.
  EXPECT_DOUBLE_EQ(seconds(arm, step_of(kShoulder, 40)), 2);
  EXPECT_DOUBLE_EQ(seconds(arm, step_of(kElbow, 40)), 4);
}

TEST(CycleTime, WithoutAccelerationsIsTheSumOfAllStepsAtTheGreatestSpeed) {
  const Workcell workcell = aristo(kSpeeds);
  const Process process = simulate(workcell);
  const Timing timing(workcell, process);
  ASSERT_EQ(timing.arrivals().size(), process.stops.size());
  double sum = 0;
  for (std::size_t i = 1; i < process.stops.size(); ++i) {
    sum += seconds(workcell.arm(), step_between(process.stops[i - 1], process.stops[i]));
    EXPECT_NEAR(timing.arrivals()[i], sum, 1e-9);
  }
  EXPECT_NEAR(timing.cycle().value(), sum, 1e-9);
  EXPECT_TRUE(
      timing.text().ends_with(": every turn as fast as its joints allow; without gripping, releasing, milling"));
}

TEST(CycleTime, IsUnknownWithoutASpeed) {
  const Workcell workcell = aristo({"robot.speeds.wrist_pitch=null"});
  EXPECT_TRUE(pace_of(workcell.arm(), step_of(kBase, 1)));
  EXPECT_FALSE(pace_of(workcell.arm(), step_of(kElbow, 1)));
  const Process process = simulate(workcell);
  const Timing timing(workcell, process);
  EXPECT_TRUE(timing.arrivals().empty());
  EXPECT_FALSE(timing.cycle());
  EXPECT_FALSE(timing.after(1, 0.5));
  for (std::size_t i = 0; i < process.moves.size(); ++i)
    if (process.moves[i].rise == 0) {
      EXPECT_EQ(timing.move(i).has_value(), process.moves[i].joint != kElbow) << i;
    }
  EXPECT_EQ(timing.text(), "no cycle time: the greatest speed of a joint is unknown");
}

// d / v + v / a, or 2 sqrt(d / a) where the speed is not reached: here v^2 / a is 25 degrees.
TEST(CycleTime, OfAMoveIsTrapezoidalOrTriangular) {
  const Workcell workcell = aristo(both(kSpeeds, kAccelerations));
  for (const int degrees : {1, -2, 12, 24, 25, -26, 80}) {
    const Process process = one_move(workcell, kBase, degrees);
    const double d = std::abs(degrees), v = 50, a = 100;
    const double expected = d >= v * v / a ? d / v + v / a : 2 * std::sqrt(d / a);
    const Timing timing(workcell, process);
    EXPECT_NEAR(timing.move(0).value(), expected, 1e-9) << degrees;
    EXPECT_NEAR(timing.cycle().value(), expected, 1e-9) << degrees;
    // After t seconds of speeding up it has gone a t^2 / 2; braking mirrors that.
    for (std::size_t i = 0; i < process.stops.size(); ++i) {
      const double gone = static_cast<double>(i), less = std::min(gone, d - gone);
      const double up = std::min(v / a, std::sqrt(d / a)),
                   since = less <= a * up * up / 2 ? std::sqrt(2 * less / a) : up + (less - a * up * up / 2) / v;
      EXPECT_NEAR(timing.arrivals()[i], gone <= d / 2 ? since : expected - since, 1e-9) << degrees << " " << i;
    }
  }
}

// The slowest joint keeps the others to its profile: the elbow turns the wrist, which is slow but quick to its speed.
TEST(CycleTime, OfAMoveIsThatOfTheSlowestSpeedAndTheSlowestAcceleration) {
  const Workcell workcell = aristo(both(kSpeeds, kAccelerations));
  const Pace pace = pace_of(workcell.arm(), step_of(kElbow, 30)).value();
  EXPECT_DOUBLE_EQ(pace.seconds, 3);  // the wrist's 10 degrees per second
  EXPECT_DOUBLE_EQ(pace.ramp, 0.2);   // the elbow's 50 degrees per second squared to the same 10
  EXPECT_NEAR(Timing(workcell, one_move(workcell, kElbow, 30)).move(0).value(), 3.2, 1e-9);
}

// Where the proportion of the joints changes, the slowest acceleration of all steps counts, in either order.
TEST(CycleTime, OfAStraightMoveIsThatOfItsSlowestAcceleration) {
  const Workcell workcell = aristo(both(kSpeeds, kAccelerations));
  const Pace shoulder = pace_of(workcell.arm(), step_of(kShoulder, 30)).value(),
             elbow = pace_of(workcell.arm(), step_of(kElbow, 30)).value();
  ASSERT_GT(shoulder.ramp, elbow.ramp);
  for (const Moved first : {kShoulder, kElbow}) {
    Process process = one_move(workcell, first, 1);
    process.stops.push_back(process.stops.back());
    process.stops[1].commanded[first] = process.stops[2].commanded[first] = workcell.arm().home[first] + 30;
    process.stops[2].commanded[first == kShoulder ? kElbow : kShoulder] += 30;
    const SpeedProfile whole{shoulder.seconds + elbow.seconds, shoulder.ramp};
    EXPECT_NEAR(Timing(workcell, process).move(0).value(), whole.seconds(), 1e-9) << first;
  }
}

class TimedRun : public testing::Test {
 protected:
  const Workcell workcell = aristo(both(both(kSpeeds, kAccelerations), kWaits));
  const Process process = simulate(workcell);
  const Timing timing{workcell, process};
};

TEST_F(TimedRun, IsTheSumOfItsMovesAndWaits) {
  double sum = 2 * 0.5 + 2 * 0.25 + 30;
  EXPECT_NEAR(std::accumulate(timing.waits().begin(), timing.waits().end(), 0.0), sum, 1e-12);
  for (std::size_t i = 0; i < process.moves.size(); ++i) sum += timing.move(i).value();
  EXPECT_NEAR(timing.cycle().value(), sum, 1e-9);
  EXPECT_TRUE(
      timing.text().ends_with(" s: every move from rest to rest as fast as the speeds and accelerations of its joints "
                              "allow; gripping 1 s; releasing 0.5 s; milling 30 s"))
      << timing.text();
}

TEST_F(TimedRun, WaitsWhereItGripsReleasesAndMills) {
  std::vector<double> waits(process.stops.size(), 0);
  for (std::size_t i = 1; i < process.transfers.size(); ++i)
    waits[process.transfers[i].stop] += process.transfers[i].slot ? 0.25 : 0.5;
  for (std::size_t i = 1; i < process.stops.size(); ++i)
    if (process.stops[i].move != process.stops[i - 1].move &&
        process.moves[process.stops[i].move].phase == Phase::ToPiece &&
        process.moves[process.stops[i - 1].move].phase == Phase::Withdraw)
      waits[i - 1] += 30;
  EXPECT_EQ(timing.waits(), waits);
  for (std::size_t i = 0; i + 1 < waits.size(); ++i)
    if (waits[i] > 0) {
      EXPECT_GE(timing.arrivals()[i + 1], timing.arrivals()[i] + waits[i]) << i;
    }
}

TEST_F(TimedRun, Ascends) {
  double last = 0;
  for (std::size_t i = 0; i + 1 < process.stops.size(); ++i) {
    EXPECT_EQ(timing.after(i, 0), timing.arrivals()[i]);
    EXPECT_LE(last, timing.arrivals()[i] + 1e-12) << i;
    last = timing.arrivals()[i];
    const double degrees = std::abs(step_between(process.stops[i], process.stops[i + 1]).degrees);
    for (const double share : {0.01, 0.5, 0.99}) {
      const double here = timing.after(i, share * degrees).value();
      EXPECT_GT(here, last) << i << " " << share;
      EXPECT_EQ(timing.after(i, -share * degrees), here);
      last = here;
    }
    EXPECT_NEAR(timing.after(i, degrees).value(), timing.arrivals()[i + 1], 1e-9) << i;
  }
  EXPECT_EQ(timing.after(process.stops.size() - 1, 0), timing.arrivals().back());
}

// Of three stops a move's speeds, and of these its accelerations, are not beyond those that are stated.
TEST_F(TimedRun, KeepsToSpeedsAndAccelerations) {
  const Arm& arm = workcell.arm();
  for (std::size_t i = 1; i < process.stops.size(); ++i) {
    const auto before = arm.chain.turns(process.stops[i - 1].commanded),
               here = arm.chain.turns(process.stops[i].commanded);
    const bool starts = i == 1 || process.stops[i].move != process.stops[i - 1].move;
    const double taken = timing.arrivals()[i] - timing.arrivals()[i - 1] - timing.waits()[i - 1];
    for (std::size_t joint = 0; joint < here.size(); ++joint) {
      const double way = std::abs(here[joint] - before[joint]);
      EXPECT_LE(way, arm.speeds[joint] * taken + 1e-9) << i;
      if (starts) {
        EXPECT_LE(way, arm.accelerations[joint] * taken * taken / 2 + 1e-9) << i << " " << joint;
      }
    }
  }
}

TEST(CycleTime, OfARunThatDoesNotComeToTheMilledPieceHasNoMilling) {
  const Workcell workcell = aristo(kWaits);
  const Timing timing(workcell, simulate(workcell, {.last = Phase::Withdraw}));
  EXPECT_NEAR(std::accumulate(timing.waits().begin(), timing.waits().end(), 0.0), 0.75, 1e-12);
  EXPECT_EQ(Timing(workcell, Process{}).text(), "no cycle time: no stops");
}

// With the sphere alone the material is in its place at once, and the run may end there.
TEST(CycleTime, EndsOnceTheLastWaitIsOver) {
  const Workcell workcell = aristo(kWaits);
  const Process process = simulate(workcell, {.last = Phase::ToMachine, .sphere_alone = true});
  const Timing timing(workcell, process);
  ASSERT_EQ(process.transfers.back().stop + 1, process.stops.size());
  EXPECT_NEAR(timing.cycle().value(), timing.arrivals().back() + 0.25, 1e-12);
}

TEST(CycleTime, SaysWhichJointsHaveTheirSpeedAtOnce) {
  const Workcell workcell = aristo({R"(robot.accelerations={"base": 100})"});
  const Timing timing(workcell, one_move(workcell, kBase, 10));
  EXPECT_NE(timing.text().find("; a joint without a stated acceleration has its speed at once;"), std::string::npos)
      << timing.text();
}

}  // namespace
}  // namespace touchstone::cell
