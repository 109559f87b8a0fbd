// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/angle_sum.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/degrees.h"
#include "geometry/contact/thesis.h"
#include "robust/filtered/filtered.h"

namespace touchstone::figures {

AngleSum angle_sum(const Outline& outline, const Eigen::Vector3d& point) {
  AngleSum sum;
  const auto& corners = outline.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [x0, y0] = corners[i];
    const auto& [x1, y1] = corners[(i + 1) % corners.size()];
    const double ux = x0 - point.x(), uy = y0 - point.y(), vx = x1 - point.x(), vy = y1 - point.y();
    sum.angles.push_back(workloads::arc_tangent(ux * vy - uy * vx, ux * vx + uy * vy));
    sum.signed_sum += sum.angles.back();
    sum.unsigned_sum += std::abs(sum.angles.back());
  }
  return sum;
}

GripperPoints gripper_points(const Outline& outline) {
  // The end of the gap lies between the two corners at which the outline turns the other way.
  const Box box = bounds(outline);
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  const std::size_t n = outline.corners.size();
  double count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [x0, y0] = outline.corners[(i + n - 1) % n];
    const auto& [x1, y1] = outline.corners[i];
    const auto& [x2, y2] = outline.corners[(i + 1) % n];
    if ((x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1) >= 0) continue;
    end += Eigen::Vector3d(x1, y1, 0);
    ++count;
  }
  end /= count;
  return {{end.x(), (end.y() + box.top) / 2, 0}, {end.x(), (end.y() + box.bottom) / 2, 0}};
}

AngleMap map_angle_sums(const Outline& outline, std::size_t along) {
  const Polygon polygon = outline.polygon();
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<> method(polygon);
  const Box outer = bounds(outline);
  AngleMap map{outer.enlarged(outer.width() / 2, outer.height() / 2), along, along, {}};
  const double pitch = std::max(map.box.width(), map.box.height()) / static_cast<double>(along);
  map.columns = static_cast<std::size_t>(std::lround(map.box.width() / pitch));
  map.rows = static_cast<std::size_t>(std::lround(map.box.height() / pitch));
  for (std::size_t row = 0; row < map.rows; ++row)
    for (std::size_t column = 0; column < map.columns; ++column) {
      const Eigen::Vector3d at{
          map.box.left + map.box.width() * (static_cast<double>(column) + 0.5) / static_cast<double>(map.columns),
          map.box.bottom + map.box.height() * (static_cast<double>(row) + 0.5) / static_cast<double>(map.rows), 0};
      const Ball ball{at, 1};
      map.points.push_back({at.x(), at.y(), angle_sum(outline, at).unsigned_sum,
                            filtered::foot(ball, truth) != PointLocation::Outside,
                            thesis::foot(ball, method) == PointLocation::Inside});
    }
  return map;
}

}  // namespace touchstone::figures
