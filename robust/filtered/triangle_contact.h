// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/sign_ladder.h"
#include "robust/filtered/triangle_filter.h"
#include "robust/filtered/unlimited_sign.h"
#include "robust/floating_point_state.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// A triangle and a ball after the first stage: signs that it was sure of, and the way to the others.
template <class Counts>
class UnsureTriangle {
 public:
  /// Requires coordinates for which no difference exceeds bounds::kLargest, round to nearest, no flush-to-zero.
  UnsureTriangle(const TriangleQuestion& question, const TriangleSigns& sure, Counts& counts)
      : question_(question), sure_(sure), counts_(counts) {
    Maxima& m = maxima_;
    m = {question.radius, 0, 0};
    for (int i = 0; i < 3; ++i) {
      from_[i] = difference(question.center, question.vertex[i]);
      edge_[i] = difference(question.vertex[(i + 1) % 3], question.vertex[i]);
      m.from = std::max(m.from, largest(from_[i]));
      m.edge = std::max(m.edge, largest(edge_[i]));
    }
    m.from *= kAboveTails, m.edge *= kAboveTails;
    m.normal = 2 * kAboveTails * m.edge * m.edge;
    normal_ = signs::normal(edge_[0], edge_[1]);
  }

  /// The vertices and edges decide wherever the foot is outside; the plane does where it is not.
  [[nodiscard]] bool contact() const { return foot_outside() ? edges_touch() : plane_sign() <= 0; }

 private:
  static constexpr double kAboveTails = 1 + 0x1p-50;  // high + low may exceed high

  static Vector3<DoubleDouble> difference(const double* a, const double* b) {
    return {two_difference(a[0], b[0]), two_difference(a[1], b[1]), two_difference(a[2], b[2])};
  }
  static double largest(const Vector3<DoubleDouble>& v) {
    return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
  }

  template <SignKind kind>
  [[nodiscard]] int sign(const SureSigns& sure, int i) const {
    if (const int known = sure.of(i)) return known;
    const EdgeInQuestion edge{from_[i], edge_[i], normal_, question_.radius, 0, maxima_, false, edge_, false};
    return exact_sign<kind>(edge, counts_, [&] { return unlimited_sign(kind, question_, i); });
  }
  [[nodiscard]] int plane_sign() const {
    for (int i = 0; i < 3; ++i)
      if (const int known = sure_.plane.of(i)) return known;
    return sign<SignKind::Plane>({}, 0);
  }

  [[nodiscard]] bool foot_outside() const {
    if (sure_.side.negative != 0) return true;
    for (int i = 0; i < 3; ++i)
      if (sign<SignKind::Side>(sure_.side, i) < 0) return true;
    return false;
  }
  [[nodiscard]] bool edges_touch() const {
    for (int i = 0; i < 3; ++i)
      if (edge_touches(i)) return true;
    return false;
  }
  /// Vertex i is judged with edge i; where the closest point is the edge's end, with the next one.
  [[nodiscard]] bool edge_touches(int i) const {
    if (sign<SignKind::Vertex>(sure_.vertex, i) <= 0) return true;
    if (sure_.line.of(i) > 0) return false;
    return sign<SignKind::Along>(sure_.along, i) > 0 && sign<SignKind::Beyond>(sure_.beyond, i) < 0 &&
           sign<SignKind::Line>(sure_.line, i) <= 0;
  }

  const TriangleQuestion& question_;
  const TriangleSigns& sure_;
  Counts& counts_;
  Vector3<DoubleDouble> from_[3], edge_[3], normal_;
  Maxima maxima_;
};

/// Contact in unlimited integers alone.
inline bool unlimited_contact(const TriangleQuestion& question) {
  const auto sign = [&question](SignKind kind, int i) { return unlimited_sign(kind, question, i); };
  bool outside = false;
  for (int i = 0; i < 3; ++i) outside = outside || sign(SignKind::Side, i) < 0;
  if (!outside) return sign(SignKind::Plane, 0) <= 0;
  for (int i = 0; i < 3; ++i) {
    if (sign(SignKind::Vertex, i) <= 0) return true;
    if (sign(SignKind::Along, i) > 0 && sign(SignKind::Beyond, i) < 0 && sign(SignKind::Line, i) <= 0) return true;
  }
  return false;
}

/// A triangle and a ball times a power of two.
class ScaledTriangle {
 public:
  /// Requires that `largest` is the largest magnitude of a number in the question; brings it to [1/2, 1).
  ScaledTriangle(const TriangleQuestion& question, double largest) : exponent_(std::ilogb(largest) + 1) {
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) vertex_[i][axis] = scaled(question.vertex[i][axis]);
      center_[i] = scaled(question.center[i]);
    }
    radius_ = scaled(question.radius);
  }
  /// No bit was lost.
  [[nodiscard]] bool exact() const { return exact_; }
  [[nodiscard]] TriangleQuestion question() const { return {vertex_, center_, radius_}; }

 private:
  double scaled(double length) {
    const double result = std::ldexp(length, -exponent_);
    exact_ = exact_ && std::ldexp(result, exponent_) == length;  // exact
    return result;
  }

  int exponent_;
  bool exact_ = true;
  double vertex_[3][3], center_[3], radius_;
};

/// What the first stage could not tell.
template <class Counts>
__attribute__((noinline)) bool unsure_contact(const TriangleQuestion& question, TriangleSigns& signs, Counts& counts) {
  const FloatingPointState nearest;
  double largest = question.radius;
  for (int i = 0; i < 3; ++i)
    for (const double x : {question.vertex[i][0], question.vertex[i][1], question.vertex[i][2], question.center[i]})
      largest = std::max(largest, std::abs(x));
  if (largest <= bounds::kLargest / 2 && largest >= 0x1p-30)
    return UnsureTriangle<Counts>(question, signs, counts).contact();

  const ScaledTriangle scaled(question, largest);
  if (!scaled.exact()) {
    counts.count(Stage::Unlimited);
    return unlimited_contact(question);
  }
  const TriangleQuestion same = scaled.question();
  const Sure sure = triangle_filter(same, signs);
  if (sure == Sure::Unsure) return UnsureTriangle<Counts>(same, signs, counts).contact();
  counts.count(Stage::Double);
  return sure == Sure::Yes;
}

template <class Counts>
TOUCHSTONE_INLINE bool contact(const TriangleQuestion& question, Counts& counts) {
  TriangleSigns signs;
  const Sure sure = triangle_filter(question, signs);
  if (sure == Sure::Unsure) [[unlikely]]
    return unsure_contact(question, signs, counts);
  counts.count(Stage::Double);
  return sure == Sure::Yes;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
