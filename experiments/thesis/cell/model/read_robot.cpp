// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_robot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/read_urdf.h"
#include "experiments/thesis/cell/model/urdf_chain.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell {
namespace {

/// The first and last link of the arm, by the keys `root` and `tip`.
UrdfEnds ends_of(const CellEntry& robot) {
  UrdfEnds ends;
  if (const auto root = robot.find("root")) ends.root = root->text();
  if (const auto tip = robot.find("tip")) ends.tip = tip->text();
  return ends;
}

std::size_t joint_named(const Robot& robot, const CellEntry& entry) {
  const std::string name = entry.text();
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].name == name && robot.joints[i].kind == Joint::Kind::Revolute) return i;
  entry.bad(fmt::format("the robot has no joint \"{}\" that turns", name));
}

/// Reads what some joints can do at most.
void read_greatest(Robot& robot, const std::optional<CellEntry>& entry, double Joint::*greatest) {
  if (!entry) return;
  for (const auto& [name, value] : entry->members()) {
    const auto joint = std::ranges::find(robot.joints, name, &Joint::name);
    if (joint == robot.joints.end() || joint->kind != Joint::Kind::Revolute)
      value.bad("the robot has no joint of this name that turns");
    (*joint).*greatest = value.positive();
    constexpr double kLeast = 1e-9;  // so that times are finite
    if ((*joint).*greatest < kLeast) value.bad(fmt::format("must be at least {}, is {}", kLeast, (*joint).*greatest));
  }
}

/// Fixes a joint that slides where `home` says.
void fix_slide(Joint& joint, const CellEntry& home) {
  const double way = home.number();
  if (way < joint.lower || way > joint.upper)
    home.bad(fmt::format("crosses a limit of the joint: {} is not within {} to {}", way, joint.lower, joint.upper));
  joint.origin.translation += joint.origin.rotation * (way * joint.axis);
  joint = {joint.name, Joint::Kind::Fixed, joint.origin, {0, 0, 1}, 0, 0, 0};
}

void read_home(Robot& robot, const CellEntry& entry) {
  std::set<std::string> moving;
  for (Joint& joint : robot.joints) {
    if (joint.kind == Joint::Kind::Fixed || joint.mimics) continue;
    moving.insert(joint.name);
    if (joint.kind == Joint::Kind::Prismatic)
      fix_slide(joint, entry.at(joint.name));
    else
      joint.home = entry.at(joint.name).number();
  }
  for (const auto& [name, angle] : entry.members())
    if (moving.count(name) == 0)
      angle.bad(std::ranges::any_of(robot.joints,
                                    [&, &joint = name](const Joint& each) { return each.name == joint && each.mimics; })
                    ? "the joint mimics another, and has no angle of its own"
                    : "the robot has no joint of this name that turns or slides");
}

/// Fixes joints that turn at home.
void hold_still(Robot& robot, const CellEntry& entry) {
  for (const CellEntry& item : entry.items()) {
    const std::size_t place = joint_named(robot, item);
    Joint& joint = robot.joints[place];
    const auto coupled = [&](const Coupling& each) { return each.joint == place || each.leader == place; };
    if (std::ranges::any_of(robot.couplings, coupled)) item.bad("is coupled to another joint");
    if (joint.home < joint.lower || joint.home > joint.upper)
      item.bad(fmt::format("home crosses a limit of the joint: {} is not within {} to {} degrees", joint.home,
                           joint.lower, joint.upper));
    joint.origin.rotation *= rotation_about(joint.axis, joint.home);
    joint = {joint.name, Joint::Kind::Fixed, joint.origin, {0, 0, 1}, 0, 0, 0};
  }
}

/// The cell's frame lies on the axis of the first joint that turns, and the first three take commands.
void check_first(const Robot& robot, const CellEntry& urdf) {
  constexpr int kCommanded = 3;
  Pose frame;
  int turning = 0;
  for (const Joint& joint : robot.joints) {
    if (turning == 0) frame = within(frame, joint.origin);
    if (joint.kind == Joint::Kind::Fixed) continue;
    const Eigen::Vector3d axis = frame.rotation * joint.axis;
    if (turning == 0 && (axis.x() != 0 || axis.y() != 0 || frame.translation.x() != 0 || frame.translation.y() != 0))
      urdf.bad(fmt::format("the first joint, \"{}\", does not turn about the z axis of the first link", joint.name));
    if (++turning <= kCommanded && joint.mimics)
      urdf.bad(
          fmt::format("joint \"{}\" mimics another, but the cell moves it by itself: only joints after the first "
                      "three that turn can follow",
                      joint.name));
  }
}

/// Returns the folders in which packages are looked for: those of the cell file, of ROS_PACKAGE_PATH, and those above
/// the URDF.
std::vector<std::filesystem::path> packages_of(const CellEntry& robot, const std::filesystem::path& folder,
                                               const std::filesystem::path& urdf) {
  std::vector<std::filesystem::path> packages;
  if (const auto given = robot.find("packages"))
    for (const CellEntry& item : given->items()) packages.push_back(folder / item.text());
  if (const char* path = std::getenv("ROS_PACKAGE_PATH")) {
    std::istringstream folders(path);
    for (std::string one; std::getline(folders, one, ':');)
      if (!one.empty()) packages.emplace_back(one);
  }
  for (std::filesystem::path above = std::filesystem::absolute(urdf).lexically_normal().parent_path();
       above != above.root_path(); above = above.parent_path())
    packages.push_back(above);
  return packages;
}

void read_couplings(Robot& robot, const CellEntry& entry) {
  for (const CellEntry& item : entry.items()) {
    item.has_only({"joint", "follows", "factor"});
    const Coupling coupling{joint_named(robot, item.at("joint")), joint_named(robot, item.at("follows")),
                            item.at("factor").number()};
    if (coupling.joint == coupling.leader) item.at("follows").bad("a joint does not follow itself");
    robot.couplings.push_back(coupling);
  }
}

void check_home(const Robot& robot, const CellEntry& home) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const double angle = angle_at_home(robot, i);
    if (angle < joint.lower || angle > joint.upper)
      (joint.mimics ? home : home.at(joint.name))
          .bad(fmt::format("crosses a limit of the joint: {} is not within {} to {} degrees", angle, joint.lower,
                           joint.upper));
  }
}

}  // namespace

Robot read_robot(const CellEntry& entry, const std::filesystem::path& folder, SolidContext context) {
  const std::filesystem::path urdf = folder / entry.at("urdf").text();
  if (!std::filesystem::is_regular_file(urdf)) entry.at("urdf").bad("there is no file " + urdf.string());
  context.packages = packages_of(entry, folder, urdf);
  Robot robot = read_urdf(urdf, entry.at("sides").whole(3, 1000), context, ends_of(entry));
  for (const std::string& warning : robot.warnings)
    fmt::print(stderr, "touchstone: warning: {}\n", io::all_legible(warning));
  robot.key = entry.path();
  robot.base.translation.z() = entry.at("height").not_negative();

  read_home(robot, entry.at("home"));
  if (const auto still = entry.find("still")) hold_still(robot, *still);
  check_first(robot, entry.at("urdf"));
  read_greatest(robot, entry.find("speeds"), &Joint::speed);
  read_greatest(robot, entry.find("accelerations"), &Joint::acceleration);
  if (const auto coupling = entry.find("coupling")) read_couplings(robot, *coupling);
  check_home(robot, entry.at("home"));
  if (const auto links = entry.find("links"))
    for (const auto& [name, parts] : links->members()) {
      const auto link = std::find_if(robot.links.begin(), robot.links.end(),
                                     [&, &link_name = name](const Link& each) { return each.name == link_name; });
      if (link == robot.links.end()) parts.bad("the robot has no link of this name");
      link->parts = read_parts(parts, context);
    }
  return robot;
}

Gripper read_gripper(const CellEntry& entry, const SolidContext& context) {
  entry.has_only({"parts", "sphere", "fingers", "grip_seconds", "release_seconds"});
  const CellEntry sphere = entry.at("sphere");
  sphere.has_only({"at", "radius"});
  Gripper gripper{
      read_parts(entry.at("parts"), context), {sphere.at("at").point(), sphere.at("radius").positive()}, {}};
  if (const auto seconds = entry.find("grip_seconds")) gripper.grip_seconds = seconds->seconds();
  if (const auto seconds = entry.find("release_seconds")) gripper.release_seconds = seconds->seconds();
  if (const auto fingers = entry.find("fingers")) {
    fingers->has_only({"along", "stroke", "parts"});
    const Eigen::Vector3d along = fingers->at("along").point();
    if (along.isZero(0)) fingers->at("along").bad("has no direction");
    std::vector<Part> parts = read_parts(fingers->at("parts"), context);
    if (parts.size() != 2) fingers->at("parts").bad("a gripper has two fingers");
    for (const CellEntry& finger : fingers->at("parts").items())
      if (std::ranges::find(gripper.parts, finger.at("name").text(), &Part::name) != gripper.parts.end())
        finger.at("name").bad("another part of the gripper has this name");
    gripper.fingers = {
        {std::move(parts[0]), std::move(parts[1])}, kinematics::direction_of(along), fingers->at("stroke").positive()};
  }
  return gripper;
}

}  // namespace touchstone::cell
