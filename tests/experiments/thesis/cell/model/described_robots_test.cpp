// SPDX-License-Identifier: GPL-3.0-or-later
// URDFs as they are in the world: five in the shape of public descriptions, and what makes others different.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/kinematics/chain.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/model/read_urdf.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/workcell.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cell {
namespace {

using nlohmann::json;
using run_tests::after_file;
using run_tests::message_of;

const std::filesystem::path kRobots =
    std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "tests/experiments/thesis/cell/model/robots";

Robot described(const std::string& name) {
  return read_urdf(kRobots / name, 8, {workloads::find_unit("mm"), kRobots / "elsewhere", {kRobots.parent_path()}});
}

bool warned(const Robot& robot, const std::string& words) {
  return std::ranges::any_of(robot.warnings,
                             [&](const std::string& each) { return each.find(words) != std::string::npos; });
}

struct Described {
  const char *file, *tip;
  std::size_t turning;
  Eigen::Vector3d place;  // of the tip with all joints at 0, in mm, by hand from published lengths
};
const std::vector<Described> kDescribed{{"irb.urdf", "tool0", 6, {940, 0, 1455}},
                                        {"xarm.urdf", "xarm_gripper_base_link", 6, {206.5, 0, 112}},
                                        {"panda.urdf", "panda_hand", 7, {88, 0, 926}},
                                        {"iiwa.urdf", "lbr_iiwa_link_7", 7, {0, 0, 1261}},
                                        {"ur.urdf", "wrist_3_link", 6, {817.25, 109.15, -5.491}}};

TEST(DescribedRobots, TheArmEndsAtTheLastLinkThatAllItsToolsShareAndStandsWhereItsLengthsPutIt) {
  for (const Described& each : kDescribed) {
    const Robot robot = described(each.file);
    EXPECT_EQ(robot.links.back().name, each.tip);
    EXPECT_EQ(std::ranges::count(robot.joints, Joint::Kind::Revolute, &Joint::kind), each.turning) << each.file;
    EXPECT_LT((home_poses(robot).back().translation - each.place).norm(), 1e-9)
        << each.file << ": " << home_poses(robot).back().translation.transpose();
  }
}

/// A cell in which such an arm turns a quarter from a shelf to a table.
Cell cell_of(const std::string& urdf, json robot, double radius, double height) {
  const run_tests::Scratch scratch;
  json cell = json::parse(run_tests::text_of(run_tests::kCells / "least/cell.json"));
  robot["urdf"] = (kRobots / urdf).string();
  robot["height"] = 0;
  robot["sides"] = 8;
  cell["robot"] = robot;
  cell["gripper"] = json::parse(R"({"parts": [{"name": "pin", "box": {"from": [-3, -3, 80], "to": [3, 3, 115]}}],
                                    "sphere": {"at": [0, 0, 120], "radius": 12}})");
  for (const char* station : {"storage", "machine"}) {
    cell[station]["radius"] = radius;
    cell[station]["height"] = height;
  }
  program::write_file(scratch.path / "cell.json", cell.dump());
  return read_cell(scratch.path / "cell.json");
}

std::string failure_of(const std::string& urdf, const json& robot, double radius, double height) {
  const Cell cell = cell_of(urdf, robot, radius, height);
  return simulate(Workcell(cell, build_model(cell))).failure;
}

json home(const std::string& prefix, const std::vector<double>& angles) {
  json robot;
  for (std::size_t i = 0; i < angles.size(); ++i) robot["home"][prefix + std::to_string(i + 1)] = angles[i];
  return robot;
}

/// The same with a hand that keeps level: the elbow makes up for the shoulder, and a joint of the wrist for the elbow,
/// by these factors.
json level(json robot, const std::string& prefix, int elbow, int by_elbow, int wrist, int by_wrist) {
  const auto name = [&](int joint) { return prefix + std::to_string(joint); };
  robot["coupling"] = {{{"joint", name(elbow)}, {"follows", name(2)}, {"factor", by_elbow}},
                       {{"joint", name(wrist)}, {"follows", name(elbow)}, {"factor", by_wrist}}};
  return robot;
}

TEST(DescribedRobots, ArmsWhoseElbowMovesInThePlaneOfTheBaseCarryTheirPiece) {
  const json irb = home("joint_", {0, 0, 0, 0, 0, 0});
  EXPECT_EQ(failure_of("irb.urdf", level(irb, "joint_", 3, -1, 5, -1), 1150, 800), "");
  EXPECT_EQ(failure_of("xarm.urdf", level(home("joint", {0, 0, -90, 0, -90, 0}), "joint", 3, -1, 5, -1), 600, 300), "");
  EXPECT_NE(failure_of("irb.urdf", irb, 1150, 800).find("the hand does not stay level"), std::string::npos);
}

// Seven joints turn: with the third one still, the arm moves in a plane.
TEST(DescribedRobots, ArmsOfSevenJointsCarryTheirPieceWithOneJointStill) {
  const json free = home("panda_joint", {0, 0, 0, -90, 0, 180, 45});
  json panda = level(home("panda_joint", {0, 0, 0, -90, 0, 0, 45}), "panda_joint", 4, 1, 6, -1),
       iiwa = level(home("lbr_iiwa_joint_", {0, 0, 0, -90, 0, 180, 0}), "lbr_iiwa_joint_", 4, 1, 6, 1);
  const std::string refusal = message_of<BadCell>([&] { (void)failure_of("panda.urdf", free, 650, 300); });
  EXPECT_NE(refusal.find("robot.home: the second and third joint do not turn about y at home"), std::string::npos)
      << refusal;
  panda["still"] = {"panda_joint3"};
  iiwa["still"] = {"lbr_iiwa_joint_3"};
  EXPECT_EQ(failure_of("panda.urdf", panda, 650, 300), "");
  EXPECT_EQ(failure_of("iiwa.urdf", iiwa, 650, 300), "");
}

TEST(DescribedRobots, AJointThatIsStillStaysWhereHomeSays) {
  json robot = home("lbr_iiwa_joint_", {0, 0, 0, -90, 0, 30, 0});
  robot["still"] = {"lbr_iiwa_joint_3"};
  const Pose free = home_poses(cell_of("iiwa.urdf", robot, 650, 300).robot).back();
  robot["still"] = {"lbr_iiwa_joint_3", "lbr_iiwa_joint_6"};
  const Robot still = cell_of("iiwa.urdf", robot, 650, 300).robot;
  EXPECT_LT((home_poses(still).back().translation - free.translation).norm(), 1e-9);
  EXPECT_EQ(std::ranges::count(still.joints, Joint::Kind::Revolute, &Joint::kind), 5);
}

/// The arm of ur.urdf, whose elbow and wrist keep its hand level.
json ur() {
  return {{"home",
           {{"shoulder_pan_joint", 0},
            {"shoulder_lift_joint", -90},
            {"elbow_joint", 0},
            {"wrist_1_joint", -90},
            {"wrist_2_joint", -90},
            {"wrist_3_joint", 0}}},
          {"coupling",
           {{{"joint", "elbow_joint"}, {"follows", "shoulder_lift_joint"}, {"factor", -1}},
            {{"joint", "wrist_1_joint"}, {"follows", "elbow_joint"}, {"factor", -1}}}},
          {"tip", "tool0"}};
}

TEST(DescribedRobots, AnArmWhoseHandIsBesideTheBasesAxisCarriesItsPiece) {
  EXPECT_EQ(failure_of("ur.urdf", ur(), 650, 300), "");
}

// The storage is where the elbow, lowered by 2 degrees, has the sphere at the height of a side's touch. The base then
// turns it on a circle that meets the side ahead of the middle of the piece, as seen by the hand.
TEST(DescribedRobots, AnArmBesideItsBasesAxisComesToTheMiddleOfASide) {
  const Arm arm = arm_of(cell_of("ur.urdf", ur(), 650, 300));
  kinematics::Angles lowered = arm.home;
  lowered[kElbow] -= 2;
  const Eigen::Vector3d center = arm.sphere_at(lowered).center;
  const double beside = 109.15, touch = 30 - 12.0 / 8;  // above the lower face of the piece
  double radius = center.head<2>().norm();
  for (int i = 0; i < 50; ++i) {
    const double turned = std::asin(beside / radius);
    const double half = 10 * (std::cos(turned) + std::sin(turned));  // of the piece, a square of 20 in the plan
    radius = std::sqrt(center.head<2>().squaredNorm() - std::pow(beside + half + 12, 2) + beside * beside);
  }
  const Cell cell = cell_of("ur.urdf", ur(), radius, center.z() - touch);
  const Process process = simulate(Workcell(cell, build_model(cell)), {.last = Phase::ToStorage});
  ASSERT_EQ(process.moves.size(), 2U);
  EXPECT_EQ(process.moves[0].joint, kElbow);
  EXPECT_NEAR(process.moves[0].exact, -2, 1e-9);
  EXPECT_EQ(process.moves[1].joint, kBase);
  EXPECT_EQ(process.moves[1].until, Until::Contact);
}

TEST(DescribedRobots, TheReachOfAnArmBesideItsBasesAxisHoldsForEveryPose) {
  const Cell cell = cell_of("ur.urdf", ur(), 650, 300);
  const Arm arm = arm_of(cell);
  const Reach reach = reach_of(cell);
  EXPECT_NEAR(reach.beside, 109.15, 1e-9);
  double furthest = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    workloads::Random random(57, i);
    kinematics::Angles angles = arm.home;
    for (const Moved joint : {kBase, kShoulder, kElbow}) angles[joint] = 360 * random.unit();
    const Eigen::Vector3d center = arm.sphere_at(angles).center;
    EXPECT_LE(reach.distance(center), reach.outer + 1e-9) << i;
    EXPECT_GE(center.head<2>().norm(), reach.beside - 1e-9) << i;
    furthest = std::max(furthest, center.head<2>().norm());
  }
  EXPECT_LE(furthest, reach.furthest() + 1e-9);
  EXPECT_GT(furthest, 0.98 * reach.furthest());
}

TEST(DescribedRobots, WhatIsBesideTheArmMovesWithTheLinkThatCarriesIt) {
  const Robot robot = described("panda.urdf");
  const std::vector<Part>& hand = robot.links.back().parts;
  ASSERT_EQ(hand.size(), 3U);
  EXPECT_EQ(hand[0].name, "collision0");
  EXPECT_EQ(hand[1].name, "panda_leftfinger-collision0");
  EXPECT_EQ(hand[2].name, "panda_rightfinger-collision0");
  const Eigen::AlignedBox3d left = bounds_of(hand[1].solid), right = bounds_of(hand[2].solid);
  EXPECT_TRUE(left.min().isApprox(Eigen::Vector3d(-10, 5, 58.4)) && left.max().isApprox(Eigen::Vector3d(10, 15, 98.4)));
  EXPECT_TRUE(right.max().isApprox(Eigen::Vector3d(10, -5, 98.4)));
  EXPECT_TRUE(warned(robot, "line 45: link panda_leftfinger: is beside the arm, and moves with link panda_hand"));
  EXPECT_TRUE(warned(robot, "line 116: joint panda_finger_joint1: is beside the arm, and stands still at 0 metres"));
  EXPECT_TRUE(warned(described("irb.urdf"), "links without shapes beside the arm are left out: base"));
}

class Urdf : public testing::Test {
 protected:
  /// An arm of three joints, with this in its text instead of that.
  [[nodiscard]] Robot changed(const std::string& from, const std::string& to, const UrdfEnds& ends = {}) const {
    std::string text = run_tests::text_of(kRobots / "three.urdf");
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("nothing to replace");
    program::write_file(file, text.replace(at, from.size(), to));
    return read_urdf(file, 8, {workloads::find_unit("mm"), scratch.path / "elsewhere", {scratch.path}}, ends);
  }
  [[nodiscard]] std::string fault(const std::string& from, const std::string& to, const UrdfEnds& ends = {}) const {
    return after_file(file, message_of<BadCell>([&] { (void)changed(from, to, ends); }));
  }
  [[nodiscard]] Solid upper(const std::string& geometry) const {
    return changed("<link name=\"Upper\"/>",
                   "<link name=\"Upper\"><collision><geometry>" + geometry + "</geometry></collision></link>")
        .links.at(2)
        .parts.at(0)
        .solid;
  }

  /// A link that a joint mounts on another.
  static std::string mounted(const std::string& name, const std::string& on, const std::string& type = "fixed",
                             const std::string& inside = "") {
    return "<link name=\"" + name + "\"/><joint name=\"to " + name + "\" type=\"" + type + "\"><parent link=\"" + on +
           "\"/><child link=\"" + name + "\"/><axis xyz=\"1 0 0\"/>" + inside + "</joint>";
  }

  const run_tests::Scratch scratch;
  const std::filesystem::path file = scratch.path / "arm.urdf";
  const std::string end = "</robot>", limit = "<limit lower=\"-1.5\" upper=\"1.5\" effort=\"0\" velocity=\"0\"/>";
};

TEST_F(Urdf, RootAndTipNameTheArm) {
  EXPECT_EQ(changed(end, mounted("a", "Fore") + mounted("b", "a") + end).links.back().name, "b");
  EXPECT_EQ(changed(end, mounted("a", "Fore") + mounted("b", "Fore") + end).links.back().name, "Fore");
  EXPECT_EQ(changed(end, mounted("a", "Fore") + mounted("b", "Fore") + end, {{}, "b"}).links.back().name, "b");
  EXPECT_EQ(changed(end, mounted("a", "Turntable", "continuous") + end).links.back().name, "Fore");
  EXPECT_EQ(fault(end, mounted("a", "Upper", "continuous") + end),
            "as many joints turn on the way to link Fore as to a: robot.tip must name the last link");
  const Robot behind =
      changed("<link name=\"Foot\"/>", "<link name=\"world\"/>" + mounted("Foot", "world", "floating"), {"Foot", {}});
  EXPECT_EQ(behind.links.front().name, "Foot");
  EXPECT_TRUE(warned(behind, "links before Foot are left out, with what else they carry: world"));
  EXPECT_EQ(fault(end, end, {"a", {}}), "root: the robot has no link \"a\"");
  EXPECT_EQ(fault(end, end, {{}, "a"}), "tip: the robot has no link \"a\"");
  EXPECT_EQ(fault(end, end, {"Fore", "Foot"}), "root: link Fore does not carry the tip Foot");
}

// A gripper whose fingers turn is not part of the arm: one is mimicked, the other mimics it.
TEST_F(Urdf, FingersThatTurnDoNotMakeTheArmLonger) {
  const std::string open = "<limit lower=\"0.5\" upper=\"1\" effort=\"0\" velocity=\"0\"/>";
  const Robot robot = changed(
      end, mounted("palm", "Fore") + mounted("l", "palm", "revolute", open) +
               mounted("r", "palm", "revolute", open + "<mimic joint=\"to l\" multiplier=\"-2\" offset=\"0.25\"/>") +
               end);
  EXPECT_EQ(robot.links.back().name, "palm");
  EXPECT_TRUE(warned(robot, "joint to l: is beside the arm, and stands still at 0.5 radians"));
  EXPECT_TRUE(warned(robot, "joint to r: is beside the arm, and stands still at -0.75 radians"));
  EXPECT_TRUE(
      fault(end, mounted("a", "Fore") + mounted("l", "Fore", "prismatic", open + "<mimic joint=\"none\"/>") + end)
          .ends_with("joint to l: mimics joint none, which the robot does not have"));
  EXPECT_TRUE(
      fault(end, mounted("a", "Fore") + mounted("l", "Fore", "prismatic", open + "<mimic joint=\"to l\"/>") + end)
          .ends_with("joint to l: mimics joint to l, which mimics others without end"));
}

TEST_F(Urdf, AJointOfTheArmFollowsTheOneThatItMimics) {
  const Robot robot = changed(
      end, mounted("hand", "Fore", "continuous", "<mimic joint=\"elbow\" multiplier=\"-1\" offset=\"0.5\"/>") + end);
  ASSERT_EQ(robot.couplings.size(), 1U);
  EXPECT_EQ(robot.couplings[0].joint, 3U);
  EXPECT_EQ(robot.couplings[0].leader, 2U);
  EXPECT_EQ(robot.couplings[0].factor, -1);
  EXPECT_NEAR(robot.joints[3].home, 28.647889757, 1e-9);
  EXPECT_TRUE(fault(end, mounted("hand", "Fore", "continuous", "<mimic joint=\"none\"/>") + end)
                  .ends_with("mimics joint none: within the arm a joint that turns can only mimic another of these"));
}

TEST_F(Urdf, LinksFormATree) {
  const std::string other = "<joint name=\"x\" type=\"fixed\"><parent link=\"Foot\"/><child link=\"Fore\"/></joint>";
  EXPECT_TRUE(fault(end, other + end).ends_with("link Fore is the child of another joint, too"));
  EXPECT_TRUE(fault(end, mounted("a", "b") + mounted("b", "a") + end)
                  .ends_with("no chain of joints leads from the root Foot to it"));
}

TEST_F(Urdf, NamesBecomePlain) {
  const Robot robot = changed("<link name=\"Foot\"/>",
                              "<link name=\"Foot\"><collision name=\"a.b\"><geometry><sphere radius=\"1\"/></geometry>"
                              "</collision></link>" +
                                  mounted("fore.arm/x", "Foot"));
  EXPECT_EQ(robot.links.front().parts.at(0).name, "a_b");
  EXPECT_TRUE(warned(robot, "link fore.arm/x: is called fore_arm_x here"));
  EXPECT_TRUE(fault(end, mounted("Fo.re", "Fore") + mounted("Fo/re", "Fore") + end)
                  .ends_with("link Fo/re: another link is called Fo_re, too"));
}

TEST_F(Urdf, MeshesAreFoundBesideTheFileAndInPackagesAndModels) {
  program::make_folder(scratch.path / "arm" / "meshes");
  const char* const tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  program::write_file(scratch.path / "arm/meshes/a.obj", tetrahedron);
  for (const char* name : {"arm/meshes/a.obj", "model://arm/meshes/a.obj", "package://arm/meshes/a.obj"})
    EXPECT_EQ(bounds_of(upper("<mesh filename=\"" + std::string(name) + "\"/>")).max(),
              Eigen::Vector3d(1000, 1000, 1000))
        << name;
  EXPECT_TRUE(message_of<BadCell>([&] {
                (void)upper("<mesh filename=\"file://$(find a)/b.stl\"/>");
              }).ends_with("mesh: file://$(find a)/b.stl: is of a xacro file; xacro must make a URDF of it first"));
  // Scaled and mirrored, with faces that still face outside.
  for (const auto& [scale, corner] : {std::pair{"1.5 1.5 1.5", Eigen::Vector3d(1500, 1500, 1500)},
                                      {"2 1 0.5", Eigen::Vector3d(2000, 1000, 500)},
                                      {"-1 1 1", Eigen::Vector3d(-1000, 1000, 1000)},
                                      {"-1 -2 1", Eigen::Vector3d(-1000, -2000, 1000)}}) {
    const Solid solid = upper("<mesh filename=\"arm/meshes/a.obj\" scale=\"" + std::string(scale) + "\"/>");
    EXPECT_EQ(bounds_of(solid).sizes(), corner.cwiseAbs()) << scale;
    EXPECT_EQ(bounds_of(solid).center(), corner / 2) << scale;
    double volume = 0;
    for (const Face& face : faces_of(solid, "a").faces)
      volume += face.polygon.vertex(0).dot(doubled_area(face.polygon)) / 6;
    EXPECT_NEAR(volume, std::abs(corner.prod()) / 6, 1e-3) << scale;
  }
  EXPECT_TRUE(message_of<BadCell>([&] {
                (void)upper("<mesh filename=\"arm/meshes/a.obj\" scale=\"1 0 1\"/>");
              }).ends_with("mesh: the scale 1 0 1 leaves no solid"));
}

TEST_F(Urdf, TurnsOfFewDigitsAreQuarterTurns) {
  const std::string origin = "<origin xyz=\"0 0 0.1\"/>";
  const Robot robot = changed(origin, "<origin xyz=\"0 0 0.1\" rpy=\"3.14159 0 0\"/>");
  EXPECT_EQ(robot.joints[0].origin.rotation, Eigen::Matrix3d(Eigen::Vector3d(1, -1, -1).asDiagonal()));
  EXPECT_TRUE(warned(robot, "turns within 1e-05 of quarter turns are taken as these; the furthest is 2.65e-06 off"));
  EXPECT_EQ(changed("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1e-7 1\"/>").joints[0].axis, Eigen::Vector3d(0, 0, 1));
  EXPECT_NE(changed(origin, "<origin xyz=\"0 0 0.1\" rpy=\"1.57 0 0\"/>").joints[0].origin.rotation(1, 1), 0);
  EXPECT_TRUE(changed(end, end).warnings.empty());
}

TEST_F(Urdf, LimitsMayBeAbsent) {
  const Robot robot = changed(limit, "");
  EXPECT_EQ(robot.joints[1].lower, -360);
  EXPECT_EQ(robot.joints[1].upper, 360);
  EXPECT_TRUE(warned(robot, "line 19: joint shoulder: has no limit, turns from -360 to 360 degrees"));
  const Robot silent = changed(limit, "<limit lower=\"-1.5\" upper=\"1.5\"/>");
  EXPECT_NEAR(silent.joints[1].upper, 85.943669270, 1e-9);
  EXPECT_EQ(silent.joints[1].speed, 0);
  EXPECT_TRUE(silent.warnings.empty());
  EXPECT_NE(fault(limit, "<limit lower=\"-1.5\" upper=\"1.5\" effort=\"x\"/>"), "");
}

}  // namespace
}  // namespace touchstone::cell
