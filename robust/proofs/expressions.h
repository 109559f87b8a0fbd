// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/edge_frame.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/filtered/detail/triangle/triangle_lanes.h"

/// The list of all claims that are proved: every expression of signs.h, edge_frame.h and triangle_lanes.h with its
/// inputs, its constant and the maxima by which the constant is multiplied, and the operations of double_double.h.
/// Records, error calculus and toy arithmetic all use this list.
namespace touchstone::proofs {

using namespace filtered::detail;

/// The part of every constant that covers the rounding of the bound computed with it.
inline constexpr double kRoundingOfBound = 0x1p-5;
/// The relative amount by which magnitudes may exceed their maximum: so high parts may replace double-doubles, and the
/// computed 2 m_u m_v may serve for the normal.
inline constexpr double kExcess = 0x1p-50;

/// The maxima of bounds.h; One bounds axes and unit directions.
enum class Maximum { Ball, Edge, BallOrEdge, Velocity, Normal, FirstEdge, SecondEdge, One, Centre, Foot };
inline constexpr int kMaxima = 10;

/// The largest value that a maximum may have.
constexpr double largest(Maximum maximum) {
  if (maximum == Maximum::One) return 1;
  return maximum == Maximum::Normal ? 2 * bounds::kLargest * bounds::kLargest : bounds::kLargest;
}

/// The smallest value of a maximum from which on kTiny is not needed.
constexpr double smallest(Maximum maximum) {
  if (maximum == Maximum::One || maximum == Maximum::Foot) return 1;
  return maximum == Maximum::Normal ? 2 * bounds::kSmallest * bounds::kSmallest : bounds::kSmallest;
}

/// An input whose computed value is at most its maximum and differs from the exact one by at most
/// error unit maximum.
struct Input {
  std::string name;
  Maximum maximum;
  double error;
};

/// The inputs of all expressions; each expression takes those that it needs.
template <class Number>
struct Inputs {
  Vector3<Number> to_center, ahead, edge, velocity;
  Number radius;
  Vector3<Number> first_edge, second_edge, normal;
  Vector3<Number> axis, from_origin;
  Number foot_x, foot_y, start_x, start_y, direction_x, direction_y;
  Vector3<Number> first_exact, second_exact;
  Vector3<Number> lane_vertex, lane_edge;
  Number first_weight, second_weight;
};

/// Calls make(Input) for each number, in the order of the members.
template <class Number, class Make>
Inputs<Number> make_inputs(Make make) {
  const auto vector = [&](const std::string& name, Maximum maximum, double error) {
    return Vector3<Number>{make(Input{name + "_x", maximum, error}), make(Input{name + "_y", maximum, error}),
                           make(Input{name + "_z", maximum, error})};
  };
  const auto number = [&](const std::string& name, Maximum maximum, double error) {
    return make(Input{name, maximum, error});
  };
  using enum Maximum;
  return {vector("to_center", Ball, 1),
          vector("ahead", Ball, 1),
          vector("edge", Edge, 1),
          vector("velocity", Velocity, 1),
          number("radius", Ball, 0),
          vector("first_edge", FirstEdge, 1),
          vector("second_edge", SecondEdge, 1),
          vector("normal", Normal, bounds::kNormal),
          vector("axis", One, 1),
          vector("from_origin", Centre, 1),
          number("foot_x", Foot, bounds::kCoordinate),
          number("foot_y", Foot, bounds::kCoordinate),
          number("start_x", Foot, bounds::kFramePoint),
          number("start_y", Foot, bounds::kFramePoint),
          number("direction_x", One, bounds::kFrameDirection),
          number("direction_y", One, bounds::kFrameDirection),
          vector("first_exact", One, 0),
          vector("second_exact", One, 0),
          vector("lane_vertex", Foot, bounds::kLaneVertex),
          vector("lane_edge", Foot, 0),
          number("first_weight", One, 0),
          number("second_weight", One, 0)};
}

/// The numbers over which a filter evaluates an expression of the list. Signs have none: what takes them to be certain
/// is recorded whole (record.cpp).
enum class Over { Doubles, Lanes, FloatLanes, DoubleDoubles };

/// A claim: computed and exact value differ by at most constant factor unit (product of maxima) + kTiny.
struct Claim {
  std::string_view constant;  ///< its name in bounds.h
  std::string_view instance;  ///< distinguishes claims about the same constant
  double value;
  double factor;
  std::vector<Maximum> maxima;
  std::vector<Over> over = {};

  /// Returns whether the proof must treat squares as products of different numbers. If a maximum bounds inputs of two
  /// groups, scaling the maxima to 1 leaves one group smaller than 1: one factor of `edge` is scaled by m_e, the other
  /// by the larger maximum, and both are at most 1.
  [[nodiscard]] bool squares_are_products() const {
    return std::find(maxima.begin(), maxima.end(), Maximum::BallOrEdge) != maxima.end();
  }
};

/// A claim about double-doubles of magnitude at most 1: computed and exact value differ by at most constant
/// kDoubleDoubleUnit. The proof is for `proved` u^2, u = 2^-53, which is at most that; it fails for one u^2 less.
struct SumOfProducts {
  std::string_view constant, instance;
  double value, proved;
};

/// Calls visit(SumOfProducts, expression) for each such claim. expression(a, b) is its value over Vector3s of any
/// number type: for double-doubles the function of double_double.h, for other types that of vector3.h.
template <class Visit>
void for_each_sum_of_products(Visit visit) {
  using bounds::kDot, bounds::kCross;
  visit(SumOfProducts{"kDot", "", kDot, 64}, [](const auto& a, const auto& b) { return dot(a, b); });
  visit(SumOfProducts{"kCross", "x", kCross, 31}, [](const auto& a, const auto& b) { return cross(a, b).x; });
  visit(SumOfProducts{"kCross", "y", kCross, 31}, [](const auto& a, const auto& b) { return cross(a, b).y; });
  visit(SumOfProducts{"kCross", "z", kCross, 31}, [](const auto& a, const auto& b) { return cross(a, b).z; });
}

/// A claim about a quotient, a reciprocal or a root of double-doubles: its relative error is at most constant
/// kDoubleDoubleUnit. The proof is for `proved` u^2, which is at most that; it fails for one u^2 less.
struct Quotient {
  std::string_view constant, instance;
  double value, proved;
};

/// Calls visit(Quotient, expression) for each such claim. expression(a, b) is its value over double-doubles.
template <class Visit>
void for_each_quotient(Visit visit) {
  using bounds::kQuotient;
  visit(Quotient{"kQuotient", "/", kQuotient, 11}, [](const auto& a, const auto& b) { return a / b; });
  visit(Quotient{"kQuotient", "reciprocal", kQuotient, 13}, [](const auto&, const auto& b) { return reciprocal(b); });
  visit(Quotient{"kQuotient", "sqrt", kQuotient, 5}, [](const auto& a, const auto&) { return sqrt(a); });
}

/// Calls visit(Claim, expression) for each claim. expression(Inputs<Number>) is its value over any number type.
template <class Visit>
void for_each_claim(Visit visit) {
  using namespace bounds;
  using enum Maximum;
  visit(Claim{"kVertex", "", kVertex, 1, {Ball, Ball}},
        [](const auto& in) { return signs::vertex(in.to_center, in.radius); });
  visit(Claim{"kAlong", "", kAlong, 1, {Ball, Edge}},
        [](const auto& in) { return signs::along(in.to_center, in.edge); });
  visit(Claim{"kBeyond", "", kBeyond, 1, {BallOrEdge, Edge}},
        [](const auto& in) { return signs::beyond(in.to_center, in.edge); });
  visit(Claim{"kLine", "", kLine, 1, {Ball, Ball, Edge, Edge}},
        [](const auto& in) { return signs::line(in.to_center, in.edge, in.radius); });
  visit(Claim{"kNormal", "x", kNormal, 2, {FirstEdge, SecondEdge}, {Over::DoubleDoubles}},
        [](const auto& in) { return signs::normal(in.first_edge, in.second_edge).x; });
  visit(Claim{"kNormal", "y", kNormal, 2, {FirstEdge, SecondEdge}, {Over::DoubleDoubles}},
        [](const auto& in) { return signs::normal(in.first_edge, in.second_edge).y; });
  visit(Claim{"kNormal", "z", kNormal, 2, {FirstEdge, SecondEdge}, {Over::DoubleDoubles}},
        [](const auto& in) { return signs::normal(in.first_edge, in.second_edge).z; });
  visit(Claim{"kFront", "", kFront, 1, {Normal, Ball}},
        [](const auto& in) { return signs::front(in.normal, in.to_center); });
  visit(Claim{"kPlane", "", kPlane, 1, {Normal, Normal, Ball, Ball}},
        [](const auto& in) { return signs::plane(in.normal, in.to_center, in.radius); });
  visit(Claim{"kSide", "", kSide, 1, {Normal, Edge, Ball}},
        [](const auto& in) { return signs::side(in.normal, in.edge, in.to_center); });
  visit(Claim{"kAbove", "x", kAbove, 1, {Normal, Normal, Ball}},
        [](const auto& in) { return signs::above(in.normal, in.to_center, in.normal.x, in.to_center.x); });
  visit(Claim{"kAbove", "y", kAbove, 1, {Normal, Normal, Ball}},
        [](const auto& in) { return signs::above(in.normal, in.to_center, in.normal.y, in.to_center.y); });
  visit(Claim{"kAbove", "z", kAbove, 1, {Normal, Normal, Ball}},
        [](const auto& in) { return signs::above(in.normal, in.to_center, in.normal.z, in.to_center.z); });
  visit(Claim{"kLineAhead", "", kLineAhead, 1, {Ball, Ball, Edge, Edge}},
        [](const auto& in) { return signs::line_ahead(in.to_center, in.ahead, in.edge, in.radius); });
  visit(Claim{"kApart", "", kApart, 1, {Ball, Edge, Velocity}},
        [](const auto& in) { return signs::apart(in.to_center, in.edge, in.velocity); });
  visit(Claim{"kLines", "", kLines, 1, {Ball, Ball, Edge, Edge, Velocity, Velocity}},
        [](const auto& in) { return signs::lines(in.to_center, in.edge, in.velocity, in.radius); });
  visit(Claim{"kOnEdge", "", kOnEdge, 1, {Ball, Edge, Velocity, Velocity}},
        [](const auto& in) { return signs::on_edge(in.to_center, in.edge, in.velocity); });
  visit(Claim{"kOnWay", "", kOnWay, 1, {Ball, Edge, Edge, Velocity}},
        [](const auto& in) { return signs::on_way(in.to_center, in.edge, in.velocity); });
  visit(Claim{"kCoordinate", "", kCoordinate, 1, {One, Centre}, {Over::Doubles, Over::Lanes}},
        [](const auto& in) { return frame::coordinate(in.axis, in.from_origin); });
  visit(Claim{"kEdgeFrame", "along", kEdgeFrame, 1, {Foot, One}, {Over::Lanes}}, [](const auto& in) {
    return frame::along(in.foot_x, in.foot_y, in.start_x, in.start_y, in.direction_x, in.direction_y);
  });
  visit(Claim{"kEdgeFrame", "across", kEdgeFrame, 1, {Foot, One}, {Over::Lanes}}, [](const auto& in) {
    return frame::across(in.foot_x, in.foot_y, in.start_x, in.start_y, in.direction_x, in.direction_y);
  });
  visit(Claim{"kRoundedDot", "", kRoundedDot, 1, {One, One}, {Over::Lanes}},
        [](const auto& in) { return dot(in.first_exact, in.second_exact); });
  visit(Claim{"kRoundedCross", "x", kRoundedCross, 1, {One, One}, {Over::Lanes}},
        [](const auto& in) { return cross(in.first_exact, in.second_exact).x; });
  visit(Claim{"kLanePoint", "", kLanePoint, 1, {One, Foot}, {Over::FloatLanes}}, [](const auto& in) {
    return lane::coordinate(in.first_weight, in.second_weight, in.lane_vertex.x, in.lane_edge.x, in.lane_edge.y);
  });
  visit(Claim{"kLaneProduct", "", kLaneProduct, 1, {One, Foot}, {Over::FloatLanes}},
        [](const auto& in) { return lane::product(in.first_exact, in.lane_vertex); });
}

}  // namespace touchstone::proofs
