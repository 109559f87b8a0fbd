// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/cell_json.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/thesis/cell/browser/drawing.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell::browser {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Eigen::Vector3d& at) { return {at.x(), at.y(), at.z()}; }

Json element(const char* kind, const std::string& key, const std::string& name, Json fields) {
  return {{"kind", kind}, {"key", key}, {"name", name}, {"listed", key.back() == ']'}, {"fields", std::move(fields)}};
}

Json field(const std::string& path, Json value) { return {{"path", path}, {"value", std::move(value)}}; }

Json station(const char* kind, const Station& given) {
  const auto at = [&](const char* key, double value) { return field(given.key + "." + key, value); };
  return element(
      kind, given.key, given.name,
      {at("angle", given.angle), at("radius", given.radius), at("height", given.height), at("turn", given.turn)});
}

/// What a cell file consists of: [{kind, key, name, listed, fields: [{path, value}]}]. A field is a number, an array of
/// numbers or true or false that the page can change by `path=value`; what is listed can be removed by `key=null`.
Json elements_json(const Plant& plant) {
  Json all = Json::array();
  for (const Plant::PlacedRobot& robot : plant.robots) {
    const std::string& key = robot.robot.key;
    Json fields = Json::array();
    if (key != "robot") {
      const Eigen::Vector3d& at = robot.frame.translation;
      fields = {field(key + ".place", {at.x(), at.y()}), field(key + ".turn", robot.turn)};
    }
    all.push_back(element("robot", key, robot.name, std::move(fields)));
  }
  for (const Plant::PlacedStation& placed : plant.storages) all.push_back(station("storage", placed.station));
  for (const Plant::PlacedStation& placed : plant.machines) all.push_back(station("machine", placed.station));
  for (const Plant::Piece& piece : plant.pieces)
    all.push_back(element("material", piece.key, piece.name, Json::array()));
  for (std::size_t i = 0; i < plant.obstacles.size(); ++i) {
    const std::string key = fmt::format("obstacles[{}]", i);
    all.push_back(element("obstacle", key, plant.obstacles[i].name,
                          Json::array({field(key + ".move", triple(plant.obstacles[i].solid.pose.translation))})));
  }
  for (std::size_t i = 0; i < plant.zones.size(); ++i) {
    const std::string key = fmt::format("zones[{}]", i);
    all.push_back(element(
        "zone", key, plant.zones[i].name,
        {field(key + ".move", triple(plant.zones[i].pose.translation)), field(key + ".stops", plant.zones[i].stops)}));
  }
  return all;
}

/// Returns the direction of a face, in the frame of the material.
std::string side_of(const Polygon& face) {
  const double up = doubled_area(face).z(), area = doubled_area(face).norm();
  return up > 0.9 * area ? "top" : up < -0.9 * area ? "underside" : "side";
}

Json station_json(const Station& station) {
  return {{"home", station.home},
          {"angle", station.angle},
          {"radius", station.radius},
          {"height", station.height},
          {"turn", station.turn}};
}

Json setting_json(const Cell& cell, const std::string& drive) {
  const Setting setting = setting_of(cell);
  return {{"storage", {{"angle", setting.angle}, {"radius", setting.radius}, {"height", setting.height}}},
          {"slot", cell.storage.slots[setting.slot].name},
          {"step", setting.step},
          {"drive", drive}};
}

Json labels_json(const Cell& cell) {
  Json labels;
  for (const char* path : {"storage.angle", "storage.radius", "storage.height", "step", "clearance", "machine.angle",
                           "machine.radius", "machine.height", "gripper.sphere.radius"})
    labels[path] = std::string(1, static_cast<char>(cell.label(path)));
  return labels;
}

const ModelPart& material_of(const std::vector<ModelPart>& parts) { return parts.back(); }

Json json_of(const Pose& pose) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) rows.push_back(drawn(pose.rotation(i, k)));
    rows.push_back(drawn(pose.translation[i]));
  }
  return rows;
}

Json links_json(const std::vector<Pose>& links) {
  Json poses = Json::array();
  for (const Pose& pose : links) poses.push_back(json_of(pose));
  return poses;
}

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Millionths suffice for what is shown.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json separation_json(const Recording& recording) {
  const Separation& separation = recording.separation;
  Json least = Json::array(), nearest;
  for (const LeastDistance& each : separation.least)
    least.push_back({{"mover", to_string(each.mover)},
                     {"element", each.element},
                     {"part", each.part},
                     {"low", each.bounds.lower},
                     {"high", each.bounds.upper},
                     {"stop", each.stop},
                     {"seconds", optional(recording.timing.after(each.stop, each.degrees))}});
  for (const Mover mover : kMovers) {
    Json here = Json::array(), low = Json::array(), element = Json::array();
    for (const auto& at : separation.nearest[static_cast<std::size_t>(mover)]) {
      here.push_back(at ? Json(rounded(at->here)) : Json());
      low.push_back(at ? Json(std::floor(at->bounds.lower * 1e6) / 1e6) : Json());
      element.push_back(at ? Json(at->element) : Json());
    }
    nearest[std::string(to_string(mover))] = {
        {"here", std::move(here)}, {"low", std::move(low)}, {"element", std::move(element)}};
  }
  return {{"elements", separation.elements},
          {"tolerance", separation.tolerance},
          {"least", std::move(least)},
          {"nearest", std::move(nearest)}};
}

Json stuck_json(const Recording& recording, const Arm& arm) {
  if (!recording.stuck) return {};
  const Stuck& stuck = *recording.process.stuck;
  return {{"reason", stuck.reason},
          {"parts", stuck.parts},
          {"commanded", stuck.commanded},
          {"links", links_json(recording.stuck->links)},
          {"sphere", drawn(arm.sphere_at(stuck.commanded).center)},
          {"material", json_of(recording.stuck->material)},
          {"closed", recording.stuck->closed},
          {"place", recording.stuck->slot ? Json(to_string(*recording.stuck->slot)) : Json()}};
}

}  // namespace

std::string cell_json(const Simulator& simulator) {
  const Cell& cell = simulator.cell();
  const Arm arm = arm_of(cell);
  Json joints = Json::array();
  for (std::size_t i = 0; i < arm.home.size(); ++i) {
    const kinematics::Joint& joint = arm.chain.joints()[i];
    joints.push_back({{"name", joint.name}, {"lower", joint.lowest}, {"upper", joint.highest}, {"home", arm.home[i]}});
  }
  Json slots = Json::array(), parts = Json::array(), sides = Json::array();
  for (const Slot& slot : cell.storage.slots) slots.push_back({{"name", slot.name}, {"place", drawn(slot.place)}});
  std::size_t finger = 0;
  for (const ModelPart& part : simulator.parts()) {
    parts.push_back(part_json(part));
    if (part.carrier != Carrier::Finger) continue;
    parts.back()["finger"] = finger;
    parts.back()["closes"] = drawn(cell.gripper.fingers->shift(finger++, 1));
  }
  for (const Face& face : material_of(simulator.parts()).faces.faces) sides.push_back(side_of(face.polygon));
  Json pieces = Json::array(), elements = Json::array();
  std::string piece = "material";
  if (const Plant* plant = simulator.plant()) {
    for (const Plant::Piece& each : plant->pieces) pieces.push_back(each.name);
    piece = plant->pieces[simulator.piece()].name;
    elements = elements_json(*plant);
  }
  const Json whole = {{"name", cell.name},
                      {"unit", cell.unit.name},
                      {"piece", piece},
                      {"pieces", std::move(pieces)},
                      {"elements", std::move(elements)},
                      {"zones", zones_json(cell)},
                      {"sphere", cell.gripper.sphere.radius},
                      {"robot", {{"name", cell.robot.name}, {"joints", std::move(joints)}}},
                      {"setting", setting_json(cell, simulator.setting().drive)},
                      {"drives", simulator.drives()},
                      {"labels", labels_json(cell)},
                      {"bounds", {{"longest", longest(cell)}}},
                      {"slots", std::move(slots)},
                      {"storage", station_json(cell.storage)},
                      {"machine", station_json(cell.machine)},
                      {"links", links_json(arm.link_poses(arm.home))},
                      {"home_sphere", drawn(arm.sphere_at(arm.home).center)},
                      {"material_faces", std::move(sides)},
                      {"parts", std::move(parts)}};
  return whole.dump();
}

std::string run_json(const Recording& recording) {
  const Process& process = recording.process;
  const Arm arm = arm_of(recording.cell);
  const auto numbers = scene_faces(material_of(recording.parts).faces).numbers;

  Json moves = Json::array();
  for (const Move& move : process.moves) {
    Json contact;
    if (move.contact)
      contact = {{"low", move.contact->low}, {"high", move.contact->high}, {"kind", to_string(move.contact->kind)}};
    moves.push_back({{"phase", to_string(move.phase)},
                     {"joint", arm.chain.joints()[move.joint].name},
                     {"until", to_string(move.until)},
                     {"degrees", move.degrees},
                     {"exact", move.exact},
                     {"contact", std::move(contact)},
                     {"rise", move.rise},
                     {"seconds", optional(recording.timing.move(moves.size()))},
                     {"wrong", move.wrong ? Json{{"early", move.wrong->early ? Json(*move.wrong->early) : Json()},
                                                 {"gap", move.wrong->gap}}
                                          : Json()}});
  }

  Json stops = Json::array();
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    const Snapshot& snapshot = recording.snapshots[i];
    const auto word = [](const std::optional<StationSlot>& p) { return p ? Json(to_string(*p)) : Json(); };
    stops.push_back({{"move", stop.move},
                     {"commanded", stop.commanded},
                     {"links", links_json(snapshot.links)},
                     {"sphere", drawn(stop.sphere.center)},
                     {"material", json_of(snapshot.material)},
                     {"closed", snapshot.closed},
                     {"place", word(snapshot.slot)},
                     {"target", word(stop.target)},
                     {"nearest", snapshot.nearest ? Json(numbers[snapshot.nearest->face.face]) : Json()},
                     {"distance", snapshot.nearest ? Json(snapshot.nearest->distance) : Json()},
                     {"touched", stop.touched ? Json(numbers[*stop.touched]) : Json()}});
  }

  Json transfers = Json::array();
  for (const MaterialTransfer& transfer : process.transfers) {
    Json grip, landing;
    if (transfer.grip) {
      grip = {{"opening", transfer.grip->opening}, {"faces", Json::array()}};
      for (const FingerContact& finger : transfer.grip->fingers) {
        Json faces = Json::array();
        for (const std::size_t face : finger.faces) faces.push_back(numbers[face]);
        grip["faces"].push_back(std::move(faces));
      }
    }
    if (transfer.landing) landing = {{"support", transfer.landing->support}, {"gap", transfer.landing->gap}};
    transfers.push_back({{"stop", transfer.stop}, {"grip", std::move(grip)}, {"landing", std::move(landing)}});
  }

  Json methods = Json::array(), disagreements = Json::array();
  for (const Score& score : recording.comparison.scores)
    methods.push_back({{"name", score.method->name()},
                       {"asked", score.asked},
                       {"wrong", score.wrong_hits + score.wrong_misses},
                       {"unsure", score.unsure}});
  for (const Disagreement& d : recording.comparison.disagreements)
    disagreements.push_back({{"stop", d.stop},
                             {"owner", d.owner},
                             {"face", d.owner == "material" ? numbers[d.face] : d.face},
                             {"methods", d.methods}});

  Json triggers = Json::array();
  for (const Trigger& trigger : process.triggers)
    triggers.push_back({{"zone", recording.cell.zones[trigger.zone].name},
                        {"mover", to_string(trigger.mover)},
                        {"part", trigger.part},
                        {"after", trigger.after},
                        {"degrees", trigger.degrees},
                        {"until", trigger.until}});

  Json stand;
  for (const ModelPart& part : recording.parts)
    if (part.name == recording.cell.storage.name + "/stand") stand = part_json(part);
  const Json whole = {
      {"setting", setting_json(recording.cell, recording.drive)},
      {"labels", labels_json(recording.cell)},
      {"failure", process.failure},
      {"refused", process.refused},
      {"stuck", stuck_json(recording, arm)},
      {"times", recording.timing.arrivals()},
      {"waits", recording.timing.waits()},
      {"cycle", recording.timing.text()},
      {"separation", separation_json(recording)},
      {"stations",
       {{"storage", json_of(pose_of(recording.cell.storage))}, {"machine", json_of(pose_of(recording.cell.machine))}}},
      {"materials", {{"storage", json_of(recording.places[0])}, {"machine", json_of(recording.places[1])}}},
      {"stand", std::move(stand)},
      {"moves", std::move(moves)},
      {"stops", std::move(stops)},
      {"methods", std::move(methods)},
      {"disagreements", std::move(disagreements)},
      {"transfers", std::move(transfers)},
      {"triggers", std::move(triggers)}};
  return whole.dump();
}

std::string pose_json(const Posed& posed) {
  Json nearest = Json::array();
  for (const Mover mover : kMovers)
    if (const auto& at = posed.separation.nearest[static_cast<std::size_t>(mover)].front())
      nearest.push_back(
          {{"mover", to_string(mover)}, {"element", posed.separation.elements[at->element]}, {"distance", at->here}});
  const Json whole{
      {"links", links_json(posed.links)},
      {"sphere", drawn(posed.sphere.center)},
      {"hindrance",
       posed.hindrance ? Json{{"what", posed.hindrance->what}, {"parts", posed.hindrance->parts}} : Json()},
      {"nearest", std::move(nearest)}};
  return whole.dump();
}

std::string area_json(const std::vector<Tried>& tried) {
  Json places = Json::array();
  for (const Tried& each : tried)
    places.push_back({{"radius", each.radius},
                      {"cause", each.cause ? Json(to_string(*each.cause)) : Json()},
                      {"reason", each.reason}});
  return places.dump();
}

}  // namespace touchstone::cell::browser
