// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/degrees.h"

#include <mpfr.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace touchstone::workloads {
namespace {

constexpr unsigned long kTurn = 360;

/// Applies `f`, a correctly rounded function of MPFR, in place to a number of 53 bits that starts as `value`.
template <class F>
double rounded(double value, const F& f) {
  free_mpfr_at_thread_end();
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

/// A function of angles that remembers results by the bits of the angle: an arm turns one joint of many in each move,
/// by whole steps.
class Remembering {
 public:
  explicit Remembering(int (*function)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t)) : function_(function) {}

  [[nodiscard]] double operator()(double degrees) {
    const auto bits = std::bit_cast<std::uint64_t>(degrees);
    Entry& entry = entries_[bits * kGolden >> (64 - kIndexBits)];
    if (!entry.is_known || entry.bits != bits) entry = {bits, of_turn(function_, degrees), true};
    return entry.result;
  }

 private:
  static constexpr unsigned kIndexBits = 10;
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio, odd: spreads the bits
  struct Entry {
    std::uint64_t bits = 0;
    double result = 0;
    bool is_known = false;
  };

  int (*function_)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t);
  std::array<Entry, std::size_t{1} << kIndexBits> entries_{};
};

}  // namespace

double sine(double degrees) {
  thread_local Remembering function(mpfr_sinu);
  return function(degrees);
}

double cosine(double degrees) {
  thread_local Remembering function(mpfr_cosu);
  return function(degrees);
}

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

void free_mpfr_at_thread_end() {
  struct Freeing {
    ~Freeing() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
  };
  thread_local const Freeing freeing;
}

}  // namespace touchstone::workloads
