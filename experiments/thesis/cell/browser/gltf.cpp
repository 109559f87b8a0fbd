// SPDX-License-Identifier: GPL-3.0-or-later
// Writes glTF without libtinygltf: that library would replace base64 and the header of .glb, about 30 lines. Nodes,
// meshes, buffer views and the animation would have to be listed just as here.
#include "experiments/thesis/cell/browser/gltf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/browser/drawing.h"
#include "experiments/thesis/cell/simulation/arm.h"

namespace touchstone::cell::browser {
namespace {

static_assert(std::endian::native == std::endian::little, "buffers of glTF are little endian");

using Json = nlohmann::ordered_json;

// Constants of the format.
constexpr int kFloat = 5126, kUnsigned = 5125, kLines = 1, kTriangles = 4, kVertices = 34962, kIndices = 34963;

enum Colour : int { kRobot, kGripper, kStorage, kMachine, kMaterial, kSphere, kEdge, kObstacle };

Json materials() {
  struct Named {
    const char* name;
    std::array<double, 3> colour;
  };
  constexpr std::array<Named, 8> kMaterials{{{"robot", {0.62, 0.68, 0.74}},
                                             {"gripper", {0.30, 0.36, 0.43}},
                                             {"storage", {0.72, 0.60, 0.42}},
                                             {"machine", {0.52, 0.60, 0.54}},
                                             {"material", {0.94, 0.89, 0.26}},
                                             {"sphere", {0.0, 0.45, 0.70}},
                                             {"edge", {0.10, 0.12, 0.15}},
                                             {"obstacle", {0.60, 0.60, 0.60}}}};
  Json result = Json::array();
  for (const auto& [name, c] : kMaterials)
    result.push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {c[0], c[1], c[2], 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}},
         {"doubleSided", true}});
  return result;
}

Colour colour_of(Carrier carrier) {
  switch (carrier) {
    case Carrier::Link: return kRobot;
    case Carrier::Gripper: return kGripper;
    case Carrier::Storage: return kStorage;
    case Carrier::Machine: return kMachine;
    case Carrier::Obstacle: return kObstacle;
    case Carrier::Material: return kMaterial;
  }
  return kRobot;
}

/// A sphere of triangles around the origin, by rings from pole to pole.
Drawing sphere_of(double radius) {
  constexpr std::uint32_t kRings = 12, kSides = 24;
  Drawing drawing;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double up = std::numbers::pi * ring / kRings, around = 2 * std::numbers::pi * side / kSides;
      drawing.points.push_back(
          radius * Eigen::Vector3d(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up)));
    }
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t a = ring * kSides + side, b = ring * kSides + (side + 1) % kSides;
      if (ring > 0) drawing.triangles.push_back({a, a + kSides, b});
      if (ring + 1 < kRings) drawing.triangles.push_back({b, a + kSides, b + kSides});
    }
  return drawing;
}

class Asset {
 public:
  Asset(const Recording& recording, double stops_per_second) : recording_(&recording), rate_(stops_per_second) {
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "touchstone cell export"}}},
             {"scene", 0},
             {"scenes", {{{"name", recording.cell.name}, {"nodes", {0}}}}},
             {"nodes", Json::array()},
             {"materials", materials()},
             {"meshes", Json::array()},
             {"accessors", Json::array()},
             {"bufferViews", Json::array()}};
    // From z up in the cell's unit to y up in metres.
    const double metre = static_cast<double>(recording.cell.unit.micrometres) * 1e-6, half = std::numbers::sqrt2 / 2;
    json_["nodes"].push_back({{"name", "cell"},
                              {"rotation", {-half, 0.0, 0.0, half}},
                              {"scale", {metre, metre, metre}},
                              {"children", Json::array()}});
    add_nodes();
    if (recording.snapshots.size() > 1) add_animation();
  }

  /// What the JSON refers to.
  [[nodiscard]] const std::string& buffer() const { return buffer_; }
  [[nodiscard]] Json json(const std::string& uri) const {
    Json whole = json_;
    whole["buffers"] = {{{"byteLength", buffer_.size()}}};
    if (!uri.empty()) whole["buffers"][0]["uri"] = uri;
    return whole;
  }

 private:
  /// A node, and where it stands at every stop; where it stands, if it does not move or there is no stop.
  struct Moving {
    std::size_t node;
    std::vector<Pose> poses;
  };

  void add_nodes() {
    const Recording& recording = *recording_;
    const Cell& cell = recording.cell;
    const Arm arm = arm_of(cell);
    const std::vector<Pose> home = arm.link_poses(arm.home);
    for (std::size_t i = 0; i < cell.robot.links.size(); ++i) {
      const std::size_t node = add_node(cell.robot.links[i].name, home[i]);
      Moving moving{node, {}};
      for (const Snapshot& snapshot : recording.snapshots) moving.poses.push_back(snapshot.links[i]);
      moving_.push_back(std::move(moving));
    }
    const std::size_t storage = add_node("storage", pose_of(cell.storage)),
                      machine = add_node("machine", pose_of(cell.machine)),
                      material = add_node("material", recording.places.front()),
                      sphere = add_node("sphere", {Eigen::Matrix3d::Identity(), arm.sphere_at(arm.home).center});
    for (const ModelPart& part : recording.parts) {
      if (part.carrier == Carrier::Obstacle) {
        add_node(part.name, Pose{});
        json_["nodes"].back()["mesh"] = add_mesh(part.name, drawing_of(part.faces), kObstacle);
        continue;
      }
      const std::size_t owner = part.carrier == Carrier::Storage    ? storage
                                : part.carrier == Carrier::Machine  ? machine
                                : part.carrier == Carrier::Material ? material
                                                                    : moving_[part.link].node;
      add_child(owner,
                {{"name", part.name}, {"mesh", add_mesh(part.name, drawing_of(part.faces), colour_of(part.carrier))}});
    }
    json_["nodes"][sphere]["mesh"] = add_mesh("sphere", sphere_of(cell.gripper.sphere.radius), kSphere);

    Moving piece{material, {}}, ball{sphere, {}};
    for (std::size_t i = 0; i < recording.snapshots.size(); ++i) {
      piece.poses.push_back(recording.snapshots[i].material);
      ball.poses.push_back({Eigen::Matrix3d::Identity(), recording.process.stops[i].sphere.center});
    }
    moving_.push_back(std::move(piece));
    moving_.push_back(std::move(ball));
  }

  static Eigen::Quaterniond turn_of(const Pose& pose) { return Eigen::Quaterniond(pose.rotation).normalized(); }

  std::size_t add_child(std::size_t parent, Json node) {
    const std::size_t number = json_["nodes"].size();
    json_["nodes"].push_back(std::move(node));
    json_["nodes"][parent]["children"].push_back(number);
    return number;
  }

  std::size_t add_node(const std::string& name, const Pose& pose) {
    const Eigen::Quaterniond turn = turn_of(pose);
    const Eigen::Vector3d& at = pose.translation;
    return add_child(0, {{"name", name},
                         {"translation", {at.x(), at.y(), at.z()}},
                         {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}}});
  }

  std::size_t add_mesh(const std::string& name, const Drawing& drawing, Colour colour) {
    std::vector<float> points;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3d& point : drawing.points) {
      const Eigen::Vector3f at = point.cast<float>();
      box.extend(at);
      points.insert(points.end(), {at.x(), at.y(), at.z()});
    }
    const std::size_t positions = add_accessor(std::span<const float>(points), kFloat, "VEC3", 3, kVertices);
    json_["accessors"][positions]["min"] = {box.min().x(), box.min().y(), box.min().z()};
    json_["accessors"][positions]["max"] = {box.max().x(), box.max().y(), box.max().z()};
    const auto primitive = [&](const auto& figures, int mode, Colour its_colour) {
      std::vector<std::uint32_t> corners;
      for (const auto& figure : figures) corners.insert(corners.end(), figure.begin(), figure.end());
      const std::size_t indices =
          add_accessor(std::span<const std::uint32_t>(corners), kUnsigned, "SCALAR", 1, kIndices);
      return Json{{"attributes", {{"POSITION", positions}}},
                  {"indices", indices},
                  {"mode", mode},
                  {"material", static_cast<int>(its_colour)}};
    };
    Json primitives = Json::array({primitive(drawing.triangles, kTriangles, colour)});
    if (!drawing.outline.empty()) primitives.push_back(primitive(drawing.outline, kLines, kEdge));
    json_["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
    return json_["meshes"].size() - 1;
  }

  template <class T>
  std::size_t add_accessor(std::span<const T> values, int component, const char* type, std::size_t width, int target) {
    static_assert(sizeof(T) == 4, "every view begins at a multiple of 4");
    Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", values.size_bytes()}};
    if (target != 0) view["target"] = target;
    json_["bufferViews"].push_back(std::move(view));
    buffer_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", values.size() / width},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
  }

  void add_animation() {
    std::vector<float> times;
    for (std::size_t i = 0; i < recording_->snapshots.size(); ++i)
      times.push_back(static_cast<float>(static_cast<double>(i) / rate_));
    const std::size_t input = add_accessor(std::span<const float>(times), kFloat, "SCALAR", 1, 0);
    json_["accessors"][input]["min"] = {times.front()};
    json_["accessors"][input]["max"] = {times.back()};

    Json samplers = Json::array(), channels = Json::array();
    const auto animate = [&](std::size_t node, const char* path, const std::vector<float>& values, std::size_t width) {
      const std::size_t output =
          add_accessor(std::span<const float>(values), kFloat, width == 3 ? "VEC3" : "VEC4", width, 0);
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
      samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    };
    for (const Moving& moving : moving_) {
      if (std::all_of(moving.poses.begin(), moving.poses.end(), [&](const Pose& p) { return p == moving.poses[0]; }))
        continue;
      std::vector<float> places, turns;
      Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
      for (const Pose& pose : moving.poses) {
        for (const double coordinate : pose.translation) places.push_back(static_cast<float>(coordinate));
        Eigen::Quaterniond turn = turn_of(pose);
        if (turn.dot(last) < 0) turn.coeffs() = -turn.coeffs();  // of the two that mean the same, the nearer
        last = turn;
        for (const double coefficient : turn.coeffs()) turns.push_back(static_cast<float>(coefficient));
      }
      animate(moving.node, "translation", places, 3);
      animate(moving.node, "rotation", turns, 4);
    }
    if (!channels.empty())
      json_["animations"] = {{{"name", "run"}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}}};
  }

  const Recording* recording_;
  double rate_;
  Json json_;
  std::string buffer_;
  std::vector<Moving> moving_;
};

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

void append_word(std::string& bytes, std::size_t value) {
  if (value > 0xFFFFFFFFU) throw std::length_error("a .glb file holds less than 4 GB");
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255U);
}

}  // namespace

std::string gltf_text(const Recording& recording, double stops_per_second) {
  const Asset asset(recording, stops_per_second);
  return asset.json("data:application/octet-stream;base64," + base64(asset.buffer())).dump(1) + "\n";
}

std::string gltf_binary(const Recording& recording, double stops_per_second) {
  const Asset asset(recording, stops_per_second);
  std::string json = asset.json("").dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string& buffer = asset.buffer();  // every view is a multiple of 4 long
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes, 12 + 8 + json.size() + 8 + buffer.size());
  append_word(bytes, json.size());
  bytes += "JSON" + json;
  append_word(bytes, buffer.size());
  bytes.append("BIN\0", 4);
  return bytes + buffer;
}

}  // namespace touchstone::cell::browser
