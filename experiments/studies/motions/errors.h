// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/methods/selection.h"
#include "experiments/run/distribution.h"
#include "experiments/run/run_control.h"
#include "experiments/studies/motions/threshold.h"

namespace touchstone::motions {

struct Settings {
  std::vector<const cases::Method*> methods;  ///< that answer about moving balls
  std::size_t vertices = 12;
  std::uint64_t samples = 1;  ///< per stratum
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// Returns the selected methods, in this order. The name `all` stands for those that answer about moving balls. Throws
/// std::invalid_argument, which names the method, if another cannot answer about them, or if an engine of the user errs
/// on a ball that moves through a triangle: it then takes balls for balls at rest.
[[nodiscard]] std::vector<const cases::Method*> find_moving_methods(const methods::Selection& selection);

/// Slow methods are asked about the first of every kSlowStride samples only; the others about all.
inline constexpr std::uint64_t kSlowStride = 4;

/// The shares of the polygon's extent by which the radius differs from the threshold, ascending: 0 and 2^-52, 2^-48,
/// ..., 2^-4 to either side.
[[nodiscard]] const std::vector<double>& all_offsets();

/// The answers to whether the ball touches.
struct Tally {
  std::uint64_t missed = 0, invented = 0;  ///< contacts
  std::uint64_t unsure = 0, trials = 0;

  [[nodiscard]] std::uint64_t wrong() const { return missed + invented; }
  auto members() { return std::tie(missed, invented, unsure, trials); }
};

/// Errors of the time of a contact that the method found.
struct TimeErrors {
  std::uint64_t found = 0;        ///< contacts; the method may not tell times
  statistics::Distribution ulps;  ///< in units in the last place of the exact time; of contacts on the way
  statistics::Distribution ways;  ///< the way between both times, as a share of the extent; of all contacts

  auto members() { return std::tie(found, ulps, ways); }
};

/// The wrong answer furthest from its threshold; the earliest of several.
struct Furthest {
  double share = 0;  ///< 0 without one, or if it is at the threshold
  std::uint64_t n = 0;
  std::size_t stratum = 0, offset = 0;
  bool any = false;

  auto members() { return std::tie(share, n, stratum, offset, any); }
  Furthest& operator+=(const Furthest& other);
};

/// The results of one method in one kind of samples.
struct MethodErrors {
  std::array<Tally, 27> offsets;          ///< by all_offsets
  std::uint64_t samples = 0, failed = 0;  ///< with an answer at any offset; with a wrong one
  TimeErrors times;
  Furthest furthest;

  [[nodiscard]] Tally all() const;
  auto members() { return std::tie(offsets, samples, failed, times, furthest); }
};

/// A kind of samples.
struct Kind {
  std::size_t way, event, feature;  ///< of kWays, kEvents and kFeatures
};
[[nodiscard]] const std::vector<Kind>& all_kinds();

/// The results of all methods. Sums do not depend on their order.
struct Errors {
  std::vector<std::vector<MethodErrors>> at;  ///< by all_kinds, then method
  std::uint64_t samples = 0;                  ///< complete samples per stratum: fewer than requested if stopped
  std::uint64_t missing = 0;                  ///< samples, over all strata, without a threshold
  std::uint64_t disagreements = 0;            ///< balls for which `exact` differed from the threshold: a defect

  /// Returns the sum of one method over the kinds that `wanted` selects.
  template <class Wanted>
  [[nodiscard]] MethodErrors sum(std::size_t method, const Wanted& wanted) const;
  auto members() { return std::tie(at, samples, missing, disagreements); }
};

[[nodiscard]] inline std::uint64_t items_done(const Errors& errors) { return errors.samples; }
[[nodiscard]] Errors no_errors(const Settings& settings);

/// Asks every method about the balls of all samples that `errors` does not contain yet; `exact` says what is right.
///
/// The result is a function of the settings and the number of samples done; threads,
/// stops and the other methods do not change it.
void measure_errors(const Settings& settings, const run::RunControl<Errors>& control, Errors& errors);

template <class Wanted>
MethodErrors Errors::sum(std::size_t method, const Wanted& wanted) const {
  MethodErrors sum;
  for (std::size_t kind = 0; kind < at.size(); ++kind)
    if (wanted(all_kinds()[kind])) run::add(sum, at[kind][method]);
  return sum;
}

}  // namespace touchstone::motions
