// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/simulation/workcell.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "experiments/workloads/degrees.h"
#include "robust/scene/posing.h"

namespace touchstone::cell {
namespace {

scene::Faces posed(const Pose& pose, const scene::Faces& faces) {
  scene::Faces result;
  for (const Triangle& triangle : faces.triangles) result.triangles.push_back(scene::posed(pose, triangle));
  for (const Polygon& polygon : faces.polygons) result.polygons.push_back(scene::posed(pose, polygon));
  return result;
}

void append(scene::Faces& all, const scene::Faces& more) {
  all.triangles.insert(all.triangles.end(), more.triangles.begin(), more.triangles.end());
  all.polygons.insert(all.polygons.end(), more.polygons.begin(), more.polygons.end());
}

/// Around all vertices, seen along and across a direction of the plan.
Eigen::AlignedBox3d box_along(const scene::Faces& faces, double azimuth) {
  Eigen::Matrix3d turned;
  const double c = workloads::cosine(azimuth), s = workloads::sine(azimuth);
  turned << c, s, 0, -s, c, 0, 0, 0, 1;
  Eigen::AlignedBox3d box;
  const auto extend = [&](const Eigen::Vector3d& vertex) { box.extend(Eigen::Vector3d(turned * vertex)); };
  for (const Triangle& t : faces.triangles) extend(t.a), extend(t.b), extend(t.c);
  for (const Polygon& polygon : faces.polygons)
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) extend(polygon.vertex(i));
  return box;
}

Workplace workplace(const Station& station, const Slot& slot, const scene::Faces& material) {
  const double x = station.radius + slot.aim.x(), y = slot.aim.y();
  const Pose frame = pose_of(station);
  Workplace place;
  place.azimuth = station.azimuth() + workloads::arc_tangent(y, x);
  place.out = std::sqrt(x * x + y * y);
  place.pose = {frame.rotation, frame.rotation * slot.place + frame.translation};
  place.faces = posed(place.pose, material);
  const Eigen::AlignedBox3d box = box_along(place.faces, place.azimuth);
  place.bottom = box.min().z();
  place.top = box.max().z();
  place.right = box.min().y();
  place.left = box.max().y();
  return place;
}

}  // namespace

std::string_view to_string(StationSlot slot) { return slot == StationSlot::Storage ? "storage" : "machine"; }

Pose pose_of(const Station& station) {
  const double c = workloads::cosine(station.azimuth()), s = workloads::sine(station.azimuth());
  Pose pose;
  pose.rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  pose.translation << c * station.radius, s * station.radius, station.height;
  return pose;
}

std::vector<Covered> cover_arm(const std::vector<ModelPart>& parts, double overhang) {
  std::vector<Covered> covered;
  for (const ModelPart& part : parts) {
    if (part.carrier != Carrier::Link && part.carrier != Carrier::Gripper) continue;
    try {
      covered.push_back({part.name, part.link, BallCover(scene_faces(part.faces).faces, overhang)});
    } catch (const std::length_error& error) {
      throw std::length_error(
          fmt::format("the part {}: {}; --cover-margin allows larger ones", part.name, error.what()));
    }
  }
  return covered;
}

Workcell::Workcell(const Cell& cell, const std::vector<ModelPart>& parts,
                   std::shared_ptr<const std::vector<Covered>> arm)
    : cell_(cell), arm_(arm_of(cell)), plane_(cell, arm_), covered_(std::move(arm)) {
  std::vector<std::string> owners_of_polygons;
  for (const ModelPart& part : parts) {
    scene::Faces faces = scene_faces(part.faces).faces;
    switch (part.carrier) {
      case Carrier::Link:
      case Carrier::Gripper: break;
      case Carrier::Storage:
      case Carrier::Machine: {
        faces = posed(pose_of(part.carrier == Carrier::Storage ? cell.storage : cell.machine), faces);
        standing_.push_back(scene_.add(part.name, faces));
        append(obstacles_.faces, faces);
        obstacles_.owners.insert(obstacles_.owners.end(), faces.triangles.size(), part.name);
        owners_of_polygons.insert(owners_of_polygons.end(), faces.polygons.size(), part.name);
        break;
      }
      case Carrier::Material:
        places_ = {workplace(cell.storage, cell.storage.slots[cell.material.slot], faces),
                   workplace(cell.machine, cell.machine.slots[cell.material.machine_slot], faces)};
        break;
    }
  }
  obstacles_.owners.insert(obstacles_.owners.end(), owners_of_polygons.begin(), owners_of_polygons.end());
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    material_.push_back(scene_.add(fmt::format("the material in the {}", to_string(slot)), at(slot).faces));
}

std::string Workcell::touched_obstacle(const kinematics::Angles& commanded, Material material,
                                       std::uint64_t& balls) const {
  std::vector<std::uint32_t> numbers = standing_;
  if (material) numbers.push_back(material_[static_cast<std::size_t>(*material)]);
  const scene::Scene::Objects objects(numbers);
  const auto name = [&](const Ball& ball) { return scene_.name(scene_.touched(ball, objects).front().object); };

  ++balls;
  const Ball sphere = arm_.sphere_at(commanded);
  if (scene_.touches(sphere, objects)) return fmt::format("the sphere touches {}", name(sphere));
  const std::vector<Pose> poses = arm_.link_poses(commanded);
  for (const Covered& part : *covered_) {
    std::string touched;
    const bool any = part.cover.any(poses[part.link], [&](const Ball& ball) {
      ++balls;
      if (!scene_.touches(ball, objects)) return false;
      touched = name(ball);
      return true;
    });
    if (any)
      return fmt::format("{} comes within {:.3g} {} of {}", part.name, part.cover.overhang(), cell_.unit.name, touched);
  }
  return "";
}

std::optional<std::size_t> Workcell::touched(const Ball& ball, StationSlot slot) const {
  const auto faces = scene_.touched(ball, {{material_[static_cast<std::size_t>(slot)]}});
  if (faces.empty()) return std::nullopt;
  return faces.front().face;
}

}  // namespace touchstone::cell
