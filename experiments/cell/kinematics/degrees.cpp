// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/degrees.h"

#include <mpfr.h>

namespace touchstone::kinematics {
namespace {

/// What `f`, one correctly rounded function of MPFR, leaves in a number of 53 bits.
template <class F>
double rounded(const F& f) {
  mpfr_t number;
  mpfr_init2(number, 53);
  f(number);
  const double result = mpfr_get_d(number, MPFR_RNDN);
  mpfr_clear(number);
  return result == 0 ? 0.0 : result;  // no -0
}

constexpr unsigned long kTurn = 360;

}  // namespace

double sine(double degrees) {
  return rounded([&](mpfr_ptr x) {
    mpfr_set_d(x, degrees, MPFR_RNDN);
    mpfr_sinu(x, x, kTurn, MPFR_RNDN);
  });
}

double cosine(double degrees) {
  return rounded([&](mpfr_ptr x) {
    mpfr_set_d(x, degrees, MPFR_RNDN);
    mpfr_cosu(x, x, kTurn, MPFR_RNDN);
  });
}

double arc_sine(double value) {
  return rounded([&](mpfr_ptr x) {
    mpfr_set_d(x, value, MPFR_RNDN);
    mpfr_asinu(x, x, kTurn, MPFR_RNDN);
  });
}

double arc_cosine(double value) {
  return rounded([&](mpfr_ptr x) {
    mpfr_set_d(x, value, MPFR_RNDN);
    mpfr_acosu(x, x, kTurn, MPFR_RNDN);
  });
}

double arc_tangent(double y, double x) {
  return rounded([&](mpfr_ptr result) {
    mpfr_t abscissa;
    mpfr_init2(abscissa, 53);
    mpfr_set_d(abscissa, x, MPFR_RNDN);
    mpfr_set_d(result, y, MPFR_RNDN);
    mpfr_atan2u(result, result, abscissa, kTurn, MPFR_RNDN);
    mpfr_clear(abscissa);
  });
}

}  // namespace touchstone::kinematics
