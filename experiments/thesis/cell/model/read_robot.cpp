// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_robot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/read_urdf.h"

namespace touchstone::cell {
namespace {

std::size_t joint_named(const Robot& robot, const CellEntry& entry) {
  const std::string name = entry.text();
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].name == name && robot.joints[i].kind == Joint::Kind::Revolute) return i;
  entry.bad(fmt::format("the robot has no joint \"{}\" that turns", name));
}

void read_speeds(Robot& robot, const CellEntry& entry) {
  for (const auto& [name, speed] : entry.members()) {
    const auto joint = std::ranges::find(robot.joints, name, &Joint::name);
    if (joint == robot.joints.end() || joint->kind != Joint::Kind::Revolute)
      speed.bad("the robot has no joint of this name that turns");
    joint->speed = speed.positive();
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
    if (joint.kind == Joint::Kind::Fixed) continue;
    moving.insert(joint.name);
    if (joint.kind == Joint::Kind::Prismatic)
      fix_slide(joint, entry.at(joint.name));
    else
      joint.home = entry.at(joint.name).number();
  }
  for (const auto& [name, angle] : entry.members())
    if (moving.count(name) == 0) angle.bad("the robot has no joint of this name that turns or slides");
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
      home.at(joint.name)
          .bad(fmt::format("crosses a limit of the joint: {} is not within {} to {} degrees", angle, joint.lower,
                           joint.upper));
  }
}

}  // namespace

Robot read_robot(const CellEntry& entry, const std::filesystem::path& folder, SolidContext context) {
  const std::filesystem::path urdf = folder / entry.at("urdf").text();
  if (!std::filesystem::is_regular_file(urdf)) entry.at("urdf").bad("there is no file " + urdf.string());
  context.packages = packages_of(entry, folder, urdf);
  Robot robot = read_urdf(urdf, entry.at("sides").whole(3, 1000), context);
  robot.key = entry.path();
  robot.base.translation.z() = entry.at("height").not_negative();

  const Joint& first = robot.joints.front();
  const Eigen::Vector3d axis = first.origin.rotation * first.axis;
  if (first.kind != Joint::Kind::Revolute || axis.x() != 0 || axis.y() != 0 || first.origin.translation.x() != 0 ||
      first.origin.translation.y() != 0)
    entry.at("urdf").bad(
        fmt::format("the first joint, \"{}\", does not turn about the z axis of the first link", first.name));

  read_home(robot, entry.at("home"));
  if (const auto speeds = entry.find("speeds")) read_speeds(robot, *speeds);
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
  entry.has_only({"parts", "sphere", "hold"});
  const CellEntry sphere = entry.at("sphere");
  sphere.has_only({"at", "radius"});
  Gripper gripper{
      read_parts(entry.at("parts"), context), {sphere.at("at").point(), sphere.at("radius").positive()}, {}};
  if (const auto hold = entry.find("hold")) {
    hold->has_only({"along", "play"});
    const Eigen::Vector3d along = hold->at("along").point();
    if (along.isZero(0)) hold->at("along").bad("has no direction");
    gripper.hold = {kinematics::direction_of(along), hold->at("play").positive()};
  }
  return gripper;
}

}  // namespace touchstone::cell
