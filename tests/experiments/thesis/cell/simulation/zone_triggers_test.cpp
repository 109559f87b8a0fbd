// SPDX-License-Identifier: GPL-3.0-or-later
// Virtual objects notice what comes into them, between the stops, too, and stop nothing unless they are to.
#include "experiments/thesis/cell/simulation/zone_triggers.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

std::string zone(const std::string& shape, bool stops = false) {
  return fmt::format(R"(zones[0]={{"name": "z", {}, "stops": {}}})", shape, stops);
}

/// On the way of the virtual sphere from home to the storage, that number of degrees from home.
Eigen::Vector3d on_the_way(double degrees) {
  const Workcell workcell = aristo();
  const Process process = simulate(workcell);
  kinematics::Angles angles = process.stops[3].commanded;  // the elbow has moved
  angles[kBase] -= degrees;
  return workcell.arm().sphere_at(angles).center;
}

const Trigger* first(const Process& process, Mover mover) {
  const auto found = std::ranges::find(process.triggers, mover, &Trigger::mover);
  return found == process.triggers.end() ? nullptr : &*found;
}

// The moment is that at which the distances say so: the sphere of radius 6 comes within 6 + r of a point of its own
// arc.
TEST(Zones, ASphereIsEnteredWhereItsDistanceSays) {
  const Eigen::Vector3d at = on_the_way(60);
  for (const double radius : {0.001, 5.0, 40.0}) {
    const Workcell workcell = aristo(
        {zone(fmt::format(R"("sphere": {{"at": [{}, {}, {}], "radius": {}}})", at.x(), at.y(), at.z(), radius))});
    const Process process = simulate(workcell);
    EXPECT_EQ(process.failure, "");
    const Trigger* trigger = first(process, Mover::Sphere);
    ASSERT_NE(trigger, nullptr);
    const double arm = std::hypot(at.x(), at.y());
    const double before = 2 * std::asin((6 + radius) / 2 / arm) * 57.29577951308232;
    const double entered = static_cast<double>(trigger->after - 3) + trigger->degrees;
    EXPECT_LE(entered, 60 - before + 1e-6);
    EXPECT_GT(entered, 60 - before - 0.05);
    EXPECT_EQ(trigger->until, 3 + static_cast<std::size_t>(std::ceil(60 + before))) << radius;
  }
}

// A point between two stops: the sphere is at neither of them near it.
TEST(Zones, NothingSlipsThroughBetweenTheStops) {
  kinematics::Angles angles = aristo().arm().home;  // steps of 10 degrees leave the elbow there
  angles[kBase] -= 65;
  const Eigen::Vector3d at = aristo().arm().sphere_at(angles).center;
  const Workcell workcell = aristo(
      {"step=10", zone(fmt::format(R"("sphere": {{"at": [{}, {}, {}], "radius": 0.01}})", at.x(), at.y(), at.z()))});
  const Process process = simulate(workcell, {.last = Phase::ToStorage, .sphere_alone = true, .finds_ways = false});
  const Trigger* trigger = first(process, Mover::Sphere);
  ASSERT_NE(trigger, nullptr);
  for (const Stop& stop : process.stops) EXPECT_GT((stop.sphere.center - at).norm(), 6.01 + 20);
  EXPECT_EQ(trigger->until, trigger->after + 1);
}

// What wholly contains the arm is entered at home and never left; what nothing comes near to is silent.
TEST(Zones, BoxesAreSolid) {
  const Process inside = simulate(aristo({zone(R"("box": {"from": [-2000, -2000, -1], "to": [2000, 2000, 2000]})")}));
  ASSERT_EQ(inside.triggers.size(), 4U);  // the arm, the sphere, and the material whenever it is held
  for (const Mover mover : {Mover::Arm, Mover::Sphere}) {
    EXPECT_EQ(first(inside, mover)->after, 0U);
    EXPECT_EQ(first(inside, mover)->degrees, 0);
    EXPECT_EQ(first(inside, mover)->until, inside.stops.size() - 1);
  }
  EXPECT_EQ(first(inside, Mover::Held)->part, "material");
  EXPECT_TRUE(simulate(aristo({zone(R"("capsule": {"from": [0, 0, 2000], "to": [0, 0, 3000], "radius": 300})")}))
                  .triggers.empty());
}

TEST(Zones, OneThatIsToStopTheRobotDoes) {
  const Eigen::Vector3d at = on_the_way(60);
  const std::string shape =
      fmt::format(R"("capsule": {{"from": [{0}, {1}, 0], "to": [{0}, {1}, 900], "radius": 10}})", at.x(), at.y());
  const Process free = simulate(aristo({zone(shape)})), stopped = simulate(aristo({zone(shape, true)}));
  EXPECT_EQ(free.failure, "");
  ASSERT_FALSE(free.triggers.empty());
  const Trigger& trigger = free.triggers.front();
  EXPECT_NE(stopped.failure.find("comes into the zone z, which stops the robot"), std::string::npos) << stopped.failure;
  EXPECT_EQ(stopped.cause, FailureCause::InTheWay);
  ASSERT_EQ(stopped.stops.size(), trigger.after + 1);
  for (std::size_t i = 0; i < stopped.stops.size(); ++i) EXPECT_EQ(stopped.stops[i].commanded, free.stops[i].commanded);
  EXPECT_EQ(stopped.moves.size(), 1U);  // the elbow's; that of the base is not completed
  ASSERT_TRUE(stopped.stuck);
  EXPECT_EQ(stopped.stuck->parts.back(), "z");
}

TEST(Zones, TheThesissRuleTestsTheSphereAlone) {
  const Process process = simulate(aristo({zone(R"("box": {"from": [-2000, -2000, -1], "to": [2000, 2000, 2000]})")}),
                                   {.sphere_alone = true});
  ASSERT_EQ(process.triggers.size(), 1U);
  EXPECT_EQ(process.triggers.front().mover, Mover::Sphere);
}

}  // namespace
}  // namespace touchstone::cell
