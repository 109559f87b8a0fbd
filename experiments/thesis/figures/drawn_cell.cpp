// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/drawn_cell.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

#include "experiments/methods/triangulate.h"

namespace touchstone::figures {
namespace {

using nlohmann::ordered_json;

ordered_json point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

ordered_json numbers(const Pose& pose) {
  ordered_json list = ordered_json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) list.push_back(pose.rotation(row, column));
  for (int row = 0; row < 3; ++row) list.push_back(pose.translation(row));
  return list;
}

const Polygon& front_face(const std::vector<cell::ModelPart>& parts) {
  const Polygon* front = nullptr;
  for (const cell::ModelPart& part : parts)
    if (part.carrier == cell::Carrier::Gripper)
      for (const cell::Face& face : part.faces.faces) {
        const Polygon& polygon = face.polygon;
        const auto y = polygon.coordinates(1);
        const bool upright = std::ranges::all_of(y, [&](double v) { return v == y[0]; }) && y[0] < 0;
        if (upright && (front == nullptr || polygon.vertex_count() > front->vertex_count())) front = &polygon;
      }
  if (front == nullptr) throw std::runtime_error("the cell's gripper has no face across its y axis");
  return *front;
}

}  // namespace

Outline gripper_outline(const std::vector<cell::ModelPart>& parts) {
  const Polygon& face = front_face(parts);
  Outline outline{"gripper", {}};
  for (std::size_t i = 0; i < face.vertex_count(); ++i)
    outline.corners.emplace_back(face.vertex(i).x(), face.vertex(i).z());
  return outline;
}

Polygon gripper_face(const std::vector<cell::ModelPart>& parts, const Pose& flange) {
  const Polygon& face = front_face(parts);
  Loop loop;
  for (std::size_t i = 0; i < face.vertex_count(); ++i) loop.push_back(flange * face.vertex(i));
  return Polygon(loop);
}

ordered_json drawn_parts(const std::vector<cell::ModelPart>& parts) {
  ordered_json all = ordered_json::array();
  for (const cell::ModelPart& part : parts) {
    cell::NumberedPoints numbered;
    ordered_json vertices = ordered_json::array(), triangles = ordered_json::array(), loops = ordered_json::array();
    for (const cell::Face& face : part.faces.faces) {
      const Polygon& polygon = face.polygon;
      for (const auto& corners : methods::triangulate(polygon)) {
        ordered_json triangle = ordered_json::array();
        for (const std::uint32_t corner : corners) triangle.push_back(numbered.number(polygon.vertex(corner)));
        triangles.push_back(triangle);
      }
      for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
        ordered_json corners = ordered_json::array();
        for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
          corners.push_back(numbered.number(polygon.vertex(i)));
        loops.push_back(corners);
      }
    }
    for (const Eigen::Vector3d& vertex : numbered.points) vertices.push_back(point(vertex));
    all.push_back({{"name", part.name},
                   {"moves_with", to_string(part.carrier)},
                   {"link", part.link},
                   {"vertices", vertices},
                   {"triangles", triangles},
                   {"loops", loops}});
  }
  return all;
}

ordered_json drawn_primitives(const std::vector<cell::Part>& parts) {
  ordered_json all = ordered_json::object();
  for (const cell::Part& part : parts)
    if (const auto* boolean = std::get_if<cell::Boolean>(&part.solid.shape)) {
      std::vector<cell::ModelPart> primitives;
      for (const cell::Solid& solid : boolean->parts)
        primitives.push_back({cell::Carrier::Link, 0, part.name, cell::faces_of(solid, part.name)});
      all[part.name] = drawn_parts(primitives);
    }
  return all;
}

ordered_json drawn_moments(const CaseStudy& study) {
  ordered_json all = ordered_json::object();
  const ordered_json storage = numbers(cell::pose_of(study.cell.storage)),
                     machine = numbers(cell::pose_of(study.cell.machine)), copy = numbers(study.copy);
  for (const Moment& moment : study.moments) {
    const cell::browser::Snapshot& now = study.snapshots[moment.stop];
    const cell::Stop& stop = study.process.stops[moment.stop];
    ordered_json poses = ordered_json::array(), fingers = ordered_json::array();
    for (const Pose& link : now.links) poses.push_back(numbers(link));
    if (const auto& its = study.cell.gripper.fingers)
      for (std::size_t i = 0; i < now.closed.size(); ++i)
        fingers.push_back(numbers({now.links.back().rotation, now.links.back() * its->shift(i, now.closed[i])}));
    all[moment.name] = {{"links", poses},
                        {"fingers", fingers},
                        {"storage", storage},
                        {"machine", machine},
                        {"material", numbers(now.material)},
                        {"virtual_material", copy},
                        {"gripped", now.slot != cell::StationSlot::Storage},
                        {"sphere", point(stop.sphere.center)},
                        {"sphere_radius", stop.sphere.radius},
                        {"commanded", stop.commanded}};
  }
  return all;
}

}  // namespace touchstone::figures
