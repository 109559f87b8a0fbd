// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/convex_cover.h"

#include "experiments/thesis/convex/convex.h"

namespace touchstone::figures {

ConvexCover convex_cover(const Outline& outline) {
  const Polygon polygon = outline.polygon(), hull = convex::convex_hull(polygon);
  Outline around{outline.name, {}};
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    around.corners.emplace_back(hull.vertex(i).x(), hull.vertex(i).y());
  return {around.area() / outline.area() - 1, convex::convex_parts(polygon).size()};
}

}  // namespace touchstone::figures
