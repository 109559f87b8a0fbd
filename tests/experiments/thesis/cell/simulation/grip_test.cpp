// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers close until they touch, on opposite faces, or it is said why not.
#include "experiments/thesis/cell/simulation/grip.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

/// The default gripper about a part that stands upright below it, 20 mm into the fingers, shifted and turned.
std::variant<Grip, std::string> grip(const std::string& solid, double x = 0, double y = 0, double degrees = 0) {
  static const std::vector<ModelPart> all = build_model(read_cell(kAristo));
  std::vector<ModelPart> parts = all;
  const Cell cell = read_cell(kAristo, std::nullopt, {"material.solid=" + solid});
  parts.back().faces = faces_of(cell.material.solid, "material");
  const Workcell workcell(cell, parts, covered_aristo());
  return close_upon(workcell, {rotation_about(Eigen::Vector3d::UnitZ(), degrees), {x, y, -95}});
}

std::string why_not(const std::string& solid, double x = 0, double y = 0, double degrees = 0) {
  const auto closed = grip(solid, x, y, degrees);
  const auto* text = std::get_if<std::string>(&closed);
  return text != nullptr ? *text : "held";
}

std::string box(double width) {
  return fmt::format(R"({{"box":{{"from":[{0},-20,0],"to":[{1},20,40]}}}})", -width / 2, width / 2);
}

/// A prism along z over the given corners.
std::string prism(int sides, double radius) {
  return fmt::format(R"({{"cylinder":{{"from":[0,0,0],"to":[0,0,40],"radius":{},"sides":{}}}}})", radius, sides);
}

TEST(Grip, EachFingerClosesUntilItTouches) {
  for (const double width : {1.5, 10.0, 39.0, 47.9})
    for (const double x : {0.0, 0.01, -0.04}) {
      const auto closed = grip(box(width), x);
      ASSERT_TRUE(std::holds_alternative<Grip>(closed)) << std::get<std::string>(closed);
      const Grip& held = std::get<Grip>(closed);
      EXPECT_NEAR(held.fingers[0].way, 24.95 - width / 2 + x, 1e-9);
      EXPECT_NEAR(held.fingers[1].way, 24.95 - width / 2 - x, 1e-9);
      EXPECT_NEAR(held.opening, width, 1e-9);
      EXPECT_GE(held.opening, width);
      for (const FingerContact& finger : held.fingers) {
        EXPECT_LT(finger.gap, 1e-9);
        EXPECT_EQ(finger.faces.size(), 1U);
      }
      EXPECT_NE(held.fingers[0].faces, held.fingers[1].faces);
    }
}

// 28 mm of the finger's width, and the 19 mm of the part that are between the fingers; less where the part ends.
TEST(Grip, ThePlaceOfContactIsWhereFingerAndFaceMeet) {
  const auto closed = grip(box(40), 1, 25);
  const Grip& held = std::get<Grip>(closed);
  for (const std::size_t finger : {0U, 1U}) {
    const Eigen::AlignedBox3d& place = held.fingers[finger].place;
    const double x = finger == 0 ? -19 : 21;
    EXPECT_LT((place.min() - Eigen::Vector3d(x, 5, -74)).norm(), 1e-6) << place.min().transpose();
    EXPECT_LT((place.max() - Eigen::Vector3d(x, 14, -55)).norm(), 1e-6) << place.max().transpose();
  }
}

TEST(Grip, RoundAndTurnedPartsAreHeldByOppositeFaces) {
  EXPECT_EQ(why_not(prism(32, 20)), "held");
  EXPECT_EQ(why_not(prism(6, 20), 0, 0, 30), "held");
  const auto turned = grip(box(40), 0, 0, 8);  // by its edges: each is of two faces
  ASSERT_TRUE(std::holds_alternative<Grip>(turned)) << std::get<std::string>(turned);
  for (const FingerContact& finger : std::get<Grip>(turned).fingers) {
    EXPECT_LT(finger.place.sizes().x(), 1e-6);
    EXPECT_LT(finger.place.sizes().y(), 1e-6);
    EXPECT_NEAR(finger.place.sizes().z(), 19, 1e-6);
  }
}

TEST(Grip, SaysWhyItDoesNotHold) {
  EXPECT_NE(why_not(box(1), 20).find("gripper/Finger1 closes by 24.95 mm and touches nothing"), std::string::npos);
  EXPECT_NE(why_not(box(40), 0, 60).find("touches nothing"), std::string::npos);
  EXPECT_NE(why_not(box(60)).find("touches it before it closes"), std::string::npos);
  // Flat on one side, an edge on the other.
  const std::string slips = why_not(prism(3, 20), 0, 0, 180);
  EXPECT_NE(slips.find("of which no two are opposite: it would slip"), std::string::npos) << slips;
}

// In both case studies and with the real arm: touched on opposite faces, for as long as it is held.
TEST(Grip, BothFingersTouchWhatIsCarried) {
  for (const auto& changes : {std::vector<std::string>{}, kSecondCase}) {
    const Workcell workcell = aristo(changes);
    const Process process = simulate(workcell);
    ASSERT_EQ(process.failure, "");
    std::size_t grips = 0;
    for (const MaterialTransfer& transfer : process.transfers) {
      EXPECT_EQ(transfer.grip.has_value(), transfer.in_flange.has_value());
      if (!transfer.grip) continue;
      ++grips;
      EXPECT_NEAR(transfer.grip->opening, 40, 2e-9);
      for (const FingerContact& finger : transfer.grip->fingers) {
        EXPECT_LT(finger.gap, 1e-9);
        EXPECT_GT(finger.place.sizes().y(), 10);
        EXPECT_GT(finger.place.sizes().z(), 1);
      }
    }
    EXPECT_EQ(grips, 2U);
  }
}

TEST(Grip, AFingerThatWouldTouchSomethingElseIsInTheWay) {
  const Process process =
      simulate(aristo({R"(storage.parts[1]={"name":"rail","box":{"from":[-23,-5,20],"to":[-21,2,36]}})"}));
  EXPECT_NE(process.failure.find("gripper/Finger1 touches storage/rail when it closes"), std::string::npos)
      << process.failure;
  EXPECT_EQ(process.cause, FailureCause::InTheWay);
}

}  // namespace
}  // namespace touchstone::cell
