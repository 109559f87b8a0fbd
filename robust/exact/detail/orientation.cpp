// SPDX-License-Identifier: Apache-2.0
// The only file of the library that includes EPICK, which takes 4 s to compile.
#include "robust/exact/detail/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace touchstone::exact {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // filtered; only its exact predicates are used

int orientation(double ax, double ay, double bx, double by, double px, double py) {
  return CGAL::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by), Kernel::Point_2(px, py));
}

bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const auto point = [](const Eigen::Vector3d& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  return CGAL::coplanar(point(a), point(b), point(c), point(d));
}

}  // namespace touchstone::exact
