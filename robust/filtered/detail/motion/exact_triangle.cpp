// SPDX-License-Identifier: Apache-2.0
// Apart from the kernels: what is compiled for one machine must not be linked into code for another, and a polygon is
// not of any target.
#include "robust/filtered/detail/motion/exact_triangle.h"

#include "robust/exact/motion.h"

namespace touchstone::filtered {

FirstContact exact_first_contact(const MotionTriangleView& view) {
  const auto point = [](const double* p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  return exact::first_contact({{point(view.motion), view.radius()}, point(view.motion + 4)},
                              Polygon({point(view.vertex[0]), point(view.vertex[1]), point(view.vertex[2])}));
}

}  // namespace touchstone::filtered
