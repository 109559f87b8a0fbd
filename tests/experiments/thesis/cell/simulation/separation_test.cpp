// SPDX-License-Identifier: GPL-3.0-or-later
// Least distances: certified from below at every angle, attained where they are said to be.
#include "experiments/thesis/cell/simulation/separation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

/// The distance of a mover from an element on the way after a stop, by all its parts, with the material where it is in
/// a state; infinite if one is not there.
double distance_in(const Workcell& workcell, const Process& process, Mover mover, const std::string& element,
                   std::size_t stop, double degrees, const MaterialTransfer& state) {
  const Arm& arm = workcell.arm();
  kinematics::Angles angles = process.stops[stop].commanded;
  if (degrees != 0)
    angles = step_between(process.stops[stop], process.stops[stop + 1]).after(angles, std::abs(degrees));
  const auto links = arm.link_poses(angles);
  std::vector<NamedTriangle> standing;
  for (const auto& each : workcell.standing_parts())
    if (workcell.names()[each.owner] == element) standing.push_back(each);
  if (state.lies && element == "the material in the " + std::string(to_string(*state.slot)))
    for (const auto& [t, owner] : workcell.material()) {
      const Pose& lies = state.lies->pose;
      standing.push_back({{lies * t.a, lies * t.b, lies * t.c}, owner});
    }
  std::optional<TriangleTree> still;
  if (!standing.empty()) still.emplace(standing);
  double least = std::numeric_limits<double>::infinity();
  if (!still) return least;
  const auto take = [&](const std::vector<NamedTriangle>& triangles, const Pose& pose, double radius) {
    const auto bounds = distance(TriangleTree(triangles), pose, *still, 1e9);
    least = std::min(least, std::max(0.0, bounds.upper - radius));
  };
  if (mover == Mover::Arm) {
    for (const auto& part : workcell.covered())
      if (part.carrier == Carrier::Link && arm.links[part.link].frame) take(part.triangles, links[part.link], 0);
    take(workcell.gripper(), links.back(), 0);
    for (std::size_t i = 0; i < workcell.fingers().size(); ++i) {
      const double way = state.grip ? state.grip->fingers[i].way : 0;
      const Eigen::Vector3d shift = workcell.cell().gripper.fingers->shift(i, way);
      take(workcell.fingers()[i], within(links.back(), {Eigen::Matrix3d::Identity(), shift}), 0);
    }
  } else if (mover == Mover::Held) {
    if (state.in_flange) take(workcell.material(), within(links.back(), *state.in_flange), 0);
  } else {
    const Eigen::Vector3d c = arm.sphere.center;
    take({{{c, c, c}, 0}}, links.back(), arm.sphere.radius);
  }
  return least;
}

/// The same in the state on that way; at a stop before or after it, whichever is nearer.
double distance_at(const Workcell& workcell, const Process& process, Mover mover, const std::string& element,
                   std::size_t stop, double degrees) {
  const auto in = [&](std::size_t number) {
    return distance_in(workcell, process, mover, element, stop, degrees, process.holding(number));
  };
  return degrees != 0 ? in(stop + 1) : std::min(in(stop), in(stop + 1));
}

class Measured : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    workcell = new Workcell(aristo());
    process = new Process(simulate(*workcell));
    separation = new Separation(separation_of(*workcell, *process));
  }
  static void TearDownTestSuite() { delete separation, delete process, delete workcell; }

  static inline const Workcell* workcell = nullptr;
  static inline const Process* process = nullptr;
  static inline const Separation* separation = nullptr;
};
using SeparationTest = Measured;

TEST_F(SeparationTest, IsAttainedWhereItIsSaidToBeAndEnclosed) {
  ASSERT_GT(process->stops.size(), 100U);
  ASSERT_GT(separation->least.size(), 20U);
  bool between_stops = false;
  for (const auto& least : separation->least) {
    EXPECT_NEAR(distance_at(*workcell, *process, least.mover, least.element, least.stop, least.degrees),
                least.bounds.upper, 1e-9)
        << to_string(least.mover) << " " << least.element;
    EXPECT_LE(least.bounds.lower, least.bounds.upper);
    EXPECT_LE(least.bounds.upper - least.bounds.lower, separation->tolerance);
    between_stops |= least.degrees != 0;
  }
  EXPECT_TRUE(between_stops);
}

TEST_F(SeparationTest, NothingIsNearerAtAnyAngle) {
  std::map<std::pair<Mover, std::string>, double> lower;
  for (const auto& least : separation->least) lower[{least.mover, least.element}] = least.bounds.lower;
  workloads::Random random(7, 0);
  for (int i = 0; i < 150; ++i) {
    const std::size_t stop = below(random, process->stops.size() - 1);
    const auto step = step_between(process->stops[stop], process->stops[stop + 1]);
    const double degrees = step.degrees * between(random, 0.01, 0.99);
    for (const Mover mover : kMovers) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::string& element : separation->elements) {
        const double here = distance_at(*workcell, *process, mover, element, stop, degrees);
        nearest = std::min(nearest, here);
        if (std::isinf(here)) continue;
        ASSERT_TRUE(lower.contains({mover, element}));
        EXPECT_GE(here + 1e-9, lower.at({mover, element})) << to_string(mover) << " " << element << " " << stop;
      }
      const auto& said = separation->nearest[static_cast<std::size_t>(mover)][stop + 1];
      if (std::isinf(nearest)) continue;
      ASSERT_TRUE(said);
      EXPECT_GE(nearest + 1e-9, said->bounds.lower) << to_string(mover) << " " << stop;
      EXPECT_LE(said->bounds.upper - said->bounds.lower,
                std::max(separation->tolerance, 0.1 * said->bounds.upper) + 1e-9);
      const double here = distance_at(*workcell, *process, mover, separation->elements[said->element], stop + 1, 0);
      if (!std::isinf(here)) {  // else it is what lies there only from that stop on
        EXPECT_NEAR(here, said->here, 1e-9);
      }
    }
  }
}

// What touches as planned is at 0: the sphere at its contacts, the held part where it rests. The arm touches nothing.
TEST_F(SeparationTest, IsZeroWhereThePlanWantsContactAndNowhereElse) {
  for (const auto& least : separation->least) {
    const bool planned =
        (least.mover == Mover::Sphere && least.element.starts_with("the material")) ||
        (least.mover == Mover::Held && (least.element == "storage/deck" || least.element == "machine/vice"));
    EXPECT_EQ(least.bounds.lower == 0, planned) << to_string(least.mover) << " " << least.element;
  }
}

// A part that only the base turns stays as high as it is. Here the shoulder and the elbow take the sphere through the
// lowest place of its arc, where it is nearer to the floor than at both stops.
TEST(Separation, KnowsThatWhatIsAboveMayComeDown) {
  const Workcell workcell = aristo();
  const Process home = simulate(workcell, {.last = Phase::ToStorage});
  for (const auto& [joint, from] : {std::pair(kShoulder, 60.0), std::pair(kElbow, -120.0)}) {
    Process process;
    process.stops = {home.stops.front(), home.stops.front()};
    process.stops.front().commanded[joint] = from;
    process.stops.back().commanded[joint] = from + 60;
    process.transfers = {home.transfers.front()};
    for (const auto& least : separation_of(workcell, process).least)
      EXPECT_LE(least.bounds.lower, distance_at(workcell, process, least.mover, least.element, 0, 30) + 1e-9)
          << to_string(least.mover) << ' ' << least.element << ", from " << from << " degrees";
  }
}

}  // namespace
}  // namespace touchstone::cell
