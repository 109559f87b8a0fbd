// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/convex_cover.h"

#include "experiments/methods/convex.h"

namespace touchstone::figures {

ConvexCover convex_cover(const Outline& outline) {
  const Polygon polygon = outline.polygon(), hull = methods::convex_hull(polygon);
  Outline around{outline.name, {}};
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    around.corners.emplace_back(hull.vertex(i).x(), hull.vertex(i).y());
  return {around.area() / outline.area() - 1, methods::convex_parts(polygon).size()};
}

}  // namespace touchstone::figures
