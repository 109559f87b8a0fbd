// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/chart.h"

#include <mpfr.h>

#include <algorithm>

#include "experiments/cases/workloads/degrees.h"

namespace touchstone::kinematics {
namespace {

int order(const Dyadic& a, const Dyadic& b) {
  const unsigned shift = std::max(a.shift, b.shift);
  return cmp(mpz_class(a.numerator << (shift - a.shift)), mpz_class(b.numerator << (shift - b.shift)));
}

}  // namespace

std::vector<IntegerVector> whole(const std::vector<Vector<mpq_class>>& vectors) {
  mp_bitcnt_t bits = 0;
  for (const auto& v : vectors)
    for (const mpq_class& x : v) bits = std::max<mp_bitcnt_t>(bits, mpz_sizeinbase(x.get_den_mpz_t(), 2) - 1);
  std::vector<IntegerVector> result;
  for (const auto& v : vectors) {
    IntegerVector& integers = result.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) integers[axis] = mpq_class(v[axis] << bits).get_num();
  }
  return result;
}

Charts::Charts(const Eigen::Vector3d& axis)
    : axis_(whole({{mpq_class(axis.x()), mpq_class(axis.y()), mpq_class(axis.z())}}).front()) {
  squared_length_ = dot(axis_, axis_);
  exponent_ = static_cast<unsigned>(mpz_sizeinbase(squared_length_.get_mpz_t(), 2) / 2);
}

Charts::Chart Charts::chart(int number) const {
  const mpz_class one = 1, k = one << exponent_;
  const auto line = [](const mpz_class& a, const mpz_class& b) { return Polynomial({a, b}); };
  switch (number) {
    case 0: return {line(k, 0), line(0, 1), {1, 0}};
    case 1: return {line(k, mpz_class(-k)), line(1, 0), {2, 0}};
    default: return {line(mpz_class(-k), 0), line(1, -1), {1, 0}};
  }
}

// Chart 0: phi = 2 atan(|axis| w / 2^k). Chart 1: 180 - 2 atan(2^k (1 - w) / |axis|). Chart 2:
// 360 - 2 atan(|axis| (1 - w) / 2^k). Every step is rounded so that the angle moves to the side asked for.
template <class F>
void Charts::with_angle(int chart, const Dyadic& w, Towards side, long bits, const F& f) const {
  const bool low = side == Towards::Low;
  const mpfr_rnd_t out = low ? MPFR_RNDD : MPFR_RNDU;
  const mpfr_rnd_t inner = chart == 0 ? out : low ? MPFR_RNDU : MPFR_RNDD;  // of what is subtracted
  mpz_class part = w.numerator;
  if (chart != 0) part = (mpz_class(1) << w.shift) - part;
  workloads::free_mpfr_at_thread_end();
  mpfr_t length, angle;
  mpfr_init2(length, bits);
  mpfr_init2(angle, bits);
  // The length's rounding: a factor in charts 0 and 2, where part >= 0; a divisor in chart 1.
  const bool up = inner == MPFR_RNDU, longer = chart == 1 ? (sgn(part) >= 0) != up : up;
  mpfr_set_z(length, squared_length_.get_mpz_t(), longer ? MPFR_RNDU : MPFR_RNDD);
  mpfr_sqrt(length, length, longer ? MPFR_RNDU : MPFR_RNDD);
  mpfr_set_z(angle, part.get_mpz_t(), inner);
  mpfr_div_2ui(angle, angle, w.shift, inner);
  if (chart == 1) {
    mpfr_mul_2ui(angle, angle, exponent_, inner);
    mpfr_div(angle, angle, length, inner);
  } else {
    mpfr_mul(angle, angle, length, inner);
    mpfr_div_2ui(angle, angle, exponent_, inner);
  }
  mpfr_atanu(angle, angle, 360, inner);
  mpfr_mul_ui(angle, angle, 2, inner);
  if (chart != 0) mpfr_ui_sub(angle, chart == 1 ? 180 : 360, angle, out);
  f(angle);
  mpfr_clear(length);
  mpfr_clear(angle);
}

double Charts::degrees(int chart, const Dyadic& w, Towards side) const {
  double result = 0;
  with_angle(chart, w, side, 96,
             [&](mpfr_srcptr angle) { result = mpfr_get_d(angle, side == Towards::Low ? MPFR_RNDD : MPFR_RNDU); });
  return result;
}

bool Charts::degrees_exceed(int chart, const Dyadic& w, double degrees, long bits) const {
  bool exceed = false;
  with_angle(chart, w, Towards::Low, bits, [&](mpfr_srcptr angle) { exceed = mpfr_cmp_d(angle, degrees) > 0; });
  return exceed;
}

double Charts::begin(int number) const {
  return number == 0 ? 0 : number == kCount ? 360 : degrees(number, {0, 0}, Towards::Low);
}

int compare(Moment& a, Moment& b) {
  if (a.chart != b.chart) return a.chart < b.chart ? -1 : 1;
  for (const unsigned bits : {8U, 30U, 60U, 120U}) {
    a.root.refine(bits), b.root.refine(bits);
    if (order(a.root.high(), b.root.low()) < 0) return -1;
    if (order(b.root.high(), a.root.low()) < 0) return 1;
  }
  return 0;
}

}  // namespace touchstone::kinematics
