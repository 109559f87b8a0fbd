// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/bounds.h"

#include "geometry/io/read_mesh.h"

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
    Mesh mesh = read_mesh(file.file).mesh;
    workloads::convert(mesh, file.unit, file.cell_unit);
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& vertex : mesh.vertices) bounds.extend(vertex);
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

}  // namespace touchstone::cell
