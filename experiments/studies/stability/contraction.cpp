// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/contraction.h"

#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/studies/stability/rational.h"
#include "robust/filtered/detail/signs/signs.h"

namespace touchstone::stability {
namespace {

using filtered::detail::Vector3;
using workloads::Random;
namespace signs = filtered::detail::signs;

/// A double that remembers whether it is a product: a sum with a product is one fused multiply-add, as a compiler that
/// contracts makes it, with the product on the right where both are.
struct Fused {
  double value;
  bool product = false;
  double left = 0, right = 0;

  friend Fused operator*(const Fused& a, const Fused& b) { return {a.value * b.value, true, a.value, b.value}; }
  friend Fused operator+(const Fused& a, const Fused& b) {
    if (b.product) return {std::fma(b.left, b.right, a.value)};
    if (a.product) return {std::fma(a.left, a.right, b.value)};
    return {a.value + b.value};
  }
  friend Fused operator-(const Fused& a, const Fused& b) {
    if (b.product) return {std::fma(-b.left, b.right, a.value)};
    if (a.product) return {std::fma(a.left, a.right, -b.value)};
    return {a.value - b.value};
  }
};

int sign_of(double value) { return (value > 0) - (value < 0); }
int sign_of(const Fused& value) { return sign_of(value.value); }
int sign_of(const Rational& value) { return sgn(value.value); }

/// The differences that an expression is about, as the doubles that they are.
struct Operands {
  Eigen::Vector3d from, edge, normal;
  double radius;
};

/// The sign of expression(from, edge, normal, radius) over a number type.
template <class Number, class Expression>
int sign_over(const Operands& operands, const Expression& expression) {
  const auto vector = [](const Eigen::Vector3d& v) { return Vector3<Number>{{v.x()}, {v.y()}, {v.z()}}; };
  return sign_of(
      expression(vector(operands.from), vector(operands.edge), vector(operands.normal), Number{operands.radius}));
}

template <class Expression>
void count(const Operands& operands, const Expression& expression, ContractionCount& counts) {
  const auto number = [&](auto zero) { return sign_over<decltype(zero)>(operands, expression); };
  const int plain = number(double{}), fused = number(Fused{0}), exact = number(Rational{});
  ++counts.trials;
  counts.plain_wrong += plain != exact ? 1 : 0;
  counts.fused_wrong += fused != exact ? 1 : 0;
  counts.differ += plain != fused ? 1 : 0;
}

constexpr auto kOrientation = [](const auto& from, const auto& edge, const auto&, const auto&) {
  return edge.x * from.y - edge.y * from.x;
};
constexpr auto kSide = [](const auto& from, const auto& edge, const auto& normal, const auto&) {
  return signs::side(normal, edge, from);
};
constexpr auto kLine = [](const auto& from, const auto& edge, const auto&, const auto& radius) {
  return signs::line(from, edge, radius);
};
constexpr auto kPlane = [](const auto& from, const auto&, const auto& normal, const auto& radius) {
  return signs::plane(normal, from, radius);
};

Eigen::Vector3d all_bits(Random& random) {
  const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
  return {x, y, 2 * random.unit() - 1};
}

Operands collinear(Random& random) {
  const Eigen::Vector3d edge = all_bits(random);
  const Eigen::Vector3d from = std::ldexp(1.0, static_cast<int>(random.integer(-3, 3))) * edge;
  return {from, edge, all_bits(random), 1};
}

/// Differences of integers below 2^21, and a normal of integers below 2^44: all exact.
Operands touching(Random& random) {
  const auto [ball, t] = workloads::draw_lattice_tangent(random);
  const Eigen::Vector3d u = t.b - t.a, v = t.c - t.a;
  return {ball.center - t.a,
          u,
          {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()},
          ball.radius};
}

}  // namespace

std::vector<ContractionCount> count_contractions(std::uint64_t trials, std::uint64_t seed) {
  constexpr std::string_view zero = "exactly zero", beside = "one double beside";
  std::vector<ContractionCount> counts{{"orientation", zero}, {"orientation", beside}, {"side", zero},
                                       {"side", beside},      {"line", zero},          {"line", beside},
                                       {"plane", zero},       {"plane", beside}};
  constexpr std::uint64_t kStream = std::uint64_t{1} << 52;
  for (std::uint64_t i = 0; i < trials; ++i) {
    Random random(seed, i, kStream);
    Operands operands = collinear(random);
    count(operands, kOrientation, counts[0]);
    count(operands, kSide, counts[2]);
    double& moved = operands.from[static_cast<int>(random.integer(0, 1))];
    moved = workloads::move_by_doubles(moved, random.coin() ? 1 : -1);
    count(operands, kOrientation, counts[1]);
    count(operands, kSide, counts[3]);
  }
  const auto touching_count = [&](std::uint64_t stream, const auto& expression, ContractionCount& at,
                                  ContractionCount& next_to) {
    for (std::uint64_t i = 0; at.trials < trials; ++i) {
      Random random(seed, i, kStream + stream);
      Operands operands = touching(random);
      if (sign_over<Rational>(operands, expression) != 0) continue;  // another feature is touched
      count(operands, expression, at);
      operands.radius = workloads::move_by_doubles(operands.radius, random.coin() ? 1 : -1);
      count(operands, expression, next_to);
    }
  };
  touching_count(1, kLine, counts[4], counts[5]);
  touching_count(2, kPlane, counts[6], counts[7]);
  return counts;
}

}  // namespace touchstone::stability
