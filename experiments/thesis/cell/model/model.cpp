// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/model.h"

#include <array>
#include <utility>

namespace touchstone::cell {
namespace {

struct Named {
  Carrier carrier;
  std::size_t link;
  std::string name;
  Solid solid;
};

std::vector<Named> solids_of(const Cell& cell) {
  std::vector<Named> result;
  const auto add = [&](Carrier carrier, std::size_t link, const std::string& owner, const std::vector<Part>& parts) {
    for (const Part& part : parts) result.push_back({carrier, link, owner + "/" + part.name, part.solid});
  };
  const Robot& robot = cell.robot;
  for (std::size_t i = 0; i < robot.links.size(); ++i) add(Carrier::Link, i, robot.links[i].name, robot.links[i].parts);
  add(Carrier::Gripper, robot.links.size() - 1, "gripper", cell.gripper.parts);
  if (const auto& fingers = cell.gripper.fingers)
    add(Carrier::Finger, robot.links.size() - 1, "gripper", {fingers->parts.begin(), fingers->parts.end()});
  const auto add_station = [&](Carrier carrier, const Station& station) {
    add(carrier, 0, station.name, station.parts);
    if (station.stand) result.push_back({carrier, 0, station.name + "/stand", stand_of(station)});
  };
  add_station(Carrier::Storage, cell.storage);
  add_station(Carrier::Machine, cell.machine);
  for (const Part& obstacle : cell.obstacles) result.push_back({Carrier::Obstacle, 0, obstacle.name, obstacle.solid});
  result.push_back({Carrier::Material, 0, "material", cell.material.solid});
  return result;
}

}  // namespace

std::string_view to_string(Carrier carrier) {
  constexpr std::array<std::string_view, 7> words{"link",    "gripper",  "finger",  "storage",
                                                  "machine", "obstacle", "material"};
  return words[static_cast<std::size_t>(carrier)];
}

std::vector<ModelPart> build_model(const Cell& cell, const std::function<void(std::size_t, std::size_t)>& done) {
  std::vector<Named> solids = solids_of(cell);
  std::vector<ModelPart> parts;
  for (Named& each : solids) {
    SolidFaces faces = faces_of(each.solid, cell.file.string() + ": " + each.name);
    parts.push_back({each.carrier, each.link, std::move(each.name), std::move(faces)});
    if (done) done(parts.size(), solids.size());
  }
  return parts;
}

ModelFaces scene_faces(const SolidFaces& solid) {
  ModelFaces result;
  std::vector<std::size_t> polygons;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    const Polygon& polygon = solid.faces[i].polygon;
    if (polygon.vertex_count() == 3) {
      result.faces.triangles.push_back({polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)});
      result.numbers.push_back(i);
    } else {
      result.faces.polygons.push_back(polygon);
      polygons.push_back(i);
    }
  }
  result.numbers.insert(result.numbers.end(), polygons.begin(), polygons.end());
  return result;
}

std::vector<Polygon> polygons_of(const scene::Faces& faces) {
  std::vector<Polygon> polygons;
  for (const Triangle& t : faces.triangles) polygons.emplace_back(Loop{t.a, t.b, t.c});
  polygons.insert(polygons.end(), faces.polygons.begin(), faces.polygons.end());
  return polygons;
}

}  // namespace touchstone::cell
