// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "experiments/run/run_control.h"
#include "experiments/studies/tunnelling/passes.h"

namespace touchstone::tunnelling {

struct Settings {
  std::size_t vertices = 12;
  std::uint64_t samples = 1;  ///< passes, each by a ball of every radius
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

/// The contacts of the balls of one radius.
struct Contacts {
  std::uint64_t all = 0;                               ///< by the exact sweep
  std::array<std::uint64_t, kMostLevel + 1> missed{};  ///< by 2^level steps
  std::uint64_t beside = 0;  ///< contacts of a place, rounded to doubles, although the exact way makes none

  auto members() { return std::tie(all, missed, beside); }
  friend bool operator==(const Contacts&, const Contacts&) = default;
};

/// Sums do not depend on their order.
struct Misses {
  std::array<Contacts, kRadii.size()> of;
  std::uint64_t samples = 0, missing = 0;

  auto members() { return std::tie(of, samples, missing); }
  friend bool operator==(const Misses&, const Misses&) = default;
};

[[nodiscard]] inline std::uint64_t items_done(const Misses& misses) { return misses.samples; }

/// Counts the passes that `misses` does not contain yet. In the first process the result is a function of the settings
/// and the number of samples done.
void count_misses(const Settings& settings, const run::RunControl<Misses>& control, Misses& misses);

}  // namespace touchstone::tunnelling
