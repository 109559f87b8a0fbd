// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/workcell.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
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
Eigen::AlignedBox3d box_along(const scene::Faces& faces, double direction) {
  Eigen::Matrix3d turned;
  const double c = workloads::cosine(direction), s = workloads::sine(direction);
  turned << c, s, 0, -s, c, 0, 0, 0, 1;
  Eigen::AlignedBox3d box;
  const auto extend = [&](const Eigen::Vector3d& vertex) { box.extend(Eigen::Vector3d(turned * vertex)); };
  for (const Triangle& t : faces.triangles) extend(t.a), extend(t.b), extend(t.c);
  for (const Polygon& polygon : faces.polygons)
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) extend(polygon.vertex(i));
  return box;
}

Lying lying(const scene::Faces& material, const Pose& pose) {
  auto there = std::make_shared<LyingMaterial>();
  there->pose = pose;
  there->faces = posed(pose, material);
  there->scene.add("material", there->faces);
  return there;
}

Workplace workplace(const PlanarArm& plane, const Station& station, const Slot& slot, const scene::Faces& material,
                    double drop) {
  const Eigen::Vector2d aim = in_plan(station, slot.aim);
  const double x = aim.x(), y = aim.y();
  const Pose frame = pose_of(station);
  Workplace place;
  place.out = std::sqrt(x * x + y * y);
  place.facing = plane.facing(station.azimuth() + workloads::arc_tangent(y, x), place.out);
  const Eigen::Vector3d at = frame * slot.place;
  place.drop = drop;
  place.material = lying(material, {frame.rotation, at});
  place.copy = lying(material, {frame.rotation, at + Eigen::Vector3d(0, 0, drop)});
  const Eigen::AlignedBox3d box = box_along(place.material->faces, place.facing);
  place.bottom = box.min().z();
  place.top = box.max().z();
  place.right = box.min().y() - plane.beside();
  place.left = box.max().y() - plane.beside();
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
      case Carrier::Finger: append(fingers_.emplace_back(), faces, owner); break;
      case Carrier::Storage:
      case Carrier::Machine:
      case Carrier::Obstacle: {
        if (part.carrier != Carrier::Obstacle)
          faces = posed(pose_of(part.carrier == Carrier::Storage ? cell.storage : cell.machine), faces);
        scene_.add(part.name, faces);
        append(standing_triangles_, faces, owner);
        append(obstacles_.faces, faces);
        obstacles_.owners.insert(obstacles_.owners.end(), faces.triangles.size(), part.name);
        owners_of_polygons.insert(owners_of_polygons.end(), faces.polygons.size(), part.name);
        break;
      }
      case Carrier::Material:
        append(material_triangles_, faces, owner);
        material_tree_.emplace(material_triangles_);
        places_ = {
            workplace(plane_, cell.storage, cell.storage.slots[cell.material.slot], faces, cell.material.drop),
            workplace(plane_, cell.machine, cell.machine.slots[cell.material.machine_slot], faces, cell.material.drop)};
        material_faces_ = std::move(faces);
        break;
    }
  }
  obstacles_.owners.insert(obstacles_.owners.end(), owners_of_polygons.begin(), owners_of_polygons.end());
  const double reach = 2 * (plane_.furthest() + cell.storage.radius + cell.machine.radius);
  const auto corner = [&](double x, double y) { return Eigen::Vector3d(x * reach, y * reach, 0); };
  floor_faces_ = {{{corner(-1, -1), corner(1, -1), corner(1, 1)}, {corner(-1, -1), corner(1, 1), corner(-1, 1)}}, {}};
  names_.emplace_back("the floor");
  standing_tree_.emplace(standing_parts());
}

Lying Workcell::lay(const Pose& pose) const { return lying(material_faces_, pose); }

std::optional<std::size_t> LyingMaterial::touched(const Ball& ball) const {
  const auto all = scene.touched(ball);
  if (all.empty()) return std::nullopt;
  return all.front().face;
}

double LyingMaterial::gap(const Ball& ball) const {
  return std::max(0.0, scene.nearest(ball).value().distance - ball.radius);
}

std::vector<NamedTriangle> Workcell::standing_parts() const {
  std::vector<NamedTriangle> all = standing_triangles_;
  append(all, floor_faces_, static_cast<std::uint32_t>(names_.size() - 1));
  return all;
}

}  // namespace touchstone::cell
