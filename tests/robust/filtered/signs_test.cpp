// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that decide, stage by stage, against rationals on the cases of the soak: what a stage is sure of is right,
// and every number lies within the bound that bounds.h gives for it.
#include "robust/filtered/detail/signs/signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/random.h"
#include "robust/filtered/detail/numbers/permanent.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/filtered/exact_number.h"
#include "tests/robust/support/hard_cases.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using filtered::detail::DoubleDouble;
using filtered::detail::Vector3;
namespace bounds = filtered::detail::bounds;
namespace signs = filtered::detail::signs;

constexpr std::array kNames{"vertex", "along", "beyond",  "line",    "front",
                            "plane",  "side",  "above x", "above y", "above z"};

/// tell(i, value) for each sign, in the order of kNames.
template <class From, class Edge, class Normal, class Radius, class Tell>
void for_each_sign(const Vector3<From>& from, const Vector3<Edge>& edge, const Vector3<Normal>& normal,
                   const Radius& radius, const Tell& tell) {
  tell(0, signs::vertex(from, radius));
  tell(1, signs::along(from, edge));
  tell(2, signs::beyond(from, edge));
  tell(3, signs::line(from, edge, radius));
  tell(4, signs::front(normal, from));
  tell(5, signs::plane(normal, from, radius));
  tell(6, signs::side(normal, edge, from));
  for (int k = 0; k < 3; ++k) tell(static_cast<std::size_t>(7 + k), signs::above(normal, from, normal[k], from[k]));
}

/// A ball and a triangle's edge, and the other edge that makes the normal, over one number type; `difference` gives
/// the exact or rounded difference of two doubles in it.
template <class Difference, class Number, class Tell>
void for_each_sign(const Ball& ball, const Triangle& t, const Difference& difference, const Number& number,
                   const Tell& tell) {
  const auto vector = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return Vector3{difference(p.x(), q.x()), difference(p.y(), q.y()), difference(p.z(), q.z())};
  };
  const auto from = vector(ball.center, t.a), edge = vector(t.b, t.a), other = vector(t.c, t.a);
  for_each_sign(from, edge, signs::normal(edge, other), number(ball.radius), tell);
}

using Exact = std::array<mpq_class, kNames.size()>;

Exact exact_signs(const Ball& ball, const Triangle& triangle) {
  Exact result;
  for_each_sign(
      ball, triangle, [](double p, double q) { return Rational{exactly(p) - exactly(q)}; },
      [](double r) { return Rational{exactly(r)}; },
      [&](std::size_t i, const Rational& value) { result[i] = value.value; });
  return result;
}

double largest(const Eigen::Vector3d& v) { return v.cwiseAbs().maxCoeff(); }

/// The maxima that bounds.h speaks of, as products, for each sign.
struct Maxima {
  Maxima(const Ball& ball, const Triangle& t) {
    const Eigen::Vector3d from = ball.center - t.a, edge = t.b - t.a, other = t.c - t.a;
    const double m_w = std::max(largest(from), ball.radius), m_e = largest(edge), m_n = 2 * m_e * largest(other);
    const double above = bounds::kAbove * m_n * m_n * m_w;
    const double products[] = {bounds::kVertex * m_w * m_w,
                               bounds::kAlong * m_w * m_e,
                               bounds::kBeyond * m_e * std::max(m_w, m_e),
                               bounds::kLine * m_w * m_w * m_e * m_e,
                               bounds::kFront * m_n * m_w,
                               bounds::kPlane * m_n * m_n * m_w * m_w,
                               bounds::kSide * m_n * m_e * m_w,
                               above,
                               above,
                               above};
    std::copy(std::begin(products), std::end(products), times_constants.begin());
    within_limits = std::max({m_w, m_e, m_n, largest(ball.center), largest(t.a)}) <= bounds::kLargest;
  }

  /// The proved bound for arithmetic of this unit.
  [[nodiscard]] double bound(std::size_t sign, double unit) const {
    return times_constants[sign] * unit + bounds::kTiny;
  }

  std::array<double, kNames.size()> times_constants{};
  bool within_limits;
};

struct Drawn {
  std::string id;
  Ball ball;
  Triangle triangle;
};

/// Calls ask for triangles of all families of the soak, each in three orders of its vertices.
template <class Ask>
void for_each_triangle(std::uint64_t count, const Ask& ask) {
  for (std::uint64_t index = 0; index < count; ++index) {
    if (index % 10 == 9) continue;
    const workloads::adversarial::Case c = workloads::adversarial::draw_case(26, index);
    const auto [a, b, d] = *c.triangle();
    const std::string id = "soak --seed 26 --from " + std::to_string(index) + " --samples 1";
    for (const Triangle& order : {Triangle{a, b, d}, {b, d, a}, {d, b, a}}) ask(Drawn{id, c.ball, order});
  }
}

constexpr std::uint64_t kTriangles = 300 * TOUCHSTONE_SAMPLES;

// Doubles to nearest are one case of the model that kUnit stands for.
TEST(Signs, InDoublesLieWithinTheirBounds) {
  for_each_triangle(kTriangles, [](const Drawn& drawn) {
    const Maxima maxima(drawn.ball, drawn.triangle);
    if (!maxima.within_limits) return;
    const Exact exact = exact_signs(drawn.ball, drawn.triangle);
    for_each_sign(
        drawn.ball, drawn.triangle, [](double p, double q) { return p - q; }, [](double r) { return r; },
        [&](std::size_t i, double value) {
          const double bound = maxima.bound(i, bounds::kUnit);
          EXPECT_LE(abs(exactly(value) - exact[i]), exactly(bound)) << kNames[i] << " of " << drawn.id;
          if (std::abs(value) > bound) {
            EXPECT_EQ(value > 0 ? 1 : -1, sgn(exact[i])) << kNames[i] << " of " << drawn.id;
          }
        });
  });
}

TEST(Signs, OfPermanentsAreRightWhereSure) {
  std::array<std::uint64_t, kNames.size()> sure{}, zero{};
  for_each_triangle(kTriangles, [&](const Drawn& drawn) {
    if (!Maxima(drawn.ball, drawn.triangle).within_limits) return;
    const Exact exact = exact_signs(drawn.ball, drawn.triangle);
    for_each_sign(
        drawn.ball, drawn.triangle, [](double p, double q) { return filtered::detail::rounded_double(p - q); },
        [](double r) { return filtered::detail::exact_double(r); },
        [&]<int Roundings>(std::size_t i, const filtered::detail::Permanent<Roundings>& value) {
          const int found = certain_sign(value, bounds::kTiny);
          const mpq_class bound = (Roundings + mpq_class(1, 8)) * exactly(0x1p-53) * exactly(value.permanent);
          EXPECT_LE(abs(exactly(value.value) - exact[i]), bound + exactly(bounds::kTiny))
              << kNames[i] << " of " << drawn.id;
          if (found != 0) {
            EXPECT_EQ(found, sgn(exact[i])) << kNames[i] << " of " << drawn.id;
          }
          sure[i] += found != 0 ? 1 : 0;
          zero[i] += found == 0 ? 1 : 0;
        });
  });
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_GT(sure[i], 0U) << kNames[i] << " is never decided";
    EXPECT_GT(zero[i], 0U) << kNames[i] << " is never hard";
  }
}

TEST(Signs, InDoubleDoublesLieWithinTheirBounds) {
  std::array<std::uint64_t, kNames.size()> sure{}, zero{};
  for_each_triangle(kTriangles, [&](const Drawn& drawn) {
    const Maxima maxima(drawn.ball, drawn.triangle);
    if (!maxima.within_limits) return;
    const Exact exact = exact_signs(drawn.ball, drawn.triangle);
    for_each_sign(
        drawn.ball, drawn.triangle, filtered::detail::two_difference<double>, [](double r) { return DoubleDouble(r); },
        [&](std::size_t i, const DoubleDouble& value) {
          const double bound = maxima.bound(i, bounds::kDoubleDoubleUnit);
          EXPECT_LE(abs(exactly(value) - exact[i]), exactly(bound)) << kNames[i] << " of " << drawn.id;
          const bool decided = std::abs(value.high) > bound;
          if (decided) {
            EXPECT_EQ(sign(value), sgn(exact[i])) << kNames[i] << " of " << drawn.id;
          }
          (decided ? sure : zero)[i] += 1;
        });
  });
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_GT(sure[i], 0U) << kNames[i] << " is never decided";
    EXPECT_GT(zero[i], 0U) << kNames[i] << " is never hard";
  }
}

/// Extreme or random, of magnitude below 2^bits.
mpz_class coordinate(workloads::Random& random, int bits) {
  const mpz_class limit = mpz_class(1) << static_cast<unsigned>(bits);
  const std::int64_t small = random.integer(-2, 2);
  switch (random.integer(0, 3)) {
    case 0: return limit - 1;
    case 1: return 1 - limit;
    case 2: return small;
    default: break;
  }
  const mpz_class magnitude = mpz_class(std::to_string(random.bits())) % limit;
  return random.coin() ? magnitude : mpz_class(-magnitude);
}

/// Integer<Bits> coordinates through every sign, against the same in rationals.
template <int Bits>
void expect_exact_signs(std::uint64_t index) {
  workloads::Random random(27, index, Bits);
  const auto point = [&] {
    std::array<mpz_class, 3> p;
    for (mpz_class& x : p) x = coordinate(random, Bits);
    return p;
  };
  const auto c = point(), a = random.integer(0, 3) == 0 ? c : point(), b = point(), d = point();
  const mpz_class r =
      abs(random.integer(0, 2) == 0 ? mpz_class(c[0] - a[0]) % (mpz_class(1) << Bits) : coordinate(random, Bits));

  const auto integer_vector = [](const auto& p, const auto& q) {
    return Vector3{integer<Bits>(p[0]) - integer<Bits>(q[0]), integer<Bits>(p[1]) - integer<Bits>(q[1]),
                   integer<Bits>(p[2]) - integer<Bits>(q[2])};
  };
  const auto rational_vector = [](const auto& p, const auto& q) {
    return Vector3{Rational{mpq_class(p[0] - q[0])}, Rational{mpq_class(p[1] - q[1])},
                   Rational{mpq_class(p[2] - q[2])}};
  };
  Exact exact;
  const auto exact_edge = rational_vector(b, a);
  for_each_sign(rational_vector(c, a), exact_edge, signs::normal(exact_edge, rational_vector(d, a)), Rational{r},
                [&](std::size_t i, const Rational& value) { exact[i] = value.value; });
  const auto edge = integer_vector(b, a);
  for_each_sign(integer_vector(c, a), edge, signs::normal(edge, integer_vector(d, a)), integer<Bits>(r),
                [&](std::size_t i, const auto& value) {
                  EXPECT_EQ(mpq_class(exactly(value)), exact[i])
                      << kNames[i] << ", " << Bits << " bits, index " << index;
                  EXPECT_EQ(value.sign(), sgn(exact[i])) << kNames[i] << ", " << Bits << " bits, index " << index;
                });
}

TEST(Signs, InIntegersAreExact) {
  for (std::uint64_t index = 0; index < 50 * TOUCHSTONE_SAMPLES; ++index) {
    expect_exact_signs<20>(index);
    expect_exact_signs<21>(index);
    expect_exact_signs<26>(index);
    expect_exact_signs<31>(index);
    expect_exact_signs<32>(index);
    expect_exact_signs<53>(index);
    expect_exact_signs<62>(index);
    expect_exact_signs<64>(index);
    expect_exact_signs<120>(index);
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests
