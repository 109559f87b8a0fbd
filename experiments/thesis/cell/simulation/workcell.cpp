// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/workcell.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/methods/triangulate.h"
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

Workplace workplace(const Station& station, const Slot& slot, const scene::Faces& material, double drop) {
  const Eigen::Vector2d aim = in_plan(station, slot.aim);
  const double x = aim.x(), y = aim.y();
  const Pose frame = pose_of(station);
  Workplace place;
  place.azimuth = station.azimuth() + workloads::arc_tangent(y, x);
  place.out = std::sqrt(x * x + y * y);
  place.pose = {frame.rotation, frame * slot.place};
  place.faces = posed(place.pose, material);
  place.drop = drop;
  place.virtual_pose = {frame.rotation, place.pose.translation + Eigen::Vector3d(0, 0, drop)};
  place.virtual_faces = posed(place.virtual_pose, material);
  const Eigen::AlignedBox3d box = box_along(place.faces, place.azimuth);
  place.bottom = box.min().z();
  place.top = box.max().z();
  place.right = box.min().y();
  place.left = box.max().y();
  return place;
}

void append(std::vector<NamedTriangle>& all, const scene::Faces& faces, std::uint32_t owner) {
  for (const Triangle& triangle : faces.triangles) all.push_back({triangle, owner});
  for (const Polygon& polygon : faces.polygons)
    for (const Triangle& triangle : methods::triangles_of(polygon)) all.push_back({triangle, owner});
}

}  // namespace

std::string_view to_string(StationSlot slot) { return slot == StationSlot::Storage ? "storage" : "machine"; }

std::vector<Covered> cover_arm(const std::vector<ModelPart>& parts) {
  std::vector<Covered> covered;
  for (const ModelPart& part : parts) {
    if (part.carrier != Carrier::Link && part.carrier != Carrier::Gripper && part.carrier != Carrier::Material)
      continue;
    covered.push_back({part.name, part.carrier, part.link, {}});
    append(covered.back().triangles, scene_faces(part.faces).faces, 0);
  }
  return covered;
}

Workcell::Workcell(const Cell& cell, const std::vector<ModelPart>& parts,
                   std::shared_ptr<const std::vector<Covered>> arm)
    : cell_(cell), arm_(arm_of(cell)), plane_(cell, arm_), covered_(std::move(arm)) {
  std::vector<std::string> owners_of_polygons;
  for (const ModelPart& part : parts) {
    scene::Faces faces = scene_faces(part.faces).faces;
    const auto owner = static_cast<std::uint32_t>(names_.size());
    names_.push_back(part.name);
    switch (part.carrier) {
      case Carrier::Link: break;
      case Carrier::Gripper: append(gripper_, faces, owner); break;
      case Carrier::Storage:
      case Carrier::Machine:
      case Carrier::Obstacle: {
        if (part.carrier != Carrier::Obstacle)
          faces = posed(pose_of(part.carrier == Carrier::Storage ? cell.storage : cell.machine), faces);
        standing_.push_back(scene_.add(part.name, faces));
        append(standing_triangles_, faces, owner);
        append(obstacles_.faces, faces);
        obstacles_.owners.insert(obstacles_.owners.end(), faces.triangles.size(), part.name);
        owners_of_polygons.insert(owners_of_polygons.end(), faces.polygons.size(), part.name);
        break;
      }
      case Carrier::Material:
        append(material_triangles_, faces, owner);
        places_ = {workplace(cell.storage, cell.storage.slots[cell.material.slot], faces, cell.material.drop),
                   workplace(cell.machine, cell.machine.slots[cell.material.machine_slot], faces, cell.material.drop)};
        for (const Workplace& place : places_) {
          std::vector<NamedTriangle> there;
          append(there, place.faces, owner);
          slots_triangles_.emplace_back(std::move(there));
        }
        break;
    }
  }
  obstacles_.owners.insert(obstacles_.owners.end(), owners_of_polygons.begin(), owners_of_polygons.end());
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine}) {
    material_.push_back(scene_.add(fmt::format("the material in the {}", to_string(slot)), at(slot).faces));
    copies_.push_back(
        scene_.add(fmt::format("the virtual material in the {}", to_string(slot)), at(slot).virtual_faces));
  }
  const double reach = 2 * (plane_.furthest() + cell.storage.radius + cell.machine.radius);
  const auto corner = [&](double x, double y) { return Eigen::Vector3d(x * reach, y * reach, 0); };
  floor_faces_ = {{{corner(-1, -1), corner(1, -1), corner(1, 1)}, {corner(-1, -1), corner(1, 1), corner(-1, 1)}}, {}};
  floor_ = scene_.add("the floor", floor_faces_);
  names_.emplace_back("the floor");
  standing_tree_.emplace(standing_parts());
}

scene::Scene::Objects Workcell::in_the_way(Material material, bool floor) const {
  std::vector<std::uint32_t> numbers = standing_;
  if (material) numbers.push_back(material_[static_cast<std::size_t>(*material)]);
  if (floor) numbers.push_back(floor_);
  return {std::move(numbers)};
}

std::optional<std::size_t> Workcell::touched(const Ball& ball, StationSlot slot, bool virtual_copy) const {
  const auto faces = scene_.touched(ball, {{(virtual_copy ? copies_ : material_)[static_cast<std::size_t>(slot)]}});
  if (faces.empty()) return std::nullopt;
  return faces.front().face;
}

std::vector<NamedTriangle> Workcell::standing_parts() const {
  std::vector<NamedTriangle> all = standing_triangles_;
  append(all, floor_faces_, static_cast<std::uint32_t>(names_.size() - 1));
  return all;
}

double Workcell::gap(const Ball& ball, StationSlot slot, bool virtual_copy) const {
  const auto nearest = scene_.nearest(ball, {{(virtual_copy ? copies_ : material_)[static_cast<std::size_t>(slot)]}});
  return std::max(0.0, nearest.value().distance - ball.radius);
}

}  // namespace touchstone::cell
