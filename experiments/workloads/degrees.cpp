// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/degrees.h"

#include <mpfr.h>

namespace touchstone::workloads {
namespace {

constexpr unsigned long kTurn = 360;

/// Applies `f`, a correctly rounded function of MPFR, in place to a number of 53 bits that starts as `value`.
template <class F>
double rounded(double value, const F& f) {
  mpfr_t number;
  mpfr_init2(number, 53);
  mpfr_set_d(number, value, MPFR_RNDN);
  f(number);
  const double result = mpfr_get_d(number, MPFR_RNDN);
  mpfr_clear(number);
  return result == 0 ? 0.0 : result;  // no -0
}

/// A function of angles, or to angles, in units of which a turn has kTurn.
double of_turn(int (*function)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t), double value) {
  return rounded(value, [&](mpfr_ptr x) { function(x, x, kTurn, MPFR_RNDN); });
}

}  // namespace

double sine(double degrees) { return of_turn(mpfr_sinu, degrees); }
double cosine(double degrees) { return of_turn(mpfr_cosu, degrees); }
double arc_sine(double value) { return of_turn(mpfr_asinu, value); }
double arc_cosine(double value) { return of_turn(mpfr_acosu, value); }

double arc_tangent(double y, double x) {
  return rounded(y, [&](mpfr_ptr result) {
    mpfr_t abscissa;
    mpfr_init2(abscissa, 53);
    mpfr_set_d(abscissa, x, MPFR_RNDN);
    mpfr_atan2u(result, result, abscissa, kTurn, MPFR_RNDN);
    mpfr_clear(abscissa);
  });
}

}  // namespace touchstone::workloads
