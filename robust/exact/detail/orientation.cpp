// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/orientation.h"

#include "robust/detail/exact_kernel.h"
#if !defined(TOUCHSTONE_BOOST_NUMBERS)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>  // in no other file: it takes 4 s to compile
#endif

namespace touchstone::exact {

#if defined(TOUCHSTONE_BOOST_NUMBERS)
using Kernel = kernel::Simple_cartesian<kernel::Mpzf>;
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // filtered; only its exact predicates are used
#endif

int orientation(double ax, double ay, double bx, double by, double px, double py) {
  return kernel::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by), Kernel::Point_2(px, py));
}

bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const auto point = [](const Eigen::Vector3d& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  return kernel::coplanar(point(a), point(b), point(c), point(d));
}

}  // namespace touchstone::exact
