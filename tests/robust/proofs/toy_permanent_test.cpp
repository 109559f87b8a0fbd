// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence beside the proof: permanents in toy arithmetic that rounds to nearest, against exact integers.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "tests/robust/proofs/permanent_inputs.h"
#include "tests/robust/proofs/toy.h"
#include "tests/robust/proofs/toy_sample.h"

namespace touchstone::proofs {
namespace {

constexpr std::uint64_t kPermanents = std::uint64_t{300} * TOUCHSTONE_SAMPLES;
constexpr std::uint64_t kPermanentSeed = 2027;

/// (1+u)^roundings - 1, rounded up.
double relative_bound(const mpq_class& u, int roundings) {
  mpq_class power = 1;
  for (int i = 0; i < roundings; ++i) power *= 1 + u;
  return std::nextafter(mpq_class(power - 1).get_d(), std::numeric_limits<double>::infinity());
}

template <class From, class To>
Inputs<To> with_permanents(const Inputs<From>& in, To (*convert)(const From&)) {
  const auto vector = [&](const Vector3<From>& v) { return Vector3<To>{convert(v.x), convert(v.y), convert(v.z)}; };
  return {vector(in.to_center),     vector(in.ahead),         vector(in.edge),         vector(in.velocity),
          convert(in.radius),       vector(in.first_edge),    vector(in.second_edge),  vector(in.normal),
          vector(in.axis),          vector(in.from_origin),   convert(in.foot_x),      convert(in.foot_y),
          convert(in.start_x),      convert(in.start_y),      convert(in.direction_x), convert(in.direction_y),
          vector(in.first_exact),   vector(in.second_exact),  vector(in.lane_vertex),  vector(in.lane_edge),
          convert(in.first_weight), convert(in.second_weight)};
}

WithPermanent<Exact> exact(const Exact& value) { return {value, std::abs(value)}; }

WithPermanent<Toy> toy(const Exact& value) {
  const Toy number = Toy::of(value);
  return {number, {std::abs(number.value)}};
}

/// What Permanent guarantees of each claim's expression, relative to its permanent.
std::vector<double> relative_bounds(int bits) {
  std::vector<double> bounds;
  for_each_claim([&](const Claim&, const auto& expression) {
    bounds.push_back(relative_bound(std::ldexp(1.0, -bits), roundings_of<decltype(expression(PermanentInputs{}))>));
  });
  return bounds;
}

/// The largest share of its bound that an error takes.
double largest_share(int bits) {
  Toy::set_arithmetic(bits, Rounding::Nearest);
  const std::vector<double> bounds = relative_bounds(bits);
  double largest = 0;
  for (std::uint64_t index = 0; index < kPermanents; ++index) {
    workloads::Random random(kPermanentSeed, index);
    const Inputs<Exact> inputs = exact_inputs(draw_operands(random));
    const auto expected = with_permanents(inputs, exact);
    const auto computed = with_permanents(inputs, toy);
    std::size_t i = 0;
    for_each_claim([&](const Claim& claim, const auto& expression) {
      const auto is = expression(computed);
      const auto should_be = expression(expected);
      const double allowed = bounds[i++] * static_cast<double>(should_be.permanent);
      const auto error = static_cast<double>(std::abs(is.value.value - should_be.value));
      ASSERT_LE(error, allowed) << claim.constant << ": " << bits << " bits, sample " << index;
      ASSERT_LE(static_cast<double>(std::abs(is.permanent.value - should_be.permanent)), allowed)
          << claim.constant << ": the permanent, " << bits << " bits, sample " << index;
      if (error > 0) largest = std::max(largest, error / allowed);
    });
  }
  return largest;
}

TEST(ToyPermanent, BoundsErrorsWithoutBeingFarFromThem) {
  double largest = 0;
  for (int bits = 4; bits <= 8; ++bits) largest = std::max(largest, largest_share(bits));
  std::printf("%.3f of the bound\n", largest);
  EXPECT_GT(largest, 0.3);
}

}  // namespace
}  // namespace touchstone::proofs
