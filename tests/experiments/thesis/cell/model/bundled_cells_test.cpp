// SPDX-License-Identifier: GPL-3.0-or-later
// The cells that come with the program: their arms move as the published tables say, and every value has a source.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::cell {
namespace {

using nlohmann::json;
using run_tests::kAristo;
using run_tests::kCells;
using run_tests::links_at;

/// One link's step of a Denavit-Hartenberg table, in degrees and mm.
Eigen::Isometry3d step(double theta, double alpha, double a, double d) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
  return Eigen::Isometry3d(Eigen::AngleAxisd(theta * std::numbers::pi / 180, z)) * Eigen::Translation3d(a, 0, d) *
         Eigen::AngleAxisd(alpha * std::numbers::pi / 180, x);
}

TEST(Aristo, ItsHomePoseIsThatOfItsDenavitHartenbergTable) {
  const Cell cell = read_cell(kAristo);
  const auto links = links_at(cell.robot, {0, 0, 0, 0, 0, 0});
  EXPECT_EQ(links[5].translation(), Eigen::Vector3d(375, 0, 622));  // the wrist
  EXPECT_EQ(links[6].translation(), Eigen::Vector3d(375, 0, 559));  // the flange
}

// The table of [mtab-aristo]: (alpha, a, d) = (90, 0, 322), (0, 300, 0), (90, 0, 0), (90, 0, -375), (90, 0, 0), (0, 0,
// 63), home at theta = 0, 90, 180, 0, 90, 0. Wherever the table's joints are turned from there, the flange is where the
// cell file's are turned by the same angles, in the cell's directions.
TEST(Aristo, MovesAsItsDenavitHartenbergTableDoes) {
  const Cell cell = read_cell(kAristo);
  for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES; ++i) {
    workloads::Random random(53, i);
    std::vector<double> q;
    for (const Joint& joint : cell.robot.joints) q.push_back(joint.lower + random.unit() * (joint.upper - joint.lower));
    const Eigen::Isometry3d table = step(q[0], 90, 0, 322) * step(90 - q[1], 0, 300, 0) * step(180 + q[2], 90, 0, 0) *
                                    step(q[3], 90, 0, -375) * step(90 - q[4], 90, 0, 0) * step(q[5], 0, 0, 63);
    const Eigen::Isometry3d flange = links_at(cell.robot, q).back();
    EXPECT_LT((flange.translation() - table.translation()).norm(), 1e-9) << i;
    // The table's last frame points out of the hand along z, the cell's is parallel to the cell at home.
    EXPECT_LT((flange.linear() * -Eigen::Vector3d::UnitZ() - table.linear() * Eigen::Vector3d::UnitZ()).norm(), 1e-12)
        << i;
  }
}

TEST(Aristo, ItsFileSaysWhereValuesComeFromAndIsBuiltWhole) {
  const Cell cell = read_cell(kAristo);
  EXPECT_EQ(cell.label("storage.angle"), Label::Text);
  EXPECT_EQ(cell.label("storage.home"), Label::Derived);
  EXPECT_EQ(cell.label("storage.slots[1].place[0]"), Label::Chosen);
  EXPECT_EQ(cell.label("robot.links.Axis1[0].union[1].cylinder.radius"), Label::Chosen);
  EXPECT_EQ(cell.label("storage"), Label::Chosen);
  EXPECT_THROW((void)cell.label("nothing"), std::out_of_range);
  EXPECT_THROW((void)cell.label("storages"), std::out_of_range);
  EXPECT_EQ(cell.storage.azimuth(), -149);  // 149 degrees clockwise
  EXPECT_EQ(cell.machine.azimuth(), -83);
  EXPECT_EQ(cell.robot.couplings.size(), 2U);

  std::map<std::string, SolidFaces> parts;
  for (ModelPart& part : build_model(cell)) {
    const std::string owner = part.name.substr(0, part.name.find('/'));
    const bool of_gripper = part.carrier == Carrier::Gripper || part.carrier == Carrier::Finger;
    EXPECT_EQ(part.carrier == Carrier::Link ? cell.robot.links[part.link].name
              : of_gripper                  ? "gripper"
                                            : to_string(part.carrier),
              owner);
    if (of_gripper) {
      EXPECT_EQ(part.link, cell.robot.links.size() - 1);
    }
    parts.emplace(part.name, std::move(part.faces));
  }
  EXPECT_EQ(parts.size(), 22U);
  EXPECT_EQ(parts.at("gripper/Gripper1").volume, 90.0 * 30 * 75 - 50 * 30 * 45);
  EXPECT_EQ(parts.at("gripper/Gripper1").faces.size(), 10U);
  EXPECT_EQ(parts.at("storage/deck").holes(), 3U);
  EXPECT_EQ(parts.at("storage/stand").volume, 80.0 * 80 * 222);
  for (const auto& [name, faces] : parts) EXPECT_LT(faces.off_plane(), 1e-13) << name;
}

// Whatever the joints do that move, the sphere is where the reach says that it can be; and it comes near both bounds.
TEST(Aristo, ItsReachHoldsForEveryPoseOfTheJointsThatMove) {
  const Cell cell = read_cell(kAristo);
  const Reach reach = reach_of(cell);
  double nearest = reach.outer, furthest = 0;
  constexpr std::uint64_t kPoses = std::max(TOUCHSTONE_SAMPLES, 100);  // fewer may stay away from the bounds
  for (std::uint64_t i = 0; i < kPoses; ++i) {
    workloads::Random random(55, i);
    std::vector<double> q;
    for (std::size_t k = 0; k < cell.robot.joints.size(); ++k)
      q.push_back(k < 3 ? 360 * random.unit() : cell.robot.joints[k].home);
    q[4] = q[1] - q[2];  // the hand stays level
    const Eigen::Vector3d sphere = links_at(cell.robot, q).back() * cell.gripper.sphere.center;
    nearest = std::min(nearest, reach.distance(sphere));
    furthest = std::max(furthest, reach.distance(sphere));
    EXPECT_LE(reach.inner, reach.distance(sphere) + 1e-9) << i;
    EXPECT_LE(reach.distance(sphere), reach.outer + 1e-9) << i;
  }
  EXPECT_LT(nearest, 1.1 * reach.inner);
  EXPECT_GT(furthest, 0.98 * reach.outer);
}

class Melfa : public testing::Test, public run_tests::MelfaMeshes {};

// LinuxCNC's modified table (alpha, a, d before each joint): (0, 0, 350), (-90, 85, 0), (0, 380, 0), (-90, 100, 425),
// (90, 0, 0), (-90, 0, 85), with its angles; the file has its own frames but the same hand.
TEST_F(Melfa, MovesAsLinuxCncsTableDoes) {
  const Cell cell = read_cell(kCells / "melfa.json", scratch.path);
  const auto before = [](double alpha, double a, double theta, double d) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(alpha * std::numbers::pi / 180, Eigen::Vector3d::UnitX())) *
           Eigen::Translation3d(a, 0, 0) * step(theta, 0, 0, d);
  };
  for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES; ++i) {
    workloads::Random random(54, i);
    std::vector<double> q;
    for (const Joint& joint : cell.robot.joints) q.push_back(joint.lower + random.unit() * (joint.upper - joint.lower));
    const Eigen::Isometry3d table = before(0, 0, q[0], 350) * before(-90, 85, q[1], 0) * before(0, 380, q[2], 0) *
                                    before(-90, 100, q[3], 425) * before(90, 0, q[4], 0) * before(-90, 0, q[5], 85);
    EXPECT_LT((links_at(cell.robot, q).back().translation() - table.translation()).norm(), 1e-9) << i;
  }
}

TEST_F(Melfa, LimitsAreWholeDegreesAndFramesQuarterTurns) {
  const Cell cell = read_cell(kCells / "melfa.json", scratch.path);
  EXPECT_EQ(cell.robot.joints[1].lower, -182);
  EXPECT_EQ(cell.robot.joints[1].upper, 45);
  EXPECT_EQ(cell.robot.joints[2].lower, -219);
  Eigen::Matrix3d turn;
  turn << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  EXPECT_EQ(cell.robot.joints[1].origin.rotation, turn);
  EXPECT_EQ(cell.robot.joints[1].origin.translation, Eigen::Vector3d(85, 0, 111));
  for (const ModelPart& part : build_model(cell)) EXPECT_FALSE(part.faces.faces.empty()) << part.name;
}

// There ./reproduce unpacks them.
TEST(MelfaMeshFolder, IsInTheCacheOfTheProject) {
  const auto file = json::parse(std::ifstream(kCells / "melfa.json"));
  EXPECT_EQ((kCells / file.at("meshes").get<std::string>()).lexically_normal(),
            std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "cache/meshes");
}

TEST_F(Melfa, AMissingMeshIsNamed) {
  std::filesystem::remove(scratch.path / "VMC_toolchange/head.stl");
  EXPECT_EQ(run_tests::message_of<BadCell>([&] { return read_cell(kCells / "melfa.json", scratch.path); }),
            (kCells / "melfa.json").string() + ": machine.parts[1].mesh.file: there is no file " +
                (scratch.path / "VMC_toolchange/head.stl").string());
}

}  // namespace
}  // namespace touchstone::cell
