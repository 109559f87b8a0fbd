// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/proofs/expressions.h"
#include "tests/robust/proofs/toy.h"

namespace touchstone::proofs {

using Exact = std::int64_t;

/// The numbers of a sample: integers with more bits than a toy number has, so that they have to be rounded, but so few
/// bits that every expression fits into 64.
using Operands = std::array<Exact, 29>;
inline constexpr Exact kLargestOperand = 511;

/// Many operands are a little above a power of two, where the steps between toy numbers are relatively largest.
inline Exact draw_operand(workloads::Random& random) {
  const Exact magnitude = random.coin() ? random.integer(256, 320) : random.integer(0, kLargestOperand);
  return random.coin() ? magnitude : -magnitude;
}

inline Operands draw_operands(workloads::Random& random) {
  Operands operands;
  for (Exact& operand : operands) operand = draw_operand(random);
  return operands;
}

/// Exact inputs of every expression, their computed counterparts and the maxima of these.
struct ToySample {
  Inputs<Exact> exact;
  Inputs<Toy> computed;
  std::array<double, kMaxima> maxima;

  [[nodiscard]] double product(const std::vector<Maximum>& of) const {
    double result = 1;
    for (const Maximum maximum : of) result *= maxima[static_cast<std::size_t>(maximum)];
    return result;
  }
};

inline Vector3<Toy> computed(const Vector3<Exact>& exact) {
  return {Toy::of(exact.x), Toy::of(exact.y), Toy::of(exact.z)};
}

inline double largest_magnitude(std::initializer_list<Toy> numbers) {
  Exact result = 0;
  for (const Toy& number : numbers) result = std::max(result, std::abs(number.value));
  return static_cast<double>(result);
}
inline double largest_magnitude(const Vector3<Toy>& vector) {
  return largest_magnitude({vector.x, vector.y, vector.z});
}

/// The exact inputs that operands stand for. The radius is known exactly; starts lie within twice the polygon's size,
/// as far out as feet do.
inline Inputs<Exact> exact_inputs(const Operands& operands) {
  std::size_t next = 0;
  Inputs<Exact> exact{};
  for (auto vector :
       {&Inputs<Exact>::to_center, &Inputs<Exact>::ahead, &Inputs<Exact>::edge, &Inputs<Exact>::velocity,
        &Inputs<Exact>::first_edge, &Inputs<Exact>::second_edge, &Inputs<Exact>::axis, &Inputs<Exact>::from_origin}) {
    exact.*vector = {operands[next], operands[next + 1], operands[next + 2]};
    next += 3;
  }
  exact.radius = Toy::of(operands[next++]).value;
  exact.normal = signs::normal(exact.first_edge, exact.second_edge);
  const Vector3<Exact> other_axis{exact.axis.y, exact.axis.z, exact.axis.x};
  exact.foot_x = frame::coordinate(exact.axis, exact.from_origin);
  exact.foot_y = frame::coordinate(other_axis, exact.from_origin);
  exact.start_x = operands[next++] * kLargestOperand * 2;
  exact.start_y = operands[next++] * kLargestOperand * 2;
  exact.direction_x = operands[next++];
  exact.direction_y = operands[next++];
  const auto rounded = [](Exact value) { return Toy::of(value).value; };
  exact.first_exact = {rounded(exact.axis.x), rounded(exact.axis.y), rounded(exact.axis.z)};
  exact.second_exact = {rounded(exact.direction_x), rounded(exact.direction_y), rounded(exact.axis.x)};
  exact.lane_vertex = {exact.start_x, exact.start_y, exact.start_x};
  exact.lane_edge = {rounded(exact.start_y), rounded(exact.foot_x), rounded(exact.foot_y)};
  exact.first_weight = exact.first_exact.x;
  exact.second_weight = exact.first_exact.y;
  return exact;
}

/// Inputs as the filters have them: differences rounded, the normal and the foot computed.
inline ToySample sample_of(const Inputs<Exact>& exact) {
  ToySample sample{exact, {}, {}};
  Inputs<Toy>& c = sample.computed;
  c.to_center = computed(exact.to_center);
  c.ahead = computed(exact.ahead);
  c.edge = computed(exact.edge);
  c.velocity = computed(exact.velocity);
  c.radius = Toy::of(exact.radius);
  c.first_edge = computed(exact.first_edge);
  c.second_edge = computed(exact.second_edge);
  c.normal = signs::normal(c.first_edge, c.second_edge);
  c.axis = computed(exact.axis);
  c.from_origin = computed(exact.from_origin);
  c.foot_x = frame::coordinate(c.axis, c.from_origin);
  c.foot_y = frame::coordinate(Vector3{c.axis.y, c.axis.z, c.axis.x}, c.from_origin);
  c.start_x = Toy::of(exact.start_x);
  c.start_y = Toy::of(exact.start_y);
  c.direction_x = Toy::of(exact.direction_x);
  c.direction_y = Toy::of(exact.direction_y);
  c.first_exact = computed(exact.first_exact);
  c.second_exact = computed(exact.second_exact);
  c.lane_vertex = {c.start_x, c.start_y, c.start_x};
  c.lane_edge = computed(exact.lane_edge);
  c.first_weight = c.first_exact.x;
  c.second_weight = c.first_exact.y;

  const auto set = [&](Maximum maximum, double value) { sample.maxima[static_cast<std::size_t>(maximum)] = value; };
  using enum Maximum;
  const double first = largest_magnitude(c.first_edge), second = largest_magnitude(c.second_edge);
  const double one = std::max(largest_magnitude(c.axis), largest_magnitude({c.direction_x, c.direction_y}));
  const double centre = largest_magnitude(c.from_origin);
  set(Ball, std::max({largest_magnitude(c.to_center), largest_magnitude(c.ahead), largest_magnitude({c.radius})}));
  set(Edge, largest_magnitude(c.edge));
  set(BallOrEdge, std::max(largest_magnitude(c.to_center), largest_magnitude(c.edge)));
  set(Velocity, largest_magnitude(c.velocity));
  set(FirstEdge, first);
  set(SecondEdge, second);
  set(Normal, 2 * first * second);
  set(One, one);
  set(Centre, centre);
  set(Foot, std::max(one * centre, std::max(largest_magnitude(c.lane_edge),
                                            largest_magnitude({c.foot_x, c.foot_y, c.start_x, c.start_y}))));
  return sample;
}

}  // namespace touchstone::proofs
