// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/solid.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/thesis/cell/model/exact_boolean.h"
#include "geometry/io/read_mesh.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/validate.h"
#include "robust/mesh/detail/face_plane.h"
#include "robust/mesh/merge.h"
#include "robust/scene/posing.h"

namespace touchstone::cell {
namespace {

struct Bounds {
  Eigen::AlignedBox3d operator()(const Box& box) const { return {box.lower, box.upper}; }

  Eigen::AlignedBox3d operator()(const Cylinder& cylinder) const {
    Eigen::Vector3d across = Eigen::Vector3d::Constant(cylinder.radius);
    across[cylinder.axis] = 0;
    return {cylinder.from.cwiseMin(cylinder.to) - across, cylinder.from.cwiseMax(cylinder.to) + across};
  }

  Eigen::AlignedBox3d operator()(const Sphere& sphere) const {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(sphere.radius);
    return {sphere.at - reach, sphere.at + reach};
  }

  Eigen::AlignedBox3d operator()(const MeshFile& file) const {
    Mesh mesh = read_mesh(file.file, OnFault::Refuse).mesh;
    workloads::convert(mesh, file.unit, file.cell_unit);
    Eigen::AlignedBox3d bounds;
    for (const auto& face : mesh.faces)
      for (const std::uint32_t vertex : face)
        bounds.extend(Eigen::Vector3d(file.scale.cwiseProduct(mesh.vertices[vertex])));
    return bounds;
  }

  Eigen::AlignedBox3d operator()(const Boolean& boolean) const {
    Eigen::AlignedBox3d bounds = bounds_of(boolean.parts.front());
    if (boolean.operation == Boolean::Operation::Union)
      for (const Solid& part : boolean.parts) bounds.extend(bounds_of(part));
    return bounds;
  }
};

}  // namespace

Eigen::AlignedBox3d bounds_of(const Solid& solid) {
  const Eigen::AlignedBox3d own = std::visit(Bounds{}, solid.shape);
  Eigen::AlignedBox3d bounds;
  if (own.isEmpty()) return bounds;
  for (int corner = 0; corner < 8; ++corner)
    bounds.extend(
        Eigen::Vector3d(solid.pose.rotation * own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) +
                        solid.pose.translation));
  return bounds;
}

namespace {

[[noreturn]] void refuse(const std::string& name, std::size_t face, const Rejection& rejection) {
  throw BadSolid(fmt::format("{}: face {}: {}: {}", name, face, to_string(rejection.code), rejection.message));
}

/// With the largest move of its vertices onto its plane.
Face measured(Polygon polygon) {
  std::vector<Eigen::Vector3d> vertices;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) vertices.push_back(polygon.vertex(i));
  const double off_plane = mesh::detail::off_plane(polygon, vertices);
  return {std::move(polygon), off_plane};
}

Face validated(const std::string& name, std::size_t face, const Boundary::Loops& loops) {
  try {
    Polygon polygon(loops.front(), {loops.begin() + 1, loops.end()});
    if (auto rejection = exact::validate(polygon)) throw Rejected(std::move(*rejection));
    return measured(std::move(polygon));
  } catch (const Rejected& rejected) {
    refuse(name, face, rejected.rejection());
  }
}

SolidFaces faces_of_boolean(const Solid& solid, const std::string& name) {
  const Boundary boundary = boundary_of(solid);
  if (boundary.faces.empty()) throw BadSolid(name + ": the solid has no inside");
  SolidFaces result;
  for (std::size_t i = 0; i < boundary.faces.size(); ++i) result.faces.push_back(validated(name, i, boundary.faces[i]));
  result.volume = exact::detail::nearest_double(boundary.volume.get_num(), boundary.volume.get_den());
  return result;
}

SolidFaces faces_of_mesh(const MeshFile& file, const Pose& pose, const std::string& name) {
  Mesh mesh = workloads::read_with_warnings(file.file, OnFault::Refuse).mesh;
  workloads::convert(mesh, file.unit, file.cell_unit);
  if (file.scale.prod() < 0)
    for (auto& face : mesh.faces) std::ranges::reverse(face);
  // Merged where it stands in its file: a pose rounds, and what it rounds is coplanar no more.
  mesh::MergedMesh merged = mesh::merge_faces(mesh);
  if (!merged.rejected.empty())
    refuse(name + ": " + file.file.string(), merged.rejected[0].face, merged.rejected[0].rejection);
  const Pose scaled{pose.rotation * file.scale.asDiagonal(), pose.translation};
  SolidFaces result;
  for (std::size_t i = 0; i < merged.faces.size(); ++i) {
    try {
      result.faces.push_back(measured(scene::posed(scaled, merged.faces[i].polygon)));
    } catch (const Rejected& rejected) {
      refuse(name + ": " + file.file.string() + ": merged and posed", i, rejected.rejection());
    }
  }
  result.merged_from = mesh.faces.size();
  return result;
}

}  // namespace

std::size_t SolidFaces::vertices() const {
  std::size_t sum = 0;
  for (const Face& face : faces) sum += face.polygon.vertex_count();
  return sum;
}

std::size_t SolidFaces::holes() const {
  std::size_t sum = 0;
  for (const Face& face : faces) sum += face.polygon.loop_count() - 1;
  return sum;
}

double SolidFaces::off_plane() const {
  double largest = 0;
  for (const Face& face : faces) largest = std::max(largest, face.off_plane);
  return largest;
}

Eigen::Vector3d doubled_area(const Polygon& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.vertex(0);
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    sum += (polygon.vertex(i) - origin).cross(polygon.vertex(polygon.next(i)) - origin);
  return sum;
}

SolidFaces faces_of(const Solid& solid, const std::string& name) {
  if (const auto* const file = std::get_if<MeshFile>(&solid.shape)) return faces_of_mesh(*file, solid.pose, name);
  try {
    return faces_of_boolean(solid, name);
  } catch (const std::invalid_argument& error) {
    throw BadSolid(name + ": " + error.what());
  }
}

}  // namespace touchstone::cell
