// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/elements_json.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

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

/// The edges of a virtual object.
struct Edges {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> all;

  void operator()(const Zone::Face& face) {
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      all.emplace_back(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
  }
  void operator()(const Zone::Cuboid& box) {
    const auto corner = [&](unsigned bits) {
      Eigen::Vector3d p;
      for (int i = 0; i < 3; ++i) p[i] = ((bits >> i) & 1U) != 0 ? box.upper[i] : box.lower[i];
      return p;
    };
    for (unsigned bits = 0; bits < 8; ++bits)
      for (unsigned i = 0; i < 3; ++i)
        if (((bits >> i) & 1U) == 0) all.emplace_back(corner(bits), corner(bits | (1U << i)));
  }
  /// Circles across the axis at both ends, half circles beyond them, and lines along it.
  void operator()(const Zone::Capsule& capsule) {
    const Eigen::Vector3d way = capsule.to - capsule.from;
    const Eigen::Vector3d along = way.norm() > 0 ? Eigen::Vector3d(way.normalized()) : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d one = along.unitOrthogonal(), other = along.cross(one);
    constexpr int kSides = 32;
    const auto arc = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int sides) {
      const auto point = [&](int i) -> Eigen::Vector3d {
        const double angle = 2 * std::numbers::pi * i / kSides;
        return at + capsule.radius * (std::cos(angle) * u + std::sin(angle) * v);
      };
      for (int i = 0; i < sides; ++i) all.emplace_back(point(i), point(i + 1));
    };
    for (const Eigen::Vector3d& end : {capsule.from, capsule.to}) arc(end, one, other, kSides);
    for (const Eigen::Vector3d& across : {one, other}) {
      arc(capsule.to, across, along, kSides / 2);
      arc(capsule.from, across, -along, kSides / 2);
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d out = side * capsule.radius * across;
        all.emplace_back(capsule.from + out, capsule.to + out);
      }
    }
  }
};

}  // namespace

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

Json zones_json(const Cell& cell) {
  Json zones = Json::array();
  for (const Zone& zone : cell.zones) {
    Edges edges;
    std::visit(edges, zone.shape);
    Json points = Json::array(), outline = Json::array();
    for (const auto& [from, to] : edges.all)
      for (const Eigen::Vector3d& end : {from, to}) {
        outline.push_back(outline.size());
        const Eigen::Vector3d at = zone.pose * end;
        for (const double coordinate : at) points.push_back(static_cast<float>(coordinate));
      }
    zones.push_back({{"name", zone.name},
                     {"stops", zone.stops},
                     {"points", std::move(points)},
                     {"triangles", Json::array()},
                     {"face_ends", Json::array()},
                     {"outline", std::move(outline)}});
  }
  return zones;
}

}  // namespace touchstone::cell::browser
