// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/integer.h"
#include "robust/filtered/detail/numbers/length_unit.h"
#include "robust/filtered/detail/numbers/permanent.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/filtered/stage.h"

/// One sign, decided by one stage after another: permanent, short integers, double-double, long integers, integers of
/// any size.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The operands of the signs of one edge, relative to a ball, in double-doubles.
///
/// Differences of doubles are exact. Those of lifted vertices are known to 2^-103 of the maxima, and the normal to
/// bounds::kNormal times that, as bounds.h requires.
struct EdgeOperands {
  const Vector3<DoubleDouble>&to_center, &edge, &normal;
  double radius;
  int axis;       ///< for SignKind::Above
  Maxima maxima;  ///< each at most bounds::kLargest
  bool lifted;    ///< whether vertices are lifted
  /// The two edges from which the normal was computed, if it is that of a triangle; else null, and either `normal`
  /// holds all bits of the normal or `exact_normal` is false.
  const Vector3<DoubleDouble>* normal_edges;
  bool exact_normal;
};

struct DoubleDoubleView {
  const EdgeOperands& operands;
  [[nodiscard]] const Vector3<DoubleDouble>& to_center() const { return operands.to_center; }
  [[nodiscard]] const Vector3<DoubleDouble>& edge() const { return operands.edge; }
  [[nodiscard]] const Vector3<DoubleDouble>& normal() const { return operands.normal; }
  [[nodiscard]] DoubleDouble radius() const { return operands.radius; }
  [[nodiscard]] int axis() const { return operands.axis; }
};

/// The doubles nearest to the differences and to the normal.
struct PermanentView {
  const EdgeOperands& operands;
  using Vector = Vector3<Permanent<1>>;

  /// Half a unit in the last place is u |high|; the error of a double-double is far below u 2^-40 of its maximum.
  static Vector rounded(const Vector3<DoubleDouble>& v, double maximum) {
    const auto component = [slack = 0x1p-40 * maximum](const DoubleDouble& x) {
      return Permanent<1>{x.high, std::abs(x.high) + slack};
    };
    return {component(v.x), component(v.y), component(v.z)};
  }
  [[nodiscard]] Vector to_center() const {
    return rounded(operands.to_center, operands.lifted ? operands.maxima.to_center : 0);
  }
  [[nodiscard]] Vector edge() const { return rounded(operands.edge, operands.lifted ? operands.maxima.edge : 0); }
  [[nodiscard]] Vector normal() const { return rounded(operands.normal, operands.maxima.normal); }
  [[nodiscard]] Permanent<0> radius() const { return exact_double(operands.radius); }
  [[nodiscard]] int axis() const { return operands.axis; }
};

/// Everything times a power of two, as integers of at most Bits bits (the normal: 2 Bits + 1).
template <int Bits>
class IntegerView {
 public:
  /// Requires that no vertex is lifted, and that the operands outlive the view.
  explicit IntegerView(const EdgeOperands& operands) : operands_(operands), scale_(0), fits_(false) {
    if (!short_enough(operands.to_center) || !short_enough(operands.edge)) return;
    // Then every difference is below 2^Bits, and the normal below 2^(2 Bits + 1).
    int shift = Bits - 1 - exponent(std::max(operands.maxima.to_center, operands.maxima.edge));
    if (operands.normal_edges == nullptr) shift = std::min(shift, (2 * Bits - exponent(operands.maxima.normal)) >> 1);
    if (shift > 400) return;
    scale_ = power_of_two(shift);
    fits_ = whole(operands.to_center) && whole(operands.edge) && whole(operands.radius, scale_) && whole_normal();
  }
  explicit IntegerView(EdgeOperands&&) = delete;

  /// Returns whether all numbers are integers after the scaling.
  [[nodiscard]] bool fits() const { return fits_; }

  using Vector = Vector3<Integer<Bits>>;
  using Normal = Vector3<Integer<2 * Bits + 1>>;
  [[nodiscard]] Vector to_center() const { return integers(operands_.to_center); }
  [[nodiscard]] Vector edge() const { return integers(operands_.edge); }
  [[nodiscard]] Normal normal() const {
    if (operands_.normal_edges != nullptr)
      return signs::normal(integers(operands_.normal_edges[0]), integers(operands_.normal_edges[1]));
    const auto integer = [scale = scale_ * scale_](const DoubleDouble& x) {
      using Storage = typename Integer<2 * Bits + 1>::Storage;
      return Integer<2 * Bits + 1>(static_cast<Storage>(x.high * scale) + static_cast<Storage>(x.low * scale));
    };
    return {integer(operands_.normal.x), integer(operands_.normal.y), integer(operands_.normal.z)};
  }
  [[nodiscard]] Integer<Bits> radius() const { return integer(operands_.radius); }
  /// @{
  /// Returns whether both words of a length, which is at most the maxima, are integers after the scaling; their sum.
  [[nodiscard]] bool fits(const DoubleDouble& length) const {
    return whole(length.high, scale_) && whole(length.low, scale_);
  }
  [[nodiscard]] Integer<Bits + 1> integer(const DoubleDouble& length) const {
    return integer(length.high) + integer(length.low);
  }
  /// @}
  [[nodiscard]] int axis() const { return operands_.axis; }

 private:
  static int exponent(double normal) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(normal) >> 52 & 0x7ff) - 1023;
  }
  /// Returns whether no component has more than Bits bits or a tail. Most numbers fail this test at once.
  static bool short_enough(const Vector3<DoubleDouble>& v) {
    if (v.x.low != 0 || v.y.low != 0 || v.z.low != 0) return false;  // exact: tails of error-free differences
    constexpr std::uint64_t rest = Bits < 53 ? (std::uint64_t{1} << (53 - std::min(Bits, 53))) - 1 : 0;
    const auto bits = [](const DoubleDouble& x) { return std::bit_cast<std::uint64_t>(x.high); };
    return ((bits(v.x) | bits(v.y) | bits(v.z)) & rest) == 0;
  }
  /// Returns whether the number is an integer after the scaling, which must not have made it zero.
  static bool whole(double length, double scale) {
    const double scaled = length * scale;
    return is_integer(scaled) && (scaled != 0 || length == 0);  // exact
  }
  [[nodiscard]] bool whole(const Vector3<DoubleDouble>& v) const {
    return whole(v.x.high, scale_) && whole(v.y.high, scale_) && whole(v.z.high, scale_);
  }
  [[nodiscard]] bool whole_normal() const {
    if (operands_.normal_edges != nullptr) {
      const auto &u = operands_.normal_edges[0], &v = operands_.normal_edges[1];
      return short_enough(u) && short_enough(v) && whole(u) && whole(v);
    }
    const double scale = scale_ * scale_;
    const auto component = [scale](const DoubleDouble& x) { return whole(x.high, scale) && whole(x.low, scale); };
    return operands_.exact_normal && component(operands_.normal.x) && component(operands_.normal.y) &&
           component(operands_.normal.z);
  }
  [[nodiscard]] Integer<Bits> integer(double value) const {
    return Integer<Bits>(static_cast<std::int64_t>(value * scale_));
  }
  [[nodiscard]] Vector integers(const Vector3<DoubleDouble>& v) const {
    return {integer(v.x.high), integer(v.y.high), integer(v.z.high)};
  }

  const EdgeOperands& operands_;
  double scale_;
  bool fits_;
};

[[nodiscard]] inline bool is_zero(const Vector3<DoubleDouble>& v) {
  return v.x.high == 0 && v.y.high == 0 && v.z.high == 0;  // exact: the tails are zero with them
}

/// Returns whether a component of u x v is certainly zero, given the computed product. Requires exact vectors.
///
/// Where neither vector has a tail and the two products round to the same double, which does not underflow, the
/// computed component is the rounded difference of their rests.
[[nodiscard]] inline bool certainly_zero(const Vector3<DoubleDouble>& u, const Vector3<DoubleDouble>& v,
                                         const Vector3<DoubleDouble>& product, int axis) {
  if (product[axis].high != 0) return false;  // exact
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto some_zero = [](const DoubleDouble& a, const DoubleDouble& b) { return a.high == 0 || b.high == 0; };
  if (some_zero(u[i], v[j]) && some_zero(u[j], v[i])) return true;
  if (u[i].low != 0 || u[j].low != 0 || v[i].low != 0 || v[j].low != 0) return false;  // exact
  const double first = u[i].high * v[j].high;
  return first == u[j].high * v[i].high && std::abs(first) >= 0x1p-900;  // exact: compared as rounded
}

/// Returns whether e.e t - (w.e) e_axis is zero, for exact vectors and a number, no larger than their components, that
/// are integers of at most Bits bits times a power of two. False if they are not.
template <int Bits>
[[nodiscard]] bool is_step_along(const Vector3<DoubleDouble>& w, const Vector3<DoubleDouble>& e, const DoubleDouble& t,
                                 int axis) {
  const auto largest = [](const Vector3<DoubleDouble>& v) {
    return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
  };
  const Vector3<DoubleDouble> edges[] = {e, e};  // there is no normal
  const EdgeOperands operands{w, e, e, 0, 0, {largest(w), largest(e), 0}, false, edges, false};
  const IntegerView<Bits> view(operands);
  if (!view.fits() || !view.fits(t)) return false;
  const auto to_center = view.to_center(), edge = view.edge();
  return (dot(edge, edge) * view.integer(t) - dot(to_center, edge) * edge[axis]).sign() == 0;
}
/// Returns whether a component of e.e w - (w.e) e is zero. False if they are not short.
[[nodiscard]] inline bool zero_across(const Vector3<DoubleDouble>& w, const Vector3<DoubleDouble>& e, int axis) {
  return is_step_along<30>(w, e, w[axis], axis);
}

/// Returns whether the sign is 0 because the centre is the edge's start, or because the edge has no length, so that
/// every product has a factor 0.
template <SignKind kind>
bool vanishes(const EdgeOperands& operands) {
  if (operands.lifted) return false;
  constexpr bool of_edge =
      kind == SignKind::Along || kind == SignKind::Beyond || kind == SignKind::Line || kind == SignKind::Side;
  if (of_edge && is_zero(operands.edge)) return true;
  if (!is_zero(operands.to_center)) return false;
  constexpr bool linear =
      kind == SignKind::Along || kind == SignKind::Front || kind == SignKind::Side || kind == SignKind::Above;
  return linear || (kind != SignKind::Beyond && operands.radius == 0);
}

/// Returns the exact sign. Calls `bigint()` only if no other stage decides. Leaves out the stages before `first`.
/// Requires round to nearest, without flush-to-zero.
template <SignKind kind, Stage first = Stage::Permanent, class BigInteger, class Counts>
int exact_sign(const EdgeOperands& operands, Counts& counts, const BigInteger& bigint) {
  constexpr bool permanent = first <= Stage::Permanent, double_double = first <= Stage::DoubleDouble;
  if (const int sign = permanent ? certain_sign(expression<kind>(PermanentView{operands}), bounds::kTiny) : 0) {
    counts.count(Stage::Permanent);
    return sign;
  }
  if (vanishes<kind>(operands)) {
    counts.count(Stage::DoubleDouble);
    return 0;
  }
  if (!operands.lifted) {
    if (const IntegerView<30> view(operands); view.fits()) {
      counts.count(Stage::FixedInteger);
      return expression<kind>(view).sign();
    }
  }
  if (const int sign = double_double ? estimate<kind>(DoubleDoubleView{operands}, operands.maxima).sign() : 0) {
    counts.count(Stage::DoubleDouble);
    return sign;
  }
  if (!operands.lifted) {
    if (const IntegerView<62> view(operands); view.fits()) {
      counts.count(Stage::FixedInteger);
      return expression<kind>(view).sign();
    }
  }
  counts.count(Stage::BigInteger);
  return bigint();
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET
