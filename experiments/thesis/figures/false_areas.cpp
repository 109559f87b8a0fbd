// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/false_areas.h"

#include <cstdint>
#include <string_view>

#include "experiments/thesis/convex/convex.h"
#include "geometry/contact/thesis.h"
#include "robust/filtered/filtered.h"

namespace touchstone::figures {
namespace {

/// One of its own for each name, beyond the small numbers that the other measurements use.
std::uint64_t stream_of(std::string_view name) {
  std::uint64_t stream = 1;
  for (const char letter : name) stream = 131 * stream + static_cast<unsigned char>(letter);
  return stream | std::uint64_t{1} << 63;
}

}  // namespace

double FalseArea::share() const { return static_cast<double>(wrong) / static_cast<double>(right); }

statistics::Limits FalseArea::limits() const {
  const auto of_called = statistics::clopper_pearson(wrong, wrong + right);
  return {of_called.lower / (1 - of_called.lower), of_called.upper / (1 - of_called.upper)};
}

FalseArea measure_false_area(const Outline& outline, std::uint64_t points, std::uint64_t seed) {
  const Polygon polygon = outline.polygon();
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<> method(polygon);
  const Box outer = bounds(outline);
  const Box box = outer.enlarged(outer.width() / 2, outer.height() / 2);
  FalseArea area{&outline};
  for (std::uint64_t i = 0; i < points; ++i) {
    workloads::Random random(seed, i, stream_of(outline.name));
    const Ball ball{box.point(random), 1};
    const bool inside = filtered::foot(ball, truth) != PointLocation::Outside;
    const bool called = thesis::foot(ball, method) == PointLocation::Inside;
    ++area.points;
    area.right += inside && called;
    area.wrong += !inside && called;
    area.missed += inside && !called;
  }
  return area;
}

ConvexCover convex_cover(const Outline& outline) {
  const Polygon polygon = outline.polygon(), hull = convex::convex_hull(polygon);
  Outline around{outline.name, {}};
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    around.corners.emplace_back(hull.vertex(i).x(), hull.vertex(i).y());
  return {around.area() / outline.area() - 1, convex::convex_parts(polygon).size()};
}

}  // namespace touchstone::figures
