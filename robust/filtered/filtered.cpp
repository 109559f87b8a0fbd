// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/filtered.h"

#include <cmath>
#include <type_traits>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/exact/exact.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::filtered {

using namespace detail;

namespace {

NoCounts uncounted;

/// Asks a polygon that is queried once.
template <auto kernel>
auto ask_once(const Ball& ball, const Polygon& polygon) {
  const PreparedPolygon::Parts parts = [&polygon] {
    const FloatingPointState nearest;
    return PreparedPolygon::Parts(polygon, EdgeIndex::Use::Once);
  }();
  return (kernels().plain.*kernel)(required(ball), parts, uncounted);
}
using Table = KernelTable<NoCounts>;

template <class Counts>
__attribute__((noinline)) PlaneSide unsure_plane_side(const Ball& ball, const PreparedPolygon::Parts& parts,
                                                      Counts& counts) {
  if constexpr (std::is_same_v<Counts, NoCounts>)
    return kernels().plain.plane_side(ball, parts, counts);
  else
    return kernels().counted.plane_side(ball, parts, counts);
}

/// The first stage is so short that the call of a kernel would cost as much.
template <class Counts>
TOUCHSTONE_INLINE PlaneSide plane_side(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  const GivenHeight height(ball, parts.plane);
  PlaneSide side;
  if (height.is_in_reach() && height.find_side(side)) [[likely]] {
    counts.count(Stage::Double);
    return side;
  }
  return unsure_plane_side(ball, parts, counts);
}

}  // namespace

std::string_view to_string(Stage stage) {
  switch (stage) {
    case Stage::Double: return "double";
    case Stage::Permanent: return "permanent";
    case Stage::DoubleDouble: return "double-double";
    case Stage::FixedInteger: return "fixed-integer";
    case Stage::BigInteger: break;
  }
  return "unlimited";
}

bool contact(const Ball& ball, const PreparedPolygon& polygon) {
  return kernels().plain.contact(required(ball), parts_of(polygon), uncounted);
}
Relation relation(const Ball& ball, const PreparedPolygon& polygon) {
  return kernels().plain.relation(required(ball), parts_of(polygon), uncounted);
}
PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon) {
  return plane_side(required(ball), parts_of(polygon), uncounted);
}
PointLocation foot(const Ball& ball, const PreparedPolygon& polygon) {
  return kernels().plain.foot(required(ball), parts_of(polygon), uncounted);
}
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon) {
  return kernels().plain.edges_hit(required(ball), parts_of(polygon), uncounted);
}
Answer answer(const Ball& ball, const PreparedPolygon& polygon) {
  return kernels().plain.answer(required(ball), parts_of(polygon), uncounted);
}

bool contact(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.contact(required(ball), parts_of(polygon), counts);
}
Relation relation(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.relation(required(ball), parts_of(polygon), counts);
}
PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return plane_side(required(ball), parts_of(polygon), counts);
}
PointLocation foot(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.foot(required(ball), parts_of(polygon), counts);
}
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.edges_hit(required(ball), parts_of(polygon), counts);
}
Answer answer(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.answer(required(ball), parts_of(polygon), counts);
}

bool contact(const Ball& ball, const Polygon& polygon) { return ask_once<&Table::contact>(ball, polygon); }
Relation relation(const Ball& ball, const Polygon& polygon) { return ask_once<&Table::relation>(ball, polygon); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return ask_once<&Table::plane_side>(ball, polygon); }
PointLocation foot(const Ball& ball, const Polygon& polygon) { return ask_once<&Table::foot>(ball, polygon); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return ask_once<&Table::edges_hit>(ball, polygon);
}
Answer answer(const Ball& ball, const Polygon& polygon) { return ask_once<&Table::answer>(ball, polygon); }

bool contact(const Ball& ball, const Triangle& triangle) {
  return kernels().plain.triangle_contact(view_of(required(ball), required(triangle)), uncounted);
}
bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts) {
  return kernels().counted.triangle_contact(view_of(required(ball), required(triangle)), counts);
}

Relation relation(const Ball& ball, const Triangle& triangle) {
  const FloatingPointState nearest;
  ClosestPoint point{};
  double depth = 0;
  kernels().plain.triangle_closest(view_of(required(ball), required(triangle)), point, &depth, uncounted);
  if (depth != 0) return depth > 0 ? Relation::Overlapping : Relation::Separate;  // 0 may stand for a small difference
  return exact::relation(ball, triangle);
}

ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) {
  return closest(kernels().plain, required(center), required(triangle), uncounted);
}
ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle, StageCounts& counts) {
  return closest(kernels().counted, required(center), required(triangle), counts);
}

void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches) {
  expect_equal_lengths("balls", balls.size(), "answers", touches.size());
  kernels().balls_contact(required(balls), parts_of(polygon), touches);
}
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  expect_equal_lengths("triangles", triangles.size(), "answers", touches.size());
  kernels().triangles_contact(required(ball), required(triangles), touches);
}

}  // namespace touchstone::filtered
