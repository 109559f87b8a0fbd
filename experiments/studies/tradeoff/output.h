// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/tradeoff/errors.h"
#include "experiments/studies/tradeoff/timings.h"

namespace touchstone::tradeoff {

// Each throws std::runtime_error, which names the file, where it cannot be written. Those of errors alone are the same
// byte for byte for the same settings, whatever the threads and processes.

/// errors.csv: one line per family (then `all`), placement, threshold, method and offset: wrong answers, the number of
/// these in samples for which the method's distance or point overflows (is not finite), undecided answers, and the
/// share of the wrong ones with its Clopper-Pearson limits (95 %).
void write_errors(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// bands.csv: one line per family (then `all`), placement, threshold and method: answers within kNear doubles, the
/// share of the wrong ones with limits (95 %, samples being independent, not answers), and the lowest and highest
/// offsets at which an answer was wrong (empty if none was).
void write_bands(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// points.csv: one line per family (then `all`), placement, method and quantity: how often it was asked and known, how
/// often of these not finite and how often correctly rounded; median, 99 % and worst of the errors of finite ones
/// (statistics::Distribution gives the accuracy) in units in the last place; and the place of the worst, which is one
/// that is not finite if there is any.
void write_points(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// worst.jsonl: the case of the worst error of each placement, method and quantity that ever has an error, in the
/// contract's form; `expected` holds the exact value of that quantity.
void write_worst(const std::filesystem::path& folder, const Settings& settings, const Errors& errors);
/// timings.csv: one line per list and method: quartiles of the repetitions, nanoseconds per question.
void write_timings(const std::filesystem::path& folder, const std::vector<Timing>& timings);
/// front.csv: one line per measure, family (then `all`), placement and method: the median time and its quartiles, the
/// error, and whether it is on the front (front.h: on, within-noise, off).
void write_front(const std::filesystem::path& folder, const Settings& settings, const Errors& errors,
                 const std::vector<Timing>& timings);

/// Returns the tables for the terminal, all families together, with their legend.
[[nodiscard]] std::string table(const Settings& settings, const Errors& errors, const std::vector<Timing>& timings);

}  // namespace touchstone::tradeoff
