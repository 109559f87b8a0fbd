// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/model/read_cell.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cell/model/change_cell.h"
#include "experiments/cell/model/reach.h"
#include "experiments/cell/model/read_at_most.h"
#include "experiments/cell/model/read_solid.h"
#include "experiments/cell/model/read_urdf.h"
#include "experiments/cell/model/stops.h"
#include "experiments/harness/json/strict_json.h"

namespace touchstone::cell {
namespace {

harness::StrictJson load(const std::filesystem::path& file) {
  const std::string text = read_at_most<BadCell>(file, kMostCellMib);
  try {
    harness::StrictJson json = harness::read_strict_json(text);
    if (json.duplicate_key) throw BadCell(fmt::format("{}: duplicate key \"{}\"", file.string(), *json.duplicate_key));
    if (json.too_deep)
      throw BadCell(fmt::format("{}: is nested deeper than {} levels", file.string(), harness::kMostLevels));
    return json;
  } catch (const harness::NotJson& error) {
    throw BadCell(fmt::format("{}: is not JSON: {}", file.string(), error.what()));
  }
}

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
    double angle = joint.home;
    for (const Coupling& coupling : robot.couplings)
      if (coupling.joint == i) angle += coupling.factor * robot.joints[coupling.leader].home;
    if (angle < joint.lower || angle > joint.upper)
      home.at(joint.name)
          .bad(fmt::format("crosses a limit of the joint: {} is not within {} to {} degrees", angle, joint.lower,
                           joint.upper));
  }
}

Robot read_robot(const CellEntry& entry, const std::filesystem::path& folder, SolidContext context) {
  entry.has_only({"urdf", "height", "home", "speeds", "sides", "coupling", "links", "packages"});
  const std::filesystem::path urdf = folder / entry.at("urdf").text();
  if (!std::filesystem::is_regular_file(urdf)) entry.at("urdf").bad("there is no file " + urdf.string());
  context.packages = packages_of(entry, folder, urdf);
  Robot robot = read_urdf(urdf, entry.at("sides").whole(3, 1000), context);
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

/// Parts are told apart by the link or thing that they belong to: none may share its name with another.
void check_names(const Cell& cell, const CellEntry& whole) {
  std::set<std::string> names{"gripper", "storage", "machine", "material"};
  for (const Link& link : cell.robot.links)
    if (!names.insert(link.name).second)
      whole.at("robot").at("urdf").bad(fmt::format("\"{}\" is not a valid name for a link", link.name));
  const auto parts = whole.at("gripper").at("parts").items();
  for (const CellEntry& part : parts)
    if (names.count(part.at("name").name()) > 0) part.at("name").bad("a link, or something else, has this name");
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
    if (!(along.norm() > 0)) hold->at("along").bad("has no direction");
    gripper.hold = {along.normalized(), hold->at("play").positive()};
  }
  return gripper;
}

Station read_station(const CellEntry& entry, const SolidContext& context) {
  entry.has_only({"home", "angle", "radius", "height", "slots", "parts", "stand"});
  Station station{entry.at("home").number(),
                  entry.at("angle").number(),
                  entry.at("radius").positive(),
                  entry.at("height").not_negative(),
                  {},
                  read_parts(entry.at("parts"), context),
                  {}};
  for (const CellEntry& item : entry.at("parts").items())
    if (item.at("name").name() == "stand") item.at("name").bad("only the stand has this name");
  std::set<std::string> names;
  for (const CellEntry& item : entry.at("slots").items()) {
    item.has_only({"name", "place", "aim"});
    const Eigen::Vector3d place = item.at("place").point();
    const auto aim = item.find("aim");
    station.slots.push_back({item.at("name").text(), place, aim ? aim->point2() : Eigen::Vector2d(place.head<2>())});
    if (!names.insert(station.slots.back().name).second) item.at("name").bad("this name is taken");
  }
  if (station.slots.empty()) entry.at("slots").bad("must not be empty");
  if (const auto stand = entry.find("stand")) {
    stand->has_only({"from", "to", "top"});
    station.stand = {stand->at("from").point2(), stand->at("to").point2(), stand->at("top").number()};
    const Station::Stand& given = *station.stand;
    if (!(given.lower.x() < given.upper.x() && given.lower.y() < given.upper.y()))
      stand->bad("\"from\" must be less than \"to\" in each coordinate");
    if (!(given.top > -station.height)) stand->at("top").bad("lies at or below the floor");
  }
  return station;
}

std::map<std::string, std::vector<std::string>> presets_of(const CellEntry& whole) {
  std::map<std::string, std::vector<std::string>> presets;
  if (const auto entry = whole.find("presets"))
    for (const auto& [name, changes] : entry->members())
      for (const CellEntry& change : changes.items()) presets[name].push_back(change.text());
  return presets;
}

/// The paths of all values, and those of numbers.
struct Paths {
  std::set<std::string> all, numbers;

  void take(const CellEntry& entry) {
    if (!entry.path().empty()) all.insert(entry.path());
    if (entry.is_number()) numbers.insert(entry.path());
    if (entry.is_object())
      for (const auto& [key, member] : entry.members()) take(member);
    if (entry.is_array())
      for (const CellEntry& item : entry.items()) take(item);
  }
};

void read_labels(Cell& cell, const CellEntry& whole) {
  const CellEntry entry = whole.at("labels");
  Paths paths;
  for (const auto& [key, member] : whole.members())
    if (key != "labels") paths.take(member);
  for (const auto& [path, label] : entry.members()) {
    const std::string word = label.text();
    if (word.size() != 1 || std::string("TSDC").find(word) == std::string::npos)
      label.bad("must be \"T\", \"S\", \"D\" or \"C\"");
    if (paths.all.count(path) == 0) label.bad("there is no value of this path");
    cell.labels[path] = static_cast<Label>(word[0]);
  }
  for (const std::string& path : paths.numbers) {
    try {
      (void)cell.label(path);
    } catch (const std::out_of_range& error) {
      entry.bad(error.what());
    }
  }
}

workloads::Unit read_unit(const CellEntry& entry) {
  try {
    return workloads::find_unit(entry.text());
  } catch (const std::invalid_argument& error) {
    entry.bad(error.what());
  }
}

}  // namespace

std::size_t slot_named(const Station& station, const CellEntry& entry) {
  const std::string name = entry.text();
  for (std::size_t i = 0; i < station.slots.size(); ++i)
    if (station.slots[i].name == name) return i;
  entry.bad(fmt::format("there is no slot \"{}\"", name));
}

std::map<std::string, std::vector<std::string>> read_presets(const std::filesystem::path& file) {
  const harness::StrictJson json = load(file);
  return presets_of(CellEntry(file.string(), "", json.value));
}

std::vector<std::string> preset(const std::filesystem::path& file, const std::string& name) {
  const auto presets = read_presets(file);
  const auto found = presets.find(name);
  if (found != presets.end()) return found->second;
  std::string names;
  for (const auto& [each, changes] : presets) names += (names.empty() ? "" : ", ") + each;
  throw BadCell(fmt::format("{}: presets: no preset is named \"{}\"; there are: {}", file.string(), name, names));
}

Cell read_cell(const std::filesystem::path& file, const std::optional<std::filesystem::path>& meshes,
               const std::vector<std::string>& changes) {
  harness::StrictJson json = load(file);
  for (const std::string& change : changes) change_cell(json.value, change);
  const CellEntry whole(file.string(), "", json.value);
  whole.has_only({"name", "unit", "step", "clearance", "meshes", "robot", "gripper", "storage", "machine", "material",
                  "labels", "presets"});
  static_cast<void>(presets_of(whole));
  const std::filesystem::path folder = file.parent_path();
  SolidContext context{read_unit(whole.at("unit")), folder.empty() ? "." : folder};
  if (const auto given = whole.find("meshes")) context.mesh_folder = folder / given->text();
  if (meshes) context.mesh_folder = *meshes;
  if (!std::filesystem::is_directory(context.mesh_folder))
    whole.at("meshes").bad("there is no folder " + context.mesh_folder.string());

  Cell cell{.file = file,
            .name = whole.at("name").text(),
            .unit = context.unit,
            .robot = read_robot(whole.at("robot"), folder, context),
            .gripper = read_gripper(whole.at("gripper"), context),
            .storage = read_station(whole.at("storage"), context),
            .machine = read_station(whole.at("machine"), context),
            .material = {},
            .step = whole.at("step").positive(),
            .clearance = whole.at("clearance").positive(),
            .labels = {}};
  if (cell.step > 90) whole.at("step").bad(fmt::format("must be at most 90, is {}", cell.step));
  const CellEntry material = whole.at("material");
  material.has_only({"solid", "slot", "machine_slot", "drop", "tolerance"});
  cell.material = {.solid = read_solid(material.at("solid"), context),
                   .slot = slot_named(cell.storage, material.at("slot")),
                   .machine_slot = slot_named(cell.machine, material.at("machine_slot")),
                   .tolerance = {}};
  if (const auto drop = material.find("drop")) cell.material.drop = drop->not_negative();
  if (const auto tolerance = material.find("tolerance")) {
    tolerance->has_only({"distance", "degrees"});
    cell.material.tolerance = {tolerance->at("distance").positive(), tolerance->at("degrees").positive()};
  }
  check_names(cell, whole);
  read_labels(cell, whole);
  check_stops(cell);
  check_reach(cell);
  return cell;
}

}  // namespace touchstone::cell
