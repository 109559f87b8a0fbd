// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/motion.h"

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/exact/motion.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::filtered {

using namespace detail;

namespace {

NoCounts uncounted;

PreparedPolygon::Parts prepared_once(const Polygon& polygon) {
  const FloatingPointState nearest;
  return PreparedPolygon::Parts(polygon, EdgeIndex::Use::Once);
}

template <class Counts>
FirstContact first_contact_of(const KernelTable<Counts>& kernels, const Motion& motion,
                              const PreparedPolygon::Parts& parts, Counts& counts) {
  FirstContact contact;
  kernels.first_contact(required(motion), parts, contact, counts);
  return contact;
}
template <class Counts>
FirstContact first_contact_of(const KernelTable<Counts>& kernels, const Motion& motion, const Triangle& triangle,
                              Counts& counts) {
  FirstContact contact;
  kernels.triangle_first_contact(view_of(required(motion), required(triangle)), contact, counts);
  return contact;
}

const exact::PreparedPolygon& exactly(const PreparedPolygon& polygon) { return parts_of(polygon).exact(); }
exact::PreparedPolygon exactly(const Triangle& triangle) { return exact::PreparedPolygon(triangle); }

/// Rounding keeps the order of times, except that they may become equal.
template <class Face>
int compare_times_of(const Motion& motion, const Face& first, const Face& second) {
  const FirstContact a = first_contact(motion, first), b = first_contact(motion, second);
  const FloatingPointState nearest;
  const bool both_on_way = a.kind == FirstContactKind::Way && b.kind == FirstContactKind::Way;
  if (both_on_way && same_number(a.time, b.time)) return exact::compare_times(motion, exactly(first), exactly(second));
  // A time on the way may round to 0, the time of a start.
  const auto rank = [](const FirstContact& contact) { return static_cast<int>(contact.kind); };
  if (!both_on_way) return (rank(a) > rank(b)) - (rank(a) < rank(b));
  return (a.time > b.time) - (a.time < b.time);
}

}  // namespace

bool contact(const Motion& motion, const PreparedPolygon& polygon) {
  return kernels().plain.motion_contact(required(motion), parts_of(polygon), uncounted);
}
bool contact(const Motion& motion, const PreparedPolygon& polygon, StageCounts& counts) {
  return kernels().counted.motion_contact(required(motion), parts_of(polygon), counts);
}
bool contact(const Motion& motion, const Polygon& polygon) {
  const PreparedPolygon::Parts parts = prepared_once(polygon);
  return kernels().plain.motion_contact(required(motion), parts, uncounted);
}
bool contact(const Motion& motion, const Triangle& triangle) {
  return kernels().plain.triangle_motion_contact(view_of(required(motion), required(triangle)), uncounted);
}
bool contact(const Motion& motion, const Triangle& triangle, StageCounts& counts) {
  return kernels().counted.triangle_motion_contact(view_of(required(motion), required(triangle)), counts);
}

FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon) {
  return first_contact_of(kernels().plain, motion, parts_of(polygon), uncounted);
}
FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon, StageCounts& counts) {
  return first_contact_of(kernels().counted, motion, parts_of(polygon), counts);
}
FirstContact first_contact(const Motion& motion, const Polygon& polygon) {
  const PreparedPolygon::Parts parts = prepared_once(polygon);
  return first_contact_of(kernels().plain, motion, parts, uncounted);
}
FirstContact first_contact(const Motion& motion, const Triangle& triangle) {
  return first_contact_of(kernels().plain, motion, triangle, uncounted);
}
FirstContact first_contact(const Motion& motion, const Triangle& triangle, StageCounts& counts) {
  return first_contact_of(kernels().counted, motion, triangle, counts);
}

int compare_times(const Motion& motion, const PreparedPolygon& first, const PreparedPolygon& second) {
  return compare_times_of(motion, first, second);
}
int compare_times(const Motion& motion, const Triangle& first, const Triangle& second) {
  return compare_times_of(motion, first, second);
}

void contact(std::span<const Motion> motions, const PreparedPolygon& polygon, std::span<bool> touches) {
  expect_equal_lengths("motions", motions.size(), "answers", touches.size());
  kernels().motions_contact(required(motions), parts_of(polygon), touches);
}
void contact(const Motion& motion, std::span<const Triangle> triangles, std::span<bool> touches) {
  expect_equal_lengths("triangles", triangles.size(), "answers", touches.size());
  kernels().motion_triangles_contact(required(motion), required(triangles), touches);
}

}  // namespace touchstone::filtered
