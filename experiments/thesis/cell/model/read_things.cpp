// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_things.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/read_robot.h"

namespace touchstone::cell {

namespace {

/// Reads a storage or a machine by the keys of read_cell.
Station read_station(const CellEntry& entry, std::string name, const SolidContext& context) {
  Station station{entry.at("home").number(),
                  entry.at("angle").number(),
                  entry.at("radius").positive(),
                  entry.at("height").not_negative(),
                  {},
                  read_parts(entry.at("parts"), context),
                  {}};
  station.name = std::move(name);
  station.key = entry.path();
  if (const auto turn = entry.find("turn")) station.turn = turn->number();
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

constexpr double kOffPlane = 1e-6;  // of the face's size

Zone::Face read_face(const CellEntry& entry) {
  Zone::Face face;
  for (const CellEntry& corner : entry.items()) face.corners.push_back(corner.point());
  const std::size_t count = face.corners.size();
  if (count < 3) entry.bad("needs at least three corners");
  const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& { return face.corners[i % count]; };
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < count; ++i) {
    normal += (corner(i) - corner(0)).cross(corner(i + 1) - corner(0));
    size = std::max(size, (corner(i) - corner(0)).norm());
  }
  if (!(normal.norm() > 0)) entry.bad("its corners lie on a line");
  normal.normalize();
  double turned = 0;  // in all
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d in = corner(i + 1) - corner(i), out = corner(i + 2) - corner(i + 1);
    const double across = in.cross(out).dot(normal);
    if (!(across > 0)) entry.bad("its corners do not turn in one direction: a face is convex");
    turned += std::atan2(across, in.dot(out));
    if (std::abs(normal.dot(corner(i) - corner(0))) > kOffPlane * size) entry.bad("its corners are not in one plane");
  }
  if (turned > 7) entry.bad("its corners go round more than once");  // than 2 pi
  return face;
}

Eigen::AlignedBox3d read_cuboid(const CellEntry& entry) {
  entry.has_only({"from", "to"});
  Eigen::AlignedBox3d box(entry.at("from").point(), entry.at("to").point());
  if (!(box.min().array() < box.max().array()).all()) entry.bad("\"from\" must be less than \"to\" in each coordinate");
  return box;
}

Zone::Capsule read_ball(const CellEntry& entry) {
  entry.has_only({"at", "radius"});
  const Eigen::Vector3d at = entry.at("at").point();
  return {at, at, entry.at("radius").positive()};
}

Zone::Capsule read_capsule(const CellEntry& entry) {
  entry.has_only({"from", "to", "radius"});
  return {entry.at("from").point(), entry.at("to").point(), entry.at("radius").positive()};
}

/// Reads a virtual object: name; one of
///   "face":    [[x, y, z], ...], the corners of a convex polygon, in order;
///   "box":     {"from": [x, y, z], "to": [x, y, z]};
///   "sphere":  {"at": [x, y, z], "radius": r};
///   "capsule": {"from": [x, y, z], "to": [x, y, z], "radius": r}, a cylinder with two half balls;
/// and, optionally, "move": [x, y, z], and "stops": true if the robot is to stop. Throws BadCell, also for a face whose
/// corners do not turn in one direction, or are off its plane by more than a millionth of its size.
Zone read_zone(const CellEntry& entry) {
  entry.has_only({"name", "face", "box", "sphere", "capsule", "move", "stops"});
  std::optional<decltype(Zone::shape)> shape;
  const auto take = [&](const char* key, const auto& read) {
    const auto given = entry.find(key);
    if (!given) return;
    if (shape) entry.bad("has more than one shape");
    shape = read(*given);
  };
  take("face", read_face);
  take("box", read_cuboid);
  take("sphere", read_ball);
  take("capsule", read_capsule);
  if (!shape) entry.bad("has no shape: face, box, sphere or capsule");
  Zone zone{entry.at("name").name(), std::move(*shape), {}, false};
  if (const auto move = entry.find("move")) zone.pose.translation = move->point();
  if (const auto stops = entry.find("stops")) zone.stops = stops->yes();
  return zone;
}

/// A thing that the file gives by a key of its own, which is then its name, or in a list, where it has a name.
struct Given {
  CellEntry entry;
  std::string name;
  bool listed;

  /// Throws BadCell unless it has these keys only or, if it is listed, also the first ones.
  void has_only(std::vector<std::string_view> if_listed, const std::vector<std::string_view>& keys) const {
    if (!listed) if_listed.clear();
    if_listed.insert(if_listed.end(), keys.begin(), keys.end());
    entry.has_only(if_listed);
  }
};

std::vector<Given> given(const CellEntry& whole, const std::string& one, const std::string& several) {
  std::vector<Given> all;
  const auto list = whole.find(several);
  if (const auto entry = whole.find(one)) all.push_back({*entry, one, false});
  if (list)
    for (const CellEntry& item : list->items()) all.push_back({item, item.at("name").name(), true});
  if (all.empty()) static_cast<void>(whole.at(one));
  return all;
}

/// The one of some things that an entry names; without a name the only one, or the one that has a key of its own.
std::size_t meant(const CellEntry& entry, const std::string& key, const std::vector<Given>& things) {
  std::string names;
  for (const Given& thing : things) names += (names.empty() ? "" : ", ") + thing.name;
  const auto named = entry.find(key);
  if (!named && (things.size() == 1 || !things.front().listed)) return 0;
  if (!named) entry.bad(fmt::format("must say by \"{}\" which: there are {}", key, names));
  const auto found = std::ranges::find(things, named->text(), &Given::name);
  if (found == things.end()) named->bad(fmt::format("\"{}\" is not one of {}", named->text(), names));
  return static_cast<std::size_t>(found - things.begin());
}

Plant::PlacedRobot read_placed(const Given& thing, const CellEntry& whole, const std::filesystem::path& folder,
                               const SolidContext& context) {
  const CellEntry& entry = thing.entry;
  thing.has_only({"name", "place", "turn", "gripper"}, {"urdf", "height", "home", "speeds", "accelerations", "sides",
                                                        "coupling", "links", "packages", "root", "tip", "still"});
  Plant::PlacedRobot placed{thing.name, {}, 0, read_robot(entry, folder, context), {}};
  placed.gripper = read_gripper(thing.listed ? entry.at("gripper") : whole.at("gripper"), context);
  if (const auto place = entry.find("place")) placed.frame.translation.head<2>() = place->point2();
  if (const auto turn = entry.find("turn")) placed.turn = turn->number();
  if (placed.turn != 0) placed.frame.rotation = rotation_about(Eigen::Vector3d::UnitZ(), placed.turn);
  return placed;
}

Plant::PlacedStation read_placed(const Given& thing, const std::vector<Given>& robots, const SolidContext& context) {
  thing.has_only({"name"}, {"home", "angle", "radius", "height", "slots", "parts", "stand", "about", "turn"});
  return {read_station(thing.entry, thing.name, context),
          thing.entry.find("about") ? meant(thing.entry, "about", robots) : 0};
}

struct Handlers {
  const std::vector<Given>&robots, &storages, &machines;
};

Plant::Piece read_piece(const Given& thing, const Plant& plant, const Handlers& by, const SolidContext& context) {
  const CellEntry& entry = thing.entry;
  thing.has_only({"name"}, {"robot", "storage", "machine", "solid", "slot", "machine_slot", "drop", "tolerance",
                            "milling_seconds"});
  Plant::Piece piece{thing.name,
                     entry.path(),
                     {},
                     meant(entry, "robot", by.robots),
                     meant(entry, "storage", by.storages),
                     meant(entry, "machine", by.machines)};
  const Station &storage = plant.storages[piece.storage].station, &machine = plant.machines[piece.machine].station;
  piece.material = {.solid = read_solid(entry.at("solid"), context),
                    .slot = slot_named(storage, entry.at("slot")),
                    .machine_slot = slot_named(machine, entry.at("machine_slot")),
                    .tolerance = {}};
  if (const auto seconds = entry.find("milling_seconds")) piece.material.milling_seconds = seconds->seconds();
  if (const auto drop = entry.find("drop")) piece.material.drop = drop->not_negative();
  if (const auto tolerance = entry.find("tolerance")) {
    tolerance->has_only({"distance", "degrees"});
    piece.material.tolerance = {tolerance->at("distance").positive(), tolerance->at("degrees").positive()};
  }
  for (const Plant::Piece& other : plant.pieces)
    if (other.storage == piece.storage && other.material.slot == piece.material.slot)
      entry.at("slot").bad(fmt::format("\"{}\" lies there", other.name));
  return piece;
}

/// Parts are told apart by the link or thing that they belong to: none may share its name with another.
class Names {
 public:
  explicit Names(const Plant& plant) {
    for (const Plant::PlacedRobot& robot : plant.robots)
      for (const Link& link : robot.robot.links) links_.insert(link.name);
  }

  void take(const std::vector<Given>& things) {
    for (const Given& thing : things)
      if (thing.listed) take(thing.entry.at("name"));
  }
  void take(const CellEntry& entry) {
    const std::string name = entry.name();
    if (links_.contains(name) || !names_.insert(name).second) entry.bad("a link, or something else, has this name");
  }
  void refuse(const CellEntry& entry) const {
    if (links_.contains(entry.name()) || names_.contains(entry.name()))
      entry.bad("a link, or something else, has this name");
  }

 private:
  std::set<std::string> names_{"robot", "gripper", "storage", "machine", "material"}, links_;
};

void check_links(const Given& robot, const Robot& read) {
  std::set<std::string> names{"gripper", "storage", "machine", "material"};
  for (const Link& link : read.links)
    if (!names.insert(link.name).second)
      robot.entry.at("urdf").bad(fmt::format("\"{}\" is not a valid name for a link", link.name));
}

}  // namespace

std::size_t slot_named(const Station& station, const CellEntry& entry) {
  const std::string name = entry.text();
  for (std::size_t i = 0; i < station.slots.size(); ++i)
    if (station.slots[i].name == name) return i;
  entry.bad(fmt::format("there is no slot \"{}\"", name));
}

void read_things(Plant& plant, const CellEntry& whole, const std::filesystem::path& folder,
                 const SolidContext& context) {
  const auto robots = given(whole, "robot", "robots");
  if (robots.front().listed)
    if (const auto gripper = whole.find("gripper")) gripper->bad("belongs to the key \"robot\", which is missing");
  for (const Given& robot : robots) plant.robots.push_back(read_placed(robot, whole, folder, context));
  const auto storages = given(whole, "storage", "storages"), machines = given(whole, "machine", "machines"),
             pieces = given(whole, "material", "materials");
  for (const Given& thing : storages) plant.storages.push_back(read_placed(thing, robots, context));
  for (const Given& thing : machines) plant.machines.push_back(read_placed(thing, robots, context));
  for (const Given& thing : pieces)
    plant.pieces.push_back(read_piece(thing, plant, {robots, storages, machines}, context));
  if (const auto obstacles = whole.find("obstacles"); obstacles && !obstacles->items().empty())
    plant.obstacles = read_parts(*obstacles, context);
  if (const auto zones = whole.find("zones"))
    for (const CellEntry& zone : zones->items()) plant.zones.push_back(read_zone(zone));

  for (std::size_t i = 0; i < robots.size(); ++i) check_links(robots[i], plant.robots[i].robot);
  Names names(plant);
  for (const auto* things : {&robots, &storages, &machines, &pieces}) names.take(*things);
  for (const char* list : {"obstacles", "zones"})
    if (const auto entries = whole.find(list))
      for (const CellEntry& entry : entries->items()) names.take(entry.at("name"));
  for (const Given& robot : robots) {
    const CellEntry gripper = robot.listed ? robot.entry.at("gripper") : whole.at("gripper");
    for (const CellEntry& part : gripper.at("parts").items()) names.refuse(part.at("name"));
    if (const auto fingers = gripper.find("fingers"))
      for (const CellEntry& part : fingers->at("parts").items()) names.refuse(part.at("name"));
  }
  for (const Plant::Piece& piece : plant.pieces)
    for (const Part& part : plant.storages[piece.storage].station.parts)
      if (part.name == piece.name)
        whole.bad(fmt::format("{}: a part of the storage has the name \"{}\", too", piece.key, piece.name));
}

}  // namespace touchstone::cell
