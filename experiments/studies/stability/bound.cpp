// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "experiments/studies/stability/stress.h"
#include "geometry/contact/fast.h"
#include "robust/filtered/detail/polygon/exact_edges.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/signs/sign_ladder.h"
#include "robust/filtered/detail/signs/signs.h"

namespace touchstone::stability {
namespace {

using filtered::detail::DoubleDouble;
using filtered::detail::Maxima;
using filtered::detail::SignKind;
using filtered::detail::Vector3;
namespace bounds = filtered::detail::bounds;

constexpr std::array kKinds{SignKind::Vertex, SignKind::Along, SignKind::Beyond, SignKind::Line,
                            SignKind::Front,  SignKind::Plane, SignKind::Side,   SignKind::Above};
constexpr std::array kKindNames{"vertex", "along", "beyond", "line", "front", "plane", "side", "above"};
static_assert(kKinds.size() == kKindNames.size());

// Places in bounded_quantities().
constexpr std::size_t kMaximaBegin = 0, kNormalPlace = kKinds.size(), kPermanentBegin = kNormalPlace + 1,
                      kDoubleDoubleBegin = kPermanentBegin + kKinds.size(),
                      kFrameBegin = kDoubleDoubleBegin + kKinds.size(), kFastPlace = kFrameBegin + 3;

/// visit(std::integral_constant<SignKind, kind>, its place) for each kind.
template <class Visit, std::size_t... place>
void for_each_kind(const Visit& visit, std::index_sequence<place...>) {
  (visit(std::integral_constant<SignKind, kKinds[place]>(), place), ...);
}
template <class Visit>
void for_each_kind(const Visit& visit) {
  for_each_kind(visit, std::make_index_sequence<kKinds.size()>());
}

/// An edge as seen from a ball, over any number type; signs.h is asked with it.
template <class Number>
struct View {
  Vector3<Number> to_center_, edge_, normal_;
  Number radius_;
  int axis_;

  [[nodiscard]] const Vector3<Number>& to_center() const { return to_center_; }
  [[nodiscard]] const Vector3<Number>& edge() const { return edge_; }
  [[nodiscard]] const Vector3<Number>& normal() const { return normal_; }
  [[nodiscard]] const Number& radius() const { return radius_; }
  [[nodiscard]] int axis() const { return axis_; }
};

template <SignKind kind>
constexpr double constant() {
  return filtered::detail::bound<kind>(Maxima{1, 1, 1});
}
template <SignKind kind>
constexpr int roundings() {
  using Vector = Vector3<filtered::detail::Permanent<1>>;
  const auto count = []<int n>(const filtered::detail::Permanent<n>&) { return std::integral_constant<int, n>(); };
  return decltype(count(filtered::detail::expression<kind>(
      View<filtered::detail::Permanent<1>>{Vector{}, Vector{}, Vector{}, {}, 0})))::value;
}

/// `size` is what the bound is a multiple of.
template <class Number>
Observation observation(std::size_t quantity, const Number& computed, const Number& exact, double bound, double size) {
  const Number error = abs(computed - exact), magnitude = abs(exact);
  const bool zero = magnitude == 0;
  const auto quotient = [](const Number& a, const Number& b) { return Number(a / b).get_d(); };
  return {quantity, quotient(error, Number(bound)), error <= Number(bound),
          zero ? INFINITY : quotient(Number(size), magnitude), zero ? NAN : quotient(error, magnitude)};
}

Vector3<double> difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}
double largest(const Vector3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double largest(const Eigen::Vector3d& v) { return v.cwiseAbs().maxCoeff(); }

/// The signs in plain doubles, and the maxima that their bounds are made from.
struct InDoubles {
  std::array<double, kKinds.size()> values, bounds, products;
  Vector3<double> normal;
  double normal_bound, normal_product;
};

/// Not inlined: the compiler may not move its operations out of the caller's floating-point mode.
[[gnu::noinline]] InDoubles signs_in_doubles(const Ball& ball, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                             const Eigen::Vector3d& c, int axis) {
  const Vector3<double> from = difference(ball.center, a), edge = difference(b, a), other = difference(c, a);
  const View<double> view{from, edge, filtered::detail::signs::normal(edge, other), ball.radius, axis};
  const double m_normal = 2 * largest(edge) * largest(other);
  const Maxima maxima{std::max(largest(from), ball.radius), largest(edge), m_normal};
  InDoubles result{};
  for_each_kind([&](auto kind, std::size_t place) {
    result.values[place] = filtered::detail::expression<kind.value>(view);
    result.bounds[place] = bounds::kUnit * filtered::detail::bound<kind.value>(maxima) + bounds::kTiny;
    result.products[place] = filtered::detail::bound<kind.value>(maxima) / constant<kind.value>();
  });
  result.normal = view.normal();
  result.normal_bound = bounds::kUnit * (bounds::kNormal * m_normal) + bounds::kTiny;
  result.normal_product = m_normal;
  return result;
}

/// A prepared polygon's quantities in its frame.
struct InFrame {
  double height, height_error, size, along, across;
};

[[gnu::noinline]] InFrame quantities_in_frame(const Ball& ball, const filtered::PreparedPolygon::Parts& parts,
                                              std::size_t edge) {
  const filtered::detail::HeightQuery height(ball, *parts.frame);
  const filtered::detail::FrameQuery query(height, *parts.frame);
  InFrame result{height.height, height.height_error, height.size, 0, 0};
  for (const auto& leaf : parts.edges->all_leaves()) {
    const auto here = std::span(leaf.edge).first(leaf.count);
    const auto lane = static_cast<std::size_t>(std::ranges::find(here, edge) - here.begin());
    if (lane == leaf.count) continue;
    result.along = filtered::detail::frame::along(query.x, query.y, leaf.start_x[lane], leaf.start_y[lane],
                                                  leaf.direction_x[lane], leaf.direction_y[lane]);
    result.across = filtered::detail::frame::across(query.x, query.y, leaf.start_x[lane], leaf.start_y[lane],
                                                    leaf.direction_x[lane], leaf.direction_y[lane]);
  }
  return result;
}

Rational scaled(Rational number, int exponent) {
  if (exponent >= 0)
    mpq_mul_2exp(number.value.get_mpq_t(), number.value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else
    mpq_div_2exp(number.value.get_mpq_t(), number.value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return number;
}
RationalVector scaled(const RationalVector& v, int exponent) {
  return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
}

Rational& component(RationalVector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

std::string_view to_string(BoundStage stage) {
  switch (stage) {
    case BoundStage::Maxima: return "maxima";
    case BoundStage::Permanent: return "permanent";
    case BoundStage::DoubleDouble: return "double-double";
    case BoundStage::Frame: return "frame";
    case BoundStage::FastPlanarity: break;
  }
  return "fast-planarity";
}

const std::vector<BoundedQuantity>& bounded_quantities() {
  static const std::vector<BoundedQuantity> quantities = [] {
    std::vector<BoundedQuantity> list;
    for_each_kind([&](auto kind, std::size_t place) {
      list.push_back({BoundStage::Maxima, kKindNames[place], bounds::kUnit * constant<kind.value>()});
    });
    list.push_back({BoundStage::Maxima, "normal", bounds::kUnit * bounds::kNormal});
    for_each_kind([&](auto kind, std::size_t place) {
      list.push_back({BoundStage::Permanent, kKindNames[place], (roundings<kind.value>() + 0.125) * 0x1p-53});
    });
    for_each_kind([&](auto kind, std::size_t place) {
      list.push_back({BoundStage::DoubleDouble, kKindNames[place], bounds::kDoubleDoubleUnit * constant<kind.value>()});
    });
    list.push_back({BoundStage::Frame, "height", bounds::kUnit * bounds::kHeight});
    list.push_back({BoundStage::Frame, "along", bounds::kUnit * bounds::kEdgeFrame});
    list.push_back({BoundStage::Frame, "across", bounds::kUnit * bounds::kEdgeFrame});
    list.push_back({BoundStage::FastPlanarity, "height", 8 * std::numeric_limits<double>::epsilon()});
    return list;
  }();
  return quantities;
}

BoundTrial::BoundTrial(const Polygon& polygon)
    : polygon_(polygon), prepared_(polygon), normal_{exactly(0), exactly(0), exactly(0)}, fast_noise_(0) {
  const std::size_t outer = polygon.loop_end(0);
  const RationalVector first = exactly(polygon.vertex(0));
  RationalVector sum = normal_;
  for (std::size_t i = 0; i < outer; ++i) {
    const RationalVector here = exactly(polygon.vertex(i)) - first;
    normal_ = normal_ + filtered::detail::cross(here, exactly(polygon.vertex(polygon.next(i))) - first);
    sum = sum + here;
  }
  int dropped = 0;
  for (const int axis : {1, 2})
    if (abs(normal_[axis].value) > abs(normal_[dropped].value)) dropped = axis;
  const Rational height = filtered::detail::dot(normal_, sum) / Rational{mpq_class(outer)};
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    RationalVector point = exactly(polygon.vertex(i));
    const Rational lift = (height - filtered::detail::dot(normal_, point - first)) / normal_[dropped];
    component(point, dropped) = point[dropped] + lift;
    lifted_.push_back(point);
  }

  // As in fast_definitions.h.
  const fast::PreparedPolygon<> fast(polygon);
  fast_normal_ = fast.plane().normal;
  double products = 0, extent = 0;
  const auto relative = [&](std::size_t i) { return Eigen::Vector3d(polygon.vertex(i) - polygon.vertex(0)); };
  for (std::size_t i = 0; i < outer; ++i) products += largest(relative(i)) * largest(relative(polygon.next(i)));
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) extent = std::max(extent, largest(relative(i)));
  fast_noise_ = 8 * std::numeric_limits<double>::epsilon() * products * extent;
}

void BoundTrial::observe(const Ball& ball, std::size_t edge, const FloatingPointMode& mode, double bound_factor,
                         std::vector<Observation>& observations) const {
  observe_signs_in_doubles(ball, edge, mode, bound_factor, observations);
  const auto& frame = parts_of(prepared_).frame;
  if (frame && std::max(largest(ball.center), ball.radius) <= frame->reachable) {
    observe_frame(ball, edge, mode, bound_factor, observations);
    observe_prepared_signs(ball, edge, bound_factor, observations);
  }
  observe_fast(edge, bound_factor, observations);
}

/// For the triangle of the edge and the vertex after it.
void BoundTrial::observe_signs_in_doubles(const Ball& ball, std::size_t edge, const FloatingPointMode& mode,
                                          double bound_factor, std::vector<Observation>& observations) const {
  const std::size_t next = polygon_.next(edge);
  const Eigen::Vector3d a = polygon_.vertex(edge), b = polygon_.vertex(next), c = polygon_.vertex(polygon_.next(next));
  const double input = std::max({largest(a), largest(b), largest(c), largest(ball.center), ball.radius});
  if (!(input <= bounds::kLargest / 2)) return;
  const auto axis = static_cast<int>(edge % 3);
  const InDoubles computed = [&] {
    const Environment environment(mode);
    return signs_in_doubles(ball, a, b, c, axis);
  }();
  const RationalVector from = exactly(ball.center) - exactly(a), first = exactly(b) - exactly(a);
  const RationalVector normal = filtered::detail::signs::normal(first, exactly(c) - exactly(a));
  const View<Rational> view{from, first, normal, exactly(ball.radius), axis};
  for_each_kind([&](auto kind, std::size_t place) {
    observations.push_back(observation(kMaximaBegin + place, mpq_class(computed.values[place]),
                                       filtered::detail::expression<kind.value>(view).value,
                                       bound_factor * computed.bounds[place], computed.products[place]));
  });
  observations.push_back(observation(kNormalPlace, mpq_class(computed.normal[axis]), normal[axis].value,
                                     bound_factor * computed.normal_bound, computed.normal_product));
}

/// As ExactEdges asks them: in the frame's unit of length, lifted.
void BoundTrial::observe_prepared_signs(const Ball& ball, std::size_t edge, double bound_factor,
                                        std::vector<Observation>& observations) const {
  const auto& parts = parts_of(prepared_);
  filtered::NoCounts none;
  const filtered::detail::ExactEdges edges(ball, parts, none);
  if (!edges.scales()) return;
  const auto axis = static_cast<int>(edge % 3);
  const auto& seen = edges.edge_view(edge);
  const filtered::detail::EdgeOperands operands = seen.operands(axis);
  if (!(std::max(operands.maxima.to_center, operands.maxima.edge) <= bounds::kLargest)) return;

  const int exponent = parts.frame->unit.exponent;
  const RationalVector from = exactly(ball.center) - lifted_[edge],
                       along = lifted_[polygon_.next(edge)] - lifted_[edge];
  const View<Rational> view{scaled(from, -exponent), scaled(along, -exponent), scaled(normal_, -2 * exponent),
                            scaled(exactly(ball.radius), -exponent), axis};
  for_each_kind([&](auto kind, std::size_t place) {
    const mpq_class exact = filtered::detail::expression<kind.value>(view).value;
    const auto permanent = filtered::detail::expression<kind.value>(filtered::detail::PermanentView{operands});
    const auto double_double = filtered::detail::expression<kind.value>(filtered::detail::DoubleDoubleView{operands});
    const auto in_doubles = bounded_quantities()[kPermanentBegin + place].constant * permanent.permanent;
    observations.push_back(observation(kPermanentBegin + place, mpq_class(permanent.value), exact,
                                       bound_factor * (in_doubles + bounds::kTiny), permanent.permanent));
    const double largest_error =
        bounds::kDoubleDoubleUnit * filtered::detail::bound<kind.value>(operands.maxima) + bounds::kTiny;
    observations.push_back(observation(
        kDoubleDoubleBegin + place, mpq_class(mpq_class(double_double.high) + mpq_class(double_double.low)), exact,
        bound_factor * largest_error, filtered::detail::bound<kind.value>(operands.maxima) / constant<kind.value>()));
  });
}

void BoundTrial::observe_frame(const Ball& ball, std::size_t edge, const FloatingPointMode& mode, double bound_factor,
                               std::vector<Observation>& observations) const {
  const filtered::detail::Frame& frame = *parts_of(prepared_).frame;
  const InFrame computed = [&] {
    const Environment environment(frame.unit.exponent < filtered::detail::Frame::kSubnormal ? FloatingPointMode()
                                                                                            : mode);
    return quantities_in_frame(ball, parts_of(prepared_), edge);
  }();
  const RationalVector from = scaled(exactly(ball.center) - lifted_[edge], -frame.unit.exponent);
  const RationalVector direction = lifted_[polygon_.next(edge)] - lifted_[edge];
  const mpf_class normal_length = sqrt(real(filtered::detail::dot(normal_, normal_)));
  const mpf_class edge_length = sqrt(real(filtered::detail::dot(direction, direction)));
  const mpf_class exact[] = {
      real(filtered::detail::dot(normal_, from)) / normal_length,
      real(filtered::detail::dot(from, direction)) / edge_length,
      real(filtered::detail::signs::side(normal_, direction, from)) / (normal_length * edge_length)};
  const double values[] = {computed.height, computed.along, computed.across};
  const double edge_bound = bounds::kEdgeFrame * bounds::kUnit * computed.size;
  const double errors[] = {computed.height_error, edge_bound, edge_bound};
  for (std::size_t i = 0; i < 3; ++i)
    observations.push_back(
        observation(kFrameBegin + i, mpf_class(values[i], 512), exact[i], bound_factor * errors[i], computed.size));
}

/// Within the sizes for which `fast` promises anything.
void BoundTrial::observe_fast(std::size_t vertex, double bound_factor, std::vector<Observation>& observations) const {
  if (std::abs(largest_exponent(polygon_)) > 160 || vertex == 0) return;
  const Eigen::Vector3d relative = polygon_.vertex(vertex) - polygon_.vertex(0);
  const mpq_class exact =
      filtered::detail::dot(normal_, exactly(polygon_.vertex(vertex)) - exactly(polygon_.vertex(0))).value;
  observations.push_back(observation(kFastPlace, mpq_class(fast_normal_.dot(relative)), exact,
                                     bound_factor * fast_noise_,
                                     fast_noise_ / bounded_quantities()[kFastPlace].constant));
}

}  // namespace touchstone::stability
