// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "experiments/run/sweep.h"

namespace touchstone::corpus {

/// The result of a check: the number of cases, and the faults as sentences that name file, line, case and key. A check
/// that was stopped has those of the first cases.
struct Findings {
  std::size_t cases = 0;
  std::vector<std::string> faults;
};

/// Derives the whole answer of every case by `exact` and by `filtered`, and every rejection of loops; all must agree with
/// the expectation of the case. A missing key, an id that is not unique among all
/// files, and a line that is not a case are faults; the check continues with the other cases.
///
/// A part checks its share of the lines. It reads the ids of the lines before, so that the findings of all parts add up
/// to those of one check.
[[nodiscard]] Findings check_files(const std::vector<std::string>& files, run::Part part, const std::atomic<bool>& stop,
                                   const run::Progress& progress);

}  // namespace touchstone::corpus
