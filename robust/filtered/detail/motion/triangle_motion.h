// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "robust/filtered/detail/motion/capsule.h"
#include "robust/filtered/detail/motion/triangle_events.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
#include "robust/filtered/detail/triangle/scaled_triangle.h"
#include "robust/filtered/detail/triangle/triangle_closest.h"

/// All stages for a moving ball and a triangle.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// Returns the first contact of a ball that touches at its start. Requires round to nearest.
template <class Counts>
FirstContact start_contact(const MotionTriangleView& view, Counts& counts) {
  const double center[] = {view.center(0), view.center(1), view.center(2), 0};
  const BallTriangleView at_rest{view.vertex, center};
  const ExactTriangle<Counts> triangle(at_rest, counts, view.radius());
  const Feature feature = triangle.nearest();
  const ClosestPointOnFeature closest(triangle, feature);
  return {FirstContactKind::Start,
          0,
          false,
          feature,
          {closest.coordinate(0), closest.coordinate(1), closest.coordinate(2)},
          closest.contact_normal(),
          closest.depth()};
}

/// The knowledge of the first stage.
struct MotionFilterResult {
  FilterResult contact;
  FilterResult at_start = FilterResult::Unsure;  ///< the contact at time 0
  std::optional<Feature> feature = {};           ///< the feature touched first on the way, if it is certain
  PossibleEvents possible = {};                  ///< on the way
  /// @{
  /// If `latest` is finite, the ball does not touch at its start, but first touches between these times.
  double earliest = 0, latest = std::numeric_limits<double>::infinity();
  /// @}
};

/// Looks for the first contact in doubles. `contact_at_start()` returns what they know about the contact at time 0.
template <class Start>
TOUCHSTONE_INLINE MotionFilterResult motion_filter(const MotionTriangleView& view, const Start& contact_at_start) {
  const Vector3<Pack> vertex = vertex_lanes(view.vertex);
  if (!in_range(vertex, view, bounds::kLongestMotion)) [[unlikely]]
    return {FilterResult::OutOfRange};
  const TriangleMotionLanes lanes(vertex, view);
  const PlaneEntry<Pack> plane = lanes.plane();
  if ((plane.misses & TriangleEvents::all) != 0) return {FilterResult::No};
  const FilterResult start = contact_at_start();
  if (start != FilterResult::No) return {start, start};
  const TriangleEvents events{start_event(lanes.moving), interior_event(lanes.moving), face_event(lanes, plane.entry)};
  const PossibleEvents possible = events.possible();
  if (events.unsure()) return {FilterResult::Unsure, start, {}, possible};
  if (!events.any()) return {FilterResult::No, start};
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
  const double earliest = candidate.earliest(), latest = candidate.latest();
  if (!candidate.certain()) return {FilterResult::Unsure, start, {}, possible, earliest, latest};
  return {FilterResult::Yes, start, candidate.feature(), possible, earliest, latest};
}

TOUCHSTONE_INLINE MotionFilterResult motion_filter(const MotionTriangleView& view) {
  return motion_filter(view, [&view] {
    TriangleSigns signs;
    return triangle_filter({view.vertex, view.motion}, signs);
  });
}

// If the largest number is smaller than this, lengths are scaled.
inline constexpr double kOrdinary = 0x1p20 / bounds::kLongestMotion;

/// A motion and a triangle in double-doubles, scaled if they have to be.
class ScaledMotionDoubles {
 public:
  ScaledMotionDoubles(const MotionTriangleView& given, bool out_of_range) {
    const double largest = largest_number(given);
    if (out_of_range || largest < kOrdinary) scaled_.emplace(given, largest);
    if (!scaled_)
      doubles_.emplace(given, nullptr);
    else if (scaled_->exact())
      doubles_.emplace(scaled_->view(), &scaled_->unit());
  }
  /// Returns nothing if scaling loses a bit.
  [[nodiscard]] const std::optional<TriangleMotionDoubles>& doubles() const { return doubles_; }

 private:
  std::optional<ScaledTriangle<MotionTriangleView>> scaled_;
  std::optional<TriangleMotionDoubles> doubles_;
};

/// Returns whether a lower edge of a degenerate triangle may hold the touched point, too.
inline bool may_be_on_lower_edge(const double (*vertex)[3], const Feature& feature) {
  for (std::size_t i = 0; i < feature.index && feature.kind == Feature::Kind::Edge; ++i)
    if (!std::equal(vertex[i], vertex[i] + 3, vertex[i + 1])) return true;  // exact
  return false;
}

/// Returns the first contact on the way with a feature that is certainly touched first and that a first stage within
/// its range has found; nothing if its rounding is not certain.
inline std::optional<FirstContact> first_contact_with(MotionTriangleView view, const Feature& feature) {
  const TriangleMotionDoubles doubles(view, nullptr);
  return TouchedPoint(doubles, feature, event_time(doubles, feature)).rounded_contact();
}

/// Returns the first contact on the way in double-doubles; nothing if it is not certain.
inline std::optional<FirstContact> first_contact_in_doubles(const MotionTriangleView& view,
                                                            const MotionFilterResult& known) {
  if (known.feature) return first_contact_with(view, *known.feature);
  const ScaledMotionDoubles scaled(view, known.contact == FilterResult::OutOfRange);
  const auto& doubles = scaled.doubles();
  if (!doubles) return std::nullopt;
  const bool degenerate = is_degenerate(view.vertex);
  FirstCandidate<DoubleDouble> first;
  switch (doubles->find_first(degenerate ? events_of_ends(view.vertex) : known.possible, first)) {
    case FilterResult::Yes:
      if (degenerate && may_be_on_lower_edge(view.vertex, first.feature())) return std::nullopt;
      return TouchedPoint(*doubles, first.feature(), {first.time(), first.error()}).rounded_contact();
    case FilterResult::No: return FirstContact{};
    default: return std::nullopt;
  }
}

/// Returns the first contact where the first stage does not suffice.
template <class Counts>
__attribute__((noinline)) FirstContact later_first_contact(const MotionTriangleView& given,
                                                           const MotionFilterResult& known, Counts& counts) {
  const FloatingPointState nearest;
  if (known.at_start == FilterResult::Yes ||
      (known.at_start != FilterResult::No && contact(BallTriangleView{given.vertex, given.motion}, counts))) {
    if (known.at_start == FilterResult::Yes) counts.count(Stage::Double);
    return start_contact(given, counts);
  }
  if (at_rest(given)) {  // all events of a way of length 0 are uncertain
    if (known.at_start == FilterResult::No) counts.count(Stage::Double);
    return {};
  }
  if (const auto found = first_contact_in_doubles(given, known)) {
    counts.count(Stage::DoubleDouble);
    return *found;
  }
  counts.count(Stage::BigInteger);
  return exact_first_contact(given);
}

/// Returns whether double-doubles exclude a contact that doubles leave open.
template <class Counts>
__attribute__((noinline)) bool misses_in_doubles(const MotionTriangleView& view, const CapsuleSigns& signs,
                                                 Counts& counts) {
  const FloatingPointState nearest;
  return !at_rest(view) && unsure_capsule(view, signs, counts) == FilterResult::No;
}

template <class Counts>
void triangle_first_contact(MotionTriangleView view, FirstContact& contact, Counts& counts) {
  // Signs alone exclude most contacts at a third of the price of times.
  CapsuleSigns signs;
  const FilterResult capsule = capsule_filter(view, signs);
  if (capsule == FilterResult::Unsure && misses_in_doubles(view, signs, counts)) {
    contact = {};
    return;
  }
  if (capsule != FilterResult::No) {
    const MotionFilterResult known = capsule == FilterResult::OutOfRange ? MotionFilterResult{capsule}
                                     : signs.at_start == FilterResult::Yes
                                         ? MotionFilterResult{FilterResult::Yes, FilterResult::Yes}
                                         : motion_filter(view, [&signs] { return signs.at_start; });
    if (known.contact != FilterResult::No) {
      contact = later_first_contact(view, known, counts);
      return;
    }
  }
  counts.count(Stage::Double);
  contact = {};
}

/// Returns whether the ball touches where the first stage does not suffice.
template <class Counts>
__attribute__((noinline)) bool later_motion_contact(const MotionTriangleView& view, FilterResult result,
                                                    const CapsuleSigns& signs, Counts& counts) {
  const FloatingPointState nearest;
  const BallTriangleView at_start{view.vertex, view.motion};
  // All signs of a way of length 0 are 0.
  if (at_rest(view)) return contact(at_start, counts);
  if (result == FilterResult::Unsure) {
    const FilterResult known = unsure_capsule(view, signs, counts);
    if (known < FilterResult::Unsure) return known == FilterResult::Yes;
  } else if (contact(at_start, counts)) {
    return true;
  }
  const ScaledMotionDoubles scaled(view, result == FilterResult::OutOfRange);
  FirstCandidate<DoubleDouble> first;
  const PossibleEvents possible = is_degenerate(view.vertex) ? events_of_ends(view.vertex) : PossibleEvents{};
  const FilterResult known =
      scaled.doubles() ? scaled.doubles()->template find_first<true>(possible, first) : FilterResult::Unsure;
  if (known < FilterResult::Unsure) {
    counts.count(Stage::DoubleDouble);
    return known == FilterResult::Yes;
  }
  counts.count(Stage::BigInteger);
  return exact_motion_contact(view);
}

template <class Counts>
bool triangle_motion_contact(MotionTriangleView view, Counts& counts) {
  CapsuleSigns signs;
  const FilterResult result = capsule_filter(view, signs);
  if (result >= FilterResult::Unsure) [[unlikely]]
    return later_motion_contact(view, result, signs, counts);
  counts.count(Stage::Double);
  return result == FilterResult::Yes;
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
