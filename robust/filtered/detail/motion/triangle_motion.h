// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robust/exact/motion.h"
#include "robust/filtered/detail/motion/capsule_filter.h"
#include "robust/filtered/detail/motion/first_candidate.h"
#include "robust/filtered/detail/motion/triangle_doubles.h"
#include "robust/filtered/detail/motion/triangle_events.h"
#include "robust/filtered/detail/triangle_closest.h"

/// All stages for a moving ball and a triangle.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Returns the first contact, computed by `exact`.
template <class Counts>
FirstContact exact_first_contact(const MotionTriangleView& view, Counts& counts) {
  counts.count(Stage::BigInteger);
  const auto point = [](const double* p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  return exact::first_contact({{point(view.motion), view.radius()}, point(view.motion + 4)},
                              Polygon({point(view.vertex[0]), point(view.vertex[1]), point(view.vertex[2])}));
}

/// Returns the first contact of a ball that touches at its start. Requires round to nearest.
template <class Counts>
FirstContact start_contact(const MotionTriangleView& view, Counts& counts) {
  const double center[] = {view.center(0), view.center(1), view.center(2), 0};
  const BallTriangleView at_rest{view.vertex, center};
  const ExactTriangle<Counts> triangle(at_rest, counts);
  const Feature feature = triangle.nearest();
  const ClosestPointOnFeature closest(triangle, feature);
  return {FirstContactKind::Start,
          0,
          false,
          feature,
          {closest.coordinate(0), closest.coordinate(1), closest.coordinate(2)}};
}

/// What the first stage knows.
struct MotionFilterResult {
  FilterResult contact;
  bool at_start;                   ///< whether a contact is at the start
  std::optional<Feature> feature;  ///< the feature touched first, if it is certain; for a contact on the way
};

/// Looks for the first contact in doubles.
TOUCHSTONE_INLINE MotionFilterResult motion_filter(const MotionTriangleView& view) {
  const Vector3<Pack> vertex = vertex_lanes(view.vertex);
  if (!in_range(vertex, view, bounds::kLongestMotion)) [[unlikely]]
    return {FilterResult::OutOfRange, false, {}};
  const TriangleMotionLanes lanes(vertex, view);
  const PlaneEntry<Pack> plane = lanes.plane();
  if ((plane.misses & TriangleEvents::all) != 0) return {FilterResult::No, false, {}};
  TriangleSigns signs;
  const FilterResult start = triangle_filter({view.vertex, view.motion}, signs);
  if (start != FilterResult::No) return {start, true, {}};
  const TriangleEvents events{start_event(lanes.moving), interior_event(lanes.moving), face_event(lanes, plane.entry)};
  if (events.unsure()) return {FilterResult::Unsure, false, {}};
  if (!events.any()) return {FilterResult::No, false, {}};
  FirstCandidate<double> candidate;
  const auto consider = [&candidate](Feature::Kind kind, const Entry<Pack>& event, unsigned lanes_of) {
    double time[kLanes], error[kLanes];
    store(time, event.time.value), store(error, event.time.error);
    for (unsigned happening = event.certain & lanes_of; happening != 0; happening &= happening - 1) {
      const int lane = __builtin_ctz(happening);
      candidate.add({kind, static_cast<std::size_t>(lane)}, time[lane], error[lane]);
    }
  };
  consider(Feature::Kind::Face, events.face, 1);
  consider(Feature::Kind::Edge, events.interior, TriangleEvents::all);
  consider(Feature::Kind::Vertex, events.start, TriangleEvents::all);
  if (!candidate.certain()) return {FilterResult::Unsure, false, {}};
  return {FilterResult::Yes, false, candidate.feature()};
}

/// Returns the first contact with a feature that is certainly touched first on the way.
template <class Counts>
FirstContact contact_with(const MotionTriangleView& given, const TriangleMotionDoubles& doubles, const Feature& feature,
                          Counts& counts) {
  if (const auto contact = TouchedPoint(doubles, feature).rounded_contact()) {
    counts.count(Stage::DoubleDouble);
    return *contact;
  }
  return exact_first_contact(given, counts);
}

// If the largest number is smaller than this fraction of bounds::kLongestMotion's inverse, lengths are scaled.
inline constexpr double kOrdinary = 0x1p20;

/// Returns the first contact where the first stage does not suffice.
template <class Counts>
__attribute__((noinline)) FirstContact later_first_contact(const MotionTriangleView& given,
                                                           const MotionFilterResult& known, Counts& counts) {
  const FloatingPointState nearest;
  if (known.contact == FilterResult::Yes && known.at_start) return start_contact(given, counts);
  if (known.feature) return contact_with(given, TriangleMotionDoubles(given, 0), *known.feature, counts);
  if (contact(BallTriangleView{given.vertex, given.motion}, counts)) return start_contact(given, counts);
  std::optional<ScaledMotion> scaled;
  MotionTriangleView view = given;
  int exponent = 0;
  if (const double largest = largest_number(given);
      largest < kOrdinary / bounds::kLongestMotion || known.contact == FilterResult::OutOfRange) {
    scaled.emplace(given, largest);
    if (!scaled->exact()) return exact_first_contact(given, counts);
    view = scaled->view(), exponent = scaled->exponent();
  }
  const TriangleMotionDoubles doubles(view, exponent);
  FirstCandidate<DoubleDouble> first;
  if (!doubles.find_first(first)) return exact_first_contact(given, counts);
  if (!first.any()) {
    counts.count(Stage::DoubleDouble);
    return {};
  }
  return contact_with(given, doubles, first.feature(), counts);
}

template <class Counts>
void triangle_first_contact(MotionTriangleView view, FirstContact& contact, Counts& counts) {
  const MotionFilterResult known = motion_filter(view);
  if (known.contact == FilterResult::No) {
    counts.count(Stage::Double);
    contact = {};
  } else {
    contact = later_first_contact(view, known, counts);
  }
}

template <class Counts>
bool triangle_motion_contact(MotionTriangleView view, Counts& counts) {
  const FilterResult result = capsule_filter(view);
  if (result >= FilterResult::Unsure) [[unlikely]]
    return later_first_contact(view, {result, false, {}}, counts).contact();
  counts.count(Stage::Double);
  return result == FilterResult::Yes;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
