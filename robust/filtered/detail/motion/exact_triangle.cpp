// SPDX-License-Identifier: Apache-2.0
// Apart from the kernels: what is compiled for one machine must not be linked into code for another, and a polygon is
// not of any target.
#include "robust/filtered/detail/motion/exact_triangle.h"

#include "robust/exact/motion.h"

namespace touchstone::filtered {
namespace {

Eigen::Vector3d point(const double* p) { return {p[0], p[1], p[2]}; }

Motion motion_of(const MotionTriangleView& view) {
  return {{point(view.motion), view.radius()}, point(view.motion + 4)};
}
Polygon polygon_of(const MotionTriangleView& view) {
  return Polygon({point(view.vertex[0]), point(view.vertex[1]), point(view.vertex[2])});
}

}  // namespace

bool exact_motion_contact(const MotionTriangleView& view) { return exact::contact(motion_of(view), polygon_of(view)); }
FirstContact exact_first_contact(const MotionTriangleView& view) {
  return exact::first_contact(motion_of(view), polygon_of(view));
}

}  // namespace touchstone::filtered
